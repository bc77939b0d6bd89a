// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that the segments are the same, bit for bit, for every number of threads and storage of
 * cells; that the filter runs again when, and only when, something changes; that it leaves its
 * input alone and replaces arrays of its own names; that values out of range are refused; and that
 * it can be stopped.
 */

#include "OpacitySegmentTesting.h"
#include "vtkCallbackCommand.h"
#include "vtkSMPTools.h"

#include <functional>
#include <limits>
#include <sstream>

using namespace OpacitySegmentTesting;

namespace
{

/// Lines that share many points, a surface, and vertices.
vtkSmartPointer<vtkPolyData> MakeInput(int numberOfLines, int n)
{
  std::vector<Point> points = MakeGridPoints(n, 0.5);
  const vtkIdType first = static_cast<vtkIdType>(points.size());
  std::vector<Cell> lines;
  for (const Curve& curve : MakeSmoothCurves(numberOfLines, 30))
  {
    lines.emplace_back();
    for (const Point& point : curve)
    {
      lines.back().push_back(static_cast<vtkIdType>(points.size()));
      points.push_back(point);
    }
    // Ten points that many lines use. The first of these is the last one of its task, so that
    // others come before it where threads work at the same time.
    if (lines.size() > 250)
    {
      lines.back()[15] = first + 15 + 30 * static_cast<vtkIdType>(300 + lines.size() % 10);
    }
  }
  points.push_back({ 0.0, 0.0, 7.0 });
  vtkSmartPointer<vtkPolyData> data = MakeData(points);
  data->SetLines(MakeCells(lines));
  data->SetPolys(MakeCells(MakeGridTriangles(n)));
  data->SetVerts(MakeCells({ { static_cast<vtkIdType>(points.size()) - 1, first } }));
  return data;
}

/// All arrays and counts, as bytes.
std::string BytesOf(const Segments& segments)
{
  std::string bytes;
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(segments.Ids), static_cast<vtkDataArray*>(segments.Distances),
      static_cast<vtkDataArray*>(segments.Neighbors) })
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
  return bytes + std::to_string(segments.Filter->GetNumberOfSegments()) + " " +
    std::to_string(segments.Filter->GetNumberOfSharedPoints());
}

void TestThreads(Checks& check)
{
  vtkSmartPointer<vtkPolyData> data = MakeInput(4000, 40);
  vtkSMPTools::SetBackend("Sequential");
  Segments reference;
  reference.Update(data);
  reference.CheckArrays(check, "threads");
  check(reference.Filter->GetNumberOfSharedPoints() == 11, "points that lines share, and a vertex");
  const std::string expected = BytesOf(reference);
  vtkSMPTools::SetBackend("STDThread");
  for (int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    Segments segments;
    segments.Update(data);
    check(BytesOf(segments) == expected, std::to_string(threads) + " threads");
  }
  for (bool is64Bit : { false, true })
  {
    vtkNew<vtkPolyData> other;
    other->ShallowCopy(data);
    vtkNew<vtkCellArray> lines;
    lines->DeepCopy(data->GetLines());
    is64Bit ? lines->ConvertTo64BitStorage() : lines->ConvertTo32BitStorage();
    other->SetLines(lines);
    vtkNew<vtkCellArray> polygons;
    polygons->DeepCopy(data->GetPolys());
    is64Bit ? polygons->ConvertTo64BitStorage() : polygons->ConvertTo32BitStorage();
    other->SetPolys(polygons);
    Segments segments;
    segments.Update(other);
    check(BytesOf(segments) == expected, is64Bit ? "64-bit cells" : "32-bit cells");
  }
}

/// So many lines, so often, that threads meet at shared points.
void TestRaces(Checks& check)
{
  vtkSmartPointer<vtkPolyData> data = MakeInput(10000, 2);
  vtkSMPTools::SetBackend("Sequential");
  Segments segments;
  segments.Update(data);
  const std::string expected = BytesOf(segments);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(7);
  for (int repetition = 0; repetition < 20; ++repetition)
  {
    segments.Filter->Modified();
    segments.Update(data);
    check(BytesOf(segments) == expected, "shared points, 7 threads");
  }
}

void TestCopies(Checks& check)
{
  vtkSmartPointer<vtkPolyData> data = MakeInput(5, 10);
  vtkNew<vtkFloatArray> old;
  old->SetName(vtkOpacitySegments::GetIdsName());
  old->SetNumberOfTuples(data->GetNumberOfPoints());
  old->Fill(0.0);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Importance");
  scalars->SetNumberOfTuples(data->GetNumberOfPoints());
  scalars->Fill(0.5);
  vtkNew<vtkFloatArray> oldField;
  oldField->SetName(vtkOpacitySegments::GetNeighborsName());
  vtkNew<vtkFloatArray> field;
  field->SetName("Time");
  field->InsertNextValue(3.0f);
  data->GetPointData()->AddArray(old);
  data->GetPointData()->SetScalars(scalars);
  data->GetFieldData()->AddArray(oldField);
  data->GetFieldData()->AddArray(field);
  Segments segments;
  segments.Update(data);
  segments.CheckArrays(check, "arrays that are replaced");
  vtkPolyData* output = segments.Output;
  check(output->GetPoints() == data->GetPoints() &&
      output->GetLines()->GetNumberOfCells() == data->GetLines()->GetNumberOfCells() &&
      output->GetNumberOfCells() == data->GetNumberOfCells() &&
      output->GetPointData()->GetScalars() == scalars &&
      output->GetFieldData()->GetArray("Time") == field,
    "points, cells and attributes are those of the input");
  check(data->GetPointData()->GetNumberOfArrays() == 2 &&
      data->GetPointData()->GetArray(vtkOpacitySegments::GetIdsName()) == old &&
      data->GetFieldData()->GetNumberOfArrays() == 2 &&
      data->GetFieldData()->GetArray(vtkOpacitySegments::GetNeighborsName()) == oldField,
    "the input is left alone");
}

