// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the mapper's way with windows: several viewports, several windows and actors, a change of
// size, tiled output, release of resources and drawing again, viewports of no size, a model shared
// by two mappers, culling of faces, and clipping planes.

#include "VoxelLineMapperTesting.h"
#include "vtkLineVoxelizer.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

using namespace VoxelLineMapperTesting;

namespace
{
vtkSmartPointer<vtkVoxelLineMapper> MakeMapper(vtkPolyData* lines, double radius = 0.04)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(radius);
  mapper->SetResolution(64);
  mapper->SetFaceBins(0);
  return mapper;
}

void SetCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(4.0, 3.0, 3.5);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(2.0, 10.0);
}

// The picture of the lines, and of a sphere, alone in a window of this size.
Picture DrawAlone(vtkPolyData* lines, int width, int height, double opacity, bool withSphere = true)
{
  Stage stage(width, height);
  stage.Add(MakeMapper(lines), opacity);
  stage.AddSphere(0.5, 0.3, 0.2, 0.4)->SetVisibility(withSphere);
  SetCamera(stage.Renderer);
  return stage.Render();
}

Picture Cut(const Picture& whole, int x, int y, int width, int height)
{
  Picture part;
  part.Width = width;
  part.Height = height;
  for (int row = y; row < y + height; ++row)
  {
    const auto* first = whole.Bytes.data() + 3 * (static_cast<std::size_t>(row) * whole.Width + x);
    part.Bytes.insert(part.Bytes.end(), first, first + 3 * static_cast<std::size_t>(width));
  }
  return part;
}

void CheckSame(Checks& check, const Picture& a, const Picture& b, const std::string& what)
{
  const Difference difference = Compare(a, b);
  // Depth peeling keeps its sums in 8 bits.
  check(difference.Largest <= 2, what + Describe(difference));
}

// One mapper in two viewports of one window, with other cameras and opacities.
void CheckViewports(Checks& check, vtkPolyData* lines, double opacity, bool peeling)
{
  auto mapper = MakeMapper(lines);
  Stage stage(300, 150);
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(26.0 / 255.0, 0.2, 0.4);
  stage.Window->AddRenderer(right);
  for (vtkRenderer* renderer : { stage.Renderer.Get(), right.Get() })
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(opacity);
    renderer->AddActor(actor);
    Stage other;
    auto sphere = other.AddSphere(0.5, 0.3, 0.2, 0.4);
    // Only on the right: what one viewport holds must not cut the rays of the other.
    sphere->SetVisibility(renderer == right);
    renderer->AddActor(sphere);
    renderer->SetUseDepthPeeling(peeling);
    SetCamera(renderer);
  }
  stage.Window->Render();
  const Picture both = stage.Render();
  const Picture leftAlone = DrawAlone(lines, 150, 150, opacity, false);
  const Picture rightAlone = DrawAlone(lines, 150, 150, opacity);
  check(GetCoverage(leftAlone, Background) > 0.1, "something is seen");
  CheckSame(check, Cut(both, 0, 0, 150, 150), leftAlone, "the left viewport");
  CheckSame(check, Cut(both, 150, 0, 150, 150), rightAlone, "the right viewport");
  check(mapper->GetNumberOfPictures() == 4, "one picture for each viewport and frame");

  // Small and outside the others' aspect.
  right->SetViewport(0.8, 0.6, 0.9, 0.9);
  const Picture small = stage.Render();
  CheckSame(check, Cut(small, 0, 0, 150, 150), leftAlone, "the left viewport beside a small one");
}

// One mapper in two windows at once, drawn in turns.
void CheckWindows(Checks& check, vtkPolyData* lines, double opacity)
{
  auto mapper = MakeMapper(lines);
  const Picture large = DrawAlone(lines, 200, 160, opacity);
  const Picture small = DrawAlone(lines, 90, 110, opacity);
  Stage first(200, 160);
  Stage second(90, 110);
  for (Stage* stage : { &first, &second })
  {
    stage->Add(mapper, opacity);
    stage->AddSphere(0.5, 0.3, 0.2, 0.4);
    SetCamera(stage->Renderer);
  }
  for (int i = 0; i < 2; ++i)
  {
    CheckSame(check, first.Render(), large, "the first window");
    CheckSame(check, second.Render(), small, "the second window");
  }
}

void CheckResize(Checks& check, vtkPolyData* lines, double opacity)
{
  Stage stage(200, 160);
  stage.Add(MakeMapper(lines), opacity);
  stage.AddSphere(0.5, 0.3, 0.2, 0.4);
  SetCamera(stage.Renderer);
  const int sizes[][2] = { { 200, 160 }, { 90, 110 }, { 210, 60 } };
  for (const auto& size : sizes)
  {
    stage.Window->SetSize(size[0], size[1]);
    CheckSame(check, stage.Render(), DrawAlone(lines, size[0], size[1], opacity),
      "after a change of size to " + std::to_string(size[0]));
  }
}

