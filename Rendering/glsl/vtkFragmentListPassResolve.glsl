//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Blends the fragments of a pixel from front to back; see vtkFragmentListPass. The colour that
// comes out is multiplied by opacity.

//VTK::Output::Dec

//LineSets::FragmentLists::Dec

// The pixel of the framebuffer on which the lists' first pixel falls.
uniform ivec2 fragmentListOrigin;

float unpackFragmentColor(uint component)
{
  return uintBitsToFloat((component & 0x1fffffu) << 10);
}

void main()
{
  int count = findFragments(ivec2(gl_FragCoord.xy) - fragmentListOrigin);
  if (count == 0)
  {
    discard;
  }
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  int i = 0;
  for (; i < count && transmittance > 0.0; ++i)
  {
    uvec4 fragment = getFragment(i);
    float opacity = uintBitsToFloat(fragment.w);
    color += transmittance * opacity *
      vec3(unpackFragmentColor(fragment.y), unpackFragmentColor(fragment.z),
        unpackFragmentColor((fragment.y >> 21) | ((fragment.z >> 21) << 11)));
    transmittance *= 1.0 - opacity;
  }
  if (i < count && transmittance > 0.0)
  {
    dropFragments(count - i);
  }
  gl_FragData[0] = vec4(color, 1.0 - transmittance);
}
