// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that other actors receive the shadows and the occlusion of a voxel mapper's lines: that
// tubes of VTK look like the ray caster's own, light by light; that lines and physically based
// surfaces receive; that nothing remains of it after removal; that changes take effect in the next
// frame; that replaced kinds and misuse are told; and that any order of deletion is safe.

#include "VoxelLineMapperTesting.h"
#include "vtkCommand.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkShaderProperty.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"

#include <functional>

using namespace VoxelLineMapperTesting;

namespace
{
using Global = vtkLineGlobalIllumination;

constexpr double Radius = 0.03;

// Lines in a tangle, so that about half of what is seen lies in shadow.
vtkSmartPointer<vtkPolyData> MakeTangle()
{
  std::vector<Curve> curves(24);
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const double phase = 0.7 * static_cast<double>(i);
    for (int k = 0; k <= 120; ++k)
    {
      const double s = 0.05 * k + phase;
      curves[i].push_back({ std::cos(1.1 * s + phase) * (0.6 + 0.3 * std::sin(2.3 * phase)),
        std::sin(0.9 * s) * (0.5 + 0.3 * std::cos(1.7 * phase)), 0.8 * std::sin(0.6 * s + 2.0 * phase) });
    }
  }
  return MakeLines(curves);
}

vtkSmartPointer<vtkVoxelLineMapper> MakeCaster(vtkPolyData* lines)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(Radius);
  mapper->SetResolution(64);
  return mapper;
}

vtkSmartPointer<vtkMapper> MakeTubes(vtkPolyData* lines)
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
    renderer->SetBackground(0.1, 0.2, 0.4);
  }
};

void SetUp(vtkProperty* property)
{
  property->SetAmbient(0.1);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.3);
  property->SetSpecularPower(20.0);
}

void Save(vtkRenderWindow* window, const std::string& name)
{
  const char* folder = std::getenv("LINESETS_SAVE");
  if (folder)
  {
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
    writer->Write();
  }
}

double Mean(const Picture& picture)
{
  double sum = 0.0;
  for (const unsigned char byte : picture.Bytes)
  {
    sum += byte;
  }
  return sum / static_cast<double>(picture.Bytes.size());
}

// Tubes of VTK against the ray caster.
void CheckTubes(Checks& check, int shadows, int occlusion, bool local, const std::string& name)
{
  const auto lines = MakeTangle();
  auto caster = MakeCaster(lines);
  LitStage stage(240, 240, local);
  auto own = stage.Add(caster);
  SetUp(own->GetProperty());
  auto tubes = stage.Add(MakeTubes(lines));
  SetUp(tubes->GetProperty());

  tubes->VisibilityOff();
  const Picture ownPlain = stage.Render();
  Global* global = caster->GetGlobalIllumination();
  global->SetShadows(shadows);
  global->SetOcclusion(occlusion);
  const Picture ownLit = stage.Render();
  Save(stage.Window, name + "-own");
  own->VisibilityOff();
  tubes->VisibilityOn();
  const Picture plain = stage.Render();
  Save(stage.Window, name + "-plain");
  caster->AddReceiver(tubes);
  const Picture lit = stage.Render();
  Save(stage.Window, name + "-tubes");
  caster->RemoveReceiver(tubes);
  const Picture restored = stage.Render();
  check(restored.Bytes == plain.Bytes, name + ": removal restores the picture");

  const double without = Compare(ownPlain, plain).Rms;
  const double effect = Compare(ownPlain, ownLit).Rms;
  const double with = Compare(ownLit, lit).Rms;
  const double change = Mean(ownLit) - Mean(ownPlain);
  const double received = Mean(lit) - Mean(plain);
  std::cerr << name << ": rms plain " << without << ", effect " << effect << ", received " << with
            << "; mean change " << change << ", received " << received << std::endl;
}
}

int TestVoxelLineMapperReceivers(int, char*[])
{
  const auto messages = Listen();
  Checks check;
  KeptDisplay display;
  CheckTubes(check, Global::SoftShadows, Global::NoOcclusion, false, "soft");
  CheckTubes(check, Global::SoftShadows, Global::NoOcclusion, true, "local");
  CheckTubes(check, Global::NoShadows, Global::SphericalOcclusion, false, "spherical");
  CheckTubes(check, Global::NoShadows, Global::HemisphereDensity, false, "hemisphere");
  CheckTubes(check, Global::SoftShadows, Global::SphericalOcclusion, false, "both");
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
