// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   which segments of a voxel a ray may hit, many at a time
 *
 * Seen along the ray, a tube is a segment in the plane widened by its radius, and the ray is one
 * point. The position of an endpoint in that plane is linear in the bins of its face, so that six
 * numbers per face replace decoding. The test errs on the safe side: the traversal intersects
 * exactly what it lets through. Only one-word segments are tested here.
 */

#ifndef vtkVoxelLineCandidates_h
#define vtkVoxelLineCandidates_h

#include <cstdint>

/// One ray's view of the endpoint codes: position of bin (u,v) of face f is Base + u U + v V.
struct vtkVoxelLineProjection
{
  /// For x and y and the eight face codes. Points inside the voxel (6, 7) have NaN as their
  /// base, by which their segments are always let through.
  alignas(64) float Base[2][8];
  alignas(64) float U[2][8];
  alignas(64) float V[2][8];
  /// Square of the radius, widened for rounding.
  float Radius2;
  /// Bits of u and of v.
  int FaceBits;
};

/**
 * Bit i of the result tells whether the ray may hit segment i; count is at most 64. (x,y) is the
 * position of the voxel's corner relative to the ray.
 */
using vtkVoxelLineCandidateTest = std::uint64_t (*)(const std::uint32_t* words, int count,
  const vtkVoxelLineProjection& projection, float x, float y);

///@{
/// The same test for processors of different kinds; see vtkVoxelLineNativeEngine for the choice.
std::uint64_t vtkVoxelLineCandidatesGeneric(const std::uint32_t* words, int count,
  const vtkVoxelLineProjection& projection, float x, float y);
std::uint64_t vtkVoxelLineCandidatesAVX2(const std::uint32_t* words, int count,
  const vtkVoxelLineProjection& projection, float x, float y);
std::uint64_t vtkVoxelLineCandidatesAVX512(const std::uint32_t* words, int count,
  const vtkVoxelLineProjection& projection, float x, float y);
///@}

#endif
