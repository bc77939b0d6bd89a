// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkView.h"

#include "BenchmarkMethod.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
namespace
{
constexpr double DegreesPerFrame = 2.0;
constexpr double ViewAngle = 30.0; // degrees
}

//------------------------------------------------------------------------------
void PlaceCamera(const BenchmarkInput& input, int frame)
{
  const double* bounds = input.Bounds;
  double center[3];
  double diagonal = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    const double side = bounds[2 * i + 1] - bounds[2 * i] + 2.0 * input.Radius;
    diagonal += side * side;
  }
  const double reach = 0.5 * std::sqrt(diagonal);
  vtkCamera* camera = input.Camera;
  camera->SetViewAngle(ViewAngle);
  // A sphere about the bounds touches the border of the shorter side of the image at 1; corners are
  // mostly empty, so that the camera can be closer.
  const double aspect = static_cast<double>(input.Options.Width) / input.Options.Height;
  const double halfAngle = vtkMath::RadiansFromDegrees(0.5 * ViewAngle);
  const double distance = input.Closeness * reach /
    std::sin(aspect < 1.0 ? std::atan(aspect * std::tan(halfAngle)) : halfAngle);
  double direction[3] = { 0.55, -0.75, 0.36 };
  vtkMath::Normalize(direction);
  camera->SetFocalPoint(center);
  camera->SetPosition(center[0] + distance * direction[0], center[1] + distance * direction[1],
    center[2] + distance * direction[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->Azimuth(DegreesPerFrame * frame);
  camera->OrthogonalizeViewUp();
  // vtkCamera::Zoom() divides the angle, which would be a half turn and more for small zooms.
  camera->SetViewAngle(
    2.0 * vtkMath::DegreesFromRadians(std::atan(std::tan(halfAngle) / input.Options.Zoom)));
  camera->SetClippingRange(
    std::max(0.01 * distance, distance - 1.01 * reach), distance + 1.01 * reach);
}

//------------------------------------------------------------------------------
double GetPixelRadius(const BenchmarkInput& input)
{
  const double height = 2.0 * input.Camera->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(0.5 * input.Camera->GetViewAngle()));
  return input.Radius / height * input.Options.Height;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeLightFromRight(vtkCamera* camera)
{
  // In coordinates in which the camera looks from (0, 0, 1) to the origin.
  const double place[4] = { 1.0, 0.4, 0.7, 1.0 };
  double position[4];
  camera->GetCameraLightTransformMatrix()->MultiplyPoint(place, position);
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(camera->GetFocalPoint());
  return light;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkLight>> MakeLights(const std::string& name, vtkCamera* camera)
{
  std::vector<vtkSmartPointer<vtkLight>> lights;
  if (name != "headlight")
  {
    lights.push_back(MakeLightFromRight(camera));
  }
  if (name == "studio")
  {
    lights.push_back(vtkSmartPointer<vtkLight>::New());
    lights.back()->SetLightTypeToHeadlight();
    lights.back()->SetIntensity(0.5);
  }
  return lights;
}
}
