// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The benchmark's scene of points: matter that gathers in a cosmic web.
 *
 * Points that fill a periodic unit cube evenly are displaced along the gradient of a random
 * potential, as far as its growth takes them: Zel'dovich, "Gravitational instability: an
 * approximate theory for large density perturbations", 1970. Sheets, filaments and clusters come
 * about where the ways of points cross, with voids between.
 */

#ifndef PointScene_h
#define PointScene_h

#include "vtkSmartPointer.h" // For the result
#include "vtkType.h"         // For vtkIdType

class vtkPolyData;

namespace linesets
{
/**
 * So many points in the unit cube, each a vertex cell, with the point arrays "speed" (the length of
 * the displacement, to which the velocity is proportional) and "importance" (which rises with the
 * density of points). Fixed seed; the result does not depend on the number of threads.
 */
vtkSmartPointer<vtkPolyData> MakePointScene(vtkIdType count);
}

#endif
