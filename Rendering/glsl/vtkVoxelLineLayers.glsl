// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Blends hits in order, one layer for each stretch of the ray inside the tubes of a curve.
// Common subset of GLSL and C++ with GLM.
//
// With OpacityByPathLength (Kanzler, Rautenhaus and Westermann 2019, Sec. 4.1.1), a stretch is blended
// piece by piece: each segment adds the length by which it makes the stretch longer. What the
// pieces let through is multiplied, so that their order does not matter to the opacity.

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
      if (OpacityByPathLength)
      {
        ActiveShade[i] = ActiveShade[ActiveCount];
        ActivePath[i] = ActivePath[ActiveCount];
      }
      continue;
    }
    i = i + 1;
  }
  if (slot >= 0)
  {
    HitSlot = slot;
    HitFrom = ActiveLeave[slot];
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
  HitSlot = slot;
  ActiveCurve[slot] = curve;
  ActiveLeave[slot] = leave;
  return true;
}

// Opacity of a tube that covers a part of its width. opacity is that of a ray through the whole
// diameter; with OpacityByPathLength, the ray has gone through some diameters before and goes on up
// to some, so that what is blended piece by piece adds up.
Real layerOpacity(Real opacity, Real coverage, Real before, Real upTo)
{
  if (!OpacityByPathLength)
  {
    return opacity * coverage;
  }
  if (opacity >= Real(1))
  {
    return before > Real(0) ? Real(0) : coverage;
  }
  Real clear = Real(1) - max(opacity, Real(0));
  Real clearBefore = Real(1) - coverage * (Real(1) - pow(clear, before));
  Real clearUpTo = Real(1) - coverage * (Real(1) - pow(clear, upTo));
  return max(Real(1) - clearUpTo / max(clearBefore, Real(1e-30)), Real(0));
}

bool isDrawn(Real seen)
{
  return seen >= Ray.DrawnFrom && seen < Ray.DrawnTo;
}

// Blends what is seen at a distance behind all that was blended before.
void blend(vec3 shade, Real opacity, Real seen, uint segment, int brick)
{
  if (!isDrawn(seen))
  {
    return;
  }
  if (!HasLayer)
  {
    HasLayer = true;
    FirstDistance = seen;
    FirstCurve = Picking ? int(fetchCurve(segment, brick)) : 0;
  }
  Real weight = (Real(1) - RayOpacity) * opacity;
  RayColor += shade * weight;
  RayOpacity += weight;
  Finished = RayOpacity >= EarlyTermination || opacity >= Real(1);
  if (Accelerating && !Finished && RayOpacity >= AccelerationOpacity)
  {
    accelerate(seen);
  }
}

// Shades the segment where the ray meets its wall and blends it as the next layer. The ray goes
// some way in it.
void blendLayer(Real seen, bool fromInside, Real way, uint segment, int brick, ivec3 voxel)
{
  // The light of a stretch that begins outside may be asked for inside.
  if (!OpacityByPathLength && !isDrawn(seen))
  {
    return;
  }
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
  Real drawnRadius = ra + (rb - ra) * parameter;
  vec4 color = segmentColor(segment, parameter);
  Real path = OpacityByPathLength ? way / (Real(2) * max(drawnRadius, Real(1e-20))) : Real(0);
  color.w = Picking
    ? Real(1)
    : layerOpacity(color.w * Opacity, tubeCoverage(radius, drawnRadius), Real(0), path);
  if (color.w <= Real(0) && !OpacityByPathLength)
  {
    return;
  }
  vec3 ambient = (Coloring == 0 ? AmbientColor : vec3(color)) * Ambient;
  vec3 diffuse = vec3(color) * Diffuse;
  vec3 shade = ambient + diffuse;
  if (Lighting)
  {
    vec3 normal = tubeNormal(x, a, b, ra, rb);
    vec3 position = vec3(ViewFromLocal * vec4(x + vec3(voxel), Real(1)));
    normal = fromInside ? -normal : normal;
    // Of a tube that is drawn wider than it is, light and shadow are those at its axis.
    ShadedAxis = vec3(voxel) + a + (b - a) * parameter;
    ShadedPoint = drawnRadius > radius ? ShadedAxis : x + vec3(voxel);
    ShadedNormal = normal;
    shade = lightTube(position, normal, b - a, surfacePart(radius, t), ambient, diffuse);
    shade = clamp(shade, Real(0), Real(1)) * ambientVisibility();
  }
  shade = clamp(shade, Real(0), Real(1));
  if (OpacityByPathLength && !fromInside)
  {
    ActiveShade[HitSlot] = shade;
    ActivePath[HitSlot] = path;
  }
  if (color.w > Real(0))
  {
    blend(shade, color.w, seen, segment, brick);
  }
}

