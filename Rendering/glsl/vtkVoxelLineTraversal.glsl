// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Casts one ray through a voxel line model. Common subset of GLSL and C++ with GLM.
//
// The ray goes through the grid slab by slab along the axis nearest to its direction. A tube reaches
// out of the voxel that holds its segment by up to the radius; so each slab is visited over the
// ray's way through the slab widened by the radius, and with all voxels that lie within
// the radius of that way. The radius is the largest one that the ray may meet: where tubes are thinner
// than a pixel they are drawn as wide as one. Thereby every segment near the ray is tested exactly once, and whatever
// later slabs hold begins behind the start of the next widened slab: hits before it can be blended.
//
// Hits wait in a small buffer, ordered by (entry, segment). Where it overflows, the ray
// remembers the first hit that did not fit, blends what comes before, and visits the slabs again for
// what is left: no hit is lost.
//
// A curve gives one layer for each stretch of the ray inside its tubes: hits come in order of entry,
// and one that begins before its curve's last exit only prolongs that stretch.
//
// Where the ray starts inside a tube (camera or clipping plane inside), the tube's far wall is seen:
// its layer is put off until the ray leaves the tube.
//
// The engine supplies what vtkVoxelLineFrame and vtkVoxelLineModel tell: GridDimensions,
// BrickDimensions, Radius, LargestRadius, ThinTubes, NarrowTubes, LitAsLines, HasRadii, SegmentWords, FaceBits, InteriorBins, IdExtension, Coloring,
// HasNaN, AmbientColor, DiffuseColor, Ambient, Diffuse, Opacity, Lighting, AllOpaque, Picking,
// EarlyTermination, NormalFromLocal, ViewFromLocal; the constants HitCapacity, ActiveCapacity,
// InsideCapacity and Beyond, a distance that no ray reaches; and
//   int fetchBrickGrid(int), uvec4 fetchBrick(int), uint fetchBrickFirstCurve(int),
//   uint fetchVoxelStart(uint), uint fetchSegmentWord(uint), uint fetchIdExtension(uint),
//   uint fetchBrickCurve(uint), Real fetchScalar(uint), vec4 fetchColor(uint), Real fetchRadius(uint),
//   vec4 fetchTable(int), int countBits(uint), int lowestBit(uint), Real exactValue(uint),
//   void beginRay(), void beginCandidates(uint, uint, vec3), uint nextCandidate(uint, uint): they leave
//   out segments of a voxel that the ray cannot hit, where an engine tells so faster than the traversal.

// The 4 by 4 voxels of a brick that lie in one slab, as bits u + 4 v of the occupancy mask.
uint sliceOfBrick(uvec4 record, int layer)
{
  if (AxisW == 2)
  {
    uint word = layer < 2 ? record.x : record.y;
    return (word >> uint(16 * (layer & 1))) & 0xffffu;
  }
  if (AxisW == 1)
  {
    uint low = (record.x >> uint(4 * layer)) & 0x000f000fu;
    uint high = (record.y >> uint(4 * layer)) & 0x000f000fu;
    return (low & 0xfu) | ((low >> 12u) & 0xf0u) | ((high & 0xfu) << 8u) | ((high >> 4u) & 0xf000u);
  }
  uint low = (record.x >> uint(layer)) & 0x11111111u;
  uint high = (record.y >> uint(layer)) & 0x11111111u;
  low = (low | (low >> 3u)) & 0x03030303u;
  high = (high | (high >> 3u)) & 0x03030303u;
  low = (low | (low >> 6u)) & 0x000f000fu;
  high = (high | (high >> 6u)) & 0x000f000fu;
  return ((low | (low >> 12u)) & 0xffu) | (((high | (high >> 12u)) & 0xffu) << 8u);
}

// Visits an occupied voxel of a slab, unless it lies too far from the ray.
void visitVoxel(int u, int v, int slab, int brick, uvec4 record)
{
  // A voxel farther from the ray than this, centre to line, holds nothing that reaches the ray.
  Real reach = RayRadius + Real(0.8661);
  ivec3 voxel = AxisW == 0 ? ivec3(slab, u, v) : (AxisW == 1 ? ivec3(u, slab, v) : ivec3(u, v, slab));
  Real t = middleOfSlab(slab);
  vec3 local = RayOrigin + RayDirection * t - vec3(voxel);
  vec3 toCenter = vec3(Real(0.5)) - local;
  Real along = dot(toCenter, RayDirection);
  if (dot(toCenter, toCenter) - along * along > reach * reach)
  {
    return;
  }
  uint bit = uint((voxel.x & 3) | ((voxel.y & 3) << 2) | ((voxel.z & 3) << 4));
  uint below = (bit < 32u ? record.x : record.y) & ((1u << (bit & 31u)) - 1u);
  uint rank = uint(countBits(below) + (bit < 32u ? 0 : countBits(record.x)));
  uint first = record.z + fetchVoxelStart(record.w + rank);
  uint end = record.z + fetchVoxelStart(record.w + rank + 1u);
  beginCandidates(first, end, local);
  for (uint segment = nextCandidate(first, end); segment < end;
       segment = nextCandidate(segment + 1u, end))
  {
    visitSegment(segment, brick, voxel, local, t);
  }
}

