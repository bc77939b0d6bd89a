// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much of a tube is seen and how it is lit, by its width on the screen. Tubes wider than a pixel
// show the light at each point of their surface. Thinner ones are drawn one pixel wide, as
// transparent as they cover less than that, and lit by the average over their width; so the light
// that reaches the picture is the same. Common subset of GLSL and C++ with GLM.

// Part of the width with which a tube is drawn that it covers.
Real tubeCoverage(Real radius, Real drawnRadius)
{
  return ThinTubes ? min(radius / max(drawnRadius, Real(1e-20)), Real(1)) : Real(1);
}

// What part of the light is that of the tube's surface, the rest being that of a line: both have the
// same mean over the tube's width, so that any change over is right; it lies between one and two
// pixels.
Real surfacePart(Real radius, Real t)
{
  if (LitAsLines)
  {
    return Real(0);
  }
  return NarrowTubes ? smoothstep(Real(1), Real(2), radius / max(halfPixelAt(t), Real(1e-20))) : Real(1);
}

// Colour of a tube at a point in view coordinates; its normal and the way along it are local.
vec3 lightTube(vec3 position, vec3 normal, vec3 along, Real surface, vec3 ambient, vec3 diffuse)
{
  vec3 color = vec3(Real(0));
  if (surface > Real(0))
  {
    color = lightSurface(position, normalize(NormalFromLocal * normal), ambient, diffuse, SpecularColor,
      SpecularPower) * surface;
  }
  if (surface < Real(1))
  {
    vec3 tangent = vec3(ViewFromLocal * vec4(along, Real(0)));
    Real size = length(tangent);
    // A segment without length has no direction: the null vector stands for that.
    tangent = size > Real(0) ? tangent / size : vec3(Real(0));
    color += lightLine(position, tangent, ambient, diffuse, SpecularColor, SpecularPower) *
      (Real(1) - surface);
  }
  return color;
}
