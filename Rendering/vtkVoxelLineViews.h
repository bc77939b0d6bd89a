// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineViews
 * @brief   the views in which lines are drawn, and whether tubes are thinner than a pixel in one
 *
 * Thin tubes let through what is behind them, and must be drawn in the translucent pass then. A
 * mapper is asked for its pass without being told the view. So the views in which it was drawn are
 * remembered, and looked at as their cameras stand when it is asked. A view that is not known
 * yet, or in which an actor has moved, is found out when it is drawn in the opaque pass; it is then
 * left to the translucent pass of the same frame.
 *
 * Within a frame the answer changes from no to yes only, so that nothing is lost between passes.
 */

#ifndef vtkVoxelLineViews_h
#define vtkVoxelLineViews_h

#include "vtkVoxelLineFrameBuilder.h"

#include "vtkWeakPointer.h"

#include <array>
#include <vector>

class vtkActor;
class vtkLineSetsFrameCounter;
class vtkRenderer;

class vtkVoxelLineViews
{
public:
  /// The tubes that are drawn: their grid, with the largest radius as its margin, and the smallest
  /// radius above 0, in voxels.
  struct Tubes
  {
    vtkVoxelLineFrameBuilder::Grid Grid;
    double SmallestRadius = 0.0;
    double LargestWidening = 0.0; ///< as vtkVoxelLineFrameBuilder tells
  };

  /**
   * Take note of a view while it is drawn, with the size of the viewport in pixels. Returns whether
   * tubes are thinner than a pixel in it, and that was not known before in this frame.
   */
  bool FindThinTubes(vtkLineSetsFrameCounter& frames, vtkRenderer* renderer, vtkActor* actor,
    const int size[2], const Tubes& tubes);

  /// Whether tubes are thinner than a pixel in any of the views.
  bool HaveThinTubes(vtkLineSetsFrameCounter& frames, const Tubes& tubes);

private:
  struct View
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    // Where it was drawn last: an assembly changes its actors' matrices while it draws them.
    std::array<double, 16> WorldFromData{};
    // Of the viewport, per pixel of the renderer: a pass may draw into a larger picture.
    double Scale[2] = { 1.0, 1.0 };
    vtkIdType Frame = -1;
    bool IsDrawn = false;
    bool IsThin = false;
  };
  static bool Look(const View& view, const Tubes& tubes);
  static bool Decide(View& view, vtkLineSetsFrameCounter& frames, const Tubes& tubes);
  void Forget(vtkLineSetsFrameCounter& frames);

  std::vector<View> Views;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineViews.h
