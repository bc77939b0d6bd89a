// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the mean of pictures that the mapper draws while nothing changes: it comes closer to a
// picture with 64 samples per pixel; it ends at the number that was set; every kind of change
// begins anew, with the very picture that is drawn without accumulation; it enters all translucent
// passes, with opaque actors before and behind, drawn earlier or later; both engines give the same;
// selections do not disturb it; several actors or renderers do not mix.

#include "RenderPassTesting.h"

#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkLineIllumination.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkVoxelLineAccumulator.h"

#include <functional>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr int Native = vtkVoxelLineMapper::Native;
constexpr int Shader = vtkVoxelLineMapper::Shader;
constexpr std::array<int, 3> Red{ 255, 0, 0 };

vtkSmartPointer<vtkVoxelLineMapper> MakeMapper(vtkPolyData* lines, double radius, int frames)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(radius);
  mapper->SetResolution(32);
  mapper->SetScalarRange(0.0, 1.0);
  mapper->SetEngine(Native);
  mapper->SetAccumulationFrames(frames);
  return mapper;
}

// Helices, and a sphere that is partly in front of them.
struct Scene : Stage
{
  vtkSmartPointer<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Lines;
  vtkSmartPointer<vtkActor> Sphere;
  vtkNew<vtkLight> Light;

  Scene(int frames, double opacity, int width = 90, int height = 75)
    : Stage(width, height)
  {
    auto lines = MakeHelices(4, 120);
    this->Mapper = MakeMapper(lines, 0.05, frames);
    this->Lines = this->Add(this->Mapper, opacity);
    this->Lines->GetProperty()->SetSpecular(0.3);
    this->Sphere = this->AddSphere(0.8, 0.4, 0.6, 0.4);
    this->Light->SetLightTypeToHeadlight();
    this->Renderer->AddLight(this->Light);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(3.0, 2.5, 3.5);
    camera->SetClippingRange(2.0, 9.0);
  }

  int GetNumber() { return this->Mapper->GetNumberOfAccumulatedPictures(); }

  Picture RenderTimes(int times)
  {
    Picture picture;
    for (int i = 0; i < times; ++i)
    {
      picture = this->Render();
    }
    return picture;
  }
};

// The mean of three pictures of three pixels, one of them behind the scene.
void CheckMean(Checks& check)
{
  vtkVoxelLineAccumulator accumulator;
  accumulator.TakeScene({ 1.0f, 1.0f, 0.3f });
  check(!accumulator.IsSameScene({ 1.0f, 1.0f, 0.4f }), "another depth of the scene");
  check(accumulator.IsSameScene({ 1.0f, 1.0f, 0.3f }), "the same depth of the scene");
  vtkVoxelLinePicture picture;
  picture.Color = { 0, 0, 0, 0, 40, 50, 60, 255, 255, 255, 255, 255 };
  picture.Depth = { 1.0f, 0.5f, 0.6f };
  accumulator.Add(picture);
  picture.Color = { 255, 0, 0, 255, 40, 50, 60, 255, 80, 0, 0, 255 };
  picture.Depth = { 0.4f, 0.5f, 0.2f };
  accumulator.Add(picture);
  picture.Color = { 0, 0, 250, 51, 40, 50, 60, 255, 0, 0, 0, 0 };
  picture.Depth = { 0.2f, 0.7f, 1.0f };
  accumulator.Add(picture);
  vtkVoxelLinePicture mean;
  accumulator.GetMean(mean);
  // 255 and 51 parts of colour; a third of opacity.
  const std::vector<std::uint8_t> colors{ 213, 0, 42, 102, 40, 50, 60, 255, 80, 0, 0, 85 };
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    check(std::abs(mean.Color[i] - colors[i]) <= 1, "mean, byte " + std::to_string(i));
  }
  check(mean.Depth == std::vector<float>{ 0.4f, 0.5f, 0.2f }, "depth of the first line");
  accumulator.Clear();
  check(accumulator.GetNumberOfPictures() == 0, "cleared");
  check(accumulator.IsSameScene({ 0.5f }), "no scene is left");

  double sums[2] = { 0.0, 0.0 };
  for (int i = 0; i < 36; ++i)
  {
    const glm::dvec2 offset = vtkVoxelLineAccumulator::GetOffset(i);
    for (int k = 0; k < 2; ++k)
    {
      sums[k] += offset[k];
      check(offset[k] >= -0.5 && offset[k] < 0.5, "rays stay in their pixel");
      check(i > 0 || offset[k] == 0.0, "the first ray is not shifted");
    }
  }
  check(std::abs(sums[0]) < 1.0 && std::abs(sums[1]) < 1.0, "rays are centred");
}

