// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The importance of the benchmark's geometry, per point and from 0 to 1, that opacity optimization
 * takes.
 *
 * That of a scene rises with a quantity of its own, such as the speed: 0 for the lower part of the
 * points, 1 for the uppermost ones, and a smooth step between, so that the share of important
 * points is the same whatever the size of the scene.
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
 * Add the point array "importance" (float). It passes about 1/2 at the quantile 0.9 of the
 * quantity: it is 0 below the quantile 0.82 and 1 above 0.98, with a smooth step between these
 * two values. Where both are the same, so are the important points' quantities: they get 1.
 *
 * `vertices` is the number of points of each line, where lines follow one another and `smoothings`
 * says how often a quantity is first replaced by the mean of its own, twice, and its neighbours'
 * on the line. The result does not depend on the number of threads.
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
