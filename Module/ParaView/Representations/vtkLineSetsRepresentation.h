// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsRepresentation
 * @brief   what the representations of line sets in ParaView share
 *
 * ParaView's geometry representation with one of this project's mappers in place of its own. The
 * superclass extracts the geometry of any data set or composite data set, delivers it to where it
 * is drawn, and keeps the colour map, the property and the placement. This class joins the blocks
 * that are visible into one vtkPolyData there, since a line mapper draws all lines of a set
 * together (one voxel model, one order of blending), and gives it to the mapper.
 *
 * On several ranks, each rank draws the lines that it has and depth tells what is in front, as long
 * as all is opaque. Else each gets the lines of its part of space (vtkLineSetsDistribution), and
 * draws what is in that part alone. What is measured of the lines is shared before, so that all
 * ranks draw as one would.
 *
 * What ParaView stores per block besides visibility (colours, opacities, colour arrays of single
 * blocks) has no counterpart in such a mapper: it is told once that it is ignored.
 */

#ifndef vtkLineSetsRepresentation_h
#define vtkLineSetsRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkLineVoxelizer.h"          // For what is measured
#include "vtkParaViewLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"           // For planes

#include <memory> // For std::unique_ptr
#include <vector> // For planes

class vtkLineSetsBlocks;
class vtkLineSetsShare;
class vtkPlane;
class vtkPolyDataMapper;

class VTKPARAVIEWLINESETS_EXPORT vtkLineSetsRepresentation : public vtkGeometryRepresentation
{
public:
  vtkAbstractTypeMacro(vtkLineSetsRepresentation, vtkGeometryRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /**
   * The mapper that draws, whose settings are those of the representation. The proxies make it and
   * hand it over before they set anything else. Each subclass begins with one of its own kind.
   */
  virtual void SetLineMapper(vtkPolyDataMapper* mapper);

protected:
  vtkLineSetsRepresentation();
  ~vtkLineSetsRepresentation() override;

  vtkPolyDataMapper* GetLineMapper();

  using Measures = vtkLineVoxelizer::Measures;

  /// What has to be the same on all ranks; by default the bounds of the lines.
  virtual Measures MeasureLines(vtkPolyData* lines);

  /**
   * Take what is measured of the lines of all ranks; null: the mapper draws all there is and
   * measures by itself. Returns how far around its part of space a rank must know the lines, in
   * units of the data; infinity: all of them. By default nothing is done and 0 is returned.
   */
  virtual double SetSharedMeasures(const Measures* measures);

  /// Draw only what is in a box in world coordinates, infinite sides are open. By default by
  /// clipping planes of the mapper, beside those that a user has set.
  virtual void SetRegion(const double region[6]);

private:
  vtkLineSetsRepresentation(const vtkLineSetsRepresentation&) = delete;
  void operator=(const vtkLineSetsRepresentation&) = delete;

  vtkPolyData* Share(vtkPolyData* lines, vtkInformation* viewInfo);

  std::unique_ptr<vtkLineSetsBlocks> Blocks;
  std::unique_ptr<vtkLineSetsShare> Shared;
  /// Those of the mapper's clipping planes that are this representation's.
  std::vector<vtkSmartPointer<vtkPlane>> RegionPlanes;
};

#endif
