// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that optimized opacity is steady over frames: small steps of the camera change the picture
// little more than with exact sums, segments out of the view keep their opacity, and with a
// transition time opacities follow by the time that passes and not by the number of pictures, but
// at once where the view jumps or has another size, or there are other points.

#include "FourierOpacityScene.h"
#include "vtkFourierOpacityElements.h"
#include "vtkFourierOpacityView.h"
#include "vtkIntArray.h"
#include "vtkOpacitySmoothingPrivate.h"

#include <chrono>
#include <thread>

using namespace FourierOpacityTesting;

namespace
{
void CheckBlend(Checks& check)
{
  for (double transition : { 0.1, 1.0, 60.0 })
  {
    check(std::abs(vtkOpacitySmoothing::GetBlend(transition, transition) - 0.95) < 1e-12,
      "after the transition time a twentieth is left");
    // Two halves make the whole, and so do parts of any size.
    for (double seconds : { 0.001, 0.02, 0.5, 30.0 })
    {
      const double whole = 1.0 - vtkOpacitySmoothing::GetBlend(seconds, transition);
      const double half = 1.0 - vtkOpacitySmoothing::GetBlend(0.5 * seconds, transition);
      const double third = 1.0 - vtkOpacitySmoothing::GetBlend(seconds / 3.0, transition);
      check(
        std::abs(half * half - whole) < 1e-12 && std::abs(third * third * third - whole) < 1e-12,
        "parts of the time add up");
    }
  }
  check(vtkOpacitySmoothing::GetBlend(0.0, 1.0) == 0.0, "nothing happens in no time");
  check(vtkOpacitySmoothing::GetBlend(0.01, 0.0) == 1.0, "at once without a transition time");
}

bool IsNearly(const std::vector<float>& values, const std::vector<double>& expected)
{
  bool isNear = values.size() == expected.size();
  for (std::size_t i = 0; isNear && i < values.size(); ++i)
  {
    isNear = std::abs(values[i] - expected[i]) < 1e-6;
  }
  return isNear;
}

void CheckElements(Checks& check)
{
  constexpr float notSeen = vtkFourierOpacityElements::NotSeen;
  const int owners[2] = { 0, 0 };
  vtkFourierOpacityGroup first;
  first.Owner = owners;
  first.BuildTime = 1;
  first.Count = 3;
  vtkFourierOpacityGroup second = first;
  second.Owner = owners + 1;
  second.Count = 2;
  vtkFourierOpacityElements elements;
  elements.SetGroups({ first, second });
  check(elements.GetNumberOfElements() == 5 && elements.GetNumberOfGroups() == 2 &&
      elements.GetFirstElement(0) == 0 && elements.GetFirstElement(1) == 3,
    "groups follow each other");
  // The first time at once, whatever part of a change is made.
  elements.Update({ 0.2f, 0.4f, notSeen, 0.6f, 0.8f }, 0, 15, 0.5);
  check(IsNearly(elements.GetOpacities(), { 0.2, 0.4, 1.0, 0.6, 0.8 }),
    "the first time, what is not seen is opaque");
  elements.Update({ notSeen, 0.8f, 0.5f, notSeen, 0.0f }, 0, 15, 0.5);
  check(IsNearly(elements.GetOpacities(), { 0.2, 0.6, 0.75, 0.6, 0.4 }),
    "half of a change; what is not seen stays");
  elements.Update({ notSeen, 0.8f, 0.5f, notSeen, 0.0f }, 0, 15, 0.5);
  check(IsNearly(elements.GetOpacities(), { 0.2, 0.7, 0.625, 0.6, 0.2 }), "half of the rest");
  // A group in another order keeps what it has; one that was away begins anew.
  elements.SetGroups({ second, first });
  elements.Update({ notSeen, notSeen, notSeen, notSeen, notSeen }, 0, 15, 1.0);
  check(IsNearly(elements.GetOpacities(), { 0.6, 0.0, 0.2, 0.8, 0.5 }), "another order");
  elements.SetGroups({ first });
  second.BuildTime = 2;
  elements.SetGroups({ first, second });
  elements.Update(std::vector<float>(5, notSeen), 0, 15, 1.0);
  check(IsNearly(elements.GetOpacities(), { 0.2, 0.8, 0.5, 1.0, 1.0 }), "another group");
  second.BuildTime = 3;
  elements.SetGroups({ first, second });
  elements.Update({ notSeen, notSeen, notSeen, 0.5f, notSeen }, 0, 15, 0.5);
  check(IsNearly(elements.GetOpacities(), { 0.2, 0.8, 0.5, 0.5, 1.0 }), "made anew, at once");
  // Neighbours in pairs share a place.
  elements.Update({ 0.1f, 0.3f, 0.9f }, 1, 0, 1.0);
  check(IsNearly(elements.GetOpacities(), { 0.1, 0.1, 0.3, 0.3, 0.9 }), "shared places");

  // What was never seen takes part by what its neighbours have.
  vtkNew<vtkIntArray> pairs;
  pairs->SetNumberOfComponents(2);
  for (int i = 0; i < 6; ++i)
  {
    pairs->InsertNextTuple2(i, i + 1);
  }
  vtkFourierOpacityGroup chain;
  chain.Owner = &chain;
  chain.Count = 7;
  chain.Neighbors = pairs;
  vtkFourierOpacityElements line;
  line.SetGroups({ chain });
  line.Update({ 0.2f, notSeen, notSeen, notSeen, 0.6f, notSeen, notSeen }, 0, 0, 1.0);
  check(IsNearly(line.GetOpacities(), { 0.2, 0.2, 0.4, 0.6, 0.6, 0.6, 0.6 }), "never seen");
  line.Update({ 0.4f, notSeen, notSeen, notSeen, notSeen, notSeen, 1.0f }, 0, 0, 1.0);
  check(IsNearly(line.GetOpacities(), { 0.4, 0.4, 0.5, 0.6, 0.6, 0.8, 1.0 }), "never seen yet");
  line.Update({ 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f }, 0, 15, 1.0);
  line.Update(std::vector<float>(7, notSeen), 0, 15, 1.0);
  check(IsNearly(line.GetOpacities(), std::vector<double>(7, 0.5)), "all were seen once");
}

void CheckJumps(Checks& check)
{
  struct
  {
    const char* Name;
    std::function<void(Stage&)> Change;
    bool IsJump;
  } changes[] = {
    { "nothing", [](Stage&) {}, false },
    { "a small turn", [](Stage& s) { s.Renderer->GetActiveCamera()->Azimuth(2.0); }, false },
    { "a small zoom", [](Stage& s) { s.Renderer->GetActiveCamera()->Zoom(1.1); }, false },
    { "a small step", [](Stage& s) { s.Renderer->GetActiveCamera()->SetPosition(0.05, 0.0, 10.0); },
      false },
    { "a large turn", [](Stage& s) { s.Renderer->GetActiveCamera()->Azimuth(25.0); }, true },
    { "a large zoom", [](Stage& s) { s.Renderer->GetActiveCamera()->Zoom(2.0); }, true },
    { "a large zoom out", [](Stage& s) { s.Renderer->GetActiveCamera()->Zoom(0.5); }, true },
    { "another size", [](Stage& s) { s.Window->SetSize(40, 32); }, true },
    { "another projection",
      [](Stage& s) { s.Renderer->GetActiveCamera()->ParallelProjectionOff(); }, true },
  };
  for (const auto& change : changes)
  {
    Scene scene(Method{}, 32, 32);
    scene.Render();
    vtkFourierOpacityView before;
    before.Set(scene.Renderer, { scene.Actor });
    change.Change(scene);
    scene.Render();
    vtkFourierOpacityView after;
    after.Set(scene.Renderer, { scene.Actor });
    check(before.IsJump(after) == change.IsJump, std::string(change.Name) + ": jump or not");
  }
}

void CheckTransition(Checks& check)
{
  Scene scene;
  Optimization* by = scene.GetOptimization();
  by->SetTransitionTime(60.0);
  const Picture first = scene.Render();
  Scene other;
  CheckSame(check, "the first picture is there at once", first, other.Render());
  // The weights change, the view does not: little has happened after a moment.
  by->SetForegroundWeight(0.0);
  by->SetBackgroundWeight(0.0);
  other.GetOptimization()->SetForegroundWeight(0.0);
  other.GetOptimization()->SetBackgroundWeight(0.0);
  const Picture goal = other.Render();
  check(Compare(first, goal).Largest > 60, "there is something to follow");
  check(Compare(scene.Render(), first).Largest < 20, "opacities follow slowly");
  // A jump and a change of size.
  scene.Renderer->GetActiveCamera()->Zoom(2.0);
  other.Renderer->GetActiveCamera()->Zoom(2.0);
  CheckSame(check, "at once after a jump", scene.Render(), other.Render());
  by->SetForegroundWeight(50.0);
  other.GetOptimization()->SetForegroundWeight(50.0);
  scene.Window->SetSize(70, 50);
  other.Window->SetSize(scene.Window->GetSize());
  CheckSame(check, "at once with another size", scene.Render(), other.Render());
  // Long after the transition time all is done, in one picture.
  by->SetTransitionTime(0.02);
  by->SetForegroundWeight(0.0);
  other.GetOptimization()->SetForegroundWeight(0.0);
  scene.Render();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  CheckSame(check, "after the transition time", scene.Render(), other.Render(), 1);
}

// Opacities follow importance as they follow the view, by its range and by its values; other points
// have opacities at once.
void CheckImportanceChanges(Checks& check)
{
  const std::vector<Square> squares = { { 0.0, 0.0, 0.5, 0.5, { 255, 255, 255, 255 } },
    { 0.0, 0.0, -0.5, 0.5, { 0, 0, 0, 255 } } };
  OpacityStage stage;
  auto data = MakeStack(squares, { 0.0, 0.5 });
  stage.GetOptimization()->SetTransitionTime(60.0);
  const auto getGrey = [&] { return stage.Render(data).At(16, 16)[0]; };
  const int opaque = 255;
  stage.Mapper->SetImportanceRange(0.0, 1e6);
  check(getGrey() == opaque, "nothing is important");
  stage.Mapper->SetImportanceRange(0.0, 0.5);
  check(getGrey() > 200, "no jump by another range: grey " + std::to_string(getGrey()));
  stage.GetOptimization()->SetTransitionTime(0.0);
  check(getGrey() < 10, "the range counts");
  stage.GetOptimization()->SetTransitionTime(60.0);
  data->GetCellData()->GetArray("Importance")->SetComponent(1, 0, 0.0);
  data->GetCellData()->GetArray("Importance")->Modified();
  check(getGrey() < 60, "no jump by another value: grey " + std::to_string(getGrey()));
  data->GetPoints()->Modified();
  check(getGrey() == opaque, "at once with other points: grey " + std::to_string(getGrey()));
}

// A white line whose left part lies before something important. The part is one of six elements,
// and far out of the view that looks to the right: versions of VTK give wide lines other ends.
void CheckLeaving(Checks& check)
{
  std::vector<Curve> curves(1);
  for (int i = 0; i <= 12; ++i)
  {
    curves[0].push_back({ -0.75 + 0.125 * i, 0.0, 0.5 });
  }
  curves.push_back({ { -0.75, 0.0, -0.5 }, { -0.625, 0.0, -0.5 } });
  auto data = MakeLines(curves);
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    importance->InsertNextValue(i < 13 ? 0.0f : 1.0f);
    const double grey = i < 13 ? 255.0 : 0.0;
    colors->InsertNextTuple3(grey, grey, grey);
  }
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->AddArray(importance);
  OpacityStage stage(64, 64);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  stage.Actor->GetProperty()->SetLineWidth(7.0);
  stage.Mapper->SetNumberOfLineSegments(7);
  stage.GetOptimization()->SetSmoothingIterations(50);
  const Picture before = stage.Render(data);
  check(before.At(34, 32)[0] < 250, "the faded part reaches into the rest");
  // 24 pixels to the right: what lies before the important line is out of sight.
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0.75, 0.0, 10.0);
  camera->SetFocalPoint(0.75, 0.0, 0.0);
  for (int i = 0; i < 2; ++i)
  {
    const Picture moved = stage.Stage::Render();
    for (int x = 30; x < 56; x += 3)
    {
      const int grey = moved.At(x - 24, 32)[0];
      check(std::abs(grey - before.At(x, 32)[0]) <= 1,
        "a segment that left the view keeps its opacity: grey " + std::to_string(grey) +
          " instead of " + std::to_string(before.At(x, 32)[0]));
    }
  }
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  CheckSame(check, "segments that enter the view again", stage.Stage::Render(), before);
}

