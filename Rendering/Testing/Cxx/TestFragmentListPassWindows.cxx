// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFragmentListPass against what surrounds it: several viewports, several windows in turn,
// windows that are closed and opened again, release of resources, a change of size, supersampling,
// hardware selection, and OpenGL's state, which is the same after the pass as before.

#include "FragmentListTesting.h"
#include "GLStateTesting.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkSSAAPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

using namespace FragmentListTesting;

namespace
{
void CheckState(Checks& check)
{
  const std::vector<Square> squares = MakeSquares(20, 5, 120);
  for (vtkIdType bytes : { vtkIdType(1) << 30, vtkIdType(16 * 600 * 7) })
  {
    ListStage stage;
    stage.Pass->SetMaximumNumberOfBytes(bytes);
    stage.AddSquares(squares);
    vtkNew<StatePass> state;
    state->Delegate = stage.Pass;
    state->HasScissor = bytes > 1000000;
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetTranslucentPass(state);
    vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(steps);
    const Picture picture = stage.Render();
    check(state->Error == GL_NO_ERROR, "error of OpenGL " + std::to_string(state->Error));
    check(state->IsSame, "the state of OpenGL is the same after the pass");
    // The scissor and the mask of the caller have had their effect.
    const Point expected = Blend(squares, Background);
    const auto left = picture.At(20, 30);
    check(IsExact({ left[0], left[1], 0 }, { expected[0], expected[1], 0.0 }, 1.0) &&
        left[2] == Background[2],
      "mask of colours" + Describe(left));
    check((picture.At(40, 30) == Background) == state->HasScissor,
      "scissor" + Describe(picture.At(40, 30)));
    check(stage.Pass->GetNumberOfFragments() == 20 * 900, "all fragments are counted");
  }
}

void CheckViewports(Checks& check)
{
  ListStage alone;
  alone.AddSquares(MakeSquares(30, 5, 120));
  Square opaque;
  opaque.HalfSize = 0.3;
  opaque.Z = 0.1;
  alone.AddSquares(std::vector<Square>{ opaque })->ForceOpaqueOn();
  const Picture expected = alone.Render();

  // One pass for two viewports, with the same scene and another one.
  ListStage stage(120, 90);
  stage.AddSquares(MakeSquares(30, 5, 120));
  stage.AddSquares(std::vector<Square>{ opaque })->ForceOpaqueOn();
  stage.Renderer->SetViewport(0.5, 1.0 / 3.0, 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 2.0 / 3.0);
  left->SetBackground(26.0 / 255.0, 0.2, 0.4);
  stage.Window->AddRenderer(left);
  left->SetActiveCamera(stage.Renderer->GetActiveCamera());
  const std::vector<Square> other = MakeSquares(3, 5, 120);
  vtkNew<vtkActor> actor;
  actor->SetMapper(MakeMapper(other));
  actor->GetProperty()->LightingOff();
  left->AddActor(actor);
  ListStage::UseLists(left, stage.Pass);
  const Picture both = stage.Render();
  int wrong = 0;
  for (int y = 0; y < 60; ++y)
  {
    for (int x = 0; x < 60; ++x)
    {
      wrong += both.At(60 + x, 30 + y) != expected.At(x, y) ? 1 : 0;
    }
  }
  check(wrong == 0, "a viewport: pixels that differ: " + std::to_string(wrong));
  check(IsExact(both.At(30, 30), Blend(other, Background), 1.0), "the other viewport");
}

void CheckWindows(Checks& check, Messages* messages)
{
  ListStage first;
  const std::vector<Square> squares = MakeSquares(30, 5, 120);
  auto mapper = MakeMapper(squares);
  first.AddSquares(mapper);
  const Picture expected = first.Render();

  // The same pass and mapper in two windows in turn, of other sizes.
  ListStage second(80, 70);
  ListStage::UseLists(second.Renderer, first.Pass);
  second.AddSquares(mapper);
  for (int i = 0; i < 2; ++i)
  {
    const auto color = second.Render().At(40, 35);
    check(IsExact(color, Blend(squares, Background), 1.0), "another window" + Describe(color));
    check(first.Render().Bytes == expected.Bytes, "back in the first window");
  }
  second.Window->SetSize(50, 90);
  check(IsExact(second.Render().At(25, 45), Blend(squares, Background), 1.0), "another size");
  second.Window->Finalize();
  check(first.Render().Bytes == expected.Bytes, "after another window was closed");

  first.Pass->ReleaseGraphicsResources(first.Window);
  check(first.Pass->GetNumberOfBytes() == 0, "all is released");
  check(first.Render().Bytes == expected.Bytes, "after a release of resources");
  first.Window->Finalize();
  check(first.Pass->GetNumberOfBytes() == 0, "all is released with the window");
  check(first.Render().Bytes == expected.Bytes, "a window that was closed and opened again");
  check(messages->IsQuiet(), "nothing is said about windows");

  // A pass that outlives its window.
  vtkNew<vtkFragmentListPass> pass;
  {
    ListStage brief;
    ListStage::UseLists(brief.Renderer, pass);
    brief.AddSquares(squares);
    check(brief.Render().Bytes == expected.Bytes, "a window that is deleted");
  }
  ListStage next;
  ListStage::UseLists(next.Renderer, pass);
  next.AddSquares(squares);
  check(next.Render().Bytes == expected.Bytes, "the window after it");
}

void CheckSuperSampling(Checks& check)
{
  ListStage stage;
  const std::vector<Square> squares = MakeSquares(30, 5, 120);
  stage.AddSquares(squares);
  vtkNew<vtkRenderStepsPass> steps;
  steps->SetTranslucentPass(stage.Pass);
  vtkNew<vtkSSAAPass> samples;
  samples->SetDelegatePass(steps);
  vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(samples);
  const auto color = stage.Render().At(30, 30);
  check(
    IsExact(color, Blend(squares, Background), 1.5), "within a pass of samples" + Describe(color));
  check(stage.Pass->GetNumberOfFragments() > 30 * 900, "there are more pixels there");
}

// VTK selects only where the renderer has no pass of its own; a pass must not be disturbed.
void CheckSelection(Checks& check)
{
  ListStage stage;
  auto actor = stage.AddSquares(MakeSquares(1, 100, 100));
  const Picture before = stage.Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(20, 20, 40, 40);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  check(stage.Pass->GetNumberOfFragments() == 0, "a selector is drawn by the delegate");
  check(stage.Render().Bytes == before.Bytes, "selection does not disturb the picture");

  auto* renderer = vtkOpenGLRenderer::SafeDownCast(stage.Renderer);
  vtkSmartPointer<vtkRenderPass> pass = renderer->GetPass();
  renderer->SetPass(nullptr);
  selection.TakeReference(selector->Select());
  renderer->SetPass(pass);
  check(selection && selection->GetNumberOfNodes() == 1 &&
      selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()) == actor.Get(),
    "selection finds the actor while the pass is off");
  check(stage.Render().Bytes == before.Bytes, "the pass after selection without it");
}
}

int TestFragmentListPassWindows(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckState(check);
  CheckViewports(check);
  CheckWindows(check, messages);
  CheckSuperSampling(check);
  CheckSelection(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
