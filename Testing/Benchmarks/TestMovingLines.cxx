// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the moving lines of the benchmark: at rest in frame 0, where the formula puts them in
// others, within bounds that hardly grow, in data of their own, the same for all numbers of
// threads; and degenerate lines go along without harm.

#include "MovingLines.h"
#include "ReferenceTesting.h"
#include "Scenes.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace linesets;

namespace
{
double GetLargestDistance(vtkPolyData* a, vtkPolyData* b)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  return largest;
}

bool HaveSamePoints(vtkPolyData* a, vtkPolyData* b)
{
  vtkDataArray* p = a->GetPoints()->GetData();
  vtkDataArray* q = b->GetPoints()->GetData();
  return p->GetNumberOfValues() == q->GetNumberOfValues() && p->GetDataType() == q->GetDataType() &&
    std::memcmp(p->GetVoidPointer(0), q->GetVoidPointer(0),
      static_cast<std::size_t>(p->GetNumberOfValues()) * p->GetDataTypeSize()) == 0;
}

// A line along x through the middle of a box 8 x 4 x 2, whose corners stretch the bounds.
void CheckFormula(Checker& checker)
{
  vtkNew<vtkPolyData> lines;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double places[][3] = { { -1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { -4, -2, -1 }, { 4, 2, 1 },
    { 0, 1, 1 }, { 0, 1, 1 }, { 0, 1, 1 } };
  for (const double* place : places)
  {
    points->InsertNextPoint(place);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  cells->InsertNextCell({ 3 });
  cells->InsertNextCell({ 5, 6 });
  lines->SetPoints(points);
  lines->SetLines(cells);

  const MovingLines moving(lines);
  const int frame = 7;
  const double advance = 0.08 * std::sin(2.0 * vtkMath::Pi() * frame / 24.0);
  const double angle =
    vtkMath::RadiansFromDegrees(15.0) * std::sin(2.0 * vtkMath::Pi() * frame / 48.0);
  vtkSmartPointer<vtkPolyData> moved = moving.GetLines(frame);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const double x = places[i][0] + (i < 3 ? advance : 0.0);
    const double y = places[i][1];
    const double turn = std::max(0.0, 1.0 - (x * x + y * y) / 4.0) * angle;
    double point[3];
    moved->GetPoint(i, point);
    const std::string name = "point " + std::to_string(i);
    checker.CheckNear(point[0], std::cos(turn) * x - std::sin(turn) * y, 1e-7, name + " x");
    checker.CheckNear(point[1], std::sin(turn) * x + std::cos(turn) * y, 1e-7, name + " y");
    checker.CheckNear(point[2], places[i][2], 1e-7, name + " z");
  }
}

void CheckScene(Checker& checker)
{
  SceneOptions options;
  options.Lines = 30;
  options.Vertices = 40;
  vtkSmartPointer<vtkPolyData> lines = MakeScene("lorenz", options);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(lines);
  double bounds[6];
  lines->GetBounds(bounds);
  const double size =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });

  const MovingLines moving(lines);
  checker.Check(HaveSamePoints(moving.GetLines(0), lines), "moved in frame 0");
  for (int frame = 1; frame <= 48; ++frame)
  {
    vtkSmartPointer<vtkPolyData> moved = moving.GetLines(frame);
    const double step = GetLargestDistance(moved, moving.GetLines(frame - 1));
    checker.Check(step > 0.001 * size && step < 0.03 * size, "step to " + std::to_string(frame));
    double box[6];
    moved->GetBounds(box);
    for (int i = 0; i < 6; ++i)
    {
      const double growth = i % 2 == 0 ? bounds[i] - box[i] : box[i] - bounds[i];
      checker.Check(growth <= 0.01001 * size, "bounds of " + std::to_string(frame));
    }
    checker.Check(moved->GetLines() != lines->GetLines() &&
        moved->GetPoints() != lines->GetPoints() &&
        moved->GetPointData()->GetScalars() != lines->GetPointData()->GetScalars() &&
        moved->GetPointData()->GetScalars(),
      "data shared");
  }
  checker.Check(HaveSamePoints(before, lines), "the lines at rest were changed");

  vtkSmartPointer<vtkPolyData> parallel = moving.GetLines(5);
  vtkSMPTools::Initialize(1);
  checker.Check(HaveSamePoints(moving.GetLines(5), parallel), "differs by threads");
}
}

int TestMovingLines(int, char*[])
{
  Checker checker;
  CheckFormula(checker);
  CheckScene(checker);
  return checker.GetExitCode();
}