// Visits the voxels of a slab that lie within the radius of the ray's way over the widened slab.
// Returns whether any brick there holds segments.
bool visitSlab(int slab)
{
  // Truncation serves as floor for what lies in the grid: what lies before it becomes its first row.
  Real at = Real(slab);
  int uFirst = int(clamp(LowU + SlopeU * at, Real(0), Real(SizeU)));
  int uLast = int(clamp(HighU + SlopeU * at + Real(1), Real(0), Real(SizeU))) - 1;
  int vFirst = int(clamp(LowV + SlopeV * at, Real(0), Real(SizeV)));
  int vLast = int(clamp(HighV + SlopeV * at + Real(1), Real(0), Real(SizeV))) - 1;

  bool any = false;
  int cellW = (slab >> 2) * StrideW;
  for (int cellV = vFirst >> 2; cellV <= (vLast >> 2); ++cellV)
  {
    for (int cellU = uFirst >> 2; cellU <= (uLast >> 2); ++cellU)
    {
      int brick = fetchBrickGrid(cellU * StrideU + cellV * StrideV + cellW);
      if (brick < 0)
      {
        continue;
      }
      any = true;
      uvec4 record = fetchBrick(brick);
      uint occupied = sliceOfBrick(record, slab & 3);
      if (occupied == 0u)
      {
        continue;
      }
      // The part of the slab's way that lies in this brick, as bits u + 4 v.
      int uLow = max(uFirst - 4 * cellU, 0);
      int uHigh = min(uLast - 4 * cellU, 3);
      int vLow = max(vFirst - 4 * cellV, 0);
      int vHigh = min(vLast - 4 * cellV, 3);
      uint row = (2u << uint(uHigh)) - (1u << uint(uLow));
      uint rows = 0x1111u & ((16u << uint(4 * vHigh)) - (1u << uint(4 * vLow)));
      occupied = occupied & (row * rows);
      while (occupied != 0u)
      {
        uint rest = occupied & (occupied - 1u);
        int bit = lowestBit(occupied);
        occupied = rest;
        visitVoxel(4 * cellU + (bit & 3), 4 * cellV + (bit >> 2), slab, brick, record);
      }
    }
  }
  return any;
}

// Number of slabs in which u stays between the limits; it goes up or down, by one in perStep slabs.
Real countSlabsWithin(Real u, bool up, Real perStep, Real lowest, Real highest)
{
  return u < lowest || u > highest ? Real(0) : Real(1) + (up ? highest - u : u - lowest) * perStep;
}

// Number of slabs, from this one on, in which the widened ray meets only empty bricks: the brick
// grid tells how far the next brick is from the one in which the ray is in the slab's middle.
int countEmptySlabs(int slab, int way)
{
  Real u = BaseU + SlopeU * (Real(slab) + Real(0.5));
  Real v = BaseV + SlopeV * (Real(slab) + Real(0.5));
  int cellU = int(clamp(u, Real(0), Real(SizeU - 1))) >> 2;
  int cellV = int(clamp(v, Real(0), Real(SizeV - 1))) >> 2;
  int cellW = slab >> 2;
  int distance = -fetchBrickGrid(cellU * StrideU + cellV * StrideV + cellW * StrideW);
  if (distance <= 0)
  {
    return 0;
  }
  // The empty box around the cell; beyond the grid all is empty.
  int reach = 4 * (distance - 1);
  int low = 4 * cellU - reach;
  int high = 4 * cellU + 4 + reach;
  Real slabs = countSlabsWithin(u, (way > 0) == (SlopeU > Real(0)), PerU, low <= 0 ? -Beyond : Real(low) + ReachU,
    high >= SizeU ? Beyond : Real(high) - ReachU);
  low = 4 * cellV - reach;
  high = 4 * cellV + 4 + reach;
  slabs = min(slabs,
    countSlabsWithin(v, (way > 0) == (SlopeV > Real(0)), PerV, low <= 0 ? -Beyond : Real(low) + ReachV,
      high >= SizeV ? Beyond : Real(high) - ReachV));
  int count = way > 0 ? 4 * cellW + 4 + reach - slab : slab - 4 * cellW + reach + 1;
  return slabs < Real(count) ? int(slabs) : count;
}

