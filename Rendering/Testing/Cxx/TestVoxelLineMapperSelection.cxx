// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards hardware selection: the cell of the input that a line came from, also where other
// cells and dropped lines come before it; the nearest point; ids of the user's own arrays;
// occlusion by other actors; an area; the prop picker; and that normal pictures are not disturbed.

#include "VoxelLineMapperTesting.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkLineVoxelizer.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedIntArray.h"

#include <set>
#include <string>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr int NumberOfBars = 5;

// Bars along x at y = -0.8, -0.4 ... 0.8 of 11 points each, after two vertex cells, so that the
// line of bar i is cell 2 + i.
vtkSmartPointer<vtkPolyData> MakeBars()
{
  std::vector<Curve> curves;
  for (int i = 0; i < NumberOfBars; ++i)
  {
    Curve curve;
    for (int k = 0; k <= 10; ++k)
    {
      curve.push_back({ -1.0 + 0.2 * k, -0.8 + 0.4 * i, 0.0 });
    }
    curves.push_back(curve);
  }
  auto lines = MakeLines(curves);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 7 });
  lines->SetVerts(vertices);
  return lines;
}

/// Selected ids by actor.
struct Selected
{
  std::set<vtkIdType> Ids;
  vtkProp* Prop = nullptr;
  int CompositeIndex = -1;
  int Process = -1;
  int NumberOfNodes = 0;
};

Selected Select(
  Stage& stage, int association, int x1, int y1, int x2, int y2, bool useProcessIds = false)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(x1, y1, x2, y2);
  selector->SetUseProcessIdFromData(useProcessIds);
  if (useProcessIds)
  {
    selector->SetProcessID(0);
  }
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Selected selected;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    ++selected.NumberOfNodes;
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      selected.Ids.insert(ids->GetValue(k));
    }
    selected.Prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    selected.CompositeIndex = node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX());
    selected.Process = node->GetProperties()->Get(vtkSelectionNode::PROCESS_ID());
  }
  return selected;
}

int GetRow(int bar)
{
  return 100 + static_cast<int>(100.0 * (-0.8 + 0.4 * bar));
}

constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

void CheckCells(Checks& check, double opacity)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeBars());
  mapper->SetRadius(0.05);
  mapper->SetResolution(32);
  Stage stage(200, 200);
  auto actor = stage.Add(mapper, opacity);
  LookAlongZ(stage);
  const Picture before = stage.Render();
  for (int bar = 0; bar < NumberOfBars; ++bar)
  {
    const int y = GetRow(bar);
    const Selected click = Select(stage, Cells, 120, y, 120, y);
    check(click.Ids == std::set<vtkIdType>{ 2 + bar } && click.Prop == actor,
      "a click on bar " + std::to_string(bar));
    check(click.CompositeIndex == 1, "composite index");
    check(Select(stage, Cells, 120, y - 15, 120, y - 15).NumberOfNodes == 0, "a click beside");
  }
  const Selected area = Select(stage, Cells, 80, GetRow(1) - 5, 140, GetRow(3) + 5);
  check(area.Ids == std::set<vtkIdType>{ 3, 4, 5 }, "an area");
  const Selected all = Select(stage, Cells, 0, 0, 199, 199);
  check(all.Ids == std::set<vtkIdType>{ 2, 3, 4, 5, 6 }, "the whole window");
  const Difference difference = Compare(before, stage.Render());
  check(difference.Largest == 0, "the picture after selection" + Describe(difference));

  // In a viewport that is not at the origin.
  stage.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  stage.Render();
  const int y = 100 + GetRow(1) / 2;
  check(Select(stage, Cells, 160, y, 160, y).Ids == std::set<vtkIdType>{ 3 },
    "in a viewport of its own");
  check(Select(stage, Cells, 0, 0, 90, 90).Prop != actor, "outside the viewport");
}

void CheckPoints(Checks& check, double opacity)
{
  auto bars = MakeBars();
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(bars);
  mapper->SetRadius(0.05);
  mapper->SetResolution(32);
  Stage stage(200, 200);
  auto actor = stage.Add(mapper, opacity);
  actor->SetScale(0.5, 1.0, 2.0);
  LookAlongZ(stage);
  stage.Render();
  for (int k = 2; k <= 8; ++k)
  {
    // Points are 0.1 apart here, which is 10 pixels; 3 pixels beside one it is still the nearest.
    const int x = 100 + static_cast<int>(std::lround(100.0 * 0.5 * (-1.0 + 0.2 * k))) + 3;
    const int y = GetRow(3);
    const Selected click = Select(stage, Points, x, y, x, y);
    check(click.Ids == std::set<vtkIdType>{ 33 + k } && click.Prop == actor,
      "point " + std::to_string(33 + k) + ", not " +
        (click.Ids.empty() ? "none" : std::to_string(*click.Ids.begin())));
  }
  check(Select(stage, Points, 100, GetRow(3) + 20, 100, GetRow(3) + 20).NumberOfNodes == 0,
    "no point beside");
}

template <typename ArrayT>
void AddNumbers(vtkDataSetAttributes* data, const char* name, vtkIdType first, vtkIdType count)
{
  vtkNew<ArrayT> numbers;
  numbers->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(static_cast<typename ArrayT::ValueType>(first + i));
  }
  data->AddArray(numbers);
}

