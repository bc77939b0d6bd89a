// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineDensities
 * @brief   how much line a voxel line model holds where, at all levels of detail
 *
 * The density of a voxel is the sum over its segments of length times opacity (Kanzler, Rautenhaus
 * and Westermann, "A Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019, Eq. 1). Lengths
 * are in edges of the model's voxels: a straight opaque line along an axis counts 1 in each voxel
 * that it crosses. Each further level has the means over 2x2x2 voxels of the level below (Sec. 3.4
 * there), down to a single voxel. Where a level has an odd number of voxels along an axis, those
 * that lack to the last 2x2x2 count as empty: its mean is the sum divided by 8 all the same, so
 * that the sum over a level, times 8^level, is the same for all levels.
 *
 * <b>Opacity of a segment.</b> Opacity, times what its attributes tell:
 * - Scalar attributes, where an opacity table is set: the mean of the table along the segment. The
 *   attribute changes linearly between the bytes of the two ends, and the table is interpolated
 *   linearly between its entries, so that the mean is an integral of trapezoids, which is exact
 * (and so it is for a table whose nearest entry is taken). Where an end is NaN, the half next to it
 * counts with the entry of NaN, 255, and the other half with the entry of its own end.
 * - Colour attributes, where UseColorOpacity is on: the mean of the opacities of both ends.
 * - Otherwise 1.
 *
 * <b>Memory.</b> Level 0 has 64 values for each brick of the model that holds segments; the levels
 * from 1 on are dense, together about Dimensions / 7 values of 4 bytes.
 *
 * <b>Cost of a change.</b> Nothing is kept per segment: when an opacity changes, the lengths are
 * computed again from the model, which takes a small part of the time of a voxelization; keeping
 * them would take as much memory as the segments themselves. See docs/design.md for figures.
 *
 * The work is shared by threads with vtkSMPTools. The result does not depend on their number.
 * ProgressEvent is invoked a few times during Build(), with the fraction done as a double; an
 * observer may call SetAbortBuild(true).
 *
 * @sa vtkVoxelLineModel vtkVoxelLineDensity
 */

#ifndef vtkVoxelLineDensities_h
#define vtkVoxelLineDensities_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For array members
#include "vtkWeakPointer.h"  // For the model

#include <array>  // For the table
#include <vector> // For the levels

class vtkDataArray;
class vtkFloatArray;
class vtkVoxelLineModel;

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineDensities : public vtkObject
{
public:
  static vtkVoxelLineDensities* New();
  vtkTypeMacro(vtkVoxelLineDensities, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Number of entries of an opacity table, one for each value of an attribute byte.
  static constexpr int TableSize = 256;

  ///@{
  /**
   * Factor of all opacities; 0 to 1, though nothing breaks beyond. Build() tells an error where it
   * is not finite. Default 1.
   */
  vtkSetMacro(Opacity, double);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Opacities by attribute byte, see vtkVoxelLineModel::GetAttributes(), for models with scalar
   * attributes. Where the model has NaN, entry 255 is the opacity of NaN. Entries that are not
   * finite are taken as 0, and a warning tells how many. Setting an equal table is no change.
   * Default none.
   */
  void SetOpacityTable(const double opacities[256]);
  void RemoveOpacityTable();
  vtkGetMacro(HasOpacityTable, bool);
  double GetTableOpacity(int byte) const;
  ///@}

  ///@{
  /**
   * Whether the opacities of a model with direct colours count. Default on.
   */
  vtkSetMacro(UseColorOpacity, bool);
  vtkGetMacro(UseColorOpacity, bool);
  vtkBooleanMacro(UseColorOpacity, bool);
  ///@}

  ///@{
  /**
   * Whether segments of a model that has radii count by their width: lengths are then multiplied by
   * the mean of the radii of both ends over the model's MaximumRadius, so that the density times
   * twice that radius is what area lines cover from the side. Default off, as in Eq. 1.
   */
  vtkSetMacro(UseRadii, bool);
  vtkGetMacro(UseRadii, bool);
  vtkBooleanMacro(UseRadii, bool);
  ///@}

  /**
   * Make the densities of a model; at once where neither the model nor an opacity has changed since
   * the last time. An empty model gives no levels. Returns whether the densities are those of
   * the model now; else, there are none: the model or an opacity has a defect, or memory does not
   * suffice, of which an error tells, or the build was aborted.
   */
  bool Build(vtkVoxelLineModel* model);

  /// Time of the last build that changed the densities.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

  /// Forget the densities and free their memory.
  void Initialize();

  ///@{
  /**
   * Whether to stop a build in progress, to be set by an observer of ProgressEvent. Build() starts
   * with false.
   */
  void SetAbortBuild(bool isAborted) { this->AbortBuild = isAborted; }
  bool GetAbortBuild() const { return this->AbortBuild; }
  ///@}

  /// Number of levels: 0 before a build and for an empty model, else 1 + ceil(log2(largest
  /// dimension)).
  int GetNumberOfLevels() const;

  /// Number of voxels of a level along x, y and z: those of the model / 2^level, rounded up; 0
  /// where there is no such level.
  void GetDimensions(int level, int dimensions[3]) const;

  /**
   * Values of a level, or nullptr where there is none; they belong to this object and are
   * overwritten by the next build. Level 0 has, for brick b of the model, the 64 values from 64 b
   * on, voxel (x,y,z) of the brick at x + 4y + 16z; the other levels have one for every voxel, x
   * fastest.
   */
  vtkFloatArray* GetValues(int level) const;

  /// The grid of bricks that level 0 refers to, see vtkVoxelLineModel; nullptr without levels.
  vtkDataArray* GetBrickGrid() const;

  /// Density of voxel (i,j,k) of a level; 0 outside the grid.
  float GetVoxel(int level, int i, int j, int k) const;

  /**
   * Density at a grid-local position of the model (see vtkVoxelLineModel), interpolated trilinearly
   * between the centres of the level's voxels; those outside the grid count as 0. 0 where there is
   * no such level or the position is not finite.
   */
  double GetDensity(int level, const double position[3]) const;

  /// Bytes of a level's values; 0 where there is no such level.
  vtkIdType GetNumberOfBytes(int level) const;

  /// Bytes of all values.
  vtkIdType GetNumberOfBytes() const;

protected:
  vtkVoxelLineDensities();
  ~vtkVoxelLineDensities() override;

  double Opacity = 1.0;
  bool HasOpacityTable = false;
  std::array<double, TableSize> OpacityTable{};
  bool UseColorOpacity = true;
  bool UseRadii = false;
  bool AbortBuild = false;

private:
  void Allocate(vtkVoxelLineModel* model);
  /// Returns false where it was aborted.
  bool SumSegments(vtkVoxelLineModel* model);
  void AverageBricks(vtkVoxelLineModel* model);
  void AverageLevel(int level);

  vtkWeakPointer<vtkVoxelLineModel> Model;
  vtkMTimeType ModelTime = 0;
  vtkTimeStamp BuildTime;
  int GridDimensions[3] = { 0, 0, 0 };
  vtkSmartPointer<vtkDataArray> BrickGrid;
  std::vector<vtkSmartPointer<vtkFloatArray>> Levels;

  vtkVoxelLineDensities(const vtkVoxelLineDensities&) = delete;
  void operator=(const vtkVoxelLineDensities&) = delete;
};

#endif
