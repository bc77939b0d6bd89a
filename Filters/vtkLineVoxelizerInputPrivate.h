// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkLineVoxelizer reads: line sets, the curves in them, and the values along the curves.
 *
 * Everything that is left out is counted here; nothing of the input is changed.
 */

#ifndef vtkLineVoxelizerInputPrivate_h
#define vtkLineVoxelizerInputPrivate_h

#include "vtkLineVoxelizerTracePrivate.h"
#include "vtkVoxelLineModel.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkIdList;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace vtkLineVoxelizerPrivate
{

/// Reads points of any array without virtual calls where they are floats or doubles in a row. It
/// may be used by several threads.
class PointReader
{
public:
  void SetPoints(vtkDataArray* points);
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }
  void Get(vtkIdType id, double point[3]) const;

private:
  vtkIdType NumberOfPoints = 0;
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  vtkDataArray* Array = nullptr;
};

/// One input of the filter.
struct LineSet
{
  int Connection = 0;
  PointReader Points;
  vtkCellArray* Lines = nullptr;
  vtkIdType NumberOfLines = 0;
  /// Cell id of the first line: vertices stand before the lines in vtkPolyData.
  vtkIdType FirstCell = 0;
  vtkIdType NumberOfCells = 0;

  /// The values that colour the curves, per point or per cell: scalars in [0,1] or NaN, or a colour
  /// array. Both empty where this input has none.
  bool ValuesPerCell = false;
  std::vector<float> Scalars;
  vtkUnsignedCharArray* Colors = nullptr;

  /// Radius per point, as a fraction of the largest one.
  std::vector<float> Radii;
};

/// A stretch of a line whose points can all be used.
struct Curve
{
  int Input;
  /// Index among the lines of its input.
  vtkIdType Line;
  /// Range of its points within the line.
  vtkIdType First;
  vtkIdType Size;
};

/// Which values to read; see the properties of vtkLineVoxelizer.
struct ValueRequest
{
  /// Per input: the array, or nullptr, and whether it belongs to the cells.
  std::vector<vtkDataArray*> Arrays;
  std::vector<bool> PerCell;
  int Component = 0;
  bool DirectColors = true;
  /// Per input: the radii or nullptr.
  std::vector<vtkDataArray*> Radii;
  std::string RadiusArrayName;
  /// Range of scalars, where it ascends, and largest radius, where it is above 0.
  double CustomRange[2] = { 1.0, 0.0 };
  double CustomRadius = 0.0;
};

class Input
{
public:
  /// connection: index of the input connection that the line set comes from.
  void AddLineSet(vtkPolyData* lines, int connection);

  /// Read the values, after FindCurves(). What cannot be used is told in messages.
  void ReadValues(const ValueRequest& request, std::vector<std::string>& messages);

  /// Find the curves of all lines, their bounds, and count what cannot be used.
  void FindCurves();

  /// The points of a curve in grid-local coordinates. ids is space to work in.
  void GetSamples(
    const Curve& curve, const Grid& grid, vtkIdList* ids, std::vector<Sample>& samples) const;

  /// Input connection and cell id of a curve.
  void GetCell(const Curve& curve, vtkIdType connectionAndCell[2]) const;

  /// What FindCurves() left out, in one sentence for each reason; empty where nothing was.
  std::string DescribeDropped() const;

  std::vector<LineSet> LineSets;
  std::vector<Curve> Curves;
  /// Of the points of all curves; valid if there is a curve.
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };

  vtkIdType NumberOfLines = 0;
  vtkIdType NumberOfDroppedCurves[vtkVoxelLineModel::NumberOfDropReasons] = { 0, 0, 0 };
  vtkIdType NumberOfNonFinitePoints = 0;
  vtkIdType NumberOfInvalidIds = 0;
  vtkIdType NumberOfInvalidRadii = 0;

  Payload Values;
  int AttributeKind = vtkVoxelLineModel::NoAttribute;
  double AttributeRange[2] = { 0.0, 1.0 };
  bool HasNaN = false;
  double MaximumRadius = 0.0;

private:
  /// Whether the lines of an input have values; why not, if there is an array that cannot be used.
  bool ChooseArray(std::size_t i, const ValueRequest& request, std::vector<std::string>& messages);
  void ReadScalars(const ValueRequest& request, std::vector<std::string>& messages);
  void ReadRadii(const ValueRequest& request, std::vector<std::string>& messages);
  /// Clamp radii that dwarf the lines, find the largest one, and tell of those that are changed or
  /// too small for a byte of it.
  void LimitRadii(std::vector<std::vector<double>>& radii, const ValueRequest& request,
    std::vector<std::string>& messages);
};

}

#endif

// VTK-HeaderTest-Exclude: vtkLineVoxelizerInputPrivate.h
