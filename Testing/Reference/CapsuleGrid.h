// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A uniform grid that finds the capsules that a ray may hit.
 *
 * Nothing but an accelerator: each capsule is entered into every cell that the box about it, grown
 * by its radius and a margin for rounding, can touch, so that a ray through the grid meets all
 * capsules that it hits, and the images with and without the grid are equal bit for bit.
 */

#ifndef CapsuleGrid_h
#define CapsuleGrid_h

#include "Capsule.h"

#include <cstdint> // For the cell lists
#include <vector>  // For the cell lists

namespace linesets
{
class CapsuleGrid
{
public:
  /// Build for the capsules of a scene; about as many cells as capsules, at most 2^24.
  explicit CapsuleGrid(const std::vector<Capsule>& capsules);

  /// Walks along the cells of the grid that a ray passes, first to last.
  class Walk
  {
  public:
    Walk(const CapsuleGrid& grid, const double origin[3], const double direction[3], double first,
      double last);

    /// Whether there is a cell.
    bool IsValid() const { return this->Valid; }
    /// Ray parameter at which the ray leaves the cell.
    double GetExit() const;
    const std::uint32_t* begin() const;
    const std::uint32_t* end() const;
    /// Go to the next cell.
    void Next();

  private:
    const CapsuleGrid& Grid;
    bool Valid = false;
    double Last = 0.0;
    int Cell[3];
    int Step[3];
    double NextCrossing[3];
    double CrossingStep[3];
    int GetNextAxis() const;
  };

private:
  template <typename Visitor>
  void VisitCells(const Capsule& capsule, Visitor&& visit) const;
  std::size_t GetIndex(int x, int y, int z) const;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double CellSize = 1.0;
  int Dimensions[3] = { 0, 0, 0 };
  std::vector<std::uint64_t> Starts;
  std::vector<std::uint32_t> Entries;
};
}

#endif