// Blends what a further segment adds to a stretch that was seen to begin: the light is that of the
// wall where it began, the opacity that of the segment over the way from the end of those before.
void prolongLayer(Real leave, uint segment, int brick, ivec3 voxel)
{
  vec3 a;
  vec3 b;
  Real ra;
  Real rb;
  fetchSegment(segment, a, b);
  fetchRadii(segment, ra, rb);
  Real t = middleOfSlab(voxel[Ray.AxisW]);
  vec3 x = Ray.Origin + Ray.Direction * t - vec3(voxel) + Ray.Direction * (HitFrom - t);
  Real parameter = tubeParameter(x, a, b);
  Real radius = ra + (rb - ra) * parameter;
  widenTube(t, ra, rb);
  Real drawnRadius = ra + (rb - ra) * parameter;
  Real before = ActivePath[HitSlot];
  Real upTo = before + (leave - HitFrom) / (Real(2) * max(drawnRadius, Real(1e-20)));
  Real opacity = layerOpacity(segmentColor(segment, parameter).w * Opacity,
    tubeCoverage(radius, drawnRadius), before, upTo);
  ActivePath[HitSlot] = upTo;
  if (opacity > Real(0))
  {
    blend(ActiveShade[HitSlot], opacity, HitFrom, segment, brick);
  }
}

// Puts off a layer in which the ray starts, and goes some way, until it leaves the tube.
void keepInside(Real leave, Real way, uint segment, int brick, ivec3 voxel)
{
  if (leave > Ray.Limit)
  {
    return; // the far wall is hidden
  }
  if (InsideCount < InsideCapacity)
  {
    InsideLeave[InsideCount] = leave;
    InsideLength[InsideCount] = way;
    InsideSegment[InsideCount] = segment;
    InsideBrick[InsideCount] = brick;
    InsideVoxel[InsideCount] = voxel;
    InsideCount = InsideCount + 1;
  }
  else
  {
    Forgot = true;
    blendLayer(leave, true, way, segment, brick, voxel);
  }
}

// What a segment adds to the stretch of its curve, which goes on: with OpacityByPathLength, the
// length by which the stretch becomes longer.
void blendProlongation(Real leave, uint segment, int brick, ivec3 voxel)
{
  Real from = max(HitFrom, Ray.Start);
  Real upTo = min(leave, Ray.Limit);
  if (upTo <= from)
  {
    return;
  }
  if (ActivePath[HitSlot] < Real(0))
  {
    keepInside(leave, leave - from, segment, brick, voxel);
  }
  else
  {
    prolongLayer(upTo, segment, brick, voxel);
  }
}

void blendHit(Real entry, Real leave, uint segment, int brick, ivec3 voxel)
{
  // Opaque lines seen from outside need no stretches: the first hit is all.
  if ((StartsInside || !AllOpaque) && !beginsStretch(fetchCurve(segment, brick), entry, leave))
  {
    if (OpacityByPathLength)
    {
      blendProlongation(leave, segment, brick, voxel);
    }
    return;
  }
  if (entry >= Ray.Start)
  {
    blendLayer(entry, false, min(leave, Ray.Limit) - entry, segment, brick, voxel);
    return;
  }
  if (OpacityByPathLength)
  {
    ActivePath[HitSlot] = Real(-1);
  }
  keepInside(leave, leave - Ray.Start, segment, brick, voxel);
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
    Real way = InsideLength[first];
    uint segment = InsideSegment[first];
    int brick = InsideBrick[first];
    ivec3 voxel = InsideVoxel[first];
    InsideCount = InsideCount - 1;
    InsideLeave[first] = InsideLeave[InsideCount];
    InsideLength[first] = InsideLength[InsideCount];
    InsideSegment[first] = InsideSegment[InsideCount];
    InsideBrick[first] = InsideBrick[InsideCount];
    InsideVoxel[first] = InsideVoxel[InsideCount];
    blendLayer(leave, true, way, segment, brick, voxel);
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
