// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineScene
 * @brief   what vtkVoxelLinePainter is to draw, apart from what renderer and actor tell
 *
 * With it comes what follows from it alone: where the tubes lie, how wide they are, and which
 * picture is the same as another one (vtkVoxelLinePictureKey).
 */

#ifndef vtkVoxelLineScene_h
#define vtkVoxelLineScene_h

#include "vtkVoxelLineFrame.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineViews.h"

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>

class vtkActor;
class vtkLineGlobalIllumination;
class vtkPolyData;
class vtkRenderWindow;
class vtkRenderer;
class vtkVoxelLineLightFields;
class vtkVoxelLineMapper;
class vtkVoxelLineModel;

struct vtkVoxelLineScene
{
  vtkVoxelLineMapper* Mapper = nullptr;
  vtkVoxelLineModel* Model = nullptr;
  /// The lines that the model was made of, where they are known.
  vtkPolyData* Input = nullptr;
  /// Largest radius, in units of the data.
  double Radius = 0.0;
  /// Smallest radius above 0, likewise.
  double SmallestRadius = 0.0;
  /// Whether direct colours of the model let something through.
  bool TranslucentColors = false;

  /// What may be not quite right in what was drawn.
  enum WarningKind
  {
    NoSceneDepth,      ///< the depth of the scene cannot be read
    OverlappingCurves, ///< the engine could not tell all curves in a pixel apart
    HugeRadius,        ///< the radius is far larger than all lines together
    NoPoints,          ///< points were to be selected in a model
    HugePixels,        ///< pixels are so large that rays miss tubes
    BadPower,          ///< the exponent of the property is not a number
    NoGlobalLight,     ///< shadows or occlusion are left out
    SofterShadows,     ///< other actors receive soft shadows in place of others
    SofterOcclusion,   ///< other actors receive occlusion by densities in place of tubes
    NothingReceived    ///< another actor receives nothing
  };
  using Warnings = std::map<WarningKind, std::string>;

  /// The tubes that are drawn.
  vtkVoxelLineViews::Tubes GetTubes(Warnings& warnings) const;

  /// Set the widths of the tubes in a frame with a view.
  void Widen(
    const vtkVoxelLineViews::Tubes& tubes, vtkVoxelLineFrame& frame, Warnings& warnings) const;

  /**
   * Bring up to date what shadows and occlusion of a frame are looked up in; the mapper tells the
   * progress, and what was aborted in an earlier frame begins anew, as an executive has it.
   */
  void UpdateLight(vtkVoxelLineLightFields& fields, vtkLineGlobalIllumination* illumination,
    vtkVoxelLineFrame& frame, Warnings& warnings) const;

  /// Whether every line of a frame is opaque, direct colours included.
  bool IsOpaque(const vtkVoxelLineFrame& frame) const;

private:
  vtkVoxelLineFrameBuilder::Grid GetGrid(Warnings& warnings) const;
};

/// All that a picture depends on except the depth of the scene.
struct vtkVoxelLinePictureKey
{
  bool Valid = false;
  vtkIdType FrameNumber = -1;
  // Weak: another object at the same address is not the same one.
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkActor> Actor;
  vtkWeakPointer<vtkVoxelLineModel> Model;
  vtkMTimeType ModelTime = 0;
  int Engine = 0;
  vtkVoxelLineFrame Frame;

  /// Whether both give the same picture, in whatever frames.
  bool IsSameInAnyFrame(const vtkVoxelLinePictureKey& other) const;

  /// Whether both give the same picture in the same frame.
  bool IsSame(const vtkVoxelLinePictureKey& other) const
  {
    return this->FrameNumber == other.FrameNumber && this->IsSameInAnyFrame(other);
  }
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineScene.h
