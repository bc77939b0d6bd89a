// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One line for each voxel of a level: the average of the passages of curves through it.
 *
 * vtkVoxelLineLevel tells what a representative is; this header has the steps.
 * 1. The passages of each occupied voxel are found (vtkVoxelLinePassagesPrivate.h) and averaged.
 * 2. The representatives are put in the order of a model: by brick, then by voxel.
 * 3. Across each face, the ends of two representatives are joined. Each face belongs to the voxel
 *    on its lower side, and each end lies on one face, so that threads do not meet.
 * 4. The model is written (vtkVoxelLineLevelWriterPrivate.cxx).
 */

#ifndef vtkVoxelLineRepresentativesPrivate_h
#define vtkVoxelLineRepresentativesPrivate_h

#include "vtkVoxelLinePassagesPrivate.h"

#include <functional>
#include <string>

namespace vtkVoxelLineRepresentatives
{

/// Face of an end that lies inside its voxel.
constexpr std::int8_t NoFace = -1;

struct RepresentativeEnd
{
  /// In coordinates of the representative's voxel, [0,1]: the middle of a bin, or an exact point.
  std::array<float, 3> Local;
  /// 0 to 5 for -x +x -y +y -z +z, or NoFace.
  std::int8_t Face;
  std::array<std::uint8_t, 4> Attribute;
  std::uint8_t Radius;
};

struct Representative
{
  std::array<int, 3> Voxel;
  std::uint32_t Curve;
  /// Start and end.
  std::array<RepresentativeEnd, 2> Ends;
};

/// What the representatives of a model have in common.
struct AveragingRules
{
  int Level = 0;
  int FaceBins = 32;
  int InteriorBins = 12;
  /// Attribute bytes that are used, 0 to 4, and whether the byte 255 of a single one marks NaN.
  std::size_t AttributeSize = 0;
  bool HasNaN = false;
};

/// The average of the passages [first, last), of which there is one at least.
Representative Average(const AveragingRules& rules, const std::array<int, 3>& voxel,
  const Passage* first, const Passage* last);

/// The representatives of a level in the order of a model, and the bricks that they make.
struct LevelTable
{
  /// Cell in the brick grid, occupied voxels, and first representative.
  struct Brick
  {
    std::uint32_t Cell;
    std::uint32_t First;
    std::uint64_t Mask;
  };

  int Dimensions[3] = { 0, 0, 0 };
  int BrickDimensions[3] = { 0, 0, 0 };
  std::vector<Representative> Lines;
  /// A last entry ends the range of the brick before it.
  std::vector<Brick> Bricks;
  /// For each cell of the brick grid its index in Bricks, or -1.
  std::vector<std::int32_t> BrickOfCell;
};

/// Fill an initialized model with the representatives of another one.
void WriteModel(vtkVoxelLineModel* source, const AveragingRules& rules, const LevelTable& table,
  vtkVoxelLineModel* output);

/// Is called with the fraction of the work done; returns whether to go on.
using ProgressFunction = std::function<bool(double)>;

/**
 * Make the representatives of a model without defect at a level. Returns what went wrong, or an
 * empty string. The output is empty where something did, where the model is empty, or where it was
 * not to go on.
 */
std::string MakeLevel(
  vtkVoxelLineModel* model, int level, const ProgressFunction& goesOn, vtkVoxelLineModel* output);

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineRepresentativesPrivate.h
