// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Counts or stores a fragment of a pixel; see vtkFragmentLists. It is GLSL only: images are no
// part of the language that is shared with C++.

// While fragments are counted: their number; then: the nodes of the pixel that are free yet.
layout(r32ui) uniform uimage2D fragmentListRoom;
// Per pixel: first node, number of nodes.
layout(rg32ui) readonly uniform uimage2D fragmentListRanges;
// A node: bits of the depth, payload.
layout(rgba32ui) writeonly uniform uimageBuffer fragmentListNodes;
// One number: fragments for which there was no node.
layout(r32ui) uniform uimage2D fragmentListDropped;
uniform int fragmentListIsCounting;
uniform int fragmentListWidth;
// The rows that are looked at: first, end.
uniform ivec2 fragmentListRows;

// depth is from 0 to 1. Fragments outside the lists' pixels are left out, since nobody asks for
// them.
void storeFragment(ivec2 pixel, float depth, uvec3 payload)
{
  if (pixel.x < 0 || pixel.x >= fragmentListWidth || pixel.y < fragmentListRows.x ||
    pixel.y >= fragmentListRows.y)
  {
    return;
  }
  if (fragmentListIsCounting != 0)
  {
    imageAtomicAdd(fragmentListRoom, pixel, 1u);
    return;
  }
  // Filled from the end, so that the room that is left is the index as well.
  int room = int(imageAtomicAdd(fragmentListRoom, pixel, 0xffffffffu));
  if (room <= 0)
  {
    imageAtomicAdd(fragmentListDropped, ivec2(0), 1u);
    return;
  }
  // The bits of floats from 0 on are ordered as the floats are; -0 would not be.
  uint bits = floatBitsToUint(clamp(depth, 0.0, 1.0)) & 0x7fffffffu;
  int first = int(imageLoad(fragmentListRanges, pixel).x);
  imageStore(fragmentListNodes, first + room - 1, uvec4(bits, payload));
}
