// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineLevel
 * @brief   a level of detail of a voxel line model: one representative line for each voxel
 *
 * Input and output are a vtkVoxelLineModel. The output has voxels of 2^Level times the edge length,
 * Dimensions / 2^Level of them, rounded up, from the same Origin on, and in each one that curves
 * pass through, one segment: the representative line of Kanzler, Rautenhaus and Westermann, "A
 * Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019, Sec. 3.4. It has the layout of
 * every other model, so that it can be drawn, measured and turned into lines as one. Level 0 has
 * the representative lines of the input's own voxels; this is not the input itself.
 *
 * <b>Lines.</b> What is averaged are the passages of curves through a voxel: from the point where
 * the curve comes in, or begins, to the point where it goes out, or ends. One that ends where it
 * begins counts only where its curve has no other through the voxel. They are put together from the
 * segments of the input, at each level anew, and not from the representatives of the level before:
 * each curve then has its weight in the average, and errors do not add up.
 *
 * <b>Average.</b> The representative goes from the mean of the start points to the mean of the end
 * points, each passage with the same weight. A passage at more than 90 degrees to the direction
 * that the others have together is flipped: first against the longest passage, and then twice
 * against the sum of all of them as flipped before. This does not depend on the order of the
 * curves, unless several passages are the longest, of which the first one (by curve) counts.
 *
 * <b>End points.</b> A mean inside the voxel is moved to the nearest face of the voxel, and there
 * to the middle of its bin. Where no curve reaches a face at this end, because all end or begin in
 * the voxel, it stays inside. Where the representatives of two voxels that share a face both end on
 * that face, both ends move to the bin of their mean; of several such pairs, the nearest one does.
 * Where both ends of an average fall on each other, the longest passage is taken in its stead; it
 * is a point only where all passages are.
 *
 * <b>What the lines carry.</b> The curve is that of the longest passage. Attributes and radii
 * are means of the bytes of the passages' ends: of scalars, without NaN unless all are; of
 * colours, each component by itself, opacity included. Radii are those of the curves, in the same
 * world units, though a representative stands for many of them. Of the statistics, what was
 * dropped is copied; there are no duplicates and no collapsed segments; LargestDeviation is not
 * measured, and NaN. Bounds are those of the representatives, which may leave the bounds of the
 * curves by up to a voxel.
 *
 * The work is shared by threads with vtkSMPTools. The result does not depend on their number.
 *
 * @sa vtkVoxelLineModel vtkVoxelLineGeometry vtkVoxelLineDensities
 */

#ifndef vtkVoxelLineLevel_h
#define vtkVoxelLineLevel_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersLineSetsModule.h" // For export macro

class vtkVoxelLineModel;

class VTKFILTERSLINESETS_EXPORT vtkVoxelLineLevel : public vtkDataObjectAlgorithm
{
public:
  static vtkVoxelLineLevel* New();
  vtkTypeMacro(vtkVoxelLineLevel, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The model that the last update made.
  vtkVoxelLineModel* GetOutput();

  ///@{
  /**
   * Level of detail, from 0, the voxels of the input, to ceil(log2(largest dimension)), a single
   * voxel. At the next update, an error tells of any other, and the output is empty. An empty
   * input gives an empty output at any level from 0 on. Default 1.
   */
  vtkSetMacro(Level, int);
  vtkGetMacro(Level, int);
  ///@}

protected:
  vtkVoxelLineLevel();
  ~vtkVoxelLineLevel() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Level = 1;

private:
  vtkVoxelLineLevel(const vtkVoxelLineLevel&) = delete;
  void operator=(const vtkVoxelLineLevel&) = delete;
};

#endif
