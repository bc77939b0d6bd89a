// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The line cells of a vtkPolyData as capsules: what a line set should look like.
 */

#ifndef CapsulesFromLines_h
#define CapsulesFromLines_h

#include "Capsule.h"

#include <string> // For array names

class vtkPolyData;

namespace linesets
{
struct LineOptions
{
  /// Radius of all capsules, in the units of the points.
  double Radius = 1.0;
  /// Point array of radii in the units of the points, in place of Radius where not empty.
  std::string RadiusArray;
  /// Point array for the colours where not empty: one component gives scalars; three or four
  /// components of unsigned char give direct colours.
  std::string ColorArray;
};

/**
 * One curve per line cell, numbered by the cell. Points that are not finite part a curve: what
 * follows is a curve of its own, numbered after the last cell. Repeated points give spheres, which
 * their neighbours hold. Throws std::invalid_argument for an array that does not exist or does not
 * fit.
 */
CapsuleScene MakeCapsulesFromLines(vtkPolyData* lines, const LineOptions& options);
}

#endif
