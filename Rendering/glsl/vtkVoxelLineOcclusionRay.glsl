// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casts secondary rays: what part of the light comes through the tubes on the way from a light to
// a point (Kanzler, Rautenhaus and Westermann 2019, Sec. 4.1.2). Common subset of GLSL and C++ with
// GLM.
//
// The ray takes the same way through slabs and voxels as every other (vtkVoxelLineTraversal.glsl).
// It may be cast while another one is blended: that one's state is put aside and brought back, and
// hits are not kept, since what is multiplied needs no order. Tubes have their own width, however
// narrow the pixels.
//
// Where all lines are opaque, any hit ends the light, except for those of the stretch in which the
// ray starts: the curve that it starts in or on, up to where it leaves its tubes. That stretch is
// put together from hits without order: where it grew, the slabs in which it did are visited again.
// Where several curves hold the start, only one of them is known.
//
// Else each tube that is entered lets 1 - opacity through. The tubes of a curve overlap at its joints,
// of which a layer counts once: a segment counts where the ray comes in through its wall, not through
// the spheres at its ends, which lie within the neighbours. For straight lines this is exact.
// At a bend the outer side has a gap, in which nothing counts, and the inner side an overlap, in
// which both segments do: with the same measure, so that the mean remains. The round ends of curves
// do not count. With OpacityByPathLength, the way inside is that in a straight tube without ends.
//
// Of the engine it asks, beyond what the traversal does, for SecondaryRays and LevelRays: whether
// there are any; LevelScale, the width of a voxel in voxels of the level;
//   void putRayAside(), void bringRayBack(): what beginRay() prepares,
//   void beginLevel(), void endLevel(): between them, OnLevel is set, and GridDimensions,
//     BrickDimensions and all that is fetched, but for curves, are those of the level's model.

// Hits that begin nearer to the start of a ray are taken for the tube that it starts on: points on a
// surface are rounded.
const Real SurfaceTolerance = Real(2e-3);
// The same on a level, in its voxels: a representative line so near stands for the point's own line.
const Real LevelBias = Real(1.5);
// A ray ends where no more than this is left of its light, which no picture of 8 bits shows.
const Real DarkLight = Real(0.004);

// Visits slabs until the light is gone.
void followOcclusionRay(Real start, Real end)
{
  int slabs = GridDimensions[Ray.AxisW];
  int way = Ray.Direction[Ray.AxisW] > Real(0) ? 1 : -1;
  Real origin = Ray.Origin[Ray.AxisW];
  Real widening = Real(way) * Ray.Radius;
  int slab = slabAt(origin + Ray.Direction[Ray.AxisW] * start - widening, slabs);
  int lastSlab = slabAt(origin + Ray.Direction[Ray.AxisW] * end + widening, slabs);
  Real least = AllOpaque ? Real(0) : DarkLight;

  // Slabs from here on are judged together: all that may hold the tube in which the ray starts,
  // then one by one.
  int judgedSlab = slab;
  bool mayBeEmpty = true;
  OwnLeave = OccluderStart;
  OwnGrew = false;
  while (true)
  {
    bool past = way > 0 ? slab > lastSlab : slab < lastSlab;
    Real from = (Real(way > 0 ? slab : slab + 1) - widening - origin) * Ray.PerW;
    if (past || (from > OccluderStart && slab != judgedSlab))
    {
      if (Transmittance <= least && !OwnGrew)
      {
        return;
      }
      if (Transmittance <= Real(0))
      {
        Transmittance = Real(1);
        slab = judgedSlab;
        mayBeEmpty = true;
        OwnGrew = false;
        continue;
      }
      judgedSlab = slab;
      OwnGrew = false;
    }
    if (past)
    {
      return;
    }
    int empty = mayBeEmpty ? countEmptySlabs(slab, way) : 0;
    if (empty > 0)
    {
      slab += way * empty;
      continue;
    }
    mayBeEmpty = !visitSlab(slab);
    slab += way;
  }
}

// The ray origin + t direction, OccluderStart < t < end, in the model that is fetched from.
Real castOcclusionRay(vec3 origin, vec3 direction, Real end)
{
  RayState aside = Ray;
  putRayAside();
  Ray.Origin = origin;
  Ray.Direction = direction;
  Ray.Start = Real(0);
  Ray.End = end;
  Ray.Limit = end;
  Ray.Pixel = vec2(Real(0));
  Ray.Radius = Radius;
  Ray.Reach = Radius;
  Transmittance = Real(1);
  Real gridStart = Real(0);
  Real gridEnd = end;
  clipToGrid(gridStart, gridEnd);
  if (gridStart < gridEnd)
  {
    OcclusionRay = true;
    beginRay();
    prepareSlabs();
    followOcclusionRay(gridStart, gridEnd);
    OcclusionRay = false;
  }
  Ray = aside;
  bringRayBack();
  return Transmittance;
}

// What part of the light, 0 to 1, comes through the tubes along origin + t direction, 0 < t < end,
// in grid-local coordinates, |direction| = 1. The tube in which or on which the ray starts lets
// everything through. 1 without SecondaryRays.
Real transmittance(vec3 origin, vec3 direction, Real end)
{
  if (!SecondaryRays)
  {
    return Real(1);
  }
  OccluderStart = SurfaceTolerance;
  return castOcclusionRay(origin, direction, end);
}

// The same through the representative lines of a level, which are as many of its voxels wide
// as tubes are voxels wide. Those nearer than LevelBias let everything through. Origin and end are in
// voxels of the model. 1 without LevelRays.
Real levelTransmittance(vec3 origin, vec3 direction, Real end)
{
  if (!LevelRays)
  {
    return Real(1);
  }
  OccluderStart = LevelBias;
  beginLevel();
  Real through = castOcclusionRay(origin * LevelScale, direction, end * LevelScale);
  endLevel();
  return through;
}
