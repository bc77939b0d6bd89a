// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineFrameBuilder
 * @brief   turns camera, actor, lights and property into a vtkVoxelLineFrame
 *
 * All placement is computed in double precision and rounded once, when it is written into the
 * frame, whose coordinates lie near the grid (see vtkVoxelLineFrame). A world position never
 * passes through single precision, so that data far from the origin loses nothing.
 */

#ifndef vtkVoxelLineFrameBuilder_h
#define vtkVoxelLineFrameBuilder_h

#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkVoxelLineFrame.h"

#include <string>

class vtkActor;
class vtkLineIllumination;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkProperty;
class vtkRenderer;

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineFrameBuilder
{
public:
  /// Tubes are not drawn with a larger radius than this, in units of the longest side of the grid:
  /// single precision would lose the lines in them.
  static constexpr double LargestRadius = 4.0;

  /// Where the grid of a model lies.
  struct Grid
  {
    /// Lower corner and voxel edge, in the coordinates of the data.
    double Origin[3] = { 0.0, 0.0, 0.0 };
    double VoxelSize = 1.0;
    int Dimensions[3] = { 1, 1, 1 };
    /// How far something drawn may lie outside the grid, in voxels: the largest tube radius.
    double Margin = 0.0;
  };

  /// How the scene is seen. Matrices act on columns, as vtkMatrix4x4 has them.
  struct View
  {
    /// Size of the viewport, in pixels.
    int ViewportSize[2] = { 0, 0 };
    /// The part of the viewport that the picture covers: first pixel and size.
    int PictureOrigin[2] = { 0, 0 };
    int PictureSize[2] = { 0, 0 };
    /// World to view coordinates, row by row.
    double ViewFromWorld[16];
    /// View to clip coordinates with z from -1 to 1, row by row.
    double ClipFromView[16];
    /// Data to world coordinates (the actor's matrix), row by row.
    double WorldFromData[16];
  };

  /**
   * The view of a renderer's camera on an actor, as all other actors have it; the picture covers
   * the whole viewport.
   */
  static View GetView(vtkRenderer* renderer, vtkActor* actor, int width, int height);

  /**
   * Fill size, rays, depth and matrices of the frame. Returns an empty string, or else why nothing
   * can be seen: a matrix that cannot be inverted or is not finite, or a projection whose depth
   * depends on more than the distance along the view direction.
   */
  static std::string SetView(vtkVoxelLineFrame& frame, const View& view, const Grid& grid);

  /**
   * Largest radius, in voxels, with which tubes are drawn for the sake of coverage: as large as
   * lets a ray meet about 4096 segments, if they were spread evenly, but at least 2. So rays need
   * not visit ever more voxels. Where half a pixel is larger, rays miss some tubes, and those that
   * they hit are less transparent by as much: the mean stays the same.
   */
  static double GetLargestWidening(const Grid& grid, double segments);

  /**
   * Decide whether tubes are widened to the width of a pixel, for a frame with a view and a radius.
   * smallest is the smallest radius above 0, in voxels. Without widen tubes have the width that
   * their radius gives, at whatever size. limit is GetLargestWidening(); returns whether it was
   * met.
   */
  static bool SetWidths(vtkVoxelLineFrame& frame, double smallest, bool widen, double limit);

  /// World clipping planes (may be null) to grid-local half spaces.
  static void SetClippingPlanes(
    vtkVoxelLineFrame& frame, vtkPlaneCollection* planes, const View& view, const Grid& grid);

  /// A box in world coordinates (smallest x, largest x, ...; infinite where it is open) to
  /// grid-local half spaces. The same side of two boxes gives planes that differ in sign alone.
  static void SetRegion(
    vtkVoxelLineFrame& frame, const double region[6], const View& view, const Grid& grid);

  /// Colours, coefficients and opacity of a vtkProperty.
  static void SetProperty(vtkVoxelLineFrame& frame, vtkProperty* property);

  /**
   * All lights of the renderer that are switched on, in view coordinates, and the light model. The
   * frame is unlit where there is no light, as VTK's polygons are, and where the property's
   * lighting is off.
   */
  static bool SetLighting(vtkVoxelLineFrame& frame, vtkRenderer* renderer,
    vtkLineIllumination* illumination, vtkProperty* property);

  /// Whether two frames would give the same picture; the depth of the scene is not compared.
  static bool IsSamePicture(const vtkVoxelLineFrame& a, const vtkVoxelLineFrame& b);

  /**
   * Data coordinates of what lies at a pixel's centre at a depth (0 to 1) of a frame that
   * SetView() filled.
   */
  static void GetDataPosition(const vtkVoxelLineFrame& frame, const Grid& grid, int x, int y,
    double depth, double position[3]);
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineFrameBuilder.h
