// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CapsuleGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linesets
{
namespace
{
constexpr double LargestNumberOfCells = 16777216.0;

// Share of a cell by which capsules are grown, far above rounding and far below what costs time.
constexpr double Margin = 1e-6;

// Whether the segment, grown by a box of the given half width, touches the box [low, high].
bool SegmentTouchesBox(
  const Capsule& capsule, double halfWidth, const double low[3], const double high[3])
{
  double first = 0.0;
  double last = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double delta = capsule.End[i] - capsule.Start[i];
    const double toLow = low[i] - halfWidth - capsule.Start[i];
    const double toHigh = high[i] + halfWidth - capsule.Start[i];
    if (delta == 0.0)
    {
      if (toLow > 0.0 || toHigh < 0.0)
      {
        return false;
      }
      continue;
    }
    first = std::max(first, std::min(toLow / delta, toHigh / delta));
    last = std::min(last, std::max(toLow / delta, toHigh / delta));
  }
  return first <= last + 1e-9;
}
}

//------------------------------------------------------------------------------
template <typename Visitor>
void CapsuleGrid::VisitCells(const Capsule& capsule, Visitor&& visit) const
{
  const double halfWidth =
    std::max({ 0.0, capsule.StartRadius, capsule.EndRadius }) + Margin * this->CellSize;
  int low[3];
  int high[3];
  for (int i = 0; i < 3; ++i)
  {
    const double bottom = std::min(capsule.Start[i], capsule.End[i]) - halfWidth - this->Origin[i];
    const double top = std::max(capsule.Start[i], capsule.End[i]) + halfWidth - this->Origin[i];
    const double last = this->Dimensions[i] - 1.0;
    low[i] = static_cast<int>(std::min(std::max(std::floor(bottom / this->CellSize), 0.0), last));
    high[i] = static_cast<int>(std::min(std::max(std::floor(top / this->CellSize), 0.0), last));
  }
  for (int z = low[2]; z <= high[2]; ++z)
  {
    for (int y = low[1]; y <= high[1]; ++y)
    {
      for (int x = low[0]; x <= high[0]; ++x)
      {
        const double bottom[3] = { this->Origin[0] + x * this->CellSize,
          this->Origin[1] + y * this->CellSize, this->Origin[2] + z * this->CellSize };
        const double top[3] = { bottom[0] + this->CellSize, bottom[1] + this->CellSize,
          bottom[2] + this->CellSize };
        if (SegmentTouchesBox(capsule, halfWidth, bottom, top))
        {
          visit(this->GetIndex(x, y, z));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
std::size_t CapsuleGrid::GetIndex(int x, int y, int z) const
{
  return x +
    static_cast<std::size_t>(this->Dimensions[0]) *
    (y + static_cast<std::size_t>(this->Dimensions[1]) * z);
}

//------------------------------------------------------------------------------
CapsuleGrid::CapsuleGrid(const std::vector<Capsule>& capsules)
{
  if (capsules.empty())
  {
    return;
  }
  double bounds[6];
  GetCapsuleBounds(capsules, bounds);
  double size[3];
  double longest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = bounds[2 * i + 1] - bounds[2 * i];
    longest = std::max(longest, size[i]);
  }
  longest = longest > 0.0 ? longest : 1.0;
  double volume = 1.0;
  for (double& side : size)
  {
    side = std::max(side, 1e-3 * longest);
    volume *= side;
  }
  const double count =
    std::min(LargestNumberOfCells, std::max(1.0, static_cast<double>(capsules.size())));
  this->CellSize = std::cbrt(volume / count);
  std::size_t cells = 1;
  for (int i = 0; i < 3; ++i)
  {
    this->Dimensions[i] = static_cast<int>(size[i] / this->CellSize) + 1;
    cells *= this->Dimensions[i];
    // Centre the grid, so that the last cell's surplus lies on both sides.
    this->Origin[i] =
      0.5 * (bounds[2 * i] + bounds[2 * i + 1]) - 0.5 * this->Dimensions[i] * this->CellSize;
  }

  this->Starts.assign(cells + 1, 0);
  for (const Capsule& capsule : capsules)
  {
    this->VisitCells(capsule, [this](std::size_t cell) { ++this->Starts[cell + 1]; });
  }
  for (std::size_t i = 0; i < cells; ++i)
  {
    this->Starts[i + 1] += this->Starts[i];
  }
  this->Entries.resize(this->Starts[cells]);
  std::vector<std::uint64_t> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t i = 0; i < capsules.size(); ++i)
  {
    this->VisitCells(capsules[i],
      [this, &next, i](std::size_t cell)
      { this->Entries[next[cell]++] = static_cast<std::uint32_t>(i); });
  }
}

//------------------------------------------------------------------------------
CapsuleGrid::Walk::Walk(const CapsuleGrid& grid, const double origin[3], const double direction[3],
  double first, double last)
  : Grid(grid)
{
  if (grid.Entries.empty())
  {
    return;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  const double margin = Margin * grid.CellSize;
  for (int i = 0; i < 3; ++i)
  {
    const double low = grid.Origin[i] - margin - origin[i];
    const double high = grid.Origin[i] + grid.Dimensions[i] * grid.CellSize + margin - origin[i];
    if (direction[i] == 0.0)
    {
      if (low > 0.0 || high < 0.0)
      {
        return;
      }
      continue;
    }
    first = std::max(first, std::min(low / direction[i], high / direction[i]));
    last = std::min(last, std::max(low / direction[i], high / direction[i]));
  }
  if (first > last)
  {
    return;
  }
  this->Valid = true;
  this->Last = last;
  for (int i = 0; i < 3; ++i)
  {
    const double position = (origin[i] + first * direction[i] - grid.Origin[i]) / grid.CellSize;
    this->Cell[i] =
      static_cast<int>(std::min(std::max(std::floor(position), 0.0), grid.Dimensions[i] - 1.0));
    this->Step[i] = direction[i] > 0.0 ? 1 : (direction[i] < 0.0 ? -1 : 0);
    this->CrossingStep[i] = this->Step[i] == 0 ? infinity : grid.CellSize / std::abs(direction[i]);
    const double face =
      grid.Origin[i] + (this->Cell[i] + (this->Step[i] > 0 ? 1 : 0)) * grid.CellSize;
    this->NextCrossing[i] = this->Step[i] == 0 ? infinity : (face - origin[i]) / direction[i];
  }
}

//------------------------------------------------------------------------------
int CapsuleGrid::Walk::GetNextAxis() const
{
  return static_cast<int>(
    std::min_element(this->NextCrossing, this->NextCrossing + 3) - this->NextCrossing);
}

//------------------------------------------------------------------------------
double CapsuleGrid::Walk::GetExit() const
{
  return this->NextCrossing[this->GetNextAxis()];
}

//------------------------------------------------------------------------------
const std::uint32_t* CapsuleGrid::Walk::begin() const
{
  const std::size_t cell = this->Grid.GetIndex(this->Cell[0], this->Cell[1], this->Cell[2]);
  return this->Grid.Entries.data() + this->Grid.Starts[cell];
}

//------------------------------------------------------------------------------
const std::uint32_t* CapsuleGrid::Walk::end() const
{
  const std::size_t cell = this->Grid.GetIndex(this->Cell[0], this->Cell[1], this->Cell[2]);
  return this->Grid.Entries.data() + this->Grid.Starts[cell + 1];
}

//------------------------------------------------------------------------------
void CapsuleGrid::Walk::Next()
{
  const int axis = this->GetNextAxis();
  if (this->NextCrossing[axis] > this->Last)
  {
    this->Valid = false;
    return;
  }
  this->Cell[axis] += this->Step[axis];
  this->Valid = this->Cell[axis] >= 0 && this->Cell[axis] < this->Grid.Dimensions[axis] &&
    this->Step[axis] != 0;
  this->NextCrossing[axis] += this->CrossingStep[axis];
}
}
