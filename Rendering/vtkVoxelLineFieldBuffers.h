// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineFieldBuffers
 * @brief   densities and occlusion of a voxel line model in texture buffers, for shaders
 *
 * They are uploaded when they changed. All calls but Forget() need the context of the window.
 */

#ifndef vtkVoxelLineFieldBuffers_h
#define vtkVoxelLineFieldBuffers_h

#include "vtkLineSetsBufferTexture.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
struct vtkVoxelLineGlobalLight;

class vtkVoxelLineFieldBuffers
{
public:
  /// Functions of a fragment shader that read what the light reads, and their samplers.
  static std::string GetSource(const vtkVoxelLineGlobalLight& light);

  /// Upload what the light reads and has changed. Returns false, with the reason in GetError(),
  /// where a buffer cannot be that large or there is no memory.
  bool Upload(vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light);

  /// Bind the buffers that a program reads and set where levels start in them, for one draw.
  void Activate(vtkShaderProgram* program);
  void Deactivate();

  /// Whether a buffer has gone with its context.
  bool IsGone() const { return this->Densities.IsGone() || this->Occlusion.IsGone(); }

  void Release(vtkWindow* window);

  /// Leave behind what has gone with its context.
  void Forget();

  const std::string& GetError() const { return this->Error; }

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

private:
  bool UploadDensities(vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light);
  bool UploadOcclusion(vtkOpenGLRenderWindow* window, const vtkVoxelLineGlobalLight& light);
  bool Fits(vtkOpenGLRenderWindow* window, std::size_t values);

  vtkLineSetsBufferTexture Densities;
  vtkLineSetsBufferTexture Occlusion;
  std::vector<int> Starts;
  // Modification times are never the same for two objects.
  vtkMTimeType DensitiesTime = 0;
  vtkMTimeType OcclusionTime = 0;
  std::string Error;
};

#endif
