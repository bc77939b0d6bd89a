// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFourierOpacityMapper among other translucent props, by VTK's ways to draw these, where
// depth peeling, which blends by a maximum, shows what is shown without it, with any method;
// clipping planes, lookup tables and textures of colours, changes of which show in the next
// picture; drawing with a subset of what is summed; lists that do not fit into memory; and hardware
// selection, which leaves out what is faint, for each of two views by its own picture.

#include "FourierOpacityScene.h"
#include "RenderPassTesting.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkLookupTable.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <set>

using namespace FourierOpacityTesting;

namespace
{
// Half transparent squares, and one of another actor in front of all of them or behind.
void CheckPasses(Checks& check)
{
  const std::vector<Square> squares = { { 0.0, 0.0, 0.3, 0.5, { 200, 30, 30, 120 } },
    { 0.0, 0.0, -0.3, 0.5, { 10, 220, 90, 160 } } };
  for (Pass pass : { Independent, Peeling, Plain })
  {
    for (double z : { 0.8, -0.8 })
    {
      OpacityStage stage;
      SetPass(stage, pass);
      stage.GetOptimization()->SetBlendingToFragmentLists();
      stage.Mapper->SetInputData(MakeStack(squares));
      const Square other{ 0.0, 0.0, z, 0.5, { 20, 60, 240, 130 } };
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(MakeStack({ other }));
      auto actor = stage.Add(mapper);
      actor->GetProperty()->LightingOff();
      if (z > 0.0 || pass != Plain)
      {
        std::vector<Square> all = squares;
        all.push_back(other);
        // VTK's order-independent translucency takes weighted means of layers.
        const double tolerance = pass == Independent ? 60.0 : 2.5;
        for (int i = 0; i < 2; ++i)
        {
          CheckColor(check, std::string(PassNames[pass]) + ", square at " + std::to_string(z),
            stage.Stage::Render().At(16, 16), Blend(all, Background), tolerance);
        }
      }
      // Without the other one all passes show the same.
      actor->VisibilityOff();
      CheckColor(check, std::string(PassNames[pass]) + ", alone", stage.Stage::Render().At(16, 16),
        Blend(squares, Background), 2.0);
    }
  }
}

// Peeling changes nothing, neither for a picture nor for a mean of several.
void CheckPeeling(Checks& check)
{
  Scene plain;
  Scene peeled;
  SetPass(plain, Plain);
  SetPass(peeled, Peeling);
  for (int blending = 0; blending < 6; ++blending)
  {
    for (int importance : { Optimization::SeriesImportance, Optimization::ExactImportance })
    {
      const Method method{ blending, importance };
      SetMethod(plain.GetOptimization(), method);
      SetMethod(peeled.GetOptimization(), method);
      for (int frames : { 1, 2 })
      {
        plain.GetOptimization()->SetAccumulationFrames(frames);
        peeled.GetOptimization()->SetAccumulationFrames(frames);
        for (int i = 0; i <= frames; ++i)
        {
          CheckSame(check,
            GetName(method) + ", peeled, picture " + std::to_string(i) + " of " +
              std::to_string(frames),
            peeled.Render(), plain.Render(), 2);
        }
      }
    }
  }
}

// A layer just in front of an opaque actor is not hidden by it, whatever depth the picture is
// given.
void CheckNearDepths(Checks& check)
{
  for (int method = 0; method < 6; ++method)
  {
    OpacityStage stage;
    stage.GetOptimization()->SetBlending(method);
    auto opaque = stage.Add(vtkNew<vtkPolyDataMapper>());
    vtkPolyDataMapper::SafeDownCast(opaque->GetMapper())
      ->SetInputData(MakeStack({ { 0.0, 0.0, 0.0, 0.5, { 0, 0, 250, 255 } } }));
    opaque->GetProperty()->LightingOff();
    opaque->ForceOpaqueOn();
    for (double gap : { 0.1, 1e-3, 1e-4, 2e-5 })
    {
      std::vector<Square> squares{ { 0.0, 0.0, 0.0, 0.5, { 250, 250, 0, 128 } } };
      // Depths that half floats cannot hold.
      for (double z : { 0.0123, 0.3217, 0.61803, -0.2345, -0.7071 })
      {
        opaque->SetPosition(0.0, 0.0, z - gap);
        squares[0].Z = z;
        std::vector<Square> drawn = squares;
        AddEnds(drawn);
        CheckColor(check,
          std::string(MethodNames[method]) + ", " + std::to_string(gap) + " before an opaque actor",
          stage.Render(MakeStack(drawn)).At(16, 16), Blend(squares, { 0, 0, 250 }), 2.0);
      }
    }
  }
}

// Clipping, colours and their tables are those of vtkPolyDataMapper, and change with the next
// picture.
void CheckColors(Checks& check)
{
  for (int method : { Optimization::Fourier, Optimization::Bins, Optimization::FragmentLists })
  {
    const std::string name = MethodNames[method];
    OpacityStage stage;
    stage.GetOptimization()->SetBlending(method);
    auto data = MakeStack({ { 0.0, 0.0, 0.2, 0.6, { 0, 0, 0, 0 } } });
    data->GetCellData()->SetScalars(nullptr);
    vtkNew<vtkDoubleArray> values;
    for (int i = 0; i < 4; ++i)
    {
      values->InsertNextValue(0.5);
    }
    data->GetPointData()->SetScalars(values);
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(2);
    table->SetTableRange(0.0, 1.0);
    table->SetTableValue(0, 1.0, 0.0, 0.0, 1.0);
    table->SetTableValue(1, 0.0, 1.0, 0.0, 1.0);
    table->Build();
    stage.Mapper->SetLookupTable(table);
    stage.Mapper->SetScalarRange(0.0, 1.0);
    stage.Mapper->SetInputData(data);
    CheckColor(check, name + ", table", stage.Stage::Render().At(16, 16), { 0, 255, 0 }, 1.0);
    table->SetTableValue(1, 0.0, 0.0, 1.0, 0.5);
    table->Modified();
    CheckColor(
      check, name + ", changed table", stage.Stage::Render().At(16, 16), { 13, 25.5, 178.5 }, 1.6);
    stage.Mapper->ScalarVisibilityOff();
    stage.Actor->GetProperty()->SetColor(1.0, 1.0, 0.0);
    stage.Actor->GetProperty()->SetOpacity(0.5);
    CheckColor(check, name + ", colour of the property", stage.Stage::Render().At(16, 16),
      { 140.5, 153.0, 51.0 }, 1.6);
    stage.Actor->GetProperty()->SetOpacity(1.0);
    CheckColor(check, name + ", opacity of the property", stage.Stage::Render().At(16, 16),
      { 255, 255, 0 }, 1.0);
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.0, 0.0);
    stage.Mapper->AddClippingPlane(plane);
    const Picture clipped = stage.Stage::Render();
    check(clipped.At(10, 16) == Background && IsNear(clipped.At(22, 16), { 255, 255, 0 }, 1),
      name + ": clipping plane");
    stage.Mapper->RemoveAllClippingPlanes();
    CheckColor(check, name + ", no plane", stage.Stage::Render().At(10, 16), { 255, 255, 0 }, 1.0);
    stage.Actor->VisibilityOff();
    check(stage.Stage::Render().At(16, 16) == Background, name + ": not visible");
  }
}

