//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vertex shader of the ray casting pass: a quad over the whole viewport.

in vec4 ndCoordIn;
in vec2 texCoordIn;
out vec2 texCoord;

void main()
{
  gl_Position = ndCoordIn;
  texCoord = texCoordIn;
}
