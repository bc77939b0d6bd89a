// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that other actors receive the shadows and the occlusion of a voxel mapper's lines: that
// tubes of VTK look like the ray caster's own, light by light; that lines and physically based
// surfaces receive; that nothing remains of it after removal; that changes take effect in the next
// frame; that replaced kinds and misuse are told; and that any order of deletion is safe.

#include "VoxelLineReceiverTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkShaderProperty.h"
#include "vtkWindowToImageFilter.h"

using namespace VoxelLineReceiverTesting;

namespace
{
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

// What shadows change in a picture, and how much less or more they change in another one where
// both agree without shadows: not at edges, where tubes of triangles end in other pixels than
// round ones.
struct Inside
{
  double EffectRms = 0.0;
  double EffectMean = 0.0;
  double Rms = 0.0;
  double Mean = 0.0;
  double Part = 0.0;

  Inside(const Picture& plainA, const Picture& a, const Picture& plainB, const Picture& b)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.Bytes.size(); ++i)
    {
      if (std::abs(plainA.Bytes[i] - plainB.Bytes[i]) <= 8 && plainA.Bytes[i] != Background[i % 3])
      {
        const double effect = a.Bytes[i] - static_cast<double>(plainA.Bytes[i]);
        const double d = b.Bytes[i] - static_cast<double>(plainB.Bytes[i]) - effect;
        this->EffectRms += effect * effect;
        this->EffectMean += effect;
        this->Rms += d * d;
        this->Mean += d;
        ++count;
      }
    }
    const double number = static_cast<double>(std::max<std::size_t>(count, 1));
    this->EffectRms = std::sqrt(this->EffectRms / number);
    this->Rms = std::sqrt(this->Rms / number);
    this->EffectMean /= number;
    this->Mean /= number;
    this->Part = number / static_cast<double>(a.Bytes.size());
  }
};

// Tubes of VTK against the ray caster, which is drawn or not.
void CheckTubes(Checks& check, int shadows, int occlusion, bool local, const std::string& name)
{
  const auto lines = MakeTangle();
  auto caster = MakeCaster(lines);
  LitStage stage(120, 120, local);
  auto own = stage.Add(caster);
  SetUp(own->GetProperty());
  auto tubes = stage.Add(MakeTubes(lines));
  SetUp(tubes->GetProperty());

  tubes->VisibilityOff();
  const Picture ownPlain = stage.Render();
  Global* global = caster->GetGlobalIllumination();
  global->SetOcclusionSamples(12);
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
  check(tubes->GetShaderProperty()->GetNumberOfShaderReplacements() == 0, name + ": code is out");
  check(stage.Render().Bytes == plain.Bytes, name + ": removal restores the picture");

  const Inside inside(ownPlain, ownLit, plain, lit);
  std::cerr << name << ": effect rms " << inside.EffectRms << ", mean " << inside.EffectMean
            << "; on tubes other by rms " << inside.Rms << ", mean " << inside.Mean << ", part "
            << inside.Part << std::endl;
  check(inside.Part > 0.2, name + ": enough is compared");
  check(inside.Rms < 0.13 * inside.EffectRms + 0.5, name + ": tubes look like the ray caster's");
  check(std::abs(inside.Mean) < 0.01 * std::abs(inside.EffectMean) + 0.1, name + ": as bright");

  auto undrawn = MakeCaster(lines);
  undrawn->SetGlobalIllumination(global);
  undrawn->AddReceiver(tubes);
  check(stage.Render().Bytes == lit.Bytes, name + ": lines that are not drawn cast the same");
}

// A change takes effect at once, as if it had been so from the beginning.
void CheckChanges(Checks& check)
{
  const auto tubes = MakeTubes(MakeTangle());
  const std::vector<std::pair<std::string, Change>> changes = {
    { "cone",
      [](vtkVoxelLineMapper* caster, vtkActor*, LitStage&)
      { caster->GetGlobalIllumination()->SetShadowConeAngle(40.0); } },
    { "radius", [](vtkVoxelLineMapper* caster, vtkActor*, LitStage&) { caster->SetRadius(0.06); } },
    { "opacity",
      [](vtkVoxelLineMapper* caster, vtkActor*, LitStage& stage)
      {
        // Drawn where nobody sees it.
        auto own = stage.Add(caster, 0.3);
        own->GetProperty()->SetOpacity(0.3);
        stage.Renderer->RemoveActor(own);
        vtkNew<vtkRenderer> other;
        LitStage::SetScene(other, false);
        other->AddActor(own);
        other->SetViewport(0.0, 0.0, 0.01, 0.01);
        stage.Window->AddRenderer(other);
        stage.Window->Render();
      } },
    { "third light",
      [](vtkVoxelLineMapper*, vtkActor*, LitStage& stage)
      {
        vtkNew<vtkLight> light;
        light->SetLightTypeToHeadlight();
        stage.Renderer->AddLight(light);
      } },
  };
  Reception before(tubes);
  const Picture first = before.Render();
  for (const auto& [name, change] : changes)
  {
    Reception changed(tubes);
    changed.Render();
    change(changed.Caster, changed.Actor, changed.Stage);
    const Picture picture = changed.Render();
    check(Compare(picture, first).Rms > 0.5, name + ": a change is seen");
    Reception anew(tubes, change);
    const Difference difference = Compare(picture, anew.Render());
    check(difference.Largest == 0, name + ": a change is like a new scene" + Describe(difference));
  }
}

