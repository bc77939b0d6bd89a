// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights a point as VTK's surfaces are lit: ambient, diffuse and specular reflection about the
// normal, for directional, positional and spot lights. Common subset of GLSL and C++ with GLM.
//
// The engine supplies: LightCount; LightKind[], LightDirection[], LightPosition[], LightColor[],
// LightAttenuation[], LightSpot[] (cosine of the cone angle, exponent); SpecularColor,
// SpecularPower; all of them as vtkVoxelLineFrame tells.

// base is raised to a power as GLSL and C++ both define it: 0^0 is 1.
Real reflectedPower(Real base, Real exponent)
{
  return exponent <= Real(0) ? Real(1) : (base <= Real(0) ? Real(0) : pow(base, exponent));
}

// Colour of a point at position with unit normal and unit direction to the viewer, all in view
// coordinates; ambient and diffuse hold colour times coefficient.
vec3 lightSurface(vec3 position, vec3 normal, vec3 viewer, vec3 ambient, vec3 diffuse)
{
  vec3 diffuseSum = vec3(Real(0));
  vec3 specularSum = vec3(Real(0));
  bool shines = SpecularColor.x + SpecularColor.y + SpecularColor.z > Real(0);
  for (int i = 0; i < LightCount; ++i)
  {
    vec3 direction = LightDirection[i];
    Real attenuation = Real(1);
    if (LightKind[i] == 1 || LightKind[i] == 2)
    {
      vec3 way = position - LightPosition[i];
      Real size = length(way);
      direction = size > Real(0) ? way / size : direction;
      attenuation = Real(1) /
        (LightAttenuation[i].x + LightAttenuation[i].y * size + LightAttenuation[i].z * size * size);
      if (LightKind[i] == 2)
      {
        Real cone = dot(direction, LightDirection[i]);
        attenuation =
          cone >= LightSpot[i].x ? attenuation * reflectedPower(cone, LightSpot[i].y) : Real(0);
      }
    }
    Real facing = -attenuation * dot(normal, direction);
    if (facing > Real(0))
    {
      diffuseSum += LightColor[i] * facing;
      if (!shines)
      {
        continue;
      }
      // A lone headlight (kind 3) shines along the view axis; VTK takes its highlight from the normal.
      Real mirrored = LightKind[i] == 3
        ? facing
        : dot(direction - normal * (Real(2) * dot(normal, direction)), viewer);
      specularSum += LightColor[i] * (attenuation * reflectedPower(max(mirrored, Real(0)), SpecularPower));
    }
  }
  return ambient + diffuse * diffuseSum + SpecularColor * specularSum;
}
