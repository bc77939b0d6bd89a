// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpacityLineSegmentsPrivate.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkOpacityLineSegments
{

namespace
{

/// Lines that one task works on: enough to outweigh its cost, few enough to share the work.
constexpr vtkIdType LinesPerBlock = 256;

/// Set a value to a smaller one, whatever other threads do. Returns a value that it had before.
vtkIdType SetMinimum(std::atomic<vtkIdType>& target, vtkIdType value)
{
  vtkIdType old = target.load(std::memory_order_relaxed);
  while (value < old && !target.compare_exchange_weak(old, value, std::memory_order_relaxed))
  {
  }
  return old;
}

/// The ids of a line's points, and reads them.
struct PointRow
{
  PointRow(const vtkLineVoxelizerPrivate::Input& input, std::size_t line, vtkIdList* ids)
    : Points(input.LineSets[0].Points)
  {
    const vtkLineVoxelizerPrivate::Curve& curve = input.Curves[line];
    input.LineSets[0].Lines->GetCellAtId(curve.Line, ids);
    this->Ids = ids->GetPointer(curve.First);
    this->Size = curve.Size;
    this->IsWhole = curve.Size == ids->GetNumberOfIds();
  }

  /// Distance of a point of the row to the one before it.
  double GetStep(vtkIdType i) const
  {
    double a[3];
    double b[3];
    this->Points.Get(this->Ids[i - 1], a);
    this->Points.Get(this->Ids[i], b);
    return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }

  const vtkLineVoxelizerPrivate::PointReader& Points;
  const vtkIdType* Ids;
  vtkIdType Size;
  bool IsWhole;
};

/// Segments of a line of one length, if they are about as long as another; at least one.
double GetNumber(double lineLength, double length)
{
  return length > 0.0 ? std::max(1.0, std::round(lineLength / length)) : 1.0;
}

}

//------------------------------------------------------------------------------
Division::Division(vtkPolyData* data)
{
  this->Source.AddLineSet(data, 0);
  this->Source.FindCurves();
  const vtkIdType numberOfPoints = this->Source.LineSets[0].Points.GetNumberOfPoints();
  this->Owners = std::vector<std::atomic<vtkIdType>>(static_cast<std::size_t>(numberOfPoints));
  std::vector<std::atomic<bool>> isShared(static_cast<std::size_t>(numberOfPoints));
  vtkSMPTools::For(0, numberOfPoints, 65536,
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::size_t i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        this->Owners[i].store(NoOwner, std::memory_order_relaxed);
        isShared[i].store(false, std::memory_order_relaxed);
      }
    });
  this->Lines.resize(this->Source.Curves.size());
  vtkSMPThreadLocalObject<vtkIdList> ids;
  vtkSMPTools::For(0, this->GetNumberOfLines(), LinesPerBlock,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        this->Measure(static_cast<std::size_t>(i), ids.Local(), isShared);
      }
    });
  this->NumberOfSharedPoints = std::count(isShared.begin(), isShared.end(), true);
  for (Line& line : this->Lines)
  {
    if (!std::isfinite(line.Length))
    {
      ++this->NumberOfInfiniteLines;
      line.Length = 0.0;
    }
  }
}

//------------------------------------------------------------------------------
void Division::Measure(std::size_t index, vtkIdList* ids, std::vector<std::atomic<bool>>& isShared)
{
  const PointRow row(this->Source, index, ids);
  Line& line = this->Lines[index];
  for (vtkIdType i = 0; i < row.Size; ++i)
  {
    line.Length += i > 0 ? row.GetStep(i) : 0.0;
    const std::size_t point = static_cast<std::size_t>(row.Ids[i]);
    const vtkIdType self = static_cast<vtkIdType>(index);
    const vtkIdType other = SetMinimum(this->Owners[point], self);
    // Whichever line comes second finds the other one.
    if (other != self && other != NoOwner)
    {
      isShared[point].store(true, std::memory_order_relaxed);
    }
  }
  double first[3];
  double last[3];
  row.Points.Get(row.Ids[0], first);
  row.Points.Get(row.Ids[row.Size - 1], last);
  line.IsClosed = row.IsWhole && row.Size > 2 && std::equal(first, first + 3, last);
}