void TestProperties(Checks& check)
{
  vtkSmartPointer<vtkPolyData> data = MakeInput(5, 10);
  Segments segments;
  vtkOpacitySegments* filter = segments.Filter;
  int executions = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&executions);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkCommand::StartEvent, counter);
  const auto runs = [&]()
  {
    executions = 0;
    segments.Update(data);
    return executions;
  };
  check(runs() == 1 && runs() == 0, "it runs once");
  const std::vector<std::pair<std::string, std::function<void()>>> changes = {
    { "NumberOfLineSegments", [&]() { filter->SetNumberOfLineSegments(17); } },
    { "SegmentLength", [&]() { filter->SetSegmentLength(0.5); } },
    { "NumberOfPatches", [&]() { filter->SetNumberOfPatches(3); } },
    { "input", [&]() { data->Modified(); } },
  };
  std::ostringstream text;
  filter->Print(text);
  for (const auto& change : changes)
  {
    change.second();
    check(runs() == 1 && runs() == 0, change.first + ": it runs again, once");
    if (change.first != "input")
    {
      change.second();
      check(runs() == 0, change.first + ": the same value changes nothing");
      check(text.str().find(change.first + ":") != std::string::npos, change.first + " is printed");
    }
  }
  const std::vector<std::function<void()>> refused = {
    [&]() { filter->SetNumberOfLineSegments(-1); },
    [&]() { filter->SetNumberOfLineSegments(1 << 24); },
    [&]() { filter->SetSegmentLength(-1.0); },
    [&]() { filter->SetSegmentLength(std::numeric_limits<double>::quiet_NaN()); },
    [&]() { filter->SetSegmentLength(std::numeric_limits<double>::infinity()); },
    [&]() { filter->SetNumberOfPatches(0); },
    [&]() { filter->SetNumberOfPatches(1 << 24); },
  };
  for (const auto& change : refused)
  {
    segments.Observer->Clear();
    change();
    check(segments.Observer->NumberOfErrors == 1 &&
        segments.Observer->ErrorMessage.find("must be from") != std::string::npos,
      "a value out of range is told");
    check(runs() == 0, "and changes nothing");
  }
  check(filter->GetNumberOfLineSegments() == 17 && filter->GetSegmentLength() == 0.5 &&
      filter->GetNumberOfPatches() == 3,
    "values stay");
}

/// Asks a filter to stop as soon as its progress has come that far.
class Stopper : public vtkCommand
{
public:
  static Stopper* New() { return new Stopper; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    vtkAlgorithm* filter = static_cast<vtkAlgorithm*>(caller);
    const double progress = filter->GetProgress();
    this->IsAscending = this->IsAscending && progress >= this->Last;
    // From VTK 9.3 on, the end of an update is told where it was stopped, too.
    this->Last = progress < 1.0 ? progress : this->Last;
    this->Looks += progress < 1.0 ? 1 : 0;
    if (progress >= this->StopAt && progress < 1.0)
    {
      filter->SetAbortExecute(1);
    }
  }
  double StopAt = 2.0;
  double Last = 0.0;
  int Looks = 0;
  bool IsAscending = true;
};

void TestAbort(Checks& check)
{
  vtkSmartPointer<vtkPolyData> data = MakeInput(100, 150);
  Segments segments;
  vtkNew<Stopper> stopper;
  segments.Filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  segments.Update(data);
  const std::string expected = BytesOf(segments);
  const int looks = stopper->Looks;
  check(stopper->IsAscending && looks > 10, "progress ascends");
  for (double stop : { 0.1, 0.2, 0.4, 0.6, 0.8 })
  {
    stopper->StopAt = stop;
    stopper->Last = 0.0;
    stopper->Looks = 0;
    segments.Filter->SetAbortExecute(0);
    segments.Filter->Modified();
    segments.Update(data);
    check(stopper->Looks <= looks && stopper->Last < stop + 0.06 &&
        segments.Output->GetNumberOfPoints() == 0 && segments.Filter->GetNumberOfSegments() == 0,
      "stopped at " + std::to_string(stop) + ": an empty output");
  }
  stopper->StopAt = 2.0;
  segments.Filter->SetAbortExecute(0);
  segments.Filter->Modified();
  segments.Update(data);
  check(BytesOf(segments) == expected, "everything afterwards");
}

}

int TestOpacitySegmentPipeline(int, char*[])
{
  Checks check;
  TestThreads(check);
  TestRaces(check);
  TestCopies(check);
  TestProperties(check);
  TestAbort(check);
  return check.GetResult();
}
