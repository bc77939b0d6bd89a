// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineLightFields.h"

#include "vtkLineGlobalIllumination.h"
#include "vtkMath.h"
#include "vtkTimerLog.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineLevel.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

namespace
{
// Mean of the sine of the angle between a ray and a line of any direction: what part of a line's
// length counts from the side.
constexpr double MeanSine = 0.25 * 3.14159265358979323846;

using Illumination = vtkLineGlobalIllumination;

/// A light's position (w = 1) or the direction to it (w = 0), seen from the grid; w = -1: it has
/// neither, and so no shadow.
glm::dvec4 FindLight(const vtkLineSetsLight& light, const glm::dmat4& localFromView)
{
  const bool isPositional = light.Kind == 1 || light.Kind == 2;
  const glm::dvec4 found = isPositional
    ? localFromView * glm::dvec4(glm::dvec3(light.Position), 1.0)
    : localFromView * glm::dvec4(-glm::dvec3(light.Direction), 0.0);
  const double size = glm::length(glm::dvec3(found));
  if (!std::isfinite(size) || (size == 0.0 && !isPositional))
  {
    // Its focal point is its position, or it is nowhere.
    return glm::dvec4(0.0, 0.0, 0.0, -1.0);
  }
  return isPositional ? glm::dvec4(glm::dvec3(found), 1.0)
                      : glm::dvec4(glm::dvec3(found) / size, 0.0);
}

/// The lights as seen from the grid. Returns whether any of them casts shadows.
bool SetLights(vtkVoxelLineFrame& frame)
{
  const glm::dmat4 localFromView = glm::inverse(glm::dmat4(frame.ViewFromLocal));
  bool any = false;
  frame.Global.Lights.clear();
  for (const vtkLineSetsLight& light : frame.Light.Lights)
  {
    any = any || light.CastsShadow;
    frame.Global.Lights.emplace_back(
      light.CastsShadow ? FindLight(light, localFromView) : glm::dvec4(0.0, 0.0, 0.0, -1.0));
  }
  return any;
}

/// What follows from the parameters alone. Returns why shadows are left out.
std::string SetParameters(vtkVoxelLineFrame& frame, Illumination* illumination)
{
  vtkVoxelLineGlobalLight& global = frame.Global;
  std::string problem;
  if (frame.Lighting)
  {
    global.Shadows = illumination->GetShadows();
    global.Occlusion = illumination->GetOcclusion();
  }
  if (global.Shadows != Illumination::NoShadows && !SetLights(frame))
  {
    global.Shadows = Illumination::NoShadows;
    problem = "Shadows are not seen: all lights that are switched on are headlights, which shine "
              "from the camera. Add a vtkLight that is fixed in the scene.";
  }
  global.OcclusionRadius = static_cast<float>(illumination->GetOcclusionRadius());
  global.OcclusionSamples = illumination->GetOcclusionSamples();
  global.OcclusionStrength = static_cast<float>(illumination->GetOcclusionStrength());
  const double halfAngle = vtkMath::RadiansFromDegrees(0.5 * illumination->GetShadowConeAngle());
  global.ConeSpread = static_cast<float>(2.0 * std::tan(halfAngle));
  global.ConeStart = frame.Radius + vtkVoxelLineLightFields::ConeMargin;
  global.Extinction = static_cast<float>(2.0 * MeanSine * static_cast<double>(frame.Radius));
  frame.SecondaryRays = global.Shadows == Illumination::HardShadows ||
    global.Occlusion == Illumination::HemisphereTubes;
  return problem;
}

/// Whether all values of densities and occlusion have indices that engines can count: 31 bits.
bool AreIndicesSmall(vtkVoxelLineModel* model)
{
  const int* size = model->GetDimensions();
  vtkIdType coarse = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    coarse *= vtkVoxelLineLevels::SizeOf(size[axis], 1);
  }
  const vtkIdType fine = 64 * model->GetNumberOfBricks();
  return std::max(coarse, fine) <= std::numeric_limits<int>::max();
}

bool NeedsDensities(const vtkVoxelLineFrame& frame)
{
  return frame.Global.Shadows == Illumination::SoftShadows ||
    frame.Global.Occlusion == Illumination::SphericalOcclusion ||
    frame.Global.Occlusion == Illumination::HemisphereDensity || frame.IsAccelerated();
}

/// Do without what needs densities.
void LeaveDensitiesOut(vtkVoxelLineFrame& frame)
{
  vtkVoxelLineGlobalLight& global = frame.Global;
  if (global.Shadows == Illumination::SoftShadows)
  {
    global.Shadows = Illumination::NoShadows;
  }
  if (global.Occlusion != Illumination::HemisphereTubes)
  {
    global.Occlusion = Illumination::NoOcclusion;
  }
}
}

//------------------------------------------------------------------------------
vtkVoxelLineLightFields::vtkVoxelLineLightFields()
  : Densities(vtkSmartPointer<vtkVoxelLineDensities>::New())
  , Level(vtkSmartPointer<vtkVoxelLineLevel>::New())
{
  this->Densities->UseRadiiOn();
}

