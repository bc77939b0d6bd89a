// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineReceivers
 * @brief   the actors that receive the shadows and the occlusion of a vtkVoxelLineMapper's lines
 *
 * Each actor's mapper announces its draw by vtkCommand::StartEvent. Then the densities and the
 * occlusion are brought up to date and uploaded, and the code is put into the actor's shaders
 * (vtkVoxelLineReceiverShader), or taken out where there is nothing to receive. By
 * vtkCommand::UpdateShaderEvent the mapper lets uniforms be set. Neither event tells the renderer:
 * it is the one of those that the actor belongs to which is in a frame.
 *
 * Actors, mappers, renderers and windows may go at any time.
 */

#ifndef vtkVoxelLineReceivers_h
#define vtkVoxelLineReceivers_h

#include "vtkLineGlobalIllumination.h"
#include "vtkLineSetsFrameCounter.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkVoxelLineReceiverBuffers.h"
#include "vtkVoxelLineScene.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkActor;
class vtkMapper;
class vtkRenderer;
class vtkVoxelLineLightFields;

class vtkVoxelLineReceivers
{
public:
  using Warnings = vtkVoxelLineScene::Warnings;

  /// What the mapper of the lines does for its receivers.
  struct Caster
  {
    /// Bring the model up to date and describe it; false: there are no lines.
    std::function<bool(vtkVoxelLineScene&)> Describe;
    /// Where densities and occlusion are kept.
    vtkVoxelLineLightFields* Fields = nullptr;
    /// Say warnings, each once.
    std::function<void(const Warnings&)> Warn;
  };

  explicit vtkVoxelLineReceivers(Caster caster);
  ~vtkVoxelLineReceivers();

  /// Returns false where the actor receives from other receivers' lines.
  bool Add(vtkActor* actor);
  /// Returns whether it was there.
  bool Remove(vtkActor* actor);
  void RemoveAll();

  /// Of the actors that still live.
  int GetNumberOfReceivers() const;

  /// The actor that has drawn the lines.
  void SetDrawnBy(vtkActor* actor);

  /// Free the memory in a window; in all of them where it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

private:
  vtkVoxelLineReceivers(const vtkVoxelLineReceivers&) = delete;
  void operator=(const vtkVoxelLineReceivers&) = delete;

  class Receiver;

  void BeginDraw(Receiver& receiver);
  void Pause(Receiver& receiver);
  std::string Describe(
    Receiver& receiver, vtkRenderer* renderer, vtkVoxelLineFrame& frame, Warnings& warnings);
  /// The actor that has drawn the lines, or else the one that will; nullptr: none.
  vtkActor* FindDrawnBy(vtkMapper* mapper, vtkRenderer* renderer) const;
  void TakeIllumination(vtkLineGlobalIllumination* wanted, Warnings& warnings);
  vtkRenderer* FindRenderer(vtkActor* actor);
  vtkVoxelLineReceiverBuffers* GetBuffers(vtkOpenGLRenderWindow* window);
  void WatchEnd(vtkRenderer* renderer);

  // Never the same for two objects.
  vtkTimeStamp Number;
  Caster Lines;
  std::vector<std::unique_ptr<Receiver>> Receivers;
  std::vector<std::unique_ptr<vtkVoxelLineReceiverBuffers>> Buffers;
  vtkLineSetsFrameCounter Frames;
  vtkNew<vtkLineGlobalIllumination> Illumination;
  vtkWeakPointer<vtkActor> DrawnBy;
  // Where the lines are drawn by none.
  vtkSmartPointer<vtkActor> Nobody;

  struct Watched
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    unsigned long Tag = 0;
  };
  std::vector<Watched> Ends;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineReceivers.h
