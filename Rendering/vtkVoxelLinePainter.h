// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLinePainter
 * @brief   the part of vtkVoxelLineMapper that deals with the graphics device
 *
 * For each frame of a renderer it describes the picture (vtkVoxelLineFrameBuilder,
 * vtkVoxelLineColoring), has one of the two engines cast the rays, and draws the result as one
 * layer (vtkLineSetsLayer). Where a render pass draws the prop again in the same frame, the picture
 * is replayed. For vtkHardwareSelector it draws numbers instead (vtkVoxelLineSelectionPainter).
 *
 * Where the mapper accumulates and a frame shows the same as the one before, one more picture is
 * cast with shifted rays, and the mean of all is drawn (vtkVoxelLineAccumulator). At the edges of
 * lines the mean is translucent even where all lines are opaque, so that it belongs into the
 * translucent pass. That the camera rests turns out when the picture is described, that is in
 * the opaque pass: the draw is then left to the translucent pass of the same frame, for which VTK
 * asks the mapper again.
 */

#ifndef vtkVoxelLinePainter_h
#define vtkVoxelLinePainter_h

#include "vtkLineSetsFrameCounter.h"
#include "vtkLineSetsLayer.h"
#include "vtkLineSetsSceneDepth.h"
#include "vtkVoxelLineAccumulator.h"
#include "vtkVoxelLineLightFields.h"
#include "vtkVoxelLineNativeEngine.h"
#include "vtkVoxelLineScene.h"
#include "vtkVoxelLineSelectionPainter.h"
#include "vtkVoxelLineShaderEngine.h"
#include "vtkVoxelLineViews.h"

#include "vtkOpenGLRenderTimer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

class vtkVoxelLinePainter
{
public:
  vtkVoxelLinePainter();
  ~vtkVoxelLinePainter();

  using Scene = vtkVoxelLineScene;
  using Warnings = vtkVoxelLineScene::Warnings;

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

  /// Whether a mean of opaque lines was left to the translucent pass of the frame under way.
  bool HasLeftOpaquePass();

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

  /// Seconds spent on what shadows and ambient occlusion are looked up in, the last time.
  double GetLightBuildTime() const { return this->LightFields.GetBuildTime(); }

  /// Number of pictures whose mean was drawn last; 0 where nothing was drawn.
  int GetNumberOfAccumulatedPictures() const;

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

  /// What shadows and occlusion are looked up in, also by other actors.
  vtkVoxelLineLightFields* GetLightFields() { return &this->LightFields; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkVoxelLinePainter(const vtkVoxelLinePainter&) = delete;
  void operator=(const vtkVoxelLinePainter&) = delete;

  void ReleaseTimer();
  static std::string Describe(vtkVoxelLinePictureKey& wanted, const Scene& scene,
    vtkRenderer* renderer, vtkActor* actor, const int viewport[4], Warnings& warnings);
  std::string DrawPicture(const Scene& scene, vtkRenderer* renderer, vtkActor* actor,
    vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings);
  std::string MakePicture(const Scene& scene, vtkRenderer* renderer, vtkOpenGLRenderWindow* window,
    const int viewport[4], vtkVoxelLinePictureKey& wanted, Warnings& warnings);
  std::string AddPicture(const Scene& scene, vtkOpenGLRenderWindow* window,
    vtkVoxelLinePictureKey& wanted, Warnings& warnings);
  std::string CastPicture(const Scene& scene, vtkOpenGLRenderWindow* window, int engine,
    const vtkVoxelLineFrame& frame, Warnings& warnings);
  std::string ShowPicture(vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame,
    const vtkVoxelLinePicture& picture);
  bool CanAdd(const Scene& scene, const vtkVoxelLinePictureKey& wanted) const;
  bool LeaveToTranslucentPass(
    const Scene& scene, vtkActor* actor, const vtkVoxelLinePictureKey& wanted);
  bool CopySceneDepth(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const int viewport[4],
    vtkVoxelLinePictureKey& wanted);
  void ReadPicture(int engine);

  vtkLineSetsLayer Layer;
  vtkLineSetsSceneDepth SceneDepth;
  vtkLineSetsFrameCounter Frames;
  vtkVoxelLineViews Views;
  vtkVoxelLineLightFields LightFields;
  vtkVoxelLineShaderEngine ShaderEngine;
  vtkOpenGLRenderTimer Timer;
  vtkWeakPointer<vtkOpenGLRenderWindow> TimerWindow;

  vtkVoxelLineSelectionPainter Selection;

  // What is drawn, and the last picture of the engine where it lies on the processor.
  vtkVoxelLinePictureKey Last;
  vtkVoxelLinePicture Picture;

  // Depth of the scene for the shader engine, from the last picture on; null where there is none.
  vtkTextureObject* SceneTexture = nullptr;

  // Empty before a picture is drawn a second time.
  vtkVoxelLineAccumulator Accumulator;
  // The frame in which opaque lines were left to the translucent pass, and its renderer.
  vtkIdType LeftFrame = -1;
  vtkWeakPointer<vtkRenderer> LeftRenderer;
  bool IsCollected = true;

  int EngineInUse = 0;
  int QualityInUse = 0;
  double Seconds = 0.0;
  vtkIdType NumberOfPictures = 0;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLinePainter.h
