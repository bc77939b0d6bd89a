// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene of squares of any importance about an opaque sphere, for tests of what surrounds the
 * mapper of opacity optimization.
 */

#ifndef FourierOpacityScene_h
#define FourierOpacityScene_h

#include "FourierOpacityTesting.h"

namespace FourierOpacityTesting
{
constexpr int SceneSize = 60;

/// How fragments are blended, and importance is summed.
struct Method
{
  int Blending = Optimization::Fourier;
  int Importance = Optimization::SeriesImportance;
};
inline void SetMethod(Optimization* by, const Method& method)
{
  by->SetBlending(method.Blending);
  by->SetImportance(method.Importance);
}

inline std::string GetName(const Method& method)
{
  return std::string(MethodNames[method.Blending]) +
    (method.Importance == Optimization::ExactImportance ? " with exact importance" : "");
}

/// Squares of all kinds of importance, of which some are nearly opaque.
inline vtkSmartPointer<vtkPolyData> MakeScene()
{
  std::vector<Square> squares = MakeSquares(9, 40, 250);
  std::vector<double> importance;
  Random random(8);
  for (Square& square : squares)
  {
    square.X = random(-0.2, 0.2);
    square.Y = random(-0.2, 0.2);
    importance.push_back(random(0.0, 1.0) * random(0.0, 1.0));
  }
  return MakeStack(squares, importance);
}

/// A scene with an opaque sphere among the squares.
struct Scene : OpacityStage
{
  explicit Scene(const Method& method = {}, int width = SceneSize, int height = SceneSize)
    : OpacityStage(width, height)
  {
    SetMethod(this->GetOptimization(), method);
    this->Mapper->SetInputData(MakeScene());
    auto block = this->AddSphere(0.1, -0.3, 0.0, 0.25);
    block->GetProperty()->SetColor(0.3, 0.9, 0.2);
  }
  Picture Render() { return this->Stage::Render(); }
};

/// Check that two pictures differ by no more than so many steps of a byte.
inline void CheckSame(Checks& check, const std::string& name, const Picture& picture,
  const Picture& expected, int tolerance = 0)
{
  const Difference difference = Compare(picture, expected);
  check(difference.Largest <= tolerance, name + VoxelLineMapperTesting::Describe(difference));
}

/// The part of a picture that begins at a pixel.
inline Picture Cut(const Picture& picture, int x, int y, int width, int height)
{
  Picture part;
  part.Width = width;
  part.Height = height;
  for (int j = y; j < y + height; ++j)
  {
    for (int i = x; i < x + width; ++i)
    {
      for (int value : picture.At(i, j))
      {
        part.Bytes.push_back(static_cast<unsigned char>(value));
      }
    }
  }
  return part;
}
}

#endif
