// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the decoding of models: the capsules of a model lie on the curves that the model was made
// of, within the bins of its encoding, belong to the right curves, are as long together, and carry
// the curves' scalars, colours and radii.

#include "CapsulesFromLines.h"
#include "CapsulesFromModel.h"
#include "ReferenceTesting.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLineVoxelizer.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <limits>
#include <map>

using namespace linesets;

namespace
{
constexpr double Offset = 1000.0;
constexpr double Side = 2.0;

// Random walks in a cube of side 2 far from the origin, whose attributes tell where a point is:
// scalar = x, red and blue = y, radius = z, as shares of the side.
void MakeLines(vtkPolyData* lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("x");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  for (int curve = 0; curve < 40; ++curve)
  {
    Random random(4, curve);
    double p[3] = { random.Uniform(), random.Uniform(), random.Uniform() };
    cells->InsertNextCell(30);
    for (int i = 0; i < 30; ++i)
    {
      for (double& x : p)
      {
        x = std::min(1.0, std::max(0.0, x + random.Uniform(-0.1, 0.1)));
      }
      cells->InsertCellPoint(
        points->InsertNextPoint(Offset + Side * p[0], Offset + Side * p[1], Offset + Side * p[2]));
      scalars->InsertNextValue(p[0]);
      radii->InsertNextValue(p[2]);
      const double red = std::floor(255.0 * p[1] + 0.5);
      colors->InsertNextTuple3(red, 0.0, 255.0 - red);
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetPointData()->SetScalars(scalars);
  lines->GetPointData()->AddArray(radii);
  lines->GetPointData()->AddArray(colors);
}

double GetLength(const Capsule& capsule)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(capsule.Start, capsule.End));
}

// Distance of a point to the capsules of a curve, as lines.
double GetDistance(const std::vector<Capsule>& capsules, const double point[3])
{
  double nearest = std::numeric_limits<double>::infinity();
  for (Capsule capsule : capsules)
  {
    capsule.StartRadius = 0.0;
    capsule.EndRadius = 0.0;
    nearest = std::min(nearest, GetCapsuleDistance(capsule, point));
  }
  return nearest;
}

void CheckEnd(Checker& checker, const CapsuleScene& scene, const double point[3], double value,
  double radius, const unsigned char color[4], double tolerance)
{
  double share[3];
  for (int i = 0; i < 3; ++i)
  {
    share[i] = (scene.Origin[i] + point[i] - Offset) / Side;
  }
  // Half a step of 8 bits, and what the point itself may be off.
  const double step = 0.5 / 255.0 + 1e-6 + tolerance / Side;
  checker.CheckNear(radius, share[2], step, "radius");
  if (scene.Colors == ColorSource::Scalars)
  {
    checker.CheckNear(value, share[0], step, "scalar");
  }
  else
  {
    checker.CheckNear(color[0] / 255.0, share[1], 2.0 * step, "red");
    checker.CheckNear(color[2] / 255.0, 1.0 - share[1], 2.0 * step, "blue");
    checker.Check(color[3] == 255, "opacity");
  }
}

void CheckModel(Checker& checker, vtkPolyData* lines, int bins, const std::string& colors)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(24);
  voxelizer->SetFaceBins(bins);
  voxelizer->SetInteriorTolerance(0.0);
  voxelizer->SetRadiusArrayName("radius");
  voxelizer->SetDirectColors(colors == "color");
  voxelizer->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, colors.c_str());
  voxelizer->Update();
  auto* model = vtkVoxelLineModel::SafeDownCast(voxelizer->GetOutputDataObject(0));
  const CapsuleScene scene = MakeCapsulesFromModel(model, 5.0);
  const CapsuleScene original = MakeCapsulesFromLines(lines, { 1.0, "", "" });
  checker.Check(static_cast<vtkIdType>(scene.Capsules.size()) == model->GetNumberOfSegments() &&
      scene.Capsules.size() > original.Capsules.size(),
    "as many capsules as segments");
  checker.Check((scene.Colors == ColorSource::Direct) == (colors == "color"), "kind of colours");

  std::map<vtkIdType, std::vector<Capsule>> curves;
  std::map<vtkIdType, double> lengths;
  for (Capsule capsule : original.Capsules)
  {
    for (int i = 0; i < 3; ++i)
    {
      capsule.Start[i] += original.Origin[i] - scene.Origin[i];
      capsule.End[i] += original.Origin[i] - scene.Origin[i];
    }
    curves[capsule.Curve].push_back(capsule);
    lengths[capsule.Curve] += GetLength(capsule);
  }
  // Points are off by half a bin's diagonal, on a face or inside a voxel.
  const double voxel = model->GetVoxelSize();
  const double tolerance = bins == 0 ? 2e-6 * voxel : 0.9 * voxel / model->GetInteriorBins();
  std::map<vtkIdType, double> decoded;
  for (const Capsule& capsule : scene.Capsules)
  {
    const vtkIdType cell = model->GetCurveCells()->GetTypedComponent(capsule.Curve, 1);
    checker.Check(GetDistance(curves[cell], capsule.Start) <= tolerance, "start on its curve");
    checker.Check(GetDistance(curves[cell], capsule.End) <= tolerance, "end on its curve");
    CheckEnd(checker, scene, capsule.Start, capsule.StartValue, capsule.StartRadius,
      capsule.StartColor, tolerance);
    CheckEnd(checker, scene, capsule.End, capsule.EndValue, capsule.EndRadius, capsule.EndColor,
      tolerance);
    decoded[cell] += GetLength(capsule);
  }
  for (const auto& length : lengths)
  {
    checker.CheckNear(
      decoded[length.first], length.second, bins == 0 ? 1e-4 : 0.1 * length.second, "length");
  }
}
}

int TestCapsulesFromModel(int, char*[])
{
  Checker checker;
  vtkNew<vtkPolyData> lines;
  MakeLines(lines);
  for (const int bins : { 0, 32, 256 })
  {
    CheckModel(checker, lines, bins, "x");
    CheckModel(checker, lines, bins, "color");
  }
  vtkNew<vtkVoxelLineModel> empty;
  checker.Check(MakeCapsulesFromModel(empty, 1.0).Capsules.empty(), "an empty model");
  return checker.GetExitCode();
}
