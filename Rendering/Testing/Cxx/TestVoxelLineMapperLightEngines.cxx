// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that both engines draw the same shadows and ambient occlusion of every kind, opaque and
// transparent, by lights of several kinds; also after the model or its opacity changed.
#include "ShadowTesting.h"

using namespace VoxelLineMapperTesting;

namespace
{
using Global = vtkLineGlobalIllumination;

struct Case
{
  std::string Name;
  int Shadows;
  int Occlusion;
  double Opacity;
};

// Software OpenGL ends all loops of a shader after 65535 rounds together: few lines, few rays.
vtkSmartPointer<vtkPolyData> MakeFewLines()
{
  std::vector<Curve> curves = MakeStraightLines(6, 3);
  const std::vector<Curve> bent = MakeBundle(3, 30, 2);
  curves.insert(curves.end(), bent.begin(), bent.end());
  return MakeLines(curves);
}

void CheckSame(Checks& check, const Case& test, ShadowStage* const stages[2])
{
  const Picture plain = stages[0]->Render(Global::NoShadows);
  Picture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    pictures[i] = stages[i]->Render(test.Shadows, test.Occlusion);
    check(stages[i]->Mapper->GetEngineInUse() == stages[i]->Mapper->GetEngine(),
      test.Name + ": the engine that was set");
  }
  const Difference difference = Compare(pictures[0], pictures[1]);
  const double light = GetBrightness(pictures[0]) / GetBrightness(plain);
  std::cout << test.Name << ": light " << light << Describe(difference) << "\n";
  check(light < 0.99, test.Name + ": some light is missing");
  // Single pixels at the edges of tubes and of shadows may fall to either side.
  check(difference.Part <= 4.0 / (36.0 * 30.0), test.Name + Describe(difference));
}

void TestKinds(Checks& check)
{
  const std::vector<Case> cases = { { "hard shadows, hemispheres by densities", Global::HardShadows,
                                      Global::HemisphereDensity, 0.4 },
    { "level shadows, spherical occlusion", Global::LevelShadows, Global::SphericalOcclusion, 1.0 },
    { "soft shadows, hemispheres by tubes", Global::SoftShadows, Global::HemisphereTubes, 0.5 } };
  const auto lines = MakeFewLines();
  ShadowStage native(lines, MakeLight({ 1.5, 0.4, 2.0 }), 36, 30);
  ShadowStage shader(lines, MakeLight({ 1.5, 0.4, 2.0 }), 36, 30);
  ShadowStage* const stages[2] = { &native, &shader };
  for (int i = 0; i < 2; ++i)
  {
    ShadowStage& stage = *stages[i];
    stage.Mapper->SetEngine(i == 0 ? vtkVoxelLineMapper::Native : vtkVoxelLineMapper::Shader);
    stage.Mapper->SetResolution(16);
    stage.Mapper->SetRadius(0.08);
    stage.Light->SetOcclusionSamples(6);
    stage.Light->SetOcclusionStrength(1.3);
    stage.Light->SetShadowConeAngle(18.0);
    stage.View.Renderer->AddLight(MakeLight({ -1.0, 2.0, 1.5 }, true, 30.0));
    vtkNew<vtkLight> head;
    head->SetLightTypeToHeadlight();
    head->SetIntensity(0.2);
    stage.View.Renderer->AddLight(head);
    stage.View.Renderer->GetActiveCamera()->SetParallelScale(1.0);
    stage.Actor->SetScale(1.0, 0.8, 1.1);
  }
  for (const Case& test : cases)
  {
    for (ShadowStage* stage : stages)
    {
      stage->Actor->GetProperty()->SetOpacity(test.Opacity);
    }
    CheckSame(check, test, stages);
  }
  // Another opacity and another model: the shader engine must bring its copies up to date.
  for (ShadowStage* stage : stages)
  {
    stage->Actor->GetProperty()->SetOpacity(0.7);
    stage->Mapper->SetResolution(13);
  }
  CheckSame(check,
    { "soft shadows of another model", Global::SoftShadows, Global::HemisphereDensity, 0.7 },
    stages);
}
}

int TestVoxelLineMapperLightEngines(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  TestKinds(check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
