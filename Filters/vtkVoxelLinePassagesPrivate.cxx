// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinePassagesPrivate.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace vtkVoxelLineRepresentatives
{

namespace
{

constexpr std::uint32_t NoPassage = 0xffffffffu;
constexpr std::size_t LargestCellsPerTask = 64;
/// Up to so many passages of a curve, each is held against each.
constexpr std::size_t FewPassages = 12;

bool IsClosed(const Passage& passage)
{
  return passage.Start.Point == passage.End.Point;
}

/// Of the passages from an index on, ordered by curve, leave out the closed ones of each curve that
/// has others.
void DropClosed(std::vector<Passage>& passages, std::size_t begin)
{
  std::size_t size = begin;
  for (std::size_t first = begin, last = begin; first < passages.size(); first = last)
  {
    bool hasOpen = false;
    while (last < passages.size() && passages[last].Curve == passages[first].Curve)
    {
      hasOpen = hasOpen || !IsClosed(passages[last]);
      ++last;
    }
    for (std::size_t i = first; i < last; ++i)
    {
      if (!hasOpen || !IsClosed(passages[i]))
      {
        passages[size++] = passages[i];
      }
    }
  }
  passages.resize(size);
}

/// Where a new row of parts begins: cells of the same coarse voxel are a row.
std::array<int, 3> ParentOf(const std::array<int, 3>& voxel)
{
  return { voxel[0] / 2, voxel[1] / 2, voxel[2] / 2 };
}

}

//------------------------------------------------------------------------------
void PassageTable::Append(PassageTable& other)
{
  const std::size_t offset = this->Passages.size();
  this->Passages.insert(this->Passages.end(), other.Passages.begin(), other.Passages.end());
  for (const Cell& cell : other.Cells)
  {
    this->Cells.push_back({ cell.Voxel, offset + cell.First, offset + cell.Last });
  }
  other = PassageTable();
}

//------------------------------------------------------------------------------
void PassageJoiner::FindFewSuccessors()
{
  const std::size_t size = this->Parts.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t j = 0; j < size && !IsClosed(this->Parts[i]); ++j)
    {
      if (!this->HasPredecessor[j] && this->Parts[j].Start.Point == this->Parts[i].End.Point &&
        !IsClosed(this->Parts[j]))
      {
        this->Successors[i] = static_cast<std::uint32_t>(j);
        this->HasPredecessor[j] = 1;
        break;
      }
    }
  }
}

//------------------------------------------------------------------------------
void PassageJoiner::FindManySuccessors()
{
  const std::vector<Passage>& parts = this->Parts;
  this->Order.resize(parts.size());
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  std::sort(this->Order.begin(), this->Order.end(),
    [&parts](std::uint32_t i, std::uint32_t j)
    { return std::tie(parts[i].Start.Point, i) < std::tie(parts[j].Start.Point, j); });
  this->Used.assign(parts.size(), 0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (IsClosed(parts[i]))
    {
      continue;
    }
    const auto place = std::lower_bound(this->Order.begin(), this->Order.end(), parts[i].End.Point,
      [&parts](std::uint32_t j, const std::array<float, 3>& point)
      { return parts[j].Start.Point < point; });
    if (place == this->Order.end())
    {
      continue;
    }
    // Of those that begin here, the first that is free.
    const std::size_t first = static_cast<std::size_t>(place - this->Order.begin());
    for (std::size_t j = first + this->Used[first]; j < parts.size(); ++j)
    {
      const std::uint32_t next = this->Order[j];
      if (parts[next].Start.Point != parts[i].End.Point)
      {
        break;
      }
      ++this->Used[first];
      if (!IsClosed(parts[next]))
      {
        this->Successors[i] = next;
        this->HasPredecessor[next] = 1;
        break;
      }
    }
  }
}

