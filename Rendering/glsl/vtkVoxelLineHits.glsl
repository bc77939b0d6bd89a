// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds where a ray enters tubes and keeps what was found in order until it is blended.
// Common subset of GLSL and C++ with GLM.

// Distance at which the ray is in the middle of a slab. Tubes are intersected relative to this point
// and to their voxel: near it, numbers are small, so that single precision suffices.
Real middleOfSlab(int slab)
{
  return (Real(slab) + Real(0.5) - Ray.Origin[Ray.AxisW]) * Ray.PerW;
}

// Half a pixel at a distance of the ray, in voxels.
Real halfPixelAt(Real t)
{
  return clamp(Ray.Pixel.x + Ray.Pixel.y * t, Real(0), Ray.Radius);
}

// From the radii of a tube to those that it is drawn with: at least half a pixel. t is in the middle
// of the tube's slab. What has no width at either end remains invisible.
void widenTube(Real t, LS_INOUT(Real) ra, LS_INOUT(Real) rb)
{
  if (ThinTubes && max(ra, rb) > Real(0))
  {
    Real least = halfPixelAt(t);
    ra = max(ra, least);
    rb = max(rb, least);
  }
}

bool isBefore(Real entry0, uint segment0, Real entry1, uint segment1)
{
  return entry0 < entry1 || (entry0 == entry1 && segment0 < segment1);
}

void keepHit(Real entry, Real leave, uint segment, int brick, ivec3 voxel)
{
  // Hits that are farther keep the places before it.
  int farther = 0;
  int place = HitPlaces;
  if (HitCount < HitCapacity)
  {
    if (HitCount < HitPlaces)
    {
      place = HitOrder[HitCount];
    }
    else
    {
      HitPlaces = HitPlaces + 1;
    }
    farther = HitCount;
    HitCount = HitCount + 1;
    while (farther > 0)
    {
      int nearer = HitOrder[farther - 1];
      if (!isBefore(HitEntry[nearer], HitSegment[nearer], entry, segment))
      {
        break;
      }
      HitOrder[farther] = nearer;
      farther = farther - 1;
    }
  }
  else
  {
    // The farthest one is lost for now.
    place = HitOrder[0];
    bool replace = isBefore(entry, segment, HitEntry[place], HitSegment[place]);
    Real lostEntry = replace ? HitEntry[place] : entry;
    uint lostSegment = replace ? HitSegment[place] : segment;
    if (isBefore(lostEntry, lostSegment, OverflowEntry, OverflowSegment))
    {
      OverflowEntry = lostEntry;
      OverflowSegment = lostSegment;
    }
    if (!replace)
    {
      return;
    }
    while (farther + 1 < HitCapacity)
    {
      int next = HitOrder[farther + 1];
      if (!isBefore(entry, segment, HitEntry[next], HitSegment[next]))
      {
        break;
      }
      HitOrder[farther] = next;
      farther = farther + 1;
    }
  }
  HitOrder[farther] = place;
  HitEntry[place] = entry;
  HitLeave[place] = leave;
  HitSegment[place] = segment;
  HitBrick[place] = brick;
  HitVoxel[place] = voxel;
}

void visitSegment(uint segment, int brick, ivec3 voxel, vec3 local, Real t)
{
  vec3 a;
  vec3 b;
  Real ra;
  Real rb;
  Real entry;
  Real leave;
  fetchSegment(segment, a, b);
  fetchRadii(segment, ra, rb);
  widenTube(t, ra, rb);
  if (!intersectTube(local, Ray.Direction, a, b, ra, rb, entry, leave))
  {
    return;
  }
  if (SecondaryRays && OcclusionRay)
  {
    meetOccluder(segment, brick, local + Ray.Direction * entry, a, b, ra, rb, entry + t, leave + t);
    return;
  }
  entry += t;
  leave += t;
  if (leave < Ray.Start || (entry >= Ray.Start && entry > Ray.End))
  {
    return;
  }
  if (Resuming && !isBefore(LastEntry, LastSegment, entry, segment))
  {
    return;
  }
  if (entry < Ray.Start)
  {
    StartsInside = true;
  }
  else if (Shortening && !StartsInside)
  {
    Ray.End = entry;
  }
  keepHit(entry, leave, segment, brick, voxel);
}
