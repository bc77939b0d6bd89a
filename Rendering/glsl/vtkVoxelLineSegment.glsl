// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fetches what a segment holds: end points, radii, curve and colour.
// Common subset of GLSL and C++ with GLM.

void fetchSegment(uint segment, LS_OUT(vec3) a, LS_OUT(vec3) b)
{
  if (SegmentWords == 1)
  {
    uint word = fetchSegmentWord(segment);
    uint codeMask = (1u << uint(2 * FaceBits + 3)) - 1u;
    a = decodePoint(word & codeMask, FaceBits, InteriorBins);
    b = decodePoint((word >> uint(2 * FaceBits + 3)) & codeMask, FaceBits, InteriorBins);
  }
  else if (SegmentWords == 2)
  {
    a = decodePoint(fetchSegmentWord(2u * segment) & 0x3ffffffu, FaceBits, InteriorBins);
    b = decodePoint(fetchSegmentWord(2u * segment + 1u) & 0x3ffffffu, FaceBits, InteriorBins);
  }
  else
  {
    uint i = 6u * segment;
    a = vec3(exactValue(fetchSegmentWord(i)), exactValue(fetchSegmentWord(i + 1u)),
      exactValue(fetchSegmentWord(i + 2u)));
    b = vec3(exactValue(fetchSegmentWord(i + 3u)), exactValue(fetchSegmentWord(i + 4u)),
      exactValue(fetchSegmentWord(i + 5u)));
  }
}

void fetchRadii(uint segment, LS_OUT(Real) ra, LS_OUT(Real) rb)
{
  ra = Radius;
  rb = Radius;
  if (HasRadii)
  {
    ra *= fetchRadius(2u * segment);
    rb *= fetchRadius(2u * segment + 1u);
  }
}

uint fetchCurve(uint segment, int brick)
{
  uint local = 0u;
  uint bits = 0u;
  if (SegmentWords == 1)
  {
    local = fetchSegmentWord(segment) >> 26u;
    bits = 6u;
  }
  else if (SegmentWords == 2)
  {
    local = (fetchSegmentWord(2u * segment) >> 26u) | ((fetchSegmentWord(2u * segment + 1u) >> 26u) << 6u);
    bits = 12u;
  }
  if (IdExtension)
  {
    local = local | (fetchIdExtension(segment) << bits);
  }
  return fetchBrickCurve(fetchBrickFirstCurve(brick) + local);
}

// Colour and opacity of a segment at a parameter from 0 (start) to 1 (end).
vec4 segmentColor(uint segment, Real parameter)
{
  if (Coloring == 1)
  {
    Real q0 = fetchScalar(2u * segment);
    Real q1 = fetchScalar(2u * segment + 1u);
    Real q = q0 + (q1 - q0) * parameter;
    if (HasNaN && (q0 > Real(254.5) || q1 > Real(254.5)))
    {
      q = parameter < Real(0.5) ? q0 : q1;
    }
    int low = int(q);
    int high = min(low + 1, HasNaN && low < 255 ? 254 : 255);
    vec4 lower = fetchTable(low);
    return lower + (fetchTable(high) - lower) * (q - Real(low));
  }
  if (Coloring == 2)
  {
    vec4 c0 = fetchColor(2u * segment);
    return c0 + (fetchColor(2u * segment + 1u) - c0) * parameter;
  }
  return vec4(DiffuseColor, Real(1));
}
