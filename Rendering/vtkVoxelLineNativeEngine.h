// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineNativeEngine
 * @brief   ray casts a voxel line model on the processor, over tiles with vtkSMPTools
 *
 * It compiles the same traversal as the shader engine (glsl/) as C++. The picture does not depend
 * on the number of threads.
 */

#ifndef vtkVoxelLineNativeEngine_h
#define vtkVoxelLineNativeEngine_h

#include "vtkVoxelLineFrame.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkVoxelLineModel;

/// One ray cast picture. Rows from the bottom, as OpenGL has them.
struct vtkVoxelLinePicture
{
  /// Red, green, blue, opacity; not multiplied by opacity; opacity 0 where no line is.
  std::vector<std::uint8_t> Color;
  /// Depth of the first layer, 0 to 1; 1 where no line is.
  std::vector<float> Depth;
  /// Only when picking: index of the curve in the model, or -1.
  std::vector<std::int32_t> Curve;
  /// Number of pixels in which more curves overlapped than the traversal can tell apart, so that
  /// one may have been blended twice at a joint.
  vtkIdType NumberOfOverflows = 0;
};

class vtkVoxelLineNativeEngine
{
public:
  /// Whether this processor runs the wide candidate tests, for information: "AVX-512", "AVX2",
  /// "generic".
  static const char* GetInstructionSet();

  /// Render one picture. The model must not change meanwhile.
  static void Render(
    vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame, vtkVoxelLinePicture& picture);
};

#endif