// Lines: darker where something is around, and elsewhere as before.
void CheckLines(Checks& check)
{
  // A line far from all others, on the side of the lights.
  auto lines = MakeTangle();
  auto all = MakeLines({ { { -1.0, 1.02, 0.9 }, { 1.0, 1.02, 0.9 } } });
  for (const double mergeLength : { 0.0, 3.0, -1.0 })
  {
    vtkSmartPointer<vtkPolyDataMapper> mapper;
    if (mergeLength >= 0.0)
    {
      auto lit = vtkSmartPointer<vtkIlluminatedLineMapper>::New();
      lit->SetMergeLength(mergeLength);
      mapper = lit;
    }
    else
    {
      mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    }
    const std::string name = "lines with " + std::to_string(mergeLength);
    mapper->SetInputData(lines);
    Reception reception(mapper);
    // Of shadows and of occlusion alone.
    Global* global = reception.Caster->GetGlobalIllumination();
    global->SetOcclusionToNone();
    const Picture shadowed = reception.Render();
    global->SetOcclusionToHemisphereDensity();
    global->SetOcclusionSamples(8);
    Save(reception.Stage.Window, "lines");
    const Picture lit = reception.Render();
    reception.Caster->RemoveReceiver(reception.Actor);
    const Picture plain = reception.Render();
    CheckDarker(check, plain, shadowed, name + " in shadow");
    CheckDarker(check, shadowed, lit, name);
    global->SetOcclusionToSpherical();

    mapper->SetInputData(all);
    const Picture plainAlone = reception.Render();
    reception.Caster->GetGlobalIllumination()->SetOcclusionRadius(2.0);
    reception.Caster->AddReceiver(reception.Actor);
    const Difference difference = Compare(reception.Render(), plainAlone);
    check(difference.Largest <= 1, name + ": far from others as before" + Describe(difference));
  }
}

// Materials, code of users, lighting off, passes.
void CheckShaders(Checks& check)
{
  const auto tubes = MakeTubes(MakeTangle());
  const auto compare = [&check, &tubes](const std::string& name, const Change& change, int most)
  {
    Reception reception(tubes, change);
    const Picture lit = reception.Render();
    Save(reception.Stage.Window, name);
    reception.Caster->RemoveAllReceivers();
    const Picture plain = reception.Render();
    CheckDarker(check, plain, lit, name, most);
    Reception never(tubes, change);
    never.Caster->RemoveReceiver(never.Actor);
    check(never.Render().Bytes == plain.Bytes, name + ": removal restores the picture");
  };
  compare(
    "physically based",
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage&)
    { actor->GetProperty()->SetInterpolationToPBR(); },
    1);
  compare(
    "translucent",
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage&) { actor->GetProperty()->SetOpacity(0.5); },
    1);
  compare(
    "peeled",
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage& stage)
    {
      actor->GetProperty()->SetOpacity(0.5);
      stage.Renderer->UseDepthPeelingOn();
      stage.Renderer->SetMaximumNumberOfPeels(20);
    },
    2);
  compare(
    "wireframe",
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage&)
    { actor->GetProperty()->SetRepresentationToWireframe(); },
    1);
  compare(
    "with code of a user",
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage&)
    {
      actor->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].g = 1.0;\n", false);
    },
    1);

  Reception unlit(tubes,
    [](vtkVoxelLineMapper*, vtkActor* actor, LitStage&) { actor->GetProperty()->LightingOff(); });
  unlit.Render();
  check(unlit.Actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0,
    "without lighting shaders stay as they are");
}

