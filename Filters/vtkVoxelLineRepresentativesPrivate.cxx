// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineRepresentativesPrivate.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineEncodingPrivate.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <bitset>
#include <new>
#include <utility>

namespace vtkVoxelLineRepresentatives
{

namespace
{

constexpr int BrickSize = vtkVoxelLineModel::BrickSize;
constexpr vtkIdType BricksPerTask = 64;
/// Parts of the bricks after which progress is told.
constexpr vtkIdType NumberOfRounds = 8;

/// Makes the representatives of one level and the model of them.
class LevelMaker
{
public:
  LevelMaker(vtkVoxelLineModel* model, int level, const ProgressFunction& goesOn)
    : Model(model)
    , GoesOn(goesOn)
  {
    this->Rules.Level = level;
    this->Rules.FaceBins = model->GetFaceBins();
    this->Rules.InteriorBins = model->GetInteriorBins();
    this->Rules.AttributeSize = model->GetAttributeKind() == vtkVoxelLineModel::Color ? 4
      : model->GetAttributeKind() == vtkVoxelLineModel::Scalar                        ? 1
                                                                                      : 0;
    this->Rules.HasNaN =
      model->GetAttributeKind() == vtkVoxelLineModel::Scalar && model->GetHasNaNAttribute();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Table.Dimensions[axis] =
        vtkVoxelLineLevels::SizeOf(model->GetDimensions()[axis], level);
      this->Table.BrickDimensions[axis] =
        (this->Table.Dimensions[axis] + BrickSize - 1) / BrickSize;
    }
  }

  void Make(vtkVoxelLineModel* output)
  {
    if (!this->CollectLines())
    {
      return;
    }
    this->SortLines();
    this->ListBricks();
    this->JoinFaces();
    if (this->GoesOn(0.9))
    {
      WriteModel(this->Model, this->Rules, this->Table, output);
    }
  }

private:
  bool CollectLines();
  bool ReadBricks(int level, std::vector<PassageTable>* tables);
  void AverageTable(const PassageTable& table, std::vector<Representative>& lines) const;
  void AverageCells(const PassageTable& table);
  void TakeLines(std::vector<std::vector<Representative>>& tasks);
  std::uint64_t KeyOf(const std::array<int, 3>& voxel) const;
  void SortLines();
  void ListBricks();
  Representative* FindLine(const std::array<int, 3>& voxel);
  void JoinFaces();
  void JoinFace(Representative& lower, Representative& upper, int axis) const;

  vtkVoxelLineModel* Model;
  const ProgressFunction& GoesOn;
  AveragingRules Rules;
  LevelTable Table;
};

//------------------------------------------------------------------------------
void LevelMaker::AverageTable(const PassageTable& table, std::vector<Representative>& lines) const
{
  for (const PassageTable::Cell& cell : table.Cells)
  {
    lines.push_back(Average(this->Rules, cell.Voxel, table.Passages.data() + cell.First,
      table.Passages.data() + cell.Last));
  }
}

//------------------------------------------------------------------------------
void LevelMaker::TakeLines(std::vector<std::vector<Representative>>& tasks)
{
  std::vector<std::size_t> starts(1, this->Table.Lines.size());
  for (const std::vector<Representative>& lines : tasks)
  {
    starts.push_back(starts.back() + lines.size());
  }
  this->Table.Lines.resize(starts.back());
  vtkSMPTools::For(0, static_cast<vtkIdType>(tasks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t task = static_cast<std::size_t>(begin); task < static_cast<std::size_t>(end);
           ++task)
      {
        std::copy(tasks[task].begin(), tasks[task].end(), this->Table.Lines.data() + starts[task]);
        std::vector<Representative>().swap(tasks[task]);
      }
    });
}

