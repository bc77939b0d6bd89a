// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineModelBuffers
 * @brief   a voxel line model in texture buffers, for the shader engine
 *
 * Each array lies in a buffer whose sampler has the array's name behind a prefix, so that a shader
 * can read several models. All calls but Forget() need the context of the window.
 */

#ifndef vtkVoxelLineModelBuffers_h
#define vtkVoxelLineModelBuffers_h

#include "vtkLineSetsBufferTexture.h"

#include "vtkType.h"
#include "vtkVoxelLineModel.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkVoxelLineModelBuffers
{
public:
  /// With or without what tells segments of different curves apart.
  explicit vtkVoxelLineModelBuffers(const std::string& prefix, bool withCurves);

  /**
   * Upload the model, if it is not there as it is now. Returns false, with the reason in
   * GetError(), where a buffer cannot be that large or there is no memory; a model that did not fit
   * is not tried again before it changes or Retry().
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model);
  void Retry();

  /// Bind the buffers that a program reads, for one draw.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /// Whether the buffers have gone with their context.
  bool IsGone() const;

  void Release(vtkWindow* window);

  /// Leave behind what has gone with its context.
  void Forget();

  const std::string& GetError() const { return this->Error; }

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

private:
  bool UploadArray(vtkOpenGLRenderWindow* window, const char* name, vtkDataArray* array,
    unsigned int format, int components = 1);
  bool UploadArrays(vtkOpenGLRenderWindow* window, vtkVoxelLineModel* model);

  std::string Prefix;
  bool WithCurves;
  std::map<std::string, vtkLineSetsBufferTexture> Buffers;
  vtkWeakPointer<vtkVoxelLineModel> Model;
  vtkMTimeType ModelTime = 0;
  // The model that found no room: it is not tried again in every frame.
  vtkWeakPointer<vtkVoxelLineModel> FailedModel;
  vtkMTimeType FailedTime = 0;
  std::string Error;
};

#endif
