// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineOcclusion.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineSegmentsPrivate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr int VoxelsPerBrick = 64;
constexpr vtkIdType BricksPerTask = 64;
// Parts of the bricks after which progress is told.
constexpr vtkIdType NumberOfRounds = 16;

// Width per length of cones; 14 of them cover the sphere with about 1.1.
constexpr double ConeSpread = 0.8;
// Part of the other lines in a line's own voxel that count: about half of their light comes through
// the side on which a line is seen.
constexpr float OwnPart = 0.5f;
// Optical depth at which a cone ends: less than 1 % of the light is left.
constexpr float DarkDepth = 5.0f;
// Levels whose voxels bricks are made of whole ones.
constexpr int NumberOfLocalLevels = 3;

/// One step of a cone from the centre of a voxel: the voxel that it looks into, as an offset in
/// voxels of level 0, and its optical depth for a density of 1.
struct Step
{
  int Offset[3];
  int Level;
  float Depth;
};

struct Cone
{
  float Weight;
  /// Optical depth from the centre of the voxel to its border for a density of 1.
  float OwnDepth;
  std::vector<Step> Steps;
  /// Number of steps, the first ones, that look into local levels.
  std::size_t NumberOfNearSteps = 0;
};

/// pitch is the distance from voxel to voxel along the direction: where the cone is narrow it looks
/// at their very centres.
Cone MakeCone(const double direction[3], double pitch, double weight, double radius,
  double extinction, int levels)
{
  Cone cone;
  cone.Weight = static_cast<float>(weight);
  int level = 0;
  double t = 0.5 * pitch;
  cone.OwnDepth = static_cast<float>(std::min(t, radius) * extinction);
  while (t < radius)
  {
    // Voxels of the levels beyond the local ones are looked up one by one, and later therefore.
    while (level + 1 < levels &&
      ConeSpread * t >= std::ldexp(level + 1 < NumberOfLocalLevels ? 2.0 : 3.0, level))
    {
      ++level;
    }
    double way = level == 0 ? pitch : std::ldexp(1.0, level);
    const double middle = t + 0.5 * way;
    // No step for less than half a voxel at the end.
    way = t + 1.5 * way > radius ? radius - t : way;
    Step step;
    for (int axis = 0; axis < 3; ++axis)
    {
      step.Offset[axis] = static_cast<int>(std::floor(direction[axis] * middle + 0.5));
    }
    step.Level = level;
    step.Depth = static_cast<float>(way * extinction);
    cone.Steps.push_back(step);
    cone.NumberOfNearSteps += level < NumberOfLocalLevels ? 1 : 0;
    t += way;
  }
  return cone;
}

/// Lebedev's rule with 14 points: the six axes and the eight diagonals.
std::vector<Cone> MakeCones(double radius, double extinction, int levels)
{
  std::vector<Cone> cones;
  for (int i = 0; i < 6; ++i)
  {
    double direction[3] = { 0.0, 0.0, 0.0 };
    direction[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
    cones.push_back(MakeCone(direction, 1.0, 1.0 / 15.0, radius, extinction, levels));
  }
  const double part = 1.0 / std::sqrt(3.0);
  for (int i = 0; i < 8; ++i)
  {
    const double direction[3] = { (i & 1) != 0 ? part : -part, (i & 2) != 0 ? part : -part,
      (i & 4) != 0 ? part : -part };
    cones.push_back(MakeCone(direction, 1.0 / part, 3.0 / 40.0, radius, extinction, levels));
  }
  return cones;
}

/// exp(-x) for x from 0 to DarkDepth and beyond, to a third of a byte's step.
class LightTable
{
public:
  LightTable()
  {
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      this->Values[i] = static_cast<float>(std::exp(-static_cast<double>(i) / EntriesPerUnit));
    }
  }
  float operator()(float depth) const
  {
    // Depths of dense sets are far beyond what a whole number holds.
    return depth < LargestDepth
      ? this->Values[static_cast<std::size_t>(depth * EntriesPerUnit + 0.5f)]
      : 0.0f;
  }

private:
  static constexpr int EntriesPerUnit = 512;
  static constexpr float LargestDepth = 6.0f;
  std::array<float, 6 * EntriesPerUnit + 1> Values;
};

