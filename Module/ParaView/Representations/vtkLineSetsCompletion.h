// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsCompletion
 * @brief   gives the lines of each rank the arrays in use that any rank has
 *
 * Ranks whose lines lack an array that those of others have would draw them as if none had it, and
 * pieces from different ranks could not be joined with it. So each rank tells the others which
 * arrays it has, and all make up for those in use that they lack (vtkLineSetsSpread).
 *
 * A frame in which nothing has changed on any rank costs one reduction of one number.
 */

#ifndef vtkLineSetsCompletion_h
#define vtkLineSetsCompletion_h

#include "vtkLineSetsSpread.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

class vtkLineSetsCompletion
{
public:
  /**
   * The lines with all arrays of the names, of points and of cells, that any rank has: the lines
   * themselves where all ranks have them alike. To be called by all ranks. Ranks without points get
   * arrays without tuples, and do not count as lacking them. Left out: arrays that the blocks of
   * this rank had, but not the lines.
   */
  vtkPolyData* Complete(vtkPolyData* lines, const std::vector<std::string>& names,
    const std::set<vtkLineSetsSpread::Identity>& leftOut, vtkMultiProcessController* controller);

  /// What ranks lack, on the first rank only: a sentence for each array.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// The arrays, not of the names, that only some of the ranks with points have, or that were left
  /// out by any, on the first rank only.
  const std::set<vtkLineSetsSpread::Identity>& GetLeftOut() const { return this->LeftOut; }

  /// Forget the result and what it was made of.
  void Release();

private:
  using Identity = vtkLineSetsSpread::Identity;
  /// Number of components and type of values, by array.
  using Arrays = std::map<Identity, std::pair<int, int>>;
  using Spreads = std::vector<vtkLineSetsSpread>;

  /// What the ranks with points have, one after the other, and what any of the ranks left out.
  std::vector<Arrays> Gather(
    std::set<Identity>& leftOut, vtkMultiProcessController* controller) const;
  /// The arrays in use that need to be changed on some rank; adds the others to what is left out.
  Spreads FindPartial(const std::vector<Arrays>& ranks, std::set<Identity>& leftOut) const;

  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> Lines;
  vtkMTimeType LinesTime = 0;
  std::vector<std::string> Names;
  std::vector<std::string> Changes;
  std::vector<std::string> Warnings;
  std::set<Identity> LeftOut;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsCompletion.h
