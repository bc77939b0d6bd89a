// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the optimized opacity of blades, lines and points, read from pixels in which nothing else
// is drawn, against Eq. 2 in double precision, pixel by pixel: the smallest fragment of an element
// counts. With sums by each series and exact ones, importance 0 and 1 everywhere, weights at their
// ends, reduced resolution and subsets.

#include "FourierOpacityTesting.h"

using namespace FourierOpacityTesting;

namespace
{
constexpr int Size = 64;

// Opacities are rounded to bytes with the picture.
constexpr double Tolerance = 1.6;

/// An element: what it covers, in units of the view (-1 to 1), and a place where it is alone.
struct Shape
{
  double Depth = 0.0;
  double Importance = 0.0;
  std::function<bool(double, double)> Covers;
  double Alone[2] = { 0.0, 0.0 };
};

enum Kind
{
  Blades,
  Lines,
  Points
};
constexpr const char* KindNames[] = { "blades", "lines", "points" };

constexpr double HalfWidth = 0.11;
constexpr double HalfLength = 0.9;

// Blades and lines cross in the middle of the view; points are squares that overlap in a row.
std::vector<Shape> MakeShapes(Kind kind, const std::vector<double>& importance, int seed)
{
  Random random(seed);
  std::vector<Shape> shapes(importance.size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    Shape& shape = shapes[i];
    shape.Depth = random(0.02, 0.98);
    shape.Importance = importance[i];
    if (kind == Points)
    {
      // Pixels 8 + 5 i to 24 + 5 i, and a quarter of one: no edge goes through the middle of a
      // pixel, at reduced resolution neither, and sizes are whole there, too, since devices may
      // round them.
      const double low = -1.0 + (8.25 + 5.0 * i) / 32.0;
      const double high = low + 16.0 / 32.0;
      shape.Covers = [low, high](double x, double y)
      { return x > low && x < high && y > low && y < high; };
      shape.Alone[0] = low + 2.0 / 32.0;
      shape.Alone[1] = high - 2.0 / 32.0;
      continue;
    }
    const double angle = vtkMath::Pi() * (static_cast<double>(i) + 0.25) / shapes.size();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    shape.Covers = [c, s](double x, double y)
    { return std::abs(c * x + s * y) < HalfLength && std::abs(c * y - s * x) < HalfWidth; };
    shape.Alone[0] = 0.8 * c;
    shape.Alone[1] = 0.8 * s;
  }
  return shapes;
}

/// Shapes and two elements outside of the view at the ends of the depth, white.
vtkSmartPointer<vtkPolyData> MakeData(Kind kind, const std::vector<Shape>& shapes, bool onCells)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> ofPoints;
  vtkNew<vtkFloatArray> ofCells;
  ofPoints->SetName("Importance");
  ofCells->SetName("Importance");
  const auto add = [&](const std::vector<Point>& corners, double importance)
  {
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const Point& corner : corners)
    {
      cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
      ofPoints->InsertNextValue(static_cast<float>(importance));
    }
    ofCells->InsertNextValue(static_cast<float>(importance));
  };
  for (const Shape& shape : shapes)
  {
    const double z = GetZ(shape.Depth);
    const double c = shape.Alone[0] / 0.8;
    const double s = shape.Alone[1] / 0.8;
    const double a = HalfLength;
    const double b = kind == Blades ? HalfWidth : 0.0;
    switch (kind)
    {
      case Blades:
        add({ { -a * c + b * s, -a * s - b * c, z }, { a * c + b * s, a * s - b * c, z },
              { a * c - b * s, a * s + b * c, z }, { -a * c - b * s, -a * s + b * c, z } },
          shape.Importance);
        break;
      case Lines:
        add({ { -a * c, -a * s, z }, { a * c, a * s, z } }, shape.Importance);
        break;
      default:
        add({ { shape.Alone[0] + 6.0 / 32.0, shape.Alone[1] - 6.0 / 32.0, z } }, shape.Importance);
        break;
    }
  }
  for (double z : { 0.9, -0.9 })
  {
    const std::vector<Point> end{ { 4.0, 0.0, z }, { 4.0 + 2.0 * HalfLength, 0.0, z },
      { 5.0, 0.1, z } };
    add(
      std::vector<Point>(end.begin(), end.begin() + (kind == Blades ? 3 : (kind == Lines ? 2 : 1))),
      0.0);
  }
  data->SetPoints(points);
  (kind == Blades ? data->SetPolys(cells)
                  : (kind == Lines ? data->SetLines(cells) : data->SetVerts(cells)));
  if (onCells)
  {
    data->GetCellData()->AddArray(ofCells);
  }
  else
  {
    data->GetPointData()->AddArray(ofPoints);
  }
  return data;
}

