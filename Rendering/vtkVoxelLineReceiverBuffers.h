// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineReceiverBuffers
 * @brief   what receivers in one window look up: densities, occlusion, and in which brick they are
 *
 * Texture units are held from the first draw of a frame to its end.
 */

#ifndef vtkVoxelLineReceiverBuffers_h
#define vtkVoxelLineReceiverBuffers_h

#include "vtkLineSetsBufferTexture.h"
#include "vtkVoxelLineFieldBuffers.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkShaderProgram;
class vtkVoxelLineModel;
class vtkWindow;
struct vtkVoxelLineGlobalLight;

class vtkVoxelLineReceiverBuffers
{
public:
  explicit vtkVoxelLineReceiverBuffers(vtkOpenGLRenderWindow* window);
  ~vtkVoxelLineReceiverBuffers();

  /// The window; nullptr where it is gone.
  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

  /// Upload what has changed; the context is current. Returns an empty string, or else why not.
  std::string Upload(vtkVoxelLineModel* model, const vtkVoxelLineGlobalLight& light);

  /// Whether what was uploaded has gone with its context.
  bool IsGone() const { return this->Fields.IsGone() || this->BrickGrid.IsGone(); }

  void Activate(vtkShaderProgram* program);
  void Deactivate();

  vtkIdType GetNumberOfBytes() const;

private:
  vtkVoxelLineReceiverBuffers(const vtkVoxelLineReceiverBuffers&) = delete;
  void operator=(const vtkVoxelLineReceiverBuffers&) = delete;

  void Release();

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkVoxelLineFieldBuffers Fields;
  vtkLineSetsBufferTexture BrickGrid;
  vtkMTimeType ModelTime = 0;
  bool Active = false;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineReceiverBuffers.h
