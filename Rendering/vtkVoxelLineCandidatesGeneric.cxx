// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineCandidates.h"

std::uint64_t vtkVoxelLineCandidatesGeneric(
  const std::uint32_t* words, int count, const vtkVoxelLineProjection& projection, float x, float y)
{
  const int bits = projection.FaceBits;
  const std::uint32_t bins = (1u << bits) - 1u;
  const float radius2 = projection.Radius2;
  std::uint64_t mask = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::uint32_t start = words[i];
    const std::uint32_t end = start >> (2 * bits + 3);
    const std::uint32_t f0 = (start >> (2 * bits)) & 7u;
    const std::uint32_t f1 = (end >> (2 * bits)) & 7u;
    const float u0 = static_cast<float>(start & bins);
    const float v0 = static_cast<float>((start >> bits) & bins);
    const float u1 = static_cast<float>(end & bins);
    const float v1 = static_cast<float>((end >> bits) & bins);
    const float ax =
      x + projection.Base[0][f0] + u0 * projection.U[0][f0] + v0 * projection.V[0][f0];
    const float ay =
      y + projection.Base[1][f0] + u0 * projection.U[1][f0] + v0 * projection.V[1][f0];
    const float bx =
      x + projection.Base[0][f1] + u1 * projection.U[0][f1] + v1 * projection.V[0][f1];
    const float by =
      y + projection.Base[1][f1] + u1 * projection.U[1][f1] + v1 * projection.V[1][f1];
    const float dx = bx - ax;
    const float dy = by - ay;
    const float length2 = dx * dx + dy * dy;
    const float h = -(ax * dx + ay * dy);
    const float cross = ax * dy - ay * dx;
    // Square of the distance from the ray to the segment, times length2 to spare the division.
    float distance2 = cross * cross;
    distance2 = h <= 0.0f ? (ax * ax + ay * ay) * length2 : distance2;
    distance2 = h >= length2 ? (bx * bx + by * by) * length2 : distance2;
    const std::uint64_t candidate = !(distance2 > radius2 * length2) ? 1u : 0u;
    mask |= candidate << i;
  }
  return mask;
}
