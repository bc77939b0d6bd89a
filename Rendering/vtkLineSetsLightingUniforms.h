// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsLightingUniforms
 * @brief   hands lights and light model to a shader program
 */

#ifndef vtkLineSetsLightingUniforms_h
#define vtkLineSetsLightingUniforms_h

#include "vtkNew.h"

#include <memory>
#include <string>

class vtkLineIlluminationTable;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;
struct vtkLineSetsLighting;

class vtkLineSetsLightingUniforms
{
public:
  // Lights whose uniforms fit into what OpenGL 3.2 guarantees.
  static constexpr int MaximumLights = 16;

  vtkLineSetsLightingUniforms();
  ~vtkLineSetsLightingUniforms();

  /**
   * Source of the light model for shaders: the constants of this kind of lighting, uniforms and
   * functions. Real, LS_OUT and LS_INOUT are defined before. Programs need to be built again where
   * it differs. At most MaximumLights lights count.
   */
  static std::string GetSource(const vtkLineSetsLighting& lighting);

  /**
   * Set what the program in use needs, upload the table if it is another one, and activate its
   * texture. Returns false where there is no memory for it on the graphics device.
   */
  bool Activate(
    vtkOpenGLRenderWindow* window, vtkShaderProgram* program, const vtkLineSetsLighting& lighting);

  /// Deactivate the texture.
  void Deactivate();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkLineSetsLightingUniforms(const vtkLineSetsLightingUniforms&) = delete;
  void operator=(const vtkLineSetsLightingUniforms&) = delete;

  vtkNew<vtkTextureObject> Texture;
  std::shared_ptr<const vtkLineIlluminationTable> Table;
  bool Active = false;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsLightingUniforms.h
