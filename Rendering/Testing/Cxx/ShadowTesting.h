// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of shadows and ambient occlusion in vtkVoxelLineMapper share: a floor of bars with
 * another bar above it, lights that are fixed in the scene, and brightness.
 */

#ifndef ShadowTesting_h
#define ShadowTesting_h

#include "VoxelLineReferenceTesting.h"

#include "vtkLight.h"
#include "vtkLineGlobalIllumination.h"

namespace VoxelLineMapperTesting
{
constexpr double BarRadius = 0.03;
constexpr double BarHeight = 0.5;

/// Bars along x in the plane z = 0 that touch each other, and one along y above them.
inline std::vector<Curve> MakeFloor(bool withBar)
{
  std::vector<Curve> bars;
  for (int i = -20; i <= 20; ++i)
  {
    bars.push_back({ { -1.0, 0.05 * i, 0.0 }, { 1.0, 0.05 * i, 0.0 } });
  }
  if (withBar)
  {
    bars.push_back({ { 0.0, -1.0, BarHeight }, { 0.0, 1.0, BarHeight } });
  }
  return bars;
}

/// A white light that is fixed in the scene and shines from a point towards the origin.
inline vtkSmartPointer<vtkLight> MakeLight(
  const Point& from, bool isPositional = false, double coneAngle = 90.0)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(from[0], from[1], from[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPositional(isPositional);
  light->SetConeAngle(coneAngle);
  light->SetExponent(0.0);
  return light;
}

/// A small picture of lines with one light, seen along z.
struct ShadowStage
{
  Stage View;
  vtkNew<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  vtkLineGlobalIllumination* Light;

  explicit ShadowStage(vtkPolyData* lines, vtkLight* light, int width = 160, int height = 60)
    : View(width, height)
  {
    this->Mapper->SetInputData(lines);
    this->Mapper->SetEngineToNative();
    this->Mapper->SetResolution(64);
    this->Mapper->SetRadius(BarRadius);
    this->Light = this->Mapper->GetGlobalIllumination();
    this->Actor = this->View.Add(this->Mapper);
    this->Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->View.Renderer->SetBackground(0.0, 0.0, 0.0);
    LookAlongZ(this->View);
    this->View.Renderer->GetActiveCamera()->SetParallelScale(0.4);
    this->SetLight(light);
  }

  void SetLight(vtkLight* light)
  {
    this->View.Renderer->RemoveAllLights();
    this->View.Renderer->AddLight(light);
  }

  void LookInPerspective()
  {
    vtkCamera* camera = this->View.Renderer->GetActiveCamera();
    camera->ParallelProjectionOff();
    camera->SetPosition(0.0, 0.0, 4.0);
    camera->SetViewAngle(12.0);
    camera->SetClippingRange(1.0, 20.0);
  }

  Picture Render(int shadows, int occlusion = vtkLineGlobalIllumination::NoOcclusion)
  {
    this->Light->SetShadows(shadows);
    this->Light->SetOcclusion(occlusion);
    return this->View.Render();
  }

  /// Column of the picture in which a point in the plane y = 0 is seen, in pixels.
  double GetColumn(double x, double z)
  {
    vtkRenderer* renderer = this->View.Renderer;
    renderer->SetWorldPoint(x, 0.0, z, 1.0);
    renderer->WorldToDisplay();
    return renderer->GetDisplayPoint()[0];
  }
};

inline double GetBrightness(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum;
}

/// How much of the light is missing in each column of a picture, 0 to 1, over its middle rows.
inline std::vector<double> GetLoss(const Picture& with, const Picture& without)
{
  std::vector<double> loss(static_cast<std::size_t>(with.Width), 0.0);
  for (int x = 0; x < with.Width; ++x)
  {
    double bright = 0.0;
    double lost = 0.0;
    for (int y = with.Height / 4; y < 3 * with.Height / 4; ++y)
    {
      bright += without.At(x, y)[0];
      lost += without.At(x, y)[0] - with.At(x, y)[0];
    }
    loss[static_cast<std::size_t>(x)] = bright > 0.0 ? lost / bright : 0.0;
  }
  return loss;
}

/// A shadow in a row of losses: where it lies, its width as a standard deviation, both in pixels,
/// how dark it is, and its sum.
struct ShadowProfile
{
  double Centre = 0.0;
  double Width = 0.0;
  double Depth = 0.0;
  double Sum = 0.0;

  explicit ShadowProfile(
    const std::vector<double>& loss, double middle = 0.0, double halfWidth = 1e9)
  {
    double square = 0.0;
    for (std::size_t x = 0; x < loss.size(); ++x)
    {
      if (std::abs(static_cast<double>(x) + 0.5 - middle) > halfWidth)
      {
        continue;
      }
      const double at = static_cast<double>(x) + 0.5;
      this->Sum += loss[x];
      this->Centre += at * loss[x];
      square += at * at * loss[x];
      this->Depth = std::max(this->Depth, loss[x]);
    }
    if (this->Sum > 0.0)
    {
      this->Centre /= this->Sum;
      this->Width = std::sqrt(std::max(square / this->Sum - this->Centre * this->Centre, 0.0));
    }
  }

  std::string Describe() const
  {
    std::ostringstream text;
    text << "centre " << this->Centre << ", width " << this->Width << ", depth " << this->Depth
         << ", sum " << this->Sum;
    return text.str();
  }
};
}

#endif
