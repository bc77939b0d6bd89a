// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much light the densities of the lines stop along a way, as vtkVoxelLineDensities tells them:
// level 0 by bricks, the others dense. Positions are grid-local. Common subset of GLSL and C++ with
// GLM.
//
// The engine supplies GridDimensions and BrickDimensions of the model, fetchBrickGrid(int),
// Real fetchDensity(int level, int i), DensityLevels, and Extinction, by which a density is
// multiplied to give the optical depth per voxel.

// Beyond this optical depth less than 1 % of the light is left.
const Real DarkDepth = Real(4.6);

ivec3 levelSize(int level)
{
  return ((GridDimensions - ivec3(1)) >> level) + ivec3(1);
}

// Entry of BrickGrid for a voxel inside the grid.
int brickGridAt(ivec3 voxel)
{
  return fetchBrickGrid(
    (voxel.x >> 2) + BrickDimensions.x * ((voxel.y >> 2) + BrickDimensions.y * (voxel.z >> 2)));
}

int voxelInBrick(ivec3 voxel)
{
  return (voxel.x & 3) | ((voxel.y & 3) << 2) | ((voxel.z & 3) << 4);
}

// The density between the centres of eight voxels, of which first has the lowest index and the others
// follow by the strides.
Real mixDensities(int level, int first, int strideY, int strideZ, vec3 part)
{
  Real d00 = mix(fetchDensity(level, first), fetchDensity(level, first + 1), part.x);
  Real d10 = mix(fetchDensity(level, first + strideY), fetchDensity(level, first + strideY + 1), part.x);
  first += strideZ;
  Real d01 = mix(fetchDensity(level, first), fetchDensity(level, first + 1), part.x);
  Real d11 = mix(fetchDensity(level, first + strideY), fetchDensity(level, first + strideY + 1), part.x);
  return mix(mix(d00, d10, part.y), mix(d01, d11, part.y), part.z);
}

// The same where some voxels may lie in other bricks, of level 0, or outside the grid, where there is
// nothing: voxel has the lowest index along each axis.
Real mixSeparateDensities(int level, ivec3 voxel, ivec3 size, vec3 part, bool inside)
{
  ivec3 last = size - ivec3(1);
  ivec3 low = clamp(voxel, ivec3(0), last);
  ivec3 high = clamp(voxel + ivec3(1), ivec3(0), last);
  vec3 lowWeight = vec3(Real(1)) - part;
  vec3 highWeight = part;
  if (!inside)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lowWeight[axis] = low[axis] == voxel[axis] ? lowWeight[axis] : Real(0);
      highWeight[axis] = high[axis] == voxel[axis] + 1 ? highWeight[axis] : Real(0);
    }
  }
  // Both sides' share of the brick's cell and of the place in it, axis by axis; without bricks of
  // the place alone.
  ivec3 cells = ivec3(1, BrickDimensions.x, BrickDimensions.x * BrickDimensions.y);
  ivec3 places = level == 0 ? ivec3(1, 4, 16) : ivec3(1, size.x, size.x * size.y);
  ivec3 lowCell = (low >> 2) * cells;
  ivec3 highCell = (high >> 2) * cells;
  ivec3 lowPlace = (level == 0 ? low & 3 : low) * places;
  ivec3 highPlace = (level == 0 ? high & 3 : high) * places;
  Real sum = Real(0);
  for (int corner = 0; corner < 4; ++corner)
  {
    bool highY = (corner & 1) != 0;
    bool highZ = (corner & 2) != 0;
    int cell = (highY ? highCell.y : lowCell.y) + (highZ ? highCell.z : lowCell.z);
    int place = (highY ? highPlace.y : lowPlace.y) + (highZ ? highPlace.z : lowPlace.z);
    Real weight = (highY ? highWeight.y : lowWeight.y) * (highZ ? highWeight.z : lowWeight.z);
    int lowBrick = level == 0 ? fetchBrickGrid(cell + lowCell.x) : 0;
    int highBrick = highCell.x == lowCell.x || level > 0 ? lowBrick : fetchBrickGrid(cell + highCell.x);
    Real row = Real(0);
    if (lowBrick >= 0)
    {
      row = lowWeight.x * fetchDensity(level, 64 * lowBrick + place + lowPlace.x);
    }
    if (highBrick >= 0)
    {
      row += highWeight.x * fetchDensity(level, 64 * highBrick + place + highPlace.x);
    }
    sum += weight * row;
  }
  return sum;
}

