// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityPainter.h"

#define LINESETS_USE_OPENGL
#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkActor.h"
#include "vtkFourierOpacityAccumulator.h"
#include "vtkFourierOpacityElements.h"
#include "vtkFourierOpacityMapper.h"
#include "vtkLineSetsScopedState.h"
#include "vtkOpacityOptimization.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkVoxelLineAccumulator.h"

#include <algorithm>
#include <chrono>

//------------------------------------------------------------------------------
struct vtkFourierOpacityPainter::View
{
  vtkWeakPointer<vtkRenderer> Renderer;
  /// Where a mapper draws by itself: several actors may have it.
  vtkWeakPointer<vtkActor> Actor;
  bool IsOfActor = false;
  vtkFourierOpacityElements Elements;
  std::vector<Item> Items; ///< of the last picture; compared, never followed
  vtkFourierOpacityView Last;
  bool HasLast = false;
  vtkMTimeType WholeTime = 0; ///< of the optimization; 0 where opacities are those of a tile
  std::chrono::steady_clock::time_point Time;
  std::chrono::steady_clock::time_point LastChange;
  vtkFourierOpacityAccumulator Accumulator;
  vtkNew<vtkTextureObject> Sum; ///< of the pictures, colours multiplied by opacity
};

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::vtkFourierOpacityPainter() = default;

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::~vtkFourierOpacityPainter() = default;

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Check(vtkOpenGLRenderWindow* window)
{
  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  if (major < 4 || (major == 4 && minor < 2))
  {
    return "OpenGL " + std::to_string(major) + "." + std::to_string(minor) +
      " has no images that shaders write to: opacity optimization needs OpenGL 4.2. "
      "vtkIlluminatedLineMapper and vtkVoxelLineMapper need 3.2.";
  }
  return {};
}

