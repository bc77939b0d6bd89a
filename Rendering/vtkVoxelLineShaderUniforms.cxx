// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineShaderUniforms.h"

#include "vtkLineSetsLightingUniforms.h"
#include "vtkShaderProgram.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineFieldBuffers.h"
#include "vtkVoxelLineFrame.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <cmath>
#include <sstream>

std::string vtkVoxelLineShaderUniforms::MakeConstants(
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel)
{
  int faceBits = 0;
  while ((1 << faceBits) < model->GetFaceBins())
  {
    ++faceBits;
  }
  std::ostringstream os;
  const auto constant = [&os](const char* type, const char* name, int value)
  { os << "const " << type << " " << name << " = " << type << "(" << value << ");\n"; };
  constant("int", "MaximumPlanes", MaximumPlanes);
  constant("int", "PlaneCount", static_cast<int>(frame.ClippingPlanes.size()));
  constant("int", "MaximumRegionPlanes", MaximumRegionPlanes);
  constant("int", "RegionPlaneCount", static_cast<int>(frame.RegionPlanes.size()));
  constant("int", "SegmentWords", model->GetSegmentWords());
  constant("int", "FaceBits", faceBits);
  constant("int", "InteriorBins", std::max(model->GetInteriorBins(), 1));
  constant("int", "Coloring", frame.Coloring);
  constant("bool", "HasRadii", model->GetRadii() ? 1 : 0);
  constant("bool", "IdExtension", model->GetCurveIdExtension() ? 1 : 0);
  constant("bool", "HasNaN", frame.HasNaN ? 1 : 0);
  constant("bool", "Lighting", frame.Lighting && !frame.Picking ? 1 : 0);
  constant("bool", "Picking", frame.Picking ? 1 : 0);
  constant("bool", "AllOpaque", frame.IsOpaque() ? 1 : 0);
  constant("bool", "OpacityByPathLength", frame.OpacityByPathLength && !frame.IsOpaque() ? 1 : 0);
  constant("bool", "Interactive", frame.Interactive ? 1 : 0);
  constant("bool", "ThinTubes", frame.ThinTubes ? 1 : 0);
  constant("bool", "NarrowTubes", frame.NarrowTubes ? 1 : 0);
  constant("bool", "LitAsLines", frame.LitAsLines ? 1 : 0);
  constant("int", "Shadows", frame.Global.Shadows);
  constant("int", "Occlusion", frame.Global.Occlusion);
  constant("bool", "Accelerating", frame.IsAccelerated() && frame.Global.Densities ? 1 : 0);
  constant("int", "DensityLevels",
    frame.Global.Densities ? frame.Global.Densities->GetNumberOfLevels() : 0);
  constant("bool", "SecondaryRays", frame.SecondaryRays || frame.LevelRays ? 1 : 0);
  constant("bool", "LevelRays", hasLevel ? 1 : 0);
  const auto define = [&os](const char* name, bool has)
  { os << (has ? std::string("#define ") + name + "\n" : std::string()); };
  define("LineSetsHasScene", hasScene);
  define("LineSetsHasLevel", hasLevel);
  os << vtkVoxelLineFieldBuffers::GetSource(frame.Global);
  os << "float lightVisibility(int i);\n" << vtkLineSetsLightingUniforms::GetSource(frame.Light);
  return os.str();
}

void vtkVoxelLineShaderUniforms::Set(vtkShaderProgram* program, vtkVoxelLineModel* model,
  const vtkVoxelLineFrame& frame, vtkVoxelLineModel* level)
{
  const auto set1 = [program](const char* name, float value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, value);
    }
  };
  const auto set3 = [program](const char* name, const glm::vec3& value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform3f(name, &value[0]);
    }
  };
  const float pictureSize[2] = { static_cast<float>(frame.Width),
    static_cast<float>(frame.Height) };
  program->SetUniform2f("PictureSize", pictureSize);
  program->SetUniform3fv("RayOrigins", 3, &frame.Origin[0][0]);
  program->SetUniform3fv("RayDirections", 3, &frame.Direction[0][0]);
  if (program->IsUniformUsed("HalfPixel"))
  {
    program->SetUniform2f("HalfPixel", &frame.HalfPixel[0]);
  }
  set1("NearestS", frame.NearestS);
  set1("FarthestS", frame.FarthestS);
  program->SetUniform2f("DepthZ", &frame.DepthZ[0]);
  program->SetUniform2f("DepthW", &frame.DepthW[0]);
  if (!frame.ClippingPlanes.empty())
  {
    program->SetUniform4fv(
      "Planes", static_cast<int>(frame.ClippingPlanes.size()), &frame.ClippingPlanes[0][0]);
  }
  if (!frame.RegionPlanes.empty())
  {
    program->SetUniform4fv(
      "RegionPlanes", static_cast<int>(frame.RegionPlanes.size()), &frame.RegionPlanes[0][0]);
  }
  int size[3];
  model->GetDimensions(size);
  set3("GridSize", glm::vec3(size[0], size[1], size[2]));
  model->GetBrickDimensions(size);
  set3("BrickGridSize", glm::vec3(size[0], size[1], size[2]));
  if (level)
  {
    level->GetDimensions(size);
    set3("LevelGridSize", glm::vec3(size[0], size[1], size[2]));
    level->GetBrickDimensions(size);
    set3("LevelBrickGridSize", glm::vec3(size[0], size[1], size[2]));
    set1("LevelScale", std::ldexp(1.0f, -frame.ShadowLevel));
  }
  set1("Radius", frame.Radius);
  set1("LargestRadius", frame.ThinTubes ? frame.LargestRadius : frame.Radius);
  set3("AmbientColor", frame.AmbientColor);
  set3("DiffuseColor", frame.DiffuseColor);
  set3("SpecularColor", frame.SpecularColor * frame.Specular);
  set1("Ambient", frame.Ambient);
  set1("Diffuse", frame.Diffuse);
  set1("SpecularPower", frame.Light.SpecularPower);
  set1("Opacity", frame.Opacity);
  set1("EarlyTermination", frame.EarlyTermination);
  set1("AccelerationOpacity", frame.AccelerationOpacity);
  const vtkVoxelLineGlobalLight& global = frame.Global;
  if (!global.Lights.empty() && program->IsUniformUsed("LocalLights"))
  {
    program->SetUniform4fv("LocalLights",
      std::min(static_cast<int>(global.Lights.size()), vtkLineSetsLightingUniforms::MaximumLights),
      &global.Lights[0][0]);
  }
  set1("ConeSpread", global.ConeSpread);
  set1("ConeStart", global.ConeStart);
  set1("OcclusionRadius", global.OcclusionRadius);
  set1("OcclusionStrength", global.OcclusionStrength);
  set1("Extinction", global.Extinction);
  if (program->IsUniformUsed("OcclusionSamples"))
  {
    program->SetUniformi("OcclusionSamples", global.OcclusionSamples);
  }
  glm::mat4 view = frame.ViewFromLocal;
  glm::mat3 normal = frame.NormalFromLocal;
  if (program->IsUniformUsed("ViewFromLocal"))
  {
    program->SetUniformMatrix4x4("ViewFromLocal", &view[0][0]);
  }
  if (program->IsUniformUsed("NormalFromLocal"))
  {
    program->SetUniformMatrix3x3("NormalFromLocal", &normal[0][0]);
  }
}
