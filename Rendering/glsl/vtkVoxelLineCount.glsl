//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lets through the pixels in which the traversal had to forget a curve's exit, for a query that
// counts them. Nothing is written: the colours are masked.

uniform sampler2D Picture;
in vec2 texCoord;

void main()
{
  if (texture(Picture, texCoord).g < 0.5)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
}
