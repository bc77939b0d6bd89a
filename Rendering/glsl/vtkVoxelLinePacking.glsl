// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Unpacks the end points of voxel line segments. The codes are told in vtkVoxelLineModel.h.
// Common subset of GLSL and C++ with GLM: Real is float (or double in tests).

// Position in [0,1]^3 of an endpoint code within its voxel, for 2^bits bins along a face's edge and
// interiorBins bins along each axis for points inside the voxel.
vec3 decodePoint(uint code, int bits, int interiorBins)
{
  uint bins = 1u << uint(bits);
  uint face = (code >> uint(2 * bits)) & 7u;
  if (face < 6u)
  {
    Real width = Real(1) / Real(bins);
    Real side = Real(face & 1u);
    Real a = (Real(code & (bins - 1u)) + Real(0.5)) * width;
    Real b = (Real((code >> uint(bits)) & (bins - 1u)) + Real(0.5)) * width;
    uint axis = face >> 1u;
    return axis == 0u ? vec3(side, a, b) : (axis == 1u ? vec3(b, side, a) : vec3(a, b, side));
  }
  uint m = uint(interiorBins);
  uint q = code - 6u * bins * bins;
  Real width = Real(1) / Real(interiorBins);
  return (vec3(Real(q % m), Real((q / m) % m), Real(q / (m * m))) + vec3(Real(0.5))) * width;
}
