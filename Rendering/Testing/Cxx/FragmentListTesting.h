// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of fragment lists share: a window drawn by a vtkFragmentListPass, upright squares of
 * known colours, opacities and depths, and their blending in double precision.
 */

#ifndef FragmentListTesting_h
#define FragmentListTesting_h

#include "RenderPassTesting.h"

#include "vtkFloatArray.h"
#include "vtkFragmentListPass.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkRenderStepsPass.h"

#include <numeric>

namespace FragmentListTesting
{
using namespace VoxelLineMapperTesting;

/// A square about (x, y, z), of a colour and an opacity as bytes.
struct Square
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
  double HalfSize = 0.5;
  std::array<unsigned char, 4> Color{ 255, 255, 255, 128 };
};

/// Squares at depths from -0.9 to 0.9, with colours and opacities by chance.
inline std::vector<Square> MakeSquares(int count, int lowestOpacity, int highestOpacity)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(7);
  const auto next = [&random](double low, double high)
  {
    const double value = random->GetRangeValue(low, high);
    random->Next();
    return value;
  };
  std::vector<Square> squares(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    Square& square = squares[i];
    square.Z = 0.9 - 1.8 * (i + 0.5) / count;
    for (int k = 0; k < 3; ++k)
    {
      square.Color[k] = static_cast<unsigned char>(next(0.0, 255.0));
    }
    square.Color[3] = static_cast<unsigned char>(next(lowestOpacity, highestOpacity));
  }
  return squares;
}

/// Cells in the order of a list of indices, coloured directly, one cell each.
inline vtkSmartPointer<vtkPolyData> MakePolyData(
  const std::vector<Square>& squares, const std::vector<int>& order)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (int i : order)
  {
    const Square& square = squares[i];
    const double s = square.HalfSize;
    const vtkIdType first = points->InsertNextPoint(square.X - s, square.Y - s, square.Z);
    points->InsertNextPoint(square.X + s, square.Y - s, square.Z);
    points->InsertNextPoint(square.X + s, square.Y + s, square.Z);
    points->InsertNextPoint(square.X - s, square.Y + s, square.Z);
    cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
    colors->InsertNextTypedTuple(square.Color.data());
  }
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colors);
  return data;
}

inline std::vector<int> MakeOrder(std::size_t count)
{
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// By chance, but the same in every run.
inline std::vector<int> Shuffle(std::vector<int> order, int seed)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(seed);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    const auto k = static_cast<std::size_t>(random->GetValue() * static_cast<double>(i));
    random->Next();
    std::swap(order[i - 1], order[std::min(k, i - 1)]);
  }
  return order;
}

inline vtkSmartPointer<vtkPolyDataMapper> MakeMapper(
  const std::vector<Square>& squares, const std::vector<int>& order)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(MakePolyData(squares, order));
  return mapper;
}

inline vtkSmartPointer<vtkPolyDataMapper> MakeMapper(const std::vector<Square>& squares)
{
  return MakeMapper(squares, MakeOrder(squares.size()));
}

/// An off-screen window that looks along -z at what lies between -1 and 1, and draws it with lists.
struct ListStage : Stage
{
  vtkNew<vtkFragmentListPass> Pass;

  explicit ListStage(int width = 60, int height = 60)
    : Stage(width, height)
  {
    LookAlongZ(*this);
    UseLists(this->Renderer, this->Pass);
  }

  static void UseLists(vtkRenderer* renderer, vtkFragmentListPass* pass)
  {
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetTranslucentPass(pass);
    vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(steps);
  }

  vtkSmartPointer<vtkActor> AddSquares(vtkMapper* mapper)
  {
    auto actor = this->Add(mapper);
    actor->GetProperty()->LightingOff();
    return actor;
  }

  vtkSmartPointer<vtkActor> AddSquares(const std::vector<Square>& squares)
  {
    return this->AddSquares(MakeMapper(squares));
  }
};

/// The squares from front to back over a colour, in double precision and units of a byte.
inline Point Blend(std::vector<Square> squares, const std::array<int, 3>& background)
{
  std::stable_sort(
    squares.begin(), squares.end(), [](const Square& a, const Square& b) { return a.Z < b.Z; });
  Point color{ static_cast<double>(background[0]), static_cast<double>(background[1]),
    static_cast<double>(background[2]) };
  for (const Square& square : squares)
  {
    const double opacity = square.Color[3] / 255.0;
    for (int k = 0; k < 3; ++k)
    {
      color[k] += opacity * (square.Color[k] - color[k]);
    }
  }
  return color;
}

/// Whether a colour is the expected one up to a part of a byte and rounding to a byte.
inline bool IsExact(const std::array<int, 3>& color, const Point& expected, double tolerance)
{
  bool isExact = true;
  for (int k = 0; k < 3; ++k)
  {
    isExact = isExact && std::abs(color[k] - expected[k]) <= tolerance;
  }
  return isExact;
}

/// A byte is rounded once; what comes before has an error far below that.
constexpr double Tolerance = 1.0;

inline std::string Describe(const Point& color)
{
  std::ostringstream text;
  text << " (" << color[0] << " " << color[1] << " " << color[2] << ")";
  return text.str();
}

inline void CheckMiddle(Checks& check, const std::string& name, ListStage& stage,
  const std::vector<Square>& squares, const std::array<int, 3>& background = Background)
{
  const Picture picture = stage.Render();
  const Point expected = Blend(squares, background);
  for (int x : { 20, 30, 40 })
  {
    const auto color = picture.At(x, 30);
    check(IsExact(color, expected, Tolerance),
      name + ": " + VoxelLineMapperTesting::Describe(color) + " instead of" + Describe(expected));
  }
  check(picture.At(4, 4) == Background, name + ": beside the squares");
}

inline void CheckStatistics(Checks& check, const std::string& name, vtkFragmentListPass* pass,
  vtkIdType layers, vtkIdType pixels)
{
  check(pass->GetNumberOfFragments() == layers * pixels,
    name + ": number of fragments " + std::to_string(pass->GetNumberOfFragments()));
  check(pass->GetLargestDepthComplexity() == (pixels > 0 ? layers : 0),
    name + ": largest depth complexity " + std::to_string(pass->GetLargestDepthComplexity()));
  check(pass->GetMeanDepthComplexity() == static_cast<double>(pixels > 0 ? layers : 0),
    name + ": mean depth complexity " + std::to_string(pass->GetMeanDepthComplexity()));
  check(pass->GetNumberOfDroppedFragments() == 0, name + ": nothing is dropped");
}
}

#endif
