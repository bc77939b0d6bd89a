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

class vtkDataArray;
class vtkHardwareSelector;
class vtkIdTypeArray;
class vtkPolyData;
class vtkVoxelLineMapper;
class vtkVoxelLineModel;

class vtkVoxelLineSelection
{
public:
  /// Arrays of the input that hold what is told in place of the input's own numbers; null: those.
  struct Arrays
  {
    vtkIdTypeArray* PointIds = nullptr;
    vtkIdTypeArray* CellIds = nullptr;
    vtkDataArray* CompositeIds = nullptr; ///< of cells
    vtkDataArray* ProcessIds = nullptr;   ///< of points
  };

  /// The arrays that the mapper names, as far as the input has them; without input there are none.
  static Arrays GetArrays(vtkVoxelLineMapper* mapper, vtkPolyData* input);

  /// Largest id of cells that a selection can tell; -1 where there is none.
  static vtkIdType GetLargestCell(vtkVoxelLineModel* model, const Arrays& arrays);
  /// Largest id of the input's points that a selection can tell; -1 where there is none.
  static vtkIdType GetLargestPoint(vtkPolyData* input, const Arrays& arrays);

  /**
   * Index of the point of the input for every pixel that shows a curve, else 0: of the points of
   * the curve's cell, the one nearest to the place that the pixel shows.
   */
  static std::vector<vtkIdType> GetPoints(vtkVoxelLineModel* model, vtkPolyData* input,
    const vtkVoxelLineFrame& frame, const vtkVoxelLineFrameBuilder::Grid& grid,
    const vtkVoxelLinePicture& picture);

  /**
   * Colours for the selector's current pass: four bytes per pixel, opaque where a curve is. points
   * is that of GetPoints() and may be empty, then point passes give 0. The input may be null where
   * there are no arrays.
   */
  static void GetColors(vtkHardwareSelector* selector, vtkVoxelLineModel* model, vtkPolyData* input,
    const Arrays& arrays, const vtkVoxelLinePicture& picture, const std::vector<vtkIdType>& points,
    std::vector<std::uint8_t>& colors);
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineSelection.h