// Measured: the error falls from the first picture to the mean of 32 by 7 to 9.
void CheckError(Checks& check, double opacity)
{
  Scene large(1, opacity, 8 * 90, 8 * 75);
  large.Sphere->VisibilityOff();
  const Picture reference = large.Render();
  Scene scene(32, opacity);
  scene.Sphere->VisibilityOff();
  double first = 0.0;
  double error = 1e9;
  std::cout << "opacity " << opacity << ", error:";
  for (const int frames : { 1, 3, 4, 8, 16 })
  {
    const double before = error;
    error = GetError(scene.RenderTimes(frames), reference);
    first = first > 0.0 ? first : error;
    std::cout << " " << error << " (" << scene.GetNumber() << ")";
    check(error < before, "the error falls as pictures add up");
  }
  std::cout << std::endl;
  check(first > 6.0 * error, "the error falls by more than 6");
}

void CheckNumber(Checks& check, double opacity)
{
  Scene plain(1, opacity);
  const Picture expected = plain.Render();
  check(plain.GetNumber() == 1, "one picture without accumulation");
  check(Compare(expected, plain.Render()).Largest == 0 && plain.Mapper->GetNumberOfPictures() == 2,
    "without accumulation each frame casts the same picture");

  Scene scene(5, opacity);
  check(scene.GetNumber() == 0, "no picture before the first frame");
  check(Compare(expected, scene.Render()).Largest == 0, "the first picture is that without");
  Picture mean;
  for (int i = 2; i <= 5; ++i)
  {
    mean = scene.Render();
    check(scene.GetNumber() == i && scene.Mapper->GetNumberOfPictures() == i,
      "one more picture in each frame");
  }
  check(Compare(expected, mean).Largest > 20, "the mean is another picture");
  check(Compare(mean, scene.RenderTimes(2)).Largest == 0, "the mean is replayed");
  check(scene.GetNumber() == 5 && scene.Mapper->GetNumberOfPictures() == 5, "no more are cast");
  scene.Mapper->SetAccumulationFrames(7);
  const Picture more = scene.RenderTimes(3);
  check(scene.GetNumber() == 7 && scene.Mapper->GetNumberOfPictures() == 7, "a larger number");
  Scene other(7, opacity);
  check(Compare(more, other.RenderTimes(7)).Largest == 0, "the same as with it from the beginning");
  scene.Mapper->SetAccumulationFrames(1);
  check(Compare(expected, scene.Render()).Largest == 0 && scene.GetNumber() == 1, "switched off");
}

struct Change
{
  std::string Name;
  std::function<void(Scene&)> Apply;
  // Whether it is found when the lines are drawn in the translucent pass, which may round.
  bool InPass = false;
};

std::vector<Change> MakeChanges()
{
  return {
    { "camera", [](Scene& s) { s.Renderer->GetActiveCamera()->Azimuth(2.0); } },
    { "projection", [](Scene& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOn(); } },
    { "actor", [](Scene& s) { s.Lines->SetPosition(0.01, 0.0, 0.0); } },
    { "colours of the property", [](Scene& s) { s.Lines->GetProperty()->SetDiffuse(0.7); } },
    { "opacity", [](Scene& s) { s.Lines->GetProperty()->SetOpacity(0.2); } },
    { "lookup table",
      [](Scene& s)
      {
        vtkNew<vtkLookupTable> table;
        table->SetHueRange(0.2, 0.4);
        s.Mapper->SetLookupTable(table);
      } },
    { "scalar range", [](Scene& s) { s.Mapper->SetScalarRange(0.0, 0.9); } },
    { "scalar visibility", [](Scene& s) { s.Mapper->ScalarVisibilityOff(); } },
    { "radius", [](Scene& s) { s.Mapper->SetRadius(0.06); } },
    { "resolution", [](Scene& s) { s.Mapper->SetResolution(24); } },
    { "scalars",
      [](Scene& s)
      {
        // Only the values in the model change.
        vtkDataArray* values = s.Mapper->GetInput()->GetPointData()->GetScalars();
        for (vtkIdType i = 30; i < 90; ++i)
        {
          values->SetComponent(i, 0, 0.5);
        }
        values->Modified();
        s.Mapper->GetInput()->Modified();
      } },
    { "engine's end of rays", [](Scene& s) { s.Mapper->SetEarlyTermination(0.5); } },
    { "light", [](Scene& s) { s.Light->SetIntensity(0.8); } },
    { "light model",
      [](Scene& s) { s.Mapper->GetIllumination()->SetReflection(vtkLineIllumination::Blinn); } },
    { "clipping plane",
      [](Scene& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0.0, 0.0, 1.0);
        s.Mapper->AddClippingPlane(plane);
      } },
    { "window size", [](Scene& s) { s.Window->SetSize(80, 70); } },
    { "an opaque actor that moves", [](Scene& s) { s.Sphere->SetPosition(-0.3, 0.1, 0.2); }, true },
    { "an opaque actor that goes", [](Scene& s) { s.Sphere->VisibilityOff(); }, true },
  };
}

