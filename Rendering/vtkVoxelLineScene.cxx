// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineScene.h"

#include "vtkActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVoxelLineLightFields.h"
#include "vtkVoxelLineMapper.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
vtkVoxelLineFrameBuilder::Grid vtkVoxelLineScene::GetGrid(Warnings& warnings) const
{
  vtkVoxelLineFrameBuilder::Grid grid;
  this->Model->GetOrigin(grid.Origin);
  this->Model->GetDimensions(grid.Dimensions);
  grid.VoxelSize = this->Model->GetVoxelSize();
  grid.Margin = this->Radius / grid.VoxelSize;
  // Beyond this, single precision would lose the lines in their tubes.
  const double largest = vtkVoxelLineFrameBuilder::LargestRadius *
    *std::max_element(grid.Dimensions, grid.Dimensions + 3);
  if (grid.Margin > largest)
  {
    grid.Margin = largest;
    std::ostringstream message;
    message << "The radius " << this->Radius << " is more than "
            << vtkVoxelLineFrameBuilder::LargestRadius
            << " times the size of all lines; the lines are drawn with the radius "
            << largest * grid.VoxelSize << ". Set a smaller one.";
    warnings[HugeRadius] = message.str();
  }
  return grid;
}

//------------------------------------------------------------------------------
vtkVoxelLineViews::Tubes vtkVoxelLineScene::GetTubes(Warnings& warnings) const
{
  vtkVoxelLineViews::Tubes tubes;
  tubes.Grid = this->GetGrid(warnings);
  tubes.SmallestRadius = std::min(this->SmallestRadius / tubes.Grid.VoxelSize, tubes.Grid.Margin);
  tubes.LargestWidening = vtkVoxelLineFrameBuilder::GetLargestWidening(
    tubes.Grid, static_cast<double>(this->Model->GetNumberOfSegments()));
  return tubes;
}

//------------------------------------------------------------------------------
void vtkVoxelLineScene::Widen(
  const vtkVoxelLineViews::Tubes& tubes, vtkVoxelLineFrame& frame, Warnings& warnings) const
{
  frame.Radius = static_cast<float>(tubes.Grid.Margin);
  const bool isLimited = vtkVoxelLineFrameBuilder::SetWidths(
    frame, tubes.SmallestRadius, this->Mapper->GetSubPixelCoverage(), tubes.LargestWidening);
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
void vtkVoxelLineScene::UpdateLight(vtkVoxelLineLightFields& fields,
  vtkLineGlobalIllumination* illumination, vtkVoxelLineFrame& frame, Warnings& warnings) const
{
  vtkVoxelLineMapper* mapper = this->Mapper;
  if (mapper->GetAbortExecute() != 0)
  {
    mapper->SetAbortExecute(0);
  }
  const std::string problem = fields.Update(frame, this->Model, illumination,
    [mapper](double done)
    {
      mapper->UpdateProgress(done);
      return mapper->GetAbortExecute() == 0;
    });
  if (!problem.empty())
  {
    warnings[NoGlobalLight] = problem;
  }
}

//------------------------------------------------------------------------------
bool vtkVoxelLineScene::IsOpaque(const vtkVoxelLineFrame& frame) const
{
  return frame.Coloring == vtkVoxelLineFrame::Direct
    ? frame.Opacity >= 1.0f && !this->TranslucentColors && !frame.ThinTubes
    : frame.IsOpaque();
}

//------------------------------------------------------------------------------
bool vtkVoxelLinePictureKey::IsSameInAnyFrame(const vtkVoxelLinePictureKey& other) const
{
  return this->Valid && other.Valid && this->Window == other.Window &&
    this->Renderer == other.Renderer && this->Actor == other.Actor && this->Model == other.Model &&
    this->ModelTime == other.ModelTime && this->Engine == other.Engine &&
    vtkVoxelLineFrameBuilder::IsSamePicture(this->Frame, other.Frame);
}
