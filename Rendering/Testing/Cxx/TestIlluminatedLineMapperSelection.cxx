// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards hardware selection: cells and points of the input, also where lines share points, of which
// the mapper draws copies; with id arrays of the user; with the processes that lines are of; and
// that pictures are not disturbed.

#include "VoxelLineMapperTesting.h"
#include "vtkFloatArray.h"
#include "vtkFourierOpacityMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr int Cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

// Four bars along x of five points each, after a vertex: bar i is cell 1 + i, has its middle at
// pixel (100, GetRow(i)), and its point k, 5 i + k, at x = 50 k / 2 + 50.
int GetRow(int bar)
{
  return 100 + static_cast<int>(100.0 * (-0.6 + 0.4 * bar));
}

vtkSmartPointer<vtkPolyData> MakeBars()
{
  std::vector<Curve> curves;
  for (int i = 0; i < 4; ++i)
  {
    Curve curve;
    for (int k = 0; k < 5; ++k)
    {
      curve.push_back({ -0.5 + 0.25 * k, -0.6 + 0.4 * i, 0.0 });
    }
    curves.push_back(curve);
  }
  auto lines = MakeLines(curves);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  lines->SetVerts(vertices);
  return lines;
}

// The same with a line from the middle of each bar to that of the next: cells 5 to 7.
vtkSmartPointer<vtkPolyData> MakeLadder()
{
  auto lines = MakeBars();
  for (vtkIdType i = 0; i < 3; ++i)
  {
    lines->GetLines()->InsertNextCell({ 5 * i + 2, 5 * i + 7 });
  }
  return lines;
}

std::set<vtkIdType> Select(Stage& stage, int association, int x1, int y1, int x2, int y2)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(x1, y1, x2, y2);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<vtkIdType> selected;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(i)->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      selected.insert(ids->GetValue(k));
    }
  }
  return selected;
}

std::string Describe(const std::set<vtkIdType>& ids)
{
  std::string text = ":";
  for (vtkIdType id : ids)
  {
    text += " " + std::to_string(id);
  }
  return text;
}

void CheckSelected(Checks& check, const std::string& name, const std::set<vtkIdType>& ids,
  const std::set<vtkIdType>& expected)
{
  check(ids == expected, name + Describe(ids) + ", expected" + Describe(expected));
}

void CheckIds(Checks& check, bool isLadder, bool hasUserIds)
{
  auto lines = isLadder ? MakeLadder() : MakeBars();
  vtkNew<vtkIlluminatedLineMapper> mapper;
  mapper->SetInputData(lines);
  vtkIdType pointOffset = 0;
  vtkIdType cellOffset = 0;
  if (hasUserIds)
  {
    pointOffset = 1000;
    cellOffset = 70000;
    vtkNew<vtkIdTypeArray> pointIds;
    pointIds->SetName("points");
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      pointIds->InsertNextValue(pointOffset + i);
    }
    lines->GetPointData()->AddArray(pointIds);
    vtkNew<vtkIdTypeArray> cellIds;
    cellIds->SetName("cells");
    for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i)
    {
      cellIds->InsertNextValue(cellOffset + i);
    }
    lines->GetCellData()->AddArray(cellIds);
    mapper->SetPointIdArrayName("points");
    mapper->SetCellIdArrayName("cells");
  }
  const std::string name =
    std::string(isLadder ? "ladder" : "bars") + (hasUserIds ? " with ids" : "") + ", ";
  Stage stage(200, 200);
  auto actor = stage.Add(mapper);
  actor->GetProperty()->SetLineWidth(5.0);
  LookAlongZ(stage);
  const Picture before = stage.Render();
  for (int bar = 0; bar < 4; ++bar)
  {
    const int y = GetRow(bar);
    CheckSelected(
      check, name + "a click", Select(stage, Cells, 65, y, 65, y), { cellOffset + 1 + bar });
    CheckSelected(check, name + "beside", Select(stage, Cells, 65, y - 12, 65, y - 12), {});
    for (int k = 0; k < 5; ++k)
    {
      const int x = 50 + 25 * k;
      CheckSelected(check, name + "a point", Select(stage, Points, x - 4, y - 4, x + 4, y + 4),
        { pointOffset + 5 * bar + k });
    }
  }
  if (isLadder)
  {
    CheckSelected(
      check, name + "a rung", Select(stage, Cells, 100, 100, 100, 100), { cellOffset + 6 });
  }
  std::set<vtkIdType> all;
  for (vtkIdType i = 0; i < 20; ++i)
  {
    all.insert(pointOffset + i);
  }
  CheckSelected(check, name + "all points", Select(stage, Points, 0, 0, 199, 199), all);
  const Difference difference = Compare(before, stage.Render());
  check(difference.Largest == 0,
    name + "the picture after selection" + VoxelLineMapperTesting::Describe(difference));
}

using Owned = std::set<std::pair<int, vtkIdType>>;

// Of all of the window: process and id. The selector takes itself for that of process 5.
Owned SelectOwned(Stage& stage, int association, bool usesArray)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(association);
  selector->SetArea(0, 0, 199, 199);
  selector->SetProcessID(5);
  selector->SetUseProcessIdFromData(usesArray);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Owned selected;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      selected.emplace(
        node->GetProperties()->Get(vtkSelectionNode::PROCESS_ID()), ids->GetValue(k));
    }
  }
  return selected;
}

