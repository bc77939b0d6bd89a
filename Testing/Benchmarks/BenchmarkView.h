// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From where linesets-bench looks, and where light comes from.
 */

#ifndef BenchmarkView_h
#define BenchmarkView_h

#include "vtkSmartPointer.h" // For the lights

#include <string> // For a name
#include <vector> // For the lights

class vtkCamera;
class vtkLight;

namespace linesets
{
struct BenchmarkInput;

/// Place the camera for a frame of so many pixels: the whole set is seen in frame 0, and the camera
/// turns about it by 2 degrees per frame.
void PlaceCamera(const BenchmarkInput& input, int frame);

/// Radius of the tubes at the focal point, in pixels.
double GetPixelRadius(const BenchmarkInput& input);

/// A light from the right of the camera as it is now. It is fixed in the scene: as the camera
/// turns, it sees shadows from other sides, and nothing that a method may keep of them is lost.
vtkSmartPointer<vtkLight> MakeLightFromRight(vtkCamera* camera);

/// The lights of a value of --light, for the camera as it is now: none for headlight, which VTK
/// makes by itself; the one from the right; or, for studio, that one and a headlight half as
/// bright.
std::vector<vtkSmartPointer<vtkLight>> MakeLights(const std::string& name, vtkCamera* camera);
}

#endif
