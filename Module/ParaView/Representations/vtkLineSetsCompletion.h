// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsCompletion
 * @brief   gives the lines of each rank the arrays in use that any rank has
 *
 * Ranks whose lines lack an array that those of others have would draw them as if none had it, and
 * pieces from different ranks could not be joined with it. So each rank tells the others which of
 * the arrays in use it has, and all make up for what they lack (vtkLineSetsSpread).
 *
 * A frame in which nothing has changed on any rank costs one reduction of one number.
 */

#ifndef vtkLineSetsCompletion_h
#define vtkLineSetsCompletion_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkLineSetsSpread;
class vtkMultiProcessController;
class vtkPolyData;

class vtkLineSetsCompletion
{
public:
  /**
   * The lines with all arrays of the names, of points and of cells, that any rank has: the lines
   * themselves where all ranks have them alike. To be called by all ranks. Ranks without points get
   * arrays without tuples, and do not count as lacking them.
   */
  vtkPolyData* Complete(vtkPolyData* lines, const std::vector<std::string>& names,
    vtkMultiProcessController* controller);

  /// What ranks lack, on the first rank only: a sentence for each array.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Forget the result and what it was made of.
  void Release();

private:
  using Spreads = std::vector<vtkLineSetsSpread>;

  Spreads FindPartial(vtkMultiProcessController* controller) const;

  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> Lines;
  vtkMTimeType LinesTime = 0;
  std::vector<std::string> Names;
  std::vector<std::string> Changes;
  std::vector<std::string> Warnings;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsCompletion.h
