// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineSelection
 * @brief   what vtkHardwareSelector gets to see of a picture of curves
 *
 * The selector has the scene drawn several times, each time with other numbers as colours: of the
 * prop, of the composite index, of the cell's or point's lower and higher 24 bits. This class turns
 * the curve that each pixel shows into those.
 */

#ifndef vtkVoxelLineSelection_h
#define vtkVoxelLineSelection_h

#include "vtkType.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineNativeEngine.h"

#include <cstdint>
#include <vector>

class vtkHardwareSelector;
class vtkPolyData;
class vtkVoxelLineModel;

class vtkVoxelLineSelection
{
public:
  /// Largest cell id that the curves of a model come from; -1 where there is none.
  static vtkIdType GetLargestCell(vtkVoxelLineModel* model);

  /**
   * Index of the point of the input for every pixel that shows a curve, else 0: of the points of
   * the curve's cell, the one nearest to the place that the pixel shows.
   */
  static std::vector<vtkIdType> GetPoints(vtkVoxelLineModel* model, vtkPolyData* input,
    const vtkVoxelLineFrame& frame, const vtkVoxelLineFrameBuilder::Grid& grid,
    const vtkVoxelLinePicture& picture);

  /**
   * Colours for the selector's current pass: four bytes per pixel, opaque where a curve is. points
   * is that of GetPoints() and may be empty, then point passes give 0.
   */
  static void GetColors(vtkHardwareSelector* selector, vtkVoxelLineModel* model,
    const vtkVoxelLinePicture& picture, const std::vector<vtkIdType>& points,
    std::vector<std::uint8_t>& colors);
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineSelection.h
