// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinePainter.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVoxelLineColoring.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineSelection.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

namespace
{
// An early end that no sum of opacities reaches: rays end behind opaque lines only.
constexpr float NeverEarly = 2.0f;

// Frames per second from which on a window is taken to be interacted with: VTK's interactor asks
// for 15 while something moves, ParaView for 5, and for far below 1 at rest.
constexpr double InteractiveRate = 1.0;

// Points are selected on top of a picture that was drawn just before; this much nearer, in units of
// the depth buffer, so that rounding between two engines does not matter.
constexpr float SelectionDepthOffset = -1e-5f;

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
}

//------------------------------------------------------------------------------
vtkVoxelLinePainter::vtkVoxelLinePainter() = default;

//------------------------------------------------------------------------------
vtkVoxelLinePainter::~vtkVoxelLinePainter()
{
  this->ReleaseTimer();
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::Cached::IsSame(const Cached& other) const
{
  return this->Valid && other.Valid && this->FrameNumber == other.FrameNumber &&
    this->Renderer == other.Renderer && this->Actor == other.Actor && this->Model == other.Model &&
    this->ModelTime == other.ModelTime && this->Engine == other.Engine &&
    vtkVoxelLineFrameBuilder::IsSamePicture(this->Frame, other.Frame);
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
vtkVoxelLineFrameBuilder::Grid vtkVoxelLinePainter::GetGrid(const Scene& scene, Warnings& warnings)
{
  vtkVoxelLineFrameBuilder::Grid grid;
  scene.Model->GetOrigin(grid.Origin);
  scene.Model->GetDimensions(grid.Dimensions);
  grid.VoxelSize = scene.Model->GetVoxelSize();
  grid.Margin = scene.Radius / grid.VoxelSize;
  // Beyond this, single precision would lose the lines in their tubes.
  const double largest = vtkVoxelLineFrameBuilder::LargestRadius *
    *std::max_element(grid.Dimensions, grid.Dimensions + 3);
  if (grid.Margin > largest)
  {
    grid.Margin = largest;
    std::ostringstream message;
    message << "The radius " << scene.Radius << " is more than "
            << vtkVoxelLineFrameBuilder::LargestRadius
            << " times the size of all lines; the lines are drawn with the radius "
            << largest * grid.VoxelSize << ". Set a smaller one.";
    warnings[HugeRadius] = message.str();
  }
  return grid;
}

//------------------------------------------------------------------------------
vtkVoxelLineViews::Tubes vtkVoxelLinePainter::GetTubes(const Scene& scene, Warnings& warnings)
{
  vtkVoxelLineViews::Tubes tubes;
  tubes.Grid = GetGrid(scene, warnings);
  tubes.SmallestRadius = std::min(scene.SmallestRadius / tubes.Grid.VoxelSize, tubes.Grid.Margin);
  tubes.LargestWidening = vtkVoxelLineFrameBuilder::GetLargestWidening(
    tubes.Grid, static_cast<double>(scene.Model->GetNumberOfSegments()));
  return tubes;
}

//------------------------------------------------------------------------------
void vtkVoxelLinePainter::Widen(const Scene& scene, const vtkVoxelLineViews::Tubes& tubes,
  vtkVoxelLineFrame& frame, Warnings& warnings)
{
  frame.Radius = static_cast<float>(tubes.Grid.Margin);
  const bool isLimited = vtkVoxelLineFrameBuilder::SetWidths(
    frame, tubes.SmallestRadius, scene.Mapper->GetSubPixelCoverage(), tubes.LargestWidening);
  // Where all lines lie within a few pixels, there is nothing to be told apart.
  const int longest = *std::max_element(tubes.Grid.Dimensions, tubes.Grid.Dimensions + 3);
  if (isLimited && 8.0 * tubes.LargestWidening < longest)
  {
    std::ostringstream message;
    message
      << "Pixels are more than " << 2.0 * tubes.LargestWidening
      << " voxels wide: for speed, some lines are missed and others are drawn less transparent"
         " in exchange. Lower the Resolution for views from so far away.";
    warnings[HugePixels] = message.str();
  }
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
  const bool found = this->Views.FindThinTubes(
    this->Frames, renderer, actor, viewport + 2, GetTubes(scene, ignored));
  return found && !actor->IsRenderingTranslucentPolygonalGeometry() && !actor->GetForceOpaque();
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePainter::HasThinTubes(const Scene& scene)
{
  Warnings ignored; // a picture tells them
  return scene.Mapper->GetSubPixelCoverage() &&
    this->Views.HaveThinTubes(this->Frames, GetTubes(scene, ignored));
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
      ? this->DrawSelection(scene, renderer, actor, window, viewport, warnings)
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
std::string vtkVoxelLinePainter::DrawPicture(const Scene& scene, vtkRenderer* renderer,
  vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings)
{
  Cached wanted;
  wanted.Valid = true;
  wanted.FrameNumber = this->Frames.GetFrame(renderer);
  wanted.Renderer = renderer;
  wanted.Actor = actor;
  wanted.Model = scene.Model;
  wanted.ModelTime = scene.Model->GetMTime();
  wanted.Engine = ChooseEngine(scene.Mapper->GetEngine(), window);
  this->EngineInUse = wanted.Engine;

  const vtkVoxelLineViews::Tubes tubes = GetTubes(scene, warnings);
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
  vtkVoxelLineFrameBuilder::SetProperty(frame, actor->GetProperty());
  if (!vtkVoxelLineFrameBuilder::SetLighting(
        frame, renderer, scene.Mapper->GetIllumination(), actor->GetProperty()))
  {
    warnings[BadPower] = "The property's SpecularPower is not a number from 0 on; 1 is taken.";
  }
  vtkVoxelLineColoring::SetColors(frame, scene.Mapper, scene.Model);
  Widen(scene, tubes, frame, warnings);
  this->QualityInUse = ChooseQuality(scene.Mapper->GetQuality(), window);
  frame.Interactive = this->QualityInUse == vtkVoxelLineMapper::InteractiveQuality;
  frame.OpacityByPathLength = scene.Mapper->GetOpacityByPathLength();
  const double early = scene.Mapper->GetEarlyTermination();
  frame.EarlyTermination = early < 1.0 ? static_cast<float>(early) : NeverEarly;

  if (!this->Last.IsSame(wanted))
  {
    error = this->CastPicture(scene, renderer, window, viewport, wanted, warnings);
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
std::string vtkVoxelLinePainter::CastPicture(const Scene& scene, vtkRenderer* renderer,
  vtkOpenGLRenderWindow* window, const int viewport[4], Cached& wanted, Warnings& warnings)
{
  vtkVoxelLineFrame& frame = wanted.Frame;
  ++this->NumberOfPictures;

  // Opaque lines need no depth of the scene: the final draw is tested against it, and a line behind
  // it hides nothing that is seen.
  const bool opaque = frame.Coloring == vtkVoxelLineFrame::Direct
    ? frame.Opacity >= 1.0f && !scene.TranslucentColors && !frame.ThinTubes
    : frame.IsOpaque();
  int readOrigin[2] = { 0, 0 };
  if (!opaque)
  {
    int size[2];
    int origin[2];
    renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
    vtkLineSetsSceneDepth::GetReadOrigin(window, viewport, origin, readOrigin);
  }
  const auto warnOfOverflows = [&warnings](vtkIdType pixels)
  {
    if (pixels > 0)
    {
      warnings[OverlappingCurves] = "In " + std::to_string(pixels) +
        " pixels more lines overlap than can be told apart, so that some may be blended twice at a "
        "joint; a smaller radius or a higher resolution avoids it.";
    }
  };
  const char* noDepth = "The depth of the scene cannot be read from the framebuffer; translucent "
                        "lines in front of opaque actors may hide them too much.";

  if (wanted.Engine == vtkVoxelLineMapper::Shader)
  {
    vtkTextureObject* depth =
      opaque ? nullptr : this->SceneDepth.Copy(window, readOrigin, frame.Width, frame.Height);
    if (!opaque && !depth)
    {
      warnings[NoSceneDepth] = noDepth;
    }
    if (this->TimerWindow != window)
    {
      this->ReleaseTimer();
      window->MakeCurrent();
      this->TimerWindow = window;
    }
    this->Timer.ReusableStart();
    const bool done = this->ShaderEngine.Render(window, scene.Model, frame, depth);
    this->Timer.ReusableStop();
    if (!done)
    {
      return this->ShaderEngine.GetError();
    }
    warnOfOverflows(this->ShaderEngine.GetNumberOfOverflows());
    this->Layer.SetTextures(
      this->ShaderEngine.GetColorTexture(), this->ShaderEngine.GetDepthTexture());
    return {};
  }

  frame.SceneDepth.clear();
  if (!opaque &&
    !this->SceneDepth.Read(window, readOrigin, frame.Width, frame.Height, frame.SceneDepth))
  {
    warnings[NoSceneDepth] = noDepth;
  }
  vtkVoxelLineNativeEngine::Render(scene.Model, frame, this->Picture);
  // Read by nobody any more, and large.
  frame.SceneDepth = std::vector<float>();
  warnOfOverflows(this->Picture.NumberOfOverflows);
  return this->Layer.SetPicture(window, frame.Width, frame.Height, this->Picture.Color.data(),
           this->Picture.Depth.data())
    ? std::string()
    : "there is not enough graphics memory for a picture of the size of the viewport";
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::DrawSelection(const Scene& scene, vtkRenderer* renderer,
  vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4], Warnings& warnings)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS && !scene.Input)
  {
    warnings[NoPoints] =
      "Points cannot be selected in a model, which does not know them; select cells.";
    return {};
  }

  // Only the area that is asked for.
  vtkVoxelLineFrameBuilder::View view =
    vtkVoxelLineFrameBuilder::GetView(renderer, actor, viewport[2], viewport[3]);
  const unsigned int* area = selector->GetArea();
  for (int i = 0; i < 2; ++i)
  {
    const int first = std::max(static_cast<int>(area[i]) - viewport[i], 0);
    const int last = std::min(static_cast<int>(area[i + 2]) - viewport[i], viewport[i + 2] - 1);
    view.PictureOrigin[i] = first;
    view.PictureSize[i] = last - first + 1;
  }
  if (view.PictureSize[0] <= 0 || view.PictureSize[1] <= 0)
  {
    return {};
  }

  selector->BeginRenderProp();
  selector->UpdateMaximumCellId(vtkVoxelLineSelection::GetLargestCell(scene.Model));
  if (scene.Input)
  {
    selector->UpdateMaximumPointId(scene.Input->GetNumberOfPoints() - 1);
  }
  std::string error = this->DrawNumbers(scene, selector, actor, window, viewport, view);
  selector->EndRenderProp();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLinePainter::DrawNumbers(const Scene& scene, vtkHardwareSelector* selector,
  vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4],
  const vtkVoxelLineFrameBuilder::View& view)
{
  const bool points = selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  Cached wanted;
  wanted.Valid = true;
  wanted.FrameNumber = points ? 1 : 0;
  wanted.Actor = actor;
  wanted.Model = scene.Model;
  wanted.ModelTime = scene.Model->GetMTime();
  wanted.Frame.Picking = true;
  Warnings ignored; // the picture has told them
  const vtkVoxelLineViews::Tubes tubes = GetTubes(scene, ignored);
  const vtkVoxelLineFrameBuilder::Grid& grid = tubes.Grid;
  std::string error = vtkVoxelLineFrameBuilder::SetView(wanted.Frame, view, grid);
  if (!error.empty())
  {
    return error;
  }
  vtkVoxelLineFrameBuilder::SetClippingPlanes(
    wanted.Frame, scene.Mapper->GetClippingPlanes(), view, grid);
  Widen(scene, tubes, wanted.Frame, ignored);

  // The selector draws the scene once per number; one picture serves for all.
  if (!this->LastPick.IsSame(wanted))
  {
    vtkVoxelLineNativeEngine::Render(scene.Model, wanted.Frame, this->PickPicture);
    this->PickPoints.clear();
    if (points)
    {
      this->PickPoints = vtkVoxelLineSelection::GetPoints(
        scene.Model, scene.Input, wanted.Frame, grid, this->PickPicture);
    }
    this->LastPick = std::move(wanted);
  }
  vtkVoxelLineSelection::GetColors(
    selector, scene.Model, this->PickPicture, this->PickPoints, this->PickColors);
  this->Last.Valid = false;
  const vtkVoxelLineFrame& frame = this->LastPick.Frame;
  if (!this->Layer.SetPicture(
        window, frame.Width, frame.Height, this->PickColors.data(), this->PickPicture.Depth.data()))
  {
    return "there is not enough graphics memory for a picture of the selected area";
  }
  return this->Layer.Draw(window, scene.Mapper, actor, viewport[0] + view.PictureOrigin[0],
    viewport[1] + view.PictureOrigin[1], points ? SelectionDepthOffset : 0.0f);
}

//------------------------------------------------------------------------------
vtkIdType vtkVoxelLinePainter::GetNumberOfBytes() const
{
  return this->Layer.GetNumberOfBytes() + this->SceneDepth.GetNumberOfBytes() +
    this->ShaderEngine.GetNumberOfBytes();
}

//------------------------------------------------------------------------------
void vtkVoxelLinePainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Last.Valid = false;
  this->LastPick.Valid = false;
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
