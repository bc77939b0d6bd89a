// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the mean of pictures that is drawn while nothing changes, by the mapper and by the pass:
// it comes closer to a picture with many samples per pixel; it ends at the number that was set;
// every kind of change begins anew, with the very picture that is drawn without accumulation; and
// with a transition time it begins when opacities rest.

#include "FourierOpacityPassTesting.h"
#include "vtkAssembly.h"
#include "vtkLight.h"
#include "vtkPlane.h"

#include <chrono>
#include <memory>
#include <thread>

using namespace FourierOpacityTesting;

namespace
{
// A scene that the mapper or the pass draws: slanted squares without anything opaque.
struct Accumulated
{
  std::unique_ptr<Stage> Scene;
  vtkSmartPointer<vtkFourierOpacityMapper> Mapper;
  vtkSmartPointer<vtkFourierOpacityPass> Pass;
  vtkSmartPointer<vtkActor> Actor;

  Accumulated(bool isPass, int frames, int size = 40)
  {
    if (isPass)
    {
      auto stage = std::make_unique<PassStage>(size, size);
      this->Pass = stage->Pass;
      const SceneSquares squares;
      this->Actor = stage->AddItem(squares.MakePart(0, 2));
      stage->AddItem(squares.MakePart(1, 2))->RotateZ(20.0);
      this->Scene = std::move(stage);
      this->Mapper = vtkFourierOpacityMapper::SafeDownCast(this->Actor->GetMapper());
    }
    else
    {
      auto stage = std::make_unique<OpacityStage>(size, size);
      stage->Mapper->SetInputData(MakeScene());
      this->Mapper = stage->Mapper;
      this->Actor = stage->Actor;
      this->Scene = std::move(stage);
    }
    this->Scene->Renderer->GetActiveCamera()->Roll(17.0);
    this->Scene->Renderer->GetActiveCamera()->Elevation(10.0);
    // VTK makes lookup tables and the like with the first picture.
    this->Render();
    this->GetOptimization()->SetAccumulationFrames(frames);
  }
  Optimization* GetOptimization()
  {
    return this->Pass ? this->Pass->GetOptimization() : this->Mapper->GetOptimization();
  }
  int GetNumber()
  {
    return this->Pass ? this->Pass->GetNumberOfAccumulatedPictures()
                      : this->Mapper->GetNumberOfAccumulatedPictures();
  }
  Picture Render() { return this->Scene->Render(); }
};

void CheckConvergence(Checks& check, const std::string& name, bool isPass, int blending)
{
  Accumulated plain(isPass, 1);
  plain.GetOptimization()->SetBlending(blending);
  plain.GetOptimization()->SetImportanceToExact();
  const Picture once = plain.Render();
  check(plain.GetNumber() == 1, name + ": one picture");
  check(plain.Render().Bytes == once.Bytes, name + ": without accumulation nothing changes");

  Accumulated large(isPass, 1, 160);
  large.GetOptimization()->SetBlending(blending);
  large.GetOptimization()->SetImportanceToExact();
  const Picture samples = large.Render();

  constexpr int largest = 16;
  Accumulated scene(isPass, largest);
  scene.GetOptimization()->SetBlending(blending);
  scene.GetOptimization()->SetImportanceToExact();
  double errors[largest + 3];
  Picture last;
  for (int i = 1; i < largest + 3; ++i)
  {
    const Picture picture = scene.Render();
    check(scene.GetNumber() == std::min(i, largest),
      name + ": number of pictures " + std::to_string(scene.GetNumber()));
    if (i == 1)
    {
      CheckSame(check, name + ": the first picture is that without accumulation", picture, once, 1);
    }
    if (i > largest)
    {
      check(picture.Bytes == last.Bytes, name + ": the mean of all stays as it is");
    }
    errors[i] = GetError(picture, samples);
    last = picture;
  }
  std::cout << name << ": error of 1, 4 and 16 pictures " << errors[1] << " " << errors[4] << " "
            << errors[largest] << "\n";
  check(errors[1] > 1.0 && errors[4] < 0.65 * errors[1] && errors[largest] < 0.4 * errors[1] &&
      errors[largest] < errors[4],
    name + ": the mean comes closer");
}

struct Change
{
  const char* Name;
  std::function<void(Accumulated&)> Apply;
};

const Change Changes[] = {
  { "camera", [](Accumulated& s) { s.Scene->Renderer->GetActiveCamera()->Azimuth(5.0); } },
  // Headlights stay where they are.
  { "roll", [](Accumulated& s) { s.Scene->Renderer->GetActiveCamera()->Roll(5.0); } },
  { "zoom", [](Accumulated& s) { s.Scene->Renderer->GetActiveCamera()->Zoom(1.05); } },
  { "opacity", [](Accumulated& s) { s.Actor->GetProperty()->SetOpacity(0.7); } },
  { "lighting", [](Accumulated& s) { s.Actor->GetProperty()->LightingOn(); } },
  { "colours",
    [](Accumulated& s)
    {
      s.Mapper->ScalarVisibilityOff();
      s.Actor->GetProperty()->SetColor(1.0, 0.5, 0.0);
    } },
  { "place", [](Accumulated& s) { s.Actor->SetPosition(0.1, 0.0, 0.0); } },
  { "input",
    [](Accumulated& s)
    {
      s.Mapper->SetInputData(MakeStack({ { 0.0, 0.0, 0.0, 0.5, { 200, 100, 50, 255 } } }, { 0.0 }));
    } },
  { "points",
    [](Accumulated& s)
    {
      s.Mapper->GetInput()->GetPoints()->SetPoint(0, -0.9, -0.9, 0.8);
      s.Mapper->GetInput()->GetPoints()->Modified();
      s.Mapper->GetInput()->Modified();
    } },
  { "importance", [](Accumulated& s) { s.Mapper->SetImportanceRange(0.0, 2.0); } },
  { "weight", [](Accumulated& s) { s.GetOptimization()->SetForegroundWeight(5.0); } },
  { "emphasis", [](Accumulated& s) { s.GetOptimization()->SetEmphasis(1.0); } },
  { "blending", [](Accumulated& s) { s.GetOptimization()->SetBlendingToWeightedAverage(); } },
  { "number of pictures", [](Accumulated& s) { s.GetOptimization()->SetAccumulationFrames(5); } },
  { "hidden", [](Accumulated& s) { s.Actor->VisibilityOff(); } },
  { "clipping",
    [](Accumulated& s)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(1.0, 0.3, 0.0);
      s.Mapper->AddClippingPlane(plane);
    } },
  { "another actor", [](Accumulated& s) { s.Scene->AddSphere(0.2, 0.1, 0.3, 0.3); } },
  { "size", [](Accumulated& s) { s.Scene->Window->SetSize(50, 36); } },
};

