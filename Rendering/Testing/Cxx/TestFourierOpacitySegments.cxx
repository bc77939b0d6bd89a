// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards how arrays become importance, that elements are made anew for other points and cells but
// not for other importance, that opacity is smoothed along a line and nowhere else, and
// that lines and surfaces fade alike everywhere, whatever the number of their segments.

#include "FourierOpacityTesting.h"
#include "vtkFourierOpacityVertices.h"

#include <limits>

using namespace FourierOpacityTesting;

namespace
{
constexpr int Size = 64;

// Opacities are rounded to bytes with the picture.
constexpr double Tolerance = 1.6;

struct Scene : OpacityStage
{
  Scene()
    : OpacityStage(Size, Size)
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Actor->GetProperty()->SetLineWidth(7.0f);
    this->GetOptimization()->SetImportanceReduction(1);
  }
};

// How arrays become importance, without a picture.
void CheckArrays(Checks& check)
{
  // Two triangles that share the points 1 and 2.
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const Point& point :
    std::vector<Point>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } })
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 1, 3, 2 });
  data->SetPoints(points);
  data->SetPolys(triangles);
  const auto makeArray = [](const char* name, int components, const std::vector<double>& values)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (double value : values)
    {
      array->InsertNextValue(value);
    }
    return array;
  };
  data->GetPointData()->SetScalars(makeArray("scalars", 1, { 0.0, 0.25, 0.5, 1.0 }));
  data->GetPointData()->AddArray(makeArray("points", 1, { -2.0, 2.0, 6.0, 4.0 }));
  data->GetPointData()->AddArray(
    makeArray("vectors", 2, { 3.0, 4.0, 0.0, 0.0, 0.0, 2.5, 6.0, 8.0 }));
  data->GetCellData()->AddArray(makeArray("cells", 1, { 0.25, 0.75 }));
  data->GetCellData()->AddArray(makeArray("points", 1, { 100.0, 200.0 }));
  struct
  {
    const char* Array;
    double Range[2];
    std::vector<double> Expected;
  } cases[] = { { "", { 0.0, 1.0 }, { 0.0, 0.25, 0.5, 1.0 } },
    { "", { 1.0, 0.0 }, { 0.0, 0.25, 0.5, 1.0 } },
    { "points", { 1.0, 0.0 }, { 0.0, 0.5, 1.0, 0.75 } },
    { "points", { 0.0, 4.0 }, { 0.0, 0.5, 1.0, 1.0 } },
    { "vectors", { 0.0, 10.0 }, { 0.5, 0.0, 0.25, 1.0 } },
    { "cells", { 0.0, 1.0 }, { 0.25, 0.75, 0.75, 0.75 } },
    { "cells", { 1.0, 0.0 }, { 0.0, 1.0, 1.0, 1.0 } } };
  for (const auto& test : cases)
  {
    vtkFourierOpacityVertices vertices;
    vtkFourierOpacityVertices::Settings settings;
    settings.ArrayName = test.Array;
    settings.Range[0] = test.Range[0];
    settings.Range[1] = test.Range[1];
    const std::string name = "array \"" + settings.ArrayName + "\"";
    check(vertices.Update(data, settings), name + ": is made");
    check(!vertices.Update(data, settings), name + ": is made once");
    check(vertices.GetWarnings().empty(), name + ": no warning");
    for (int i = 0; i < 4; ++i)
    {
      check(std::abs(vertices.GetImportance()->GetValue(i) - test.Expected[i]) < 1e-6,
        name + ": point " + std::to_string(i) + " has " +
          std::to_string(vertices.GetImportance()->GetValue(i)));
    }
    settings.Range[1] += 1.0;
    check(vertices.Update(data, settings), name + ": is made anew for another range");
    data->Modified();
    check(vertices.Update(data, settings), name + ": is made anew for another input");
  }

  // What is not a number is unimportant, for points and cells.
  const double nan = vtkMath::Nan();
  const double infinity = std::numeric_limits<double>::infinity();
  data->GetPointData()->AddArray(makeArray("bad points", 1, { nan, infinity, 1.0, 3.0 }));
  data->GetCellData()->AddArray(makeArray("bad cells", 1, { nan, 1.0 }));
  const std::pair<const char*, std::array<double, 4>> bad[] = {
    { "bad points", { 0, 0, 0.25, 0.75 } }, { "bad cells", { 0.0, 0.25, 0.25, 0.25 } }
  };
  for (const auto& test : bad)
  {
    vtkFourierOpacityVertices vertices;
    vtkFourierOpacityVertices::Settings settings;
    settings.ArrayName = test.first;
    settings.Range[0] = 0.0;
    settings.Range[1] = 4.0;
    vertices.Update(data, settings);
    check(vertices.GetWarnings().size() == 1, settings.ArrayName + ": one warning");
    for (int i = 0; i < 4; ++i)
    {
      check(vertices.GetImportance()->GetValue(i) == test.second[i],
        settings.ArrayName + ": point " + std::to_string(i) + " has " +
          std::to_string(vertices.GetImportance()->GetValue(i)));
    }
  }
}