/// What all threads read.
struct Grid
{
  Grid(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities)
    : BrickGrid(static_cast<const std::int32_t*>(model->GetBrickGrid()->GetVoidPointer(0)))
  {
    model->GetBrickDimensions(this->Bricks);
    for (int level = 0; level < densities->GetNumberOfLevels(); ++level)
    {
      this->Levels.emplace_back();
      densities->GetDimensions(level, this->Levels.back().Size);
      this->Levels.back().Values = densities->GetValues(level)->GetPointer(0);
    }
  }

  struct Level
  {
    int Size[3];
    const float* Values;
  };
  const std::int32_t* BrickGrid;
  int Bricks[3];
  std::vector<Level> Levels;
  LightTable Light;
};

/**
 * The densities of one level around a brick, copied to one place: the voxels of a brick look into
 * much the same ones, and need neither look up bricks nor test for the grid's border there.
 */
class Surroundings
{
public:
  /// reach: how far steps go from a voxel of the brick, in voxels of level 0. first: index of the
  /// first value in the place where they are copied to.
  Surroundings(const Grid& grid, int level, int reach, int first)
    : Source(grid)
    , Level(level)
    , Margin((reach + (1 << level) - 1) >> level)
    , Size((BrickSize >> level) + 2 * this->Margin)
    , First(first)
  {
  }

  /// Index behind the last value.
  int GetEnd() const { return this->First + this->Size * this->Size * this->Size; }

  /// Index of the voxel that holds a voxel of level 0, told relative to the brick.
  int GetIndex(int x, int y, int z) const
  {
    return this->First + (x >> this->Level) + this->Margin +
      this->Size *
      ((y >> this->Level) + this->Margin + this->Size * ((z >> this->Level) + this->Margin));
  }

  /// Copy what surrounds the brick of a cell.
  void Copy(const int cell[3], float* values) const
  {
    std::fill(values + this->First, values + this->GetEnd(), 0.0f);
    int first[3];
    int low[3];
    int high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = (cell[axis] * BrickSize >> this->Level) - this->Margin;
      low[axis] = std::max(first[axis], 0);
      high[axis] = std::min(first[axis] + this->Size,
        this->Source.Levels[static_cast<std::size_t>(this->Level)].Size[axis]);
    }
    for (int z = low[2]; z < high[2]; ++z)
    {
      for (int y = low[1]; y < high[1]; ++y)
      {
        float* row =
          values + this->First + this->Size * (y - first[1] + this->Size * (z - first[2]));
        this->CopyRow(low[0], high[0], y, z, row - first[0]);
      }
    }
  }

private:
  static constexpr int BrickSize = vtkVoxelLineModel::BrickSize;

  /// Voxels (x, y, z) for x from low to high go to row[x].
  void CopyRow(int low, int high, int y, int z, float* row) const
  {
    const Grid::Level& level = this->Source.Levels[static_cast<std::size_t>(this->Level)];
    if (this->Level > 0)
    {
      const float* values =
        level.Values + level.Size[0] * (y + static_cast<vtkIdType>(level.Size[1]) * z);
      std::copy(values + low, values + high, row + low);
      return;
    }
    const int* bricks = this->Source.Bricks;
    const std::int32_t* cells = this->Source.BrickGrid +
      bricks[0] * (y / BrickSize + static_cast<vtkIdType>(bricks[1]) * (z / BrickSize));
    for (int x = low; x < high;)
    {
      const int last = std::min(x - x % BrickSize + BrickSize, high);
      const std::int32_t brick = cells[x / BrickSize];
      if (brick >= 0)
      {
        const float* values = level.Values + VoxelsPerBrick * static_cast<vtkIdType>(brick) +
          BrickSize * (y % BrickSize + BrickSize * (z % BrickSize)) + x % BrickSize;
        std::copy(values, values + (last - x), row + x);
      }
      x = last;
    }
  }

  const Grid& Source;
  int Level;
  int Margin;
  int Size;
  int First;
};

