// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
// Compiled with AVX-512. It includes nothing that could leave such code in a shared inline
// function, since other processors run the rest of the library.
#include "vtkVoxelLineCandidates.h"

#if defined(__GNUC__) && !defined(__clang__)
// GCC 12 takes its own _mm512_undefined_ps() for a mistake of ours.
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

namespace
{
struct Tables
{
  __m512 Base[2];
  __m512 U[2];
  __m512 V[2];
};

struct Points
{
  __m512 X;
  __m512 Y;
};

// The eight faces, twice: the permutation takes the lowest four bits of the index, of which the
// fourth belongs to other data.
inline __m512 Twice(const float* table)
{
  const __m512 low = _mm512_castps256_ps512(_mm256_load_ps(table));
  return _mm512_shuffle_f32x4(low, low, 0x44);
}

inline Points Project(__m512i code, __m512i bins, int bits, const Tables& t, __m512 x, __m512 y)
{
  const __m512i face = _mm512_srl_epi32(code, _mm_cvtsi32_si128(2 * bits));
  const __m512 u = _mm512_cvtepi32_ps(_mm512_and_si512(code, bins));
  const __m512 v =
    _mm512_cvtepi32_ps(_mm512_and_si512(_mm512_srl_epi32(code, _mm_cvtsi32_si128(bits)), bins));
  Points result;
  result.X = _mm512_add_ps(x, _mm512_permutexvar_ps(face, t.Base[0]));
  result.Y = _mm512_add_ps(y, _mm512_permutexvar_ps(face, t.Base[1]));
  result.X = _mm512_fmadd_ps(u, _mm512_permutexvar_ps(face, t.U[0]), result.X);
  result.Y = _mm512_fmadd_ps(u, _mm512_permutexvar_ps(face, t.U[1]), result.Y);
  result.X = _mm512_fmadd_ps(v, _mm512_permutexvar_ps(face, t.V[0]), result.X);
  result.Y = _mm512_fmadd_ps(v, _mm512_permutexvar_ps(face, t.V[1]), result.Y);
  return result;
}
}

std::uint64_t vtkVoxelLineCandidatesAVX512(
  const std::uint32_t* words, int count, const vtkVoxelLineProjection& projection, float x, float y)
{
  const int bits = projection.FaceBits;
  const __m512i bins = _mm512_set1_epi32((1 << bits) - 1);
  const __m512 radius2 = _mm512_set1_ps(projection.Radius2);
  const __m512 cornerX = _mm512_set1_ps(x);
  const __m512 cornerY = _mm512_set1_ps(y);
  const Tables tables = { { Twice(projection.Base[0]), Twice(projection.Base[1]) },
    { Twice(projection.U[0]), Twice(projection.U[1]) },
    { Twice(projection.V[0]), Twice(projection.V[1]) } };
  std::uint64_t mask = 0;
  for (int i = 0; i < count; i += 16)
  {
    const int left = count - i;
    const __mmask16 lanes =
      left >= 16 ? static_cast<__mmask16>(0xffffu) : static_cast<__mmask16>((1u << left) - 1u);
    const __m512i start = _mm512_maskz_loadu_epi32(lanes, words + i);
    const __m512i end = _mm512_srl_epi32(start, _mm_cvtsi32_si128(2 * bits + 3));
    const Points a = Project(start, bins, bits, tables, cornerX, cornerY);
    const Points b = Project(end, bins, bits, tables, cornerX, cornerY);
    const __m512 dx = _mm512_sub_ps(b.X, a.X);
    const __m512 dy = _mm512_sub_ps(b.Y, a.Y);
    const __m512 length2 = _mm512_fmadd_ps(dx, dx, _mm512_mul_ps(dy, dy));
    const __m512 h = _mm512_fnmsub_ps(a.X, dx, _mm512_mul_ps(a.Y, dy));
    const __m512 cross = _mm512_fmsub_ps(a.X, dy, _mm512_mul_ps(a.Y, dx));
    const __m512 a2 = _mm512_fmadd_ps(a.X, a.X, _mm512_mul_ps(a.Y, a.Y));
    const __m512 b2 = _mm512_fmadd_ps(b.X, b.X, _mm512_mul_ps(b.Y, b.Y));
    __m512 distance2 = _mm512_mul_ps(cross, cross);
    distance2 = _mm512_mask_mul_ps(
      distance2, _mm512_cmp_ps_mask(h, _mm512_setzero_ps(), _CMP_LE_OQ), a2, length2);
    distance2 =
      _mm512_mask_mul_ps(distance2, _mm512_cmp_ps_mask(h, length2, _CMP_GE_OQ), b2, length2);
    const __mmask16 hit =
      _mm512_mask_cmp_ps_mask(lanes, distance2, _mm512_mul_ps(radius2, length2), _CMP_NGT_UQ);
    mask |= static_cast<std::uint64_t>(hit) << i;
  }
  return mask;
}
