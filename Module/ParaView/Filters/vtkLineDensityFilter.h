// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineDensityFilter
 * @brief   sum the length of the lines in each voxel of a grid, as an image
 *
 * The density of a voxel is the sum over the lines in it of length times opacity, with lengths in
 * voxels of level 0: a straight line through the middle of a voxel along an axis counts 1. Coarser
 * levels have means over 2x2x2 voxels (Kanzler, Rautenhaus and Westermann, "A Voxel-based
 * Rendering Pipeline for Large 3D Line Sets", 2019, Eq. 1).
 *
 * vtkLineVoxelizer and vtkVoxelLineDensity in one. The output is an image with one point in the
 * centre of each voxel of the level, with the float array Density as active scalars. At level 0 its
 * sum is the length of all lines, times their opacity, by the edge of a voxel.
 *
 * With an array of opacities, chosen with SetInputArrayToProcess(0, ...), the value at each place
 * of a line multiplies its length, of several components the length of the vector; it is kept with
 * 8 bits over the range of the array, and where it is NaN nothing is counted. Other values than 0
 * to 1 count as they are, so that any quantity can be summed along the lines.
 *
 * <b>Several ranks.</b> Each rank sums its own lines over the whole grid, the sums of all ranks are
 * added up, and each rank keeps the piece of the image that it is asked for, as readers of images
 * do: neighbouring pieces share the points in between. Each rank needs memory for the whole image
 * meanwhile.
 *
 * <b>Size.</b> The number of values grows with the cube of Resolution: for a cube of lines, 1024
 * needs 5 GiB at level 0 and 0.6 GiB at any other one. Where that is more than the memory of the
 * machine (of the smallest one of all ranks; several ranks on a machine count as one), an error
 * tells it before anything is allocated, and the output is empty.
 *
 * The size of the image is known only when the lines are. Therefore the input is updated as soon as
 * the output's information is asked for, and where the lines change over time, the whole extent is
 * that of the last update.
 *
 * @sa vtkLineVoxelizer vtkVoxelLineDensity
 */

#ifndef vtkLineDensityFilter_h
#define vtkLineDensityFilter_h

#include "vtkLineModelFilter.h"
#include "vtkParaViewFiltersLineSetsModule.h" // For export macro

#include <string> // For std::string

class vtkImageData;

class VTKPARAVIEWFILTERSLINESETS_EXPORT vtkLineDensityFilter : public vtkLineModelFilter
{
public:
  static vtkLineDensityFilter* New();
  vtkTypeMacro(vtkLineDensityFilter, vtkLineModelFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Opacity of every line, which its length is multiplied by, 0 to 1. Default 1.
   *
   * Nothing breaks beyond, but an error tells of one that is not finite.
   */
  vtkSetMacro(Opacity, double);
  vtkGetMacro(Opacity, double);
  ///@}

protected:
  vtkLineDensityFilter();
  ~vtkLineDensityFilter() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Opacity = 1.0;

private:
  /// What is wrong with the size of the image, the same on all ranks; empty where nothing is.
  std::string FindSizeError(const double bounds[6]);
  /// An image without values that has the place of the level of a grid; empty without such a level.
  vtkSmartPointer<vtkImageData> PlaceImage(const double bounds[6]);
  /// The densities of the blocks of this rank. Returns false where something went wrong.
  bool SumLines(const std::vector<Block>& blocks, const double bounds[6], vtkImageData* image);

  vtkLineDensityFilter(const vtkLineDensityFilter&) = delete;
  void operator=(const vtkLineDensityFilter&) = delete;
};

#endif
