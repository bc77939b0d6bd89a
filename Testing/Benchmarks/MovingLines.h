// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines that move as a whole, for pipelines that get other lines in every frame.
 *
 * In frame f a point p with the unit tangent t of its line comes to S(p + a t), where
 * a = L/100 sin(2 pi f/24) with the longest side L of the bounds, and S turns about the vertical
 * axis (z) through the centre of the bounds, by 15 degrees sin(2 pi f/48) (1 - r^2/R^2) at the
 * distance r from it. R is half the shorter of the horizontal sides; beyond R nothing turns. So
 * frames that follow on each other differ by a fraction of a percent of the size everywhere, the
 * set keeps its shape, and its bounds grow by a at most.
 */

#ifndef MovingLines_h
#define MovingLines_h

#include "vtkSmartPointer.h" // For the lines

#include <vector> // For tangents

class vtkPolyData;

namespace linesets
{
class MovingLines
{
public:
  /// The lines at rest, which are left as they are.
  explicit MovingLines(vtkPolyData* lines);

  /// The lines in a frame, with points, cells and arrays of their own, so that nothing which was
  /// made of another frame's lines can be used again. In frame 0 they are at rest.
  vtkSmartPointer<vtkPolyData> GetLines(int frame) const;

private:
  void Move(double point[3], const float tangent[3], double advance, double angle) const;

  vtkSmartPointer<vtkPolyData> Lines;
  std::vector<float> Tangents; // three per point; zero for points of no line
  double Size = 0.0;
  double Center[2] = { 0.0, 0.0 };
  double SwirlRadius = 0.0;
};
}

#endif
