// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFourierOpacityPass against what surrounds it: viewports with a pass each or one for
// both, windows in turn, closed and opened again, on the screen, of another size, with samples;
// a pass that goes while another window is current, whose buffers stay, or whose window is closed
// without it; renderers without actors; OpenGL's state, which is the same afterwards; and hardware
// selection without the pass, which leaves out what was faint in the pass's last picture of a view.

#include "FourierOpacityPassTesting.h"
#include "GLStateTesting.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkSSAAPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <set>

using namespace FourierOpacityTesting;

namespace
{
constexpr int Size = SceneSize;

constexpr Method Methods[] = { { Optimization::Fourier, Optimization::SeriesImportance },
  { Optimization::Bins, Optimization::ExactImportance },
  { Optimization::WeightedAverage, Optimization::SeriesImportance },
  { Optimization::FragmentLists, Optimization::ExactImportance } };

// The part of a picture that the state lets through: no blue, and what the scissor leaves.
Picture CutState(const Picture& picture)
{
  Picture part = Cut(picture, 0, 0, 30, Size);
  for (std::size_t i = 2; i < part.Bytes.size(); i += 3)
  {
    part.Bytes[i] = 0;
  }
  return part;
}

void CheckState(Checks& check, const Method& method)
{
  PassScene scene(method);
  const Picture expected = scene.Render();
  vtkNew<StatePass> state;
  state->Delegate = scene.Pass;
  state->HasCulling = false;
  UsePass(scene.Renderer, state);
  for (int frames : { 1, 3 })
  {
    scene.GetOptimization()->SetAccumulationFrames(frames);
    for (int i = 0; i <= frames; ++i)
    {
      const Picture picture = scene.Render();
      check(state->Error == GL_NO_ERROR, GetName(method) + ": error of OpenGL");
      check(state->IsSame, GetName(method) + ": the state of OpenGL is the same afterwards");
      check(GetCoverage(Cut(picture, 0, 0, 30, Size), Background) > 0.1,
        GetName(method) + ": something is drawn");
      // Whatever the state is, blending is the pass's own.
      if (frames == 1)
      {
        CheckSame(
          check, GetName(method) + ", in an unusual state", CutState(picture), CutState(expected));
      }
    }
  }
}

void CheckViewports(Checks& check, const Method& method)
{
  PassScene alone(method);
  const Picture expected = alone.Render();
  alone.Renderer->GetActiveCamera()->SetParallelScale(1.5);
  const Picture expectedLeft = alone.Render();
  check(Compare(expectedLeft, expected).Largest > 20, "the views differ");

  for (bool isShared : { false, true })
  {
    const std::string name = GetName(method) + (isShared ? ", one pass" : ", two passes");
    PassScene stage(method, 2 * Size, Size + 30);
    stage.Renderer->SetViewport(0.5, 30.0 / (Size + 30), 1.0, 1.0);
    vtkNew<vtkRenderer> left;
    left->SetViewport(0.0, 0.0, 0.5, Size / (Size + 30.0));
    left->SetBackground(26.0 / 255.0, 0.2, 0.4);
    vtkNew<vtkCamera> camera;
    camera->DeepCopy(stage.Renderer->GetActiveCamera());
    camera->SetParallelScale(1.5);
    left->SetActiveCamera(camera);
    stage.Window->AddRenderer(left);
    // The same actors in both; the sphere comes last and has another mapper.
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    vtkCollectionSimpleIterator cookie;
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      left->AddViewProp(prop);
    }
    vtkNew<vtkFourierOpacityPass> other;
    other->SetOptimization(stage.GetOptimization());
    UsePass(left, isShared ? stage.Pass.Get() : other.Get());
    for (int i = 0; i < 2; ++i)
    {
      const Picture both = stage.Render();
      CheckSame(check, name + ", right", Cut(both, Size, 30, Size, Size), expected);
      CheckSame(check, name + ", left", Cut(both, 0, 0, Size, Size), expectedLeft);
      check(Cut(both, 0, Size, Size, 30).Bytes == Cut(both, Size, 0, Size, 30).Bytes,
        name + ": nothing is drawn beside the viewports");
    }
    // Accumulated pictures of two views do not mix.
    stage.GetOptimization()->SetAccumulationFrames(2);
    stage.Render();
    const Picture mean = stage.Render();
    check(Compare(Cut(mean, Size, 30, Size, Size), expected).Rms < 15.0 &&
        Compare(Cut(mean, 0, 0, Size, Size), expectedLeft).Rms < 15.0,
      name + ": accumulated");
    CheckSame(check, name + ": accumulated, again", stage.Render(), mean);
  }
}