//------------------------------------------------------------------------------
vtkVoxelLineLightFields::~vtkVoxelLineLightFields() = default;

//------------------------------------------------------------------------------
std::string vtkVoxelLineLightFields::Update(vtkVoxelLineFrame& frame, vtkVoxelLineModel* model,
  vtkLineGlobalIllumination* illumination, const std::function<bool(double)>& progress)
{
  frame.Global = vtkVoxelLineGlobalLight();
  frame.SecondaryRays = false;
  frame.LevelRays = false;
  this->HasLevel = false;
  std::string problem = SetParameters(frame, illumination);

  const double start = vtkTimerLog::GetUniversalTime();
  const vtkMTimeType before = this->GetLatestTime();
  vtkVoxelLineGlobalLight& global = frame.Global;
  if (global.Shadows == Illumination::LevelShadows &&
    !this->UpdateLevel(frame, model, illumination->GetShadowLevel()))
  {
    global.Shadows = Illumination::NoShadows;
    problem = "Shadows are left out: the representative lines of the level could not be made.";
  }
  if (NeedsDensities(frame))
  {
    if (this->UpdateDensities(frame, model))
    {
      global.Densities = this->Densities;
      global.DensitiesTime = this->Densities->GetBuildTime();
    }
    else
    {
      LeaveDensitiesOut(frame);
      problem = "Soft shadows, occlusion and opacity acceleration by densities are left out: the "
                "densities could not be made. Lower the Resolution.";
    }
  }
  if (global.Occlusion == Illumination::SphericalOcclusion)
  {
    // Where it is aborted, there is none.
    bool isBuilt = false;
    try
    {
      isBuilt = this->Occlusion.Build(model, this->Densities, illumination->GetOcclusionRadius(),
        static_cast<double>(global.Extinction), progress);
    }
    catch (const std::bad_alloc&)
    {
      this->Occlusion.Initialize();
      problem = "Occlusion is left out: there is not enough memory for it. Lower the Resolution.";
    }
    global.Occlusion = isBuilt ? global.Occlusion : Illumination::NoOcclusion;
    global.SphericalOcclusion = isBuilt ? &this->Occlusion : nullptr;
    global.SphericalOcclusionTime = this->Occlusion.GetBuildTime();
  }
  if (this->GetLatestTime() != before)
  {
    this->BuildTime = vtkTimerLog::GetUniversalTime() - start;
  }
  return problem;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVoxelLineLightFields::GetLatestTime() const
{
  vtkVoxelLineModel* level = this->Level->GetOutput();
  return std::max({ this->Densities->GetBuildTime(), this->Occlusion.GetBuildTime(),
    level ? level->GetMTime() : 0 });
}

//------------------------------------------------------------------------------
bool vtkVoxelLineLightFields::UpdateDensities(
  const vtkVoxelLineFrame& frame, vtkVoxelLineModel* model)
{
  if (!AreIndicesSmall(model))
  {
    return false;
  }
  this->Densities->SetOpacity(static_cast<double>(frame.Opacity));
  this->Densities->SetUseColorOpacity(frame.Coloring == vtkVoxelLineFrame::Direct);
  std::array<double, vtkVoxelLineDensities::TableSize> opacities;
  std::transform(frame.ColorTable.begin(), frame.ColorTable.end(), opacities.begin(),
    [](const glm::vec4& color) { return static_cast<double>(color.w); });
  const bool isOpaque =
    std::all_of(opacities.begin(), opacities.end(), [](double opacity) { return opacity >= 1.0; });
  if (frame.Coloring == vtkVoxelLineFrame::Table && !isOpaque)
  {
    this->Densities->SetOpacityTable(opacities.data());
  }
  else
  {
    this->Densities->RemoveOpacityTable();
  }
  return this->Densities->Build(model);
}

//------------------------------------------------------------------------------
bool vtkVoxelLineLightFields::UpdateLevel(
  vtkVoxelLineFrame& frame, vtkVoxelLineModel* model, int level)
{
  const int coarsest = vtkVoxelLineLevels::CountLevels(model->GetDimensions()) - 1;
  frame.ShadowLevel = std::min(level, coarsest);
  this->Level->SetInputDataObject(model);
  this->Level->SetLevel(frame.ShadowLevel);
  this->Level->Update();
  this->HasLevel = this->Level->GetOutput() && this->Level->GetOutput()->GetNumberOfSegments() > 0;
  frame.LevelRays = this->HasLevel;
  return this->HasLevel;
}

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkVoxelLineLightFields::GetLevelModel() const
{
  return this->HasLevel ? this->Level->GetOutput() : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineLightFields::GetNumberOfBytes() const
{
  vtkVoxelLineModel* level = this->Level->GetOutput();
  return this->Densities->GetNumberOfBytes() +
    static_cast<vtkIdType>(this->Occlusion.GetValues().size()) +
    (level ? level->GetNumberOfBytes() : 0);
}