// Density between the centres of a level's voxels, interpolated trilinearly; x in voxels of the level.
Real densityAt(vec3 x, int level, ivec3 size)
{
  x -= vec3(Real(0.5));
  vec3 low = floor(x);
  vec3 part = x - low;
  ivec3 voxel = ivec3(low);
  bool inside = min(min(voxel.x, voxel.y), voxel.z) >= 0 && voxel.x + 1 < size.x && voxel.y + 1 < size.y &&
    voxel.z + 1 < size.z;
  if (inside && level > 0)
  {
    return mixDensities(
      level, voxel.x + size.x * (voxel.y + size.y * voxel.z), size.x, size.x * size.y, part);
  }
  if (inside && max(max(voxel.x & 3, voxel.y & 3), voxel.z & 3) < 3)
  {
    int brick = brickGridAt(voxel);
    return brick < 0 ? Real(0) : mixDensities(0, 64 * brick + voxelInBrick(voxel), 4, 16, part);
  }
  return mixSeparateDensities(level, voxel, size, part, inside);
}

// How far around a position all bricks are empty, in voxels; 0 near the grid's border and outside.
Real emptyReach(vec3 position)
{
  ivec3 voxel = ivec3(floor(position));
  if (min(min(voxel.x, voxel.y), voxel.z) < 0 || voxel.x >= GridDimensions.x ||
    voxel.y >= GridDimensions.y || voxel.z >= GridDimensions.z)
  {
    return Real(0);
  }
  return Real(4 * max(-brickGridAt(voxel) - 1, 0));
}

// Where a ray enters and leaves the grid, grown by a voxel; enter is beyond leave where it misses it.
void crossGrid(vec3 origin, vec3 direction, LS_OUT(Real) enter, LS_OUT(Real) leave)
{
  enter = Real(0);
  leave = Beyond;
  for (int axis = 0; axis < 3; ++axis)
  {
    Real high = Real(GridDimensions[axis]) + Real(1);
    if (abs(direction[axis]) > Real(1e-6))
    {
      Real perUnit = Real(1) / direction[axis];
      Real t0 = (-Real(1) - origin[axis]) * perUnit;
      Real t1 = (high - origin[axis]) * perUnit;
      enter = max(enter, min(t0, t1));
      leave = min(leave, max(t0, t1));
    }
    else if (origin[axis] < -Real(1) || origin[axis] > high)
    {
      leave = -Real(1);
    }
  }
}

// Optical depth of the lines from start to end of a cone. It is a voxel wide, and spread times its
// length. Each step is as long as a voxel of the level whose voxels are about as wide as the cone is
// there. Interpolated densities reach out by one and a half voxels: no level is taken so near to the
// start that lines behind it would count.
Real coneDepth(vec3 origin, vec3 direction, Real start, Real end, Real spread)
{
  Real limit = DarkDepth / max(Extinction, Real(1e-20));
  Real enter;
  Real leave;
  crossGrid(origin, direction, enter, leave);
  Real last = min(end, leave);
  Real depth = Real(0);
  Real t = max(start, enter);
  int level = 0;
  ivec3 size = GridDimensions;
  Real edge = Real(1);
  Real perEdge = Real(1);
  bool mayBeEmpty = true;
  while (t < last && depth < limit)
  {
    while (level + 1 < DensityLevels && Real(1) + spread * t >= Real(2) * edge && t >= Real(3) * edge)
    {
      level = level + 1;
      size = levelSize(level);
      edge = edge * Real(2);
      perEdge = perEdge * Real(0.5);
    }
    Real way = min(edge, last - t);
    vec3 position = origin + direction * (t + Real(0.5) * way);
    if (mayBeEmpty)
    {
      // Whole steps, so that all samples behind stay where they are.
      Real skipped = floor(emptyReach(position) * perEdge - Real(1));
      if (skipped >= Real(1))
      {
        t += edge * skipped;
        continue;
      }
    }
    Real density = densityAt(position * perEdge, level, size);
    mayBeEmpty = density <= Real(0);
    if (level + 1 == DensityLevels)
    {
      // Of a cone that is wider than all lines together they fill a part only.
      Real part = edge / (Real(1) + spread * t);
      density *= min(part * part, Real(1));
    }
    depth += density * way;
    t += way;
  }
  return depth * Extinction;
}