/// Follows the cones from the voxels of one brick after the other. Threads have their own.
class Follower
{
public:
  Follower(const Grid& grid, const std::vector<Cone>& cones)
    : Source(grid)
    , Cones(cones)
  {
    int reach[NumberOfLocalLevels] = { 0, 0, 0 };
    for (const Cone& cone : cones)
    {
      for (const Step& step : cone.Steps)
      {
        for (const int offset : step.Offset)
        {
          int& most = reach[std::min(step.Level, NumberOfLocalLevels - 1)];
          most = step.Level < NumberOfLocalLevels ? std::max(most, std::abs(offset)) : most;
        }
      }
    }
    const int levels = std::min(NumberOfLocalLevels, static_cast<int>(grid.Levels.size()));
    for (int level = 0; level < levels; ++level)
    {
      this->Near.emplace_back(
        grid, level, reach[level], level > 0 ? this->Near.back().GetEnd() : 0);
    }
    this->Values.resize(static_cast<std::size_t>(this->Near.back().GetEnd()));
    // Where each of a brick's voxels looks.
    for (int bit = 0; bit < VoxelsPerBrick; ++bit)
    {
      for (const Cone& cone : cones)
      {
        for (std::size_t i = 0; i < cone.NumberOfNearSteps; ++i)
        {
          const Step& step = cone.Steps[i];
          this->Indices.push_back(
            static_cast<std::uint16_t>(this->Near[static_cast<std::size_t>(step.Level)].GetIndex(
              bit % 4 + step.Offset[0], bit / 4 % 4 + step.Offset[1], bit / 16 + step.Offset[2])));
        }
      }
    }
    this->IndicesPerVoxel = this->Indices.size() / VoxelsPerBrick;
  }

  void SetBrick(const int cell[3])
  {
    for (const Surroundings& surroundings : this->Near)
    {
      surroundings.Copy(cell, this->Values.data());
    }
  }

  /**
   * Part of the light that does not reach a line in a voxel of the brick. Of the lines in the voxel
   * itself, the others count, which is all but one part in segments.
   */
  float GetOcclusion(const int voxel[3], int bit, vtkIdType segments) const
  {
    const float* values = this->Values.data();
    const float own = values[this->Near[0].GetIndex(bit % 4, bit / 4 % 4, bit / 16)];
    const float others =
      OwnPart * (own - own / static_cast<float>(std::max(segments, vtkIdType(1))));
    const std::uint16_t* index =
      this->Indices.data() + this->IndicesPerVoxel * static_cast<std::size_t>(bit);
    float light = 0.0f;
    for (const Cone& cone : this->Cones)
    {
      float depth = cone.OwnDepth * others;
      const Step* steps = cone.Steps.data();
      const std::size_t near = cone.NumberOfNearSteps;
      for (std::size_t i = 0; i < near; ++i)
      {
        depth += steps[i].Depth * values[index[i]];
      }
      index += near;
      for (std::size_t i = near; i < cone.Steps.size() && depth < DarkDepth; ++i)
      {
        depth += steps[i].Depth * this->GetFarDensity(voxel, steps[i]);
      }
      light += cone.Weight * this->Source.Light(depth);
    }
    // Weights may add up to a little more than 1.
    return std::max(1.0f - light, 0.0f);
  }

private:
  float GetFarDensity(const int voxel[3], const Step& step) const
  {
    const Grid::Level& level = this->Source.Levels[static_cast<std::size_t>(step.Level)];
    vtkIdType index = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int i = (voxel[axis] + step.Offset[axis]) >> step.Level;
      if (i < 0 || i >= level.Size[axis])
      {
        return 0.0f;
      }
      index = index * level.Size[axis] + i;
    }
    return level.Values[index];
  }

  const Grid& Source;
  const std::vector<Cone>& Cones;
  std::vector<Surroundings> Near;
  std::vector<float> Values;
  std::vector<std::uint16_t> Indices;
  std::size_t IndicesPerVoxel = 0;
};

using BrickValues = std::array<float, VoxelsPerBrick>;

/// Each value becomes the sum of itself and its neighbours along an axis of the brick.
void AddNeighbors(BrickValues& values, std::size_t stride)
{
  for (std::size_t first = 0; first < values.size(); ++first)
  {
    if (first / stride % 4 == 0)
    {
      const float v[4] = { values[first], values[first + stride], values[first + 2 * stride],
        values[first + 3 * stride] };
      values[first] = v[0] + v[1];
      values[first + stride] = v[0] + v[1] + v[2];
      values[first + 2 * stride] = v[1] + v[2] + v[3];
      values[first + 3 * stride] = v[2] + v[3];
    }
  }
}

