// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards which capsules the reference makes of a vtkPolyData: cells, attributes, radii, and what
// becomes of points that are not finite.

#include "CapsulesFromLines.h"
#include "ReferenceTesting.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <stdexcept>

using namespace linesets;

namespace
{
void MakeLines(vtkPolyData* lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("color");
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    points->InsertNextPoint(i, i == 5 ? nan : 0.0, 1e9);
    values->InsertNextValue(10.0 * i);
    colors->InsertNextTuple3(i, 2 * i, 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  cells->InsertNextCell({ 3, 4, 5, 6, 7 });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  lines->SetPoints(points);
  lines->SetVerts(verts);
  lines->SetLines(cells);
  lines->GetPointData()->AddArray(values);
  lines->GetPointData()->AddArray(colors);
}
}

int TestCapsulesFromLines(int, char*[])
{
  Checker checker;
  vtkNew<vtkPolyData> lines;
  checker.Check(MakeCapsulesFromLines(lines, {}).Capsules.empty(), "empty input");
  MakeLines(lines);
  const CapsuleScene scene = MakeCapsulesFromLines(lines, { 0.5, "", "value" });
  checker.Check(scene.Colors == ColorSource::Scalars, "scalars");
  checker.Check(scene.Capsules.size() == 4, "two, one and one segments");
  const vtkIdType curves[4] = { 1, 1, 2, 3 };
  for (int i = 0; i < 4; ++i)
  {
    const Capsule& capsule = scene.Capsules[i];
    const int first = i < 2 ? i : (i == 2 ? 3 : 6);
    checker.Check(capsule.Curve == curves[i], "curves are cells, and parts after a gap");
    checker.Check(capsule.Start[0] + scene.Origin[0] == first, "start");
    checker.Check(capsule.End[0] + scene.Origin[0] == first + 1, "end");
    checker.Check(std::fabs(capsule.Start[2]) < 10.0, "relative to an origin near the data");
    checker.Check(
      capsule.StartValue == 10.0 * first && capsule.EndValue == 10.0 * first + 10.0, "values");
    checker.Check(capsule.StartRadius == 0.5 && capsule.EndRadius == 0.5, "radius");
  }
  const CapsuleScene colored = MakeCapsulesFromLines(lines, { 0.5, "value", "color" });
  checker.Check(colored.Colors == ColorSource::Direct, "colours");
  checker.Check(colored.Capsules[3].StartColor[2] == 18 && colored.Capsules[3].EndColor[0] == 7 &&
      colored.Capsules[3].EndColor[3] == 255,
    "bytes of the colours");
  checker.Check(colored.Capsules[1].StartRadius == 10.0 && colored.Capsules[1].EndRadius == 20.0,
    "radius by array");
  bool thrown = false;
  try
  {
    MakeCapsulesFromLines(lines, { 0.5, "none", "" });
  }
  catch (const std::invalid_argument&)
  {
    thrown = true;
  }
  checker.Check(thrown, "an array that does not exist is an error");
  return checker.GetExitCode();
}
