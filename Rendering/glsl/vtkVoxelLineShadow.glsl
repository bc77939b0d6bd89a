// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much light other lines leave to a point of a line: of each light (shadows), and of all that
// comes from around (ambient occlusion). vtkLineGlobalIllumination tells the methods. Common subset
// of GLSL and C++ with GLM.
//
// The engine supplies Shadows and Occlusion (vtkLineGlobalIllumination's types); LocalLights[], a
// direction to the light (w = 0) or its position (w = 1), grid-local, or w = -1 for a light that
// casts no shadow; ConeSpread, ConeStart, OcclusionRadius, OcclusionSamples, OcclusionStrength; and
// Real fetchOcclusion(int), occlusion of voxels as vtkVoxelLineOcclusion tells.

// The point in question, grid-local: on the tube, its normal, and on the axis next to it.
vec3 ShadedPoint;
vec3 ShadedNormal;
vec3 ShadedAxis;

// Part of light i that arrives.
Real lightVisibility(int i)
{
  if (Shadows == 0)
  {
    return Real(1);
  }
  vec4 light = LocalLights[i];
  if (light.w < Real(0))
  {
    return Real(1);
  }
  vec3 way = vec3(light);
  Real distance = Beyond;
  if (light.w > Real(0))
  {
    way = way - ShadedAxis;
    distance = length(way);
    way = way / max(distance, Real(1e-6));
  }
  return exp(-coneDepth(ShadedAxis, way, ConeStart, distance, ConeSpread));
}

// Occlusion of what surrounds a position, interpolated between the voxels of bricks that hold lines.
Real sphericalOcclusion(vec3 position)
{
  vec3 x = position - vec3(Real(0.5));
  vec3 low = floor(x);
  vec3 part = x - low;
  ivec3 voxel = ivec3(low);
  Real sum = Real(0);
  Real weights = Real(0);
  for (int corner = 0; corner < 8; ++corner)
  {
    ivec3 side = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    ivec3 at = clamp(voxel + side, ivec3(0), GridDimensions - ivec3(1));
    int brick = brickGridAt(at);
    if (brick >= 0)
    {
      vec3 near = mix(vec3(Real(1)) - part, part, vec3(side));
      Real weight = near.x * near.y * near.z;
      weights += weight;
      sum += weight * fetchOcclusion(64 * brick + voxelInBrick(at));
    }
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

// Part of the hemisphere above the shaded point that lines fill.
Real hemisphereOcclusion()
{
  Real sum = Real(0);
  for (int i = 0; i < OcclusionSamples; ++i)
  {
    vec3 direction = hemisphereDirection(i, ShadedNormal);
    sum += Real(1) - exp(-coneDepth(ShadedPoint, direction, Real(0.5), OcclusionRadius, Real(0)));
  }
  return sum / Real(OcclusionSamples);
}

// What is left of all light at the shaded point.
Real ambientVisibility()
{
  if (Occlusion == 0)
  {
    return Real(1);
  }
  Real occlusion = Occlusion == 1 ? sphericalOcclusion(ShadedAxis) : hemisphereOcclusion();
  return pow(max(Real(1) - occlusion, Real(0)), OcclusionStrength);
}
