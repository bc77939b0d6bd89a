// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casts one ray through a voxel line model. Common subset of GLSL and C++ with GLM.
//
// The ray goes through the grid slab by slab along the axis nearest to its direction. A tube
// reaches out of the voxel that holds its segment by up to the radius; so each slab is visited over
// the ray's way through the slab widened by the radius, and with all voxels that lie within the
// radius of that way. The radius is the largest one that the ray may meet: where tubes are thinner
// than a pixel they are drawn as wide as one. Thereby every segment near the ray is tested exactly
// once, and whatever later slabs hold begins behind the start of the next widened slab: hits before
// it can be blended.
//
// Hits wait in a small buffer, ordered by (entry, segment). Where it overflows, the ray
// remembers the first hit that did not fit, blends what comes before, and visits the slabs again for
// what is left: no hit is lost.
//
// A curve gives one layer for each stretch of the ray inside its tubes: hits come in order of entry,
// and one that begins before its curve's last exit only prolongs that stretch.
//
// With Interactive, the ray looks only into the voxels that it passes (Kanzler, Rautenhaus and
// Westermann 2019, Sec. 4.1): slabs are not widened, and what reaches out of its voxel is missing
// where the ray passes other voxels only. Hits are then blended up to where the next slab begins;
// one that is found later and begins before, since its tube reaches into the slab before its own,
// is blended late.
//
// Where the ray starts inside a tube (camera or clipping plane inside), the tube's far wall is seen:
// its layer is put off until the ray leaves the tube.
//
// Where a part of the ray is drawn only, layers that are seen outside of it are not blended, and slabs
// outside are not visited. All tubes that reach into it are found, also those that the ray entered
// before, so that what only prolongs a stretch is known.
//
// While hits are blended, further rays may be cast towards lights: vtkVoxelLineOcclusionRay.glsl.
//
// The engine supplies what vtkVoxelLineFrame and vtkVoxelLineModel tell: GridDimensions,
// BrickDimensions, Radius, LargestRadius, ThinTubes, NarrowTubes, LitAsLines, HasRadii,
// SegmentWords, FaceBits, InteriorBins, IdExtension, Coloring, HasNaN, AmbientColor, DiffuseColor,
// Ambient, Diffuse, Opacity, Lighting, AllOpaque, Picking, Interactive, OpacityByPathLength (false
// where AllOpaque is set), EarlyTermination, Accelerating and AccelerationOpacity, at which the
// rest of a ray goes by densities, NormalFromLocal, ViewFromLocal; the constants HitCapacity,
// ActiveCapacity, InsideCapacity and Beyond, a distance that no ray reaches; and
//   int fetchBrickGrid(int), uvec4 fetchBrick(int), uint fetchBrickFirstCurve(int),
//   uint fetchVoxelStart(uint), uint fetchSegmentWord(uint), uint fetchIdExtension(uint),
//   uint fetchBrickCurve(uint), Real fetchScalar(uint), vec4 fetchColor(uint), Real fetchRadius(uint),
//   vec4 fetchTable(int), int countBits(uint), int lowestBit(uint), Real exactValue(uint),
//   void beginRay(), void beginCandidates(uint, uint, vec3), uint nextCandidate(uint, uint): they leave
//   out segments of a voxel that the ray cannot hit, where an engine tells so faster than the
//   traversal.

void castRay(vec3 origin, vec3 direction, Real start, Real end)
{
  Ray.Origin = origin;
  Ray.Direction = direction;
  // The light of a stretch is that of the wall where it began.
  Real lead = OpacityByPathLength ? Real(4) * LargestRadius + Real(2) : Real(0);
  Real gridStart = max(start, Ray.DrawnFrom - lead);
  Real gridEnd = min(end, Ray.DrawnTo);
  Ray.Radius = LargestRadius;
  Ray.Reach = Interactive ? Real(0) : Ray.Radius;
  clipToGrid(gridStart, gridEnd);
  if (!(gridStart < gridEnd))
  {
    return;
  }
  if (ThinTubes)
  {
    Ray.Radius = max(Radius, max(halfPixelAt(gridStart), halfPixelAt(gridEnd)));
    Ray.Reach = Interactive ? Real(0) : Ray.Radius;
  }
  Ray.Start = start;
  Ray.End = end;
  Ray.Limit = end;
  HitCount = 0;
  HitPlaces = 0;
  InsideCount = 0;
  StartsInside = false;
  ActiveCount = 0;
  OverflowEntry = Beyond;
  OverflowSegment = 0u;
  LastEntry = -Beyond;
  LastSegment = 0u;
  Resuming = false;
  RayColor = vec3(Real(0));
  RayOpacity = Real(0);
  FirstDistance = Real(0);
  FirstCurve = -1;
  HasLayer = false;
  Forgot = false;
  Finished = false;

  beginRay();
  prepareSlabs();
  int slabs = GridDimensions[Ray.AxisW];
  int way = direction[Ray.AxisW] > Real(0) ? 1 : -1;
  Real widening = Real(way) * Ray.Reach;
  Real atStart = origin[Ray.AxisW] + direction[Ray.AxisW] * gridStart - widening;
  Real atEnd = origin[Ray.AxisW] + direction[Ray.AxisW] * gridEnd + widening;
  int firstSlab = slabAt(atStart, slabs);
  int lastSlab = slabAt(atEnd, slabs);
  int resumeEnd = firstSlab;

  bool mayBeEmpty = true;
  int slab = firstSlab;
  while (!Finished)
  {
    bool past = way > 0 ? slab > lastSlab : slab < lastSlab;
    // Hits of this slab and later ones begin behind this distance.
    Real from = past
      ? Beyond
      : (Real(way > 0 ? slab : slab + 1) - widening - origin[Ray.AxisW]) * Ray.PerW;
    bool waiting = HitCount > 0 || InsideCount > 0;
    if (waiting && !blendHits(from))
    {
      Real back = origin[Ray.AxisW] + direction[Ray.AxisW] * OverflowEntry - widening;
      resumeEnd = slab;
      slab = slabAt(back - Real(way), slabs);
      slab = way > 0 ? max(slab, firstSlab) : min(slab, firstSlab);
      HitCount = 0;
      OverflowEntry = Beyond;
      Resuming = true;
      continue;
    }
    if (past || Finished)
    {
      break;
    }
    if (from > Ray.End)
    {
      // Nothing that follows is visible: blend what waits.
      lastSlab = slab - way;
      continue;
    }
    if (mayBeEmpty)
    {
      int empty = countEmptySlabs(slab, way);
      if (empty > 0)
      {
        slab += way * empty;
        continue;
      }
    }
    if (Resuming && (way > 0 ? slab > resumeEnd : slab < resumeEnd))
    {
      Resuming = false;
    }
    Shortening = AllOpaque && from >= Ray.Start;
    mayBeEmpty = !visitSlab(slab);
    slab += way;
  }
}
