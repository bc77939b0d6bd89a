// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFourierOpacityMapper against what surrounds it: several viewports, windows in turn,
// closed and opened again, of another size, with samples, in tiles; parallel and perspective views.

#include "FourierOpacityScene.h"
#include "vtkImageData.h"
#include "vtkWindowToImageFilter.h"

using namespace FourierOpacityTesting;

namespace
{
constexpr int Size = SceneSize;

constexpr Method Methods[] = { { Optimization::Fourier, Optimization::SeriesImportance },
  { Optimization::WeightedAverage, Optimization::ExactImportance },
  { Optimization::FragmentLists, Optimization::ExactImportance } };

void CheckViewports(Checks& check, const Method& method)
{
  Scene alone(method);
  const Picture expected = alone.Render();
  check(GetCoverage(expected, Background) > 0.3, GetName(method) + ": something is drawn");

  Scene stage(method, 2 * Size, Size + 30);
  stage.Renderer->SetViewport(0.5, 30.0 / (Size + 30), 1.0, 1.0);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  left->SetBackground(26.0 / 255.0, 0.2, 0.4);
  left->AddActor(stage.Actor);
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(stage.Renderer->GetActiveCamera());
  camera->SetParallelScale(1.5);
  left->SetActiveCamera(camera);
  stage.Window->AddRenderer(left);
  const Picture both = stage.Render();
  CheckSame(check, GetName(method) + ", a viewport", Cut(both, Size, 30, Size, Size), expected);
  check(GetCoverage(Cut(both, 0, 0, Size, Size + 30), Background) > 0.1,
    GetName(method) + ": the other viewport");
  // The same again: no view takes what belongs to the other.
  CheckSame(check, GetName(method) + ", viewports again", stage.Render(), both);
}

void CheckWindows(Checks& check, const Method& method)
{
  const std::string name = GetName(method);
  Scene first(method);
  const Picture expected = first.Render();
  CheckSame(check, name + ", again", first.Render(), expected);

  // The same mapper in two windows in turn, of other sizes.
  Scene second(method, 80, 70);
  const Picture expectedSecond = second.Render();
  second.Actor->SetMapper(first.Mapper);
  for (int i = 0; i < 2; ++i)
  {
    CheckSame(check, name + ", another window", second.Render(), expectedSecond);
    CheckSame(check, name + ", back in the first window", first.Render(), expected);
  }
  second.Window->SetSize(50, 90);
  const Picture narrow = second.Render();
  second.Window->SetSize(80, 70);
  CheckSame(check, name + ", another size and back", second.Render(), expectedSecond);
  check(narrow.Width == 50 && GetCoverage(narrow, Background) > 0.1, name + ": another size");
  second.Window->Finalize();
  CheckSame(check, name + ", after another window was closed", first.Render(), expected);
  first.Mapper->ReleaseGraphicsResources(first.Window);
  CheckSame(check, name + ", after a release of resources", first.Render(), expected);
  first.Window->Finalize();
  CheckSame(check, name + ", closed and opened again", first.Render(), expected);
}

void CheckSamples(Checks& check, const Method& method)
{
  Scene plain(method);
  const Picture expected = plain.Render();
  Scene samples(method);
  samples.Window->SetMultiSamples(4);
  const Picture picture = samples.Render();
  // Edges of what is opaque are smooth.
  const Difference difference = Compare(picture, expected);
  check(difference.Part < 0.06 && difference.Rms < 12.0,
    GetName(method) + ", four samples" + VoxelLineMapperTesting::Describe(difference));
}

void CheckProjections(Checks& check, const Method& method)
{
  Scene stage(method);
  const Picture expected = stage.Render();
  // From so far away that rays are nearly parallel.
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  const double distance = 400.0;
  camera->SetPosition(0.0, 0.0, distance);
  camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(1.0 / distance)));
  camera->SetClippingRange(distance - 2.0, distance + 2.0);
  for (bool isLogarithmic : { false, true })
  {
    stage.GetOptimization()->SetDepthScale(isLogarithmic);
    const Difference difference = Compare(stage.Render(), expected);
    check(difference.Rms < 3.0,
      GetName(method) + ", perspective" + VoxelLineMapperTesting::Describe(difference));
  }
  // From within the scene: what is behind the viewer is not there.
  camera->SetPosition(0.0, 0.0, 0.5);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(0.01, 5.0);
  check(GetCoverage(stage.Render(), Background) > 0.1, GetName(method) + ": from within");
}

