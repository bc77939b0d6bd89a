// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the light model asks of an engine, for shaders. Constants come before, from
// vtkLineSetsLightingUniforms.

uniform vec3 LightDirection[MaximumLights];
uniform vec3 LightPosition[MaximumLights];
uniform vec3 LightColor[MaximumLights];
uniform vec3 LightAttenuation[MaximumLights];
uniform vec2 LightSpot[MaximumLights];
#ifdef LineSetsHasPowerMeans
uniform sampler2D PowerMeans;
#endif

// x and row go from the middle of the first texel to the middle of the last one.
float fetchPowerMean(float x, float row)
{
#ifdef LineSetsHasPowerMeans
  vec2 size = vec2(textureSize(PowerMeans, 0));
  return texture(PowerMeans, (vec2(x, row) * (size - 1.0) + 0.5) / size).r;
#else
  return 0.0;
#endif
}