// Chooses the axes of a ray and prepares what the slabs share.
void prepareSlabs()
{
  vec3 size = abs(RayDirection);
  AxisW = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  AxisU = AxisW == 0 ? 1 : 0;
  AxisV = AxisW == 2 ? 1 : 2;
  Real o = RayOrigin[AxisW];
  PerW = Real(1) / RayDirection[AxisW];
  SlopeU = RayDirection[AxisU] * PerW;
  SlopeV = RayDirection[AxisV] * PerW;
  PerU = Real(1) / max(abs(SlopeU), Real(1e-6));
  PerV = Real(1) / max(abs(SlopeV), Real(1e-6));
  BaseU = RayOrigin[AxisU] - o * SlopeU;
  BaseV = RayOrigin[AxisV] - o * SlopeV;
  LowU = BaseU + min(-RayRadius * SlopeU, (Real(1) + RayRadius) * SlopeU) - RayRadius;
  HighU = BaseU + max(-RayRadius * SlopeU, (Real(1) + RayRadius) * SlopeU) + RayRadius;
  LowV = BaseV + min(-RayRadius * SlopeV, (Real(1) + RayRadius) * SlopeV) - RayRadius;
  HighV = BaseV + max(-RayRadius * SlopeV, (Real(1) + RayRadius) * SlopeV) + RayRadius;
  ReachU = (Real(0.5) + RayRadius) * abs(SlopeU) + RayRadius;
  ReachV = (Real(0.5) + RayRadius) * abs(SlopeV) + RayRadius;
  SizeU = GridDimensions[AxisU];
  SizeV = GridDimensions[AxisV];
  ivec3 strides = ivec3(1, BrickDimensions.x, BrickDimensions.x * BrickDimensions.y);
  StrideU = strides[AxisU];
  StrideV = strides[AxisV];
  StrideW = strides[AxisW];
}

// Narrows an interval of the ray to the grid, widened by the radius.
void clipToGrid(LS_INOUT(Real) start, LS_INOUT(Real) end)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Real d = RayDirection[axis];
    Real o = RayOrigin[axis];
    Real size = Real(GridDimensions[axis]);
    if (abs(d) < Real(1e-9))
    {
      if (o < -RayRadius || o > size + RayRadius)
      {
        end = start - Real(1);
      }
      continue;
    }
    Real perUnit = Real(1) / d;
    Real t0 = (-RayRadius - o) * perUnit;
    Real t1 = (size + RayRadius - o) * perUnit;
    start = max(start, min(t0, t1));
    end = min(end, max(t0, t1));
  }
}

// The slab at a place along the major axis, or the one nearest to it.
int slabAt(Real w, int slabs)
{
  return int(clamp(w, Real(0), Real(slabs - 1)));
}

void castRay(vec3 origin, vec3 direction, Real start, Real end)
{
  RayOrigin = origin;
  RayDirection = direction;
  Real gridStart = start;
  Real gridEnd = end;
  RayRadius = LargestRadius;
  clipToGrid(gridStart, gridEnd);
  if (!(gridStart < gridEnd))
  {
    return;
  }
  if (ThinTubes)
  {
    RayRadius = max(Radius, max(halfPixelAt(gridStart), halfPixelAt(gridEnd)));
  }
  RayStart = start;
  RayEnd = end;
  RayLimit = end;
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
  int slabs = GridDimensions[AxisW];
  int way = direction[AxisW] > Real(0) ? 1 : -1;
  Real widening = Real(way) * RayRadius;
  Real atStart = origin[AxisW] + direction[AxisW] * gridStart - widening;
  Real atEnd = origin[AxisW] + direction[AxisW] * gridEnd + widening;
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
      : (Real(way > 0 ? slab : slab + 1) - widening - origin[AxisW]) * PerW;
    bool waiting = HitCount > 0 || InsideCount > 0;
    if (waiting && !blendHits(from))
    {
      Real back = origin[AxisW] + direction[AxisW] * OverflowEntry - widening;
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
    if (from > RayEnd)
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
    Shortening = AllOpaque && from >= RayStart;
    mayBeEmpty = !visitSlab(slab);
    slab += way;
  }
}
