// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLinesRepresentation
 * @brief   lines in ParaView, ray cast as tubes from a voxel model (vtkVoxelLineMapper)
 *
 * ParaView highlights what is selected by lines in the middle of the tubes: they are seen where
 * their width (SelectionLineWidth, in pixels) is above the tube's, or where tubes are translucent.
 */

#ifndef vtkVoxelLinesRepresentation_h
#define vtkVoxelLinesRepresentation_h

#include "vtkLineSetsRepresentation.h"
#include "vtkParaViewLineSetsModule.h" // For export macro
#include "vtkWeakPointer.h"            // For what was measured

class vtkVoxelLineMapper;

class VTKPARAVIEWLINESETS_EXPORT vtkVoxelLinesRepresentation : public vtkLineSetsRepresentation
{
public:
  static vtkVoxelLinesRepresentation* New();
  vtkTypeMacro(vtkVoxelLinesRepresentation, vtkLineSetsRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Point array of the input with one radius per point, in units of the data. Default "None": all
   * tubes have the same radius.
   *
   * See vtkVoxelLineMapper::SetRadiusArrayName(). An empty name and nullptr mean "None" as well.
   */
  void SetRadiusArrayName(const char* name);

protected:
  vtkVoxelLinesRepresentation();
  ~vtkVoxelLinesRepresentation() override;

  const char* GetLineMapperType() override { return "vtkVoxelLineMapper"; }
  bool IsThinned() override { return false; }
  std::vector<std::string> GetArraysInUse() override;
  /// Also where tubes are opaque, which let something through where they are thinner than a pixel,
  /// and where lines of other ranks cast shadows.
  bool NeedsOrderedCompositing() override;
  void LeaveStaleMeasures() override;
  Measures MeasureLines(vtkPolyData* lines) override;
  double SetSharedMeasures(const Measures* measures) override;
  void SetRegion(const double region[6]) override;

private:
  vtkVoxelLinesRepresentation(const vtkVoxelLinesRepresentation&) = delete;
  void operator=(const vtkVoxelLinesRepresentation&) = delete;

  vtkVoxelLineMapper* GetVoxelLineMapper();

  /// What was measured last, and of what.
  Measures Measured;
  vtkWeakPointer<vtkPolyData> MeasuredLines;
  vtkMTimeType MeasuredLinesTime = 0;
  std::string MeasuredSettings;
};

#endif
