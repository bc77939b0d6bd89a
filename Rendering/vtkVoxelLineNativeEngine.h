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

#include "vtkRenderingLineSetsModule.h" // For export macro
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

/// A ray origin + t direction, 0 < t < End, in grid-local coordinates; the direction has length 1.
struct vtkVoxelLineSecondaryRay
{
  glm::vec3 Origin;
  glm::vec3 Direction;
  float End;
};

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineNativeEngine
{
public:
  /// Whether this processor runs the wide candidate tests, for information: "AVX-512", "AVX2",
  /// "generic".
  static const char* GetInstructionSet();

  /**
   * Render one picture. The models must not change meanwhile. levelModel is what vtkVoxelLineLevel
   * makes of the model at the frame's ShadowLevel, where the frame has LevelRays; without it light
   * is not stopped by a level.
   */
  static void Render(vtkVoxelLineModel* model, const vtkVoxelLineFrame& frame,
    vtkVoxelLinePicture& picture, vtkVoxelLineModel* levelModel = nullptr);

  /**
   * What part of the light, 0 to 1, comes through the tubes along each ray, one after another: what
   * shading finds for its own rays. Through the level where the frame has LevelRays, else through
   * the model where it has SecondaryRays. For tests.
   */
  static std::vector<float> CastSecondaryRays(vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, const std::vector<vtkVoxelLineSecondaryRay>& rays,
    vtkVoxelLineModel* levelModel = nullptr);
};

#endif
