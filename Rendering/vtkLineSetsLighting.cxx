// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsLighting.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLineIllumination.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
glm::vec3 ToVec3(const double v[3])
{
  return glm::vec3(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
}

vtkLineSetsLight MakeLight(vtkLight* light, vtkTransform* view, vtkTransform* user)
{
  double position[3];
  double focalPoint[3];
  light->GetTransformedPosition(position);
  light->GetTransformedFocalPoint(focalPoint);
  double direction[3];
  vtkMath::Subtract(focalPoint, position, direction);
  vtkMath::Normalize(direction);
  view->TransformNormal(direction, direction);
  view->TransformPoint(position, position);
  if (!light->LightTypeIsSceneLight() && user)
  {
    user->TransformNormal(direction, direction);
    user->TransformPoint(position, position);
  }

  vtkLineSetsLight result;
  // VTK's shaders take a cone of 90 degrees or more for none at all.
  result.Kind = !light->GetPositional() ? 0 : (light->GetConeAngle() < 90.0 ? 2 : 1);
  result.Direction = ToVec3(direction);
  result.Position = ToVec3(position);
  result.Color = ToVec3(light->GetDiffuseColor()) * static_cast<float>(light->GetIntensity());
  result.Attenuation = ToVec3(light->GetAttenuationValues());
  result.CosConeAngle =
    static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle())));
  result.Exponent = static_cast<float>(light->GetExponent());
  result.CastsShadow = !light->LightTypeIsHeadlight();
  return result;
}
}

//------------------------------------------------------------------------------
bool vtkLineSetsLight::operator==(const vtkLineSetsLight& other) const
{
  // In view coordinates they differ by rounding where a camera is set to where it was.
  const auto isNear = [](const glm::vec3& a, const glm::vec3& b)
  { return glm::length(a - b) <= 1e-5f * glm::length(a); };
  return this->Kind == other.Kind && isNear(this->Direction, other.Direction) &&
    isNear(this->Position, other.Position) && this->Color == other.Color &&
    this->Attenuation == other.Attenuation && this->CosConeAngle == other.CosConeAngle &&
    this->Exponent == other.Exponent && this->CastsShadow == other.CastsShadow;
}

//------------------------------------------------------------------------------
void vtkLineSetsLighting::SetRenderer(vtkRenderer* renderer)
{
  this->Lights.clear();
  vtkCamera* camera = renderer->GetActiveCamera();
  this->ParallelView = camera->GetParallelProjection() != 0;
  auto* glRenderer = vtkOpenGLRenderer::SafeDownCast(renderer);
  vtkTransform* user = glRenderer ? glRenderer->GetUserLightTransform() : nullptr;
  bool loneHeadlight = false;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      this->Lights.push_back(MakeLight(light, camera->GetModelViewTransformObject(), user));
      loneHeadlight = light->LightTypeIsHeadlight() && !light->GetPositional();
    }
  }
  // VTK has a word in that, too: a light that is off may count for it. Before its first frame it
  // has none.
  const bool isSimple = !glRenderer || glRenderer->GetLightingComplexity() <= 1;
  if (this->Lights.size() == 1 && loneHeadlight && isSimple)
  {
    this->Lights[0].Kind = 3;
    this->Lights[0].Direction = glm::vec3(0.0f, 0.0f, -1.0f);
  }
}

//------------------------------------------------------------------------------
bool vtkLineSetsLighting::SetModel(vtkLineIllumination* illumination, vtkProperty* property)
{
  this->Model = illumination->GetModel();
  this->Reflection = illumination->GetReflection();
  this->StretchDynamicRange = illumination->GetStretchDynamicRange();
  double power = illumination->GetSpecularPower();
  power = power >= 0.0 ? power : property->GetSpecularPower();
  // vtkProperty keeps its exponent within bounds, but not from being NaN.
  const bool isValid = std::isfinite(power) && power >= 0.0;
  this->SpecularPower = static_cast<float>(isValid ? power : 1.0);
  this->Table = illumination->GetEvaluation() == vtkLineIllumination::Tables
    ? vtkLineIlluminationTable::Get(illumination->GetTableTolerance())
    : nullptr;
  return isValid;
}

//------------------------------------------------------------------------------
bool vtkLineSetsLighting::operator==(const vtkLineSetsLighting& other) const
{
  return this->Lights == other.Lights && this->ParallelView == other.ParallelView &&
    this->Model == other.Model && this->Reflection == other.Reflection &&
    this->StretchDynamicRange == other.StretchDynamicRange &&
    this->SpecularPower == other.SpecularPower && this->Table == other.Table;
}