/// Opacities of the shapes that one pixel shows, by Eq. 2.
std::vector<double> GetOpacities(
  Optimization* by, const std::vector<Shape>& shapes, const std::vector<std::size_t>& shown)
{
  const int sums = 2 * by->GetNumberOfBands() + 1;
  const int n = by->GetImportance() == Optimization::ExactImportance ? 1 : by->GetSubset();
  Values values;
  for (std::size_t i : shown)
  {
    const double g = shapes[i].Importance;
    values.Depths.push_back(shapes[i].Depth);
    values.Sizes.push_back(static_cast<int>(i) % n == 0 ? n * g * g : 0.0);
  }
  const double total = values.GetTotal();
  std::vector<double> opacities;
  for (std::size_t k = 0; k < shown.size(); ++k)
  {
    double front;
    double behind = -1.0;
    if (by->GetImportance() == Optimization::ExactImportance)
    {
      front = values.GetExactFront(k);
    }
    else if (by->GetBlending() == Optimization::PaperFourier)
    {
      // Eq. 10, where the sum at a fragment stands for the sum with it.
      const double here =
        values.GetSum(SinesAndCosines, sums, values.Depths[k], static_cast<std::size_t>(-1));
      const double others = total - values.Sizes[k];
      front = std::min(std::max(here - values.Sizes[k], 0.0), others);
      behind = std::min(std::max(total - here, 0.0), total);
    }
    else
    {
      const Series series = by->GetBlending() == Optimization::Bins ? EqualBins : Cosines;
      front = values.GetSeriesFront(series, sums, k);
    }
    behind = behind < 0.0 ? std::max(total - values.Sizes[k] - front, 0.0) : behind;
    opacities.push_back(GetOptimalOpacity(shapes[shown[k]].Importance, front, behind, by));
  }
  return opacities;
}

/// The smallest opacity of each shape over all pixels.
std::vector<double> GetSmallest(Optimization* by, const std::vector<Shape>& shapes)
{
  std::vector<double> smallest(shapes.size(), 1.0);
  const int size = Size / by->GetImportanceReduction();
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      std::vector<std::size_t> shown;
      for (std::size_t i = 0; i < shapes.size(); ++i)
      {
        if (shapes[i].Covers((2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0))
        {
          shown.push_back(i);
        }
      }
      const std::vector<double> opacities = GetOpacities(by, shapes, shown);
      for (std::size_t k = 0; k < shown.size(); ++k)
      {
        smallest[shown[k]] = std::min(smallest[shown[k]], opacities[k]);
      }
    }
  }
  return smallest;
}

struct Scene : OpacityStage
{
  Scene()
    : OpacityStage(Size, Size)
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Actor->GetProperty()->SetPointSize(16.0);
    // As wide as the blades.
    this->Actor->GetProperty()->SetLineWidth(static_cast<float>(Size * HalfWidth));
    this->Mapper->SetNumberOfPatches(1);
    this->Mapper->SetNumberOfLineSegments(1);
    this->GetOptimization()->SetImportanceReduction(1);
  }
};

// Grey of a shape where it is alone. Its surroundings are the same, so that no edge is near.
int GetGrey(const Picture& picture, const Shape& shape)
{
  return picture.At(static_cast<int>((shape.Alone[0] + 1.0) * Size / 2),
    static_cast<int>((shape.Alone[1] + 1.0) * Size / 2))[0];
}

void CheckShapes(Checks& check, const std::string& name, Scene& scene, const Picture& picture,
  const std::vector<Shape>& shapes)
{
  Optimization* by = scene.GetOptimization();
  const std::vector<double> expected = GetSmallest(by, shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const bool isOpaque =
      by->GetBlending() == Optimization::Fourier && expected[i] >= by->GetOpaqueThreshold();
    const double grey = 255.0 * (isOpaque ? 1.0 : expected[i]);
    check(std::abs(GetGrey(picture, shapes[i]) - grey) < Tolerance,
      name + ", importance " + std::to_string(shapes[i].Importance) + ": grey " +
        std::to_string(GetGrey(picture, shapes[i])) + " instead of " + std::to_string(grey));
  }
}

