// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineRepresentativesPrivate.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeUInt16Array.h"
#include "vtkTypeUInt32Array.h"
#include "vtkTypeUInt8Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineDistancePrivate.h"
#include "vtkVoxelLineEncodingPrivate.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numeric>
#include <utility>

namespace vtkVoxelLineRepresentatives
{

namespace
{

constexpr int BrickSize = vtkVoxelLineModel::BrickSize;
constexpr int WordsPerRow = 5;
constexpr vtkIdType BricksPerTask = 64;
/// Parts of the bricks after which progress is told.
constexpr vtkIdType NumberOfRounds = 8;

template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeArray(int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/// The bricks of the output: cell in the brick grid, occupied voxels, and first representative.
struct Brick
{
  std::uint32_t Cell;
  std::uint32_t First;
  std::uint64_t Mask;
};

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
    this->Rules.AttributeSize = model->GetAttributeKind() == vtkVoxelLineModel::Color ? 4
      : model->GetAttributeKind() == vtkVoxelLineModel::Scalar                        ? 1
                                                                                      : 0;
    this->Rules.HasNaN =
      model->GetAttributeKind() == vtkVoxelLineModel::Scalar && model->GetHasNaNAttribute();
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Dimensions[axis] = vtkVoxelLineLevels::SizeOf(model->GetDimensions()[axis], level);
      this->BrickDimensions[axis] = (this->Dimensions[axis] + BrickSize - 1) / BrickSize;
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
      this->WriteModel(output);
    }
  }

private:
  bool CollectLines();
  bool ReadBricks(int level, std::vector<PassageTable>* tables);
  void AverageTable(const PassageTable& table, std::vector<Representative>& lines) const;
  void AverageCells(const PassageTable& table);
  void TakeLines(std::vector<std::vector<Representative>>& tasks);
  std::uint64_t KeyOf(const Representative& line) const;
  void SortLines();
  void ListBricks();
  Representative* FindLine(const std::array<int, 3>& voxel);
  void JoinFaces();
  void JoinFace(Representative& lower, Representative& upper, int axis) const;
  void WriteModel(vtkVoxelLineModel* output);
  void WriteBricks(vtkVoxelLineModel* output);
  void WriteSegments(vtkVoxelLineModel* output);
  void WriteBrickGrid(vtkVoxelLineModel* output);
  void WriteBounds(vtkVoxelLineModel* output) const;

