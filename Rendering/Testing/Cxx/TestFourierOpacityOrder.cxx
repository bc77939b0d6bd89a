// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that no order of cells changes the picture: lines, triangles, points and a mixture, by
// each method. Lists give the same bits. Other methods add floats, whose sums depend on the order
// in the last bit: the opacity of a segment may differ by that, and a pixel by one step of its
// byte.

#include "FourierOpacityTesting.h"

using namespace FourierOpacityTesting;

namespace
{
enum Kind
{
  Lines,
  Triangles,
  Points,
  Mixture
};
constexpr const char* KindNames[] = { "lines", "triangles", "points", "mixture" };

// Cells that share no points, drawn in some order. Points and their values are in the order of the
// cells, so that nothing but the order differs.
vtkSmartPointer<vtkPolyData> MakeCells(Kind kind, int count, const std::vector<int>& order)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells[3];
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  for (int i : order)
  {
    Random random(i + 1);
    const int type = kind == Mixture ? i * 3 / count : static_cast<int>(kind);
    // A multiple of 1/1024: lengths do not depend on the order in which they are added.
    const auto next = [&random]() { return std::floor(random(-0.9, 0.9) * 1024.0) / 1024.0; };
    const Point start{ next(), next(), next() };
    const int size = type == Points ? 1 : 3;
    vtkIdType ids[3];
    const double g = random(0.0, 1.0);
    const unsigned char color[4] = { static_cast<unsigned char>(random(0.0, 255.0)),
      static_cast<unsigned char>(random(0.0, 255.0)),
      static_cast<unsigned char>(random(0.0, 255.0)), 200 };
    for (int k = 0; k < size; ++k)
    {
      ids[k] = points->InsertNextPoint(start[0] + (k == 1 ? 0.5 : 0.0),
        start[1] + (k == 2 ? 0.5 : 0.0), start[2] + (k == 1 ? 0.25 : 0.0));
      importance->InsertNextValue(static_cast<float>(g * g));
      colors->InsertNextTypedTuple(color);
    }
    cells[type]->InsertNextCell(size, ids);
  }
  data->SetPoints(points);
  data->SetLines(cells[Lines]);
  data->SetPolys(cells[Triangles]);
  data->SetVerts(cells[Points]);
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->AddArray(importance);
  return data;
}

void CheckOrder(Checks& check, Kind kind)
{
  struct
  {
    int Blending;
    int Importance;
  } methods[] = { { Optimization::Fourier, Optimization::SeriesImportance },
    { Optimization::Fourier, Optimization::ExactImportance },
    { Optimization::PaperFourier, Optimization::SeriesImportance },
    { Optimization::Bins, Optimization::SeriesImportance },
    { Optimization::WeightedAverage, Optimization::SeriesImportance },
    { Optimization::WeightedBlended, Optimization::ExactImportance },
    { Optimization::FragmentLists, Optimization::SeriesImportance },
    { Optimization::FragmentLists, Optimization::ExactImportance } };
  const int count = kind == Points ? 400 : 60;
  OpacityStage stage(48, 48);
  stage.Actor->GetProperty()->SetPointSize(5.0);
  stage.Actor->GetProperty()->SetLineWidth(3.0);
  stage.Mapper->SetNumberOfLineSegments(300);
  stage.Mapper->SetNumberOfPatches(count);
  const std::vector<int> order = MakeOrder(static_cast<std::size_t>(count));
  for (const auto& method : methods)
  {
    stage.GetOptimization()->SetBlending(method.Blending);
    stage.GetOptimization()->SetImportance(method.Importance);
    const bool isExact = method.Blending == Optimization::FragmentLists &&
      method.Importance == Optimization::ExactImportance;
    const std::string name = std::string(KindNames[kind]) + ", " + MethodNames[method.Blending] +
      (method.Importance == Optimization::ExactImportance ? ", exact importance" : "");
    const Picture first = stage.Render(MakeCells(kind, count, order));
    check(GetCoverage(first, Background) > 0.2, name + ": something is drawn");
    // Nothing of a picture is left in the next one.
    check(stage.Stage::Render().Bytes == first.Bytes, name + ": drawn again");
    for (int seed : { 1, 2 })
    {
      const Picture other = stage.Render(MakeCells(kind, count, Shuffle(order, seed)));
      const Difference difference = Compare(first, other);
      check(difference.Largest <= (isExact ? 0 : 1),
        name + ": another order" + VoxelLineMapperTesting::Describe(difference));
    }
  }
}
}

int TestFourierOpacityOrder(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  for (Kind kind : { Lines, Triangles, Points, Mixture })
  {
    CheckOrder(check, kind);
  }
  return check.GetResult();
}