// After three pictures, or one: the first picture of the changed scene comes next, and the
// same means as if it had been so from the beginning.
void CheckChanges(Checks& check, double opacity)
{
  for (const Change& change : MakeChanges())
  {
    Scene fresh(4, opacity);
    change.Apply(fresh);
    const Picture first = fresh.Render();
    const Picture mean = fresh.RenderTimes(2);
    for (const int before : { 1, 3 })
    {
      if (before == 1 && !change.InPass)
      {
        continue; // found in the same way
      }
      const std::string name =
        change.Name + ", opacity " + std::to_string(opacity) + ", after " + std::to_string(before);
      Scene scene(4, opacity);
      scene.RenderTimes(before);
      change.Apply(scene);
      Difference difference = Compare(first, scene.Render());
      // The first picture of opaque lines does not depend on other actors.
      const bool keeps = change.InPass && opacity == 1.0 && before == 1;
      const int passes = change.InPass && opacity == 1.0 ? 2 : 0;
      check(scene.GetNumber() == (keeps ? 2 : 1), name + ": begins anew");
      check(keeps || difference.Largest <= passes, name + ": first picture" + Describe(difference));
      difference = Compare(mean, scene.RenderTimes(keeps ? 1 : 2));
      check(
        scene.GetNumber() == 3 && difference.Largest == 0, name + ": mean" + Describe(difference));
    }
  }
}

// An opaque actor moves in every frame: what was cast before leaves no trace in the mean.
void CheckMovingActor(Checks& check, double opacity)
{
  for (const int moves : { 2, 3 })
  {
    Scene scene(4, opacity);
    for (int i = moves; i >= 0; --i)
    {
      scene.Sphere->SetPosition(-0.3 * i, -0.1 * i, 0.2 * i);
      scene.RenderTimes(i == moves ? 3 : 1);
    }
    scene.RenderTimes(5);
    Scene fresh(4, opacity);
    const Difference difference = Compare(scene.Render(), fresh.RenderTimes(4));
    check(scene.GetNumber() == 4 && difference.Largest == 0,
      "after an actor that moved in every frame" + Describe(difference));
  }
}

// Changes that the shader engine finds in other ways: the scene's depth lies in a texture.
void CheckEngines(Checks& check)
{
  for (const double opacity : { 1.0, 0.4 })
  {
    Picture pictures[2];
    for (const int engine : { Native, Shader })
    {
      Scene scene(4, opacity, 60, 50);
      scene.Mapper->SetEngine(engine);
      pictures[engine == Shader] = scene.RenderTimes(4);
      const Picture again = scene.Render();
      check(scene.Mapper->GetNumberOfPictures() == 4 &&
          Compare(again, pictures[engine == Shader]).Largest == 0,
        "an engine's mean is replayed");
      for (const int before : { 1, 3 })
      {
        scene.Renderer->GetActiveCamera()->Azimuth(5.0);
        scene.RenderTimes(before);
        scene.Sphere->SetPosition(-0.3, 0.1, 0.2);
        scene.Render();
        check(scene.GetNumber() == (opacity == 1.0 && before == 1 ? 2 : 1),
          "a moved actor with engine " + std::to_string(engine) + " after " +
            std::to_string(before));
        scene.Sphere->SetPosition(0.0, 0.0, 0.0);
        scene.Renderer->GetActiveCamera()->Azimuth(-5.0);
        const Difference difference = Compare(pictures[engine == Shader], scene.RenderTimes(4));
        check(difference.Largest == 0, "the same again" + Describe(difference));
      }
    }
    const Difference difference = Compare(pictures[0], pictures[1]);
    check(difference.Part < 2e-3, "both engines" + Describe(difference));
    // An engine is a setting like others.
    Scene scene(4, opacity, 60, 50);
    scene.RenderTimes(3);
    scene.Mapper->SetEngine(Shader);
    scene.Render();
    check(scene.GetNumber() == 1, "another engine begins anew");
  }
}

