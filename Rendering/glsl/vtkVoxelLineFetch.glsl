// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the traversal asks of an engine, for a fragment shader: settings as uniforms, the model
// in texture buffers. The tag below is replaced by the constants of the frame's kind, which define
// what there are textures for: see vtkVoxelLineFields.glsl.

#define Real float
#define LS_OUT(T) out T
#define LS_INOUT(T) inout T

const int HitCapacity = 16;
const int ActiveCapacity = 32;
const int InsideCapacity = 4;
const float Beyond = 1e30;

//LineSets::Constants

uniform vec2 PictureSize;
uniform vec3 RayOrigins[3];
uniform vec3 RayDirections[3];
uniform vec2 HalfPixel;
uniform float NearestS;
uniform float FarthestS;
uniform vec2 DepthZ;
uniform vec2 DepthW;
uniform vec4 Planes[MaximumPlanes];
uniform vec4 RegionPlanes[MaximumRegionPlanes];
uniform vec3 GridSize;
uniform vec3 BrickGridSize;
uniform float Radius;
uniform float LargestRadius;
uniform vec3 AmbientColor;
uniform vec3 DiffuseColor;
uniform vec3 SpecularColor;
uniform float Ambient;
uniform float Diffuse;
uniform float SpecularPower;
uniform float Opacity;
uniform float EarlyTermination;
uniform float AccelerationOpacity;
uniform mat4 ViewFromLocal;
uniform mat3 NormalFromLocal;

uniform isamplerBuffer BrickGrid;
uniform usamplerBuffer Bricks;
uniform usamplerBuffer VoxelStarts;
uniform usamplerBuffer Segments;
uniform usamplerBuffer CurveIdExtension;
uniform usamplerBuffer BrickCurves;
uniform samplerBuffer Attributes;
uniform samplerBuffer Radii;
uniform samplerBuffer ColorTable;
#ifdef LineSetsHasScene
uniform sampler2D SceneDepth;
#endif

// Shadows and ambient occlusion.
uniform vec4 LocalLights[MaximumLights];
uniform float ConeSpread;
uniform float ConeStart;
uniform float OcclusionRadius;
uniform int OcclusionSamples;
uniform float OcclusionStrength;
uniform float Extinction;

// The model of a level; where there is none, its samplers are those of the model.
#ifdef LineSetsHasLevel
uniform vec3 LevelGridSize;
uniform vec3 LevelBrickGridSize;
uniform float LevelScale;
uniform isamplerBuffer LevelBrickGrid;
uniform usamplerBuffer LevelBricks;
uniform usamplerBuffer LevelVoxelStarts;
uniform usamplerBuffer LevelSegments;
uniform samplerBuffer LevelAttributes;
uniform samplerBuffer LevelRadii;
#else
const vec3 LevelGridSize = vec3(0.0);
const vec3 LevelBrickGridSize = vec3(0.0);
const float LevelScale = 1.0;
#define LevelBrickGrid BrickGrid
#define LevelBricks Bricks
#define LevelVoxelStarts VoxelStarts
#define LevelSegments Segments
#define LevelAttributes Attributes
#define LevelRadii Radii
#endif

// Of the model that is fetched from.
ivec3 GridDimensions;
ivec3 BrickDimensions;
bool OnLevel = false;

void beginModel()
{
  OnLevel = false;
  GridDimensions = ivec3(GridSize + vec3(0.5));
  BrickDimensions = ivec3(BrickGridSize + vec3(0.5));
}

void beginLevel()
{
  OnLevel = true;
  GridDimensions = ivec3(LevelGridSize + vec3(0.5));
  BrickDimensions = ivec3(LevelBrickGridSize + vec3(0.5));
}

void endLevel()
{
  beginModel();
}

int fetchBrickGrid(int cell)
{
  if (LevelRays && OnLevel)
  {
    return texelFetch(LevelBrickGrid, cell).r;
  }
  return texelFetch(BrickGrid, cell).r;
}

uvec4 fetchBrick(int brick)
{
  int i = 5 * brick;
  if (LevelRays && OnLevel)
  {
    return uvec4(texelFetch(LevelBricks, i).r, texelFetch(LevelBricks, i + 1).r,
      texelFetch(LevelBricks, i + 2).r, texelFetch(LevelBricks, i + 3).r);
  }
  return uvec4(texelFetch(Bricks, i).r, texelFetch(Bricks, i + 1).r, texelFetch(Bricks, i + 2).r,
    texelFetch(Bricks, i + 3).r);
}

uint fetchBrickFirstCurve(int brick)
{
  return texelFetch(Bricks, 5 * brick + 4).r;
}

uint fetchVoxelStart(uint i)
{
  if (LevelRays && OnLevel)
  {
    return texelFetch(LevelVoxelStarts, int(i)).r;
  }
  return texelFetch(VoxelStarts, int(i)).r;
}

uint fetchSegmentWord(uint i)
{
  if (LevelRays && OnLevel)
  {
    return texelFetch(LevelSegments, int(i)).r;
  }
  return texelFetch(Segments, int(i)).r;
}

uint fetchIdExtension(uint i)
{
  return texelFetch(CurveIdExtension, int(i)).r;
}

uint fetchBrickCurve(uint i)
{
  return texelFetch(BrickCurves, int(i)).r;
}

vec4 fetchColor(uint i)
{
  if (LevelRays && OnLevel)
  {
    return texelFetch(LevelAttributes, int(i));
  }
  return texelFetch(Attributes, int(i));
}

// Attributes are normalized bytes.
float fetchScalar(uint i)
{
  return floor(fetchColor(i).r * 255.0 + 0.5);
}

float fetchRadius(uint i)
{
  if (LevelRays && OnLevel)
  {
    return texelFetch(LevelRadii, int(i)).r;
  }
  return texelFetch(Radii, int(i)).r;
}

vec4 fetchTable(int i)
{
  return texelFetch(ColorTable, i);
}

// OpenGL 3.2 has no bitCount(), findLSB() and uintBitsToFloat().
int countBits(uint word)
{
  word = word - ((word >> 1u) & 0x55555555u);
  word = (word & 0x33333333u) + ((word >> 2u) & 0x33333333u);
  return int((((word + (word >> 4u)) & 0x0f0f0f0fu) * 0x01010101u) >> 24u);
}

// Index of the lowest bit that is set.
int lowestBit(uint word)
{
  return countBits((word ^ (word - 1u)) >> 1u);
}

// The number that the bits of a 32-bit float mean; coordinates in [0,1], never infinite or NaN.
float exactValue(uint word)
{
  uint exponent = (word >> 23u) & 255u;
  if (exponent == 0u)
  {
    return 0.0;
  }
  float mantissa = float((word & 0x7fffffu) | 0x800000u);
  return mantissa * exp2(float(int(exponent) - 150));
}

// The traversal intersects every segment: there is nothing faster to leave them out by.
void beginRay()
{
}

void putRayAside()
{
}

void bringRayBack()
{
}

void beginCandidates(uint first, uint end, vec3 local)
{
}

uint nextCandidate(uint segment, uint end)
{
  return segment;
}
