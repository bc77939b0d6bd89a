// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards shadows and ambient occlusion where things are at their limits:
// - the shader engine draws the same in a second window after the first one was closed,
// - wide tubes in dense lines: depths far beyond any table are dark, and nothing breaks,
// - a model with a brick without voxels is drawn,
// - rays that end at their first line (EarlyTermination 0) cast shadows of translucent lines all
// the
//   same,
// - accumulation where there is no translucent pass: lines do not vanish for more than a frame,
// - a warning that has to do with lights is said once, however often the lines change.
#include "RenderPassTesting.h"
#include "ShadowTesting.h"

#include "vtkDataArray.h"

using namespace VoxelLineMapperTesting;

namespace
{
using Global = vtkLineGlobalIllumination;

void TestSecondWindow(Checks& check)
{
  for (const bool isLit : { false, true })
  {
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetInputData(MakeLines(MakeStraightLines(12, 3)));
    mapper->SetResolution(16);
    mapper->SetRadius(0.06);
    mapper->SetEngineToShader();
    mapper->GetGlobalIllumination()->SetShadows(isLit ? Global::SoftShadows : Global::NoShadows);
    mapper->GetGlobalIllumination()->SetOcclusion(
      isLit ? Global::SphericalOcclusion : Global::NoOcclusion);
    Picture pictures[2];
    for (Picture& picture : pictures)
    {
      Stage stage(40, 30);
      stage.Add(mapper);
      stage.Renderer->AddLight(MakeLight({ 1.0, 0.5, 1.0 }));
      LookAlongZ(stage);
      picture = stage.Render();
      stage.Window->Finalize();
    }
    check(GetCoverage(pictures[0], Background) > 0.1, "lines are seen");
    check(Compare(pictures[0], pictures[1]).Largest == 0,
      std::string(isLit ? "lit" : "plain") + ": the same in a second window");
  }
}

void TestDenseTubes(Checks& check)
{
  std::vector<Curve> curves(1500, Curve{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } });
  ShadowStage stage(MakeLines(curves), MakeLight({ 1.0, 0.5, 1.0 }), 40, 30);
  stage.Mapper->SetResolution(256);
  stage.Mapper->SetRadius(3.0);
  stage.View.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  const double plain = GetBrightness(stage.Render(Global::NoShadows));
  const double lit = GetBrightness(stage.Render(Global::SoftShadows, Global::SphericalOcclusion));
  std::cout << "dense: " << plain << " without, " << lit << " with occlusion\n";
  check(plain > 0.1 && lit < 0.2 * plain, "dense wide tubes are dark");
}

void TestEmptyBrick(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> maker;
  maker->SetInputData(MakeLines(MakeStraightLines(12, 3)));
  maker->SetResolution(16);
  vtkNew<vtkVoxelLineModel> model;
  model->DeepCopy(maker->GetModel());
  model->GetBricks()->SetComponent(0, 0, 0.0);
  model->GetBricks()->SetComponent(0, 1, 0.0);
  ShadowStage stage(nullptr, MakeLight({ 1.0, 0.5, 1.0 }), 40, 30);
  stage.Mapper->SetInputData(model.Get());
  const Picture picture = stage.Render(Global::SoftShadows, Global::SphericalOcclusion);
  check(GetBrightness(picture) > 0.0, "a model with a brick without voxels is drawn");
}

void TestEarlyRays(Checks& check)
{
  ShadowStage stage(MakeLines(MakeFloor(true)), MakeLight({ 0.8, 0.0, 1.0 }));
  stage.Actor->GetProperty()->SetOpacity(0.9);
  double losses[2];
  int i = 0;
  for (const double early : { 0.99, 0.0 })
  {
    stage.Mapper->SetEarlyTermination(early);
    losses[i++] = 1.0 -
      GetBrightness(stage.Render(Global::HardShadows)) /
        GetBrightness(stage.Render(Global::NoShadows));
  }
  std::cout << "shadows take " << losses[0] << ", where rays end early " << losses[1] << "\n";
  check(losses[0] > 0.01 && losses[1] > 0.5 * losses[0], "rays to lights do not end early");
}

void TestOpaquePassOnly(Checks& check)
{
  Stage stage(60, 40);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(3, 60));
  mapper->SetRadius(0.1);
  mapper->SetAccumulationFrames(4);
  stage.Add(mapper);
  LookAlongZ(stage);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(camera);
  int missing = 0;
  for (int frame = 0; frame < 6; ++frame)
  {
    missing += GetCoverage(stage.Render(), Background) < 0.05 ? 1 : 0;
  }
  std::cout << "without a translucent pass lines are missing in " << missing << " of 6 frames\n";
  check(missing <= 1, "lines do not vanish without a translucent pass");
}

void TestWarnings(Checks& check, Messages* messages)
{
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  ShadowStage stage(MakeLines(MakeFloor(true)), head, 40, 30);
  for (int frame = 0; frame < 3; ++frame)
  {
    stage.Mapper->SetInputData(MakeLines(MakeStraightLines(4 + frame, 3)));
    stage.Render(Global::SoftShadows);
  }
  check(messages->TakeWarnings("headlights") == 1, "told once, though the lines change");
}
}

int TestVoxelLineMapperLightLimits(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  TestSecondWindow(check);
  TestDenseTubes(check);
  TestEmptyBrick(check);
  TestEarlyRays(check);
  TestOpaquePassOnly(check);
  messages->TakeWarnings("radius"); // of the dense tubes
  TestWarnings(check, messages);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