// Straight lines along y at (x, z).
vtkSmartPointer<vtkVoxelLineMapper> MakeBars(const std::vector<std::array<double, 2>>& places)
{
  std::vector<Curve> curves;
  for (const auto& place : places)
  {
    curves.push_back({ { place[0], -0.9, place[1] }, { place[0] + 0.05, 0.9, place[1] } });
  }
  auto mapper = MakeMapper(MakeLines(curves), 0.1, 16);
  mapper->SetFaceBins(0);
  return mapper;
}

vtkSmartPointer<vtkActor> AddBars(Stage& stage, vtkMapper* mapper, double opacity)
{
  auto actor = stage.Add(mapper, opacity);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

// Means in all passes are the same picture, with a sphere drawn before or after the lines.
void CheckPasses(Checks& check)
{
  for (const double opacity : { 1.0, 0.4 })
  {
    for (const bool linesFirst : { true, false })
    {
      Picture pictures[3];
      for (const Pass pass : { Plain, Independent, Peeling })
      {
        Stage stage(90, 75);
        auto mapper = MakeBars({ { 0.3, 0.8 }, { -0.6, 0.1 }, { 0.0, -0.8 } });
        linesFirst ? AddBars(stage, mapper, opacity) : nullptr;
        stage.AddSphere(0.0, 0.0, 0.0, 0.7)->GetProperty()->LightingOff();
        linesFirst ? nullptr : AddBars(stage, mapper, opacity);
        SetPass(stage, pass);
        LookAlongZ(stage);
        for (int i = 1; i <= 16; ++i)
        {
          pictures[pass] = stage.Render();
          check(mapper->GetNumberOfPictures() == i && mapper->GetNumberOfAccumulatedPictures() == i,
            std::string(PassNames[pass]) + ": one picture in each frame");
        }
        // Over the sphere, red and white mix: red is full; nothing dark is left at edges.
        const Picture& picture = pictures[pass];
        int mixed = 0;
        int dark = 0;
        for (int x = 30; x < 60; ++x)
        {
          const auto pixel = picture.At(x, picture.Height / 2);
          mixed += pixel[1] > 30 && pixel[1] < 225 ? 1 : 0;
          dark += pixel[0] < 252 ? 1 : 0;
        }
        check(mixed > 0 && dark == 0,
          std::string(PassNames[pass]) + ": edges over a sphere, " + std::to_string(mixed) +
            " mixed, " + std::to_string(dark) + " dark");
        check(!mapper->HasTranslucentPolygonalGeometry(), "lines are opaque between frames");
      }
      for (const Pass pass : { Independent, Peeling })
      {
        const Difference difference = Compare(pictures[pass], pictures[Plain]);
        check(difference.Largest <= 2, std::string(PassNames[pass]) + Describe(difference));
      }
    }
  }
}

// Lines behind an opaque actor must not show at the edges of a line before it, nor hide these.
void CheckHiddenLines(Checks& check)
{
  for (const double opacity : { 1.0, 0.4 })
  {
    Picture pictures[2];
    for (const bool hidden : { false, true })
    {
      Stage stage(90, 75);
      auto mapper = MakeBars({ { 0.0, 0.8 }, { 0.12, -0.8 }, { -0.15, -0.8 } });
      vtkNew<vtkPlane> plane;
      plane->SetNormal(0.0, 0.0, 1.0);
      hidden ? static_cast<void>(0) : mapper->AddClippingPlane(plane);
      AddBars(stage, mapper, opacity);
      stage.AddSphere(0.0, 0.0, 0.0, 0.7)->GetProperty()->LightingOff();
      LookAlongZ(stage);
      for (int i = 0; i < 16; ++i)
      {
        pictures[hidden] = stage.Render();
      }
    }
    int different = 0;
    for (int i = 0; i < 30 * 40; ++i)
    {
      const int x = 30 + i % 30;
      const int y = 18 + i / 30;
      different += IsNear(pictures[0].At(x, y), pictures[1].At(x, y), 1) ? 0 : 1;
    }
    check(different == 0, "pixels in which hidden lines show: " + std::to_string(different));
  }
}

void CheckForcedOpaque(Checks& check)
{
  Stage stage(90, 75);
  auto mapper = MakeBars({ { 0.0, 0.0 } });
  AddBars(stage, mapper, 1.0)->ForceOpaqueOn();
  LookAlongZ(stage);
  Picture picture;
  for (int i = 0; i < 16; ++i)
  {
    picture = stage.Render();
  }
  check(mapper->GetNumberOfAccumulatedPictures() == 16, "accumulates in the opaque pass");
  check(IsNear(picture.At(46, 38), Red, 1), "and is drawn there");
}

void Select(Scene& scene)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(10, 10, 70, 60);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
}