// Release, draw again; release twice; the window goes before the mapper.
void CheckRelease(Checks& check, vtkPolyData* lines, double opacity)
{
  const Picture alone = DrawAlone(lines, 200, 160, opacity);
  auto mapper = MakeMapper(lines);
  {
    Stage stage;
    stage.Add(mapper, opacity);
    stage.AddSphere(0.5, 0.3, 0.2, 0.4);
    SetCamera(stage.Renderer);
    CheckSame(check, stage.Render(), alone, "before release");
    check(mapper->GetGraphicsMemory() > 0, "graphics memory is told");
    vtkVoxelLineModel* model = mapper->GetModel();
    mapper->ReleaseGraphicsResources(stage.Window);
    check(mapper->GetGraphicsMemory() == 0, "no graphics memory after release");
    mapper->ReleaseGraphicsResources(stage.Window);
    CheckSame(check, stage.Render(), alone, "after release");
    check(mapper->GetModel() == model, "the model outlives a release");
    stage.Window->Finalize();
  }
  Stage stage;
  stage.Add(mapper, opacity);
  stage.AddSphere(0.5, 0.3, 0.2, 0.4);
  SetCamera(stage.Renderer);
  CheckSame(check, stage.Render(), alone, "in another window after the first is gone");
}

void CheckTiles(Checks& check, vtkPolyData* lines, double opacity)
{
  Stage stage(100, 80);
  stage.Add(MakeMapper(lines), opacity);
  stage.AddSphere(0.5, 0.3, 0.2, 0.4);
  SetCamera(stage.Renderer);
  stage.Render();
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(stage.Window);
  filter->SetScale(3);
  filter->ReadFrontBufferOff();
  filter->FixBoundaryOff();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  Picture tiled;
  tiled.Width = image->GetDimensions()[0];
  tiled.Height = image->GetDimensions()[1];
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  tiled.Bytes.assign(bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues());
  const Difference difference = Compare(tiled, DrawAlone(lines, 300, 240, opacity));
  // The tiles' cameras are rounded in other ways: single pixels at edges of lines.
  check(difference.Part < 2e-3, "tiles" + Describe(difference));
}

void CheckNoSize(Checks& check, vtkPolyData* lines, double opacity, Messages* messages)
{
  auto mapper = MakeMapper(lines);
  Stage stage(120, 100);
  stage.Add(mapper, opacity);
  SetCamera(stage.Renderer);
  stage.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  stage.Window->Render();
  stage.Renderer->SetViewport(0.25, 0.25, 0.2501, 0.75);
  stage.Window->Render();
  // VTK 9.6 draws translucent actors of any kind into framebuffers without a pixel, and says so.
  check(messages->TakeWarnings("Invalid framebuffer operation") >= 0,
    "nothing is said of viewports of no size");
  stage.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  stage.Window->SetSize(1, 1);
  stage.Window->Render();
  stage.Window->SetSize(120, 100);
  check(GetCoverage(stage.Render(), Background) > 0.05, "drawn again after windows of no size");
}

void CheckSharedModel(Checks& check, vtkPolyData* lines, double opacity)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(64);
  voxelizer->SetFaceBins(0);
  vtkNew<vtkVoxelLineMapper> first;
  first->SetInputConnection(voxelizer->GetOutputPort());
  first->SetRadius(0.04);
  check(first->GetModel() == voxelizer->GetOutput(), "the voxelizer's model itself");
  vtkNew<vtkVoxelLineMapper> second;
  second->SetInputData(first->GetModel());
  second->SetRadius(0.04);
  check(second->GetModel() == voxelizer->GetOutput() && second->GetModelBuildTime() == 0.0,
    "nothing is built of a shared model");
  const Picture alone = DrawAlone(lines, 200, 160, opacity);
  for (vtkVoxelLineMapper* mapper : { first.Get(), second.Get() })
  {
    Stage stage;
    stage.Add(mapper, opacity);
    stage.AddSphere(0.5, 0.3, 0.2, 0.4);
    SetCamera(stage.Renderer);
    CheckSame(check, stage.Render(), alone, "a shared model");
    double bounds[6];
    mapper->GetBounds(bounds);
    check(std::abs(bounds[4] + 1.04) < 1e-6 && std::abs(bounds[5] - 1.04) < 1e-6,
      "bounds are those of lines and radius");
  }
  // A change upstream arrives.
  voxelizer->SetResolution(32);
  check(first->GetModel()->GetDimensions()[2] <= 33, "the model is brought up to date");
}