// A surface among lines: dimmed also where voxels hold none.
void CheckSurface(Checks& check)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-1.0, 0.1, -1.0);
  source->SetPoint1(-1.0, 0.1, 1.0);
  source->SetPoint2(1.0, 0.1, -1.0);
  vtkNew<vtkPolyDataMapper> plane;
  plane->SetInputConnection(source->GetOutputPort());
  Reception reception(plane,
    [](vtkVoxelLineMapper* caster, vtkActor* actor, LitStage&)
    {
      caster->SetRadius(0.08);
      caster->GetGlobalIllumination()->SetShadowsToNone();
      actor->GetProperty()->SetDiffuseColor(1.0, 1.0, 1.0);
    });
  const Picture picture = reception.Render();
  Save(reception.Stage.Window, "plane");
  reception.Caster->RemoveAllReceivers();
  const Picture plain = reception.Render();
  // Half of the plane lies in voxels without lines.
  const double part = CheckDarker(check, plain, picture, "plane");
  std::cerr << "plane: darker part " << part << std::endl;
  // A tenth, and a fiftieth without the cones that are followed where voxels hold none.
  check(part > 0.06, "a plane is dimmed between the lines, too");
}

// Renderers and windows that come, go and differ; deletion in any order.
void CheckWindows(Checks& check, Messages* messages)
{
  const auto tubes = MakeTubes(MakeTangle());
  Reception reception(tubes);
  const Picture lit = reception.Render();

  // Another window.
  {
    LitStage other(64, 64);
    other.Renderer->AddActor(reception.Actor);
    check(other.Render().Bytes == lit.Bytes, "another window shows the same");
    check(reception.Render().Bytes == lit.Bytes, "and the first one still does");
    check(other.Render().Bytes == lit.Bytes, "and the other one again");

    // Two actors with the same mapper are not told apart by it.
    other.Renderer->RemoveActor(reception.Actor);
    auto second = other.Add(tubes);
    SetUp(second->GetProperty());
    reception.Caster->AddReceiver(second);
    for (int frame = 0; frame < 2; ++frame)
    {
      check(other.Render().Bytes == lit.Bytes, "a second actor with the same mapper");
      check(reception.Render().Bytes == lit.Bytes, "and the first one");
    }
    reception.Caster->RemoveReceiver(second);
  }
  check(reception.Render().Bytes == lit.Bytes, "after the other window is gone");
  check(reception.Caster->GetGraphicsMemory() > 0, "memory is told");
  reception.Caster->ReleaseGraphicsResources(reception.Stage.Window);
  check(reception.Caster->GetGraphicsMemory() == 0, "memory is released");
  check(reception.Render().Bytes == lit.Bytes, "after resources were released");
  reception.Stage.Window->Finalize();
  check(reception.Render().Bytes == lit.Bytes, "after the window was finalized");

  // Two viewports at once.
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(128, 64);
  for (const double x : { 0.0, 0.5 })
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(x, 0.0, x + 0.5, 1.0);
    LitStage::SetScene(renderer, false);
    renderer->AddActor(reception.Actor);
    if (x > 0.0)
    {
      renderer->GetLights()->RemoveItem(0);
    }
    window->AddRenderer(renderer);
  }
  window->Render();
  const Picture both = Grab(window);
  bool isSame = true;
  for (int y = 0; y < 64; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      isSame = isSame && both.At(x, y) == lit.At(x, y);
    }
  }
  check(isSame, "one of two viewports shows the same");
  window->Render();
  check(Grab(window).Bytes == both.Bytes, "two viewports in their second frame");

  // Another mapper for the actor, and back.
  vtkNew<vtkPolyDataMapper> nothing;
  nothing->SetInputData(MakeLines({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }));
  reception.Actor->SetMapper(nothing);
  reception.Render();
  reception.Actor->SetMapper(tubes);
  check(reception.Render().Bytes == lit.Bytes, "after another mapper");

  // The lines go first, or the actor.
  reception.Caster = nullptr;
  Reception plain(tubes);
  plain.Caster->RemoveAllReceivers();
  check(reception.Render().Bytes == plain.Render().Bytes, "after the lines are gone");
  plain.Caster->AddReceiver(plain.Actor);
  plain.Render();
  check(plain.Caster->GetNumberOfReceivers() == 1, "one receiver");
  plain.Stage.Renderer->RemoveActor(plain.Actor);
  plain.Actor = nullptr;
  check(plain.Caster->GetNumberOfReceivers() == 0, "an actor that is gone does not count");
  plain.Render();
  check(messages->IsQuiet(), "nothing is said with windows");
}