//------------------------------------------------------------------------------
void PassageJoiner::JoinCurve(std::vector<Passage>& passages)
{
  const std::size_t size = this->Parts.size();
  this->Successors.assign(size, NoPassage);
  this->HasPredecessor.assign(size, 0);
  if (size <= FewPassages)
  {
    this->FindFewSuccessors();
  }
  else
  {
    this->FindManySuccessors();
  }
  this->IsDone.assign(size, 0);
  // First those that begin here; what is left then are rings, which begin anywhere.
  for (const bool isRing : { false, true })
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      if (this->IsDone[i] || (!isRing && this->HasPredecessor[i]))
      {
        continue;
      }
      passages.push_back(this->Parts[i]);
      this->IsDone[i] = 1;
      for (std::uint32_t j = this->Successors[i]; j != NoPassage && !this->IsDone[j];
           j = this->Successors[j])
      {
        passages.back().End = this->Parts[j].End;
        this->IsDone[j] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
void PassageJoiner::SortByCurve(const std::vector<Passage>& parts)
{
  // The parts of each smaller voxel come sorted, so that merging these few runs is all there is.
  this->Keys.resize(parts.size());
  this->Runs.clear();
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (i == 0 || parts[i].Curve < parts[i - 1].Curve)
    {
      this->Runs.push_back(i);
    }
    this->Keys[i] = static_cast<std::uint64_t>(parts[i].Curve) << 32 | i;
  }
  this->MergedKeys.resize(parts.size());
  while (this->Runs.size() > 1)
  {
    const std::uint64_t* keys = this->Keys.data();
    this->Runs.push_back(parts.size());
    std::size_t pairs = 0;
    for (std::size_t run = 0; run + 1 < this->Runs.size(); run += 2)
    {
      const std::size_t first = this->Runs[run];
      const std::size_t middle = this->Runs[run + 1];
      const std::size_t last = this->Runs[std::min(run + 2, this->Runs.size() - 1)];
      std::merge(
        keys + first, keys + middle, keys + middle, keys + last, this->MergedKeys.data() + first);
      this->Runs[pairs++] = first;
    }
    this->Runs.resize(pairs);
    this->Keys.swap(this->MergedKeys);
  }
}

//------------------------------------------------------------------------------
void PassageJoiner::Join(const std::vector<Passage>& parts, std::vector<Passage>& passages)
{
  const std::size_t begin = passages.size();
  this->SortByCurve(parts);
  for (std::size_t first = 0, last = 0; first < parts.size(); first = last)
  {
    const std::uint64_t curve = this->Keys[first] >> 32;
    while (last < parts.size() && this->Keys[last] >> 32 == curve)
    {
      ++last;
    }
    if (last - first == 1)
    {
      passages.push_back(parts[static_cast<std::uint32_t>(this->Keys[first])]);
      continue;
    }
    this->Parts.clear();
    for (std::size_t i = first; i < last; ++i)
    {
      this->Parts.push_back(parts[static_cast<std::uint32_t>(this->Keys[i])]);
    }
    this->JoinCurve(passages);
  }
  DropClosed(passages, begin);
}

//------------------------------------------------------------------------------
PassageReader::PassageReader(vtkVoxelLineModel* model)
  : Segments(model)
{
  if (model->GetAttributes() && model->GetAttributeKind() != vtkVoxelLineModel::NoAttribute)
  {
    this->Attributes = model->GetAttributes()->GetPointer(0);
    this->AttributeSize = model->GetAttributeKind() == vtkVoxelLineModel::Color ? 4 : 1;
  }
  this->Radii = model->GetRadii() ? model->GetRadii()->GetPointer(0) : nullptr;
}

//------------------------------------------------------------------------------
void PassageReader::ReadEnd(
  vtkIdType segment, int end, const int voxel[3], const double local[3], PassageEnd& target) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    target.Point[axis] = static_cast<float>(voxel[axis] + local[axis]);
  }
  const std::size_t row = 2 * static_cast<std::size_t>(segment) + static_cast<std::size_t>(end);
  target.Attribute = {};
  std::copy_n(
    this->Attributes + this->AttributeSize * row, this->AttributeSize, target.Attribute.begin());
  target.Radius = this->Radii ? this->Radii[row] : std::uint8_t(0);
}

//------------------------------------------------------------------------------
void PassageReader::ReadVoxel(vtkIdType brick, const int voxel[3], vtkIdType first, vtkIdType last,
  std::vector<Passage>& passages) const
{
  const std::size_t begin = passages.size();
  for (vtkIdType i = first; i < last; ++i)
  {
    double start[3];
    double end[3];
    this->Segments.GetPoints(i, start, end);
    Passage passage;
    passage.Curve = this->Segments.GetCurve(brick, i);
    this->ReadEnd(i, 0, voxel, start, passage.Start);
    this->ReadEnd(i, 1, voxel, end, passage.End);
    // Segments of a curve are in the order of the curve.
    if (passages.size() > begin && passages.back().Curve == passage.Curve &&
      passages.back().End.Point == passage.Start.Point)
    {
      passages.back().End = passage.End;
    }
    else
    {
      passages.push_back(passage);
    }
  }
  DropClosed(passages, begin);
}

