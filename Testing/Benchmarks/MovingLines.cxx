// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MovingLines.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
namespace
{
constexpr double LargestAdvance = 0.01; // of the longest side
constexpr double LargestAngle = 15.0;   // degrees
constexpr double FramesPerAdvance = 24.0;
constexpr double FramesPerSwirl = 48.0;

// Tangents by central differences, one-sided at the ends.
std::vector<float> MakeTangents(vtkPolyData* lines)
{
  std::vector<float> tangents(3 * static_cast<std::size_t>(lines->GetNumberOfPoints()), 0.0f);
  auto cells = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    cells->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double before[3];
      double tangent[3];
      lines->GetPoint(ids[std::max<vtkIdType>(i - 1, 0)], before);
      lines->GetPoint(ids[std::min(i + 1, count - 1)], tangent);
      vtkMath::Subtract(tangent, before, tangent);
      vtkMath::Normalize(tangent);
      std::copy_n(tangent, 3, tangents.begin() + 3 * ids[i]);
    }
  }
  return tangents;
}

double GetPhase(int frame, double period)
{
  return std::sin(2.0 * vtkMath::Pi() * frame / period);
}
}

//------------------------------------------------------------------------------
MovingLines::MovingLines(vtkPolyData* lines)
  : Lines(lines)
  , Tangents(MakeTangents(lines))
{
  double bounds[6];
  lines->GetBounds(bounds);
  double sides[3];
  for (int i = 0; i < 3; ++i)
  {
    sides[i] = bounds[2 * i + 1] - bounds[2 * i];
  }
  this->Size = *std::max_element(sides, sides + 3);
  this->Center[0] = 0.5 * (bounds[0] + bounds[1]);
  this->Center[1] = 0.5 * (bounds[2] + bounds[3]);
  this->SwirlRadius = 0.5 * std::min(sides[0], sides[1]);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MovingLines::GetLines(int frame) const
{
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(this->Lines);
  const double advance = LargestAdvance * this->Size * GetPhase(frame, FramesPerAdvance);
  const double angle = vtkMath::RadiansFromDegrees(LargestAngle) * GetPhase(frame, FramesPerSwirl);
  vtkPoints* points = moved->GetPoints();
  const auto move = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double point[3];
      points->GetPoint(i, point);
      this->Move(point, &this->Tangents[3 * i], advance, angle);
      points->SetPoint(i, point);
    }
  };
  vtkSMPTools::For(0, points->GetNumberOfPoints(), move);
  points->Modified();
  return moved;
}

//------------------------------------------------------------------------------
void MovingLines::Move(double point[3], const float tangent[3], double advance, double angle) const
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] += advance * tangent[i];
  }
  const double x = point[0] - this->Center[0];
  const double y = point[1] - this->Center[1];
  const double square = x * x + y * y;
  const double reach = this->SwirlRadius * this->SwirlRadius;
  if (square < reach)
  {
    const double turn = angle * (1.0 - square / reach);
    point[0] = this->Center[0] + std::cos(turn) * x - std::sin(turn) * y;
    point[1] = this->Center[1] + std::sin(turn) * x + std::cos(turn) * y;
  }
}
}
