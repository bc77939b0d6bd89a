// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsBlocks
 * @brief   joins the visible blocks of a composite data set into one vtkPolyData
 *
 * The cells keep where they came from: the arrays "vtkOriginalPointIds" and "vtkOriginalCellIds",
 * which ParaView's geometry filter makes, and a cell array "vtkCompositeIndex" with the flat index
 * of each cell's block. The arrays of the result are those that all visible blocks with points
 * have. The result is kept as long as the data and the visible blocks are the same.
 */

#ifndef vtkLineSetsBlocks_h
#define vtkLineSetsBlocks_h

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <vector>

class vtkCompositeDataDisplayAttributes;
class vtkDataObject;
class vtkPolyData;

class vtkLineSetsBlocks
{
public:
  /**
   * The visible blocks of the data as one vtkPolyData, never null. Attributes may be null: then all
   * blocks are visible.
   */
  vtkPolyData* Join(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes);

private:
  vtkSmartPointer<vtkPolyData> Joined;
  std::vector<vtkSmartPointer<vtkPolyData>> Parts;
  std::vector<unsigned int> Indices;
  vtkTimeStamp JoinTime;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsBlocks.h