  vtkVoxelLineModel* Model;
  const ProgressFunction& GoesOn;
  AveragingRules Rules;
  int Dimensions[3];
  int BrickDimensions[3];
  std::vector<Representative> Lines;
  std::vector<Brick> Bricks;
  /// For each brick cell its index in Bricks, or -1.
  std::vector<std::int32_t> BrickOfCell;
  /// The different curves of each brick, one brick after the other, and where each begins.
  std::vector<std::uint32_t> BrickCurves;
  std::vector<std::uint32_t> FirstCurves;
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
  std::vector<std::size_t> starts(1, this->Lines.size());
  for (const std::vector<Representative>& lines : tasks)
  {
    starts.push_back(starts.back() + lines.size());
  }
  this->Lines.resize(starts.back());
  vtkSMPTools::For(0, static_cast<vtkIdType>(tasks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t task = static_cast<std::size_t>(begin); task < static_cast<std::size_t>(end);
           ++task)
      {
        std::copy(tasks[task].begin(), tasks[task].end(), this->Lines.data() + starts[task]);
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
  this->Lines.resize(table.Cells.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(table.Cells.size()), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const PassageTable::Cell& cell = table.Cells[i];
        this->Lines[i] = Average(this->Rules, cell.Voxel, table.Passages.data() + cell.First,
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
std::uint64_t LevelMaker::KeyOf(const Representative& line) const
{
  std::uint64_t cell = 0;
  std::uint64_t bit = 0;
  for (std::size_t axis = 3; axis-- > 0;)
  {
    cell = cell * static_cast<std::uint64_t>(this->BrickDimensions[axis]) +
      static_cast<std::uint64_t>(line.Voxel[axis] / BrickSize);
    bit = bit * BrickSize + static_cast<std::uint64_t>(line.Voxel[axis] % BrickSize);
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
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(this->Lines.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = { this->KeyOf(this->Lines[i]), static_cast<std::uint32_t>(i) };
  }
  vtkSMPTools::Sort(order.begin(), order.end());
  std::vector<Representative> lines(this->Lines.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(lines.size()), 8192,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        lines[i] = this->Lines[order[i].second];
      }
    });
  this->Lines.swap(lines);
}

//------------------------------------------------------------------------------
void LevelMaker::ListBricks()
{
  this->BrickOfCell.assign(static_cast<std::size_t>(this->BrickDimensions[0]) *
      static_cast<std::size_t>(this->BrickDimensions[1]) *
      static_cast<std::size_t>(this->BrickDimensions[2]),
    -1);
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    const std::uint64_t key = this->KeyOf(this->Lines[i]);
    const std::uint32_t cell = static_cast<std::uint32_t>(key >> 6);
    if (this->Bricks.empty() || this->Bricks.back().Cell != cell)
    {
      this->BrickOfCell[cell] = static_cast<std::int32_t>(this->Bricks.size());
      this->Bricks.push_back({ cell, static_cast<std::uint32_t>(i), 0 });
    }
    this->Bricks.back().Mask |= std::uint64_t(1) << (key & 63);
  }
  this->Bricks.push_back({ 0, static_cast<std::uint32_t>(this->Lines.size()), 0 });
}

//------------------------------------------------------------------------------
Representative* LevelMaker::FindLine(const std::array<int, 3>& voxel)
{
  Representative here;
  here.Voxel = voxel;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (voxel[axis] >= this->Dimensions[axis])
    {
      return nullptr;
    }
  }
  const std::uint64_t key = this->KeyOf(here);
  const std::int32_t brick = this->BrickOfCell[key >> 6];
  if (brick < 0)
  {
    return nullptr;
  }
  const std::size_t index = static_cast<std::size_t>(brick);
  const auto first = this->Lines.begin() + this->Bricks[index].First;
  const auto last = this->Lines.begin() + this->Bricks[index + 1].First;
  const auto line = std::lower_bound(first, last, key,
    [this](const Representative& other, std::uint64_t value)
    { return this->KeyOf(other) < value; });
  return line != last && line->Voxel == voxel ? &*line : nullptr;
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
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Lines.size()), 4096,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        Representative& lower = this->Lines[i];
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

//------------------------------------------------------------------------------
void LevelMaker::WriteBricks(vtkVoxelLineModel* output)
{
  const std::size_t numberOfBricks = this->Bricks.size() - 1;
  auto rows = MakeArray<vtkTypeUInt32Array>(WordsPerRow, numberOfBricks + 1);
  auto starts = MakeArray<vtkTypeUInt16Array>(1, this->Lines.size() + numberOfBricks);
  std::uint16_t* start = starts->GetPointer(0);
  std::vector<std::uint32_t> curves;
  for (std::size_t brick = 0; brick <= numberOfBricks; ++brick)
  {
    const Brick& here = this->Bricks[brick];
    std::uint32_t* row = rows->GetPointer(static_cast<vtkIdType>(WordsPerRow * brick));
    row[0] = static_cast<std::uint32_t>(here.Mask);
    row[1] = static_cast<std::uint32_t>(here.Mask >> 32);
    row[2] = here.First;
    row[3] = here.First + static_cast<std::uint32_t>(brick);
    row[4] = static_cast<std::uint32_t>(this->BrickCurves.size());
    this->FirstCurves.push_back(row[4]);
    if (brick == numberOfBricks)
    {
      break;
    }
    // One line per voxel, and the closing entry.
    const std::uint32_t size = this->Bricks[brick + 1].First - here.First;
    curves.clear();
    for (std::uint32_t i = 0; i <= size; ++i)
    {
      *start++ = static_cast<std::uint16_t>(i);
      if (i < size)
      {
        curves.push_back(this->Lines[here.First + i].Curve);
      }
    }
    std::sort(curves.begin(), curves.end());
    this->BrickCurves.insert(
      this->BrickCurves.end(), curves.begin(), std::unique(curves.begin(), curves.end()));
  }
  output->SetBricks(rows);
  output->SetVoxelStarts(starts);
  auto brickCurves = MakeArray<vtkTypeUInt32Array>(1, this->BrickCurves.size());
  std::copy(this->BrickCurves.begin(), this->BrickCurves.end(), brickCurves->GetPointer(0));
  output->SetBrickCurves(brickCurves);
}

//------------------------------------------------------------------------------
void LevelMaker::WriteSegments(vtkVoxelLineModel* output)
{
  const vtkVoxelLineEncoding::Codec codec(this->Rules.FaceBins);
  const std::size_t size = this->Lines.size();
  const std::size_t attributeSize = this->Rules.AttributeSize;
  vtkSmartPointer<vtkDataArray> segments;
  if (codec.FaceBins == 0)
  {
    segments = MakeArray<vtkFloatArray>(codec.Words, size);
  }
  else
  {
    segments = MakeArray<vtkTypeUInt32Array>(codec.Words, size);
  }
  output->SetSegments(segments);
  void* words = segments->GetVoidPointer(0);
  std::uint8_t* attributes = nullptr;
  if (attributeSize > 0)
  {
    auto array = MakeArray<vtkUnsignedCharArray>(2 * static_cast<int>(attributeSize), size);
    attributes = array->GetPointer(0);
    output->SetAttributes(array);
  }
  std::uint8_t* radii = nullptr;
  if (this->Model->GetRadii())
  {
    auto array = MakeArray<vtkUnsignedCharArray>(2, size);
    radii = array->GetPointer(0);
    output->SetRadii(array);
  }
  // A brick has 64 curves at most, which the words of quantized ends tell apart.
  std::uint8_t* extension = nullptr;
  if (codec.CurveBits == 0)
  {
    auto array = MakeArray<vtkTypeUInt8Array>(1, size);
    extension = array->GetPointer(0);
    output->SetCurveIdExtension(array);
  }

  const auto codeOf = [&codec](const RepresentativeEnd& end)
  {
    const double point[3] = { end.Local[0], end.Local[1], end.Local[2] };
    if (end.Face == NoFace)
    {
      return codec.InteriorCode(point);
    }
    const int axis = end.Face / 2;
    return codec.FaceCode(static_cast<std::uint32_t>(end.Face),
      codec.Bin(point[(axis + 1) % 3], codec.FaceBins),
      codec.Bin(point[(axis + 2) % 3], codec.FaceBins));
  };
  const auto write = [&](std::size_t i, std::uint32_t curve)
  {
    const Representative& line = this->Lines[i];
    if (codec.FaceBins == 0)
    {
      float* target = static_cast<float*>(words) + 6 * i;
      std::copy_n(line.Ends[0].Local.begin(), 3, target);
      std::copy_n(line.Ends[1].Local.begin(), 3, target + 3);
      extension[i] = static_cast<std::uint8_t>(curve);
    }
    else
    {
      std::uint32_t* target =
        static_cast<std::uint32_t*>(words) + static_cast<std::size_t>(codec.Words) * i;
      codec.Pack(codeOf(line.Ends[0]), codeOf(line.Ends[1]), target);
      codec.PackCurve(curve, target);
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      std::copy_n(line.Ends[end].Attribute.begin(), attributeSize,
        attributes + attributeSize * (2 * i + end));
      if (radii)
      {
        radii[2 * i + end] = line.Ends[end].Radius;
      }
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Bricks.size()) - 1, BricksPerTask,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t brick = static_cast<std::size_t>(begin);
           brick < static_cast<std::size_t>(end); ++brick)
      {
        const auto first = this->BrickCurves.begin() + this->FirstCurves[brick];
        const auto last = this->BrickCurves.begin() + this->FirstCurves[brick + 1];
        for (std::size_t i = this->Bricks[brick].First; i < this->Bricks[brick + 1].First; ++i)
        {
          const auto curve = std::lower_bound(first, last, this->Lines[i].Curve);
          write(i, static_cast<std::uint32_t>(curve - first));
        }
      }
    });
}

