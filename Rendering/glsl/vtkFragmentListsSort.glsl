// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sorts the fragments of a pixel where they lie, after vtkFragmentListsRead; see vtkFragmentLists.

// The gaps to do of those below: first, end.
uniform ivec2 fragmentListGaps;

// Shell sort; gaps of Ciura 2001, continued by a factor of 9/4. Short lists get insertion sort.
const int Gaps[15] =
  int[15](177784, 79015, 35118, 15608, 6937, 3083, 1577, 701, 301, 132, 57, 23, 10, 4, 1);

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

// Insertion sort of every gap-th fragment. Returns how many fragments it came to. No fragment is
// lost where a loop ends early.
int sortFragmentsByGap(int count, int gap)
{
  int i = gap;
  for (; i < count; ++i)
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
  return i;
}

void main()
{
  int count = findFragments(ivec2(gl_FragCoord.xy));
  bool isDone = true;
  int i = fragmentListGaps.x;
  for (; i < fragmentListGaps.y; ++i)
  {
    if (Gaps[i] < count)
    {
      isDone = isDone && sortFragmentsByGap(count, Gaps[i]) == count;
    }
  }
  if (!isDone || i < fragmentListGaps.y)
  {
    imageAtomicAdd(fragmentListFailures, ivec2(1, 0), 1u);
  }
}
