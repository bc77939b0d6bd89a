// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineSelectionPainter.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineSelection.h"

#include <algorithm>
#include <utility>

namespace
{
// Points are selected on top of a picture that was drawn just before; this much nearer, in units of
// the depth buffer, so that rounding between two engines does not matter.
constexpr float SelectionDepthOffset = -1e-5f;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineSelectionPainter::Draw(const vtkVoxelLineScene& scene,
  vtkRenderer* renderer, vtkActor* actor, vtkOpenGLRenderWindow* window, const int viewport[4],
  vtkVoxelLineScene::Warnings& warnings)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS && !scene.Input)
  {
    warnings[vtkVoxelLineScene::NoPoints] =
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
  const auto arrays = vtkVoxelLineSelection::GetArrays(scene.Mapper, scene.Input);
  selector->UpdateMaximumCellId(vtkVoxelLineSelection::GetLargestCell(scene.Model, arrays));
  if (scene.Input)
  {
    selector->UpdateMaximumPointId(vtkVoxelLineSelection::GetLargestPoint(scene.Input, arrays));
  }
  std::string error = this->DrawNumbers(scene, selector, actor, window, viewport, view);
  selector->EndRenderProp();
  return error;
}

//------------------------------------------------------------------------------
std::string vtkVoxelLineSelectionPainter::DrawNumbers(const vtkVoxelLineScene& scene,
  vtkHardwareSelector* selector, vtkActor* actor, vtkOpenGLRenderWindow* window,
  const int viewport[4], const vtkVoxelLineFrameBuilder::View& view)
{
  const bool points = selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkVoxelLinePictureKey wanted;
  wanted.Valid = true;
  wanted.FrameNumber = points ? 1 : 0;
  wanted.Actor = actor;
  wanted.Model = scene.Model;
  wanted.ModelTime = scene.Model->GetMTime();
  wanted.Frame.Picking = true;
  vtkVoxelLineScene::Warnings ignored; // the picture has told them
  const vtkVoxelLineViews::Tubes tubes = scene.GetTubes(ignored);
  const vtkVoxelLineFrameBuilder::Grid& grid = tubes.Grid;
  std::string error = vtkVoxelLineFrameBuilder::SetView(wanted.Frame, view, grid);
  if (!error.empty())
  {
    return error;
  }
  vtkVoxelLineFrameBuilder::SetClippingPlanes(
    wanted.Frame, scene.Mapper->GetClippingPlanes(), view, grid);
  vtkVoxelLineFrameBuilder::SetRegion(wanted.Frame, scene.Mapper->GetRegion(), view, grid);
  scene.Widen(tubes, wanted.Frame, ignored);

  // The selector draws the scene once per number; one picture serves for all.
  if (!this->Last.IsSame(wanted))
  {
    vtkVoxelLineNativeEngine::Render(scene.Model, wanted.Frame, this->Picture);
    this->Points.clear();
    if (points)
    {
      this->Points = vtkVoxelLineSelection::GetPoints(
        scene.Model, scene.Input, wanted.Frame, grid, this->Picture);
    }
    this->Last = std::move(wanted);
  }
  vtkVoxelLineSelection::GetColors(selector, scene.Model, scene.Input,
    vtkVoxelLineSelection::GetArrays(scene.Mapper, scene.Input), this->Picture, this->Points,
    this->Colors);
  const vtkVoxelLineFrame& frame = this->Last.Frame;
  if (!this->Layer.SetPicture(
        window, frame.Width, frame.Height, this->Colors.data(), this->Picture.Depth.data()))
  {
    return "there is not enough graphics memory for a picture of the selected area";
  }
  return this->Layer.Draw(window, scene.Mapper, actor, viewport[0] + view.PictureOrigin[0],
    viewport[1] + view.PictureOrigin[1], points ? SelectionDepthOffset : 0.0f);
}

//------------------------------------------------------------------------------
void vtkVoxelLineSelectionPainter::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Last.Valid = false;
  this->Layer.ReleaseGraphicsResources(window);
}
