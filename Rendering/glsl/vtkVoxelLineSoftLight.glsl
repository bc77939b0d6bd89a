// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much light the densities of lines leave to a point: of each light (soft shadows), and of all
// that comes from around (ambient occlusion). vtkLineGlobalIllumination tells the methods. Common
// subset of GLSL and C++ with GLM.
//
// The engine supplies LocalLights[], a direction to the light (w = 0) or its position (w = 1),
// grid-local, or w = -1 for a light that casts no shadow; ConeSpread, ConeStart, OcclusionRadius,
// OcclusionSamples, OcclusionStrength; PlaneCount and Planes[], grid-local clipping planes; and
// Real fetchOcclusion(int), occlusion of voxels as vtkVoxelLineOcclusion tells.

// The point in question, grid-local: on the tube, its normal, and on the axis next to it.
vec3 ShadedPoint;
vec3 ShadedNormal;
vec3 ShadedAxis;

// How far a ray goes until a clipping plane cuts it off: what is clipped takes no light.
Real keptWay(vec3 origin, vec3 direction, Real end)
{
  for (int i = 0; i < PlaneCount; ++i)
  {
    Real towards = dot(vec3(Planes[i]), direction);
    Real height = dot(vec3(Planes[i]), origin) + Planes[i].w;
    end = towards < Real(0) ? min(end, max(height, Real(0)) / -towards) : end;
  }
  return end;
}

// Whether light i may be in shadow at a point; then the way to it and how far lines may be on it.
bool findLight(int i, vec3 point, LS_OUT(vec3) way, LS_OUT(Real) distance)
{
  vec4 light = LocalLights[i];
  way = vec3(light);
  distance = Beyond;
  if (light.w > Real(0))
  {
    way = way - point;
    distance = length(way);
    way = way / max(distance, Real(1e-6));
  }
  distance = keptWay(point, way, distance);
  return light.w >= Real(0);
}

// Part of light i that densities let through.
Real softVisibility(int i)
{
  vec3 way;
  Real distance;
  if (!findLight(i, ShadedAxis, way, distance))
  {
    return Real(1);
  }
  return exp(-coneDepth(ShadedAxis, way, ConeStart, distance, ConeSpread));
}

Real mixOcclusions(int first, vec3 part)
{
  Real o00 = mix(fetchOcclusion(first), fetchOcclusion(first + 1), part.x);
  Real o10 = mix(fetchOcclusion(first + 4), fetchOcclusion(first + 5), part.x);
  Real o01 = mix(fetchOcclusion(first + 16), fetchOcclusion(first + 17), part.x);
  Real o11 = mix(fetchOcclusion(first + 20), fetchOcclusion(first + 21), part.x);
  return mix(mix(o00, o10, part.y), mix(o01, o11, part.y), part.z);
}

// Occlusion of what surrounds a position, interpolated between the voxels of bricks that hold lines.
Real sphericalOcclusion(vec3 position)
{
  vec3 x = position - vec3(Real(0.5));
  vec3 low = floor(x);
  vec3 part = x - low;
  ivec3 voxel = ivec3(low);
  ivec3 last = GridDimensions - ivec3(1);
  if (min(min(voxel.x, voxel.y), voxel.z) >= 0 && max(max(voxel.x & 3, voxel.y & 3), voxel.z & 3) < 3 &&
    voxel.x <= last.x && voxel.y <= last.y && voxel.z <= last.z)
  {
    int brick = brickGridAt(voxel);
    return brick < 0 ? Real(0) : mixOcclusions(64 * brick + voxelInBrick(voxel), part);
  }
  // Both sides' share of the brick's cell and of the place in the brick, axis by axis.
  ivec3 low3 = clamp(voxel, ivec3(0), last);
  ivec3 high3 = clamp(voxel + ivec3(1), ivec3(0), last);
  ivec3 strides = ivec3(1, BrickDimensions.x, BrickDimensions.x * BrickDimensions.y);
  ivec3 lowCell = (low3 >> 2) * strides;
  ivec3 highCell = (high3 >> 2) * strides;
  ivec3 lowPlace = (low3 & 3) * ivec3(1, 4, 16);
  ivec3 highPlace = (high3 & 3) * ivec3(1, 4, 16);
  Real sum = Real(0);
  Real weights = Real(0);
  for (int corner = 0; corner < 4; ++corner)
  {
    bool highY = (corner & 1) != 0;
    bool highZ = (corner & 2) != 0;
    int cell = (highY ? highCell.y : lowCell.y) + (highZ ? highCell.z : lowCell.z);
    int place = (highY ? highPlace.y : lowPlace.y) + (highZ ? highPlace.z : lowPlace.z);
    Real weight = (highY ? part.y : Real(1) - part.y) * (highZ ? part.z : Real(1) - part.z);
    int brick = fetchBrickGrid(cell + lowCell.x);
    Real lowWeight = brick >= 0 ? weight * (Real(1) - part.x) : Real(0);
    sum += lowWeight * fetchOcclusion(64 * max(brick, 0) + place + lowPlace.x);
    brick = fetchBrickGrid(cell + highCell.x);
    Real highWeight = brick >= 0 ? weight * part.x : Real(0);
    sum += highWeight * fetchOcclusion(64 * max(brick, 0) + place + highPlace.x);
    weights += lowWeight + highWeight;
  }
  return weights > Real(0) ? sum / weights : Real(0);
}

// Direction number i of a spiral that covers the hemisphere about a normal evenly.
vec3 hemisphereDirection(int i, vec3 normal)
{
  Real up = Real(1) - (Real(i) + Real(0.5)) / Real(OcclusionSamples);
  Real side = sqrt(max(Real(0), Real(1) - up * up));
  Real angle = Real(2.39996323) * Real(i);
  vec3 other = abs(normal.x) < Real(0.6) ? vec3(Real(1), Real(0), Real(0)) : vec3(Real(0), Real(1), Real(0));
  vec3 u = normalize(cross(normal, other));
  vec3 v = cross(normal, u);
  return normal * up + u * (side * cos(angle)) + v * (side * sin(angle));
}

// Part of the light in a direction of the hemisphere that densities stop.
Real densityOcclusion(vec3 direction)
{
  Real end = keptWay(ShadedPoint, direction, OcclusionRadius);
  return Real(1) - exp(-coneDepth(ShadedPoint, direction, Real(0.5), end, Real(0)));
}

// What is left of all light where a part of the hemisphere is free.
Real dimmedLight(Real visible)
{
  if (OcclusionStrength == Real(1) || OcclusionStrength <= Real(0))
  {
    return OcclusionStrength > Real(0) ? visible : Real(1);
  }
  return visible > Real(0) ? pow(visible, OcclusionStrength) : Real(0);
}

// The same where lines stop a part of the light from the sphere, half of which a surface hides by
// itself.
Real dimmedByOcclusion(Real occlusion)
{
  return dimmedLight(min(Real(2) - Real(2) * occlusion, Real(1)));
}
