// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards vtkVoxelLineGeometry: lines of a model come back, connected, in place and with their
 * values and cells; a model of these lines in the same grid is the same model again. And
 * vtkVoxelLineDensity: the densities sum up to the length of these lines.
 */

#include "VoxelLineTesting.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVoxelLineDensity.h"
#include "vtkVoxelLineGeometry.h"

#include <numeric>

using namespace VoxelLineTesting;

namespace
{

double TotalLength(vtkPolyData* lines)
{
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      double a[3];
      double b[3];
      lines->GetPoint(ids->GetId(i - 1), a);
      lines->GetPoint(ids->GetId(i), b);
      sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return sum;
}

/// Smooth curves, a loop, a line in a voxel, and a point, with values and radii.
std::vector<Curve> MakeCurves()
{
  std::vector<Curve> curves = MakeSmoothCurves(60, 50);
  curves.push_back({});
  for (int i = 0; i <= 48; ++i)
  {
    const double angle = vtkMath::Pi() * i / 24;
    curves.back().push_back({ 0.5 + 0.2 * std::cos(angle), 0.5 + 0.2 * std::sin(angle), 0.5 });
  }
  curves.push_back({ { 0.501, 0.501, 0.501 }, { 0.504, 0.507, 0.503 } });
  curves.push_back({ { 0.3, 0.3, 0.3 }, { 0.3, 0.3, 0.3 } });
  return curves;
}

vtkSmartPointer<vtkPolyData> MakeInput()
{
  vtkSmartPointer<vtkPolyData> lines = MakeLines(MakeCurves());
  vtkNew<vtkDoubleArray> values;
  values->SetName("X");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(100.0 * lines->GetPoint(i)[0]);
    radii->InsertNextValue(0.01 * (1.0 + lines->GetPoint(i)[1]));
  }
  lines->GetPointData()->SetScalars(values);
  lines->GetPointData()->AddArray(radii);
  return lines;
}