//------------------------------------------------------------------------------
double Division::GetTotal(double length) const
{
  double total = 0.0;
  for (const Line& line : this->Lines)
  {
    total += GetNumber(line.Length, length);
  }
  return total;
}

//------------------------------------------------------------------------------
bool Division::Divide(double length, int number, int limit)
{
  if (!(length > 0.0))
  {
    double total = 0.0;
    for (const Line& line : this->Lines)
    {
      total += line.Length / number;
    }
    length = std::isfinite(total) ? total : std::numeric_limits<double>::max();
  }
  const bool isTooShort = this->GetTotal(length) > limit;
  if (isTooShort && this->GetNumberOfLines() >= limit)
  {
    length = 0.0; // one segment for each line
  }
  else if (isTooShort)
  {
    double low = length;
    while (this->GetTotal(length) > limit)
    {
      low = length;
      length *= 2.0;
    }
    for (int i = 0; i < 40; ++i)
    {
      const double middle = 0.5 * (low + length);
      (this->GetTotal(middle) > limit ? low : length) = middle;
    }
  }
  this->NumberOfSegments = 0;
  this->NumberOfLeftOutLines = 0;
  for (Line& line : this->Lines)
  {
    line.First = this->NumberOfSegments;
    line.Number =
      this->NumberOfSegments < limit ? static_cast<int>(GetNumber(line.Length, length)) : 0;
    this->NumberOfSegments += line.Number;
    this->NumberOfLeftOutLines += line.Number == 0 ? 1 : 0;
  }
  return isTooShort;
}

//------------------------------------------------------------------------------
void Division::SetPoints(const PointArrays& arrays) const
{
  vtkSMPThreadLocalObject<vtkIdList> ids;
  vtkSMPTools::For(0, this->GetNumberOfLines(), LinesPerBlock,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        if (this->Lines[static_cast<std::size_t>(i)].Number > 0)
        {
          this->SetPointsOfLine(static_cast<std::size_t>(i), ids.Local(), arrays);
        }
      }
    });
}

//------------------------------------------------------------------------------
void Division::SetPointsOfLine(std::size_t index, vtkIdList* ids, const PointArrays& arrays) const
{
  const PointRow row(this->Source, index, ids);
  const Line& line = this->Lines[index];
  const double step = line.Length / line.Number;
  double position = 0.0;
  for (vtkIdType i = 0; i < row.Size; ++i)
  {
    position += i > 0 && step > 0.0 ? row.GetStep(i) : 0.0;
    const vtkIdType point = row.Ids[i];
    // The line itself may come back to a point; no other thread writes to it.
    if (this->Owners[static_cast<std::size_t>(point)] != static_cast<vtkIdType>(index) ||
      arrays.Ids[3 * point] >= 0)
    {
      continue;
    }
    const int last = line.Number - 1;
    const int own =
      step > 0.0 ? static_cast<int>(std::min(position / step, static_cast<double>(last))) : 0;
    const double offset = position - (own + 0.5) * step;
    int other = offset < 0.0 ? own - 1 : own + 1;
    if (line.IsClosed)
    {
      other = (other + line.Number) % line.Number;
    }
    if (other < 0 || other > last || other == own || !(step > 0.0))
    {
      arrays.Set(point, line.First + own);
      continue;
    }
    const double distance = std::min(std::abs(offset), 0.5 * step);
    const int segments[3] = { line.First + own, line.First + other, -1 };
    const double distances[4] = { distance, step - distance, step, step };
    arrays.Set(point, segments, distances);
  }
}

//------------------------------------------------------------------------------
void Division::AddNeighbors(std::vector<std::pair<int, int>>& pairs) const
{
  for (const Line& line : this->Lines)
  {
    for (int i = 1; i < line.Number; ++i)
    {
      pairs.emplace_back(line.First + i - 1, line.First + i);
      if (i == 1 && line.IsClosed && line.Number > 2)
      {
        pairs.emplace_back(line.First, line.First + line.Number - 1);
      }
    }
  }
}

}
