// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsDistribution
 * @brief   gives each process the lines of the part of space that it draws
 *
 * Where something is translucent, ParaView's view parts space into boxes, one for each process (a
 * kd-tree over the points of all that is drawn), and lays the pictures of the processes over each
 * other in the order of the boxes. Its own redistribution hands on whole cells, or cuts them at
 * the sides of the boxes: a long line would be copied whole to each box that it enters, or lose its
 * neighbours, by which it is lit, at each cut. This class does it for lines instead:
 *
 * 1. A line is looked at in blocks of BlockSize segments. A process gets the blocks that come
 *    within a margin of its box, and one block more to either side, as polylines of their own. So
 *    whatever is computed from neighbours is the same as in the whole line wherever it is seen.
 *    Closed lines stay whole. Blocks begin at multiples of BlockSize within the line, and so do
 *    pieces: vtkLineMerging relies on it.
 * 2. Points of poly-vertices go to the boxes that they are in, polygons and strips whole.
 * 3. The pieces keep all arrays of points and cells, ids of original cells among them. After they
 *    are joined, those are left that all of them have: see vtkLineSetsCompletion.
 * 4. Pieces are sent from process to process in rounds of pairs, and joined in the order of ranks.
 *
 * Who draws must draw nothing outside of the process's box: what is in the margin is there twice.
 * Boxes are open where no other box follows, since tubes stick out of the bounds of their points.
 *
 * Boxes are taken in world coordinates, as ParaView sorts them; the lines' matrix counts.
 */

#ifndef vtkLineSetsDistribution_h
#define vtkLineSetsDistribution_h

#include "vtkLineMerging.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkBoundingBox;
class vtkMatrix4x4;
class vtkMultiProcessController;
class vtkPolyData;

class vtkLineSetsDistribution
{
public:
  /// Smallest x, largest x, ...; infinite where it is open.
  using Box = std::array<double, 6>;

  static constexpr int BlockSize = vtkLineMerging::BlockSize;

  /// Boxes of all processes, open where no other box is; a process without a box has an empty one.
  static std::vector<Box> OpenBoxes(const std::vector<vtkBoundingBox>& cuts);

  /// Everything.
  static Box GetOpenBox();

  /// Whether lines are not those of the last call of Distribute().
  bool IsChanged(vtkPolyData* lines) const;

  /**
   * The lines that this process needs, of those that all processes have. To be called by all of
   * them with the same boxes, matrix (world from data) and margin (in units of the data, or
   * infinite: everything goes everywhere), and the same value of isChanged: whether IsChanged() on
   * any of them. Where nothing has changed, the last result is returned.
   */
  vtkPolyData* Distribute(vtkPolyData* lines, bool isChanged, const std::vector<Box>& boxes,
    vtkMatrix4x4* matrix, double margin, vtkMultiProcessController* controller);

  /// Cells of this process's lines that were left out since they name points that do not exist.
  vtkIdType GetNumberOfInvalidCells() const { return this->NumberOfInvalidCells; }

  /// Forget the result and what it was made of: the next call distributes anew.
  void Release();

private:
  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> Lines;
  vtkMTimeType LinesTime = 0;
  std::vector<Box> Boxes;
  std::array<double, 16> Matrix{};
  double Margin = 0.0;
  vtkIdType NumberOfInvalidCells = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsDistribution.h