/// Distinct end points, to compare lines with segments: neither order nor direction matters.
std::vector<std::pair<Point, Point>> EdgesOf(vtkPolyData* lines)
{
  std::vector<std::pair<Point, Point>> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      Point a;
      Point b;
      lines->GetPoint(ids->GetId(i - 1), a.data());
      lines->GetPoint(ids->GetId(i), b.data());
      edges.emplace_back(a, b);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void TestGeometry(Checks& check, int bins)
{
  vtkSmartPointer<vtkPolyData> lines = MakeInput();
  const std::string name = std::to_string(bins) + " bins";
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(24);
  voxelizer->SetFaceBins(bins);
  voxelizer->SetRadiusArrayName("Radius");
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputConnection(voxelizer->GetOutputPort());
  geometry->Update();
  vtkPolyData* output = geometry->GetOutput();
  vtkVoxelLineModel* model = voxelizer->GetOutput();
  const double voxel = model->GetVoxelSize();

  if (!check(
        output->GetNumberOfLines() == lines->GetNumberOfLines(), name + ": a line per curve") ||
    !check(output->GetNumberOfPoints() == model->GetNumberOfSegments() + model->GetNumberOfCurves(),
      name + ": a point per segment and a last one"))
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> original;
  double farthest = 0.0;
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    check(output->GetCellData()->GetArray("CurveId")->GetComponent(line, 0) == line &&
        output->GetCellData()->GetArray("CellId")->GetComponent(line, 0) == line &&
        output->GetCellData()->GetArray("InputId")->GetComponent(line, 0) == 0.0,
      name + ": ids of line " + std::to_string(line));
    output->GetLines()->GetCellAtId(line, ids);
    lines->GetLines()->GetCellAtId(line, original);
    for (int end = 0; end < 2; ++end)
    {
      double a[3];
      double b[3];
      output->GetPoint(ids->GetId(end * (ids->GetNumberOfIds() - 1)), a);
      lines->GetPoint(original->GetId(end * (original->GetNumberOfIds() - 1)), b);
      farthest = std::max(farthest, std::sqrt(vtkMath::Distance2BetweenPoints(a, b)));
    }
  }
  const double bin = bins > 0 ? std::sqrt(0.75) / model->GetInteriorBins() : 1e-6;
  check(farthest <= bin * voxel + 1e-12, name + ": lines end where the curves do");

  // Values: linear in the position, so that each point tells what it should have.
  vtkDataArray* values = output->GetPointData()->GetScalars();
  vtkDataArray* radii = output->GetPointData()->GetArray("Radius");
  double valueError = 0.0;
  double radiusError = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* point = output->GetPoint(i);
    valueError = std::max(valueError, std::abs(values->GetComponent(i, 0) - 100.0 * point[0]));
    radiusError =
      std::max(radiusError, std::abs(radii->GetComponent(i, 0) - 0.01 * (1.0 + point[1])));
  }
  const double range = model->GetAttributeRange()[1] - model->GetAttributeRange()[0];
  check(valueError <= 0.5 * range / 255 + 100.0 * bin * voxel + 1e-4, name + ": values");
  check(radiusError <= 0.5 * model->GetMaximumRadius() / 255 + 0.01 * bin * voxel + 1e-9,
    name + ": radii");

  // Joined or not, the same segments.
  const std::vector<std::pair<Point, Point>> joined = EdgesOf(output);
  geometry->JoinOff();
  geometry->Update();
  check(output->GetNumberOfLines() == model->GetNumberOfSegments() &&
      output->GetNumberOfPoints() == 2 * model->GetNumberOfSegments(),
    name + ": a line per segment");
  check(EdgesOf(output) == joined, name + ": joined or not, the same segments");
  bool isOrdered = true;
  for (const Segment& segment : DecodeModel(model))
  {
    double a[3];
    output->GetPoint(2 * segment.Index, a);
    isOrdered = isOrdered &&
      output->GetCellData()->GetArray("CurveId")->GetComponent(segment.Index, 0) ==
        static_cast<double>(segment.Curve) &&
      Length(ToLocal(model, { a[0], a[1], a[2] }) - segment.Start) < 1e-9;
  }
  check(isOrdered, name + ": single segments are in the order of the model");

  vtkNew<vtkVoxelLineDensity> density;
  density->SetInputConnection(voxelizer->GetOutputPort());
  density->SetOpacity(0.25);
  density->Update();
  vtkImageData* image = density->GetOutput();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    sum += scalars->GetComponent(i, 0);
  }
  const double length = TotalLength(output) / voxel;
  check(length > 1000.0 && std::abs(sum - 0.25 * length) < 1e-5 * length,
    name + ": densities sum up to the length of the lines");
  // Each voxel by itself, through the placement of the image.
  std::vector<double> expected(static_cast<std::size_t>(image->GetNumberOfPoints()), 0.0);
  for (const Segment& segment : DecodeModel(model))
  {
    const double centre[3] = { model->GetOrigin()[0] + (segment.Voxel[0] + 0.5) * voxel,
      model->GetOrigin()[1] + (segment.Voxel[1] + 0.5) * voxel,
      model->GetOrigin()[2] + (segment.Voxel[2] + 0.5) * voxel };
    const vtkIdType point = image->FindPoint(centre[0], centre[1], centre[2]);
    if (check(point >= 0, name + ": every voxel has a point"))
    {
      expected[static_cast<std::size_t>(point)] += 0.25 * Length(segment.End - segment.Start);
    }
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    largest = std::max(
      largest, std::abs(expected[static_cast<std::size_t>(i)] - scalars->GetComponent(i, 0)));
  }
  check(largest < 1e-5, name + ": density of each voxel");
}

/// Points where a line comes down to a face and goes up again: the voxel below was left by the bin
/// that it was entered by.
int CountTouches(vtkVoxelLineModel* model, vtkPolyData* lines)
{
  int touches = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 1; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      Point points[3];
      for (int j = 0; j < 3; ++j)
      {
        lines->GetPoint(ids->GetId(i - 1 + j), points[j].data());
        points[j] = ToLocal(model, points[j]);
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double plane = points[1][axis];
        touches +=
          plane == std::floor(plane) && points[0][axis] >= plane && points[2][axis] >= plane;
      }
    }
  }
  return touches;
}

