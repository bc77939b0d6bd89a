// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Spherical ambient occlusion by brute force: the part of all directions in which capsules are met
 * within a reach. All arithmetic is in double precision, and none of it is shared with what is
 * judged by it.
 *
 * The stretch of each curve that a ray starts inside does not count, so that a point on the axis of
 * a curve is not occluded by that curve's own tube; where the curve comes back, it does.
 */

#ifndef SphericalOcclusion_h
#define SphericalOcclusion_h

#include "Capsule.h"
#include "CapsuleGrid.h"

#include <array>  // For directions
#include <vector> // For directions

namespace linesets
{
class SphericalOcclusion
{
public:
  /// The capsules must live as long as this, and so must their grid. The reach is in their units.
  /// The directions, at least 1, are spread evenly over the sphere (Fibonacci).
  SphericalOcclusion(
    const std::vector<Capsule>& capsules, const CapsuleGrid& grid, double reach, int directions);

  /// Occlusion of a point, 0 to 1. May be called by several threads.
  double GetOcclusion(const double point[3]) const;

private:
  const std::vector<Capsule>& Capsules;
  const CapsuleGrid& Grid;
  double Reach;
  std::vector<std::array<double, 3>> Directions;
};
}

#endif
