// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Gives out the fragments of a pixel; see vtkFragmentLists. It is GLSL only: images are no part of
// the language that is shared with C++.

layout(r32ui) readonly uniform uimage2D fragmentListRoom;
layout(rg32ui) readonly uniform uimage2D fragmentListRanges;
layout(rgba32ui) uniform uimageBuffer fragmentListNodes;
// One number: fragments that were dropped.
layout(r32ui) uniform uimage2D fragmentListDropped;
uniform int fragmentListWidth;
// The rows that are looked at: first, end.
uniform ivec2 fragmentListRows;

// The first node of the pixel's fragments.
int fragmentListFirst = 0;

// Turns to a pixel. Returns the number of its fragments, 0 outside the rows that are looked at.
int findFragments(ivec2 pixel)
{
  if (pixel.x < 0 || pixel.x >= fragmentListWidth || pixel.y < fragmentListRows.x ||
    pixel.y >= fragmentListRows.y)
  {
    return 0;
  }
  ivec2 range = ivec2(imageLoad(fragmentListRanges, pixel).xy);
  int room = max(int(imageLoad(fragmentListRoom, pixel).x), 0);
  fragmentListFirst = range.x + room;
  return range.y - room;
}

// The fragment of an index, from front to back: bits of the depth, payload.
uvec4 getFragment(int index)
{
  return imageLoad(fragmentListNodes, fragmentListFirst + index);
}

// Counts fragments that a loop has not come to: software OpenGL ends loops after so many turns.
void dropFragments(int count)
{
  imageAtomicAdd(fragmentListDropped, ivec2(0), uint(count));
}
