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
 * blocks) has no counterpart in such a mapper: it is told once that it is ignored. So is what some
 * visible blocks lack of the arrays in use (vtkLineSetsBlocks).
 *
 * While the user interacts and the view wants levels of detail, every n-th line is drawn by a
 * second mapper with the same settings (vtkLineSetsThinning), unless the mapper draws less by
 * itself; data with polygons are decimated by the superclass. What is drawn between interactions is
 * left as it is.
 */

#ifndef vtkLineSetsRepresentation_h
#define vtkLineSetsRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkLineVoxelizer.h"          // For what is measured
#include "vtkParaViewLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"           // For mappers and planes

#include <memory> // For std::unique_ptr
#include <set>    // For what has been said
#include <string> // For std::string
#include <vector> // For std::vector

class vtkLineSetsBlocks;
class vtkLineSetsThinning;
class vtkPlane;
class vtkPolyData;
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
   * hand it over before they set anything else. Each subclass begins with one of its own kind, and
   * takes no other: an error tells it.
   */
  virtual void SetLineMapper(vtkPolyDataMapper* mapper);

  /// Arrays with the ids of points and cells that a selection tells; nullptr: those of the input.
  void SetArrayIdNames(const char* pointArray, const char* cellArray) override;

protected:
  vtkLineSetsRepresentation();
  ~vtkLineSetsRepresentation() override;

  vtkPolyDataMapper* GetLineMapper();

  /// Class of the mapper that is taken, or of one that derives from it. Also called in constructors
  /// of subclasses.
  virtual const char* GetLineMapperType() = 0;

  /// Name of an array as the mappers take it: empty where a list offers "None".
  static std::string GetArrayName(const char* name);

  /**
   * Whether the view's level of detail is every n-th line; else the mapper itself draws less while
   * the user interacts. Also called in constructors of subclasses. Default true.
   */
  virtual bool IsThinned() { return true; }

  /// Names of the arrays, beside the one that colours, that the mapper reads. Default none.
  virtual std::vector<std::string> GetArraysInUse() { return {}; }

  /**
   * Tells what is wrong with the lines that are drawn, as far as the mapper does not, by the
   * functions below; called before each frame. By default nothing.
   */
  virtual void CheckLines(vtkPolyData*) {}
  /// Warn where the array that is to colour the lines is missing.
  void CheckColorArray(vtkPolyData* lines);
  /// Warn where there are other cells but no lines.
  void CheckCells(vtkPolyData* lines);

  /// Overridden since arrays of field data become arrays of cells where blocks are joined.
  void UpdateColoringParameters() override;

  using Measures = vtkLineVoxelizer::Measures;

  /**
   * Leave what was shared if it is of other settings than the present ones: a view asks for bounds,
   * for which the mapper may build, before the lines are shared again. By default nothing is done.
   */
  virtual void LeaveStaleMeasures();

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

  void UpdateLevelOfDetail(vtkInformation* viewInfo);
  void UpdateLines(vtkInformation* viewInfo);
  /// Whether a level of detail is no more than an outline.
  bool IsOutline(vtkDataObject* detail);
  /// The mapper that draws the level of detail, with the settings of the other one.
  vtkPolyDataMapper* UpdateLevelOfDetailMapper(vtkDataObject* detail);
  void UpdateBlockAttributes(vtkDataObject* data, vtkDataObject* detail);
  /// Says a warning where none of the same key has been said; its text is the key by default.
  void WarnOnce(const std::string& warning, const std::string& key = std::string());

  /// Tells once of each array that is left out. No warning, for which ParaView's window would open
  /// its messages: nothing that is drawn depends on such arrays.
  void TellLeftOut();

  /// The lines of one level of detail and what ParaView sets for their blocks.
  struct Level;
  /// What this rank draws of the level's lines, of which it tells the mapper.
  vtkPolyData* Share(Level& level, vtkPolyData* lines);

  std::unique_ptr<Level> Whole;
  std::unique_ptr<Level> Thin;
  std::unique_ptr<vtkLineSetsThinning> Thinning;
  vtkSmartPointer<vtkPolyDataMapper> OutlineMapper;
  /// When the mapper of the thin level got its settings.
  vtkTimeStamp ThinMapperTime;
  std::set<std::string> Said;
  /// How far around its part of space a rank knows the lines; negative: nothing is shared.
  double Margin = -1.0;
  /// Those of the mapper's clipping planes that are this representation's.
  std::vector<vtkSmartPointer<vtkPlane>> RegionPlanes;
};

#endif
