// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of receivers share: a tangle of lines that casts, tubes that receive, and a stage
 * with two lights.
 */

#ifndef VoxelLineReceiverTesting_h
#define VoxelLineReceiverTesting_h

#include "VoxelLineMapperTesting.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkTubeFilter.h"

#include <functional>

namespace VoxelLineReceiverTesting
{
using namespace VoxelLineMapperTesting;
using Global = vtkLineGlobalIllumination;

constexpr double Radius = 0.03;

// Lines in a tangle, so that about half of what is seen lies in shadow.
inline vtkSmartPointer<vtkPolyData> MakeTangle()
{
  std::vector<Curve> curves(24);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const double phase = 0.7 * static_cast<double>(i);
    for (int k = 0; k <= 120; ++k)
    {
      const double s = 0.05 * k + phase;
      curves[i].push_back({ std::cos(1.1 * s + phase) * (0.6 + 0.3 * std::sin(2.3 * phase)),
        std::sin(0.9 * s) * (0.5 + 0.3 * std::cos(1.7 * phase)),
        0.8 * std::sin(0.6 * s + 2.0 * phase) });
    }
  }
  return MakeLines(curves);
}

inline vtkSmartPointer<vtkVoxelLineMapper> MakeCaster(vtkPolyData* lines)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(Radius);
  mapper->SetResolution(64);
  return mapper;
}

inline vtkSmartPointer<vtkMapper> MakeTubes(vtkPolyData* lines)
{
  vtkNew<vtkTubeFilter> filter;
  filter->SetInputData(lines);
  filter->SetRadius(Radius);
  filter->SetNumberOfSides(16);
  filter->CappingOn();
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(filter->GetOutputPort());
  return mapper;
}

// A stage with light from above and from aside.
struct LitStage : Stage
{
  LitStage(int width = 160, int height = 160, bool local = false)
    : Stage(width, height)
  {
    SetScene(this->Renderer, local);
  }

  static void SetScene(vtkRenderer* renderer, bool local)
  {
    renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1.0, 4.0, 2.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPositional(local);
    light->SetConeAngle(90.0);
    renderer->AddLight(light);
    vtkNew<vtkLight> other;
    other->SetLightTypeToSceneLight();
    other->SetPosition(-3.0, 0.0, 2.0);
    other->SetIntensity(0.4);
    renderer->AddLight(other);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(2.4, 1.6, 2.8);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetClippingRange(1.5, 7.0);
    renderer->SetBackground(26.0 / 255.0, 0.2, 0.4);
  }
};

inline void SetUp(vtkProperty* property)
{
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.3);
  property->SetSpecularPower(20.0);
}

// What a receiver looks like by itself: a stage made anew.
using Change = std::function<void(vtkVoxelLineMapper* caster, vtkActor* tubes, LitStage& stage)>;

struct Reception
{
  LitStage Stage{ 64, 64 };
  vtkSmartPointer<vtkVoxelLineMapper> Caster;
  vtkSmartPointer<vtkActor> Actor;

  explicit Reception(vtkMapper* mapper, const Change& change = nullptr)
  {
    this->Caster = MakeCaster(MakeTangle());
    this->Caster->GetGlobalIllumination()->SetShadowsToSoft();
    this->Caster->GetGlobalIllumination()->SetOcclusionToSpherical();
    this->Actor = this->Stage.Add(mapper);
    SetUp(this->Actor->GetProperty());
    this->Caster->AddReceiver(this->Actor);
    if (change)
    {
      change(this->Caster, this->Actor, this->Stage);
    }
  }
  Picture Render() { return this->Stage.Render(); }
};

// Not brighter anywhere, and darker somewhere. Returns the part that is darker.
inline double CheckDarker(
  Checks& check, const Picture& plain, const Picture& lit, const std::string& what, int most = 1)
{
  std::size_t darker = 0;
  int brightest = 0;
  for (std::size_t i = 0; i < plain.Bytes.size(); ++i)
  {
    darker += lit.Bytes[i] + 4 < plain.Bytes[i] ? 1 : 0;
    brightest = std::max(brightest, lit.Bytes[i] - plain.Bytes[i]);
  }
  const double part = static_cast<double>(darker) / static_cast<double>(plain.Bytes.size());
  check(brightest <= most, what + " is nowhere brighter: " + std::to_string(brightest));
  check(part > 0.02, what + " is darker somewhere: " + std::to_string(part));
  return part;
}
}

#endif
