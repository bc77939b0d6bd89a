// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineMerging.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkLineSetsStretchPrivate.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr vtkIdType LinesPerBlock = 256;

// Part of the length by which a piece may deviate from its line.
constexpr double LargestDeviation = 0.125;

/// Where a point is; NaN where there is no such point.
void GetPosition(vtkPoints* points, vtkIdType id, double position[3])
{
  if (id >= 0 && id < points->GetNumberOfPoints())
  {
    points->GetPoint(id, position);
  }
  else
  {
    std::fill(position, position + 3, vtkMath::Nan());
  }
}

/// Grows pieces along one line after the other.
class Merger
{
public:
  Merger(vtkPoints* points, double length)
    : Points(points)
    , Length(length)
  {
  }

  void AddLine(vtkIdType size, const vtkIdType* ids, std::vector<unsigned int>& indices)
  {
    if (size < 2)
    {
      return;
    }
    this->Begin(ids[0]);
    for (vtkIdType i = 1; i < size; ++i)
    {
      double point[3];
      GetPosition(this->Points, ids[i], point);
      const double step = std::sqrt(vtkMath::Distance2BetweenPoints(this->End, point));
      const bool isBlockEnd = (i - 1) % vtkLineMerging::BlockSize == 0;
      if (this->IsGrowing && (isBlockEnd || !this->Fits(point, step)))
      {
        this->Finish(indices);
      }
      this->Last = ids[i];
      std::copy(point, point + 3, this->End);
      this->Arc += step;
      this->IsGrowing = true;
    }
    this->Finish(indices);
  }

private:
  void Begin(vtkIdType id)
  {
    this->First = this->Last = id;
    GetPosition(this->Points, id, this->Start);
    std::copy(this->Start, this->Start + 3, this->End);
    this->Arc = 0.0;
    this->IsGrowing = false;
  }

  bool Fits(const double point[3], double step) const
  {
    // A comparison with NaN is false: nothing is merged across points that are not finite.
    const double arc = this->Arc + step;
    const double chord2 = vtkMath::Distance2BetweenPoints(this->Start, point);
    const double deviation = LargestDeviation * this->Length;
    return arc <= this->Length && arc * arc - chord2 <= 4.0 * deviation * deviation;
  }

  void Finish(std::vector<unsigned int>& indices)
  {
    indices.push_back(static_cast<unsigned int>(this->First));
    indices.push_back(static_cast<unsigned int>(this->Last));
    this->Begin(this->Last);
  }

  vtkPoints* Points;
  double Length;
  vtkIdType First = 0;
  vtkIdType Last = 0;
  double Start[3];
  double End[3];
  double Arc = 0.0;
  bool IsGrowing = false;
};
}

//------------------------------------------------------------------------------
std::vector<unsigned int> vtkLineMerging::GetIndices(vtkPolyData* data, double length)
{
  vtkCellArray* lines = data->GetLines();
  const vtkIdType numberOfLines = lines->GetNumberOfCells();
  const vtkIdType blocks = (numberOfLines + LinesPerBlock - 1) / LinesPerBlock;
  std::vector<std::vector<unsigned int>> parts(static_cast<std::size_t>(blocks));
  vtkSMPThreadLocalObject<vtkIdList> idLists;
  vtkSMPTools::For(0, blocks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdList* ids = idLists.Local();
      Merger merger(data->GetPoints(), length);
      for (vtkIdType block = begin; block < end; ++block)
      {
        std::vector<unsigned int>& part = parts[static_cast<std::size_t>(block)];
        const vtkIdType last = std::min(numberOfLines, (block + 1) * LinesPerBlock);
        for (vtkIdType line = block * LinesPerBlock; line < last; ++line)
        {
          lines->GetCellAtId(line, ids);
          merger.AddLine(ids->GetNumberOfIds(), ids->GetPointer(0), part);
        }
      }
    });

  std::size_t size = 0;
  for (const auto& part : parts)
  {
    size += part.size();
  }
  std::vector<unsigned int> indices;
  indices.reserve(size);
  for (const auto& part : parts)
  {
    indices.insert(indices.end(), part.begin(), part.end());
  }
  return indices;
}

//------------------------------------------------------------------------------
double vtkLineMerging::GetLongestSegment(vtkPolyData* data)
{
  vtkCellArray* lines = data->GetLines();
  vtkSMPThreadLocalObject<vtkIdList> idLists;
  vtkSMPThreadLocal<double> longest(0.0);
  vtkSMPTools::For(0, lines->GetNumberOfCells(), LinesPerBlock,
    [&](vtkIdType begin, vtkIdType end)
    {
      vtkIdList* ids = idLists.Local();
      double& longest2 = longest.Local();
      for (vtkIdType line = begin; line < end; ++line)
      {
        lines->GetCellAtId(line, ids);
        double point[3];
        double next[3];
        for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
        {
          GetPosition(data->GetPoints(), ids->GetId(i), next);
          const double length2 = i > 0 ? vtkMath::Distance2BetweenPoints(point, next) : 0.0;
          longest2 = std::isfinite(length2) ? std::max(longest2, length2) : longest2;
          std::copy(next, next + 3, point);
        }
      }
    });
  double result = 0.0;
  for (double length2 : longest)
  {
    result = std::max(result, std::sqrt(length2));
  }
  return result;
}

//------------------------------------------------------------------------------
double vtkLineMerging::GetLength(double pixels, const double bounds[6], vtkMatrix4x4* viewFromData,
  vtkMatrix4x4* clipFromView, const int viewportSize[2])
{
  // Pixels per unit of view coordinates grow as the homogeneous coordinate w falls; and off the
  // axis, as what moves in depth moves sideways, too.
  double smallestW = VTK_DOUBLE_MAX;
  double largestSlope2 = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double view[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)], 1.0 };
    double clip[4];
    viewFromData->MultiplyPoint(view, view);
    clipFromView->MultiplyPoint(view, clip);
    smallestW = std::min(smallestW, clip[3]);
    largestSlope2 =
      std::max(largestSlope2, (view[0] * view[0] + view[1] * view[1]) / (view[2] * view[2]));
  }
  const bool isPerspective = clipFromView->GetElement(3, 2) != 0.0;
  const double pixelsPerUnit = (isPerspective ? std::sqrt(1.0 + largestSlope2) : 1.0) *
    vtkLineSetsGetLargestStretch(viewFromData) * 0.5 *
    std::max(std::abs(clipFromView->GetElement(0, 0)) * viewportSize[0],
      std::abs(clipFromView->GetElement(1, 1)) * viewportSize[1]);
  const double length = pixels * smallestW / pixelsPerUnit;
  return std::isfinite(length) ? std::max(0.0, length) : 0.0;
}
