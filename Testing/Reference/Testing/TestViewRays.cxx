// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the rays: a point on the ray through a pixel is where vtkRenderer's WorldToView puts that
// pixel, with the same depth, in perspective and parallel views, with an actor matrix, far from the
// origin, and with planes in world coordinates.

#include "ReferenceTesting.h"
#include "ViewRays.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

using namespace linesets;

namespace
{
constexpr int Width = 320;
constexpr int Height = 200;

struct Setup
{
  bool Parallel = false;
  double Offset = 0.0;     // of everything, along all axes
  double Tolerance = 1e-9; // pixels
  bool Actor = false;
};

void CheckPoint(Checker& checker, vtkRenderer* renderer, const ViewRays& rays, const Setup& setup,
  vtkMatrix4x4* actor, const double reference[3], double x, double y, double t)
{
  const Ray ray = rays.GetRay(x, y);
  double model[4] = { 0.0, 0.0, 0.0, 1.0 };
  double view[3];
  for (int i = 0; i < 3; ++i)
  {
    model[i] = reference[i] + ray.ModelOrigin[i] + t * ray.Length * ray.ModelDirection[i];
    view[i] = ray.ViewOrigin[i] + t * ray.Length * ray.ViewDirection[i];
  }
  double world[4] = { model[0], model[1], model[2], 1.0 };
  if (actor)
  {
    actor->MultiplyPoint(model, world);
  }
  double device[3] = { world[0], world[1], world[2] };
  renderer->WorldToView(device[0], device[1], device[2]);
  checker.CheckNear(0.5 * (device[0] + 1.0) * Width, x, setup.Tolerance, "x of the pixel");
  checker.CheckNear(0.5 * (device[1] + 1.0) * Height, y, setup.Tolerance, "y of the pixel");
  // WorldToView's depth runs from 0 to 1.
  const double depth = device[2];
  checker.CheckNear(rays.GetDepth(view), depth, setup.Tolerance, "depth");
  if (setup.Offset == 0.0)
  {
    checker.CheckNear(rays.GetParameter(x, y, depth), t * ray.Length, 1e-6, "parameter of a depth");
  }

  // A plane through the point keeps what is on its side.
  const double normal[3] = { 0.6, -0.3, -0.74 };
  double first = 0.0;
  double last = ray.Length;
  rays.Clip(ray, world, normal, first, last);
  double camera[3];
  renderer->GetActiveCamera()->GetPosition(camera);
  double ahead[3];
  renderer->GetActiveCamera()->GetDirectionOfProjection(ahead);
  if (!setup.Parallel)
  {
    vtkMath::Subtract(world, camera, ahead);
  }
  const bool entering = vtkMath::Dot(normal, ahead) > 0.0;
  checker.CheckNear(
    entering ? first : last, t * ray.Length, 1e-5 * (1.0 + setup.Offset), "cut by a plane");
}

void CheckSetup(Checker& checker, const Setup& setup)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->SetOffScreenRendering(true);
  window->SetSize(Width, Height);
  window->AddRenderer(renderer);
  vtkNew<vtkCamera> camera;
  const double o = setup.Offset;
  camera->SetPosition(o + 3.0, o - 2.0, o + 4.0);
  camera->SetFocalPoint(o + 0.5, o + 0.3, o - 0.2);
  camera->SetViewUp(0.1, 0.9, 0.2);
  camera->SetViewAngle(37.0);
  camera->SetParallelProjection(setup.Parallel);
  camera->SetParallelScale(1.7);
  camera->SetClippingRange(0.5, 30.0);
  renderer->SetActiveCamera(camera);
  vtkNew<vtkTransform> transform;
  if (setup.Actor)
  {
    transform->Translate(0.2, -0.3, 0.1);
    transform->RotateWXYZ(50.0, 1.0, 2.0, -0.5);
    transform->Scale(1.0, 2.5, 0.5);
  }
  vtkMatrix4x4* actor = setup.Actor ? transform->GetMatrix() : nullptr;
  const double reference[3] = { o + 0.1, o + 0.2, o - 0.1 };
  const ViewRays rays(camera, Width, Height, actor, reference);
  Random random(11);
  for (int i = 0; i < 200; ++i)
  {
    CheckPoint(checker, renderer, rays, setup, actor, reference, random.Uniform(0, Width),
      random.Uniform(0, Height), random.Uniform(0.01, 0.99));
  }
}
}

int TestViewRays(int, char*[])
{
  Checker checker;
  CheckSetup(checker, { false, 0.0, 1e-9, false });
  CheckSetup(checker, { true, 0.0, 1e-9, false });
  CheckSetup(checker, { false, 0.0, 1e-9, true });
  CheckSetup(checker, { true, 0.0, 1e-9, true });
  // At 1e6, doubles of world coordinates are 1e-10 apart and WorldToView loses 1e-9 of the view.
  CheckSetup(checker, { false, 1e6, 1e-5, false });
  CheckSetup(checker, { true, 1e6, 1e-5, false });
  return checker.GetExitCode();
}
