// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineNativeEngine.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLineIllumination.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineCandidates.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineOcclusion.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace
{
using namespace glm;

// Edge length of the tiles that threads take, in pixels.
constexpr int TileSize = 16;

/// The arrays of a model, as the traversal fetches from them.
struct ModelView
{
  const std::int32_t* BrickGrid = nullptr;
  const std::uint32_t* Bricks = nullptr;
  const std::uint16_t* ShortStarts = nullptr;
  const std::uint32_t* LongStarts = nullptr;
  const std::uint32_t* Segments = nullptr;
  const void* IdExtension = nullptr;
  int IdExtensionSize = 0;
  const std::uint32_t* BrickCurves = nullptr;
  const std::uint8_t* Attributes = nullptr;
  const std::uint8_t* Radii = nullptr;
};

template <typename T>
const T* Pointer(vtkDataArray* array)
{
  return array ? static_cast<const T*>(array->GetVoidPointer(0)) : nullptr;
}

ModelView ViewModel(vtkVoxelLineModel* model)
{
  ModelView view;
  view.BrickGrid = Pointer<std::int32_t>(model->GetBrickGrid());
  view.Bricks = Pointer<std::uint32_t>(model->GetBricks());
  if (model->GetVoxelStarts()->GetDataTypeSize() == 2)
  {
    view.ShortStarts = Pointer<std::uint16_t>(model->GetVoxelStarts());
  }
  else
  {
    view.LongStarts = Pointer<std::uint32_t>(model->GetVoxelStarts());
  }
  view.Segments = Pointer<std::uint32_t>(model->GetSegments());
  if (vtkDataArray* extension = model->GetCurveIdExtension())
  {
    view.IdExtension = extension->GetVoidPointer(0);
    view.IdExtensionSize = extension->GetDataTypeSize();
  }
  view.BrickCurves = Pointer<std::uint32_t>(model->GetBrickCurves());
  view.Attributes = Pointer<std::uint8_t>(model->GetAttributes());
  view.Radii = Pointer<std::uint8_t>(model->GetRadii());
  return view;
}

vtkVoxelLineCandidateTest ChooseCandidateTest(const char*& name)
{
#if defined(LINESETS_HAVE_AVX512)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
  {
    name = "AVX-512";
    return vtkVoxelLineCandidatesAVX512;
  }
#endif
#if defined(LINESETS_HAVE_AVX2)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
  {
    name = "AVX2";
    return vtkVoxelLineCandidatesAVX2;
  }
#endif
  name = "generic";
  return vtkVoxelLineCandidatesGeneric;
}

#define LS_OUT(T) T&
#define LS_INOUT(T) T&

/**
 * The traversal with all that it asks for. One caster casts one ray after another; threads have
 * their own.
 */
struct RayCaster
{
  using Real = float;
  using uint = std::uint32_t;
  using vec2 = glm::vec2;
  using vec3 = glm::vec3;
  using vec4 = glm::vec4;
  using ivec3 = glm::ivec3;
  using uvec4 = glm::uvec4;
  using mat3 = glm::mat3;
  using mat4 = glm::mat4;

  static constexpr int HitCapacity = 64;
  static constexpr int ActiveCapacity = 256;
  static constexpr int InsideCapacity = 32;
  static constexpr Real Beyond = 1e30f;

  RayCaster(
    vtkVoxelLineModel* source, const vtkVoxelLineFrame& settings, vtkVoxelLineModel* levelSource)
    : Model(ViewModel(source))
    , Frame(settings)
    , RayOrigins(settings.Origin)
    , RayDirections(settings.Direction)
    , HalfPixel(settings.HalfPixel)
    , NearestS(settings.NearestS)
    , FarthestS(settings.FarthestS)
    , DepthZ(settings.DepthZ)
    , DepthW(settings.DepthW)
    , PlaneCount(static_cast<int>(settings.ClippingPlanes.size()))
    , Planes(settings.ClippingPlanes.data())
    , RegionPlaneCount(static_cast<int>(settings.RegionPlanes.size()))
    , RegionPlanes(settings.RegionPlanes.data())
    , Radius(settings.Radius)
    , LargestRadius(settings.ThinTubes ? settings.LargestRadius : settings.Radius)
    , Interactive(settings.Interactive)
    , ThinTubes(settings.ThinTubes)
    , NarrowTubes(settings.NarrowTubes)
    , LitAsLines(settings.LitAsLines)
    , HasRadii(source->GetRadii() != nullptr)
    , SegmentWords(source->GetSegmentWords())
    , InteriorBins(source->GetInteriorBins())
    , IdExtension(source->GetCurveIdExtension() != nullptr)
    , Coloring(settings.Coloring)
    , HasNaN(settings.HasNaN)
    , Lighting(settings.Lighting && !settings.Picking)
    , Picking(settings.Picking)
    , AmbientColor(settings.AmbientColor)
    , DiffuseColor(settings.DiffuseColor)
    , SpecularColor(settings.SpecularColor * settings.Specular)
    , Ambient(settings.Ambient)
    , Diffuse(settings.Diffuse)
    , SpecularPower(settings.Light.SpecularPower)
    , Opacity(settings.Opacity)
    , AllOpaque(settings.IsOpaque())
    , OpacityByPathLength(settings.OpacityByPathLength && !settings.IsOpaque())
    , EarlyTermination(settings.EarlyTermination)
    , Accelerating(settings.IsAccelerated() && settings.Global.Densities)
    , AccelerationOpacity(settings.AccelerationOpacity)
    , ViewFromLocal(settings.ViewFromLocal)
    , NormalFromLocal(settings.NormalFromLocal)
    , ParallelView(settings.Light.ParallelView)
    , MaximumReflection(settings.Light.Model == vtkLineIllumination::MaximumReflection)
    , HalfwayReflection(settings.Light.Reflection == vtkLineIllumination::Blinn)
    , StretchRange(settings.Light.StretchDynamicRange)
    , PowerMeans(settings.Light.Table.get())
    , TabulatedMeans(settings.Light.Table != nullptr)
    , LightCount(static_cast<int>(settings.Light.Lights.size()))
    , Shadows(settings.Global.Shadows)
    , Occlusion(settings.Global.Occlusion)
    , LocalLights(settings.Global.Lights.data())
    , ConeSpread(settings.Global.ConeSpread)
    , ConeStart(settings.Global.ConeStart)
    , OcclusionRadius(settings.Global.OcclusionRadius)
    , OcclusionSamples(settings.Global.OcclusionSamples)
    , OcclusionStrength(settings.Global.OcclusionStrength)
    , Extinction(settings.Global.Extinction)
    , SecondaryRays(settings.SecondaryRays || settings.LevelRays)
    , LevelRays(settings.LevelRays && levelSource && levelSource->GetNumberOfSegments() > 0)
    , LevelScale(std::ldexp(1.0f, -settings.ShadowLevel))
  {
    if (vtkVoxelLineDensities* densities = settings.Global.Densities)
    {
      this->DensityLevels = densities->GetNumberOfLevels();
      for (int level = 0; level < this->DensityLevels; ++level)
      {
        this->DensityValues.push_back(densities->GetValues(level)->GetPointer(0));
      }
    }
    if (settings.Global.SphericalOcclusion)
    {
      this->OcclusionValues = settings.Global.SphericalOcclusion->GetValues().data();
    }
    if (this->LevelRays)
    {
      this->OtherModel = ViewModel(levelSource);
      levelSource->GetDimensions(&this->OtherGridDimensions[0]);
      levelSource->GetBrickDimensions(&this->OtherBrickDimensions[0]);
    }
    source->GetDimensions(&this->GridDimensions[0]);
    source->GetBrickDimensions(&this->BrickDimensions[0]);
    while ((1 << this->FaceBits) < source->GetFaceBins())
    {
      ++this->FaceBits;
    }
    for (const vtkLineSetsLight& light : settings.Light.Lights)
    {
      this->LightKind.push_back(light.Kind);
      this->LightDirection.push_back(light.Direction);
      this->LightPosition.push_back(light.Position);
      this->LightColor.push_back(light.Color);
      this->LightAttenuation.push_back(light.Attenuation);
      this->LightSpot.emplace_back(light.CosConeAngle, light.Exponent);
    }
    const char* name;
    this->CandidateTest = ChooseCandidateTest(name);
  }

  // --- What the traversal fetches ---

  int fetchBrickGrid(int cell) const { return this->Model.BrickGrid[cell]; }
  uvec4 fetchBrick(int brick) const
  {
    const std::uint32_t* record = this->Model.Bricks + 5 * static_cast<std::size_t>(brick);
    return uvec4(record[0], record[1], record[2], record[3]);
  }
  uint fetchBrickFirstCurve(int brick) const
  {
    return this->Model.Bricks[5 * static_cast<std::size_t>(brick) + 4];
  }
  uint fetchVoxelStart(uint i) const
  {
    return this->Model.ShortStarts ? this->Model.ShortStarts[i] : this->Model.LongStarts[i];
  }
  uint fetchSegmentWord(uint i) const { return this->Model.Segments[i]; }
  uint fetchIdExtension(uint i) const
  {
    switch (this->Model.IdExtensionSize)
    {
      case 1:
        return static_cast<const std::uint8_t*>(this->Model.IdExtension)[i];
      case 2:
        return static_cast<const std::uint16_t*>(this->Model.IdExtension)[i];
      default:
        return static_cast<const std::uint32_t*>(this->Model.IdExtension)[i];
    }
  }
  uint fetchBrickCurve(uint i) const { return this->Model.BrickCurves[i]; }
  Real fetchScalar(uint i) const { return this->Model.Attributes[i]; }
  vec4 fetchColor(uint i) const
  {
    const std::uint8_t* c = this->Model.Attributes + 4 * static_cast<std::size_t>(i);
    return vec4(c[0], c[1], c[2], c[3]) * (1.0f / 255.0f);
  }
  Real fetchRadius(uint i) const { return this->Model.Radii[i] * (1.0f / 255.0f); }
  Real fetchDensity(int level, int i) const { return this->DensityValues[level][i]; }
  Real fetchOcclusion(int i) const { return this->OcclusionValues[i] * (1.0f / 255.0f); }
  Real fetchPowerMean(Real x, Real row) const { return this->PowerMeans->Interpolate(x, row); }
  vec4 fetchTable(int i) const { return this->Frame.ColorTable[i]; }
  static int countBits(uint word)
  {
    word = word - ((word >> 1u) & 0x55555555u);
    word = (word & 0x33333333u) + ((word >> 2u) & 0x33333333u);
    return static_cast<int>((((word + (word >> 4u)) & 0x0f0f0f0fu) * 0x01010101u) >> 24u);
  }
  static int lowestBit(uint word) { return static_cast<int>(LowestBit(word)); }
  static Real exactValue(uint word)
  {
    float value;
    std::memcpy(&value, &word, sizeof(value));
    return value;
  }

  // --- The model of a level takes the place of the model for a while ---

  void beginLevel() { this->exchangeModels(true); }
  void endLevel() { this->exchangeModels(false); }
  void exchangeModels(bool onLevel)
  {
    std::swap(this->Model, this->OtherModel);
    std::swap(this->GridDimensions, this->OtherGridDimensions);
    std::swap(this->BrickDimensions, this->OtherBrickDimensions);
    this->OnLevel = onLevel;
  }

  // --- Candidates: one-word segments are tested 64 at a time ---

  void beginCandidates(uint first, uint end, const vec3& local)
  {
    this->CandidateFirst = first;
    this->CandidateEnd = first;
    this->CandidateStop = end;
    this->CandidateX = -dot(local, this->PlaneX);
    this->CandidateY = -dot(local, this->PlaneY);
  }
  uint nextCandidate(uint segment, uint end)
  {
    if (this->SegmentWords != 1)
    {
      return segment;
    }
    while (segment < end)
    {
      if (segment >= this->CandidateEnd)
      {
        const uint count = std::min(64u, this->CandidateStop - segment);
        this->CandidateFirst = segment;
        this->CandidateEnd = segment + count;
        this->CandidateMask = this->CandidateTest(this->Model.Segments + segment,
          static_cast<int>(count), this->Projection, this->CandidateX, this->CandidateY);
      }
      const std::uint64_t rest = this->CandidateMask >> (segment - this->CandidateFirst);
      if (rest)
      {
        return segment + this->LowestBit(rest);
      }
      segment = this->CandidateEnd;
    }
    return end;
  }
  static uint LowestBit(std::uint64_t bits)
  {
#if defined(__GNUC__)
    return static_cast<uint>(__builtin_ctzll(bits));
#else
    uint index = 0;
    for (; !(bits & 1u); bits >>= 1)
    {
      ++index;
    }
    return index;
#endif
  }

  /// The plane across the ray, and where the bins of the six faces lie in it.
  void beginRay()
  {
    const vec3& direction = this->Ray.Direction;
    const vec3 other = abs(direction.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    this->PlaneX = normalize(cross(direction, other));
    this->PlaneY = cross(direction, this->PlaneX);
    const float width = 1.0f / static_cast<float>(1 << this->FaceBits);
    for (int xy = 0; xy < 2; ++xy)
    {
      const vec3& across = xy == 0 ? this->PlaneX : this->PlaneY;
      for (int face = 0; face < 6; ++face)
      {
        const int axis = face / 2;
        const float u = across[(axis + 1) % 3] * width;
        const float v = across[(axis + 2) % 3] * width;
        this->Projection.U[xy][face] = u;
        this->Projection.V[xy][face] = v;
        this->Projection.Base[xy][face] = 0.5f * (u + v) + ((face & 1) ? across[axis] : 0.0f);
      }
      for (int face = 6; face < 8; ++face)
      {
        this->Projection.U[xy][face] = 0.0f;
        this->Projection.V[xy][face] = 0.0f;
        this->Projection.Base[xy][face] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    // Rounding in the projection is far below a thousandth of a bin of 32.
    const float wide = this->Ray.Radius * 1.001f + 1e-4f;
    this->Projection.Radius2 = wide * wide;
    this->Projection.FaceBits = this->FaceBits;
  }

  // Between slabs, no candidates wait.
  void putRayAside()
  {
    this->AsideProjection = this->Projection;
    this->AsidePlaneX = this->PlaneX;
    this->AsidePlaneY = this->PlaneY;
  }
  void bringRayBack()
  {
    this->Projection = this->AsideProjection;
    this->PlaneX = this->AsidePlaneX;
    this->PlaneY = this->AsidePlaneY;
  }

  // --- Settings, named as the traversal names them ---

  ModelView Model;
  const vtkVoxelLineFrame& Frame;
  const vec3* RayOrigins;
  const vec3* RayDirections;
  vec2 HalfPixel;
  Real NearestS;
  Real FarthestS;
  vec2 DepthZ;
  vec2 DepthW;
  int PlaneCount;
  const vec4* Planes;
  int RegionPlaneCount;
  const vec4* RegionPlanes;
  ivec3 GridDimensions;
  ivec3 BrickDimensions;
  Real Radius;
  Real LargestRadius;
  bool Interactive;
  bool ThinTubes;
  bool NarrowTubes;
  bool LitAsLines;
  bool HasRadii;
  int SegmentWords;
  int FaceBits = 0;
  int InteriorBins;
  bool IdExtension;
  int Coloring;
  bool HasNaN;
  bool Lighting;
  bool Picking;
  vec3 AmbientColor;
  vec3 DiffuseColor;
  vec3 SpecularColor;
  Real Ambient;
  Real Diffuse;
  Real SpecularPower;
  Real Opacity;
  bool AllOpaque;
  bool OpacityByPathLength;
  Real EarlyTermination;
  bool Accelerating;
  Real AccelerationOpacity;
  mat4 ViewFromLocal;
  mat3 NormalFromLocal;
  bool ParallelView;
  bool MaximumReflection;
  bool HalfwayReflection;
  bool StretchRange;
  const vtkLineIlluminationTable* PowerMeans;
  bool TabulatedMeans;
  int LightCount;
  std::vector<int> LightKind;
  std::vector<vec3> LightDirection;
  std::vector<vec3> LightPosition;
  std::vector<vec3> LightColor;
  std::vector<vec3> LightAttenuation;
  std::vector<vec2> LightSpot;
  int Shadows;
  int Occlusion;
  const vec4* LocalLights;
  Real ConeSpread;
  Real ConeStart;
  Real OcclusionRadius;
  int OcclusionSamples;
  Real OcclusionStrength;
  Real Extinction;
  int DensityLevels = 0;
  std::vector<const float*> DensityValues;
  const std::uint8_t* OcclusionValues = nullptr;
  bool SecondaryRays;
  bool LevelRays;
  Real LevelScale;
  bool OnLevel = false;
  ModelView OtherModel;
  ivec3 OtherGridDimensions;
  ivec3 OtherBrickDimensions;

  vtkVoxelLineCandidateTest CandidateTest;
  vtkVoxelLineProjection Projection;
  vec3 PlaneX;
  vec3 PlaneY;
  vtkVoxelLineProjection AsideProjection;
  vec3 AsidePlaneX;
  vec3 AsidePlaneY;
  uint CandidateFirst;
  uint CandidateEnd;
  uint CandidateStop;
  std::uint64_t CandidateMask;
  float CandidateX;
  float CandidateY;

#include "glsl/vtkVoxelLinePacking.glsl"

#include "glsl/vtkVoxelLineCapsule.glsl"

#include "glsl/vtkLineReflection.glsl"

#include "glsl/vtkLineLighting.glsl"

#include "glsl/vtkVoxelLineRay.glsl"

#include "glsl/vtkVoxelLineSegment.glsl"

#include "glsl/vtkVoxelLineOccluder.glsl"

#include "glsl/vtkVoxelLineHits.glsl"

#include "glsl/vtkVoxelLineSlabs.glsl"

#include "glsl/vtkVoxelLineOcclusionRay.glsl"

#include "glsl/vtkVoxelLineDensity.glsl"

#include "glsl/vtkVoxelLineSoftLight.glsl"

#include "glsl/vtkVoxelLineShadow.glsl"

#include "glsl/vtkVoxelLineAcceleration.glsl"

#include "glsl/vtkVoxelLineShading.glsl"

#include "glsl/vtkVoxelLineLayers.glsl"

#include "glsl/vtkVoxelLineTraversal.glsl"

#include "glsl/vtkVoxelLinePixel.glsl"
};

#undef LS_OUT
#undef LS_INOUT

std::uint8_t ToByte(float value)
{
  return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f);
}
}

const char* vtkVoxelLineNativeEngine::GetInstructionSet()
{
  const char* name;
  ChooseCandidateTest(name);
  return name;
}

void vtkVoxelLineNativeEngine::Render(vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame,
  vtkVoxelLinePicture& picture, vtkVoxelLineModel* levelModel)
{
  const int width = std::max(frame.Width, 0);
  const int height = std::max(frame.Height, 0);
  const std::size_t pixels = static_cast<std::size_t>(width) * height;
  picture.Color.assign(4 * pixels, 0);
  picture.Depth.assign(pixels, 1.0f);
  picture.Curve.assign(frame.Picking ? pixels : 0, -1);
  picture.NumberOfOverflows = 0;
  if (pixels == 0 || !model || model->GetNumberOfSegments() == 0)
  {
    return;
  }

  const RayCaster prototype(model, frame, levelModel);
  std::atomic<vtkIdType> overflows(0);
  const int tilesX = (width + TileSize - 1) / TileSize;
  const int tilesY = (height + TileSize - 1) / TileSize;
  const bool hasScene = frame.SceneDepth.size() == pixels;

  const auto renderTiles = [&](vtkIdType begin, vtkIdType end)
  {
    RayCaster caster(prototype);
    vtkIdType forgotten = 0;
    for (vtkIdType tile = begin; tile < end; ++tile)
    {
      const int x0 = static_cast<int>(tile % tilesX) * TileSize;
      const int y0 = static_cast<int>(tile / tilesX) * TileSize;
      const int x1 = std::min(x0 + TileSize, width);
      const int y1 = std::min(y0 + TileSize, height);
      for (int y = y0; y < y1; ++y)
      {
        for (int x = x0; x < x1; ++x)
        {
          const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
          vec4 color;
          float depth;
          caster.castPixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
            hasScene ? frame.SceneDepth[pixel] : 1.0f, color, depth);
          for (int c = 0; c < 4; ++c)
          {
            picture.Color[4 * pixel + c] = ToByte(color[c]);
          }
          picture.Depth[pixel] = depth;
          forgotten += caster.Forgot ? 1 : 0;
          if (frame.Picking)
          {
            picture.Curve[pixel] = caster.FirstCurve;
          }
        }
      }
    }
    overflows += forgotten;
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(tilesX) * tilesY, 4, renderTiles);
  picture.NumberOfOverflows = overflows;
}

std::vector<float> vtkVoxelLineNativeEngine::CastSecondaryRays(vtkVoxelLineModel* model,
  const vtkVoxelLineFrame& frame, const std::vector<vtkVoxelLineSecondaryRay>& rays,
  vtkVoxelLineModel* levelModel)
{
  RayCaster caster(model, frame, levelModel);
  std::vector<float> through;
  for (const vtkVoxelLineSecondaryRay& ray : rays)
  {
    through.push_back(frame.LevelRays
        ? caster.levelTransmittance(ray.Origin, ray.Direction, ray.End)
        : caster.transmittance(ray.Origin, ray.Direction, ray.End));
  }
  return through;
}
