// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that tubes thinner than a pixel keep the brightness of the picture: along a zoom, in which
// tubes go from 4 pixels of width to 0.2, by both engines, opaque and transparent; and against the
// reference, in double precision and averaged over 64 rays per pixel. Without coverage the same
// measures are far worse.

#include "VoxelLineReferenceTesting.h"

#include "vtkLight.h"

#include <chrono>
#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double TubeRadius = 0.0075;

// Straight and curved lines in all directions in a ball of radius 1 around the origin.
vtkSmartPointer<vtkPolyData> MakeSparseBundle()
{
  std::vector<Curve> curves;
  for (int i = 0; i < 120; ++i)
  {
    linesets::Random random(11, static_cast<std::uint64_t>(i));
    Point center;
    Point along;
    Point aside;
    for (int k = 0; k < 3; ++k)
    {
      center[k] = random.Uniform(-0.45, 0.45);
      along[k] = random.Uniform(-1.0, 1.0);
      aside[k] = random.Uniform(-1.0, 1.0);
    }
    vtkMath::Normalize(along.data());
    vtkMath::Normalize(aside.data());
    const double bend = i % 2 == 0 ? 0.0 : 0.15;
    Curve curve;
    for (int j = 0; j <= 40; ++j)
    {
      const double s = j / 20.0 - 1.0;
      Point x;
      for (int k = 0; k < 3; ++k)
      {
        x[k] = center[k] + 0.4 * s * along[k] + bend * std::sin(4.0 * s) * aside[k];
      }
      curve.push_back(x);
    }
    curves.push_back(curve);
  }
  auto lines = MakeLines(curves);
  vtkNew<vtkDoubleArray> t;
  t->SetName("t");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    t->InsertNextValue(static_cast<double>(i % 41) / 40.0);
  }
  lines->GetPointData()->SetScalars(t);
  return lines;
}

// A light of the scene that is the same wherever the camera stands.
void AddLight(vtkRenderer* renderer, const Point& position, const Point& color, bool positional)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(color.data());
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  renderer->AddLight(light);
}

// The bundle on black, by three lights, none of which makes a colour reach its end.
class Bundle
{
public:
  explicit Bundle(int size)
    : Scene(size, size)
  {
    this->Mapper->SetInputData(MakeSparseBundle());
    this->Mapper->SetRadius(TubeRadius);
    this->Mapper->SetEarlyTermination(1.0);
    this->Actor = this->Scene.Add(this->Mapper);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetAmbient(0.1);
    property->SetDiffuse(0.6);
    property->SetSpecular(0.25);
    property->SetSpecularPower(15.0);
    vtkRenderer* renderer = this->Scene.Renderer;
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->AutomaticLightCreationOff();
    AddLight(renderer, { 3.0, 4.0, 5.0 }, { 0.7, 0.6, 0.5 }, false);
    AddLight(renderer, { -4.0, 0.0, 2.0 }, { 0.3, 0.4, 0.5 }, false);
    AddLight(renderer, { 0.0, -3.0, 3.0 }, { 0.3, 0.3, 0.3 }, true);
  }

  // Tubes become this many pixels wide, by the scale of a parallel view or by the distance.
  void SetWidth(double pixels, bool parallel)
  {
    const double worldPerPixel = 2.0 * TubeRadius / pixels;
    const double height = worldPerPixel * this->Scene.Window->GetSize()[1];
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * height);
    camera->SetViewAngle(4.0);
    const double distance =
      parallel ? 10.0 : 0.5 * height / std::tan(0.5 * vtkMath::RadiansFromDegrees(4.0));
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.36 * distance, 0.48 * distance, 0.8 * distance);
    camera->SetViewUp(0.0, 1.0, 0.0);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  Stage Scene;
  vtkNew<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
};

// Light of the picture; the background is black.
double GetLight(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum;
}

/// Widths from 4 pixels to 0.2, the largest first.
std::vector<double> GetWidths()
{
  std::vector<double> widths;
  for (int i = 0; i <= 15; ++i)
  {
    widths.push_back(4.0 * std::pow(0.05, i / 15.0));
  }
  return widths;
}

struct Steadiness
{
  /// Largest change of light per area of the bundle between neighbouring steps, and over all.
  double Step = 0.0;
  double Range = 0.0;
};

Steadiness Zoom(Bundle& bundle, const std::vector<double>& widths, bool parallel)
{
  Steadiness result;
  double last = 0.0;
  double lowest = std::numeric_limits<double>::max();
  double highest = 0.0;
  for (const double width : widths)
  {
    bundle.SetWidth(width, parallel);
    const double light = GetLight(bundle.Scene.Render()) / (width * width);
    std::cout << " " << width << ": " << light;
    result.Step = last > 0.0 ? std::max(result.Step, std::abs(light / last - 1.0)) : 0.0;
    last = light;
    lowest = std::min(lowest, light);
    highest = std::max(highest, light);
  }
  result.Range = highest / lowest - 1.0;
  std::cout << std::endl;
  return result;
}

void CheckZooms(Checks& check)
{
  Bundle bundle(700);
  bundle.Mapper->SetEngineToNative();
  for (const bool parallel : { true, false })
  {
    for (const double opacity : { 1.0, 0.25 })
    {
      const std::string name = std::string(parallel ? "parallel" : "perspective") +
        (opacity < 1.0 ? ", transparent" : ", opaque");
      bundle.Actor->GetProperty()->SetOpacity(opacity);
      bundle.Mapper->SubPixelCoverageOn();
      const Steadiness on = Zoom(bundle, GetWidths(), parallel);
      bundle.Mapper->SubPixelCoverageOff();
      const Steadiness off = Zoom(bundle, GetWidths(), parallel);
      std::cout << name << ": with coverage " << on.Step << " per step, " << on.Range
                << " over all; without " << off.Step << ", " << off.Range << std::endl;
      check(on.Step <= 0.02, name + ": light from step to step");
      check(on.Range <= 0.04, name + ": light over all");
    }
  }
}
}

int TestVoxelLineMapperZoom(int argc, char* argv[])
{
  (void)argc;
  (void)argv;
  Checks check;
  const KeptDisplay display;
  CheckZooms(check);
  return check.GetResult();
}
