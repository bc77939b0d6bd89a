// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineShaderEngine
 * @brief   ray casts a voxel line model in a fragment shader (OpenGL 3.2)
 *
 * The model lies in texture buffers, the picture in two textures: colour (RGBA8, not multiplied by
 * opacity) and depth (R32F). All GL state that it changes is restored.
 */

#ifndef vtkVoxelLineShaderEngine_h
#define vtkVoxelLineShaderEngine_h

#include "vtkVoxelLineFrame.h"

#include "vtkType.h"

#include <memory>
#include <string>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkVoxelLineModel;
class vtkWindow;

class vtkVoxelLineShaderEngine
{
public:
  vtkVoxelLineShaderEngine();
  ~vtkVoxelLineShaderEngine();

  /**
   * Render one picture into the engine's own textures. The model is uploaded when it or the window
   * changed. sceneDepth is a depth texture of the frame's size or nullptr; frame.SceneDepth is not
   * used. Returns false, with the reason in GetError(), where the context cannot do it or
   * memory does not suffice; a model that did not fit is not uploaded again before it or the window
   * changes. levelModel is what vtkVoxelLineLevel makes of the model at the frame's ShadowLevel,
   * where the frame has LevelRays; without it light is not stopped by a level.
   */
  bool Render(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model,
    const vtkVoxelLineFrame& frame, vtkTextureObject* sceneDepth,
    vtkVoxelLineModel* levelModel = nullptr);

  ///@{
  /// The picture; owned by the engine, nullptr before the first Render().
  vtkTextureObject* GetColorTexture() const;
  vtkTextureObject* GetDepthTexture() const;
  ///@}

  /// What is missing, after Render() returned false.
  const std::string& GetError() const;

  /// Number of pixels of the last picture in which more curves overlapped than the shader can tell
  /// apart, so that one may have been blended twice at a joint; as vtkVoxelLinePicture tells. 0
  /// where they could not be counted, since an occlusion query of somebody else was under way.
  vtkIdType GetNumberOfOverflows() const;

  /// Bytes on the graphics device: model, tables and picture.
  vtkIdType GetNumberOfBytes() const;

  /**
   * Release everything, in the context of the window in which it was made, whichever is given; may
   * be called several times and before a change of window. What went with its window is forgotten.
   * A model for which there was no memory is tried again after it.
   */
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};

#endif
