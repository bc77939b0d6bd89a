// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blends hits in order, one layer for each stretch of the ray inside the tubes of a curve.
// Common subset of GLSL and C++ with GLM.

// Whether the hit begins a new stretch inside its curve; keeps the curve's exit up to date.
bool beginsStretch(uint curve, Real entry, Real leave)
{
  int slot = -1;
  int i = 0;
  while (i < ActiveCount)
  {
    if (ActiveCurve[i] == curve)
    {
      slot = i;
    }
    else if (ActiveLeave[i] < entry)
    {
      ActiveCount = ActiveCount - 1;
      ActiveCurve[i] = ActiveCurve[ActiveCount];
      ActiveLeave[i] = ActiveLeave[ActiveCount];
      continue;
    }
    i = i + 1;
  }
  if (slot >= 0)
  {
    bool inside = entry <= ActiveLeave[slot];
    ActiveLeave[slot] = inside ? max(ActiveLeave[slot], leave) : leave;
    return !inside;
  }
  if (ActiveCount == ActiveCapacity)
  {
    // Forget the curve that ends first: it is the least likely to matter again.
    Forgot = true;
    slot = 0;
    for (int j = 1; j < ActiveCapacity; ++j)
    {
      slot = ActiveLeave[j] < ActiveLeave[slot] ? j : slot;
    }
  }
  else
  {
    slot = ActiveCount;
    ActiveCount = ActiveCount + 1;
  }
  ActiveCurve[slot] = curve;
  ActiveLeave[slot] = leave;
  return true;
}

// Shades the segment where the ray meets its wall and blends it as the next layer.
void blendLayer(Real seen, bool fromInside, uint segment, int brick, ivec3 voxel)
{
  vec3 a;
  vec3 b;
  Real ra;
  Real rb;
  fetchSegment(segment, a, b);
  fetchRadii(segment, ra, rb);
  Real t = middleOfSlab(voxel[Ray.AxisW]);
  vec3 x = Ray.Origin + Ray.Direction * t - vec3(voxel) + Ray.Direction * (seen - t);
  Real parameter = tubeParameter(x, a, b);
  Real radius = ra + (rb - ra) * parameter;
  widenTube(t, ra, rb);
  vec4 color = segmentColor(segment, parameter);
  color.w = Picking ? Real(1) : color.w * Opacity * tubeCoverage(radius, ra + (rb - ra) * parameter);
  if (color.w <= Real(0))
  {
    return;
  }
  if (!HasLayer)
  {
    HasLayer = true;
    FirstDistance = seen;
    FirstCurve = Picking ? int(fetchCurve(segment, brick)) : 0;
  }
  vec3 ambient = (Coloring == 0 ? AmbientColor : vec3(color)) * Ambient;
  vec3 diffuse = vec3(color) * Diffuse;
  vec3 shade = ambient + diffuse;
  if (Lighting)
  {
    vec3 normal = tubeNormal(x, a, b, ra, rb);
    vec3 position = vec3(ViewFromLocal * vec4(x + vec3(voxel), Real(1)));
    shade = lightTube(
      position, fromInside ? -normal : normal, b - a, surfacePart(radius, t), ambient, diffuse);
  }
  shade = clamp(shade, Real(0), Real(1));
  Real weight = (Real(1) - RayOpacity) * color.w;
  RayColor += shade * weight;
  RayOpacity += weight;
  Finished = RayOpacity >= EarlyTermination || color.w >= Real(1);
}

void blendHit(Real entry, Real leave, uint segment, int brick, ivec3 voxel)
{
  // Opaque lines seen from outside need no stretches: the first hit is all.
  if ((StartsInside || !AllOpaque) && !beginsStretch(fetchCurve(segment, brick), entry, leave))
  {
    return;
  }
  if (entry >= Ray.Start)
  {
    blendLayer(entry, false, segment, brick, voxel);
  }
  else if (leave > Ray.Limit)
  {
    return; // the far wall is hidden
  }
  else if (InsideCount < InsideCapacity)
  {
    InsideLeave[InsideCount] = leave;
    InsideSegment[InsideCount] = segment;
    InsideBrick[InsideCount] = brick;
    InsideVoxel[InsideCount] = voxel;
    InsideCount = InsideCount + 1;
  }
  else
  {
    Forgot = true;
    blendLayer(leave, true, segment, brick, voxel);
  }
}

// Blends the layers that were put off and come before a distance.
void blendInside(Real limit)
{
  while (InsideCount > 0 && !Finished)
  {
    int first = 0;
    for (int i = 1; i < InsideCount; ++i)
    {
      first = InsideLeave[i] < InsideLeave[first] ? i : first;
    }
    if (InsideLeave[first] >= limit)
    {
      return;
    }
    Real leave = InsideLeave[first];
    uint segment = InsideSegment[first];
    int brick = InsideBrick[first];
    ivec3 voxel = InsideVoxel[first];
    InsideCount = InsideCount - 1;
    InsideLeave[first] = InsideLeave[InsideCount];
    InsideSegment[first] = InsideSegment[InsideCount];
    InsideBrick[first] = InsideBrick[InsideCount];
    InsideVoxel[first] = InsideVoxel[InsideCount];
    blendLayer(leave, true, segment, brick, voxel);
  }
}

// Blends, in order, the waiting hits that begin before a distance. Returns whether all of them could
// be blended: not where one that did not fit comes before that distance.
bool blendHits(Real limit)
{
  while (HitCount > 0 && !Finished)
  {
    int first = HitOrder[HitCount - 1];
    Real entry = HitEntry[first];
    uint segment = HitSegment[first];
    if (entry >= limit || !isBefore(entry, segment, OverflowEntry, OverflowSegment))
    {
      break;
    }
    if (InsideCount > 0)
    {
      blendInside(entry);
      if (Finished)
      {
        break;
      }
    }
    Real leave = HitLeave[first];
    int brick = HitBrick[first];
    ivec3 voxel = HitVoxel[first];
    HitCount = HitCount - 1;
    LastEntry = entry;
    LastSegment = segment;
    blendHit(entry, leave, segment, brick, voxel);
  }
  if (OverflowEntry < limit && !Finished)
  {
    return false;
  }
  blendInside(limit);
  return true;
}
