// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIlluminatedLineShader
 * @brief   what vtkIlluminatedLineMapper adds to the shaders of vtkOpenGLPolyDataMapper
 */

#ifndef vtkIlluminatedLineShader_h
#define vtkIlluminatedLineShader_h

#include "vtkShader.h"

#include <map>
#include <string>

struct vtkLineSetsLighting;

struct vtkIlluminatedLineShader
{
  /// What the light of a line is asked for: nothing. Code that tells shadows may take its place;
  /// beginLight() is then told the point, in view coordinates, before lightVisibility().
  static constexpr const char* Visibility = "void beginLight(vec3 position) {}\n"
                                            "float lightVisibility(int i) { return 1.0; }\n";

  /// Whether anything shines; else compilers leave out all that computes highlights.
  bool Shines = false;
  /// Whether each point has an exponent of its own.
  bool HasPowers = false;
  /// Whether light is computed for each point and interpolated, in place of for each pixel.
  bool IsFine = false;
  /// Whether no fragment can be wholly transparent.
  bool IsOpaque = false;
  /// Source of the light model.
  std::string Lighting;

  /// Differs where the shaders differ.
  std::string GetKey() const;

  /// Put light into the shaders, before the superclass replaces their tags for light.
  void Insert(std::map<vtkShader::Type, vtkShader*>& shaders) const;

private:
  std::string GetSource() const;
};

#endif

// VTK-HeaderTest-Exclude: vtkIlluminatedLineShader.h