void CheckChanges(Checks& check, bool isPass)
{
  Accumulated scene(isPass, 4);
  Accumulated plain(isPass, 1);
  for (const Change& change : Changes)
  {
    const std::string name = std::string(isPass ? "pass, " : "mapper, ") + change.Name;
    scene.GetOptimization()->SetAccumulationFrames(4);
    scene.Render();
    scene.Render();
    check(scene.GetNumber() > 1, name + ": pictures before");
    change.Apply(scene);
    change.Apply(plain);
    plain.GetOptimization()->SetAccumulationFrames(1);
    const Picture picture = scene.Render();
    // A hidden actor leaves the mapper nothing to count.
    const bool isCounted = scene.Actor->GetVisibility() || isPass;
    check(!isCounted || scene.GetNumber() == 1,
      name + ": begins anew, " + std::to_string(scene.GetNumber()));
    CheckSame(check, name + ": is seen at once", picture, plain.Render(), 1);
    scene.Render();
    check(!isCounted || scene.GetNumber() == 2, name + ": goes on");
    scene.Actor->VisibilityOn();
    plain.Actor->VisibilityOn();
  }
}

// Two actors of one mapper, and one in an assembly: pictures of one do not get into another's mean.
void CheckActors(Checks& check)
{
  OpacityStage stage(32, 32);
  stage.Mapper->SetInputData(MakeStack({ { 0.0, 0.0, 0.0, 0.3, { 250, 120, 30, 255 } } }));
  stage.Actor->SetPosition(-0.5, 0.0, 0.0);
  auto other = stage.Add(stage.Mapper);
  other->GetProperty()->LightingOff();
  other->SetPosition(0.5, 0.0, 0.0);
  stage.Stage::Render();
  stage.GetOptimization()->SetAccumulationFrames(3);
  for (int i = 1; i < 6; ++i)
  {
    const Picture picture = stage.Stage::Render();
    check(stage.Mapper->GetNumberOfAccumulatedPictures() == std::min(i, 3),
      "shared mapper: number of pictures " +
        std::to_string(stage.Mapper->GetNumberOfAccumulatedPictures()));
    for (int x : { 8, 24 })
    {
      CheckColor(check, "mean of a shared mapper", picture.At(x, 16), { 250, 120, 30 }, 1.0);
    }
  }

  OpacityStage parts(32, 32);
  vtkNew<vtkAssembly> assembly;
  auto data = MakeStack({ { 0.0, 0.0, 0.0, 0.3, { 250, 120, 30, 255 } } });
  parts.Mapper->SetInputData(data);
  assembly->AddPart(parts.Actor);
  parts.Renderer->RemoveActor(parts.Actor);
  parts.Renderer->AddActor(assembly);
  parts.Stage::Render();
  parts.GetOptimization()->SetAccumulationFrames(3);
  for (int i = 0; i < 3; ++i)
  {
    CheckColor(
      check, "part of an assembly", parts.Stage::Render().At(16, 16), { 250, 120, 30 }, 1.0);
  }
  data->GetCellData()->GetScalars()->Fill(255.0);
  data->GetCellData()->GetScalars()->Modified();
  data->Modified();
  CheckColor(check, "changed data of a part of an assembly", parts.Stage::Render().At(16, 16),
    { 255, 255, 255 }, 1.0);
}

