// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineGeometry
 * @brief   the lines of a voxel line model as polygonal data
 *
 * To look at what a vtkVoxelLineModel holds, to measure it against the original curves, or to
 * rasterize it (Kanzler et al. 2019, Fig. 4). The input is a vtkVoxelLineModel.
 *
 * The output has double-precision points in world coordinates, and
 * - cell data CurveId (index of the curve in the model), InputId and CellId (input connection and
 *   cell of the voxelizer that the curve comes from),
 * - point data Attribute (float; the 8-bit values in their units, NaN where the input had none) or
 *   Color (unsigned char RGBA), set as active scalars, where the model has attributes,
 * - point data Radius (double, world units) where the model has radii.
 *
 * The model does not store the order of segments along a curve beyond a voxel. With Join on, the
 * segments of a curve are put in a row by their end points, which match exactly: since they
 * are a connected walk, one trail uses each of them once (Hierholzer's method). Where a curve
 * passes the same point several times, the trail may take the loops in between in another order
 * than the curve did, at the same places.
 *
 * A line that was kept as a point gives a line of two equal points.
 */

#ifndef vtkVoxelLineGeometry_h
#define vtkVoxelLineGeometry_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineGeometry : public vtkPolyDataAlgorithm
{
public:
  static vtkVoxelLineGeometry* New();
  vtkTypeMacro(vtkVoxelLineGeometry, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Level of detail. Only 0, the full model, exists; at the next update, an error is told
   * for any other. Default 0.
   */
  vtkSetMacro(Level, int);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Whether the segments of a curve are joined to a polyline. Otherwise each one is a line of two
   * points of its own, in the order of the model. Default on.
   */
  vtkSetMacro(Join, bool);
  vtkGetMacro(Join, bool);
  vtkBooleanMacro(Join, bool);
  ///@}

protected:
  vtkVoxelLineGeometry();
  ~vtkVoxelLineGeometry() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Level = 0;
  bool Join = true;

private:
  vtkVoxelLineGeometry(const vtkVoxelLineGeometry&) = delete;
  void operator=(const vtkVoxelLineGeometry&) = delete;
};

#endif