void CheckWindows(Checks& check, const Method& method)
{
  const std::string name = GetName(method);
  PassScene first(method);
  const Picture expected = first.Render();
  PassScene second(method, 80, 70);
  const Picture expectedSecond = second.Render();
  // One pass and its actors in two windows in turn.
  UsePass(second.Renderer, first.Pass);
  for (std::size_t i = 0; i < second.Actors.size(); ++i)
  {
    second.Actors[i]->SetMapper(first.Actors[i]->GetMapper());
  }
  for (int i = 0; i < 2; ++i)
  {
    CheckSame(check, name + ", another window", second.Render(), expectedSecond);
    CheckSame(check, name + ", back in the first window", first.Render(), expected);
  }
  second.Window->SetSize(50, 90);
  const Picture narrow = second.Render();
  check(narrow.Width == 50 && GetCoverage(narrow, Background) > 0.1, name + ": another size");
  second.Window->SetSize(80, 70);
  CheckSame(check, name + ", another size and back", second.Render(), expectedSecond);
  second.Window->Finalize();
  CheckSame(check, name + ", after another window was closed", first.Render(), expected);
  first.Pass->ReleaseGraphicsResources(first.Window);
  check(first.Pass->GetNumberOfBytes() == 0, name + ": all is released");
  CheckSame(check, name + ", after a release of resources", first.Render(), expected);
  first.Window->Finalize();
  check(first.Pass->GetNumberOfBytes() == 0, name + ": all is released with the window");
  CheckSame(check, name + ", closed and opened again", first.Render(), expected);

  // A pass that outlives its window, and one that goes first.
  vtkNew<vtkFourierOpacityPass> pass;
  {
    PassScene brief(method);
    pass->SetOptimization(brief.GetOptimization());
    UsePass(brief.Renderer, pass);
    CheckSame(check, name + ", a window that is deleted", brief.Render(), expected);
  }
  PassScene next(method);
  UsePass(next.Renderer, pass);
  CheckSame(check, name + ", the window after it", next.Render(), expected);
}

/// Buffers and textures of the current window.
std::vector<unsigned int> GetGLObjects()
{
  std::vector<unsigned int> objects;
  for (unsigned int i = 1; i < 1000; ++i)
  {
    objects.push_back((glIsBuffer(i) ? 1 : 0) + (glIsTexture(i) ? 2 : 0));
  }
  return objects;
}

// Windows do not share buffers: those of the same number are others.
void CheckContexts(Checks& check, const Method& method)
{
  const std::string name = GetName(method);
  PassScene second(method);
  const Picture expected = second.Render();
  {
    PassScene first(method);
    auto pass = vtkSmartPointer<vtkFourierOpacityPass>::New();
    pass->SetOptimization(first.GetOptimization());
    UsePass(first.Renderer, pass);
    CheckSame(check, name + ", a pass that will go", first.Render(), expected);
    first.Renderer->SetPass(nullptr);
    second.Render();
    second.Window->MakeCurrent();
    const std::vector<unsigned int> before = GetGLObjects();
    pass = nullptr;
    second.Window->MakeCurrent();
    check(GetGLObjects() == before, name + ": a pass that goes takes nothing of another window");
    CheckSame(check, name + ", after the pass of another window", second.Render(), expected);
    UsePass(first.Renderer, first.Pass);
    CheckSame(check, name + ", another pass in its window", first.Render(), expected);
  }

  // The window is closed while it is not drawn by the pass, and lives on.
  PassScene closed(method);
  CheckSame(check, name + ", a window that will be closed", closed.Render(), expected);
  closed.Renderer->SetPass(nullptr);
  closed.Window->Finalize();
  second.Window->MakeCurrent();
  const std::vector<unsigned int> before = GetGLObjects();
  UsePass(second.Renderer, closed.Pass);
  for (int i = 0; i < 2; ++i)
  {
    CheckSame(check, name + ", the pass of a closed window", second.Render(), expected);
    check(glGetError() == GL_NO_ERROR, name + ": error of OpenGL after a window was closed");
  }
  const std::vector<unsigned int> after = GetGLObjects();
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    check((before[i] & ~after[i]) == 0,
      name + ": a pass from a closed window deleted object " + std::to_string(i + 1));
  }
}