// Lights change what is lit; halos have the colour of the background.
void CheckLights(Checks& check, bool isPass)
{
  Accumulated scene(isPass, 4);
  scene.Actor->GetProperty()->LightingOn();
  scene.Actor->GetProperty()->SetAmbient(0.3);
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.GetOptimization()->SetHaloWidth(2.0);
  vtkNew<vtkLight> light;
  light->SetPosition(3.0, 4.0, 5.0);
  scene.Scene->Renderer->AddLight(light);
  vtkNew<vtkLight> second;
  second->SetPosition(3.0, -4.0, 5.0);
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "intensity", [&] { light->SetIntensity(0.8); } },
    { "colour", [&] { light->SetDiffuseColor(0.3, 0.9, 1.0); } },
    { "specular colour", [&] { light->SetSpecularColor(0.3, 0.9, 1.0); } },
    { "ambient colour", [&] { light->SetAmbientColor(0.3, 0.3, 0.1); } },
    { "position", [&] { light->SetPosition(-3.0, 4.0, 5.0); } },
    { "focal point", [&] { light->SetFocalPoint(0.5, 0.0, 0.0); } },
    { "kind", [&] { light->PositionalOn(); } },
    { "cone", [&] { light->SetConeAngle(10.0); } },
    { "exponent", [&] { light->SetExponent(3.0); } },
    { "attenuation", [&] { light->SetAttenuationValues(0.5, 0.1, 0.0); } },
    { "another light", [&] { scene.Scene->Renderer->AddLight(second); } },
    { "off", [&] { second->SwitchOff(); } },
    { "background", [&] { scene.Scene->Renderer->SetBackground(0.3, 0.3, 0.3); } },
  };
  for (const auto& change : changes)
  {
    scene.Render();
    scene.Render();
    check(scene.GetNumber() >= 2, std::string(change.first) + ": pictures before");
    change.second();
    scene.Render();
    check(scene.GetNumber() == 1,
      std::string(isPass ? "pass, " : "mapper, ") + change.first + " of a light: begins anew");
  }
}

// While opacities follow, each picture stands by itself, as bright as ever.
void CheckTransition(Checks& check, bool isPass)
{
  const std::string name = isPass ? "pass, " : "mapper, ";
  const auto sleep = [](int milliseconds)
  { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); };
  Accumulated plain(isPass, 1);
  const Picture before = plain.Render();
  plain.GetOptimization()->SetForegroundWeight(0.0);
  plain.GetOptimization()->SetBackgroundWeight(0.0);
  const Picture goal = plain.Render();
  check(Compare(before, goal).Largest > 40, name + "there is something to follow");

  Accumulated scene(isPass, 4);
  scene.GetOptimization()->SetTransitionTime(60.0);
  for (int i = 0; i < 4; ++i)
  {
    CheckSame(check, name + "pictures while opacities may follow", scene.Render(), before, 1);
    check(scene.GetNumber() == 1, name + "no mean while opacities may follow");
  }
  // Rendered once in a while: opacities arrive before pictures are added.
  scene.GetOptimization()->SetTransitionTime(0.1);
  scene.Render();
  scene.GetOptimization()->SetForegroundWeight(0.0);
  scene.GetOptimization()->SetBackgroundWeight(0.0);
  scene.Render();
  check(scene.GetNumber() == 1, name + "a change begins anew");
  sleep(350);
  CheckSame(check, name + "opacities have arrived", scene.Render(), goal, 2);
  check(scene.GetNumber() == 1, name + "the first one at rest");
  for (int i = 2; i < 7; ++i)
  {
    scene.Render();
    check(scene.GetNumber() == std::min(i, 4), name + "the mean goes on at rest");
  }
}
}

int TestFourierOpacityAccumulation(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  for (int blending : { Optimization::Fourier, Optimization::FragmentLists })
  {
    CheckConvergence(check, std::string("mapper, ") + MethodNames[blending], false, blending);
  }
  CheckConvergence(check, "pass", true, Optimization::Fourier);
  CheckActors(check);
  for (bool isPass : { false, true })
  {
    CheckChanges(check, isPass);
    CheckLights(check, isPass);
    CheckTransition(check, isPass);
  }
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
