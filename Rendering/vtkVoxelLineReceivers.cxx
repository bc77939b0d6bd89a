// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineReceivers.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVoxelLineColoring.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineLightFields.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineReceiverShader.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include <algorithm>
#include <utility>

namespace
{
// An observer of this event tells that an actor is a receiver. Nobody invokes it.
constexpr unsigned long IsReceiver = vtkCommand::UserEvent + 7254901;

// The renderers that a prop is drawn by, directly or as a part of an assembly.
void FindRenderers(vtkProp* prop, std::vector<vtkRenderer*>& renderers)
{
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    vtkObject* consumer = prop->GetConsumer(i);
    if (auto* renderer = vtkRenderer::SafeDownCast(consumer))
    {
      renderers.push_back(renderer);
    }
    else if (auto* assembly = vtkProp::SafeDownCast(consumer))
    {
      FindRenderers(assembly, renderers);
    }
  }
}

// Whether a renderer, whose window is drawn to, has the viewport that is drawn to.
bool HasViewport(vtkRenderer* renderer)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int viewport[4] = { 0, 0, 0, 0 };
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  return viewport[0] == origin[0] && viewport[1] == origin[1] && viewport[2] == size[0] &&
    viewport[3] == size[1];
}
}

/// An actor, the mapper that draws it, and what is observed of them.
class vtkVoxelLineReceivers::Receiver
{
public:
  Receiver(vtkVoxelLineReceivers* owner, vtkActor* actor)
    : Shader(owner->Number.GetMTime())
    , Owner(owner)
    , Actor(actor)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* data, void* program)
      { static_cast<Receiver*>(data)->Notice(event, program); });
    this->ActorTags[0] = actor->AddObserver(vtkCommand::ModifiedEvent, this->Command);
    this->ActorTags[1] = actor->AddObserver(IsReceiver, this->Command);
    this->ActorTags[2] = actor->AddObserver(vtkCommand::DeleteEvent, this->Command);
    this->FollowMapper();
  }

  ~Receiver()
  {
    this->Leave();
    if (this->Actor)
    {
      for (const unsigned long tag : this->ActorTags)
      {
        this->Actor->RemoveObserver(tag);
      }
    }
    this->SetMapper(nullptr);
  }

  vtkActor* GetActor() const { return this->Actor; }

  /// Receive by the shader, with buffers, from now on. Returns an empty string, or else why not.
  std::string Receive(vtkVoxelLineReceiverBuffers* buffers)
  {
    vtkShaderProperty* property = this->Actor->GetShaderProperty();
    if (this->Property != property)
    {
      this->Leave();
      this->Property = property;
    }
    std::string error = this->Shader.Install(property);
    this->Buffers = error.empty() ? buffers : nullptr;
    return error;
  }

  /// Set nothing in the draw under way: another actor with the same mapper is drawn.
  void Pause() { this->Buffers = nullptr; }

  /// Receive nothing, by shaders that are as they were.
  void Leave()
  {
    if (this->Property)
    {
      this->Shader.Remove(this->Property);
    }
    this->Property = nullptr;
    this->Buffers = nullptr;
  }

  void ForgetBuffers(vtkVoxelLineReceiverBuffers* buffers)
  {
    this->Buffers = this->Buffers == buffers ? nullptr : this->Buffers;
  }

  vtkVoxelLineReceiverShader Shader;

private:
  void Notice(unsigned long event, void* program)
  {
    if (event == vtkCommand::ModifiedEvent)
    {
      this->FollowMapper();
    }
    else if (event == vtkCommand::DeleteEvent)
    {
      // Deletes this, too.
      this->Owner->Remove(this->Actor);
    }
    else if (event == vtkCommand::StartEvent)
    {
      this->Owner->BeginDraw(*this);
    }
    else if (event == vtkCommand::UpdateShaderEvent)
    {
      auto* shader = static_cast<vtkShaderProgram*>(program);
      if (this->Buffers && this->Shader.IsUsed(shader))
      {
        this->Shader.SetUniforms(shader);
        this->Buffers->Activate(shader);
      }
    }
  }

  void FollowMapper() { this->SetMapper(this->Actor->GetMapper()); }

  void SetMapper(vtkMapper* mapper)
  {
    if (this->Mapper == mapper)
    {
      return;
    }
    if (this->Mapper)
    {
      this->Mapper->RemoveObserver(this->MapperTags[0]);
      this->Mapper->RemoveObserver(this->MapperTags[1]);
    }
    this->Mapper = mapper;
    if (mapper)
    {
      this->MapperTags[0] = mapper->AddObserver(vtkCommand::StartEvent, this->Command);
      this->MapperTags[1] = mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
    }
  }

  vtkVoxelLineReceivers* Owner;
  vtkNew<vtkCallbackCommand> Command;
  vtkWeakPointer<vtkActor> Actor;
  vtkWeakPointer<vtkMapper> Mapper;
  // Into which the code has been put.
  vtkWeakPointer<vtkShaderProperty> Property;
  vtkVoxelLineReceiverBuffers* Buffers = nullptr;
  unsigned long ActorTags[3] = { 0, 0, 0 };
  unsigned long MapperTags[2] = { 0, 0 };
};

