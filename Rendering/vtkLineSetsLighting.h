// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsLighting
 * @brief   the lights of a renderer and the light model, as shaders and the native engine take them
 *
 * All mappers of the module fill it anew for each frame, and draw by glsl/vtkLineLighting.glsl
 * and glsl/vtkLineReflection.glsl with it.
 */

#ifndef vtkLineSetsLighting_h
#define vtkLineSetsLighting_h

#include "vtkLineIlluminationTable.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <glm/glm.hpp>

#include <memory>
#include <vector>

class vtkLineIllumination;
class vtkProperty;
class vtkRenderer;

struct vtkLineSetsLight
{
  /// Kind of light: 0 a directional light, 1 a positional one, 2 a spot light, 3 a headlight that
  /// is the only light (VTK's lighting complexity 1, whose highlight depends on the normal alone).
  int Kind = 0;
  /// Direction in which the light shines, unit length, view coordinates.
  glm::vec3 Direction = glm::vec3(0.0f, 0.0f, -1.0f);
  /// Position in view coordinates (kinds 1 and 2).
  glm::vec3 Position = glm::vec3(0.0f);
  /// Diffuse (and specular) colour times intensity.
  glm::vec3 Color = glm::vec3(1.0f);
  /// Constant, linear and quadratic attenuation (kinds 1 and 2).
  glm::vec3 Attenuation = glm::vec3(1.0f, 0.0f, 0.0f);
  /// Cosine of the cone angle and exponent of a spot light (kind 2).
  float CosConeAngle = 0.0f;
  float Exponent = 1.0f;
  /// Whether shadows of this light can be seen: not those of a headlight, which is at the camera.
  bool CastsShadow = false;

  bool operator==(const vtkLineSetsLight& other) const;
};

struct VTKRENDERINGLINESETS_EXPORT vtkLineSetsLighting
{
  /// All lights that are switched on.
  std::vector<vtkLineSetsLight> Lights;
  /// Whether the camera's projection is parallel.
  bool ParallelView = false;

  /// vtkLineIllumination, and the exponent in use.
  int Model = 0;
  int Reflection = 0;
  bool StretchDynamicRange = false;
  float SpecularPower = 1.0f;
  /// Null: E_m is integrated anew (vtkLineIllumination::Direct).
  std::shared_ptr<const vtkLineIlluminationTable> Table;

  /// Take the lights of a renderer that are switched on, and its camera's kind of projection.
  void SetRenderer(vtkRenderer* renderer);

  /// Take the light model, and the exponent from it or else from the property. Returns false where
  /// that is negative or not finite: then it is 1.
  bool SetModel(vtkLineIllumination* illumination, vtkProperty* property);

  bool operator==(const vtkLineSetsLighting& other) const;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsLighting.h
