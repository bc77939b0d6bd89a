// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much light other lines leave to a point of a line: of each light (shadows), and of all that
// comes from around (ambient occlusion), by densities (vtkVoxelLineSoftLight.glsl) or by rays
// (vtkVoxelLineOcclusionRay.glsl). Common subset of GLSL and C++ with GLM.
//
// The engine supplies Shadows and Occlusion, vtkLineGlobalIllumination's types.

// Part of light i that arrives.
Real lightVisibility(int i)
{
  if (Shadows == 0)
  {
    return Real(1);
  }
  if (Shadows == 3)
  {
    return softVisibility(i);
  }
  vec3 way;
  Real distance;
  if (!findLight(i, Shadows == 1 ? ShadedPoint : ShadedAxis, way, distance))
  {
    return Real(1);
  }
  if (Shadows == 1)
  {
    return transmittance(ShadedPoint, way, distance);
  }
  return levelTransmittance(ShadedAxis, way, distance);
}

// Part of the hemisphere above the shaded point that lines fill.
Real hemisphereOcclusion()
{
  Real sum = Real(0);
  for (int i = 0; i < OcclusionSamples; ++i)
  {
    vec3 direction = hemisphereDirection(i, ShadedNormal);
    sum += Occlusion == 3
      ? Real(1) - transmittance(ShadedPoint, direction, keptWay(ShadedPoint, direction, OcclusionRadius))
      : densityOcclusion(direction);
  }
  return sum / Real(OcclusionSamples);
}

// What is left of all light at the shaded point.
Real ambientVisibility()
{
  if (Occlusion == 0)
  {
    return Real(1);
  }
  return Occlusion == 1 ? dimmedByOcclusion(sphericalOcclusion(ShadedAxis))
                        : dimmedLight(Real(1) - hemisphereOcclusion());
}