/// The decoded lines, voxelized again into the same grid, give the same segments. Only where a line
/// touches a face from above, there is nothing left that leaves the voxel: it becomes a point
/// inside, which changes the two segments that meet there.
void TestRoundTrip(Checks& check)
{
  // Voxels of 1/8, so that points on faces are there without rounding.
  const auto setUp = [](vtkLineVoxelizer* voxelizer)
  {
    voxelizer->SetResolution(16);
    voxelizer->SetFaceBins(64);
    voxelizer->UseCustomBoundsOn();
    voxelizer->SetCustomBounds(-0.5, 1.5, -0.5, 1.5, -0.5, 1.5);
  };
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(MakeLines(MakeSmoothCurves(50, 50)));
  setUp(voxelizer);
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputConnection(voxelizer->GetOutputPort());
  geometry->Update();
  vtkNew<vtkLineVoxelizer> again;
  again->SetInputData(geometry->GetOutput());
  setUp(again);
  // All interior points but those that rounding makes.
  again->SetInteriorTolerance(1e-9);
  again->Update();
  const auto edgesOf = [](vtkVoxelLineModel* model)
  {
    std::vector<std::pair<Point, Point>> edges;
    for (const Segment& segment : DecodeModel(model))
    {
      // A line that touches the face of a voxel at its end may be cut off by nothing.
      if (Length(segment.End - segment.Start) > 0.0)
      {
        edges.emplace_back(segment.Start, segment.End);
      }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  };
  const auto first = edgesOf(voxelizer->GetOutput());
  const auto second = edgesOf(again->GetOutput());
  std::vector<std::pair<Point, Point>> common;
  std::set_intersection(
    first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(common));
  const int touches = CountTouches(voxelizer->GetOutput(), geometry->GetOutput());
  const std::size_t expected = first.size() - 2 * static_cast<std::size_t>(touches);
  std::cout << common.size() << " of " << first.size() << " segments came back, of "
            << second.size() << "; " << touches << " touches\n";
  check(first.size() > 500 && expected > first.size() * 9 / 10 && common.size() >= expected &&
      second.size() <= first.size(),
    "voxelized again, the same segments");
}

void TestErrors(Checks& check)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(MakeLines(MakeSmoothCurves(2, 10)));
  vtkNew<MessageObserver> observer;
  vtkNew<vtkVoxelLineGeometry> geometry;
  vtkNew<vtkVoxelLineDensity> density;
  geometry->AddObserver(vtkCommand::ErrorEvent, observer);
  density->AddObserver(vtkCommand::ErrorEvent, observer);
  geometry->SetInputConnection(voxelizer->GetOutputPort());
  density->SetInputConnection(voxelizer->GetOutputPort());
  geometry->SetLevel(-1);
  geometry->Update();
  check(observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("the levels 0 to") != std::string::npos &&
      geometry->GetErrorCode() == vtkErrorCode::UserError &&
      geometry->GetOutput()->GetNumberOfPoints() == 0,
    "geometry of another level");
  observer->Clear();
  density->SetLevel(-1);
  density->Update();
  check(observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("the levels 0 to") != std::string::npos &&
      density->GetErrorCode() == vtkErrorCode::UserError,
    "density of another level");
  observer->Clear();
  geometry->SetLevel(0);
  density->SetLevel(0);
  geometry->Update();
  density->Update();
  check(observer->NumberOfErrors == 0 && geometry->GetOutput()->GetNumberOfPoints() > 0 &&
      density->GetOutput()->GetNumberOfPoints() > 0,
    "the right level after it");
  check(density->GetOutput()->GetDimensions()[0] == voxelizer->GetOutput()->GetDimensions()[0],
    "dimensions of the image");

  voxelizer->SetResolution(16);
  density->UpdateInformation();
  int extent[6];
  density->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  check(
    extent[1] > 0 && extent[1] < 16 && extent[1] == voxelizer->GetOutput()->GetDimensions()[0] - 1,
    "the whole extent is known before the image");
  density->Update();
  check(density->GetOutput()->GetDimensions()[0] == voxelizer->GetOutput()->GetDimensions()[0] &&
      voxelizer->GetOutput()->GetDimensions()[0] <= 16,
    "the image follows the model");

  vtkNew<vtkPolyData> empty;
  voxelizer->SetInputData(empty);
  geometry->Update();
  density->Update();
  check(observer->NumberOfErrors == 0 && geometry->GetOutput()->GetNumberOfPoints() == 0 &&
      density->GetOutput()->GetNumberOfPoints() == 0,
    "an empty model");
}

}

int TestVoxelLineGeometry(int, char*[])
{
  Checks check;
  for (int bins : { 0, 2, 32, 128 })
  {
    TestGeometry(check, bins);
  }
  TestRoundTrip(check);
  TestErrors(check);
  return check.GetResult();
}