// Arrays of the user's own, with ids of more than 24 bits.
void CheckArrays(Checks& check)
{
  constexpr vtkIdType first = (vtkIdType{ 3 } << 24) + 5;
  auto bars = MakeBars();
  const vtkIdType points = bars->GetNumberOfPoints();
  const vtkIdType cells = bars->GetNumberOfCells();
  AddNumbers<vtkIdTypeArray>(bars->GetPointData(), "PointIds", first, points);
  AddNumbers<vtkIdTypeArray>(bars->GetCellData(), "CellIds", 2 * first, cells);
  AddNumbers<vtkUnsignedIntArray>(bars->GetCellData(), "Blocks", 70, cells);
  AddNumbers<vtkUnsignedIntArray>(bars->GetPointData(), "Processes", 100, points);
  AddNumbers<vtkIntArray>(bars->GetCellData(), "Numbers", 90, cells);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(bars);
  mapper->SetRadius(0.05);
  mapper->SetResolution(32);
  mapper->SetPointIdArrayName("PointIds");
  mapper->SetCellIdArrayName("CellIds");
  mapper->SetCompositeIdArrayName("Blocks");
  mapper->SetProcessIdArrayName("Processes");
  Stage stage(200, 200);
  stage.Add(mapper);
  LookAlongZ(stage);
  stage.Render();
  const int y = GetRow(3);
  const Selected cell = Select(stage, Cells, 120, y, 120, y);
  check(cell.Ids == std::set<vtkIdType>{ 2 * first + 5 }, "the cell's id in the array");
  check(cell.CompositeIndex == 75, "the block in the array");
  const Selected point = Select(stage, Points, 120, y, 120, y);
  check(point.Ids == std::set<vtkIdType>{ first + 39 }, "the point's id in the array");
  // Bar 3 begins with point 33.
  check(Select(stage, Cells, 120, y, 120, y, true).Process == 133, "the process in the array");

  // Arrays that do not fit, and none.
  mapper->SetCellIdArrayName("Numbers");
  mapper->SetCompositeIdArrayName("Numbers");
  mapper->SetPointIdArrayName("Missing");
  const Selected own = Select(stage, Cells, 120, y, 120, y);
  check(own.Ids == std::set<vtkIdType>{ 5 } && own.CompositeIndex == 1, "arrays of another type");
  check(Select(stage, Points, 120, y, 120, y).Ids == std::set<vtkIdType>{ 39 }, "no array");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(std::string(copy->GetProcessIdArrayName()) == "Processes", "names are copied");
  copy->SetProcessIdArrayName(nullptr);
  check(copy->GetProcessIdArrayName() == nullptr, "names are taken back");
}

void CheckOcclusion(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeBars());
  mapper->SetRadius(0.05);
  mapper->SetResolution(32);
  for (double z : { 0.5, -0.5 })
  {
    Stage stage(200, 200);
    auto bars = stage.Add(mapper);
    auto sphere = stage.AddSphere(0.0, 0.0, z, 0.3);
    LookAlongZ(stage);
    stage.Render();
    const Selected click = Select(stage, Cells, 101, 101, 101, 101);
    check(click.Prop == (z > 0.0 ? sphere : bars) && click.NumberOfNodes == 1,
      "what is in front is selected");
    vtkNew<vtkPropPicker> picker;
    picker->Pick(101, 101, 0, stage.Renderer);
    check(picker->GetViewProp() == (z > 0.0 ? sphere : bars), "the prop picker");
    double position[3];
    picker->GetPickPosition(position);
    check(std::abs(position[2] - (z > 0.0 ? 0.8 : 0.05)) < 0.01,
      "the position of the prop picker: " + std::to_string(position[2]));
    picker->Pick(101, GetRow(4), 0, stage.Renderer);
    check(picker->GetViewProp() == bars, "the prop picker beside the sphere");
  }
}

// The model's curves name input and cell; there are no points to select.
void CheckSharedModel(Checks& check, Messages* messages)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  auto bars = MakeBars();
  auto higher = MakeLines({ { { -1.0, 0.2, 0.0 }, { 1.0, 0.2, 0.0 } } });
  voxelizer->AddInputDataObject(0, bars);
  voxelizer->AddInputDataObject(0, higher);
  voxelizer->SetResolution(32);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputConnection(voxelizer->GetOutputPort());
  mapper->SetRadius(0.05);
  Stage stage(200, 200);
  stage.Add(mapper);
  LookAlongZ(stage);
  stage.Render();
  Selected click = Select(stage, Cells, 150, GetRow(4), 150, GetRow(4));
  check(click.Ids == std::set<vtkIdType>{ 6 } && click.CompositeIndex == 1, "the first input");
  click = Select(stage, Cells, 150, 120, 150, 120);
  check(click.Ids == std::set<vtkIdType>{ 0 } && click.CompositeIndex == 2, "the second input");
  check(messages->IsQuiet(), "nothing said so far");
  check(Select(stage, Points, 150, 120, 150, 120).NumberOfNodes == 0, "no points in a model");
  check(messages->TakeWarnings("Points cannot be selected") == 1, "one warning about points");
}
}

int TestVoxelLineMapperSelection(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  for (double opacity : { 1.0, 0.3 })
  {
    CheckCells(check, opacity);
    CheckPoints(check, opacity);
  }
  CheckArrays(check);
  CheckOcclusion(check);
  CheckSharedModel(check, messages);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