// All is drawn, though sums are taken over a part.
void CheckSubset(Checks& check)
{
  std::vector<Square> squares;
  for (int i = 0; i < 40; ++i)
  {
    squares.push_back({ 0.0, 0.0, 0.8 - 0.04 * i, 0.5, { 220, 110, 30, 20 } });
  }
  for (int method : { Optimization::Fourier, Optimization::PaperFourier, Optimization::Bins })
  {
    OpacityStage stage;
    stage.GetOptimization()->SetBlending(method);
    const auto all = stage.Render(MakeStack(squares)).At(16, 16);
    for (int n : { 2, 4, 10000 })
    {
      stage.GetOptimization()->SetSubset(n);
      const auto part = stage.Stage::Render().At(16, 16);
      const std::string name =
        std::string(MethodNames[method]) + ", subset of " + std::to_string(n);
      check(part[0] > Background[0], name + ": is drawn");
      // Every fourth of forty alike squares stands for all.
      check(n > 4 || IsNear(part, all, 12), name + VoxelLineMapperTesting::Describe(part));
    }
  }
}

void CheckMemory(Checks& check, Messages* messages)
{
  OpacityStage stage(256, 8);
  stage.GetOptimization()->SetBlendingToFragmentLists();
  std::vector<Square> squares = MakeSquares(300, 1, 5);
  for (Square& square : squares)
  {
    square.HalfSize = 40.0;
  }
  stage.Mapper->SetInputData(MakeStack(squares));
  stage.GetOptimization()->SetMaximumListMemory(1);
  stage.Stage::Render();
  stage.Stage::Render();
  // A row of 256 pixels with 300 fragments of 16 bytes is more than 1 MiB.
  check(stage.Mapper->GetNumberOfDroppedFragments() > 0, "lists do not fit");
  check(messages->TakeWarnings("MaximumListMemory is 1 MiB") == 1, "what is dropped is told once");
  check(stage.Mapper->GetNumberOfFragments() == 300 * 256 * 8, "all fragments are counted");
  check(std::abs(stage.Mapper->GetMeanDepthComplexity() - 300.0) < 1e-9, "mean depth complexity");
  stage.GetOptimization()->SetMaximumListMemory(4);
  CheckColor(check, "strips", stage.Stage::Render().At(128, 4), Blend(squares, Background), 1.6);
  check(stage.Mapper->GetNumberOfDroppedFragments() == 0, "strips hold all");
}