//------------------------------------------------------------------------------
bool LevelMaker::ReadBricks(int level, std::vector<PassageTable>* tables)
{
  const PassageReader reader(this->Model);
  const vtkIdType numberOfBricks = reader.GetNumberOfBricks();
  const vtkIdType numberOfTasks = (numberOfBricks + BricksPerTask - 1) / BricksPerTask;
  std::vector<std::vector<Representative>> lines(static_cast<std::size_t>(numberOfTasks));
  vtkSMPThreadLocal<std::pair<PassageReader::Scratch, PassageTable>> locals;
  for (vtkIdType round = 0; round < NumberOfRounds; ++round)
  {
    vtkSMPTools::For(round * numberOfTasks / NumberOfRounds,
      (round + 1) * numberOfTasks / NumberOfRounds, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        auto& local = locals.Local();
        for (vtkIdType task = begin; task < end; ++task)
        {
          const std::size_t index = static_cast<std::size_t>(task);
          PassageTable& table = tables ? (*tables)[index] : local.second;
          table.Clear();
          const vtkIdType last = std::min((task + 1) * BricksPerTask, numberOfBricks);
          for (vtkIdType brick = task * BricksPerTask; brick < last; ++brick)
          {
            reader.ReadBrick(brick, level, local.first, table);
          }
          if (!tables)
          {
            this->AverageTable(table, lines[index]);
          }
        }
      });
    if (!this->GoesOn(0.6 * static_cast<double>(round + 1) / NumberOfRounds))
    {
      return false;
    }
  }
  this->TakeLines(lines);
  return true;
}

//------------------------------------------------------------------------------
void LevelMaker::AverageCells(const PassageTable& table)
{
  this->Table.Lines.resize(table.Cells.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(table.Cells.size()), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const PassageTable::Cell& cell = table.Cells[i];
        this->Table.Lines[i] = Average(this->Rules, cell.Voxel, table.Passages.data() + cell.First,
          table.Passages.data() + cell.Last);
      }
    });
}

//------------------------------------------------------------------------------
bool LevelMaker::CollectLines()
{
  if (this->Rules.Level <= PassageReader::LargestLevel)
  {
    return this->ReadBricks(this->Rules.Level, nullptr);
  }
  const vtkIdType numberOfBricks = this->Model->GetNumberOfBricks();
  std::vector<PassageTable> tables(
    static_cast<std::size_t>((numberOfBricks + BricksPerTask - 1) / BricksPerTask));
  if (!this->ReadBricks(PassageReader::LargestLevel, &tables))
  {
    return false;
  }
  PassageTable fine;
  for (PassageTable& table : tables)
  {
    fine.Append(table);
  }
  for (int level = PassageReader::LargestLevel + 1; level <= this->Rules.Level; ++level)
  {
    PassageTable coarse;
    JoinLevel(fine, coarse);
    fine = std::move(coarse);
    if (!this->GoesOn(0.7))
    {
      return false;
    }
  }
  this->AverageCells(fine);
  return true;
}

//------------------------------------------------------------------------------
std::uint64_t LevelMaker::KeyOf(const std::array<int, 3>& voxel) const
{
  std::uint64_t cell = 0;
  std::uint64_t bit = 0;
  for (std::size_t axis = 3; axis-- > 0;)
  {
    cell = cell * static_cast<std::uint64_t>(this->Table.BrickDimensions[axis]) +
      static_cast<std::uint64_t>(voxel[axis] / BrickSize);
    bit = bit * BrickSize + static_cast<std::uint64_t>(voxel[axis] % BrickSize);
  }
  return cell << 6 | bit;
}

//------------------------------------------------------------------------------
void LevelMaker::SortLines()
{
  if (this->Rules.Level == 0)
  {
    // The order of the model is that of its representatives.
    return;
  }
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(this->Table.Lines.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = { this->KeyOf(this->Table.Lines[i].Voxel), static_cast<std::uint32_t>(i) };
  }
  vtkSMPTools::Sort(order.begin(), order.end());
  std::vector<Representative> lines(this->Table.Lines.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(lines.size()), 8192,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        lines[i] = this->Table.Lines[order[i].second];
      }
    });
  this->Table.Lines.swap(lines);
}

//------------------------------------------------------------------------------
void LevelMaker::ListBricks()
{
  this->Table.BrickOfCell.assign(static_cast<std::size_t>(this->Table.BrickDimensions[0]) *
      static_cast<std::size_t>(this->Table.BrickDimensions[1]) *
      static_cast<std::size_t>(this->Table.BrickDimensions[2]),
    -1);
  for (std::size_t i = 0; i < this->Table.Lines.size(); ++i)
  {
    const std::uint64_t key = this->KeyOf(this->Table.Lines[i].Voxel);
    const std::uint32_t cell = static_cast<std::uint32_t>(key >> 6);
    if (this->Table.Bricks.empty() || this->Table.Bricks.back().Cell != cell)
    {
      this->Table.BrickOfCell[cell] = static_cast<std::int32_t>(this->Table.Bricks.size());
      this->Table.Bricks.push_back({ cell, static_cast<std::uint32_t>(i), 0 });
    }
    this->Table.Bricks.back().Mask |= std::uint64_t(1) << (key & 63);
  }
  this->Table.Bricks.push_back({ 0, static_cast<std::uint32_t>(this->Table.Lines.size()), 0 });
}