//------------------------------------------------------------------------------
void LevelMaker::WriteBrickGrid(vtkVoxelLineModel* output)
{
  std::vector<std::uint8_t> distances(this->BrickOfCell.size());
  std::transform(this->BrickOfCell.begin(), this->BrickOfCell.end(), distances.begin(),
    [](std::int32_t brick) { return static_cast<std::uint8_t>(brick >= 0 ? 0 : 255); });
  vtkVoxelLineDistance::Transform(
    distances, this->BrickDimensions, vtkVoxelLineModel::LargestBrickDistance);
  auto grid = MakeArray<vtkTypeInt32Array>(1, this->BrickOfCell.size());
  std::transform(this->BrickOfCell.begin(), this->BrickOfCell.end(), distances.begin(),
    grid->GetPointer(0),
    [](std::int32_t brick, std::uint8_t distance)
    { return brick >= 0 ? brick : -static_cast<std::int32_t>(distance); });
  output->SetBrickGrid(grid);
}

//------------------------------------------------------------------------------
void LevelMaker::WriteBounds(vtkVoxelLineModel* output) const
{
  double low[3];
  double high[3];
  std::fill_n(low, 3, VTK_DOUBLE_MAX);
  std::fill_n(high, 3, -VTK_DOUBLE_MAX);
  for (const Representative& line : this->Lines)
  {
    for (const RepresentativeEnd& end : line.Ends)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double coordinate = line.Voxel[axis] + static_cast<double>(end.Local[axis]);
        low[axis] = std::min(low[axis], coordinate);
        high[axis] = std::max(high[axis], coordinate);
      }
    }
  }
  double bounds[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = output->GetOrigin()[axis] + output->GetVoxelSize() * low[axis];
    bounds[2 * axis + 1] = output->GetOrigin()[axis] + output->GetVoxelSize() * high[axis];
  }
  output->SetBounds(bounds);
}

