// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How much a matrix stretches.
 */

#ifndef vtkLineSetsStretchPrivate_h
#define vtkLineSetsStretchPrivate_h

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>

/// How much the matrix stretches lengths at most; its translation and perspective do not count.
inline double vtkLineSetsGetLargestStretch(vtkMatrix4x4* matrix)
{
  double linear[3][3];
  for (int i = 0; i < 9; ++i)
  {
    linear[i / 3][i % 3] = matrix->GetElement(i / 3, i % 3);
  }
  double u[3][3];
  double stretch[3];
  double v[3][3];
  vtkMath::SingularValueDecomposition3x3(linear, u, stretch, v);
  return std::max({ std::abs(stretch[0]), std::abs(stretch[1]), std::abs(stretch[2]) });
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsStretchPrivate.h
