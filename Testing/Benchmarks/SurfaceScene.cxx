// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceScene.h"

#include "SceneFields.h"
#include "SceneImportance.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
namespace
{
constexpr double Lowest = 0.03; // heights of the curves
constexpr double Highest = 0.8;
constexpr double Innermost = 0.08; // distances from the core, relative to its radius
constexpr double Outermost = 0.38;
constexpr double Angle = 5.0;     // by which a surface winds about the core, in radians
constexpr double FirstGap = -0.6; // direction in which the innermost surface is open
constexpr double GapTurn = 0.35;  // from one surface to the next

// The tornado with all air going around the core at one radian per unit of time: its stream lines
// are the same, and points of a surface that are reached at one time lie side by side.
class TurningField : public VectorField
{
public:
  bool Evaluate(const double point[3], double time, double vector[3]) const override
  {
    if (!this->Tornado.Evaluate(point, time, vector))
    {
      return false;
    }
    double center[2];
    double radius;
    TornadoField::GetCore(point[2], center, radius);
    const double x = point[0] - center[0];
    const double y = point[1] - center[1];
    const double rate = std::fabs(x * vector[1] - y * vector[0]) / (x * x + y * y);
    vtkMath::MultiplyScalar(vector, 1.0 / rate);
    return std::isfinite(1.0 / rate);
  }

private:
  TornadoField Tornado;
};

vtkSmartPointer<vtkPolyData> TraceSurfaces(int lines, int vertices)
{
  TraceOptions trace;
  trace.Lines = static_cast<vtkIdType>(NumberOfSurfaces) * lines;
  trace.Vertices = vertices;
  trace.MakeSeed = [lines](vtkIdType line, Random&, double point[3])
  {
    const int surface = static_cast<int>(line / lines);
    const double along = static_cast<double>(line % lines) / (lines - 1);
    const double outward = surface / (NumberOfSurfaces - 1.0);
    double center[2];
    double radius;
    point[2] = Lowest + along * (Highest - Lowest);
    TornadoField::GetCore(point[2], center, radius);
    radius *= Innermost + outward * (Outermost - Innermost);
    // The seeds are in the middle of the stream lines, opposite the gap.
    const double angle = FirstGap + vtkMath::Pi() + GapTurn * surface;
    point[0] = center[0] + radius * std::cos(angle);
    point[1] = center[1] + radius * std::sin(angle);
  };
  trace.ByTime = true;
  trace.BothWays = true;
  trace.Step = Angle / (vertices - 1.0);
  trace.Substeps = std::max(1, 50 / vertices);
  trace.FewestSteps = vertices - 1;
  trace.Attempts = 1;
  return TraceLines(TurningField(), trace);
}

// The vector from the vertex before to the one after, `stride` apart on the grid of a surface.
void GetDifference(
  vtkFloatArray* points, vtkIdType id, int index, int count, vtkIdType stride, double vector[3])
{
  const vtkIdType before = index > 0 ? id - stride : id;
  const vtkIdType after = index + 1 < count ? id + stride : id;
  for (int i = 0; i < 3; ++i)
  {
    vector[i] = points->GetTypedComponent(after, i) - points->GetTypedComponent(before, i);
  }
}

vtkSmartPointer<vtkFloatArray> MakeNormals(vtkFloatArray* points, int lines, int vertices)
{
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(points->GetNumberOfTuples());
  vtkSMPTools::For(0, points->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        double around[3];
        double up[3];
        double normal[3];
        GetDifference(points, id, static_cast<int>(id % vertices), vertices, 1, around);
        GetDifference(points, id, static_cast<int>(id / vertices % lines), lines, vertices, up);
        vtkMath::Cross(around, up, normal);
        vtkMath::Normalize(normal);
        for (int i = 0; i < 3; ++i)
        {
          normals->SetTypedComponent(id, i, static_cast<float>(normal[i]));
        }
      }
    });
  return normals;
}

vtkSmartPointer<vtkCellArray> MakeTriangles(int lines, int vertices)
{
  const vtkIdType count =
    static_cast<vtkIdType>(NumberOfSurfaces) * 2 * (lines - 1) * (vertices - 1);
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> ids;
  offsets->SetNumberOfValues(count + 1);
  ids->SetNumberOfValues(3 * count);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  vtkIdType place = 0;
  for (vtkIdType line = 0; line < static_cast<vtkIdType>(NumberOfSurfaces) * lines; ++line)
  {
    if (line % lines == lines - 1)
    {
      continue; // the last one of a surface
    }
    for (vtkIdType i = line * vertices; i < line * vertices + vertices - 1; ++i)
    {
      const vtkIdType above = i + vertices;
      for (const vtkIdType id : { i, i + 1, above + 1, i, above + 1, above })
      {
        ids->SetValue(place++, id);
      }
    }
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

// The speed of the wind, in place of that of the turning field.
void SetSpeeds(vtkPolyData* surfaces)
{
  const TornadoField tornado;
  auto* speeds = vtkFloatArray::SafeDownCast(surfaces->GetPointData()->GetScalars());
  vtkSMPTools::For(0, surfaces->GetNumberOfPoints(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double point[3];
        double vector[3];
        surfaces->GetPoint(i, point);
        tornado.Evaluate(point, 0.0, vector);
        speeds->SetValue(i, static_cast<float>(vtkMath::Norm(vector)));
      }
    });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSurfaceScene(int lines, int vertices)
{
  vtkSmartPointer<vtkPolyData> surfaces = TraceSurfaces(lines, vertices);
  auto* coordinates = vtkFloatArray::SafeDownCast(surfaces->GetPoints()->GetData());
  surfaces->SetLines(nullptr);
  surfaces->SetPolys(MakeTriangles(lines, vertices));
  surfaces->GetPointData()->SetNormals(MakeNormals(coordinates, lines, vertices));
  SetSpeeds(surfaces);
  AddImportance(surfaces,
    [](vtkIdType, const double point[3]) { return -TornadoField::GetCoreDistance(point); });
  return surfaces;
}
}
