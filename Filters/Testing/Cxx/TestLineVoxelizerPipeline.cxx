// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards vtkLineVoxelizer as a part of a pipeline: it runs when and only when something changed,
 * tells its progress, stops when asked to and starts again, appends inputs, and has all its
 * properties in PrintSelf.
 */

#include "VoxelLineTesting.h"
#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkIdTypeArray.h"

#include <functional>
#include <sstream>

using namespace VoxelLineTesting;

namespace
{

/// Calls a function at each progress event.
class ProgressObserver : public vtkCommand
{
public:
  static ProgressObserver* New() { return new ProgressObserver; }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    this->Progress.push_back(*static_cast<double*>(data));
    if (this->Progress.back() >= this->StopAt)
    {
      this->Algorithm->SetAbortExecute(1);
    }
  }
  std::vector<double> Progress;
  double StopAt = 2.0;
  vtkAlgorithm* Algorithm = nullptr;
};

void TestProgress(Checks& check)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(MakeLines(MakeSmoothCurves(500, 100)));
  voxelizer->SetResolution(32);
  vtkNew<ProgressObserver> observer;
  observer->Algorithm = voxelizer;
  voxelizer->AddObserver(vtkCommand::ProgressEvent, observer);
  voxelizer->Update();
  const std::vector<double> progress = observer->Progress;
  check(progress.size() > 10 && std::is_sorted(progress.begin(), progress.end()) &&
      progress.back() == 1.0,
    "progress rises to 1");
  const vtkIdType size = voxelizer->GetOutput()->GetNumberOfSegments();
  check(size > 0, "a model");

  for (double stop : { 0.1, 0.3, 0.7, 0.9 })
  {
    observer->StopAt = stop;
    observer->Progress.clear();
    voxelizer->SetAbortExecute(0);
    voxelizer->Modified();
    voxelizer->Update();
    vtkVoxelLineModel* model = voxelizer->GetOutput();
    check(model->GetNumberOfSegments() == 0 && model->GetNumberOfBytes() == 0 &&
        model->GetDimensions()[0] == 0,
      "stopped at " + std::to_string(stop) + ": an empty model");
    double last = 0.0;
    for (double value : observer->Progress)
    {
      last = value < 1.0 ? value : last;
    }
    check(last >= stop && last < stop + 0.06,
      "stopped at " + std::to_string(stop) + ": not later than at the next look");
  }
  observer->StopAt = 2.0;
  voxelizer->SetAbortExecute(0);
  voxelizer->Modified();
  voxelizer->Update();
  check(voxelizer->GetOutput()->GetNumberOfSegments() == size, "the whole model afterwards");
}

void TestExecutions(Checks& check)
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines(MakeSmoothCurves(5, 20));
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  int executions = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&executions);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  voxelizer->AddObserver(vtkCommand::StartEvent, counter);
  const auto runs = [&]()
  {
    executions = 0;
    voxelizer->Update();
    return executions;
  };
  check(runs() == 1, "it runs once");
  check(runs() == 0, "it does not run again");
  const std::vector<std::pair<std::string, std::function<void()>>> changes = {
    { "Resolution", [&]() { voxelizer->SetResolution(17); } },
    { "FaceBins", [&]() { voxelizer->SetFaceBins(16); } },
    { "InteriorTolerance", [&]() { voxelizer->SetInteriorTolerance(0.2); } },
    { "GenerateAttributes", [&]() { voxelizer->GenerateAttributesOff(); } },
    { "AttributeComponent", [&]() { voxelizer->SetAttributeComponent(-1); } },
    { "DirectColors", [&]() { voxelizer->DirectColorsOff(); } },
    { "RadiusArrayName", [&]() { voxelizer->SetRadiusArrayName(""); } },
    { "CustomBounds", [&]() { voxelizer->SetCustomBounds(-9.0, 9.0, -9.0, 9.0, -9.0, 9.0); } },
    { "UseCustomBounds", [&]() { voxelizer->UseCustomBoundsOn(); } },
    { "input", [&]() { lines->Modified(); } },
  };
  for (const auto& change : changes)
  {
    change.second();
    const int expected = change.first == "RadiusArrayName" ? 0 : 1; // it was empty before
    check(runs() == expected && runs() == 0, change.first + ": it runs again, once");
  }
  std::ostringstream text;
  voxelizer->Print(text);
  for (const auto& change : changes)
  {
    check(change.first == "input" || text.str().find(change.first + ":") != std::string::npos,
      change.first + " is printed");
  }
}

void TestAppend(Checks& check)
{
  // Several inputs are as good as one that holds them all, but for the origin of the curves.
  vtkNew<vtkLineVoxelizer> several;
  vtkNew<vtkAppendPolyData> append;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    vtkSmartPointer<vtkPolyData> lines =
      MakeLines(MakeSmoothCurves(20, 30, seed), seed == 2 ? VTK_FLOAT : VTK_DOUBLE);
    if (seed == 3)
    {
      lines->GetLines()->ConvertTo32BitStorage();
    }
    several->AddInputData(lines);
    append->AddInputData(lines);
  }
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkLineVoxelizer> one;
  one->SetInputConnection(append->GetOutputPort());
  several->SetResolution(40);
  one->SetResolution(40);
  several->Update();
  one->Update();
  vtkVoxelLineModel* a = several->GetOutput();
  vtkVoxelLineModel* b = one->GetOutput();
  check(a->GetNumberOfSegments() > 1000 && a->GetNumberOfSegments() == b->GetNumberOfSegments() &&
      std::memcmp(a->GetSegments()->GetVoidPointer(0), b->GetSegments()->GetVoidPointer(0),
        static_cast<std::size_t>(4 * a->GetNumberOfSegments())) == 0,
    "several inputs give the segments of one");
  check(b->GetCurveCells()->GetNumberOfTuples() == 60, "all curves");
  for (vtkIdType curve = 0; curve < 60; ++curve)
  {
    check(a->GetCurveCells()->GetComponent(curve, 0) == static_cast<double>(curve / 20) &&
        a->GetCurveCells()->GetComponent(curve, 1) == static_cast<double>(curve % 20),
      "input and cell of curve " + std::to_string(curve));
  }

  // Two-point line cells are curves too.
  vtkSmartPointer<vtkPolyData> lines = MakeLines(
    { { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.5 } }, { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.5 } } });
  check(MakeModel(check, lines, 8, 32)->GetNumberOfCurves() == 2, "two-point lines");
}

}

int TestLineVoxelizerPipeline(int, char*[])
{
  Checks check;
  TestProgress(check);
  TestExecutions(check);
  TestAppend(check);
  return check.GetResult();
}
