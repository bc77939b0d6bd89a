// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @namespace vtkVoxelLineShaderUniforms
 * @brief     hands the numbers of a frame to the ray casting shader
 */

#ifndef vtkVoxelLineShaderUniforms_h
#define vtkVoxelLineShaderUniforms_h

#include <string>

class vtkShaderProgram;
class vtkVoxelLineModel;
struct vtkVoxelLineFrame;

namespace vtkVoxelLineShaderUniforms
{
// As many clipping planes as OpenGL guarantees.
constexpr int MaximumPlanes = 8;
// The sides of a box.
constexpr int MaximumRegionPlanes = 6;

/// The constants that make one kind of shader out of the common source. hasLevel: the model of a
/// level is there as well.
std::string MakeConstants(
  vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, bool hasScene, bool hasLevel);

/// Set what this kind of shader uses of the frame and of the model's grid; program is in use, and
/// the frame has no more clipping planes and lights than it takes. Textures are not set. level is
/// the model of a level or nullptr.
void Set(vtkShaderProgram* program, vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame,
  vtkVoxelLineModel* level);
}

#endif