// Elements belong to points and cells: their opacities last while importance changes.
void CheckElements(Checks& check)
{
  std::vector<Curve> curves(1);
  for (int i = 0; i < 9; ++i)
  {
    curves[0].push_back({ 0.1 * i, 0.0, 0.0 });
  }
  auto data = MakeLines(curves);
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int i = 0; i < 9; ++i)
  {
    values->InsertNextValue(0.1 * i);
  }
  data->GetPointData()->AddArray(values);
  vtkFourierOpacityVertices vertices;
  vtkFourierOpacityVertices::Settings settings;
  settings.ArrayName = "values";
  settings.Range[0] = 0.0;
  settings.Range[1] = 1.0;
  settings.NumberOfLineSegments = 4;
  vertices.Update(data, settings);
  vtkNew<vtkDoubleArray> others;
  others->DeepCopy(values);
  others->SetName("others");
  const auto setValue = [&]
  {
    values->SetValue(3, 0.7);
    values->Modified();
  };
  const auto movePoint = [&]
  {
    data->GetPoints()->SetPoint(8, 3.0, 0.0, 0.0);
    data->GetPoints()->Modified();
  };
  const auto setCells = [&]
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1, 2, 3 });
    lines->InsertNextCell({ 4, 5, 6, 7, 8 });
    data->SetLines(lines);
  };
  const struct
  {
    const char* Name;
    std::function<void()> Change;
    bool MakesElements;
  } changes[] = { { "another range", [&] { settings.Range[1] = 0.5; }, false },
    { "another value", setValue, false },
    { "another array", [&] { data->GetPointData()->AddArray(others); }, false },
    { "the name of another array", [&] { settings.ArrayName = "others"; }, false },
    { "a modified input", [&] { data->Modified(); }, false }, { "another point", movePoint, true },
    { "other cells", setCells, true },
    { "another number of segments", [&] { settings.NumberOfLineSegments = 6; }, true } };
  for (const auto& change : changes)
  {
    const vtkMTimeType time = vertices.GetBuildTime();
    const std::vector<float> before(
      vertices.GetElements()->GetPointer(0), vertices.GetElements()->GetPointer(0) + 27);
    change.Change();
    check(vertices.Update(data, settings), std::string(change.Name) + ": importance is made anew");
    check((vertices.GetBuildTime() > time) == change.MakesElements,
      std::string(change.Name) + (change.MakesElements ? ": elements are" : ": no elements are") +
        " made anew");
    check(change.MakesElements ||
        std::equal(before.begin(), before.end(), vertices.GetElements()->GetPointer(0)),
      std::string(change.Name) + ": elements stay");
    check(vertices.GetElements()->GetNumberOfTuples() == 9, "elements of all points");
  }
  check(std::abs(vertices.GetImportance()->GetValue(3) - 0.6) < 1e-6, "importance in the end");
}

// Mean of a value and the mean of its neighbours on a line, so many times.
std::vector<double> Smooth(std::vector<double> values, int iterations)
{
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const std::vector<double> old = values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double before = i > 0 ? old[i - 1] : old[i + 1];
      const double after = i + 1 < values.size() ? old[i + 1] : old[i - 1];
      values[i] = 0.5 * old[i] + 0.25 * (before + after);
    }
  }
  return values;
}

