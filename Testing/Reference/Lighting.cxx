// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lighting.h"

#include "vtkCamera.h"
#include "vtkCollection.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
namespace
{
// Factors of the diffuse and the specular colour for one light.
struct Response
{
  double Diffuse;
  double Specular;
};

Response RespondToHeadlight(const double normal[3], double power)
{
  const double diffuse = std::max(0.0, normal[2]);
  return { diffuse, std::pow(diffuse, power) };
}

Response RespondToLight(const Light& light, bool positionalCase, const double point[3],
  const double toViewer[3], const double normal[3], double power)
{
  double direction[3] = { light.Direction[0], light.Direction[1], light.Direction[2] };
  double attenuation = 1.0;
  if (positionalCase && light.Positional)
  {
    vtkMath::Subtract(point, light.Position, direction);
    const double distance = vtkMath::Normalize(direction);
    attenuation = 1.0 /
      (light.Attenuation[0] + light.Attenuation[1] * distance +
        light.Attenuation[2] * distance * distance);
    if (light.ConeAngle < 90.0)
    {
      const double cosine = vtkMath::Dot(direction, light.Direction);
      const bool inside = cosine >= std::cos(vtkMath::RadiansFromDegrees(light.ConeAngle));
      attenuation = inside ? attenuation * std::pow(cosine, light.Exponent) : 0.0;
    }
  }
  const double facing = vtkMath::Dot(normal, direction);
  Response response;
  response.Diffuse = std::max(0.0, -attenuation * facing);
  double reflected = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    reflected += (direction[i] - 2.0 * facing * normal[i]) * toViewer[i];
  }
  response.Specular =
    response.Diffuse > 0.0 ? attenuation * std::pow(std::max(0.0, reflected), power) : 0.0;
  return response;
}

Light MakeLight(vtkLight* light, vtkMatrix4x4* view)
{
  Light result;
  light->GetDiffuseColor(result.Color);
  vtkMath::MultiplyScalar(result.Color, light->GetIntensity());
  double focalPoint[3];
  double position[4];
  light->GetTransformedFocalPoint(focalPoint);
  light->GetTransformedPosition(position);
  position[3] = 1.0;
  double direction[4];
  vtkMath::Subtract(focalPoint, position, direction);
  vtkMath::Normalize(direction);
  direction[3] = 0.0;
  // The view transform of a camera is a rotation and a translation, so that directions transform
  // as normals do.
  view->MultiplyPoint(direction, direction);
  view->MultiplyPoint(position, position);
  vtkMath::Normalize(direction);
  std::copy(direction, direction + 3, result.Direction);
  std::copy(position, position + 3, result.Position);
  light->GetAttenuationValues(result.Attenuation);
  result.ConeAngle = light->GetConeAngle();
  result.Exponent = light->GetExponent();
  result.Positional = light->GetPositional() != 0;
  return result;
}
}

//------------------------------------------------------------------------------
Material Material::FromProperty(vtkProperty* property)
{
  Material material;
  material.Lighting = property->GetLighting();
  material.Ambient = property->GetAmbient();
  material.Diffuse = property->GetDiffuse();
  material.Specular = property->GetSpecular();
  material.SpecularPower = property->GetSpecularPower();
  material.Opacity = property->GetOpacity();
  property->GetAmbientColor(material.AmbientColor);
  property->GetDiffuseColor(material.DiffuseColor);
  property->GetSpecularColor(material.SpecularColor);
  return material;
}

//------------------------------------------------------------------------------
LightSet LightSet::FromRenderer(vtkRenderer* renderer)
{
  renderer->UpdateLightsGeometryToFollowCamera();
  vtkMatrix4x4* view = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  LightSet result;
  result.ParallelView = renderer->GetActiveCamera()->GetParallelProjection() != 0;
  result.Complexity = 0;
  result.Lights.clear();
  vtkCollectionSimpleIterator iterator;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      result.Lights.push_back(MakeLight(light, view));
      const bool plain = result.Lights.size() == 1 && light->LightTypeIsHeadlight();
      result.Complexity = std::max(result.Complexity, plain ? 1 : 2);
    }
    // VTK looks at lights that are off, too, once it has seen one that is on or positional.
    if (light->GetPositional())
    {
      result.Complexity = 3;
    }
  }
  if (result.Lights.empty())
  {
    if (renderer->GetAutomaticLightCreation())
    {
      result.Complexity = 1;
      result.Lights.resize(1);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void Shade(const LightSet& lights, const Material& material, const double* colors,
  const double point[3], const double normal[3], double rgb[3])
{
  const double* ambient = colors ? colors : material.AmbientColor;
  const double* diffuse = colors ? colors : material.DiffuseColor;
  const bool lit = material.Lighting && lights.Complexity > 0 && !lights.Lights.empty();
  double toViewer[3] = { 0.0, 0.0, 1.0 };
  if (!lights.ParallelView)
  {
    std::transform(point, point + 3, toViewer, [](double x) { return -x; });
    vtkMath::Normalize(toViewer);
  }
  double diffuseLight[3] = { 0.0, 0.0, 0.0 };
  double specularLight[3] = { 0.0, 0.0, 0.0 };
  for (const Light& light : lights.Lights)
  {
    const Response response = lights.Complexity == 1
      ? RespondToHeadlight(normal, material.SpecularPower)
      : RespondToLight(
          light, lights.Complexity == 3, point, toViewer, normal, material.SpecularPower);
    for (int i = 0; i < 3; ++i)
    {
      diffuseLight[i] += response.Diffuse * light.Color[i];
      specularLight[i] += response.Specular * light.Color[i];
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    const double color = lit
      ? material.Ambient * ambient[i] + material.Diffuse * diffuse[i] * diffuseLight[i] +
        material.Specular * material.SpecularColor[i] * specularLight[i]
      : material.Ambient * ambient[i] + material.Diffuse * diffuse[i];
    rgb[i] = std::min(std::max(color, 0.0), 1.0);
  }
}
}