// Textures of another size are drawn to, whatever is attached in between.
void CheckSizes(Checks& check)
{
  PassScene scene;
  for (int blending = 0; blending < 6; ++blending)
  {
    for (int importance : { Optimization::SeriesImportance, Optimization::ExactImportance })
    {
      const Method method{ blending, importance };
      SetMethod(scene.GetOptimization(), method);
      const Picture expected = scene.Render();
      check(GetCoverage(expected, Background) > 0.2, GetName(method) + ": something is drawn");
      scene.Window->SetSize(Size + 20, Size);
      CheckSame(check, GetName(method) + ", another size", Cut(scene.Render(), 10, 0, Size, Size),
        expected, 2);
      scene.Window->SetSize(Size, Size);
      CheckSame(check, GetName(method) + ", another size and back", scene.Render(), expected);
    }
  }
}

void CheckSamples(Checks& check, const Method& method)
{
  PassScene plain(method);
  const Picture expected = plain.Render();
  PassScene samples(method);
  samples.Window->SetMultiSamples(4);
  const Difference difference = Compare(samples.Render(), expected);
  check(difference.Part < 0.06 && difference.Rms < 12.0,
    GetName(method) + ", four samples" + VoxelLineMapperTesting::Describe(difference));
  PassScene screen(method);
  screen.Window->SetOffScreenRendering(0);
  const Picture picture = screen.Render();
  // A window manager may give it another size.
  if (picture.Width == Size && picture.Height == Size)
  {
    CheckSame(check, GetName(method) + ", on the screen", picture, expected, 1);
  }
}

// Within a pass of samples the picture is larger than the window.
void CheckSuperSampling(Checks& check, const Method& method)
{
  PassScene scene(method);
  const Picture expected = scene.Render();
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(scene.Pass);
  vtkNew<vtkSSAAPass> samples;
  samples->SetDelegatePass(steps);
  vtkOpenGLRenderer::SafeDownCast(scene.Renderer)->SetPass(samples);
  const Difference difference = Compare(scene.Render(), expected);
  check(difference.Part < 0.15 && difference.Rms < 8.0,
    GetName(method) + ", a pass of samples" + VoxelLineMapperTesting::Describe(difference));

  // The mapper by itself, and a mean that begins anew where the number of pixels changes.
  Scene alone(method);
  alone.GetOptimization()->SetAccumulationFrames(4);
  alone.Render();
  alone.Render();
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(alone.Renderer);
  vtkNew<vtkRenderStepsPass> plain;
  plain->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkSSAAPass> other;
  other->SetDelegatePass(plain);
  renderer->SetPass(other);
  for (int i = 0; i < 2; ++i)
  {
    const Difference own = Compare(alone.Render(), expected);
    check(own.Part < 0.15 && own.Rms < 8.0,
      GetName(method) + ", the mapper in a pass of samples" +
        VoxelLineMapperTesting::Describe(own));
  }
}

void CheckEmpty(Checks& check)
{
  PassStage stage;
  const Picture empty = stage.Render();
  check(GetCoverage(empty, Background) == 0.0, "an empty renderer is empty");
  check(stage.Pass->GetNumberOfBytes() == 0 && stage.Pass->GetNumberOfRenderedProps() == 0 &&
      stage.Pass->GetNumberOfAccumulatedPictures() == 0,
    "nothing is made for an empty renderer");
  vtkNew<vtkPolyData> nothing;
  stage.AddItem(nothing);
  for (int method = 0; method < 6; ++method)
  {
    stage.GetOptimization()->SetBlending(method);
    check(GetCoverage(stage.Render(), Background) == 0.0, "an actor of nothing");
  }
  auto actor = stage.AddItem(MakeStack({ { 0.0, 0.0, 0.0, 0.5, { 200, 100, 50, 255 } } }));
  CheckColor(check, "beside an actor of nothing", stage.Render().At(30, 30), { 200, 100, 50 }, 1.0);
  actor->VisibilityOff();
  check(GetCoverage(stage.Render(), Background) == 0.0, "hidden beside an actor of nothing");
}

std::set<const vtkObjectBase*> SelectActors(vtkRenderer* renderer, int x1, int y1, int x2, int y2)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(x1, y1, x2, y2);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<const vtkObjectBase*> actors;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    actors.insert(selection->GetNode(i)->GetProperties()->Get(vtkSelectionNode::PROP()));
  }
  return actors;
}