//------------------------------------------------------------------------------
vtkVoxelLineReceivers::vtkVoxelLineReceivers(Caster caster)
  : Lines(std::move(caster))
  , Nobody(vtkSmartPointer<vtkActor>::New())
{
  this->Number.Modified();
}

//------------------------------------------------------------------------------
vtkVoxelLineReceivers::~vtkVoxelLineReceivers()
{
  this->RemoveAll();
  for (const Watched& watched : this->Ends)
  {
    if (watched.Renderer)
    {
      watched.Renderer->RemoveObserver(watched.Tag);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineReceivers::Add(vtkActor* actor)
{
  const auto isIt = [actor](const std::unique_ptr<Receiver>& receiver)
  { return receiver->GetActor() == actor; };
  if (std::any_of(this->Receivers.begin(), this->Receivers.end(), isIt))
  {
    return true;
  }
  if (actor->HasObserver(IsReceiver))
  {
    return false;
  }
  this->Receivers.push_back(std::make_unique<Receiver>(this, actor));
  // From now on it is known which of its renderers is in a frame.
  std::vector<vtkRenderer*> renderers;
  FindRenderers(actor, renderers);
  for (vtkRenderer* renderer : renderers)
  {
    this->Frames.GetFrame(renderer);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineReceivers::Remove(vtkActor* actor)
{
  const auto found = std::find_if(this->Receivers.begin(), this->Receivers.end(),
    [actor](const std::unique_ptr<Receiver>& receiver) { return receiver->GetActor() == actor; });
  if (found == this->Receivers.end())
  {
    return false;
  }
  this->Receivers.erase(found);
  if (this->GetNumberOfReceivers() == 0)
  {
    this->ReleaseGraphicsResources(nullptr);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::RemoveAll()
{
  this->Receivers.clear();
  this->ReleaseGraphicsResources(nullptr);
}

//------------------------------------------------------------------------------
int vtkVoxelLineReceivers::GetNumberOfReceivers() const
{
  return static_cast<int>(std::count_if(this->Receivers.begin(), this->Receivers.end(),
    [](const std::unique_ptr<Receiver>& receiver) { return receiver->GetActor() != nullptr; }));
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::SetDrawnBy(vtkActor* actor)
{
  this->DrawnBy = actor;
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::ReleaseGraphicsResources(vtkWindow* window)
{
  const auto goes = [this, window](const std::unique_ptr<vtkVoxelLineReceiverBuffers>& buffers)
  {
    const bool isIt = !window || !buffers->GetWindow() || buffers->GetWindow() == window;
    for (const auto& receiver : this->Receivers)
    {
      if (isIt)
      {
        receiver->ForgetBuffers(buffers.get());
      }
    }
    return isIt;
  };
  this->Buffers.erase(
    std::remove_if(this->Buffers.begin(), this->Buffers.end(), goes), this->Buffers.end());
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLineReceivers::GetNumberOfBytes() const
{
  vtkIdType bytes = 0;
  for (const auto& buffers : this->Buffers)
  {
    bytes += buffers->GetNumberOfBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkVoxelLineReceivers::FindRenderer(vtkActor* actor)
{
  std::vector<vtkRenderer*> renderers;
  FindRenderers(actor, renderers);
  const auto isIdle = [this](vtkRenderer* renderer)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    return !window || !window->IsCurrent() || !this->Frames.IsInFrame(renderer);
  };
  renderers.erase(std::remove_if(renderers.begin(), renderers.end(), isIdle), renderers.end());
  // More than one only before they are known: all of them pass for being in a frame then.
  const auto found = std::find_if(renderers.begin(), renderers.end(), HasViewport);
  return found != renderers.end() ? *found : renderers.empty() ? nullptr : renderers.front();
}

//------------------------------------------------------------------------------
vtkVoxelLineReceiverBuffers* vtkVoxelLineReceivers::GetBuffers(vtkOpenGLRenderWindow* window)
{
  for (const auto& buffers : this->Buffers)
  {
    if (buffers->GetWindow() == window && !buffers->IsGone())
    {
      return buffers.get();
    }
  }
  // Also what is left of windows that are gone.
  this->ReleaseGraphicsResources(window);
  this->Buffers.push_back(std::make_unique<vtkVoxelLineReceiverBuffers>(window));
  return this->Buffers.back().get();
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::WatchEnd(vtkRenderer* renderer)
{
  const auto isGone = [](const Watched& watched) { return !watched.Renderer; };
  this->Ends.erase(std::remove_if(this->Ends.begin(), this->Ends.end(), isGone), this->Ends.end());
  const auto isIt = [renderer](const Watched& watched) { return watched.Renderer == renderer; };
  if (std::any_of(this->Ends.begin(), this->Ends.end(), isIt))
  {
    return;
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      vtkWindow* window = static_cast<vtkRenderer*>(caller)->GetRenderWindow();
      for (const auto& buffers : static_cast<vtkVoxelLineReceivers*>(data)->Buffers)
      {
        if (buffers->GetWindow() == window)
        {
          buffers->Deactivate();
        }
      }
    });
  this->Ends.push_back({ renderer, renderer->AddObserver(vtkCommand::EndEvent, command) });
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::TakeIllumination(vtkLineGlobalIllumination* wanted, Warnings& warnings)
{
  using Types = vtkLineGlobalIllumination;
  const int shadows = wanted->GetShadows();
  const int occlusion = wanted->GetOcclusion();
  const bool areHard = shadows == Types::HardShadows || shadows == Types::LevelShadows;
  this->Illumination->SetShadows(areHard ? static_cast<int>(Types::SoftShadows) : shadows);
  this->Illumination->SetShadowConeAngle(wanted->GetShadowConeAngle());
  const bool byTubes = occlusion == Types::HemisphereTubes;
  this->Illumination->SetOcclusion(
    byTubes ? static_cast<int>(Types::HemisphereDensity) : occlusion);
  this->Illumination->SetOcclusionRadius(wanted->GetOcclusionRadius());
  this->Illumination->SetOcclusionSamples(wanted->GetOcclusionSamples());
  this->Illumination->SetOcclusionStrength(wanted->GetOcclusionStrength());
  if (areHard)
  {
    warnings[vtkVoxelLineScene::SofterShadows] =
      "Other actors cannot receive hard shadows or those of a level; they receive soft ones.";
  }
  if (byTubes)
  {
    warnings[vtkVoxelLineScene::SofterOcclusion] =
      "Other actors cannot receive occlusion of the hemisphere by tubes; they receive that by "
      "densities.";
  }
}

//------------------------------------------------------------------------------
vtkActor* vtkVoxelLineReceivers::FindDrawnBy(vtkMapper* mapper, vtkRenderer* renderer) const
{
  if (this->DrawnBy)
  {
    return this->DrawnBy;
  }
  // Not drawn yet. The receiver's renderer is looked at first, and visible actors before others.
  std::vector<vtkRenderer*> renderers = { renderer };
  vtkRendererCollection* all = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator cookie;
  all->InitTraversal(cookie);
  while (vtkRenderer* other = all->GetNextRenderer(cookie))
  {
    renderers.push_back(other);
  }
  vtkActor* hidden = nullptr;
  for (vtkRenderer* each : renderers)
  {
    vtkNew<vtkPropCollection> parts;
    vtkPropCollection* props = each->GetViewProps();
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      prop->GetActors(parts);
    }
    parts->InitTraversal(cookie);
    while (vtkProp* part = parts->GetNextProp(cookie))
    {
      auto* actor = vtkActor::SafeDownCast(part);
      if (actor && actor->GetMapper() == mapper)
      {
        if (actor->GetVisibility())
        {
          return actor;
        }
        hidden = hidden ? hidden : actor;
      }
    }
  }
  return hidden;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineReceivers::Describe(
  Receiver& receiver, vtkRenderer* renderer, vtkVoxelLineFrame& frame, Warnings& warnings)
{
  vtkVoxelLineScene scene;
  vtkActor* actor = receiver.GetActor();
  if (!actor->GetProperty()->GetLighting() || !this->Lines.Describe(scene))
  {
    return {};
  }
  this->TakeIllumination(scene.Mapper->GetGlobalIllumination(), warnings);
  if (this->Illumination->GetShadows() == vtkLineGlobalIllumination::NoShadows &&
    this->Illumination->GetOcclusion() == vtkLineGlobalIllumination::NoOcclusion)
  {
    return {};
  }
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  // An executing pipeline may have made another context current.
  window->MakeCurrent();
  int viewport[4] = { 0, 0, 0, 0 };
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] <= 0 || viewport[3] <= 0)
  {
    return {};
  }
  vtkActor* drawnBy = this->FindDrawnBy(scene.Mapper, renderer);
  Warnings ignored; // a picture of the lines tells them
  const vtkVoxelLineViews::Tubes tubes = scene.GetTubes(ignored);
  const vtkVoxelLineFrameBuilder::View view = vtkVoxelLineFrameBuilder::GetView(
    renderer, drawnBy ? drawnBy : this->Nobody.Get(), viewport[2], viewport[3]);
  std::string error = vtkVoxelLineFrameBuilder::SetView(frame, view, tubes.Grid);
  if (!error.empty())
  {
    return error;
  }
  vtkProperty* property = (drawnBy ? drawnBy : actor)->GetProperty();
  vtkVoxelLineFrameBuilder::SetProperty(frame, property);
  vtkVoxelLineFrameBuilder::SetLighting(
    frame, renderer, scene.Mapper->GetIllumination(), actor->GetProperty());
  vtkVoxelLineColoring::SetColors(frame, scene.Mapper, scene.Model);
  frame.Radius = static_cast<float>(tubes.Grid.Margin);
  scene.UpdateLight(*this->Lines.Fields, this->Illumination, frame, warnings);
  if (frame.Global.Shadows == 0 && frame.Global.Occlusion == 0)
  {
    return {};
  }
  vtkVoxelLineReceiverBuffers* buffers = this->GetBuffers(window);
  error = buffers->Upload(scene.Model, frame.Global);
  if (error.empty())
  {
    receiver.Shader.SetFrame(frame, view, tubes.Grid, viewport);
    this->WatchEnd(renderer);
    error = receiver.Receive(buffers);
  }
  return error;
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::Pause(Receiver& receiver)
{
  // Another receiver with the same mapper is drawn, even by the same shaders: the code stays.
  const auto isDrawn = [this, &receiver](const std::unique_ptr<Receiver>& other)
  {
    vtkActor* actor = other->GetActor();
    return actor && receiver.GetActor() && other.get() != &receiver &&
      actor->GetMapper() == receiver.GetActor()->GetMapper() && this->FindRenderer(actor);
  };
  if (std::any_of(this->Receivers.begin(), this->Receivers.end(), isDrawn))
  {
    receiver.Pause();
  }
  else
  {
    // An actor may be drawn where its renderer is not known; code without uniforms would fail.
    receiver.Leave();
  }
}

//------------------------------------------------------------------------------
void vtkVoxelLineReceivers::BeginDraw(Receiver& receiver)
{
  vtkActor* actor = receiver.GetActor();
  // A mapper that was set later may be one that receives nothing, or even the caster itself, which
  // would ask itself for its model without end.
  if (actor && vtkVoxelLineMapper::SafeDownCast(actor->GetMapper()))
  {
    receiver.Leave();
    return;
  }
  vtkRenderer* renderer = actor ? this->FindRenderer(actor) : nullptr;
  if (!renderer)
  {
    this->Pause(receiver);
    return;
  }
  Warnings warnings;
  vtkVoxelLineFrame frame;
  const std::string error = this->Describe(receiver, renderer, frame, warnings);
  if (!error.empty())
  {
    warnings[vtkVoxelLineScene::NothingReceived] =
      "An actor receives no shadows and no occlusion: " + error;
  }
  if (!error.empty() || (frame.Global.Shadows == 0 && frame.Global.Occlusion == 0))
  {
    receiver.Leave();
  }
  this->Lines.Warn(warnings);
}