std::set<vtkIdType> SelectCells(vtkRenderer* renderer, int x1, int y1, int x2, int y2)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(x1, y1, x2, y2);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<vtkIdType> cells;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(i)->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      cells.insert(ids->GetValue(k));
    }
  }
  return cells;
}

// An unimportant square in front of an important one, and one beside them with nothing behind.
void CheckSelection(Checks& check)
{
  OpacityStage stage;
  stage.Mapper->SetInputData(MakeStack(
    { { -0.4, 0.0, 0.5, 0.3, { 255, 255, 255, 255 } }, { -0.4, 0.0, -0.5, 0.3, { 255, 0, 0, 255 } },
      { 0.5, 0.0, 0.5, 0.3, { 0, 255, 0, 255 } } },
    { 0.0, 1.0, 0.0 }));
  const Picture before = stage.Stage::Render();
  const std::set<vtkIdType> important{ 1 };
  const std::set<vtkIdType> alone{ 2 };
  check(SelectCells(stage.Renderer, 8, 14, 11, 17) == important, "what is faint is not selected");
  check(SelectCells(stage.Renderer, 22, 14, 26, 17) == alone, "what is opaque is selected");
  check(SelectCells(stage.Renderer, 14, 2, 17, 4).empty(), "nothing is selected of nothing");
  check(stage.Stage::Render().Bytes == before.Bytes, "selection does not disturb the picture");
  // Where nothing fades, the front is selected.
  stage.GetOptimization()->SetForegroundWeight(0.0);
  stage.Stage::Render();
  const std::set<vtkIdType> front{ 0 };
  check(SelectCells(stage.Renderer, 8, 14, 11, 17) == front, "opacities of the last picture count");
}

// Something important between two unimportant squares, seen from either side: what lies before it
// is faint in that view alone.
void CheckSelectionOfViews(Checks& check)
{
  OpacityStage stage(64, 32);
  stage.GetOptimization()->SetBackgroundWeight(0.0);
  stage.Mapper->SetInputData(MakeStack(
    { { 0.0, 0.0, 0.5, 0.4, { 0, 255, 0, 255 } }, { 0.0, 0.0, 0.0, 0.4, { 255, 0, 0, 255 } },
      { 0.0, 0.0, -0.5, 0.4, { 0, 0, 255, 255 } } },
    { 0.0, 1.0, 0.0 }));
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> behind;
  behind->SetViewport(0.5, 0.0, 1.0, 1.0);
  behind->AddActor(stage.Actor);
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(stage.Renderer->GetActiveCamera());
  camera->SetPosition(0.0, 0.0, -10.0);
  behind->SetActiveCamera(camera);
  stage.Window->AddRenderer(behind);
  const Picture before = stage.Stage::Render();
  const std::set<vtkIdType> important{ 1 };
  for (int i = 0; i < 2; ++i)
  {
    check(SelectCells(stage.Renderer, 14, 14, 17, 17) == important, "selection from the front");
    check(SelectCells(behind, 46, 14, 49, 17) == important, "selection from behind");
  }
  CheckSame(check, "selection of two views does not disturb", stage.Stage::Render(), before);
}
}

int TestFourierOpacityPasses(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  CheckPasses(check);
  CheckPeeling(check);
  CheckNearDepths(check);
  CheckColors(check);
  CheckSubset(check);
  CheckMemory(check, messages);
  CheckSelection(check);
  CheckSelectionOfViews(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
