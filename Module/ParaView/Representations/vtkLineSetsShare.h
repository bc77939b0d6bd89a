// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsShare
 * @brief   what the ranks that draw together agree on before each frame
 *
 * Bounds, ranges and radii must be those of the lines of all ranks, and a rank that has got new
 * lines must make all of them take part in a new distribution. One reduction of a few numbers tells
 * both. Each rank takes part in each frame: it is done when a view asks its representations to get
 * ready for rendering, which happens on all ranks that render, just after the view's own
 * redistribution.
 */

#ifndef vtkLineSetsShare_h
#define vtkLineSetsShare_h

#include "vtkLineSetsDistribution.h"
#include "vtkLineVoxelizer.h"

class vtkDataObject;
class vtkMatrix4x4;
class vtkMultiProcessController;
class vtkPVRenderView;
class vtkPolyData;

class vtkLineSetsShare
{
public:
  using Measures = vtkLineVoxelizer::Measures;

  /// Learn how a view draws now: the whole, or a level of detail.
  void SetView(vtkPVRenderView* view, bool isDetail);

  /**
   * Whether the data of all ranks together are more than a point; all must call it.
   */
  static bool HasExtent(vtkDataObject* data);

  /// Whether the lines are parted among several ranks that draw them.
  bool IsParted() const { return this->Controller != nullptr; }

  /// Whether each rank draws one part of space.
  bool IsOrdered() const { return !this->Boxes.empty(); }

  /**
   * The union of what the ranks measure; all must call it. Also finds out whether any rank has
   * other lines than in the last call of Distribute().
   */
  Measures Reduce(const Measures& measures, vtkPolyData* lines);

  /// See vtkLineSetsDistribution; after Reduce().
  vtkPolyData* Distribute(vtkPolyData* lines, vtkMatrix4x4* matrix, double margin);

  /// The part of space that this rank draws.
  vtkLineSetsDistribution::Box GetRegion() const;

private:
  vtkMultiProcessController* Controller = nullptr;
  std::vector<vtkLineSetsDistribution::Box> Boxes;
  vtkLineSetsDistribution Distribution;
  bool IsChanged = true;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsShare.h
