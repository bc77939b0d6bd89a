// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Sorts the fragments of a pixel where they lie, after vtkFragmentListsRead; see vtkFragmentLists.
// It is heap sort, whose steps may be done in several draws: their number is known, and so is what
// each may take. Insertion sort of short lists is no gain, since neighbouring pixels, which are
// worked on together, have lists of all lengths.

// The steps to do: first, end.
uniform ivec2 fragmentListSteps;

// Nearer first; of equal depth, by payload: then no order of drawing is told from another.
bool isFragmentBefore(uvec4 a, uvec4 b)
{
  return a.x != b.x ? a.x < b.x
                    : (a.y != b.y ? a.y < b.y : (a.z != b.z ? a.z < b.z : a.w < b.w));
}

// Puts a node where it belongs in the heap (no fragment is before its children) of count fragments,
// from an index downwards, whose own fragment is lost. It takes up to log2(count) turns.
void sinkFragment(uvec4 node, int index, int count)
{
  int child = 2 * index + 1;
  while (child < count)
  {
    uvec4 other = getFragment(child);
    if (child + 1 < count)
    {
      uvec4 second = getFragment(child + 1);
      if (isFragmentBefore(other, second))
      {
        other = second;
        ++child;
      }
    }
    if (!isFragmentBefore(node, other))
    {
      break;
    }
    imageStore(fragmentListNodes, fragmentListFirst + index, other);
    index = child;
    child = 2 * index + 1;
  }
  imageStore(fragmentListNodes, fragmentListFirst + index, node);
}

// The first count / 2 steps make the heap; each further one takes the last fragment out of it.
void main()
{
  int count = findFragments(ivec2(gl_FragCoord.xy));
  int parents = count / 2;
  int end = min(fragmentListSteps.y, parents + count - 1);
  for (int step = fragmentListSteps.x; step < end; ++step)
  {
    int index = parents - 1 - step;
    int size = count;
    if (step >= parents)
    {
      size = parents + count - 1 - step;
      index = size;
    }
    uvec4 node = getFragment(index);
    if (step >= parents)
    {
      imageStore(fragmentListNodes, fragmentListFirst + index, getFragment(0));
      index = 0;
    }
    sinkFragment(node, index, size);
  }
}
