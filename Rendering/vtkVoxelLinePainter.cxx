// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinePainter.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkVoxelLineColoring.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace
{
// An early end that no sum of opacities reaches: rays end behind opaque lines only.
constexpr float NeverEarly = 2.0f;

// Frames per second from which on a window is taken to be interacted with: VTK's interactor asks
// for 15 while something moves, ParaView for 5, and for far below 1 at rest.
constexpr double InteractiveRate = 1.0;

bool IsSoftwareRenderer(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* part : { "llvmpipe", "softpipe", "swr", "swrast", "swiftshader",
         "software rasterizer", "software renderer", "gdi generic", "microsoft basic render" })
  {
    if (name.find(part) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

// One value per texel and component, row by row from the bottom.
void ReadTexture(vtkTextureObject* texture, unsigned int format, unsigned int type, void* values)
{
  texture->Activate();
  glGetTexImage(GL_TEXTURE_2D, 0, format, type, values);
  texture->Deactivate();
}
}

//------------------------------------------------------------------------------
vtkVoxelLinePainter::vtkVoxelLinePainter() = default;

//------------------------------------------------------------------------------
vtkVoxelLinePainter::~vtkVoxelLinePainter()
{
  this->ReleaseTimer();
}

//------------------------------------------------------------------------------
int vtkVoxelLinePainter::ChooseEngine(int engine, vtkOpenGLRenderWindow* window)
{
  if (engine != vtkVoxelLineMapper::Automatic)
  {
    return engine;
  }
  window->MakeCurrent();
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return IsSoftwareRenderer(name ? name : "") ? vtkVoxelLineMapper::Native
                                              : vtkVoxelLineMapper::Shader;
}

//------------------------------------------------------------------------------
int vtkVoxelLinePainter::ChooseQuality(int quality, vtkRenderWindow* window)
{
  if (quality != vtkVoxelLineMapper::AutomaticQuality)
  {
    return quality;
  }
  return window->GetDesiredUpdateRate() >= InteractiveRate ? vtkVoxelLineMapper::InteractiveQuality
                                                           : vtkVoxelLineMapper::StillQuality;
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::IsLeftToTranslucentPass(
  const Scene& scene, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !scene.Mapper->GetSubPixelCoverage() || renderer->GetSelector())
  {
    return false;
  }
  int viewport[4] = { 0, 0, 0, 0 };
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  Warnings ignored; // a picture tells them
  const bool found =
    this->Views.FindThinTubes(this->Frames, renderer, actor, viewport + 2, scene.GetTubes(ignored));
  return found && !actor->IsRenderingTranslucentPolygonalGeometry() && !actor->GetForceOpaque();
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::HasThinTubes(const Scene& scene)
{
  Warnings ignored; // a picture tells them
  return scene.Mapper->GetSubPixelCoverage() &&
    this->Views.HaveThinTubes(this->Frames, scene.GetTubes(ignored));
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::Draw(
  const Scene& scene, vtkRenderer* renderer, vtkActor* actor, Warnings& warnings)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "an OpenGL render window is needed";
  }
  const double start = vtkTimerLog::GetUniversalTime();
  // The viewport of the framebuffer that is drawn to, which a pass may have made its own.
  int viewport[4] = { 0, 0, 0, 0 };
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  std::string error;
  if (viewport[2] > 0 && viewport[3] > 0 && size[0] > 0 && size[1] > 0)
  {
    error = renderer->GetSelector()
      ? this->Selection.Draw(scene, renderer, actor, window, viewport, warnings)
      : this->DrawPicture(scene, renderer, actor, window, viewport, warnings);
  }
  // Never 0, which VTK takes for "not drawn yet".
  this->Seconds = std::max(vtkTimerLog::GetUniversalTime() - start, 1e-4);
  if (this->EngineInUse == vtkVoxelLineMapper::Shader)
  {
    this->Seconds =
      std::max(this->Seconds, static_cast<double>(this->Timer.GetReusableElapsedSeconds()));
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::Describe(vtkVoxelLinePictureKey& wanted, const Scene& scene,
  vtkRenderer* renderer, vtkActor* actor, const int viewport[4], Warnings& warnings)
{
  wanted.Valid = true;
  wanted.Window = renderer->GetRenderWindow();
  wanted.Renderer = renderer;
  wanted.Actor = actor;
  wanted.Model = scene.Model;
  wanted.ModelTime = scene.Model->GetMTime();

  const vtkVoxelLineViews::Tubes tubes = scene.GetTubes(warnings);
  const vtkVoxelLineFrameBuilder::Grid& grid = tubes.Grid;
  const vtkVoxelLineFrameBuilder::View view =
    vtkVoxelLineFrameBuilder::GetView(renderer, actor, viewport[2], viewport[3]);
  vtkVoxelLineFrame& frame = wanted.Frame;
  std::string error = vtkVoxelLineFrameBuilder::SetView(frame, view, grid);
  if (!error.empty())
  {
    return error;
  }
  vtkVoxelLineFrameBuilder::SetClippingPlanes(frame, scene.Mapper->GetClippingPlanes(), view, grid);
  vtkVoxelLineFrameBuilder::SetRegion(frame, scene.Mapper->GetRegion(), view, grid);
  vtkVoxelLineFrameBuilder::SetProperty(frame, actor->GetProperty());
  if (!vtkVoxelLineFrameBuilder::SetLighting(
        frame, renderer, scene.Mapper->GetIllumination(), actor->GetProperty()))
  {
    warnings[Scene::BadPower] =
      "The property's SpecularPower is not a number from 0 on; 1 is taken.";
  }
  vtkVoxelLineColoring::SetColors(frame, scene.Mapper, scene.Model);
  scene.Widen(tubes, frame, warnings);
  frame.Interactive = ChooseQuality(scene.Mapper->GetQuality(), renderer->GetRenderWindow()) ==
    vtkVoxelLineMapper::InteractiveQuality;
  frame.OpacityByPathLength = scene.Mapper->GetOpacityByPathLength();
  const double early = scene.Mapper->GetEarlyTermination();
  frame.EarlyTermination = early < 1.0 ? static_cast<float>(early) : NeverEarly;
  const double accelerated = scene.Mapper->GetOpacityAcceleration();
  frame.AccelerationOpacity = accelerated < 1.0 ? static_cast<float>(accelerated) : NeverEarly;
  return {};
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::DrawPicture(const Scene& scene, vtkRenderer* renderer,
  vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings)
{
  vtkVoxelLinePictureKey wanted;
  wanted.FrameNumber = this->Frames.GetFrame(renderer);
  wanted.Engine = ChooseEngine(scene.Mapper->GetEngine(), window);
  this->EngineInUse = wanted.Engine;
  std::string error = Describe(wanted, scene, renderer, actor, viewport, warnings);
  if (!error.empty())
  {
    return error;
  }
  scene.UpdateLight(
    this->LightFields, scene.Mapper->GetGlobalIllumination(), wanted.Frame, warnings);
  this->QualityInUse = wanted.Frame.Interactive ? vtkVoxelLineMapper::InteractiveQuality
                                                : vtkVoxelLineMapper::StillQuality;
  this->IsCollected = this->IsCollected ||
    (this->LeftFrame == wanted.FrameNumber && actor->IsRenderingTranslucentPolygonalGeometry());
  if (!this->Last.IsSame(wanted))
  {
    if (this->CanAdd(scene, wanted) && this->LeaveToTranslucentPass(scene, actor, wanted))
    {
      return {};
    }
    error = this->MakePicture(scene, renderer, window, viewport, wanted, warnings);
    if (!error.empty())
    {
      this->Last.Valid = false;
      return error;
    }
    this->Last = std::move(wanted);
  }
  return this->Layer.Draw(window, scene.Mapper, actor, viewport[0], viewport[1]);
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::CanAdd(const Scene& scene, const vtkVoxelLinePictureKey& wanted) const
{
  const int frames = scene.Mapper->GetAccumulationFrames();
  return frames > 1 && this->Accumulator.GetNumberOfPictures() <= frames &&
    this->Layer.HasPicture() && this->Last.IsSameInAnyFrame(wanted);
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::LeaveToTranslucentPass(
  const Scene& scene, vtkActor* actor, const vtkVoxelLinePictureKey& wanted)
{
  // Where what was left in an earlier frame was not asked for, there is no translucent pass.
  const bool isInVain = !this->IsCollected && this->LeftRenderer == wanted.Renderer &&
    this->LeftFrame != wanted.FrameNumber;
  // Translucent lines are drawn in that pass already.
  if (isInVain || this->LeftFrame == wanted.FrameNumber ||
    actor->IsRenderingTranslucentPolygonalGeometry() || actor->GetForceOpaque() ||
    actor->GetForceTranslucent() || wanted.Frame.Opacity < 1.0f ||
    scene.Mapper->HasTranslucentPolygonalGeometry())
  {
    return false;
  }
  this->LeftFrame = wanted.FrameNumber;
  this->LeftRenderer = wanted.Renderer;
  this->IsCollected = false;
  return true;
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::HasLeftOpaquePass()
{
  return this->LeftFrame >= 0 && this->LeftRenderer && this->Frames.IsInFrame(this->LeftRenderer) &&
    this->Frames.GetFrame(this->LeftRenderer) == this->LeftFrame;
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::CopySceneDepth(vtkRenderer* renderer, vtkOpenGLRenderWindow* window,
  const int viewport[4], vtkVoxelLinePictureKey& wanted)
{
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  int readOrigin[2];
  vtkLineSetsSceneDepth::GetReadOrigin(window, viewport, origin, readOrigin);
  vtkVoxelLineFrame& frame = wanted.Frame;
  if (wanted.Engine == vtkVoxelLineMapper::Shader)
  {
    this->SceneTexture = this->SceneDepth.Copy(window, readOrigin, frame.Width, frame.Height);
    return this->SceneTexture != nullptr;
  }
  return this->SceneDepth.Read(window, readOrigin, frame.Width, frame.Height, frame.SceneDepth);
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::MakePicture(const Scene& scene, vtkRenderer* renderer,
  vtkOpenGLRenderWindow* window, const int viewport[4], vtkVoxelLinePictureKey& wanted,
  Warnings& warnings)
{
  vtkVoxelLineFrame& frame = wanted.Frame;
  const bool shader = wanted.Engine == vtkVoxelLineMapper::Shader;
  // Opaque lines need no depth of the scene: the final draw is tested against it, and a line behind
  // it hides nothing that is seen. Their mean needs it.
  const bool opaque = scene.IsOpaque(frame);
  const bool adds = this->CanAdd(scene, wanted);
  if (adds && shader && !opaque && this->Accumulator.GetNumberOfPictures() == 0)
  {
    // That of the first picture.
    this->Accumulator.TakeScene(this->SceneDepth.Download(this->SceneTexture));
  }
  this->SceneTexture = nullptr;
  if ((adds || !opaque) && !this->CopySceneDepth(renderer, window, viewport, wanted) && !opaque)
  {
    warnings[Scene::NoSceneDepth] =
      "The depth of the scene cannot be read from the framebuffer; translucent "
      "lines in front of opaque actors may hide them too much.";
  }
  if (adds &&
    this->Accumulator.IsSameScene(
      shader ? this->SceneDepth.Download(this->SceneTexture) : frame.SceneDepth))
  {
    return this->AddPicture(scene, window, wanted, warnings);
  }

  this->Accumulator.Clear();
  if (opaque)
  {
    // The picture may be the first one of a mean with another depth of the scene.
    frame.SceneDepth.clear();
  }
  const std::string error = this->CastPicture(scene, window, wanted.Engine, frame, warnings);
  if (error.empty() && !shader && !opaque && scene.Mapper->GetAccumulationFrames() > 1)
  {
    this->Accumulator.TakeScene(std::move(frame.SceneDepth));
  }
  // Read by nobody any more, and large.
  frame.SceneDepth = std::vector<float>();
  if (!error.empty())
  {
    return error;
  }
  if (shader)
  {
    this->Layer.SetTextures(
      this->ShaderEngine.GetColorTexture(), this->ShaderEngine.GetDepthTexture());
    return {};
  }
  return this->ShowPicture(window, frame, this->Picture);
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::AddPicture(const Scene& scene, vtkOpenGLRenderWindow* window,
  vtkVoxelLinePictureKey& wanted, Warnings& warnings)
{
  if (this->Accumulator.GetNumberOfPictures() == 0)
  {
    this->ReadPicture(wanted.Engine);
    this->Accumulator.Add(this->Picture);
  }
  const int number = this->Accumulator.GetNumberOfPictures();
  if (number >= scene.Mapper->GetAccumulationFrames())
  {
    return {};
  }
  vtkVoxelLineFrame shifted = wanted.Frame;
  vtkVoxelLineAccumulator::Shift(shifted, number);
  const std::string error = this->CastPicture(scene, window, wanted.Engine, shifted, warnings);
  if (!error.empty())
  {
    return error;
  }
  this->ReadPicture(wanted.Engine);
  this->Accumulator.Add(this->Picture);
  vtkVoxelLinePicture mean;
  this->Accumulator.GetMean(mean);
  return this->ShowPicture(window, shifted, mean);
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::CastPicture(const Scene& scene, vtkOpenGLRenderWindow* window,
  int engine, const vtkVoxelLineFrame& frame, Warnings& warnings)
{
  ++this->NumberOfPictures;
  vtkIdType overflows = 0;
  if (engine == vtkVoxelLineMapper::Shader)
  {
    if (this->TimerWindow != window)
    {
      this->ReleaseTimer();
      window->MakeCurrent();
      this->TimerWindow = window;
    }
    this->Timer.ReusableStart();
    const bool done = this->ShaderEngine.Render(window, scene.Model, frame,
      scene.IsOpaque(frame) ? nullptr : this->SceneTexture, this->LightFields.GetLevelModel());
    this->Timer.ReusableStop();
    if (!done)
    {
      return this->ShaderEngine.GetError();
    }
    overflows = this->ShaderEngine.GetNumberOfOverflows();
  }
  else
  {
    vtkVoxelLineNativeEngine::Render(
      scene.Model, frame, this->Picture, this->LightFields.GetLevelModel());
    overflows = this->Picture.NumberOfOverflows;
  }
  if (overflows > 0)
  {
    warnings[Scene::OverlappingCurves] = "In " + std::to_string(overflows) +
      " pixels more lines overlap than can be told apart, so that some may be blended twice at a "
      "joint; a smaller radius or a higher resolution avoids it.";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkVoxelLinePainter::ReadPicture(int engine)
{
  if (engine == vtkVoxelLineMapper::Shader)
  {
    vtkTextureObject* color = this->ShaderEngine.GetColorTexture();
    const std::size_t pixels = static_cast<std::size_t>(color->GetWidth()) * color->GetHeight();
    this->Picture.Color.resize(4 * pixels);
    this->Picture.Depth.resize(pixels);
    ReadTexture(color, GL_RGBA, GL_UNSIGNED_BYTE, this->Picture.Color.data());
    ReadTexture(this->ShaderEngine.GetDepthTexture(), GL_RED, GL_FLOAT, this->Picture.Depth.data());
  }
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::ShowPicture(
  vtkOpenGLRenderWindow* window, const vtkVoxelLineFrame& frame, const vtkVoxelLinePicture& picture)
{
  return this->Layer.SetPicture(
           window, frame.Width, frame.Height, picture.Color.data(), picture.Depth.data())
    ? std::string()
    : "there is not enough graphics memory for a picture of the size of the viewport";
}

//------------------------------------------------------------------------------
int vtkVoxelLinePainter::GetNumberOfAccumulatedPictures() const
{
  return this->Last.Valid ? std::max(this->Accumulator.GetNumberOfPictures(), 1) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLinePainter::GetNumberOfBytes() const
{
  return this->Layer.GetNumberOfBytes() + this->SceneDepth.GetNumberOfBytes() +
    this->ShaderEngine.GetNumberOfBytes() + this->Selection.GetNumberOfBytes();
}

//------------------------------------------------------------------------------
void vtkVoxelLinePainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Last.Valid = false;
  this->Accumulator.Clear();
  this->SceneTexture = nullptr;
  this->Selection.ReleaseGraphicsResources(window);
  this->Layer.ReleaseGraphicsResources(window);
  this->SceneDepth.ReleaseGraphicsResources(window);
  this->ShaderEngine.ReleaseGraphicsResources(window);
  this->ReleaseTimer();
}

//------------------------------------------------------------------------------
void vtkVoxelLinePainter::ReleaseTimer()
{
  // Its queries belong to the context of the window in which they were made.
  if (this->TimerWindow)
  {
    this->TimerWindow->PushContext();
    this->Timer.ReleaseGraphicsResources();
    this->TimerWindow->PopContext();
    this->TimerWindow = nullptr;
  }
}
