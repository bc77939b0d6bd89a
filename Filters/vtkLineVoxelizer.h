// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineVoxelizer
 * @brief   make a voxel line model from the lines of polygonal data
 *
 * Every line cell of every input (polylines and lines of two points) is a curve. Its polygon is cut
 * at the faces of a grid of cubic voxels over the bounds of all curves; within a voxel it becomes a
 * straight segment, whose end points are quantized to bins on the faces. See Kanzler, Rautenhaus
 * and Westermann, "A Voxel-based Rendering Pipeline for Large 3D Line Sets", 2019, Secs. 3.1
 * to 3.3, and vtkVoxelLineModel for the result. Beyond the paper, the ends of the curves are kept,
 * points are kept inside voxels where a curve bends there, any number of segments may share a
 * voxel, and empty regions take no memory.
 *
 * Input port 0 takes any number of vtkPolyData; their lines share one grid, and vtkVoxelLineModel
 * tells which input and cell each curve comes from. Other cells are ignored. 32- and 64-bit
 * cell arrays and points of any type may be mixed.
 *
 * <b>Attributes.</b> The array chosen with SetInputArrayToProcess(0, ...), by default the active
 * scalars of the points or else of the cells, is kept in 8 bits per end point. Values are
 * interpolated linearly along the lines; where one of two is NaN (or infinite, which counts as
 * NaN), the nearer vertex has its way. Unsigned char arrays are colours if DirectColors is on.
 *
 * <b>What cannot be used</b> is left out, counted in the model, and told in one warning: lines of
 * fewer than two points, points that are not finite or whose id does not exist, arrays whose length
 * does not fit, radii that are not usable. A point that cannot be used interrupts its curve, which
 * goes on after it as another curve of the same cell. A line without length is kept as a point.
 * An empty input gives an empty model without a warning.
 *
 * <b>Errors.</b> Where a property is outside its range, or the extent of the data exceeds 1e300, or
 * the model would have more than 2^31 segments or more than memory holds, the error is told,
 * GetErrorCode() is not 0, and the model is empty. It is told once, until something changes.
 *
 * The work is shared by threads with vtkSMPTools. The model does not depend on their number.
 *
 * @sa vtkVoxelLineModel vtkVoxelLineMapper
 */

#ifndef vtkLineVoxelizer_h
#define vtkLineVoxelizer_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersLineSetsModule.h" // For export macro

#include <string> // For std::string

class vtkVoxelLineModel;

namespace vtkLineVoxelizerPrivate
{
struct Grid;
class Input;
}

