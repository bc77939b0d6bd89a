// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelizeLinesFilter
 * @brief   cut lines at the faces of a grid of voxels, and give the lines of a level
 *
 * Within each voxel a line becomes straight, its points on the faces of voxels are rounded, and
 * from level 1 on one line of each voxel stands for all (Kanzler, Rautenhaus and Westermann, "A
 * Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019). Level 0 has all lines.
 *
 * vtkLineVoxelizer and vtkVoxelLineGeometry in one. The output is one vtkPolyData, whose cell
 * arrays CurveId, InputId and CellId tell which curve of the model, block of the input (its flat
 * index, 0 without blocks) and cell of that block a line comes from. The array chosen with
 * SetInputArrayToProcess(0, ...) keeps its name, or is called Color where it holds colours, and
 * radii are in the array Radius. Both are stored with 8 bits over their range.
 *
 * <b>Several ranks.</b> Each rank gives the lines of its own input, in the grid of all. From level
 * 1 on a voxel has one line for each rank that has lines in it, since no rank knows the lines of
 * the others; curves and cells are counted on each rank by itself.
 *
 * @sa vtkLineVoxelizer vtkVoxelLineGeometry
 */

#ifndef vtkVoxelizeLinesFilter_h
#define vtkVoxelizeLinesFilter_h

#include "vtkLineModelFilter.h"
#include "vtkParaViewFiltersLineSetsModule.h" // For export macro

#include <string> // For the array

class VTKPARAVIEWFILTERSLINESETS_EXPORT vtkVoxelizeLinesFilter : public vtkLineModelFilter
{
public:
  static vtkVoxelizeLinesFilter* New();
  vtkTypeMacro(vtkVoxelizeLinesFilter, vtkLineModelFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the segments of a curve are joined to a polyline. Otherwise each one is a line of two
   * points of its own. Default on.
   */
  vtkSetMacro(Join, bool);
  vtkGetMacro(Join, bool);
  vtkBooleanMacro(Join, bool);
  ///@}

  ///@{
  /**
   * Point array of radii, in units of the data, that the output gets as well. Default "None".
   *
   * An empty name and nullptr mean "None" as well.
   */
  void SetRadiusArrayName(const char* name);
  const char* GetRadiusArrayName() const { return this->RadiusArrayName.c_str(); }
  ///@}

protected:
  vtkVoxelizeLinesFilter();
  ~vtkVoxelizeLinesFilter() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool Join = true;
  std::string RadiusArrayName;

private:
  vtkVoxelizeLinesFilter(const vtkVoxelizeLinesFilter&) = delete;
  void operator=(const vtkVoxelizeLinesFilter&) = delete;
};

#endif
