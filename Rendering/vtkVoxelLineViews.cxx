// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineViews.h"

#include "vtkActor.h"
#include "vtkLineSetsFrameCounter.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkVoxelLineViews::Look(const View& view, const Tubes& tubes)
{
  vtkRenderer* renderer = view.Renderer;
  // An active camera would be made, and moved, by asking for it.
  if (!renderer->GetRenderWindow() || !renderer->IsActiveCameraCreated())
  {
    return false;
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    size[i] = static_cast<int>(std::lround(size[i] * view.Scale[i]));
  }
  if (size[0] < 1 || size[1] < 1)
  {
    return false;
  }
  vtkVoxelLineFrameBuilder::View seen =
    vtkVoxelLineFrameBuilder::GetView(renderer, view.Actor, size[0], size[1]);
  std::copy(view.WorldFromData.begin(), view.WorldFromData.end(), seen.WorldFromData);
  vtkVoxelLineFrame frame;
  frame.Radius = static_cast<float>(tubes.Grid.Margin);
  if (!vtkVoxelLineFrameBuilder::SetView(frame, seen, tubes.Grid).empty())
  {
    return false;
  }
  vtkVoxelLineFrameBuilder::SetWidths(frame, tubes.SmallestRadius, true, tubes.LargestWidening);
  return frame.ThinTubes;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineViews::Decide(View& view, vtkLineSetsFrameCounter& frames, const Tubes& tubes)
{
  const vtkIdType frame = frames.GetFrame(view.Renderer);
  const bool known = view.IsThin && view.Frame == frame && frames.IsInFrame(view.Renderer);
  view.Frame = frame;
  view.IsThin = known || Look(view, tubes);
  return view.IsThin;
}

//------------------------------------------------------------------------------
void vtkVoxelLineViews::Forget(vtkLineSetsFrameCounter& frames)
{
  // Renderers and actors that are gone, and actors that a renderer drew no more in its last frame.
  const auto isGone = [&frames](View& view)
  {
    if (!view.Renderer || !view.Actor)
    {
      return true;
    }
    const bool isNew = view.Frame != frames.GetFrame(view.Renderer);
    const bool gone = isNew && !view.IsDrawn;
    view.IsDrawn = view.IsDrawn && !isNew;
    return gone;
  };
  this->Views.erase(
    std::remove_if(this->Views.begin(), this->Views.end(), isGone), this->Views.end());
}

//------------------------------------------------------------------------------
bool vtkVoxelLineViews::FindThinTubes(vtkLineSetsFrameCounter& frames, vtkRenderer* renderer,
  vtkActor* actor, const int size[2], const Tubes& tubes)
{
  this->Forget(frames);
  auto found = std::find_if(this->Views.begin(), this->Views.end(),
    [&](const View& v) { return v.Renderer == renderer && v.Actor == actor; });
  if (found == this->Views.end())
  {
    found = this->Views.emplace(found);
    found->Renderer = renderer;
    found->Actor = actor;
  }
  const bool known =
    found->IsThin && found->Frame == frames.GetFrame(renderer) && frames.IsInFrame(renderer);
  actor->ComputeMatrix();
  vtkMatrix4x4* matrix = actor->GetMatrix();
  std::copy_n(matrix->GetData(), 16, found->WorldFromData.begin());
  int rendererSize[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&rendererSize[0], &rendererSize[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    found->Scale[i] = static_cast<double>(size[i]) / std::max(rendererSize[i], 1);
  }
  found->IsDrawn = true;
  return Decide(*found, frames, tubes) && !known;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineViews::HaveThinTubes(vtkLineSetsFrameCounter& frames, const Tubes& tubes)
{
  this->Forget(frames);
  bool any = false;
  for (View& view : this->Views)
  {
    any = Decide(view, frames, tubes) || any;
  }
  return any;
}
