// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
// Compiled with AVX2 and FMA. It includes nothing that could leave such code in a shared inline
// function, since other processors run the rest of the library.
#include "vtkVoxelLineCandidates.h"

#include <immintrin.h>

namespace
{
struct Points
{
  __m256 X;
  __m256 Y;
};

inline Points Project(
  __m256i code, __m256i bins, int bits, const vtkVoxelLineProjection& p, __m256 x, __m256 y)
{
  // The permutation takes the lowest three bits of the face.
  const __m256i face = _mm256_srl_epi32(code, _mm_cvtsi32_si128(2 * bits));
  const __m256 u = _mm256_cvtepi32_ps(_mm256_and_si256(code, bins));
  const __m256 v =
    _mm256_cvtepi32_ps(_mm256_and_si256(_mm256_srl_epi32(code, _mm_cvtsi32_si128(bits)), bins));
  Points result;
  const auto look = [face](const float* table)
  { return _mm256_permutevar8x32_ps(_mm256_load_ps(table), face); };
  result.X = _mm256_add_ps(x, look(p.Base[0]));
  result.Y = _mm256_add_ps(y, look(p.Base[1]));
  result.X = _mm256_fmadd_ps(u, look(p.U[0]), result.X);
  result.Y = _mm256_fmadd_ps(u, look(p.U[1]), result.Y);
  result.X = _mm256_fmadd_ps(v, look(p.V[0]), result.X);
  result.Y = _mm256_fmadd_ps(v, look(p.V[1]), result.Y);
  return result;
}
}

std::uint64_t vtkVoxelLineCandidatesAVX2(
  const std::uint32_t* words, int count, const vtkVoxelLineProjection& projection, float x, float y)
{
  const int bits = projection.FaceBits;
  const __m256i bins = _mm256_set1_epi32((1 << bits) - 1);
  const __m256 radius2 = _mm256_set1_ps(projection.Radius2);
  const __m256 cornerX = _mm256_set1_ps(x);
  const __m256 cornerY = _mm256_set1_ps(y);
  std::uint64_t mask = 0;
  for (int i = 0; i < count; i += 8)
  {
    const int left = count - i;
    const __m256i lanes =
      _mm256_cmpgt_epi32(_mm256_set1_epi32(left), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    const __m256i start = _mm256_maskload_epi32(reinterpret_cast<const int*>(words + i), lanes);
    const __m256i end = _mm256_srl_epi32(start, _mm_cvtsi32_si128(2 * bits + 3));
    const Points a = Project(start, bins, bits, projection, cornerX, cornerY);
    const Points b = Project(end, bins, bits, projection, cornerX, cornerY);
    const __m256 dx = _mm256_sub_ps(b.X, a.X);
    const __m256 dy = _mm256_sub_ps(b.Y, a.Y);
    const __m256 length2 = _mm256_fmadd_ps(dx, dx, _mm256_mul_ps(dy, dy));
    const __m256 h = _mm256_fnmsub_ps(a.X, dx, _mm256_mul_ps(a.Y, dy));
    const __m256 cross = _mm256_fmsub_ps(a.X, dy, _mm256_mul_ps(a.Y, dx));
    const __m256 a2 = _mm256_fmadd_ps(a.X, a.X, _mm256_mul_ps(a.Y, a.Y));
    const __m256 b2 = _mm256_fmadd_ps(b.X, b.X, _mm256_mul_ps(b.Y, b.Y));
    __m256 distance2 = _mm256_mul_ps(cross, cross);
    distance2 = _mm256_blendv_ps(
      distance2, _mm256_mul_ps(a2, length2), _mm256_cmp_ps(h, _mm256_setzero_ps(), _CMP_LE_OQ));
    distance2 = _mm256_blendv_ps(
      distance2, _mm256_mul_ps(b2, length2), _mm256_cmp_ps(h, length2, _CMP_GE_OQ));
    const __m256 hit = _mm256_and_ps(_mm256_castsi256_ps(lanes),
      _mm256_cmp_ps(distance2, _mm256_mul_ps(radius2, length2), _CMP_NGT_UQ));
    mask |= static_cast<std::uint64_t>(static_cast<unsigned int>(_mm256_movemask_ps(hit))) << i;
  }
  return mask;
}