// How much each of some small steps changes the picture, on average.
double GetMeanChange(Optimization* by)
{
  Stage stage(80, 80);
  vtkNew<vtkFourierOpacityMapper> mapper;
  mapper->SetOptimization(by);
  auto data = MakeHelices(8, 120);
  mapper->SetInputData(data);
  mapper->SetImportanceArrayName("t");
  mapper->SetImportanceRange(0.0, 1.0);
  mapper->SetScalarRange(0.0, 1.0);
  mapper->SetNumberOfLineSegments(400);
  stage.Add(mapper)->GetProperty()->SetLineWidth(3.0);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(4.0, 3.0, 3.5);
  stage.Renderer->ResetCamera();
  Picture last = stage.Render();
  double change = 0.0;
  const int steps = 12;
  for (int i = 0; i < steps; ++i)
  {
    camera->Azimuth(0.5);
    const Picture next = stage.Render();
    change += Compare(last, next).Rms / steps;
    last = next;
  }
  return change;
}

void CheckPath(Checks& check)
{
  vtkNew<Optimization> exact;
  exact->SetImportanceToExact();
  exact->SetBlendingToFragmentLists();
  const double exactChange = GetMeanChange(exact);
  vtkNew<Optimization> none;
  none->SetForegroundWeight(0.0);
  none->SetBackgroundWeight(0.0);
  const double opaqueChange = GetMeanChange(none);
  vtkNew<Optimization> fourier;
  const double change = GetMeanChange(fourier);
  std::cout << "change by a step: exact " << exactChange << ", Fourier " << change << ", opaque "
            << opaqueChange << "\n";
  check(exactChange > 0.5, "a step changes something");
  check(change < 1.2 * exactChange + 0.2, "Fourier is as steady as exact sums");
}
}

int TestFourierOpacityCoherence(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  CheckBlend(check);
  CheckElements(check);
  CheckJumps(check);
  CheckTransition(check);
  CheckImportanceChanges(check);
  CheckLeaving(check);
  CheckPath(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