void CheckSelection(Checks& check)
{
  for (const double opacity : { 1.0, 0.4 })
  {
    Scene quiet(4, opacity);
    const Picture expected = quiet.RenderTimes(4);
    Scene scene(4, opacity);
    for (int i = 1; i <= 5; ++i)
    {
      scene.Render();
      Select(scene);
      check(scene.GetNumber() == std::min(i, 4), "selections do not count");
    }
    check(scene.Mapper->GetNumberOfPictures() == 4, "nor make the mapper begin anew");
    check(Compare(expected, scene.Render()).Largest == 0, "the mean after selections");
  }
}

// Two actors, or two renderers, with one mapper: the pictures are those without accumulation.
void CheckShared(Checks& check, double opacity)
{
  for (const bool renderers : { false, true })
  {
    Picture pictures[2];
    for (const int frames : { 1, 4 })
    {
      Scene scene(frames, opacity);
      vtkNew<vtkRenderer> right;
      vtkNew<vtkActor> second;
      second->SetMapper(scene.Mapper);
      second->SetProperty(scene.Lines->GetProperty());
      // The views of two renderers are the same.
      second->SetPosition(renderers ? 0.0 : 0.4, 0.0, 0.0);
      scene.Renderer->UseDepthPeelingOn();
      if (renderers)
      {
        scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
        right->SetViewport(0.5, 0.0, 1.0, 1.0);
        right->AddActor(second);
        right->AddActor(scene.Sphere);
        right->AddLight(scene.Light);
        right->SetBackground(scene.Renderer->GetBackground());
        right->SetActiveCamera(scene.Renderer->GetActiveCamera());
        scene.Window->AddRenderer(right);
      }
      else
      {
        scene.Renderer->AddActor(second);
      }
      pictures[frames > 1] = scene.RenderTimes(3);
      check(scene.GetNumber() == 1, "nothing is accumulated for two");
      if (!renderers && frames > 1)
      {
        scene.Renderer->RemoveActor(second);
        scene.RenderTimes(6);
        Scene alone(4, opacity);
        alone.Renderer->UseDepthPeelingOn();
        check(scene.GetNumber() == 4 && Compare(scene.Render(), alone.RenderTimes(4)).Largest == 0,
          "accumulates when one is left");
      }
    }
    const Difference difference = Compare(pictures[0], pictures[1]);
    check(difference.Largest == 0, "a mapper drawn twice" + Describe(difference));
  }
}

void CheckRelease(Checks& check)
{
  Scene scene(4, 0.4);
  const Picture mean = scene.RenderTimes(4);
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  check(scene.GetNumber() == 0, "nothing is left after release");
  check(Compare(mean, scene.RenderTimes(4)).Largest == 0, "the same again after release");
  Stage other(90, 75);
  other.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->RemoveActor(scene.Lines);
  other.Renderer->AddActor(scene.Lines);
  other.Render();
  check(scene.GetNumber() == 1, "another window begins anew");
}

void CheckProperty(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  check(mapper->GetAccumulationFrames() == 1, "off by default");
  for (const int bad : { 0, -3, 4097 })
  {
    mapper->SetAccumulationFrames(bad);
    check(
      messages->TakeErrors("must be from 1 to 4096") == 1 && mapper->GetAccumulationFrames() == 1,
      "a value out of range is an error");
  }
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SetAccumulationFrames(4096);
  check(
    mapper->GetAccumulationFrames() == 4096 && mapper->GetMTime() > before, "the largest value");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetAccumulationFrames() == 4096, "a copy has the number of its original");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("AccumulationFrames: 4096") != std::string::npos, "it is printed");
}
}

int TestVoxelLineMapperAccumulation(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckProperty(check, messages);
  CheckMean(check);
  for (const double opacity : { 1.0, 0.4 })
  {
    CheckError(check, opacity);
    CheckNumber(check, opacity);
    CheckChanges(check, opacity);
    CheckMovingActor(check, opacity);
    CheckShared(check, opacity);
  }
  CheckPasses(check);
  CheckHiddenLines(check);
  CheckForcedOpaque(check);
  CheckSelection(check);
  CheckRelease(check);
  CheckEngines(check);
  check(messages->IsQuiet(), "no other errors and no warnings");
  return check.GetResult();
}
