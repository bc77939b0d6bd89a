// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sorts the fragments of a pixel and gives them out; see vtkFragmentLists. It is GLSL only: images
// are no part of the language that is shared with C++.

layout(r32ui) readonly uniform uimage2D fragmentListRoom;
layout(rg32ui) readonly uniform uimage2D fragmentListRanges;
layout(rgba32ui) uniform uimageBuffer fragmentListNodes;
uniform int fragmentListWidth;
uniform ivec2 fragmentListRows;

// The first node of the pixel's fragments.
int fragmentListFirst = 0;

// Nearer first; of equal depth, by payload: then no order of drawing is told from another.
bool isFragmentBefore(uvec4 a, uvec4 b)
{
  if (a.x != b.x)
  {
    return a.x < b.x;
  }
  if (a.y != b.y)
  {
    return a.y < b.y;
  }
  return a.z != b.z ? a.z < b.z : a.w < b.w;
}

// Insertion sort of every gap-th fragment.
void sortFragmentsByGap(int count, int gap)
{
  for (int i = gap; i < count; ++i)
  {
    uvec4 node = imageLoad(fragmentListNodes, fragmentListFirst + i);
    int k = i;
    while (k >= gap)
    {
      uvec4 other = imageLoad(fragmentListNodes, fragmentListFirst + k - gap);
      if (!isFragmentBefore(node, other))
      {
        break;
      }
      imageStore(fragmentListNodes, fragmentListFirst + k, other);
      k -= gap;
    }
    if (k != i)
    {
      imageStore(fragmentListNodes, fragmentListFirst + k, node);
    }
  }
}

// Sorts the pixel's fragments from front to back, where they lie. Returns their number, 0 outside
// the rows that are looked at.
int sortFragments(ivec2 pixel)
{
  if (pixel.x < 0 || pixel.x >= fragmentListWidth || pixel.y < fragmentListRows.x ||
    pixel.y >= fragmentListRows.y)
  {
    return 0;
  }
  ivec2 range = ivec2(imageLoad(fragmentListRanges, pixel).xy);
  int room = max(int(imageLoad(fragmentListRoom, pixel).x), 0);
  fragmentListFirst = range.x + room;
  int count = range.y - room;
  // Shell sort; gaps of Ciura 2001, continued by a factor of 9/4. Short lists get insertion sort.
  const int gaps[16] = int[16](177784, 79015, 35118, 15608, 6937, 3083, 1577, 701, 301, 132, 57, 23,
    10, 4, 1, 0);
  for (int i = 0; gaps[i] > 0; ++i)
  {
    if (gaps[i] < count && (gaps[i] == 1 || count > 2 * gaps[i]))
    {
      sortFragmentsByGap(count, gaps[i]);
    }
  }
  return count;
}

// The fragment of an index, in the order of sortFragments(): bits of the depth, payload.
uvec4 getFragment(int index)
{
  return imageLoad(fragmentListNodes, fragmentListFirst + index);
}