//------------------------------------------------------------------------------
vtkFourierOpacityPainter::View& vtkFourierOpacityPainter::GetView(
  vtkRenderer* renderer, vtkActor* actor)
{
  this->Views.remove_if([](const std::unique_ptr<View>& view)
    { return !view->Renderer || (view->IsOfActor && !view->Actor); });
  for (const std::unique_ptr<View>& view : this->Views)
  {
    if (view->Renderer == renderer && view->Actor == actor)
    {
      return *view;
    }
  }
  this->Views.push_back(std::make_unique<View>());
  this->Views.back()->Renderer = renderer;
  this->Views.back()->Actor = actor;
  this->Views.back()->IsOfActor = actor != nullptr;
  return *this->Views.back();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::PrepareView(View& view, vtkFourierOpacityFrame& frame)
{
  const auto time = std::chrono::steady_clock::now();
  const double transition = frame.Optimization->GetTransitionTime();
  if (transition > 0.0 && view.HasLast && !view.Last.IsJump(frame.Now))
  {
    const double seconds = std::chrono::duration<double>(time - view.Time).count();
    frame.Blend = vtkOpacitySmoothing::GetBlend(seconds, transition);
  }
  const int largest = frame.Optimization->GetAccumulationFrames();
  if (view.Last.Size[0] != frame.Now.Size[0] || view.Last.Size[1] != frame.Now.Size[1])
  {
    view.Accumulator.Forget();
  }
  if (largest > 1)
  {
    frame.Number = view.Accumulator.Begin(view.Renderer, frame.Optimization, largest);
    // While opacities follow, no picture shows the same as the one before. They follow with each
    // picture: the first one that counts is the first one after a picture in which they rested.
    const bool follows = transition > 0.0 &&
      std::chrono::duration<double>(view.Time - view.LastChange).count() < transition;
    if (frame.Number == 0)
    {
      view.LastChange = time;
    }
    else if (follows)
    {
      view.Accumulator.Restart();
      frame.Number = 0;
    }
    const glm::dvec2 offset =
      vtkVoxelLineAccumulator::GetOffset(std::min(frame.Number, largest - 1));
    frame.Shift[0] = static_cast<float>(2.0 * offset.x / frame.Now.Size[0]);
    frame.Shift[1] = static_cast<float>(2.0 * offset.y / frame.Now.Size[1]);
  }
  if (frame.KeepsOpacities)
  {
    return;
  }
  view.Last = frame.Now;
  view.HasLast = true;
  view.Time = time;
  view.WholeTime = frame.IsTile ? 0 : frame.Optimization->GetMTime();
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Accumulate(View& view, vtkFourierOpacityFrame& frame)
{
  vtkTextureObject* sum = view.Sum;
  if (frame.Number == 0 && !vtkFourierOpacityTargets::MakeColors(frame.Window, sum, frame.Now.Size))
  {
    return "There is no memory on the graphics device to accumulate pictures.";
  }
  this->Steps.Targets.Bind({ sum }, nullptr);
  if (frame.Number == 0)
  {
    frame.State->vtkglClear(GL_COLOR_BUFFER_BIT);
  }
  frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
  frame.State->vtkglDisable(GL_DEPTH_TEST);
  frame.State->vtkglEnable(GL_BLEND);
  frame.State->vtkglBlendFunc(GL_ONE, GL_ONE);
  std::string error = this->Steps.Finish(frame);
  if (error.empty())
  {
    view.Accumulator.Add();
  }
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Show(View& view, vtkFourierOpacityFrame& frame)
{
  // Depths are written where the test is on.
  frame.State->SetEnumState(GL_DEPTH_TEST, frame.HasPicture);
  frame.State->vtkglDepthFunc(GL_ALWAYS);
  frame.State->vtkglDepthMask(frame.HasPicture);
  if (frame.HasPicture)
  {
    frame.State->vtkglDisable(GL_BLEND);
    frame.State->vtkglViewport(0, 0, frame.Now.Size[0], frame.Now.Size[1]);
    this->Steps.BindPicture();
  }
  else
  {
    frame.State->vtkglEnable(GL_BLEND);
    frame.State->vtkglBlendEquation(GL_FUNC_ADD);
    frame.State->vtkglBlendFuncSeparate(
      GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  if (frame.Number < 0)
  {
    return this->Steps.Finish(frame);
  }
  frame.MeanFactor = 1.0f / static_cast<float>(std::max(1, view.Accumulator.GetNumber()));
  frame.Textures.Add("fourierColors", view.Sum);
  std::string error = this->Steps.DrawQuad(frame, frame.Stages.ShowMean());
  frame.Textures.Clear();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPainter::Draw(vtkRenderer* renderer, const std::vector<Item>& items,
  vtkOpacityOptimization* optimization, const vtkFourierOpacityDrawFunction& drawItem,
  DestinationType destination, std::string& warning)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "The renderer has no window of OpenGL.";
  }
  std::string error = this->Check(window);
  if (!error.empty())
  {
    return error;
  }
  if (this->Window && this->Window != window)
  {
    vtkSmartPointer<vtkOpenGLRenderWindow> other = this->Window.GetPointer();
    other->PushContext();
    this->ReleaseGraphicsResources(other);
    other->PopContext();
    window->MakeCurrent();
  }
  this->Window = window;

  vtkFourierOpacityView now;
  std::vector<vtkActor*> actors;
  for (const Item& item : items)
  {
    actors.push_back(item.Actor);
  }
  now.Set(renderer, actors);
  // A pass may draw to textures that are larger than the renderer.
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  now.Size[0] = viewport[2];
  now.Size[1] = viewport[3];
  if (now.Size[0] < 1 || now.Size[1] < 1)
  {
    return {}; // a renderer beside the tile that is drawn
  }
  View& view = this->GetView(renderer, destination == Picture ? items.front().Actor : nullptr);
  view.Items = items;
  std::vector<vtkFourierOpacityGroup> groups;
  for (const Item& item : items)
  {
    groups.push_back(item.Mapper->UpdateElements());
    // Actors of one mapper fade each for itself.
    groups.back().Owner = item.Actor;
  }
  view.Elements.SetGroups(groups);
  vtkFourierOpacityFrame frame(renderer, items, optimization, drawItem, now, view.Elements);
  frame.HasPicture = destination == Picture;
  const int* tiles = window->GetTileScale();
  frame.IsTile = tiles[0] > 1 || tiles[1] > 1;
  frame.KeepsOpacities = frame.IsTile && view.Elements.AreKnown() &&
    view.WholeTime == optimization->GetMTime() && view.Last.HasSameEye(now);
  this->PrepareView(view, frame);
  error = this->Steps.Prepare(frame);
  if (!error.empty())
  {
    return error;
  }

  const vtkLineSetsScopedState::SavedState saved(frame.State);
  frame.Origin[0] = destination == Picture ? 0 : viewport[0];
  frame.Origin[1] = destination == Picture ? 0 : viewport[1];
  int tiledOrigin[2];
  int size[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &tiledOrigin[0], &tiledOrigin[1]);
  int readOrigin[2];
  vtkLineSetsSceneDepth::GetReadOrigin(window, viewport, tiledOrigin, readOrigin);
  // Enough pictures are in the sum, or one more is made.
  if (frame.Number < optimization->GetAccumulationFrames())
  {
    const vtkLineSetsScopedState::SavedState target(frame.State);
    error = this->Steps.MakePicture(frame, readOrigin);
    error = error.empty() && frame.Number >= 0 ? this->Accumulate(view, frame) : error;
  }
  error = error.empty() ? this->Show(view, frame) : error;
  if (!error.empty())
  {
    view.Accumulator.Forget();
  }
  this->NumberOfAccumulatedPictures = frame.Number < 0 ? 1 : view.Accumulator.GetNumber();
  if (frame.IsTile && !frame.KeepsOpacities)
  {
    warning = "A view is drawn in tiles that was not drawn as a whole before: each tile finds "
              "opacities of its own, with seams between them. For a large picture of a window, "
              "render the window before. ";
  }
  if (this->GetNumberOfDroppedFragments() > 0)
  {
    // Their number, which changes with every view, is told by a getter.
    warning += "Fragments did not fit into the lists and are not drawn: MaximumListMemory is " +
      std::to_string(optimization->GetMaximumListMemory()) +
      " MiB. GetNumberOfDroppedFragments() tells how many.";
  }
  return error;
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityPainter::BeginSelection(vtkRenderer* renderer, const Item& item,
  const vtkFourierOpacityGroup& elements, vtkFourierOpacityStage& stage)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto isItem = [&item](const Item& last)
  { return last.Actor == item.Actor && last.Mapper == item.Mapper; };
  const auto view = std::find_if(this->Views.begin(), this->Views.end(),
    [&](const std::unique_ptr<View>& known)
    {
      return known->Renderer == renderer &&
        std::any_of(known->Items.begin(), known->Items.end(), isItem);
    });
  if (view == this->Views.end() || !window || window != this->Window.GetPointer())
  {
    return false;
  }
  const std::vector<Item>& items = (*view)->Items;
  const auto place =
    static_cast<std::size_t>(std::find_if(items.begin(), items.end(), isItem) - items.begin());
  vtkFourierOpacityGroup group = elements;
  group.Owner = item.Actor;
  // Elements of another input have no opacities yet.
  if (!(*view)->Elements.IsGroup(place, group) ||
    !this->Steps.UploadOpacities(window, (*view)->Elements).empty())
  {
    return false;
  }
  vtkTextureObject* texture = this->Steps.GetOpacities().GetTexture();
  texture->Activate();
  const auto first = static_cast<int>((*view)->Elements.GetFirstElement(place));
  const int shift = vtkFourierOpacitySteps::GetElementShift(window, (*view)->Elements);
  stage = vtkFourierOpacityStages::Select();
  stage.MakeKey();
  stage.SetParameters = [texture, first, shift](vtkShaderProgram* program)
  {
    program->SetUniformi("fourierOpacities", texture->GetTextureUnit());
    program->SetUniformi("fourierFirstElement", first);
    program->SetUniformi("fourierElementShift", shift);
  };
  return true;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::EndSelection()
{
  this->Steps.GetOpacities().Deactivate();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::ForgetOpacities()
{
  for (const std::unique_ptr<View>& view : this->Views)
  {
    view->Elements.SetGroups({});
    view->Items.clear();
    view->Accumulator.Forget();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkFourierOpacityPainter::GetNumberOfBytes() const
{
  vtkIdType bytes = this->Steps.GetNumberOfBytes();
  for (const std::unique_ptr<View>& view : this->Views)
  {
    bytes += vtkFourierOpacityTargets::GetNumberOfColorBytes(view->Sum);
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  // A mapper that meets a new window in the middle of a picture leaves the old one then.
  if (window && this->Window && window != this->Window.GetPointer())
  {
    return;
  }
  this->Steps.ReleaseGraphicsResources(window);
  for (const std::unique_ptr<View>& view : this->Views)
  {
    view->Sum->ReleaseGraphicsResources(window);
    view->Accumulator.Forget();
  }
  this->Window = nullptr;
}
