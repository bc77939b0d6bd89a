// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityView
 * @brief   a renderer's view as opacity optimization sees it: its depths, and whether it jumped
 */

#ifndef vtkFourierOpacityView_h
#define vtkFourierOpacityView_h

#include "vtkRenderingLineSetsModule.h" // For export macro

#include <vector>

class vtkActor;
class vtkRenderer;

struct VTKRENDERINGLINESETS_EXPORT vtkFourierOpacityView
{
  int Size[2] = { 0, 0 };
  bool IsParallel = false;
  /// Elements 22, 23, 32 and 33 of the projection, which make z of the device from z of the view.
  double Projection[4] = { 1.0, 0.0, 0.0, 1.0 };
  /// Distances from the camera, along its direction, between which all actors lie.
  double Range[2] = { 0.0, 1.0 };
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, -1.0 };
  double Angle = 30.0;
  double ParallelScale = 1.0;

  /// Take the view of a renderer and the depths of some actors in it.
  void Set(vtkRenderer* renderer, const std::vector<vtkActor*>& actors);

  /**
   * Whether another view follows this one by more than a movement: another size or kind of
   * projection, a turn by more than 20 degrees, a step of more than half the range of depths, or a
   * zoom by more than a half.
   */
  bool IsJump(const vtkFourierOpacityView& next) const;

  /// Whether another view is from the same place in the same direction, as tiles of it are.
  bool HasSameEye(const vtkFourierOpacityView& other) const;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityView.h
