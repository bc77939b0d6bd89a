// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// What vtkFragmentListPass adds to the declarations of every fragment shader, after that of
// storeFragment().

// Depth of what is opaque; fragments behind it are not stored.
uniform sampler2D fragmentListOpaqueDepth;
// Half the distance of two depths that the framebuffer can tell apart.
uniform float fragmentListHalfDepthStep;

// A component of a colour as a float without sign, of 8 bits of exponent and 13 of mantissa.
uint packFragmentColor(float component)
{
  return ((floatBitsToUint(max(component, 0.0)) & 0x7fffffffu) + 0x200u) >> 10;
}

// color is not multiplied by its opacity.
void storeFragmentColor(ivec2 pixel, float depth, vec4 color)
{
  if (depth - texelFetch(fragmentListOpaqueDepth, pixel, 0).r > fragmentListHalfDepthStep)
  {
    return;
  }
  uint red = packFragmentColor(color.r);
  uint green = packFragmentColor(color.g);
  uint blue = packFragmentColor(color.b);
  storeFragment(pixel, depth, uvec3(red | (blue << 21), green | ((blue >> 11) << 21),
    floatBitsToUint(clamp(color.a, 0.0, 1.0))));
}
