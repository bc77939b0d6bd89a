// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Puts traced segments in order and assembles a vtkVoxelLineModel from them.
 *
 * The segments come in the order of the curves, in blocks that do not depend on the number of
 * threads. Their index in that order is their emission index; it tells curve and position.
 * 1. Count the segments of each brick cell (atomic additions), and take the running sum: it gives
 *    each brick its range.
 * 2. Scatter the emission indices into those ranges (atomic cursors). Their order within a brick
 *    depends on the threads here.
 * 3. For each brick, sort its emission indices, which makes the order the same again, list its
 *    curves, and order the segments by voxel without changing the order within a voxel. Write words
 *    and payload to their place.
 * 4. Join what the bricks have: voxel starts, curve lists, the higher bits of the local curve ids.
 * 5. Fill the empty cells of the brick grid with their distance to the nearest brick.
 */

#ifndef vtkVoxelLineModelBuilderPrivate_h
#define vtkVoxelLineModelBuilderPrivate_h

#include "vtkLineVoxelizerTracePrivate.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkVoxelLineModel;

namespace vtkLineVoxelizerPrivate
{

/// Memory that is not filled in advance, since every element will be written.
template <typename T>
class Buffer
{
public:
  void Allocate(std::size_t size)
  {
    this->Values.reset(new T[size]);
    this->Length = size;
  }
  void Free() { this->Values.reset(); }
  T* Get(std::size_t i = 0) { return this->Values.get() + i; }
  const T* Get(std::size_t i = 0) const { return this->Values.get() + i; }
  T& operator[](std::size_t i) { return this->Values[i]; }
  const T& operator[](std::size_t i) const { return this->Values[i]; }
  std::size_t Size() const { return this->Length; }

private:
  std::unique_ptr<T[]> Values;
  std::size_t Length = 0;
};

class ModelBuilder
{
public:
  ModelBuilder(const Grid& grid, int faceBins, const Payload& payload);

  /// Take the segments of all blocks in one row, and free the blocks. At most 2^31 segments.
  void TakeSegments(std::vector<Trace>& blocks);

  /// Steps 1 and 2.
  void SortIntoBricks();

  /// Steps 3 and 4. Fills the model's arrays but BrickGrid.
  void AssembleBricks(vtkVoxelLineModel* model);

  /// Step 5.
  void MakeBrickGrid(vtkVoxelLineModel* model);

private:
  struct Assembly;
  struct Target;
  class BrickWriter;

  std::size_t NumberOfBricks() const { return this->BrickStarts.size() - 1; }
  Target MakeArrays(vtkVoxelLineModel* model) const;
  void JoinBricks(vtkVoxelLineModel* model, std::vector<Assembly>& assemblies);
  template <typename ArrayT>
  void JoinVoxelStarts(vtkVoxelLineModel* model, const std::vector<Assembly>& assemblies) const;
  void MakeCurveIdExtension(vtkVoxelLineModel* model, std::uint32_t largestBrickCurves);

  const Grid& Cells;
  const vtkVoxelLineEncoding::Codec Codec;
  const Payload Values;
  const RecordLayout Layout;

  std::size_t NumberOfSegments = 0;
  /// By emission index.
  Buffer<std::uint32_t> SegmentCells;
  Buffer<std::uint32_t> Records;
  /// Emission index of the first segment of each curve, and the number of segments.
  std::vector<std::uint32_t> CurveStarts;
  /// The curve of every 64th emission index, from which the curve of the others is not far.
  std::vector<std::uint32_t> FirstCurves;

  /// Cell and first segment of each brick, and the number of segments.
  std::vector<std::uint32_t> BrickCells;
  std::vector<std::uint32_t> BrickStarts;
  /// Emission indices by brick; each is overwritten by its segment's local curve id in step 3.
  Buffer<std::uint32_t> Order;
};

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineModelBuilderPrivate.h
