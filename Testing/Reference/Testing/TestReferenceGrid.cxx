// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the grid of candidates: images with it and without it are equal bit for bit, in all kinds
// of views, and so are images by different numbers of threads.

#include "ReferenceRenderer.h"
#include "ReferenceTesting.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

using namespace linesets;

namespace
{
bool AreEqual(const ReferenceImage& a, const ReferenceImage& b)
{
  return a.Color == b.Color && a.Opacity == b.Opacity && a.Depth == b.Depth && a.Curve == b.Curve &&
    a.Layers == b.Layers;
}

void CheckView(Checker& checker, ReferenceRenderer& renderer, const std::string& what)
{
  ReferenceImage brute;
  ReferenceImage grid;
  renderer.UseGrid = false;
  renderer.Render(brute);
  renderer.UseGrid = true;
  renderer.Render(grid);
  int covered = 0;
  for (const int layers : brute.Layers)
  {
    covered += layers > 0 ? 1 : 0;
  }
  checker.Check(covered > 20, what + ": something is seen, " + std::to_string(covered));
  checker.Check(AreEqual(brute, grid), what + ": grid and brute force are equal");
  ReferenceImage single;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config{ 1, "Sequential", false }, [&]() { renderer.Render(single); });
  checker.Check(AreEqual(grid, single), what + ": one thread and several are equal");
}

void CheckScene(Checker& checker, const CapsuleScene& scene, const std::string& name)
{
  ReferenceRenderer renderer(scene);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkMatrix4x4> matrix;
  renderer.Camera = camera;
  renderer.Width = 90;
  renderer.Height = 70;
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetPosition(2.2, 1.9, 2.4);
  camera->SetClippingRange(0.01, 100);
  CheckView(checker, renderer, name + ", opaque");
  renderer.Surface.Opacity = 0.25;
  CheckView(checker, renderer, name + ", transparent");
  camera->SetPosition(0.5, 0.5, 0.45);
  CheckView(checker, renderer, name + ", from within");
  camera->SetPosition(0.5, 0.5, 4.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.6);
  CheckView(checker, renderer, name + ", along an axis");
  matrix->SetElement(0, 0, 0.5);
  matrix->SetElement(1, 0, 0.4);
  matrix->SetElement(2, 1, -0.7);
  matrix->SetElement(1, 3, 0.2);
  renderer.ActorMatrix = matrix;
  renderer.Planes = { { { 0.5, 0.5, 0.5 }, { 0.3, 0.1, 0.8 } } };
  renderer.Surface.Opacity = 1.0;
  CheckView(checker, renderer, name + ", sheared and cut");
}
}

int TestReferenceGrid(int, char*[])
{
  Checker checker;
  CheckScene(checker, MakeRandomCurves(60, 20, 0.03, 1), "curves");
  CheckScene(checker, MakeRandomCurves(8, 4, 0.25, 2, 0.5), "wide curves");
  CapsuleScene flat = MakeRandomCurves(40, 10, 0.01, 3);
  for (Capsule& capsule : flat.Capsules)
  {
    capsule.Start[2] = 0.5;
    capsule.End[2] = 0.5;
  }
  CheckScene(checker, flat, "flat curves");
  return checker.GetExitCode();
}
