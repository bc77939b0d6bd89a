// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineDensity
 * @brief   how much line each voxel of a voxel line model holds
 *
 * The density of a voxel is the sum over its segments of length times opacity (Kanzler et al. 2019,
 * Eq. 1), with lengths in voxels: a straight line through the middle of a voxel along an
 * axis counts 1. The input is a vtkVoxelLineModel.
 *
 * The output is an image with one point in the centre of each voxel of the model's grid, so that it
 * can be probed and volume-rendered in place, with the float array Density as active scalars.
 *
 * The size of the image is known only when the model is. Therefore the input is updated as soon as
 * the output's information is asked for.
 */

#ifndef vtkVoxelLineDensity_h
#define vtkVoxelLineDensity_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineDensity : public vtkImageAlgorithm
{
public:
  static vtkVoxelLineDensity* New();
  vtkTypeMacro(vtkVoxelLineDensity, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Level of detail. Only 0, the voxels of the model, exists; at the next update, an error
   * is told for any other. Default 0.
   */
  vtkSetMacro(Level, int);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Opacity of every line, which its length is multiplied by; 0 to 1, though nothing breaks beyond.
   * Default 1.
   */
  vtkSetMacro(Opacity, double);
  vtkGetMacro(Opacity, double);
  ///@}

protected:
  vtkVoxelLineDensity();
  ~vtkVoxelLineDensity() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Level = 0;
  double Opacity = 1.0;

private:
  vtkVoxelLineDensity(const vtkVoxelLineDensity&) = delete;
  void operator=(const vtkVoxelLineDensity&) = delete;
};

#endif
