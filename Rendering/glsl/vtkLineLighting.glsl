// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums the light of all lights at a point of a surface, as VTK's surfaces are lit, or of a line.
// Common subset of GLSL and C++ with GLM.
//
// The engine supplies: LightCount; LightKind[], LightDirection[], LightPosition[], LightColor[],
// LightAttenuation[], LightSpot[] (cosine of the cone angle, exponent), as vtkLineSetsLighting
// tells; ParallelView, bool; Real lightVisibility(int i), what part of light i reaches the point, 1
// where there are no shadows; and what vtkLineReflection.glsl asks for.

// Unit direction from a point to the viewer, in view coordinates.
vec3 viewerDirection(vec3 position)
{
  return ParallelView ? vec3(Real(0), Real(0), Real(1)) : normalize(-position);
}

// Unit direction from light i to the point, and how much of the light arrives there.
Real lightArrival(int i, vec3 position, LS_OUT(vec3) direction)
{
  direction = LightDirection[i];
  if (LightKind[i] != 1 && LightKind[i] != 2)
  {
    return Real(1);
  }
  vec3 way = position - LightPosition[i];
  Real size = length(way);
  direction = size > Real(0) ? way / size : direction;
  Real arrival = Real(1) /
    (LightAttenuation[i].x + LightAttenuation[i].y * size + LightAttenuation[i].z * size * size);
  if (LightKind[i] == 2)
  {
    Real cone = dot(direction, LightDirection[i]);
    arrival = cone >= LightSpot[i].x ? arrival * reflectedPower(cone, LightSpot[i].y) : Real(0);
  }
  return arrival;
}

// Colour of a point of a surface with unit normal, in view coordinates; ambient, diffuse and
// specular hold colour times coefficient.
vec3 lightSurface(vec3 position, vec3 normal, vec3 ambient, vec3 diffuse, vec3 specular, Real power)
{
  vec3 viewer = viewerDirection(position);
  vec3 diffuseSum = vec3(Real(0));
  vec3 specularSum = vec3(Real(0));
  bool shines = specular.x + specular.y + specular.z > Real(0);
  for (int i = 0; i < LightCount; ++i)
  {
    vec3 direction;
    Real arrival = lightArrival(i, position, direction);
    Real facing = -dot(normal, direction);
    if (facing > Real(0) && arrival > Real(0))
    {
      arrival *= lightVisibility(i);
      diffuseSum += LightColor[i] * (arrival * facing);
      if (!shines)
      {
        continue;
      }
      // A lone headlight (kind 3) shines along the view axis; VTK takes its highlight from the normal.
      Real mirrored = facing;
      if (HalfwayReflection)
      {
        vec3 halfway = viewer - direction;
        mirrored = dot(halfway, normal) / max(length(halfway), Real(1e-6));
      }
      else if (LightKind[i] != 3)
      {
        mirrored = dot(direction + normal * (Real(2) * facing), viewer);
      }
      specularSum += LightColor[i] * (arrival * reflectedPower(max(mirrored, Real(0)), power));
    }
  }
  return ambient + diffuse * diffuseSum + specular * specularSum;
}

// Light that a point of a line with unit tangent (or a null vector) reflects, in view coordinates, by
// its diffuse and, where it shines, its specular colour, both white.
void lineLight(vec3 position, vec3 tangent, bool shines, Real power, LS_OUT(vec3) diffuse,
  LS_OUT(vec3) specular)
{
  vec3 viewer = viewerDirection(position);
  diffuse = vec3(Real(0));
  specular = vec3(Real(0));
  for (int i = 0; i < LightCount; ++i)
  {
    vec3 direction;
    Real arrival = lightArrival(i, position, direction);
    arrival *= arrival > Real(0) ? lightVisibility(i) : Real(0);
    vec2 response = lineResponse(tangent, viewer, -direction,
      LightKind[i] == 3 && !HalfwayReflection, shines, power);
    diffuse += LightColor[i] * (arrival * response.x);
    specular += LightColor[i] * (arrival * response.y);
  }
}

// Colour of a point of a line, as lightSurface() else.
vec3 lightLine(vec3 position, vec3 tangent, vec3 ambient, vec3 diffuse, vec3 specular, Real power)
{
  vec3 diffuseLight;
  vec3 specularLight;
  bool shines = specular.x + specular.y + specular.z > Real(0);
  lineLight(position, tangent, shines, power, diffuseLight, specularLight);
  return ambient + diffuse * diffuseLight + specular * specularLight;
}
