// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much light lines leave to a point of something that another mapper draws. Unlike the lines
// themselves it may lie anywhere.
//
// Beside vtkVoxelLineReceiverFetch.glsl there are Shadows and Occlusion, vtkLineGlobalIllumination's
// types, soft shadows or none.

// Whether the parts of the lights at the point are known; they are looked up where they are first
// asked for.
bool HasReceived = false;
float ReceivedParts[ReceivedLights];

// The point that is asked about, grid-local, and the normal of its surface: a null vector where it
// has none, as on lines.
//
// Surfaces are looked up below the surface, as lines are on their axis: around the lines that cast
// the shadows, tubes of the same radius are lit as the ray caster's.
void receiveAt(vec3 position, vec3 normal)
{
  GridDimensions = ivec3(GridSize + vec3(0.5));
  BrickDimensions = ivec3(BrickGridSize + vec3(0.5));
  ShadedPoint = position;
  ShadedNormal = normal;
  ShadedAxis = position - normal * SurfaceDepth;
}

// The same in view coordinates. Normals are mapped as such, by the inverse transpose.
void receiveInView(vec3 position, vec3 normal)
{
  float size = length(normal);
  vec3 local = size > 0.0 ? normalize(LocalNormalFromView * normal) : vec3(0.0);
  receiveAt((LocalFromView * vec4(position, 1.0)).xyz, local);
}

// Part of light i that arrives.
float receivedPart(int i)
{
  if (Shadows == 0)
  {
    return 1.0;
  }
  // No light is seen on the side that faces away.
  vec3 way;
  float distance;
  bool mayBeDark = findLight(i, ShadedAxis, way, distance);
  return mayBeDark && (ShadedNormal == vec3(0.0) || dot(ShadedNormal, way) > 0.0) ? softVisibility(i)
                                                                                : 1.0;
}

void receiveLights()
{
  if (!HasReceived)
  {
    HasReceived = true;
    for (int i = 0; i < ReceivedLights; ++i)
    {
      ReceivedParts[i] = receivedPart(i);
    }
  }
}

// Part of all light that arrives, for what VTK draws without light, and reflects all alike.
float receivedMean()
{
  if (Shadows == 0)
  {
    return 1.0;
  }
  float sum = 0.0;
  for (int i = 0; i < ReceivedLights; ++i)
  {
    sum += LightWeights[i] * receivedPart(i);
  }
  return sum;
}

// Whether a voxel of the grid holds lines.
bool holdsLines(ivec3 voxel)
{
  if (min(min(voxel.x, voxel.y), voxel.z) < 0 || voxel.x >= GridDimensions.x ||
    voxel.y >= GridDimensions.y || voxel.z >= GridDimensions.z)
  {
    return false;
  }
  int brick = brickGridAt(voxel);
  return brick >= 0 && fetchDensity(0, 64 * brick + voxelInBrick(voxel)) > 0.0;
}

// How near a position is to voxels with lines: 1 in such a voxel, 0 from a voxel away on. Other
// voxels' occlusion is no more than that of a neighbour, which shows on surfaces.
float isAmongLines(vec3 position)
{
  vec3 low = floor(position - vec3(0.5));
  vec3 part = position - vec3(0.5) - low;
  float sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    ivec3 side = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    vec3 weight = mix(vec3(1.0) - part, part, vec3(side));
    sum += holdsLines(ivec3(low) + side) ? weight.x * weight.y * weight.z : 0.0;
  }
  // A position in a voxel has at least an eighth of its weight.
  return min(8.0 * sum, 1.0);
}

// Occlusion where there is none to be looked up: by cones in the directions of those that
// vtkVoxelLineOcclusion follows, along the axes and the diagonals. Those take the densities of
// whole voxels; these interpolate them, and have a spread of their own.
float coneOcclusion(vec3 position)
{
  if (emptyReach(position) >= OcclusionRadius)
  {
    return 0.0;
  }
  float light = 0.0;
  for (int i = 0; i < 14; ++i)
  {
    bool onAxis = i < 6;
    vec3 direction = vec3((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    vec3 axis = vec3(i < 2 ? 1.0 : 0.0, i >= 2 && i < 4 ? 1.0 : 0.0, i >= 4 ? 1.0 : 0.0);
    direction = onAxis ? axis * ((i & 1) != 0 ? 1.0 : -1.0) : direction * 0.57735027;
    // Weights of Lebedev's rule; a spread with which levels follow as they do there.
    light += (onAxis ? 1.0 / 15.0 : 3.0 / 40.0) * exp(-coneDepth(position, direction, 0.0, OcclusionRadius, 0.5));
  }
  return 1.0 - light;
}

// Part of all light that is left by what surrounds the point.
float receivedAmbient()
{
  if (Occlusion == 0)
  {
    return 1.0;
  }
  if (Occlusion == 1)
  {
    float known = isAmongLines(ShadedAxis);
    float occlusion = known > 0.0 ? sphericalOcclusion(ShadedAxis) : 0.0;
    return dimmedByOcclusion(
      known < 1.0 ? mix(coneOcclusion(ShadedAxis), occlusion, known) : occlusion);
  }
  float sum = 0.0;
  for (int i = 0; i < OcclusionSamples; ++i)
  {
    sum += densityOcclusion(hemisphereDirection(i, ShadedNormal));
  }
  return dimmedLight(1.0 - sum / float(OcclusionSamples));
}
