// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The leaves of a data set that may be a tree of blocks.
 */

#ifndef vtkLineSetsLeavesPrivate_h
#define vtkLineSetsLeavesPrivate_h

#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"

namespace vtkLineSetsLeaves
{
/**
 * Calls leaf(vtkDataObject*, unsigned int flatIndex, state) for each leaf below a node, in the
 * order of their flat indices, which count empty nodes as well; index is that of the node, and
 * behind it the next one. A state is handed down: that of a node's children is
 * enter(vtkDataObject*, outer), where outer is the state of the node's parent.
 */
template <typename State, typename Enter, typename Leaf>
void VisitBelow(
  vtkDataObject* node, unsigned int& index, const State& outer, Enter&& enter, Leaf&& leaf)
{
  const unsigned int nodeIndex = index++;
  if (!node)
  {
    return;
  }
  const State state = enter(node, outer);
  if (auto* tree = vtkDataObjectTree::SafeDownCast(node))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      VisitBelow(child, index, state, enter, leaf);
    }
    return;
  }
  leaf(node, nodeIndex, state);
}

/// Calls leaf(vtkDataObject*, unsigned int flatIndex) for each leaf of the data, which may be one
/// itself, or null.
template <typename Leaf>
void Visit(vtkDataObject* data, Leaf&& leaf)
{
  unsigned int index = 0;
  VisitBelow(
    data, index, true, [](vtkDataObject*, bool) { return true; },
    [&leaf](vtkDataObject* node, unsigned int flatIndex, bool) { leaf(node, flatIndex); });
}
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsLeavesPrivate.h