//------------------------------------------------------------------------------
Representative* LevelMaker::FindLine(const std::array<int, 3>& voxel)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (voxel[axis] >= this->Table.Dimensions[axis])
    {
      return nullptr;
    }
  }
  const std::uint64_t key = this->KeyOf(voxel);
  const std::int32_t brick = this->Table.BrickOfCell[key >> 6];
  if (brick < 0)
  {
    return nullptr;
  }
  // The lines of a brick are in the order of its mask bits.
  const LevelTable::Brick& here = this->Table.Bricks[static_cast<std::size_t>(brick)];
  const std::uint64_t bit = std::uint64_t(1) << (key & 63);
  return (here.Mask & bit) != 0
    ? &this->Table.Lines[here.First + std::bitset<64>(here.Mask & (bit - 1)).count()]
    : nullptr;
}

//------------------------------------------------------------------------------
void LevelMaker::JoinFace(Representative& lower, Representative& upper, int axis) const
{
  const std::size_t u = static_cast<std::size_t>(axis + 1) % 3;
  const std::size_t v = static_cast<std::size_t>(axis + 2) % 3;
  const auto distance2 = [u, v](const RepresentativeEnd& a, const RepresentativeEnd& b)
  {
    const double du = static_cast<double>(a.Local[u]) - b.Local[u];
    const double dv = static_cast<double>(a.Local[v]) - b.Local[v];
    return du * du + dv * dv;
  };
  // The two ends that are nearest, the first ones of several.
  RepresentativeEnd* joined[2] = { nullptr, nullptr };
  double nearest = VTK_DOUBLE_MAX;
  for (RepresentativeEnd& a : lower.Ends)
  {
    for (RepresentativeEnd& b : upper.Ends)
    {
      if (a.Face == 2 * axis + 1 && b.Face == 2 * axis && distance2(a, b) < nearest)
      {
        nearest = distance2(a, b);
        joined[0] = &a;
        joined[1] = &b;
      }
    }
  }
  if (!joined[0])
  {
    return;
  }
  const int bins = this->Rules.FaceBins;
  const auto middle = [bins, &joined](std::size_t i)
  {
    const double mean = 0.5 * (static_cast<double>(joined[0]->Local[i]) + joined[1]->Local[i]);
    return static_cast<float>(
      bins == 0 ? mean : (vtkVoxelLineEncoding::Codec::Bin(mean, bins) + 0.5) / bins);
  };
  RepresentativeEnd target = *joined[0];
  target.Local[u] = middle(u);
  target.Local[v] = middle(v);
  // A line whose other end is on the same face, in this place, would become a point. Ends on other
  // faces are not looked at, since other threads may move them.
  for (const Representative* line : { &lower, &upper })
  {
    for (const RepresentativeEnd& other : line->Ends)
    {
      const int face = 2 * axis + (line == &lower);
      if (&other != joined[0] && &other != joined[1] && other.Face == face &&
        distance2(other, target) == 0.0)
      {
        return;
      }
    }
  }
  for (RepresentativeEnd* end : joined)
  {
    end->Local[u] = target.Local[u];
    end->Local[v] = target.Local[v];
  }
}

//------------------------------------------------------------------------------
void LevelMaker::JoinFaces()
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Table.Lines.size()), 4096,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        Representative& lower = this->Table.Lines[i];
        for (int axis = 0; axis < 3; ++axis)
        {
          if (lower.Ends[0].Face != 2 * axis + 1 && lower.Ends[1].Face != 2 * axis + 1)
          {
            continue;
          }
          std::array<int, 3> voxel = lower.Voxel;
          ++voxel[static_cast<std::size_t>(axis)];
          if (Representative* upper = this->FindLine(voxel))
          {
            this->JoinFace(lower, *upper, axis);
          }
        }
      }
    });
}

}

//------------------------------------------------------------------------------
std::string MakeLevel(
  vtkVoxelLineModel* model, int level, const ProgressFunction& goesOn, vtkVoxelLineModel* output)
{
  output->Initialize();
  const std::string error = vtkVoxelLineLevels::FindLevelError(model, level);
  if (!error.empty() || !model || model->GetNumberOfSegments() == 0)
  {
    return error;
  }
  try
  {
    LevelMaker maker(model, level, goesOn);
    maker.Make(output);
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    return "There is not enough memory for the representative lines.";
  }
  return std::string();
}

}