// A line of eight segments, of which the first two lie before something important; another line
// beside it does not.
void CheckSmoothing(Checks& check)
{
  std::vector<Curve> curves(2);
  for (int i = 0; i <= 16; ++i)
  {
    curves[0].push_back({ -0.8 + 0.1 * i, 0.25, 0.5 });
    curves[1].push_back({ -0.8 + 0.1 * i, -0.25, 0.5 });
  }
  // The important thing is a black line, so that it adds no light. What is drawn between points of
  // two segments counts as the second one: so it ends within the second segment.
  curves.push_back({ { -0.8, 0.25, -0.5 }, { -0.55, 0.25, -0.5 } });
  auto data = MakeLines(curves);
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    importance->InsertNextValue(i < 34 ? 0.0f : 1.0f);
    const unsigned char grey = i < 34 ? 255 : 0;
    colors->InsertNextTuple3(grey, grey, grey);
  }
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->AddArray(importance);

  Scene scene;
  Optimization* by = scene.GetOptimization();
  by->SetImportanceToExact();
  by->SetBlendingToFragmentLists();
  by->SetForegroundWeight(9.0);
  // Lengths of 1.6, 1.6 and 0.25: 8, 8 and 1 segments.
  scene.Mapper->SetNumberOfLineSegments(17);
  for (int iterations : { 0, 1, 15, 1000 })
  {
    by->SetSmoothingIterations(iterations);
    const Picture picture = scene.Render(data);
    std::vector<double> expected(8, 1.0);
    expected[0] = expected[1] = 0.1;
    expected = Smooth(expected, iterations);
    const std::string name = std::to_string(iterations) + " iterations, ";
    for (int i = 0; i < 8; ++i)
    {
      // The centre of segment i is at -0.7 + 0.2 i.
      const int x = static_cast<int>((0.3 + 0.2 * i) * Size / 2);
      const int grey = picture.At(x, 40)[0];
      // Between centres opacity is linear: a pixel is 5/32 of their distance.
      const double left = i > 0 ? expected[i - 1] : expected[i];
      const double right = i < 7 ? expected[i + 1] : expected[i];
      const double slack =
        0.16 * 255.0 * std::max(std::abs(expected[i] - left), std::abs(expected[i] - right));
      check(std::abs(grey - 255.0 * expected[i]) < 2.0 + slack,
        name + "segment " + std::to_string(i) + ": grey " + std::to_string(grey) + " instead of " +
          std::to_string(255.0 * expected[i]));
      check(picture.At(x, 24)[0] == 255, name + "the other line stays opaque");
    }
  }
}

// A line, or a strip of squares, in front of an important one fades alike everywhere, however many
// of its segments lie between two of its points, or have no fragment that counts as theirs.
void CheckCoarse(Checks& check)
{
  for (bool isSurface : { false, true })
  {
    for (int segments : { 2, 6, 50, 50000 })
    {
      for (int columns : { 2, 5, 60 })
      {
        std::vector<Curve> curves(isSurface ? 4 : 2);
        for (int i = 0; i < columns; ++i)
        {
          for (std::size_t k = 0; k < curves.size(); ++k)
          {
            const bool isFront = 2 * k < curves.size();
            curves[k].push_back({ -0.9 + 1.8 * i / (columns - 1),
              isSurface ? (k % 2 == 0 ? -0.3 : 0.3) : -0.15, isFront ? 0.5 : -0.5 });
          }
        }
        if (!isSurface)
        {
          curves[1] = curves[0];
          for (Point& point : curves[1])
          {
            point[2] = -0.5;
          }
        }
        auto data = MakeLines(curves);
        if (isSurface)
        {
          vtkNew<vtkCellArray> squares;
          for (vtkIdType first : { 0, 2 * columns })
          {
            for (vtkIdType i = first; i < first + columns - 1; ++i)
            {
              squares->InsertNextCell({ i, i + 1, i + 1 + columns, i + columns });
            }
          }
          data->SetLines(nullptr);
          data->SetPolys(squares);
        }
        vtkNew<vtkFloatArray> importance;
        importance->SetName("Importance");
        vtkNew<vtkUnsignedCharArray> colors;
        colors->SetNumberOfComponents(3);
        for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
        {
          const bool isFront = 2 * i < data->GetNumberOfPoints();
          importance->InsertNextValue(isFront ? 0.0f : 1.0f);
          const double grey = isFront ? 255.0 : 0.0;
          colors->InsertNextTuple3(grey, grey, grey);
        }
        data->GetPointData()->SetScalars(colors);
        data->GetPointData()->AddArray(importance);

        Scene scene;
        scene.Mapper->SetNumberOfLineSegments(segments);
        scene.Mapper->SetNumberOfPatches(segments);
        const Picture picture = scene.Render(data);
        for (int x : { 5, 20, 32, 44, 58 })
        {
          const int grey = picture.At(x, 27)[0];
          check(std::abs(grey - 255.0 / 51.0) < Tolerance,
            std::string(isSurface ? "surface" : "line") + " of " + std::to_string(columns) +
              " points and " + std::to_string(segments) + " segments: grey " +
              std::to_string(grey));
        }
      }
    }
  }
}
}

int TestFourierOpacitySegments(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  CheckArrays(check);
  CheckElements(check);
  CheckSmoothing(check);
  CheckCoarse(check);
  return check.GetResult();
}