struct Weights
{
  const char* Name;
  double P, Q, R, Lambda;
};

constexpr Weights AllWeights[] = { { "usual weights", 1.0, 50.0, 50.0, 2.0 },
  { "foreground", 1.0, 20.0, 0.5, 1.5 }, { "background", 1.0, 1.0, 30.0, 2.0 },
  { "only ratios count", 10.0, 200.0, 5.0, 1.5 }, { "no background", 1.0, 5.0, 0.0, 1.0 },
  { "no foreground", 1.0, 0.0, 5.0, 1.0 }, { "q = r = 0", 1.0, 0.0, 0.0, 2.0 },
  { "smallest lambda", 1.0, 5.0, 2.0, 0.01 }, { "largest lambda", 1.0, 50.0, 20.0, 100.0 },
  { "largest weights", 1e-6, 1e6, 1e6, 2.0 } };

void SetWeights(Optimization* by, const Weights& weights)
{
  by->SetRegularizationWeight(weights.P);
  by->SetForegroundWeight(weights.Q);
  by->SetBackgroundWeight(weights.R);
  by->SetEmphasis(weights.Lambda);
}

void CheckEquation(Checks& check, Kind kind)
{
  struct
  {
    const char* Name;
    int Blending;
    int Importance;
    int Bands;
  } methods[] = { { "exact", Optimization::FragmentLists, Optimization::ExactImportance, 5 },
    { "cosines", Optimization::FragmentLists, Optimization::SeriesImportance, 5 },
    { "Fourier", Optimization::Fourier, Optimization::SeriesImportance, 3 },
    { "paper", Optimization::PaperFourier, Optimization::SeriesImportance, 5 },
    { "bins", Optimization::Bins, Optimization::SeriesImportance, 5 } };
  Scene scene;
  Optimization* by = scene.GetOptimization();
  const std::vector<double> mixed = kind == Points ? std::vector<double>{ 0.1, 0.9, 0.0, 0.6 }
                                                   : std::vector<double>{ 0.1, 0.9, 0.0, 0.6, 0.3 };
  const std::string name = std::string(KindNames[kind]) + ", ";
  for (const auto& method : methods)
  {
    by->SetBlending(method.Blending);
    by->SetImportance(method.Importance);
    by->SetNumberOfBands(method.Bands);
    for (const Weights& weights : AllWeights)
    {
      SetWeights(by, weights);
      const std::vector<Shape> shapes = MakeShapes(kind, mixed, 3);
      const Picture picture = scene.Render(MakeData(kind, shapes, kind == Lines));
      CheckShapes(check, name + method.Name + ", " + weights.Name, scene, picture, shapes);
    }
    SetWeights(by, AllWeights[0]);
    for (double all : { 0.0, 1.0 })
    {
      const auto shapes = MakeShapes(kind, std::vector<double>(mixed.size(), all), 5);
      const Picture picture = scene.Render(MakeData(kind, shapes, false));
      for (const Shape& shape : shapes)
      {
        check(GetGrey(picture, shape) == 255,
          name + method.Name + ", importance " + std::to_string(all) + " everywhere is opaque");
      }
    }
  }
  // At reduced resolution; and every second or third of the points stands for all.
  for (int reduction : { 2, 4 })
  {
    by->SetImportanceReduction(reduction);
    const std::vector<Shape> shapes = MakeShapes(kind, mixed, 3);
    CheckShapes(check, name + "reduced by " + std::to_string(reduction), scene,
      scene.Render(MakeData(kind, shapes, false)), shapes);
  }
  by->SetImportanceReduction(1);
  for (int n : { 2, 3 })
  {
    by->SetSubset(n);
    by->SetBlendingToFragmentLists();
    SetWeights(by, AllWeights[1]);
    const std::vector<Shape> shapes = MakeShapes(kind, mixed, 3);
    if (kind == Points)
    {
      CheckShapes(check, name + "subset of " + std::to_string(n), scene,
        scene.Render(MakeData(kind, shapes, false)), shapes);
    }
  }
}
}

int TestFourierOpacityImportance(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  for (Kind kind : { Blades, Lines, Points })
  {
    CheckEquation(check, kind);
  }
  return check.GetResult();
}
