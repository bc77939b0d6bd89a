// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelMethod.h"

#include "JsonObject.h"

#include "vtkPolyData.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <stdexcept>

namespace linesets
{
//------------------------------------------------------------------------------
const std::vector<VoxelMethod::Variant>& VoxelMethod::GetVariants()
{
  using G = vtkLineGlobalIllumination;
  static const std::vector<Variant> variants = {
    { "voxel-hard-shadow", G::HardShadows, G::NoOcclusion },
    { "voxel-line-shadow", G::LevelShadows, G::NoOcclusion },
    { "voxel-soft-shadow", G::SoftShadows, G::NoOcclusion },
    { "voxel-occlusion", G::NoShadows, G::SphericalOcclusion },
    { "voxel-full", G::SoftShadows, G::SphericalOcclusion },
    { "voxel-hemisphere", G::NoShadows, G::HemisphereDensity },
    { "voxel-hemisphere-tubes", G::NoShadows, G::HemisphereTubes },
  };
  return variants;
}

//------------------------------------------------------------------------------
const VoxelMethod::Variant* VoxelMethod::FindVariant(const std::string& name)
{
  const std::vector<Variant>& variants = GetVariants();
  const auto found = std::find_if(variants.begin(), variants.end(),
    [&name](const Variant& variant) { return name == variant.Name; });
  return found == variants.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
VoxelMethod::VoxelMethod(const std::string& name, const std::string& engine)
  : Global(FindVariant(name))
{
  this->Mapper->SetEngine(engine == "native" ? vtkVoxelLineMapper::Native
      : engine == "shader"                   ? vtkVoxelLineMapper::Shader
                                             : vtkVoxelLineMapper::Automatic);
}

//------------------------------------------------------------------------------
VoxelMethod::~VoxelMethod() = default;

//------------------------------------------------------------------------------
void VoxelMethod::SetGlobalIllumination(const BenchmarkOptions& options)
{
  vtkLineGlobalIllumination* global = this->Mapper->GetGlobalIllumination();
  global->SetShadows(this->Global->Shadows);
  global->SetShadowLevel(options.ShadowLevel);
  global->SetShadowConeAngle(options.ConeAngle);
  global->SetOcclusion(this->Global->Occlusion);
  global->SetOcclusionRadius(options.OcclusionRadius);
  global->SetOcclusionSamples(options.OcclusionSamples);
}

//------------------------------------------------------------------------------
void VoxelMethod::Prepare(BenchmarkInput& input)
{
  this->Mapper->SetInputData(input.Geometry);
  this->Mapper->SetRadius(input.Radius);
  this->Mapper->SetResolution(input.Options.Resolution);
  this->Mapper->SetFaceBins(input.Options.FaceBins);
  if (this->Global)
  {
    this->SetGlobalIllumination(input.Options);
  }
  this->SetMapper(this->Mapper, input);
  const auto start = std::chrono::steady_clock::now();
  if (!this->Mapper->GetModel())
  {
    throw std::runtime_error("no model was built");
  }
  this->BuildMilliseconds = GetMilliseconds(start);
}

//------------------------------------------------------------------------------
double VoxelMethod::Update(BenchmarkInput& input)
{
  this->Mapper->SetInputData(input.Geometry);
  if (!this->Mapper->GetModel())
  {
    throw std::runtime_error("no model was built");
  }
  return 1000.0 * this->Mapper->GetModelBuildTime();
}

//------------------------------------------------------------------------------
void VoxelMethod::Describe(JsonObject& object)
{
  const int engine = this->Mapper->GetEngineInUse();
  object.Add("engine",
    std::string(engine == vtkVoxelLineMapper::Native ? "native"
        : engine == vtkVoxelLineMapper::Shader       ? "shader"
                                                     : "none"));
  if (this->Global)
  {
    this->DescribeGlobalIllumination(object);
  }
  vtkVoxelLineModel* model = this->Mapper->GetModel();
  object.Add("model_bytes", static_cast<long long>(model->GetNumberOfBytes()));
  object.Add("gpu_bytes", static_cast<long long>(this->Mapper->GetGraphicsMemory()));
  object.Add("segments", static_cast<long long>(model->GetNumberOfSegments()));
}

//------------------------------------------------------------------------------
void VoxelMethod::DescribeGlobalIllumination(JsonObject& object)
{
  // What the mapper has, in place of what was asked for.
  vtkLineGlobalIllumination* global = this->Mapper->GetGlobalIllumination();
  const int shadows = global->GetShadows();
  if (shadows != vtkLineGlobalIllumination::NoShadows)
  {
    const char* const names[] = { "none", "hard", "level", "soft" };
    object.Add("shadows", std::string(names[shadows]));
  }
  if (shadows == vtkLineGlobalIllumination::LevelShadows)
  {
    object.Add("shadow_level", global->GetShadowLevel());
  }
  if (shadows == vtkLineGlobalIllumination::SoftShadows)
  {
    object.Add("cone_angle", global->GetShadowConeAngle());
  }
  const int occlusion = global->GetOcclusion();
  if (occlusion != vtkLineGlobalIllumination::NoOcclusion)
  {
    const char* const names[] = { "none", "spherical", "hemisphere", "hemisphere-tubes" };
    object.Add("occlusion", std::string(names[occlusion]));
    object.Add("occlusion_radius", global->GetOcclusionRadius());
  }
  if (occlusion == vtkLineGlobalIllumination::HemisphereDensity ||
    occlusion == vtkLineGlobalIllumination::HemisphereTubes)
  {
    object.Add("occlusion_samples", global->GetOcclusionSamples());
  }
}

//------------------------------------------------------------------------------
vtkVoxelLineModel* VoxelMethod::GetModel()
{
  return this->Mapper->GetModel();
}
}
