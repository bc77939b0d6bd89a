// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkVoxelLineDensity.glsl, vtkVoxelLineSoftLight.glsl and vtkVoxelLineReceiver.glsl ask for, in
// shaders of other mappers. Constants come before, from vtkVoxelLineReceiverShader.

const float Beyond = 1e30;
// Clipping planes of the lines are not looked at.
const int PlaneCount = 0;
const vec4 Planes[1] = vec4[1](vec4(0.0));

uniform vec3 GridSize;
uniform vec3 BrickGridSize;
uniform vec4 LocalLights[ReceivedLights];
uniform float LightWeights[ReceivedLights];
uniform float ConeSpread;
uniform float ConeStart;
uniform float SurfaceDepth;
uniform float OcclusionRadius;
uniform int OcclusionSamples;
uniform float OcclusionStrength;
uniform float Extinction;
uniform isamplerBuffer BrickGrid;
uniform mat4 LocalFromView;
uniform mat3 LocalNormalFromView;

ivec3 GridDimensions;
ivec3 BrickDimensions;

int fetchBrickGrid(int cell)
{
  return texelFetch(BrickGrid, cell).r;
}
