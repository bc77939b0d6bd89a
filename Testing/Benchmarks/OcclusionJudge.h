// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Holds the spherical occlusion of voxels against brute force, and tells how long it takes.
 *
 * Brute force casts rays from a point on a line's axis through the tubes of the decoded model.
 * Three samples tell different things. Per voxel, the mean over a voxel's lines is held against the
 * voxel's value: the error of the cones through densities. On lines, places on them are held
 * against interpolated values: how lines of one voxel differ comes on top. On what is seen, places
 * are those that the camera sees, which lie at the border of dense regions, where occlusion changes
 * most: the error of the picture.
 */

#ifndef OcclusionJudge_h
#define OcclusionJudge_h

#include "BenchmarkMethod.h"

#include <limits> // For what is not known

namespace linesets
{
/// NaN where it was not measured. Errors are those of occlusions in [0,1].
struct OcclusionMeasures
{
  double VoxelRmse = std::numeric_limits<double>::quiet_NaN();
  double VoxelBias = std::numeric_limits<double>::quiet_NaN(); ///< mean of value - exact
  double LineRmse = std::numeric_limits<double>::quiet_NaN();
  double LineBias = std::numeric_limits<double>::quiet_NaN();
  double SeenRmse = std::numeric_limits<double>::quiet_NaN();
  double SeenBias = std::numeric_limits<double>::quiet_NaN();
  /// Medians of the times that a model's densities and the occlusion of its voxels take.
  double DensityMilliseconds = std::numeric_limits<double>::quiet_NaN();
  double OcclusionMilliseconds = std::numeric_limits<double>::quiet_NaN();
};

/**
 * Measure a method with spherical occlusion, for opaque lines and the view of the input. The result
 * but for times is the same for any number of threads. Throws std::runtime_error where there is
 * nothing to compare.
 */
OcclusionMeasures JudgeOcclusion(const BenchmarkInput& input, BenchmarkMethod& method);
}

#endif
