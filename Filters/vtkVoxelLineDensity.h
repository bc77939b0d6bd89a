// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineDensity
 * @brief   how much line each voxel of a voxel line model holds, as an image
 *
 * The density of a voxel is the sum over its segments of length times opacity (Kanzler et al. 2019,
 * Eq. 1), with lengths in voxels of the model: a straight line through the middle of a voxel along
 * an axis counts 1. Coarser levels have the means over 2x2x2 voxels; see vtkVoxelLineDensities for
 * the rules, and for densities without a dense image of level 0. The input is a vtkVoxelLineModel.
 *
 * The output is an image with one point in the centre of each voxel of the level, so that it can be
 * probed and volume-rendered in place, with the float array Density as active scalars. Level L has
 * Dimensions / 2^L points, rounded up, at a spacing of VoxelSize * 2^L.
 *
 * The size of the image is known only when the model is. Therefore the input is updated as soon as
 * the output's information is asked for.
 *
 * @sa vtkVoxelLineDensities vtkVoxelLineModel
 */

#ifndef vtkVoxelLineDensity_h
#define vtkVoxelLineDensity_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For the opacity function

class vtkPiecewiseFunction;
class vtkVoxelLineDensities;
class vtkVoxelLineModel;

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineDensity : public vtkImageAlgorithm
{
public:
  static vtkVoxelLineDensity* New();
  vtkTypeMacro(vtkVoxelLineDensity, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Time of the last change, of the opacity function too.
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Level of detail: 0 has the voxels of the model, each further one half as many along each axis,
   * down to a single one. At the next update, an error tells of any other. An empty model gives an
   * empty image at any level from 0 on. Default 0.
   */
  vtkSetMacro(Level, int);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Opacity of every line, which its length is multiplied by; 0 to 1, though nothing breaks beyond,
   * but an error tells of one that is not finite. Default 1.
   */
  vtkSetMacro(Opacity, double);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Opacity by attribute value, for models with scalar attributes (a warning tells where there are
   * none). It is multiplied by Opacity, and it is evaluated at the 255 or 256 values that an
   * attribute can have, see vtkVoxelLineModel::GetAttributes(). Default none: 1 for all values.
   */
  virtual void SetOpacityFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetOpacityFunction() const;
  ///@}

  ///@{
  /**
   * Opacity of the attribute NaN where there is an opacity function. Default 1, as in
   * vtkLookupTable.
   */
  vtkSetMacro(NaNOpacity, double);
  vtkGetMacro(NaNOpacity, double);
  ///@}

  ///@{
  /**
   * Whether the opacities of a model with direct colours count. Default on.
   */
  vtkSetMacro(UseColorOpacity, bool);
  vtkGetMacro(UseColorOpacity, bool);
  vtkBooleanMacro(UseColorOpacity, bool);
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
  vtkSmartPointer<vtkPiecewiseFunction> OpacityFunction;
  double NaNOpacity = 1.0;
  bool UseColorOpacity = true;

private:
  /// Returns false where there was an error or the build was aborted.
  bool BuildDensities(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities);
  void SetOpacities(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities);

  vtkVoxelLineDensity(const vtkVoxelLineDensity&) = delete;
  void operator=(const vtkVoxelLineDensity&) = delete;
};

#endif