// Two actors with one mapper in one scene, and a mirrored actor against mirrored lines.
void CheckActors(Checks& check, vtkPolyData* lines, double opacity)
{
  auto mapper = MakeMapper(lines, 0.1);
  Stage stage;
  auto left = stage.Add(mapper, opacity);
  left->SetPosition(-1.0, 0.5, 0.0);
  left->SetScale(-0.6, 0.6, 0.6);
  left->RotateX(30.0);
  auto right = stage.Add(mapper, opacity);
  right->SetPosition(1.0, -0.5, 0.0);
  right->SetScale(0.5);
  stage.Renderer->UseDepthPeelingOn();
  SetCamera(stage.Renderer);
  const Picture both = stage.Render();

  Stage other;
  for (vtkActor* actor : { left.Get(), right.Get() })
  {
    // Points and radius carried to the place; a stretched tube is no tube, so the check allows
    // more.
    vtkNew<vtkTransform> transform;
    transform->SetMatrix(actor->GetMatrix());
    vtkNew<vtkTransformFilter> filter;
    filter->SetInputData(lines);
    filter->SetTransform(transform);
    filter->Update();
    other.Add(MakeMapper(filter->GetPolyDataOutput(), actor == right ? 0.05 : 0.06), opacity);
  }
  other.Renderer->UseDepthPeelingOn();
  SetCamera(other.Renderer);
  const Difference difference = Compare(both, other.Render());
  // The grids differ: pixels at edges of lines.
  check(difference.Rms < 2.0, "actors with a matrix" + Describe(difference));
}

// Culling is about surfaces: the picture of the lines is drawn as a quad that faces the front.
void CheckCulling(Checks& check, vtkPolyData* lines, double opacity)
{
  Stage stage;
  auto actor = stage.Add(MakeMapper(lines), opacity);
  SetCamera(stage.Renderer);
  const Picture plain = stage.Render();
  actor->GetProperty()->FrontfaceCullingOn();
  check(Compare(plain, stage.Render()).Largest == 0, "with culling of front faces");
  actor->GetProperty()->BackfaceCullingOn();
  check(Compare(plain, stage.Render()).Largest == 0, "with culling of all faces");
}

void CheckClippingPlanes(Checks& check, vtkPolyData* lines)
{
  auto mapper = MakeMapper(lines);
  Stage stage;
  auto actor = stage.Add(mapper);
  actor->SetScale(1.0, 0.5, 1.0);
  SetCamera(stage.Renderer);
  stage.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 5.0);
  const double whole = GetCoverage(stage.Render(), Background);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.2, 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  mapper->AddClippingPlane(plane);
  const Picture half = stage.Render();
  const double halfCoverage = GetCoverage(half, Background);
  check(halfCoverage > 0.2 * whole && halfCoverage < 0.6 * whole, "one half is clipped");
  // The plane stands on edge: by perspective, the clipped side stays left of this column.
  double worldX = 0.0;
  for (int x = 0; x < half.Width && worldX == 0.0; ++x)
  {
    for (int y = 0; y < half.Height; ++y)
    {
      worldX = half.At(x, y) != Background ? x : worldX;
    }
  }
  check(worldX > half.Width / 2, "the side of the plane");

  // Ten more planes than OpenGL would take, in a ring: the native engine takes any number.
  mapper->RemoveAllClippingPlanes();
  for (int i = 0; i < 18; ++i)
  {
    const double angle = vtkMath::Pi() * i / 9.0;
    vtkNew<vtkPlane> side;
    side->SetOrigin(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.0);
    side->SetNormal(-std::cos(angle), -std::sin(angle), 0.0);
    mapper->AddClippingPlane(side);
  }
  mapper->SetEngineToNative();
  const double ring = GetCoverage(stage.Render(), Background);
  check(ring > 0.05 * whole && ring < 0.9 * whole, "eighteen planes");
  mapper->RemoveAllClippingPlanes();
  check(GetCoverage(stage.Render(), Background) == whole, "planes removed");
}
}

int TestVoxelLineMapperWindows(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  auto lines = MakeHelices(5, 150);
  lines->GetPointData()->SetScalars(nullptr);
  for (double opacity : { 1.0, 0.3 })
  {
    CheckViewports(check, lines, opacity, false);
    CheckViewports(check, lines, opacity, true);
    CheckWindows(check, lines, opacity);
    CheckResize(check, lines, opacity);
    CheckRelease(check, lines, opacity);
    CheckTiles(check, lines, opacity);
    CheckNoSize(check, lines, opacity, messages);
    CheckSharedModel(check, lines, opacity);
    CheckActors(check, lines, opacity);
    CheckCulling(check, lines, opacity);
  }
  CheckClippingPlanes(check, lines);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
