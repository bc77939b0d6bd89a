// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The benchmark's scene of surfaces: stream surfaces that lie about the core of a tornado, one
 * within the other.
 */

#ifndef SurfaceScene_h
#define SurfaceScene_h

#include "vtkSmartPointer.h" // For the result

class vtkPolyData;

namespace linesets
{
/// Number of nested surfaces.
constexpr int NumberOfSurfaces = 20;

/**
 * Stream surfaces of TornadoField. Each goes through a curve that follows the core at a distance of
 * its own, and winds about the core by 5 radians, so that a gap is left; the gaps of surfaces that
 * follow on each other are turned. A surface has `lines` stream lines of `vertices` vertices each,
 * joined by triangles: (lines - 1)(vertices - 1) 2 of them. Point arrays: normals, "speed" (of the
 * wind) and "importance" (which rises towards the core). Both numbers are at least 2. The result
 * does not depend on the number of threads.
 */
vtkSmartPointer<vtkPolyData> MakeSurfaceScene(int lines, int vertices);
}

#endif