// Where lines and receivers are, far from the origin.
void CheckPlacement(Checks& check)
{
  const auto tubes = MakeTubes(MakeTangle());
  const auto place = [](double far)
  {
    return [far](vtkVoxelLineMapper* caster, vtkActor* actor, LitStage& stage)
    {
      auto own = stage.Add(caster, 0.0);
      for (vtkActor* moved : { own.Get(), actor })
      {
        moved->SetScale(2.0);
        moved->RotateZ(30.0);
        moved->SetPosition(far, -far, 0.5 * far);
      }
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      camera->SetPosition(far + 5.0, -far + 4.0, 0.5 * far + 5.0);
      camera->SetFocalPoint(far, -far, 0.5 * far);
      camera->SetClippingRange(2.0, 14.0);
      // An actor that is wholly transparent casts no shadow.
      own->GetProperty()->SetOpacity(1.0);
      stage.Window->Render();
      own->VisibilityOff();
    };
  };
  Reception near(tubes, place(0.0));
  Reception far(tubes, place(1e6));
  const Difference difference = Compare(near.Render(), far.Render());
  check(difference.Rms < 3.0, "far from the origin" + Describe(difference));
  near.Caster->RemoveAllReceivers();
  const Picture lit = far.Render();
  check(Compare(near.Render(), lit).Rms > 10.0, "shadows are seen far from the origin");
}

void CheckMessages(Checks& check, Messages* messages)
{
  const auto tubes = MakeTubes(MakeTangle());
  Reception reception(tubes);
  const Picture soft = reception.Render();
  check(messages->IsQuiet(), "soft shadows need no warning");
  reception.Caster->GetGlobalIllumination()->SetShadowsToHard();
  const Picture hard = reception.Render();
  check(messages->TakeWarnings("receive soft ones") == 1, "hard shadows are replaced");
  check(hard.Bytes == soft.Bytes, "by soft ones");
  reception.Caster->GetGlobalIllumination()->SetShadowsToLevel();
  check(reception.Render().Bytes == soft.Bytes, "level shadows are replaced by soft ones");
  check(messages->IsQuiet(), "which is said once");
  reception.Caster->GetGlobalIllumination()->SetOcclusionToHemisphereTubes();
  reception.Caster->GetGlobalIllumination()->SetOcclusionSamples(8);
  const Picture byTubes = reception.Render();
  check(messages->TakeWarnings("by densities") == 1, "occlusion by tubes is replaced");
  reception.Caster->GetGlobalIllumination()->SetOcclusionToHemisphereDensity();
  check(reception.Render().Bytes == byTubes.Bytes, "by densities");
  reception.Caster->GetGlobalIllumination()->SetOcclusionToNone();
  reception.Stage.Renderer->RemoveAllLights();
  reception.Stage.Renderer->AutomaticLightCreationOn();
  reception.Stage.Renderer->CreateLight();
  reception.Render();
  reception.Render();
  check(messages->TakeWarnings("headlights") == 1, "headlights cast no shadows");

  vtkNew<vtkVoxelLineMapper> second;
  second->AddReceiver(reception.Actor);
  check(messages->TakeErrors("receives from another") == 1, "one mapper at a time");
  second->AddReceiver(nullptr);
  check(messages->TakeErrors("no actor") == 1, "a null pointer");
  check(second->GetNumberOfReceivers() == 0, "neither is a receiver");
  reception.Caster->AddReceiver(reception.Actor);
  check(reception.Caster->GetNumberOfReceivers() == 1, "twice is once");
  second->RemoveReceiver(reception.Actor);
  second->RemoveReceiver(nullptr);
  reception.Caster->RemoveReceiver(reception.Actor);
  second->AddReceiver(reception.Actor);
  check(second->GetNumberOfReceivers() == 1, "after removal another one may");
  reception.Render();
  check(messages->IsQuiet(), "a mapper without input casts nothing");
}
}

int TestVoxelLineMapperReceivers(int, char*[])
{
  const auto messages = Listen();
  Checks check;
  KeptDisplay display;
  CheckTubes(check, Global::SoftShadows, Global::NoOcclusion, false, "soft");
  CheckTubes(check, Global::SoftShadows, Global::SphericalOcclusion, true, "local");
  CheckTubes(check, Global::NoShadows, Global::SphericalOcclusion, false, "spherical");
  CheckTubes(check, Global::NoShadows, Global::HemisphereDensity, false, "hemisphere");
  check(messages->IsQuiet(), "nothing is said of tubes");
  CheckChanges(check);
  check(messages->IsQuiet(), "nothing is said of changes");
  CheckLines(check);
  check(messages->IsQuiet(), "nothing is said of lines");
  CheckShaders(check);
  check(messages->IsQuiet(), "nothing is said of shaders");
  CheckSurface(check);
  CheckPlacement(check);
  check(messages->IsQuiet(), "nothing is said of places");
  CheckWindows(check, messages);
  CheckMessages(check, messages);
  return check.GetResult();
}
