// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that a model is the same, bit for bit, for every number of threads, and for every way in
 * which the same lines can be stored: 32- and 64-bit cell arrays, points in double, in single
 * precision, and in arrays of other layouts.
 */

#include "VoxelLineTesting.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"

using namespace VoxelLineTesting;

namespace
{

/// All arrays of a model and its counts, as bytes.
std::vector<std::string> BytesOf(vtkVoxelLineModel* model)
{
  std::vector<std::string> bytes;
  for (vtkDataArray* array : { model->GetBrickGrid(), model->GetBricks(), model->GetVoxelStarts(),
         model->GetSegments(), model->GetCurveIdExtension(), model->GetBrickCurves(),
         static_cast<vtkDataArray*>(model->GetCurveCells()),
         static_cast<vtkDataArray*>(model->GetAttributes()),
         static_cast<vtkDataArray*>(model->GetRadii()) })
  {
    bytes.emplace_back();
    if (array)
    {
      bytes.back().assign(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    }
  }
  const double numbers[] = { static_cast<double>(model->GetNumberOfDuplicates()),
    static_cast<double>(model->GetNumberOfCollapsedSegments()), model->GetLargestDeviation(),
    model->GetVoxelSize() };
  bytes.emplace_back(reinterpret_cast<const char*>(numbers), sizeof(numbers));
  return bytes;
}

std::vector<std::string> Voxelize(vtkPolyData* lines, int bins, int resolution = 20)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(resolution);
  voxelizer->SetFaceBins(bins);
  voxelizer->SetRadiusArrayName("Radius");
  voxelizer->Update();
  return BytesOf(voxelizer->GetOutput());
}

vtkSmartPointer<vtkPolyData> MakeInput()
{
  // Enough lines for many bricks with many curves each, and for many tasks.
  std::vector<Curve> curves = MakeSmoothCurves(3000, 40);
  for (Curve& curve : curves)
  {
    for (Point& point : curve)
    {
      for (double& coordinate : point)
      {
        coordinate = static_cast<float>(coordinate);
      }
    }
  }
  vtkSmartPointer<vtkPolyData> lines = MakeLines(curves);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("Scalars");
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(static_cast<float>(i % 977));
    radii->InsertNextValue(static_cast<float>(i % 13));
  }
  lines->GetPointData()->SetScalars(scalars);
  lines->GetPointData()->AddArray(radii);
  return lines;
}

/// So many segments that threads are in each other's way for milliseconds, several times over.
void TestRaces(Checks& check, vtkPolyData* lines)
{
  vtkSMPTools::SetBackend("Sequential");
  const std::vector<std::string> expected = Voxelize(lines, 32, 150);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(7);
  for (int repetition = 0; repetition < 4; ++repetition)
  {
    check(Voxelize(lines, 32, 150) == expected, "many segments, 7 threads");
  }
}

}

int TestLineVoxelizerThreads(int, char*[])
{
  Checks check;
  vtkSmartPointer<vtkPolyData> lines = MakeInput();
  TestRaces(check, lines);
  for (int bins : { 32, 256, 0 })
  {
    vtkSMPTools::SetBackend("Sequential");
    const std::vector<std::string> expected = Voxelize(lines, bins);
    check(expected[3].size() > 100000 && expected[4].empty() == (bins == 256) &&
        !expected[7].empty() && !expected[8].empty(),
      "the model has segments, id extension, attributes and radii");
    const std::string name = std::to_string(bins) + " bins: ";
    for (int threads : { 1, 2, 7 })
    {
      vtkSMPTools::SetBackend("STDThread");
      vtkSMPTools::Initialize(threads);
      check(Voxelize(lines, bins) == expected, name + std::to_string(threads) + " threads");
    }
    if (vtkSMPTools::SetBackend("TBB"))
    {
      check(Voxelize(lines, bins) == expected, name + "TBB");
    }

    // The same lines otherwise stored.
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(2);
    vtkNew<vtkPolyData> other;
    other->ShallowCopy(lines);
    for (bool is64Bit : { false, true })
    {
      vtkNew<vtkCellArray> cells;
      cells->DeepCopy(lines->GetLines());
      is64Bit ? cells->ConvertTo64BitStorage() : cells->ConvertTo32BitStorage();
      check(cells->IsStorage64Bit() == is64Bit, "storage of the cell array");
      other->SetLines(cells);
      check(Voxelize(other, bins) == expected, name + (is64Bit ? "64" : "32") + "-bit cell array");
    }
    vtkNew<vtkPoints> floats;
    floats->SetDataTypeToFloat();
    vtkNew<vtkSOADataArrayTemplate<double>> columns;
    columns->SetNumberOfComponents(3);
    columns->SetNumberOfTuples(lines->GetNumberOfPoints());
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      floats->InsertNextPoint(lines->GetPoint(i));
      columns->SetTuple(i, lines->GetPoint(i));
    }
    other->SetPoints(floats);
    check(Voxelize(other, bins) == expected, name + "points in single precision");
    vtkNew<vtkPoints> soa;
    soa->SetData(columns);
    other->SetPoints(soa);
    check(Voxelize(other, bins) == expected, name + "points in columns");
  }
  return check.GetResult();
}