class VTKFILTERSLINESETS_EXPORT vtkLineVoxelizer : public vtkDataObjectAlgorithm
{
public:
  static vtkLineVoxelizer* New();
  vtkTypeMacro(vtkLineVoxelizer, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The model that the last update made.
  vtkVoxelLineModel* GetOutput();

  /// Largest value of Resolution.
  static constexpr int LargestResolution = 4096;

  ///@{
  /**
   * Number of voxels along the longest side of the bounds, 1 to 4096. The other sides have as many
   * as they need, at least 1. Default 256. An error is told at the next update otherwise.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Bins along the edge of a voxel face that end points are quantized to: a power of two from 2 to
   * 2048, or 0 to keep them exact. Up to 32 bins, a segment takes 4 bytes, above 8, and exact ones
   * 24, not counting attributes. Default 32. An error is told at the next update otherwise.
   */
  vtkSetMacro(FaceBins, int);
  vtkGetMacro(FaceBins, int);
  ///@}

  ///@{
  /**
   * Largest distance in voxels, 0 or above, between the part of a curve inside a voxel and its
   * straight segment. Where it would be larger, the farthest vertex is kept as a point inside the
   * voxel, until it is not (Douglas-Peucker). Quantization comes on top of it. With infinity, no
   * point is kept, as in the paper. Default 0.1. An error is told at the next update otherwise.
   */
  vtkSetMacro(InteriorTolerance, double);
  vtkGetMacro(InteriorTolerance, double);
  ///@}

  ///@{
  /**
   * Whether the model gets attributes to colour the curves by. Default on.
   */
  vtkSetMacro(GenerateAttributes, bool);
  vtkGetMacro(GenerateAttributes, bool);
  vtkBooleanMacro(GenerateAttributes, bool);
  ///@}

  ///@{
  /**
   * Component of the attribute array, counted from 0, or -1 for the magnitude of all components.
   * An array of one component is taken as it is. Default 0. Where an array has fewer components,
   * its last one is taken and a warning tells so.
   */
  vtkSetMacro(AttributeComponent, int);
  vtkGetMacro(AttributeComponent, int);
  ///@}

  ///@{
  /**
   * Whether unsigned char arrays of 1 to 4 components are colours as in vtkScalarsToColors
   * (luminance, luminance and opacity, RGB, RGBA) and kept as such, 4 bytes per end point.
   * Otherwise they are scalars as all others. Default on.
   */
  vtkSetMacro(DirectColors, bool);
  vtkGetMacro(DirectColors, bool);
  vtkBooleanMacro(DirectColors, bool);
  ///@}

  ///@{
  /**
   * Name of a point array of radii in world units, or an empty string for none. Its first component
   * is used; radii that are negative or not finite are taken as 0, and those above 4 times the
   * longest side of the curves' bounds as that. A model stores them in 8 bits, so that those below
   * 1/510 of the largest one become 0. Each of these is counted in a warning. Default none.
   */
  vtkSetMacro(RadiusArrayName, std::string);
  vtkGetMacro(RadiusArrayName, std::string);
  ///@}

  ///@{
  /**
   * Bounds of the grid in world units (smallest x, largest x, ...), used when UseCustomBounds is
   * on, so that several models can share a grid. Where they do not contain all curves, the grid is
   * enlarged until it does, and a warning tells so. Default off, and 0 1 0 1 0 1.
   */
  vtkSetMacro(UseCustomBounds, bool);
  vtkGetMacro(UseCustomBounds, bool);
  vtkBooleanMacro(UseCustomBounds, bool);
  vtkSetVector6Macro(CustomBounds, double);
  vtkGetVector6Macro(CustomBounds, double);
  ///@}

  ///@{
  /**
   * Range of the scalars and largest radius, used when UseCustomRanges is on instead of those of
   * the input, so that the bytes of several models stand for the same. Scalars outside the range
   * count as its nearer end, radii above the largest one as that; warnings tell how many. A range
   * whose first value is above its second, and a radius of 0, stand for those of the input. Default
   * off, and (1, 0) and 0. Values that are not finite and a negative radius are errors at the next
   * update.
   */
  vtkSetMacro(UseCustomRanges, bool);
  vtkGetMacro(UseCustomRanges, bool);
  vtkBooleanMacro(UseCustomRanges, bool);
  vtkSetVector2Macro(CustomAttributeRange, double);
  vtkGetVector2Macro(CustomAttributeRange, double);
  vtkSetMacro(CustomMaximumRadius, double);
  vtkGetMacro(CustomMaximumRadius, double);
  ///@}

  /// What an update measures in its input, and what the properties above replace.
  struct Measures
  {
    /// Of all curves; the first value of an axis is above its second where there are none.
    double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
    /// Of the scalars that are kept in bytes; (1, 0) where there are none.
    double AttributeRange[2] = { 1.0, 0.0 };
    /// 0 where there are no radii.
    double MaximumRadius = 0.0;
  };

  /**
   * Bring the input up to date and measure it, without making a model, and without regard to the
   * custom values. The union of what several filters measure is what they have to share, as
   * processes do of which each has a part of the lines.
   */
  Measures MeasureInput();

protected:
  vtkLineVoxelizer();
  ~vtkLineVoxelizer() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Resolution = 256;
  int FaceBins = 32;
  double InteriorTolerance = 0.1;
  bool GenerateAttributes = true;
  int AttributeComponent = 0;
  bool DirectColors = true;
  std::string RadiusArrayName;
  bool UseCustomBounds = false;
  double CustomBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  bool UseCustomRanges = false;
  double CustomAttributeRange[2] = { 1.0, 0.0 };
  double CustomMaximumRadius = 0.0;

private:
  /// What is wrong with the properties, or an empty string.
  std::string FindPropertyError() const;
  void ReadInput(vtkInformationVector* inputs, bool useCustomRanges,
    vtkLineVoxelizerPrivate::Input& input, std::string& warning);
  std::string MakeGrid(const vtkLineVoxelizerPrivate::Input& input,
    vtkLineVoxelizerPrivate::Grid& grid, std::string& warning) const;
  /// Returns what went wrong, or an empty string.
  std::string BuildModel(const vtkLineVoxelizerPrivate::Input& input,
    const vtkLineVoxelizerPrivate::Grid& grid, vtkVoxelLineModel* model);
  std::string Execute(vtkInformationVector* inputs, vtkVoxelLineModel* model, std::string& warning);

  vtkLineVoxelizer(const vtkLineVoxelizer&) = delete;
  void operator=(const vtkLineVoxelizer&) = delete;
};

#endif