// Lines that other processes have handed on are theirs: each bar is of a process of its own, in
// numbers of one byte to three.
template <typename MapperT>
void CheckProcesses(Checks& check, bool isShared, double opacity)
{
  constexpr unsigned int processes[] = { 0, 3, 300, 70000 };
  auto lines = MakeBars();
  vtkNew<vtkUnsignedIntArray> numbers;
  numbers->SetName("processes");
  vtkNew<vtkIntArray> others;
  others->SetName("others");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    numbers->InsertNextValue(processes[i / 5]);
    others->InsertNextValue(9);
  }
  lines->GetPointData()->AddArray(numbers);
  lines->GetPointData()->AddArray(others);
  if (isShared)
  {
    // The second half of each bar once more, of whose points the mapper draws copies.
    for (vtkIdType i = 0; i < 4; ++i)
    {
      lines->GetLines()->InsertNextCell({ 5 * i + 2, 5 * i + 3, 5 * i + 4 });
    }
  }
  vtkNew<MapperT> mapper;
  if constexpr (std::is_same_v<MapperT, vtkFourierOpacityMapper>)
  {
    // All is important: a selection leaves out what is faint.
    vtkNew<vtkFloatArray> importance;
    importance->SetNumberOfValues(lines->GetNumberOfPoints());
    importance->FillValue(1.0f);
    lines->GetPointData()->SetScalars(importance);
    mapper->SetImportanceRange(0.0, 1.0);
  }
  mapper->SetInputData(lines);
  mapper->SetProcessIdArrayName("processes");
  Stage stage(200, 200);
  auto actor = stage.Add(mapper, opacity);
  actor->GetProperty()->SetLineWidth(5.0);
  LookAlongZ(stage);
  stage.Render();
  const std::string name = std::string(mapper->GetClassName()) + (isShared ? ", copies, " : ", ");
  Owned cells = { { 0, 0 } };
  Owned points;
  for (int bar = 0; bar < 4; ++bar)
  {
    const int process = static_cast<int>(processes[bar]);
    cells.emplace(process, 1 + bar);
    if (isShared)
    {
      cells.emplace(process, 5 + bar);
    }
    for (int k = 0; k < 5; ++k)
    {
      points.emplace(process, 5 * bar + k);
    }
  }
  // Of the parts that lie upon each other either may be seen.
  Owned found = SelectOwned(stage, Cells, true);
  check(std::includes(cells.begin(), cells.end(), found.begin(), found.end()) && found.size() >= 4,
    name + "cells and their processes");
  check(SelectOwned(stage, Points, true) == points, name + "points and their processes");

  // All are of the selector's own where it is not to look, and where there is nothing to look at.
  const auto areOwn = [&stage](bool usesArray)
  {
    const Owned own = SelectOwned(stage, Cells, usesArray);
    return own.size() >= 4 &&
      std::all_of(own.begin(), own.end(), [](const auto& id) { return id.first == 5; });
  };
  check(areOwn(false), name + "processes are not asked for");
  for (const char* array : { "others", "missing", static_cast<const char*>(nullptr) })
  {
    mapper->SetProcessIdArrayName(array);
    check(areOwn(true), name + "processes by " + (array ? array : "no array"));
  }
}

// Highlights of the mapper's own selection: just those of vtkPolyDataMapper.
void CheckHighlights(Checks& check)
{
  const std::array<int, 3> green{ 0, 255, 0 };
  for (int field : { vtkSelectionNode::CELL, vtkSelectionNode::POINT })
  {
    Picture pictures[2];
    vtkNew<vtkIlluminatedLineMapper> mapper;
    vtkNew<vtkPolyDataMapper> plain;
    for (int kind : { 0, 1 })
    {
      vtkPolyDataMapper* used = kind == 0 ? mapper.Get() : plain.Get();
      used->SetInputData(MakeLadder());
      vtkNew<vtkIdTypeArray> ids;
      ids->InsertNextValue(field == vtkSelectionNode::CELL ? 6 : 7);
      vtkNew<vtkSelectionNode> node;
      node->SetFieldType(field);
      node->SetContentType(vtkSelectionNode::INDICES);
      node->SetSelectionList(ids);
      vtkNew<vtkSelection> selection;
      selection->AddNode(node);
      used->SetSelection(selection);
      Stage stage(200, 200);
      auto actor = stage.Add(used);
      actor->GetProperty()->SetSelectionColor(0.0, 1.0, 0.0, 1.0);
      actor->GetProperty()->SetSelectionLineWidth(5.0);
      actor->GetProperty()->SetSelectionPointSize(7.0);
      LookAlongZ(stage);
      pictures[kind] = stage.Render();
    }
    int highlighted = 0;
    int different = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const bool isGreen = pictures[0].At(x, y) == green;
        highlighted += isGreen ? 1 : 0;
        different += isGreen != (pictures[1].At(x, y) == green) ? 1 : 0;
      }
    }
    check(highlighted > 20 && different == 0,
      "highlights: " + std::to_string(highlighted) + " pixels, " + std::to_string(different) +
        " not as vtkPolyDataMapper");
  }
}
}

int TestIlluminatedLineMapperSelection(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  for (bool isLadder : { false, true })
  {
    for (bool hasUserIds : { false, true })
    {
      CheckIds(check, isLadder, hasUserIds);
    }
  }
  for (bool isShared : { false, true })
  {
    CheckProcesses<vtkIlluminatedLineMapper>(check, isShared, 1.0);
    CheckProcesses<vtkIlluminatedLineMapper>(check, isShared, 0.5);
    CheckProcesses<vtkFourierOpacityMapper>(check, isShared, 0.9);
  }
  CheckHighlights(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