//------------------------------------------------------------------------------
void PassageReader::ReadBrick(
  vtkIdType brick, int level, Scratch& scratch, PassageTable& table) const
{
  std::array<int, 3> corner = { 0, 0, 0 };
  const int voxelsPerEdge = vtkVoxelLineModel::BrickSize >> level;
  this->Segments.VisitVoxels(brick,
    [&](const int voxel[3], vtkIdType first, vtkIdType last)
    {
      if (level == 0)
      {
        const std::size_t begin = table.Passages.size();
        this->ReadVoxel(brick, voxel, first, last, table.Passages);
        table.Cells.push_back({ { voxel[0], voxel[1], voxel[2] }, begin, table.Passages.size() });
        return;
      }
      std::size_t part = 0;
      for (std::size_t axis = 3; axis-- > 0;)
      {
        const int coarse = voxel[axis] >> level;
        corner[axis] = coarse / voxelsPerEdge * voxelsPerEdge;
        part = 2 * part + static_cast<std::size_t>(coarse - corner[axis]);
      }
      this->ReadVoxel(brick, voxel, first, last, scratch.Parts[part]);
    });
  for (std::size_t part = 0; part < scratch.Parts.size(); ++part)
  {
    if (!scratch.Parts[part].empty())
    {
      const int index = static_cast<int>(part);
      const std::size_t begin = table.Passages.size();
      scratch.Joiner.Join(scratch.Parts[part], table.Passages);
      table.Cells.push_back(
        { { corner[0] + index % 2, corner[1] + index / 2 % 2, corner[2] + index / 4 }, begin,
          table.Passages.size() });
      scratch.Parts[part].clear();
    }
  }
}

//------------------------------------------------------------------------------
void JoinLevel(const PassageTable& fine, PassageTable& coarse)
{
  std::vector<std::size_t> order(fine.Cells.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto parentOf = [&fine](std::size_t cell) { return ParentOf(fine.Cells[cell].Voxel); };
  std::sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t j)
    {
      const std::array<int, 3> a = parentOf(i);
      const std::array<int, 3> b = parentOf(j);
      return std::tie(a[2], a[1], a[0], i) < std::tie(b[2], b[1], b[0], j);
    });
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || parentOf(order[i]) != parentOf(order[i - 1]))
    {
      rows.push_back(i);
    }
  }
  const std::size_t numberOfRows = rows.size();
  rows.push_back(order.size());

  // Few voxels hold much each.
  const std::size_t cellsPerTask =
    std::min(LargestCellsPerTask, numberOfRows / LargestCellsPerTask + 1);
  std::vector<PassageTable> tasks((numberOfRows + cellsPerTask - 1) / cellsPerTask);
  vtkSMPThreadLocal<PassageReader::Scratch> scratches;
  vtkSMPTools::For(0, static_cast<vtkIdType>(tasks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      PassageReader::Scratch& scratch = scratches.Local();
      std::vector<Passage>& parts = scratch.Parts[0];
      for (std::size_t task = static_cast<std::size_t>(begin); task < static_cast<std::size_t>(end);
           ++task)
      {
        PassageTable& table = tasks[task];
        const std::size_t last = std::min((task + 1) * cellsPerTask, numberOfRows);
        for (std::size_t row = task * cellsPerTask; row < last; ++row)
        {
          for (std::size_t i = rows[row]; i < rows[row + 1]; ++i)
          {
            const PassageTable::Cell& cell = fine.Cells[order[i]];
            parts.insert(
              parts.end(), fine.Passages.data() + cell.First, fine.Passages.data() + cell.Last);
          }
          const std::size_t first = table.Passages.size();
          scratch.Joiner.Join(parts, table.Passages);
          table.Cells.push_back({ parentOf(order[rows[row]]), first, table.Passages.size() });
          parts.clear();
        }
      }
    });
  coarse.Clear();
  for (PassageTable& table : tasks)
  {
    coarse.Append(table);
  }
}

}