//------------------------------------------------------------------------------
void LevelMaker::WriteModel(vtkVoxelLineModel* output)
{
  output->SetDimensions(this->Dimensions);
  output->SetOrigin(this->Model->GetOrigin());
  output->SetVoxelSize(std::ldexp(this->Model->GetVoxelSize(), this->Rules.Level));
  output->SetFaceBins(this->Rules.FaceBins);
  output->SetAttributeKind(this->Model->GetAttributeKind());
  output->SetAttributeRange(this->Model->GetAttributeRange());
  output->SetHasNaNAttribute(this->Model->GetHasNaNAttribute());
  output->SetMaximumRadius(this->Model->GetMaximumRadius());
  output->SetNumberOfDroppedPoints(this->Model->GetNumberOfDroppedPoints());
  for (int reason = 0; reason < vtkVoxelLineModel::NumberOfDropReasons; ++reason)
  {
    output->SetNumberOfDroppedCurves(reason, this->Model->GetNumberOfDroppedCurves(reason));
  }
  output->SetLargestDeviation(std::numeric_limits<double>::quiet_NaN());
  output->SetCurveCells(this->Model->GetCurveCells());
  this->WriteBricks(output);
  this->WriteSegments(output);
  this->WriteBrickGrid(output);
  this->WriteBounds(output);
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
