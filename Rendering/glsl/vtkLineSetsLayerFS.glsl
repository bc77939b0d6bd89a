//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Draws one layer, a picture of colour and depth, as if it were a surface; see vtkLineSetsLayer.
// The tags are those at which VTK's render passes insert their code.

//VTK::Output::Dec

//VTK::DepthPeeling::Dec

//VTK::Picking::Dec

// Colour, not multiplied by opacity, and depth from 0 to 1, pixel by pixel.
uniform sampler2D layerColor;
uniform sampler2D layerDepth;
// The pixel of the framebuffer on which the first texel falls.
uniform ivec2 layerOrigin;
uniform ivec2 layerSize;
// Added to the depth; for selection on top of an earlier picture of the same lines.
uniform float layerDepthOffset;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy) - layerOrigin;
  if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, layerSize)))
  {
    discard;
  }
  vec4 color = texelFetch(layerColor, texel, 0);
  if (color.a <= 0.0)
  {
    discard;
  }
  gl_FragDepth = clamp(texelFetch(layerDepth, texel, 0).r + layerDepthOffset, 0.0, 1.0);

  //VTK::DepthPeeling::PreColor

  gl_FragData[0] = color;

  //VTK::DepthPeeling::Impl

  //VTK::Picking::Impl
}