// An unimportant actor in front of an important one, and one beside them.
void CheckSelection(Checks& check)
{
  PassStage stage(32, 32);
  auto front = stage.AddItem(MakeStack({ { -0.4, 0.0, 0.5, 0.3, { 255, 255, 255, 255 } } }));
  auto important =
    stage.AddItem(MakeStack({ { -0.4, 0.0, -0.5, 0.3, { 255, 0, 0, 255 } } }, { 1.0 }));
  auto beside = stage.AddItem(MakeStack({ { 0.5, 0.0, 0.5, 0.3, { 0, 255, 0, 255 } } }));
  const Picture before = stage.Render();
  auto* renderer = vtkOpenGLRenderer::SafeDownCast(stage.Renderer);
  vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  using Actors = std::set<const vtkObjectBase*>;
  renderer->SetPass(nullptr);
  check(SelectActors(stage.Renderer, 8, 14, 11, 17) == Actors{ important.Get() },
    "what is faint is not selected");
  check(SelectActors(stage.Renderer, 22, 14, 26, 17) == Actors{ beside.Get() },
    "what is opaque is selected");
  check(SelectActors(stage.Renderer, 14, 2, 17, 4).empty(), "nothing is selected of nothing");
  renderer->SetPass(pass);
  CheckSame(check, "selection does not disturb the picture", stage.Render(), before);
  stage.GetOptimization()->SetForegroundWeight(0.0);
  stage.Render();
  renderer->SetPass(nullptr);
  check(SelectActors(stage.Renderer, 8, 14, 11, 17) == Actors{ front.Get() },
    "opacities of the pass's last picture count");
  renderer->SetPass(pass);
  // Without its pass, nothing is known of what is faint.
  stage.GetOptimization()->SetForegroundWeight(50.0);
  stage.Render();
  UsePass(stage.Renderer, vtkNew<vtkTranslucentPass>());
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  renderer->SetPass(nullptr);
  check(SelectActors(stage.Renderer, 8, 14, 11, 17) == Actors{ front.Get() }, "after a release");
}

// An important actor between two unimportant ones, seen from either side by one pass.
void CheckSelectionOfViews(Checks& check)
{
  PassStage stage(64, 32);
  stage.GetOptimization()->SetBackgroundWeight(0.0);
  const auto add = [&](double z, double importance) {
    return stage.AddItem(MakeStack({ { 0.0, 0.0, z, 0.4, { 0, 255, 0, 255 } } }, { importance }));
  };
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> behind;
  behind->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(stage.Renderer->GetActiveCamera());
  camera->SetPosition(0.0, 0.0, -10.0);
  behind->SetActiveCamera(camera);
  const auto front = add(0.5, 0.0);
  const auto important = add(0.0, 1.0);
  const auto back = add(-0.5, 0.0);
  for (vtkActor* actor : { front.Get(), important.Get(), back.Get() })
  {
    behind->AddActor(actor);
  }
  stage.Window->AddRenderer(behind);
  UsePass(behind, stage.Pass);
  const Picture before = stage.Render();
  const std::set<const vtkObjectBase*> expected{ important.Get() };
  for (int i = 0; i < 2; ++i)
  {
    // The other view is drawn as well, by the pass.
    vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(nullptr);
    check(SelectActors(stage.Renderer, 14, 14, 17, 17) == expected, "selection from the front");
    UsePass(stage.Renderer, stage.Pass);
    vtkOpenGLRenderer::SafeDownCast(behind)->SetPass(nullptr);
    check(SelectActors(behind, 46, 14, 49, 17) == expected, "selection from behind");
    UsePass(behind, stage.Pass);
  }
  CheckSame(check, "selection of two views does not disturb", stage.Render(), before);
}
}

int TestFourierOpacityPassWindows(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  for (const Method& method : Methods)
  {
    CheckState(check, method);
  }
  for (const Method& method : { Methods[0], Methods[3] })
  {
    CheckViewports(check, method);
    CheckWindows(check, method);
    CheckContexts(check, method);
  }
  CheckSamples(check, Methods[0]);
  CheckSuperSampling(check, Methods[0]);
  CheckSuperSampling(check, Methods[3]);
  CheckSizes(check);
  CheckEmpty(check);
  CheckSelection(check);
  CheckSelectionOfViews(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
