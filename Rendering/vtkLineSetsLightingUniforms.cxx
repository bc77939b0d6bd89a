// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsLightingUniforms.h"

#include "vtkLineIllumination.h"
#include "vtkLineIlluminationTable.h"
#include "vtkLineSetsLighting.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include "vtkLineLighting.h"
#include "vtkLineLightingUniforms.h"
#include "vtkLineReflection.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace
{
void SetLights(vtkShaderProgram* program, const std::vector<vtkLineSetsLight>& lights, int count)
{
  std::vector<float> directions;
  std::vector<float> positions;
  std::vector<float> colors;
  std::vector<float> attenuations;
  std::vector<float> spots;
  const auto append = [](std::vector<float>& values, const glm::vec3& v) {
    values.insert(values.end(), { v.x, v.y, v.z });
  };
  for (int i = 0; i < count; ++i)
  {
    const vtkLineSetsLight& light = lights[i];
    append(directions, light.Direction);
    append(positions, light.Position);
    append(colors, light.Color);
    append(attenuations, light.Attenuation);
    spots.insert(spots.end(), { light.CosConeAngle, light.Exponent });
  }
  if (count > 0)
  {
    program->SetUniform3fv("LightDirection", count, directions.data());
    program->SetUniform3fv("LightPosition", count, positions.data());
    program->SetUniform3fv("LightColor", count, colors.data());
    program->SetUniform3fv("LightAttenuation", count, attenuations.data());
    program->SetUniform2fv("LightSpot", count, spots.data());
  }
}
}

//------------------------------------------------------------------------------
vtkLineSetsLightingUniforms::vtkLineSetsLightingUniforms() = default;

//------------------------------------------------------------------------------
vtkLineSetsLightingUniforms::~vtkLineSetsLightingUniforms() = default;

//------------------------------------------------------------------------------
std::string vtkLineSetsLightingUniforms::GetSource(const vtkLineSetsLighting& lighting)
{
  std::ostringstream os;
  const auto constant = [&os](const char* type, const char* name, int value)
  { os << "const " << type << " " << name << " = " << type << "(" << value << ");\n"; };
  constant("int", "MaximumLights", MaximumLights);
  const int count = std::min(static_cast<int>(lighting.Lights.size()), MaximumLights);
  constant("int", "LightCount", count);
  // Constants, not uniforms: software OpenGL runs all branches that it cannot rule out.
  const int kinds = std::max(count, 1);
  os << "const int LightKind[" << kinds << "] = int[" << kinds << "](";
  for (int i = 0; i < kinds; ++i)
  {
    os << (i > 0 ? ", " : "") << (i < count ? lighting.Lights[i].Kind : 0);
  }
  os << ");\n";
  constant("bool", "ParallelView", lighting.ParallelView ? 1 : 0);
  constant(
    "bool", "MaximumReflection", lighting.Model == vtkLineIllumination::MaximumReflection ? 1 : 0);
  constant("bool", "HalfwayReflection", lighting.Reflection == vtkLineIllumination::Blinn ? 1 : 0);
  constant("bool", "StretchRange", lighting.StretchDynamicRange ? 1 : 0);
  constant("bool", "TabulatedMeans", lighting.Table ? 1 : 0);
  os << (lighting.Table ? "#define LineSetsHasPowerMeans\n" : "");
  os << vtkLineLightingUniforms << vtkLineReflection << vtkLineLighting;
  return os.str();
}

//------------------------------------------------------------------------------
bool vtkLineSetsLightingUniforms::Activate(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const vtkLineSetsLighting& lighting)
{
  SetLights(
    program, lighting.Lights, std::min(static_cast<int>(lighting.Lights.size()), MaximumLights));
  if (!lighting.Table || !program->IsUniformUsed("PowerMeans"))
  {
    return true;
  }
  if (this->Table != lighting.Table || this->Texture->GetHandle() == 0 ||
    this->Texture->GetContext() != window)
  {
    this->Table = nullptr;
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    std::vector<float> values = lighting.Table->GetValues();
    if (!this->Texture->Create2DFromRaw(static_cast<unsigned int>(lighting.Table->GetColumns()),
          static_cast<unsigned int>(lighting.Table->GetRows()), 1, VTK_FLOAT, values.data()))
    {
      return false;
    }
    this->Table = lighting.Table;
  }
  this->Texture->Activate();
  this->Active = true;
  program->SetUniformi("PowerMeans", this->Texture->GetTextureUnit());
  return true;
}

//------------------------------------------------------------------------------
void vtkLineSetsLightingUniforms::Deactivate()
{
  if (this->Active)
  {
    this->Texture->Deactivate();
    this->Active = false;
  }
}

//------------------------------------------------------------------------------
void vtkLineSetsLightingUniforms::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Table = nullptr;
  this->Active = false;
}
