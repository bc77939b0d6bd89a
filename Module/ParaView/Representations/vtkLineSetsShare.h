// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsShare
 * @brief   what the ranks that draw together agree on before each frame
 *
 * The arrays in use must be those that any rank has. Bounds, ranges and radii must be those of the
 * lines of all ranks, and a rank that has got new lines must make all of them take part in a new
 * distribution. One reduction for the arrays and one of a few numbers for the rest tell it. Each
 * rank takes part in each frame: it is done when a view asks its representations to get ready for
 * rendering, which happens on all ranks that render, just after the view's own redistribution.
 */

#ifndef vtkLineSetsShare_h
#define vtkLineSetsShare_h

#include "vtkLineSetsCompletion.h"
#include "vtkLineSetsDistribution.h"
#include "vtkLineVoxelizer.h"

#include <set>
#include <string>
#include <vector>

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

  /// The lines with the arrays of these names that any rank has (vtkLineSetsCompletion), where the
  /// lines are parted; else the lines themselves. All ranks must call it.
  vtkPolyData* Complete(vtkPolyData* lines, const std::vector<std::string>& names,
    const std::set<vtkLineSetsSpread::Identity>& leftOut);

  /**
   * The union of what the ranks measure; all must call it. Also finds out whether any rank has
   * other lines than in the last call of Distribute().
   */
  Measures Reduce(const Measures& measures, vtkPolyData* lines);

  /// See vtkLineSetsDistribution; after Reduce().
  vtkPolyData* Distribute(vtkPolyData* lines, vtkMatrix4x4* matrix, double margin);

  /// Forget the pieces that were distributed: for while each rank draws the lines that it has.
  void ReleasePieces() { this->Distribution.Release(); }

  /// Forget all that was made of lines: for while nothing is drawn, or nothing is shared.
  void Release();

  /// What is wrong with the lines, in sentences; after Distribute(), where that is called.
  std::vector<std::string> GetWarnings() const;

  /// The arrays that are left out on any rank, on the first rank only; while the lines are parted.
  const std::set<vtkLineSetsSpread::Identity>& GetLeftOut() const
  {
    return this->Completion.GetLeftOut();
  }

  /// The part of space that this rank draws.
  vtkLineSetsDistribution::Box GetRegion() const;

private:
  vtkMultiProcessController* Controller = nullptr;
  std::vector<vtkLineSetsDistribution::Box> Boxes;
  vtkLineSetsCompletion Completion;
  vtkLineSetsDistribution Distribution;
  bool IsChanged = true;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsShare.h