// What hides something important in one tile only has one opacity in all of them, that of the
// window's own picture; without that one, a warning says that tiles are on their own.
void CheckTiles(Checks& check, const Method& method, Messages* messages)
{
  const std::string name = GetName(method) + ", tiles";
  const auto grab = [](vtkRenderWindow* window)
  {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetScale(2);
    filter->ReadFrontBufferOff();
    filter->FixBoundaryOff();
    filter->Update();
    Picture picture;
    picture.Width = filter->GetOutput()->GetDimensions()[0];
    picture.Height = filter->GetOutput()->GetDimensions()[1];
    auto* bytes =
      vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
    picture.Bytes.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
    return picture;
  };
  // A wide context before something important on the left.
  const auto scene = MakeStack({ { 0.0, 0.0, 0.5, 0.8, { 255, 255, 255, 255 } },
                                 { -0.5, -0.5, -0.5, 0.2, { 255, 0, 0, 255 } } },
    { 0.0, 1.0 });
  OpacityStage stage(Size, Size);
  SetMethod(stage.GetOptimization(), method);
  stage.Mapper->SetNumberOfPatches(2);
  stage.Mapper->SetInputData(scene);
  const auto context = stage.Stage::Render().At(Size * 3 / 4, Size * 3 / 4);
  const Picture tiled = grab(stage.Window);
  for (int x : { Size / 2, Size * 3 / 2 })
  {
    for (int y : { Size * 3 / 4, Size * 3 / 2 })
    {
      check(IsNear(tiled.At(x, y), context, 1),
        name + VoxelLineMapperTesting::Describe(tiled.At(x, y)) + " instead of" +
          VoxelLineMapperTesting::Describe(context));
    }
  }
  check(messages->IsQuiet(), name + ": nothing is said");
  // A picture of the window again, as it was.
  check(IsNear(stage.Stage::Render().At(Size * 3 / 4, Size * 3 / 4), context, 1), name + ": after");

  // On their own: without a picture of the whole before, from elsewhere, or with other weights. The
  // first tile is that on the left below.
  for (const char* what : { "no picture", "another view", "other weights" })
  {
    OpacityStage fresh(Size, Size);
    SetMethod(fresh.GetOptimization(), method);
    fresh.Mapper->SetNumberOfPatches(2);
    fresh.Mapper->SetInputData(MakeStack({ { 0.0, 0.0, 0.5, 0.8, { 255, 255, 255, 255 } },
                                           { 0.5, 0.5, -0.5, 0.2, { 255, 0, 0, 255 } } },
      { 0.0, 1.0 }));
    if (what[0] != 'n')
    {
      fresh.Stage::Render();
    }
    if (what[0] == 'a')
    {
      fresh.Renderer->GetActiveCamera()->SetPosition(0.01, 0.0, 10.0);
    }
    if (what[0] == 'o')
    {
      fresh.GetOptimization()->SetForegroundWeight(60.0);
    }
    for (int i = 0; i < 2; ++i)
    {
      const Picture alone = grab(fresh.Window);
      check(IsNear(alone.At(Size / 2, Size / 2), { 255, 255, 255 }, 1) &&
          IsNear(alone.At(Size * 3 / 2, Size * 5 / 4), context, 12),
        name + " alone, " + what + VoxelLineMapperTesting::Describe(alone.At(Size / 2, Size / 2)) +
          VoxelLineMapperTesting::Describe(alone.At(Size * 3 / 2, Size * 5 / 4)));
    }
    check(messages->TakeWarnings("tiles") == 1, name + ": one warning, " + what);
  }

  // Beside another renderer, which some tiles do not show.
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(stage.Renderer->GetBackground());
  right->AddActor(stage.Actor);
  right->GetActiveCamera()->DeepCopy(stage.Renderer->GetActiveCamera());
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  stage.Window->AddRenderer(right);
  stage.Stage::Render();
  const Picture both = grab(stage.Window);
  for (int x : { Size / 2, Size * 3 / 2 })
  {
    check(IsNear(both.At(x, Size * 5 / 4), context, 1),
      name + ", two renderers" + VoxelLineMapperTesting::Describe(both.At(x, Size * 5 / 4)));
  }
  // VTK 9.6 draws translucent actors of any kind into framebuffers without a pixel, and says so.
  check(messages->TakeWarnings("Invalid framebuffer operation") >= 0 && messages->IsQuiet(),
    name + ": nothing is said of two renderers");
}
}

int TestFourierOpacityWindows(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  for (const Method& method : Methods)
  {
    CheckViewports(check, method);
    CheckWindows(check, method);
    CheckSamples(check, method);
    CheckProjections(check, method);
    CheckTiles(check, method, messages);
  }
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
