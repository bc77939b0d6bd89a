// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsBlocks
 * @brief   joins the visible blocks of a composite data set into one vtkPolyData
 *
 * The cells keep where they came from: the arrays "vtkOriginalPointIds" and "vtkOriginalCellIds",
 * which ParaView's geometry filter makes, and a cell array "vtkCompositeIndex" with the flat index
 * of each cell's block, unless the geometry filter has made that as well (AMR).
 *
 * The arrays of the result are those that all visible blocks with points have, and those that are
 * in use and that some block has (vtkLineSetsSpread). An array of the blocks' field data that
 * colours whole blocks becomes a cell array of its first tuple.
 *
 * The result is kept as long as the data, the visible blocks and what was changed in their arrays
 * are the same.
 */

#ifndef vtkLineSetsBlocks_h
#define vtkLineSetsBlocks_h

#include "vtkLineSetsSpread.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <set>
#include <string>
#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkPolyData;

class vtkLineSetsBlocks
{
public:
  /// What is done with the arrays of the blocks.
  struct Request
  {
    /// Point or cell arrays in use; none of them twice.
    std::vector<std::string> Arrays;
    /// Array of field data to make a cell array of; empty: none.
    std::string FieldArray;
  };

  /**
   * The visible blocks of the data as one vtkPolyData, never null. Attributes may be null: then all
   * blocks are visible; a block without a visibility of its own has that of its parent.
   */
  vtkPolyData* Join(
    vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes, const Request& request);

  /// What is missing in the blocks joined last. The key is that of the array, whatever the blocks.
  struct Warning
  {
    std::string Key;
    std::string Text;
  };

  /// One for each array in use that some blocks lack.
  const std::vector<Warning>& GetWarnings() const { return this->Warnings; }

  /// The arrays of the blocks joined last that the result does not have.
  const std::set<vtkLineSetsSpread::Identity>& GetLeftOut() const { return this->LeftOut; }

private:
  using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

  vtkSmartPointer<vtkPolyData> Joined;
  Parts Sources;
  std::vector<unsigned int> Indices;
  std::vector<std::string> Changes;
  std::vector<Warning> Warnings;
  std::set<vtkLineSetsSpread::Identity> LeftOut;
  vtkTimeStamp JoinTime;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsBlocks.h