/// Give the voxels of a brick that have no value, below 0, the mean of the 26 around them.
void FillGaps(BrickValues& values)
{
  const auto isGap = [](float value) { return value < 0.0f; };
  if (std::all_of(values.begin(), values.end(), isGap))
  {
    values.fill(0.0f);
  }
  while (std::any_of(values.begin(), values.end(), isGap))
  {
    BrickValues sums;
    BrickValues counts;
    std::transform(values.begin(), values.end(), sums.begin(),
      [](float value) { return std::max(value, 0.0f); });
    std::transform(values.begin(), values.end(), counts.begin(),
      [&](float value) { return isGap(value) ? 0.0f : 1.0f; });
    for (const std::size_t stride : { 1, 4, 16 })
    {
      AddNeighbors(sums, stride);
      AddNeighbors(counts, stride);
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (isGap(values[i]) && counts[i] > 0.0f)
      {
        values[i] = sums[i] / counts[i];
      }
    }
  }
}

// Where voxels hold few lines, what surrounds them changes little from one to the next: every
// other one is computed, and the rest is interpolated.
constexpr vtkIdType FewSegments = 2;

bool IsSparse(const vtkVoxelLineSegments::Reader& reader, vtkIdType brick)
{
  vtkIdType voxels = 0;
  vtkIdType segments = 0;
  reader.VisitVoxels(brick,
    [&](const int[3], vtkIdType first, vtkIdType last)
    {
      ++voxels;
      segments += last - first;
    });
  return segments < FewSegments * voxels;
}

void ComputeBrick(const vtkVoxelLineSegments::Reader& reader, vtkIdType brick, Follower& follower,
  std::uint8_t* bytes)
{
  BrickValues values;
  values.fill(-1.0f);
  const bool isSparse = IsSparse(reader, brick);
  bool isFirst = true;
  // Two rounds where voxels are left out, since all of a brick's may be of the kind left out.
  for (int parity = 0; parity < 2 && (isFirst || !isSparse); ++parity)
  {
    reader.VisitVoxels(brick,
      [&](const int voxel[3], vtkIdType first, vtkIdType last)
      {
        if ((voxel[0] + voxel[1] + voxel[2]) % 2 != parity)
        {
          return;
        }
        if (isFirst)
        {
          const int cell[3] = { voxel[0] / 4, voxel[1] / 4, voxel[2] / 4 };
          follower.SetBrick(cell);
          isFirst = false;
        }
        const int bit = voxel[0] % 4 + 4 * (voxel[1] % 4) + 16 * (voxel[2] % 4);
        values[static_cast<std::size_t>(bit)] = follower.GetOcclusion(voxel, bit, last - first);
      });
  }
  FillGaps(values);
  std::transform(values.begin(), values.end(), bytes,
    [](float value) { return static_cast<std::uint8_t>(255.0f * value + 0.5f); });
}
}

//------------------------------------------------------------------------------
bool vtkVoxelLineOcclusion::Build(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities,
  double radius, double extinction, const std::function<bool(double)>& progress)
{
  if (this->BuildTime.GetMTime() > 0 && this->DensitiesTime == densities->GetBuildTime() &&
    this->Radius == radius && this->Extinction == extinction)
  {
    return true;
  }
  const vtkIdType bricks = densities->GetNumberOfLevels() > 0 ? model->GetNumberOfBricks() : 0;
  this->Values.assign(static_cast<std::size_t>(VoxelsPerBrick * bricks), 0);
  if (bricks > 0)
  {
    const vtkVoxelLineSegments::Reader reader(model);
    const Grid grid(model, densities);
    // Beyond the grid's diagonal there is nothing: cones, and what is copied around a brick for
    // them, need not reach farther.
    const int* size = model->GetDimensions();
    const double farthest = 2.0 * std::max({ size[0], size[1], size[2] });
    const std::vector<Cone> cones =
      MakeCones(std::min(radius, farthest), extinction, densities->GetNumberOfLevels());
    for (vtkIdType round = 0; round < NumberOfRounds; ++round)
    {
      vtkSMPTools::For(round * bricks / NumberOfRounds, (round + 1) * bricks / NumberOfRounds,
        BricksPerTask,
        [&](vtkIdType begin, vtkIdType end)
        {
          Follower follower(grid, cones);
          for (vtkIdType brick = begin; brick < end; ++brick)
          {
            ComputeBrick(reader, brick, follower, this->Values.data() + VoxelsPerBrick * brick);
          }
        });
      if (progress && !progress(static_cast<double>(round + 1) / NumberOfRounds))
      {
        this->Initialize();
        return false;
      }
    }
  }
  this->DensitiesTime = densities->GetBuildTime();
  this->Radius = radius;
  this->Extinction = extinction;
  this->BuildTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineOcclusion::Initialize()
{
  this->Values = std::vector<std::uint8_t>();
  this->BuildTime = vtkTimeStamp();
}
