// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The importance of the benchmark's geometry, per point and from 0 to 1, that opacity optimization
 * takes.
 *
 * That of a scene rises with a quantity of its own, such as the speed: 0 for the lower part of the
 * points, 1 for the uppermost ones, and a smooth step between, so that the share of important
 * geometry is the same whatever the size of the scene.
 */

#ifndef SceneImportance_h
#define SceneImportance_h

#include "vtkSmartPointer.h" // For the result
#include "vtkType.h"         // For vtkIdType

#include <functional> // For quantities
#include <string>     // For names

class vtkFloatArray;
class vtkPolyData;

namespace linesets
{
/// What the importance rises with, at a point with this number and place. Called by several
/// threads at once.
using Quantity = std::function<double(vtkIdType id, const double point[3])>;

/**
 * Add the point array "importance" (float): 0 below the quantile 0.76 of the quantity and 1 above
 * 0.98, with a smooth step between these two values, so that about a tenth is above 1/2.
 *
 * Lines have so many `vertices` each and follow one another; quantiles are then of their length,
 * and `smoothings` is how often the quantity of a point is first replaced by the mean of its own,
 * twice, and its neighbours' on the line. For points and surfaces, `vertices` is 0 and quantiles
 * are of the points. The result does not depend on the number of threads.
 */
void AddImportance(
  vtkPolyData* data, const Quantity& quantity, vtkIdType vertices = 0, int smoothings = 0);

/**
 * The importance of any data: its point array `name`, or where that is empty "importance", or else
 * the active scalars. An array that leaves [0,1] is scaled so that its range becomes that; NaN and
 * infinite values get 0; both are told on standard error. Null where `name` is empty and there is
 * neither of the two. Throws std::runtime_error where there is no array `name`, or it has several
 * components or no finite value.
 */
vtkSmartPointer<vtkFloatArray> MakeImportance(vtkPolyData* data, const std::string& name);
}

#endif
