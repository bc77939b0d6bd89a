// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Takes a ray through the grid slab by slab, and in each slab to the voxels near it;
// vtkVoxelLineTraversal.glsl tells the method. Common subset of GLSL and C++ with GLM.

// The 4 by 4 voxels of a brick that lie in one slab, as bits u + 4 v of the occupancy mask.
uint sliceOfBrick(uvec4 record, int layer)
{
  if (Ray.AxisW == 2)
  {
    uint word = layer < 2 ? record.x : record.y;
    return (word >> uint(16 * (layer & 1))) & 0xffffu;
  }
  if (Ray.AxisW == 1)
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
  Real reach = Ray.Reach + Real(0.8661);
  ivec3 voxel = Ray.AxisW == 0 ? ivec3(slab, u, v) : (Ray.AxisW == 1 ? ivec3(u, slab, v) : ivec3(u, v, slab));
  Real t = middleOfSlab(slab);
  vec3 local = Ray.Origin + Ray.Direction * t - vec3(voxel);
  vec3 toCenter = vec3(Real(0.5)) - local;
  Real along = dot(toCenter, Ray.Direction);
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

// Visits the voxels of a slab that lie within reach of the ray's way over the widened slab.
// Returns whether any brick there holds segments.
bool visitSlab(int slab)
{
  // Truncation serves as floor for what lies in the grid: what lies before it becomes its first row.
  Real at = Real(slab);
  int uFirst = int(clamp(Ray.LowU + Ray.SlopeU * at, Real(0), Real(Ray.SizeU)));
  int uLast = int(clamp(Ray.HighU + Ray.SlopeU * at + Real(1), Real(0), Real(Ray.SizeU))) - 1;
  int vFirst = int(clamp(Ray.LowV + Ray.SlopeV * at, Real(0), Real(Ray.SizeV)));
  int vLast = int(clamp(Ray.HighV + Ray.SlopeV * at + Real(1), Real(0), Real(Ray.SizeV))) - 1;

  bool any = false;
  int cellW = (slab >> 2) * Ray.StrideW;
  for (int cellV = vFirst >> 2; cellV <= (vLast >> 2); ++cellV)
  {
    for (int cellU = uFirst >> 2; cellU <= (uLast >> 2); ++cellU)
    {
      int brick = fetchBrickGrid(cellU * Ray.StrideU + cellV * Ray.StrideV + cellW);
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
  Real u = Ray.BaseU + Ray.SlopeU * (Real(slab) + Real(0.5));
  Real v = Ray.BaseV + Ray.SlopeV * (Real(slab) + Real(0.5));
  int cellU = int(clamp(u, Real(0), Real(Ray.SizeU - 1))) >> 2;
  int cellV = int(clamp(v, Real(0), Real(Ray.SizeV - 1))) >> 2;
  int cellW = slab >> 2;
  int distance = -fetchBrickGrid(cellU * Ray.StrideU + cellV * Ray.StrideV + cellW * Ray.StrideW);
  if (distance <= 0)
  {
    return 0;
  }
  // The empty box around the cell; beyond the grid all is empty.
  int reach = 4 * (distance - 1);
  int low = 4 * cellU - reach;
  int high = 4 * cellU + 4 + reach;
  Real slabs = countSlabsWithin(u, (way > 0) == (Ray.SlopeU > Real(0)), Ray.PerU, low <= 0 ? -Beyond : Real(low) + Ray.ReachU,
    high >= Ray.SizeU ? Beyond : Real(high) - Ray.ReachU);
  low = 4 * cellV - reach;
  high = 4 * cellV + 4 + reach;
  slabs = min(slabs,
    countSlabsWithin(v, (way > 0) == (Ray.SlopeV > Real(0)), Ray.PerV, low <= 0 ? -Beyond : Real(low) + Ray.ReachV,
      high >= Ray.SizeV ? Beyond : Real(high) - Ray.ReachV));
  int count = way > 0 ? 4 * cellW + 4 + reach - slab : slab - 4 * cellW + reach + 1;
  return slabs < Real(count) ? int(slabs) : count;
}

// Chooses the axes of a ray and prepares what the slabs share.
void prepareSlabs()
{
  vec3 size = abs(Ray.Direction);
  Ray.AxisW = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  Ray.AxisU = Ray.AxisW == 0 ? 1 : 0;
  Ray.AxisV = Ray.AxisW == 2 ? 1 : 2;
  Real o = Ray.Origin[Ray.AxisW];
  Ray.PerW = Real(1) / Ray.Direction[Ray.AxisW];
  Ray.SlopeU = Ray.Direction[Ray.AxisU] * Ray.PerW;
  Ray.SlopeV = Ray.Direction[Ray.AxisV] * Ray.PerW;
  Ray.PerU = Real(1) / max(abs(Ray.SlopeU), Real(1e-6));
  Ray.PerV = Real(1) / max(abs(Ray.SlopeV), Real(1e-6));
  Ray.BaseU = Ray.Origin[Ray.AxisU] - o * Ray.SlopeU;
  Ray.BaseV = Ray.Origin[Ray.AxisV] - o * Ray.SlopeV;
  Ray.LowU = Ray.BaseU + min(-Ray.Reach * Ray.SlopeU, (Real(1) + Ray.Reach) * Ray.SlopeU) - Ray.Reach;
  Ray.HighU = Ray.BaseU + max(-Ray.Reach * Ray.SlopeU, (Real(1) + Ray.Reach) * Ray.SlopeU) + Ray.Reach;
  Ray.LowV = Ray.BaseV + min(-Ray.Reach * Ray.SlopeV, (Real(1) + Ray.Reach) * Ray.SlopeV) - Ray.Reach;
  Ray.HighV = Ray.BaseV + max(-Ray.Reach * Ray.SlopeV, (Real(1) + Ray.Reach) * Ray.SlopeV) + Ray.Reach;
  Ray.ReachU = (Real(0.5) + Ray.Reach) * abs(Ray.SlopeU) + Ray.Reach;
  Ray.ReachV = (Real(0.5) + Ray.Reach) * abs(Ray.SlopeV) + Ray.Reach;
  Ray.SizeU = GridDimensions[Ray.AxisU];
  Ray.SizeV = GridDimensions[Ray.AxisV];
  ivec3 strides = ivec3(1, BrickDimensions.x, BrickDimensions.x * BrickDimensions.y);
  Ray.StrideU = strides[Ray.AxisU];
  Ray.StrideV = strides[Ray.AxisV];
  Ray.StrideW = strides[Ray.AxisW];
}

// Narrows an interval of the ray to the grid, widened by Reach.
void clipToGrid(LS_INOUT(Real) start, LS_INOUT(Real) end)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Real d = Ray.Direction[axis];
    Real o = Ray.Origin[axis];
    Real size = Real(GridDimensions[axis]);
    if (abs(d) < Real(1e-9))
    {
      if (o < -Ray.Reach || o > size + Ray.Reach)
      {
        end = start - Real(1);
      }
      continue;
    }
    Real perUnit = Real(1) / d;
    Real t0 = (-Ray.Reach - o) * perUnit;
    Real t1 = (size + Ray.Reach - o) * perUnit;
    start = max(start, min(t0, t1));
    end = min(end, max(t0, t1));
  }
}

// The slab at a place along the major axis, or the one nearest to it.
int slabAt(Real w, int slabs)
{
  return int(clamp(w, Real(0), Real(slabs - 1)));
}
