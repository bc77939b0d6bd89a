// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Main function of the ray casting shader: colour (not multiplied by opacity) to the first target;
// depth, and whether an exit had to be forgotten, to the second one.

in vec2 texCoord;

void main()
{
  beginModel();
  ivec2 pixel = ivec2(texCoord * PictureSize);
#ifdef LineSetsHasScene
  float sceneDepth = texelFetch(SceneDepth, pixel, 0).r;
#else
  float sceneDepth = 1.0;
#endif
  vec4 color;
  float depth;
  castPixel(float(pixel.x) + 0.5, float(pixel.y) + 0.5, sceneDepth, color, depth);
  gl_FragData[0] = color;
  gl_FragData[1] = vec4(depth, Forgot ? 1.0 : 0.0, 0.0, 0.0);
}
