// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLinePainter
 * @brief   the part of vtkVoxelLineMapper that deals with the graphics device
 *
 * For each frame of a renderer it describes the picture (vtkVoxelLineFrameBuilder,
 * vtkVoxelLineColoring), has one of the two engines cast the rays, and draws the result as one
 * layer (vtkLineSetsLayer). Where a render pass draws the prop again in the same frame, the picture
 * is replayed. For vtkHardwareSelector it draws numbers instead (vtkVoxelLineSelection).
 */

#ifndef vtkVoxelLinePainter_h
#define vtkVoxelLinePainter_h

#include "vtkLineSetsFrameCounter.h"
#include "vtkLineSetsLayer.h"
#include "vtkLineSetsSceneDepth.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineNativeEngine.h"
#include "vtkVoxelLineShaderEngine.h"
#include "vtkVoxelLineViews.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkActor;
class vtkHardwareSelector;
class vtkPolyData;
class vtkRenderer;
class vtkVoxelLineMapper;
class vtkVoxelLineModel;
class vtkWindow;

class vtkVoxelLinePainter
{
public:
  vtkVoxelLinePainter();
  ~vtkVoxelLinePainter();

  /// What to draw, apart from what mapper, renderer and actor tell.
  struct Scene
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
  };

  /// What may be not quite right in what was drawn.
  enum WarningKind
  {
    NoSceneDepth,      ///< the depth of the scene cannot be read
    OverlappingCurves, ///< the engine could not tell all curves in a pixel apart
    HugeRadius,        ///< the radius is far larger than all lines together
    NoPoints,          ///< points were to be selected in a model
    HugePixels,        ///< pixels are so large that rays miss tubes
    BadPower           ///< the exponent of the property is not a number
  };
  using Warnings = std::map<WarningKind, std::string>;

  /**
   * Draw into the active pass. Returns an empty string, or else why nothing was drawn; warnings are
   * added where something was drawn that is not quite right.
   */
  std::string Draw(const Scene& scene, vtkRenderer* renderer, vtkActor* actor, Warnings& warnings);

  /**
   * Whether a draw in the opaque pass is to be left to the translucent pass of the same frame:
   * where it turns out that tubes are thinner than a pixel in a view for which that was not known.
   */
  bool IsLeftToTranslucentPass(const Scene& scene, vtkRenderer* renderer, vtkActor* actor);

  /// Whether tubes are thinner than a pixel in a view in which the scene was drawn.
  bool HasThinTubes(const Scene& scene);

  /// vtkVoxelLineMapper::EngineType that would cast rays in a window.
  static int ChooseEngine(int engine, vtkOpenGLRenderWindow* window);

  /// vtkVoxelLineMapper::QualityType of pictures in a window.
  static int ChooseQuality(int quality, vtkRenderWindow* window);

  /// Quality of the last picture.
  int GetQualityInUse() const { return this->QualityInUse; }

  /// Engine of the last Draw().
  int GetEngineInUse() const { return this->EngineInUse; }

  /// Seconds that the last Draw() took, on the processor or, where longer, on the graphics device.
  double GetSeconds() const { return this->Seconds; }

  /// Number of pictures ray cast so far; replays and selections do not count.
  vtkIdType GetNumberOfPictures() const { return this->NumberOfPictures; }

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkVoxelLinePainter(const vtkVoxelLinePainter&) = delete;
  void operator=(const vtkVoxelLinePainter&) = delete;

  // A picture that can be drawn again.
  struct Cached
  {
    bool Valid = false;
    vtkIdType FrameNumber = -1;
    vtkRenderer* Renderer = nullptr;
    vtkActor* Actor = nullptr;
    vtkVoxelLineModel* Model = nullptr;
    vtkMTimeType ModelTime = 0;
    int Engine = 0;
    vtkVoxelLineFrame Frame;

    bool IsSame(const Cached& other) const;
  };

  void ReleaseTimer();
  static vtkVoxelLineViews::Tubes GetTubes(const Scene& scene, Warnings& warnings);
  static void Widen(const Scene& scene, const vtkVoxelLineViews::Tubes& tubes,
    vtkVoxelLineFrame& frame, Warnings& warnings);
  static vtkVoxelLineFrameBuilder::Grid GetGrid(const Scene& scene, Warnings& warnings);
  std::string DrawPicture(const Scene& scene, vtkRenderer* renderer, vtkActor* actor,
    vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings);
  std::string CastPicture(const Scene& scene, vtkRenderer* renderer, vtkOpenGLRenderWindow* window,
    const int viewport[4], Cached& wanted, Warnings& warnings);
  std::string DrawSelection(const Scene& scene, vtkRenderer* renderer, vtkActor* actor,
    vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings);
  std::string DrawNumbers(const Scene& scene, vtkHardwareSelector* selector, vtkActor* actor,
    vtkOpenGLRenderWindow* window, const int viewport[4],
    const vtkVoxelLineFrameBuilder::View& view);

  vtkLineSetsLayer Layer;
  vtkLineSetsSceneDepth SceneDepth;
  vtkLineSetsFrameCounter Frames;
  vtkVoxelLineViews Views;
  vtkVoxelLineShaderEngine ShaderEngine;
  vtkOpenGLRenderTimer Timer;
  vtkWeakPointer<vtkOpenGLRenderWindow> TimerWindow;

  Cached Last;
  Cached LastPick;
  vtkVoxelLinePicture Picture;
  vtkVoxelLinePicture PickPicture;
  std::vector<vtkIdType> PickPoints;
  std::vector<std::uint8_t> PickColors;

  int EngineInUse = 0;
  int QualityInUse = 0;
  double Seconds = 0.0;
  vtkIdType NumberOfPictures = 0;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLinePainter.h
