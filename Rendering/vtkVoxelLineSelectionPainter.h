// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineSelectionPainter
 * @brief   draws the numbers that vtkHardwareSelector reads in place of colours
 *
 * The selector has the scene drawn once per number. One picture of curves, ray cast by the native
 * engine over the area that is asked for, serves for all of them (vtkVoxelLineSelection). What
 * vtkVoxelLinePainter keeps of its own pictures is left alone.
 */

#ifndef vtkVoxelLineSelectionPainter_h
#define vtkVoxelLineSelectionPainter_h

#include "vtkLineSetsLayer.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineNativeEngine.h"
#include "vtkVoxelLineScene.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkActor;
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

class vtkVoxelLineSelectionPainter
{
public:
  vtkVoxelLineSelectionPainter() = default;

  /**
   * Draw for the renderer's selector into a viewport of OpenGL. Returns an empty string, or else
   * why nothing was drawn.
   */
  std::string Draw(const vtkVoxelLineScene& scene, vtkRenderer* renderer, vtkActor* actor,
    vtkOpenGLRenderWindow* window, const int viewport[4], vtkVoxelLineScene::Warnings& warnings);

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const { return this->Layer.GetNumberOfBytes(); }

  /// Release what lies on the graphics device; may be called several times.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkVoxelLineSelectionPainter(const vtkVoxelLineSelectionPainter&) = delete;
  void operator=(const vtkVoxelLineSelectionPainter&) = delete;

  std::string DrawNumbers(const vtkVoxelLineScene& scene, vtkHardwareSelector* selector,
    vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4],
    const vtkVoxelLineFrameBuilder::View& view);

  vtkLineSetsLayer Layer;
  vtkVoxelLinePictureKey Last;
  vtkVoxelLinePicture Picture;
  std::vector<vtkIdType> Points;
  std::vector<std::uint8_t> Colors;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineSelectionPainter.h
