// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   the pure shader functions compiled as C++, in single or double precision
 */

#ifndef ShaderFunctions_h
#define ShaderFunctions_h

#include "vtkLineIlluminationTable.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace ShaderTesting
{
using namespace glm;

#define LS_OUT(T) T&
#define LS_INOUT(T) T&

template <typename R>
struct Functions
{
  using Real = R;
  using uint = std::uint32_t;
  using vec2 = glm::vec<2, R>;
  using vec3 = glm::vec<3, R>;
  using vec4 = glm::vec<4, R>;

  int LightCount = 0;
  std::vector<int> LightKind;
  std::vector<vec3> LightDirection;
  std::vector<vec3> LightPosition;
  std::vector<vec3> LightColor;
  std::vector<vec3> LightAttenuation;
  std::vector<vec2> LightSpot;
  bool ParallelView = false;
  bool MaximumReflection = false;
  bool HalfwayReflection = false;
  bool StretchRange = false;
  bool TabulatedMeans = false;
  std::shared_ptr<const vtkLineIlluminationTable> Table;

  Real fetchPowerMean(Real x, Real row) const { return this->Table->Interpolate(x, row); }

#include "glsl/vtkVoxelLinePacking.glsl"

#include "glsl/vtkVoxelLineCapsule.glsl"

#include "glsl/vtkLineReflection.glsl"

  // No shadows.
  static Real lightVisibility(int)
  {
    return Real(1);
  }

#include "glsl/vtkLineLighting.glsl"
};

#undef LS_OUT
#undef LS_INOUT
}

#endif
