// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth of a fragment as the series take it, from 0 to 1. GLSL only. Before it stands
// FourierLogarithmic, a constant.

// Elements 22, 23, 32 and 33 of the projection.
uniform vec4 fourierProjection;
// Nearest distance from the camera, and the inverse of the range of distances or of its logarithm.
uniform vec2 fourierRange;
// Size of the full picture.
uniform ivec2 fourierSize;

// Depth in the scene's range from that of the depth buffer.
float fourierSceneDepth(float z)
{
  float n = 2.0 * z - 1.0;
  float way = (n * fourierProjection.w - fourierProjection.y) /
    (n * fourierProjection.z - fourierProjection.x);
  return clamp(FourierLogarithmic ? log(max(way / fourierRange.x, 1.0)) * fourierRange.y
                                  : (way - fourierRange.x) * fourierRange.y, 0.0, 1.0);
}

// Depth of the depth buffer from that in the scene's range.
float fourierBufferDepth(float d)
{
  float way = FourierLogarithmic ? fourierRange.x * exp(d / fourierRange.y)
                                 : fourierRange.x + d / fourierRange.y;
  float n = (fourierProjection.y - way * fourierProjection.x) /
    (fourierProjection.w - way * fourierProjection.z);
  return clamp(0.5 * n + 0.5, 0.0, 1.0);
}

// Pixel of the full picture that stands for one of a reduced picture.
ivec2 fourierFullPixel(ivec2 pixel, int reduction)
{
  return min(pixel * reduction + reduction / 2, fourierSize - 1);
}

// Farthest depth of the scene, of the depth buffer, in a pixel of a reduced picture.
float fourierFarthest(sampler2D scene, ivec2 pixel, int reduction)
{
  float farthest = 0.0;
  for (int i = 0; i < reduction * reduction; ++i)
  {
    ivec2 full = pixel * reduction + ivec2(i % reduction, i / reduction);
    farthest = max(farthest, texelFetch(scene, min(full, fourierSize - 1), 0).r);
  }
  return farthest;
}
