// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
void vtkFourierOpacityView::Set(vtkRenderer* renderer, const std::vector<vtkActor*>& actors)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  renderer->GetTiledSize(&this->Size[0], &this->Size[1]);
  this->IsParallel = camera->GetParallelProjection() != 0;
  camera->GetPosition(this->Position);
  camera->GetDirectionOfProjection(this->Direction);
  this->Angle = camera->GetViewAngle();
  this->ParallelScale = camera->GetParallelScale();
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    this->Projection[i] = projection->GetElement(2 + i / 2, 2 + i % 2);
  }

  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  double nearest = std::numeric_limits<double>::max();
  double farthest = std::numeric_limits<double>::lowest();
  for (vtkActor* actor : actors)
  {
    const double* bounds = actor->GetBounds();
    if (!bounds || !vtkMath::AreBoundsInitialized(bounds))
    {
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const double world[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
        bounds[4 + (corner >> 2)], 1.0 };
      double seen[4];
      view->MultiplyPoint(world, seen);
      nearest = std::min(nearest, -seen[2]);
      farthest = std::max(farthest, -seen[2]);
    }
  }
  // Nothing is seen outside the clipping range.
  const double* clipping = camera->GetClippingRange();
  this->Range[0] = std::max(nearest, clipping[0]);
  this->Range[1] = std::min(farthest, clipping[1]);
  if (!(this->Range[0] < this->Range[1]))
  {
    this->Range[0] = clipping[0];
    this->Range[1] = std::max(clipping[1], clipping[0] + 1e-30);
  }
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityView::HasSameEye(const vtkFourierOpacityView& other) const
{
  return this->IsParallel == other.IsParallel &&
    std::equal(this->Position, this->Position + 3, other.Position) &&
    std::equal(this->Direction, this->Direction + 3, other.Direction);
}

//------------------------------------------------------------------------------
bool vtkFourierOpacityView::IsJump(const vtkFourierOpacityView& next) const
{
  const double largestTurn = std::cos(vtkMath::RadiansFromDegrees(20.0));
  const double depth = this->Range[1] - this->Range[0];
  const double zoom =
    next.IsParallel ? next.ParallelScale / this->ParallelScale : next.Angle / this->Angle;
  return this->Size[0] != next.Size[0] || this->Size[1] != next.Size[1] ||
    this->IsParallel != next.IsParallel ||
    vtkMath::Dot(this->Direction, next.Direction) < largestTurn ||
    std::sqrt(vtkMath::Distance2BetweenPoints(this->Position, next.Position)) >
    0.5 * depth + 2.0 * this->Range[0] * std::sin(vtkMath::RadiansFromDegrees(10.0)) ||
    !(zoom > 1.0 / 1.5 && zoom < 1.5);
}
