// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineModelFilter
 * @brief   what filters share that make a voxel line model of lines and give a part of it
 *
 * ParaView does not know vtkVoxelLineModel as data. A subclass therefore runs vtkLineVoxelizer and
 * the filter after it inside, and gives data that ParaView knows. Progress and abort are those of
 * the filters inside, and so are their errors and warnings.
 *
 * The input is vtkPolyData or a tree of blocks, of which every vtkPolyData is taken; other leaves
 * are counted in a warning. All blocks share one grid.
 *
 * <b>Several ranks.</b> The bounds of the grid are those of the lines of all ranks of the
 * controller, so that the grids of all ranks are one, whatever lines each of them has. All ranks
 * must update together.
 *
 * @sa vtkVoxelizeLinesFilter vtkLineDensityFilter vtkLineVoxelizer
 */

#ifndef vtkLineModelFilter_h
#define vtkLineModelFilter_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkParaViewFiltersLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"                  // For the controller

#include <vector> // For blocks

class vtkLineVoxelizer;
class vtkMultiProcessController;
class vtkPolyData;

class VTKPARAVIEWFILTERSLINESETS_EXPORT vtkLineModelFilter : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkLineModelFilter, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of voxels along the longest side of the lines' bounds, 1 to 4096. The other sides have
   * as many as they need. Default 256.
   *
   * A value out of range is an error.
   */
  virtual void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Level of detail, 0 to 12: 0 has the voxels of the resolution, each further one half as many
   * along each axis, down to a single one. Default 0.
   *
   * A value out of range is an error, and at the next update so is a level that the grid does not
   * have.
   */
  virtual void SetLevel(int level);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Bins along the edge of a voxel face to which points are rounded: a power of two from 2 to 2048,
   * or 0 for exact points. Default 32.
   *
   * At the next update, an error tells of any other.
   */
  vtkSetMacro(FaceBins, int);
  vtkGetMacro(FaceBins, int);
  ///@}

  ///@{
  /**
   * How far a line may deviate inside a voxel before its points there are kept, in voxels, 0 or
   * above. Default 0.1. With infinity no such point is kept.
   *
   * At the next update, an error tells of a negative value or NaN.
   */
  vtkSetMacro(InteriorTolerance, double);
  vtkGetMacro(InteriorTolerance, double);
  ///@}

  ///@{
  /**
   * Whose ranks share the grid; nullptr for a filter by itself. Default: the global controller.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

protected:
  vtkLineModelFilter();
  ~vtkLineModelFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// A vtkPolyData of the input, and its flat index in the tree; 0 where the input is no tree.
  struct Block
  {
    vtkSmartPointer<vtkPolyData> Lines;
    unsigned int FlatIndex = 0;
  };
  /// The number of leaves that are no vtkPolyData comes along.
  static std::vector<Block> FindBlocks(vtkDataObject* input, int& numberOfOthers);

  /// Warn of leaves that are not used.
  void TellOthers(int numberOfOthers);

  /// Bounds of the lines of all ranks. Returns false where there are none.
  bool FindBounds(const std::vector<Block>& blocks, double bounds[6]);

  /// The array that SetInputArrayToProcess(0, ...) chose by name, or an empty name: of none.
  const char* GetChosenArrayName();

  /// Settings of the voxelizer for a grid over the bounds.
  void SetUpVoxelizer(vtkLineVoxelizer* voxelizer, const double bounds[6]);

  /// Run a filter inside: its progress becomes that of this filter from first to last, and an abort
  /// of this filter its own. Returns whether it made its output.
  bool RunInside(vtkAlgorithm* inside, double first, double last);

  int Resolution = 256;
  int Level = 0;
  int FaceBins = 32;
  double InteriorTolerance = 0.1;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkLineModelFilter(const vtkLineModelFilter&) = delete;
  void operator=(const vtkLineModelFilter&) = delete;
};

#endif
