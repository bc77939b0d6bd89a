// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewRays.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>

namespace linesets
{
namespace
{
void CopyLinearPart(vtkMatrix4x4* from, double to[3][3])
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      to[i][j] = from->GetElement(i, j);
    }
  }
}
}

//------------------------------------------------------------------------------
ViewRays::ViewRays(
  vtkCamera* camera, int width, int height, vtkMatrix4x4* actor, const double reference[3])
  : Width(width)
  , Height(height)
{
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(
    camera->GetProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0));
  std::copy_n(projection->GetData(), 16, this->Projection);
  projection->Invert();
  std::copy_n(projection->GetData(), 16, this->InverseProjection);

  vtkNew<vtkMatrix4x4> view;
  view->DeepCopy(camera->GetModelViewTransformMatrix());
  camera->GetPosition(this->CameraPosition);
  // The view transform is a rotation about the camera's position, unless somebody added more to it.
  std::fill_n(this->ViewOfCamera, 3, 0.0);
  if (camera->GetUserViewTransform())
  {
    double position[4] = { this->CameraPosition[0], this->CameraPosition[1],
      this->CameraPosition[2], 1.0 };
    view->MultiplyPoint(position, position);
    std::copy_n(position, 3, this->ViewOfCamera);
  }

  double worldToView[3][3];
  CopyLinearPart(view, worldToView);
  vtkMath::Invert3x3(worldToView, this->ViewToWorld);
  double modelToWorld[3][3];
  double placed[4] = { reference[0], reference[1], reference[2], 1.0 };
  vtkMath::Identity3x3(modelToWorld);
  if (actor)
  {
    CopyLinearPart(actor, modelToWorld);
    actor->MultiplyPoint(placed, placed);
  }
  vtkMath::Subtract(placed, this->CameraPosition, this->ReferenceFromCamera);
  vtkMath::Invert3x3(modelToWorld, this->WorldToModel);
  double modelToView[3][3];
  vtkMath::Multiply3x3(worldToView, modelToWorld, modelToView);
  vtkMath::Invert3x3(modelToView, this->ViewToModel);
  vtkMath::Transpose3x3(this->ViewToModel, this->NormalToView);
}

//------------------------------------------------------------------------------
void ViewRays::Unproject(double x, double y, double depth, double view[3]) const
{
  const double device[4] = { 2.0 * x / this->Width - 1.0, 2.0 * y / this->Height - 1.0,
    2.0 * depth - 1.0, 1.0 };
  double point[4];
  vtkMatrix4x4::MultiplyPoint(this->InverseProjection, device, point);
  for (int i = 0; i < 3; ++i)
  {
    view[i] = point[i] / point[3];
  }
}

//------------------------------------------------------------------------------
Ray ViewRays::GetRay(double x, double y) const
{
  Ray ray;
  double far[3];
  this->Unproject(x, y, 0.0, ray.ViewOrigin);
  this->Unproject(x, y, 1.0, far);
  vtkMath::Subtract(far, ray.ViewOrigin, ray.ViewDirection);
  ray.Length = vtkMath::Normalize(ray.ViewDirection);
  double fromCamera[3];
  vtkMath::Subtract(ray.ViewOrigin, this->ViewOfCamera, fromCamera);
  double world[3];
  vtkMath::Multiply3x3(this->ViewToWorld, fromCamera, world);
  vtkMath::Subtract(world, this->ReferenceFromCamera, world);
  vtkMath::Multiply3x3(this->WorldToModel, world, ray.ModelOrigin);
  vtkMath::Multiply3x3(this->ViewToModel, ray.ViewDirection, ray.ModelDirection);
  return ray;
}

//------------------------------------------------------------------------------
double ViewRays::GetDepth(const double viewPoint[3]) const
{
  const double point[4] = { viewPoint[0], viewPoint[1], viewPoint[2], 1.0 };
  double device[4];
  vtkMatrix4x4::MultiplyPoint(this->Projection, point, device);
  return 0.5 * (device[2] / device[3] + 1.0);
}

//------------------------------------------------------------------------------
double ViewRays::GetParameter(double x, double y, double depth) const
{
  const Ray ray = this->GetRay(x, y);
  double point[3];
  this->Unproject(x, y, depth, point);
  vtkMath::Subtract(point, ray.ViewOrigin, point);
  return vtkMath::Dot(point, ray.ViewDirection);
}

//------------------------------------------------------------------------------
void ViewRays::TransformNormal(const double model[3], double view[3]) const
{
  vtkMath::Multiply3x3(this->NormalToView, model, view);
  vtkMath::Normalize(view);
}

//------------------------------------------------------------------------------
void ViewRays::Clip(
  const Ray& ray, const double origin[3], const double normal[3], double& first, double& last) const
{
  double fromCamera[3];
  vtkMath::Subtract(ray.ViewOrigin, this->ViewOfCamera, fromCamera);
  double start[3];
  double direction[3];
  vtkMath::Multiply3x3(this->ViewToWorld, fromCamera, start);
  vtkMath::Multiply3x3(this->ViewToWorld, ray.ViewDirection, direction);
  double offset = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    offset += normal[i] * (start[i] + (this->CameraPosition[i] - origin[i]));
  }
  const double slope = vtkMath::Dot(normal, direction);
  if (slope > 0.0)
  {
    first = std::max(first, -offset / slope);
  }
  else if (slope < 0.0)
  {
    last = std::min(last, -offset / slope);
  }
  else if (offset < 0.0)
  {
    last = first;
  }
}
}
