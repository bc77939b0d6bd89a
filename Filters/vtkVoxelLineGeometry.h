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
 *
 * Representative lines carry the curve of the longest line of their voxel, which changes from voxel
 * to voxel. A curve may then give several lines, one for each stretch of voxels that it stands for.
 *
 * @sa vtkVoxelLineModel vtkVoxelLineLevel
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
   * Level of detail: 0 is the full model, with all of its segments. From 1 on, these are the
   * representative lines of a level, one for each voxel of 2^Level times the edge length, as
   * vtkVoxelLineLevel makes them, up to ceil(log2(largest dimension)), a single voxel. The
   * representatives of the model's own voxels, level 0 of vtkVoxelLineLevel, are not among
   * these: use that filter before this one to get them. At the next update, an error tells of
   * any other level. Default 0.
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
