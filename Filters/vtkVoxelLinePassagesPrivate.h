// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The passages of curves through the voxels of a level: where each curve comes in, and where it
 * goes out.
 *
 * A curve's segments within a voxel follow each other from point to point; one that begins where
 * another of its curve ends belongs to the same passage. So does, in a voxel of a coarser level,
 * a passage of one of its eight parts that begins where one of another part ends: these points
 * are equal exactly, since the end points of a model are quantized once for both sides of a
 * face. A curve that comes back has several passages. Which of several passages that meet in a
 * point belong together cannot be told; however they are joined, from each way in there is a way
 * out, and what is left are rings. A ring, or any passage that ends where it begins, counts only
 * where its curve has no other passage through the voxel. The passages of a level are thus what a
 * voxelization with voxels of that size and no points inside voxels would give, but they are made
 * from the model, level by level, without the curves.
 */

#ifndef vtkVoxelLinePassagesPrivate_h
#define vtkVoxelLinePassagesPrivate_h

#include "vtkVoxelLineSegmentsPrivate.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkVoxelLineRepresentatives
{

/// Where a curve comes into a voxel or goes out of it.
struct PassageEnd
{
  /**
   * Grid-local coordinates of the model, the same number on both sides of a face. Single precision
   * holds those of all quantized points on faces exactly, up to the largest model of 4096 voxels.
   */
  std::array<float, 3> Point;
  std::array<std::uint8_t, 4> Attribute;
  std::uint8_t Radius;
};

struct Passage
{
  std::uint32_t Curve;
  PassageEnd Start;
  PassageEnd End;
};

/// The passages of several voxels of a level, one voxel after the other.
struct PassageTable
{
  struct Cell
  {
    std::array<int, 3> Voxel;
    /// Passages [First, Last).
    std::size_t First;
    std::size_t Last;
  };

  void Clear()
  {
    this->Passages.clear();
    this->Cells.clear();
  }

  /// Take what another table holds, after what is here, and leave that one empty.
  void Append(PassageTable& other);

  std::vector<Passage> Passages;
  std::vector<Cell> Cells;
};

/// Joins passages of parts of a voxel to passages of the voxel.
class PassageJoiner
{
public:
  /**
   * Append what a row of passages gives, ordered by curve, and for each curve in the order of the
   * first ones of each. Where a curve goes through the same point several times, its passages are
   * joined in the order given.
   */
  void Join(const std::vector<Passage>& parts, std::vector<Passage>& passages);

private:
  void SortByCurve(const std::vector<Passage>& parts);
  void JoinCurve(std::vector<Passage>& passages);
  void FindFewSuccessors();
  void FindManySuccessors();

  /// Curve and index of each part in one number, to sort by, where runs of these begin that
  /// ascend, and what they are merged into.
  std::vector<std::uint64_t> Keys;
  std::vector<std::size_t> Runs;
  std::vector<std::uint64_t> MergedKeys;
  /// The parts of one curve, for each the one that follows it, and whether it follows one.
  std::vector<Passage> Parts;
  std::vector<std::uint32_t> Successors;
  std::vector<std::uint8_t> HasPredecessor;
  std::vector<std::uint8_t> IsDone;
  /// Parts by start point and index, and for the first one of each point, how many of these were
  /// looked at.
  std::vector<std::uint32_t> Order;
  std::vector<std::uint32_t> Used;
};

/// Reads the passages of bricks, up to the level at which a voxel is a brick.
class PassageReader
{
public:
  static constexpr int LargestLevel = 2;

  /// The model must live, and its arrays stay as they are, as long as the reader.
  explicit PassageReader(vtkVoxelLineModel* model);

  vtkIdType GetNumberOfBricks() const { return this->Segments.GetNumberOfBricks(); }

  /// What a thread needs to read.
  struct Scratch
  {
    PassageJoiner Joiner;
    std::array<std::vector<Passage>, 8> Parts;
  };

  /// Append the passages of a brick's voxels of a level from 0 to LargestLevel.
  void ReadBrick(vtkIdType brick, int level, Scratch& scratch, PassageTable& table) const;

private:
  void ReadVoxel(vtkIdType brick, const int voxel[3], vtkIdType first, vtkIdType last,
    std::vector<Passage>& passages) const;
  void ReadEnd(vtkIdType segment, int end, const int voxel[3], const double local[3],
    PassageEnd& target) const;

  const vtkVoxelLineSegments::Reader Segments;
  const std::uint8_t* Attributes = nullptr;
  std::size_t AttributeSize = 0;
  const std::uint8_t* Radii = nullptr;
};

/// The passages of the next coarser level, ordered by voxel, x fastest.
void JoinLevel(const PassageTable& fine, PassageTable& coarse);

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLinePassagesPrivate.h
