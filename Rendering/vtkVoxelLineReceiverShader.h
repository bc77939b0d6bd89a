// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineReceiverShader
 * @brief   what is put into an actor's shaders so that its mapper receives the light that lines
 * leave
 *
 * Replacements of the actor's vtkShaderProperty, made after VTK has generated its source:
 * - All functions go before main(). There a macro takes the place of each lightColorN, which VTK
 *   multiplies by whatever it reflects of light N (Phong or physically based): the same colour
 * times what arrives of the light.
 * - Ambient occlusion multiplies the colour where VTK assigns it; where it is physically based, in
 *   linear space and before emission.
 * - What VTK draws without light gets the mean of all lights.
 * - vtkIlluminatedLineMapper has functions of its own that ask for shadows, here replaced.
 *
 * Parts of VTK's lines are their keys. Where a user has replaced one of them, the code is put into
 * the user's and enclosed in comments, by which it is taken out again. Properties may be shared.
 */

#ifndef vtkVoxelLineReceiverShader_h
#define vtkVoxelLineReceiverShader_h

#include "vtkVoxelLineFrame.h"
#include "vtkVoxelLineFrameBuilder.h"

#include <string>

class vtkShaderProgram;
class vtkShaderProperty;

class vtkVoxelLineReceiverShader
{
public:
  /// Code of different numbers is told apart in programs.
  explicit vtkVoxelLineReceiverShader(vtkMTimeType number);

  /// Describe what a frame's global light and view ask for; clip coordinates have the depth range
  /// -1 to 1, and the viewport is that of the framebuffer.
  void SetFrame(const vtkVoxelLineFrame& frame, const vtkVoxelLineFrameBuilder::View& view,
    const vtkVoxelLineFrameBuilder::Grid& grid, const int viewport[4]);

  /// Put the code into a shader property, unless it is there already. Returns an empty string, or
  /// else which replacement by a user leaves no place for it; then nothing is put in.
  std::string Install(vtkShaderProperty* property);

  /// Take it out unless it is of another number; what a user has put in remains.
  void Remove(vtkShaderProperty* property) const;

  /// Whether a program holds code of this number.
  bool IsUsed(vtkShaderProgram* program) const;

  /// Set the uniforms but for the buffers.
  void SetUniforms(vtkShaderProgram* program) const;

private:
  std::string GetSource() const;

  std::string Mark;
  vtkVoxelLineGlobalLight Global;
  std::vector<float> Weights;
  int DensityLevels = 0;
  float SurfaceDepth = 0.0f;
  glm::vec3 GridSize = glm::vec3(1.0f);
  glm::mat4 LocalFromView = glm::mat4(1.0f);
  glm::mat3 LocalNormalFromView = glm::mat3(1.0f);
  glm::mat4 LocalFromWindow = glm::mat4(1.0f);
  glm::vec3 LocalViewer = glm::vec3(0.0f);
  float ViewerDistant = 0.0f;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineReceiverShader.h
