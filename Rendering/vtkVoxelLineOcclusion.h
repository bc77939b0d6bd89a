// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineOcclusion
 * @brief   how much of what surrounds each voxel lines fill: spherical ambient occlusion
 *
 * Kanzler, Rautenhaus and Westermann, "A Voxel-based Rendering Pipeline for Large 3D Line Sets",
 * 2019, Sec. 4.1.3: the part of the light from all directions that lines stop within a radius,
 * for each voxel that holds lines; where they hold few, for every other one. In place of rays it
 * follows 14 cones through the densities, along the axes and the diagonals, with the weights of
 * Lebedev's rule of that many points, which integrates polynomials of degree 5 exactly. A cone goes
 * by steps of a voxel, of the level whose voxels are as wide as it is there, and takes the density
 * of the voxel it is in. docs/design.md has errors and times of this and of other ways.
 *
 * The other voxels of a brick get the mean of their neighbours that have a value, so that lookups
 * may interpolate within bricks.
 *
 * The work is shared by threads with vtkSMPTools. The result does not depend on their number.
 */

#ifndef vtkVoxelLineOcclusion_h
#define vtkVoxelLineOcclusion_h

#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <cstdint>
#include <functional>
#include <vector>

class vtkVoxelLineDensities;
class vtkVoxelLineModel;

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineOcclusion
{
public:
  /**
   * Compute the occlusion of a model with these densities within a radius, in voxels; at once where
   * nothing changed. extinction is the optical depth per voxel for a density of 1. progress is told
   * the part that is done, and returns whether to go on; where it says no there are no values and
   * the result is false.
   */
  bool Build(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities, double radius,
    double extinction, const std::function<bool(double)>& progress = nullptr);

  /// Time of the last build that changed the values.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  /// For brick b the 64 values from 64 b on, voxel (x,y,z) of the brick at x + 4y + 16z; 255 stands
  /// for no light at all.
  const std::vector<std::uint8_t>& GetValues() const { return this->Values; }

  /// Forget the values and free their memory.
  void Initialize();

private:
  std::vector<std::uint8_t> Values;
  vtkTimeStamp BuildTime;
  vtkMTimeType DensitiesTime = 0;
  double Radius = 0.0;
  double Extinction = 0.0;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineOcclusion.h
