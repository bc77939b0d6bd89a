// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the ray caster's walk through the grid: the picture must be that of the reference renderer
// wherever rays start and whatever their direction is, with clipping planes, and where a ray has
// more hits than its buffers hold.

#include "VoxelLineReferenceTesting.h"

#include "vtkPlane.h"

using namespace VoxelLineMapperTesting;

namespace
{
void TestProjections(ReferenceStage& stage)
{
  ReferenceCase what;
  what.Lines = MakeLines(MakeBundle(20, 80, 101));
  what.Resolution = 32;
  what.Radius = 0.8;
  what.Width = 120;
  what.Height = 90;
  for (const double opacity : { 1.0, 0.3 })
  {
    const std::string end = opacity < 1.0 ? ", transparent" : "";
    what.Opacity = opacity;
    what.PartOfTies = 0.0;
    what.Name = "perspective from outside" + end;
    what.View = {};
    stage.Run(what);
    what.Name = "parallel from outside" + end;
    what.View = [](vtkCamera* camera, vtkVoxelLineModel*) { camera->ParallelProjectionOn(); };
    stage.Run(what);
    what.PartOfTies = 0.01;

    what.Name = "perspective within the grid" + end;
    what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
    {
      camera->SetPosition(0.11, -0.07, 0.05);
      camera->SetFocalPoint(1.0, 0.4, -0.3);
      camera->SetViewAngle(100.0);
      camera->SetClippingRange(0.01, 10.0);
    };
    stage.Run(what);
    what.Name = "parallel within the grid" + end;
    what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
    {
      camera->ParallelProjectionOn();
      camera->SetPosition(0.11, -0.07, 0.05);
      camera->SetFocalPoint(1.0, 0.4, -0.3);
      camera->SetParallelScale(0.8);
      camera->SetClippingRange(0.001, 10.0);
    };
    stage.Run(what);
  }
}

// The far wall of the tube is seen, and what lies within it comes before. Straight lines with exact
// points have hardly any ties; bent ones have.
void TestInsideTube(ReferenceStage& stage)
{
  const Curve helix = MakeHelix(0.6, 1.5, 2.0, 100);
  const Curve rod{ { -0.9, -0.3, 0.2 }, { 0.8, 0.9, -0.1 } };
  for (int i = 0; i < 8; ++i)
  {
    const bool isBent = i % 2 == 1;
    const bool isParallel = i / 2 % 2 == 1;
    std::vector<Curve> curves = isBent ? MakeBundle(6, 60, 111) : MakeStraightLines(12, 112);
    curves.push_back(isBent ? helix : rod);
    curves.push_back({ { 0.5, -1.0, 0.1 }, { 0.7, 1.0, 0.0 } });
    ReferenceCase what;
    what.Lines = MakeLines(curves);
    what.Resolution = 32;
    what.Radius = 3.0;
    what.FaceBins = isBent ? 32 : 0;
    what.PartOfTies = isBent ? 0.15 : 0.02;
    what.Width = 100;
    what.Height = 75;
    what.Opacity = i < 4 ? 1.0 : 0.3;
    what.Name = std::string(isParallel ? "parallel" : "perspective") + " within a " +
      (isBent ? "bent" : "straight") + " tube" + (i < 4 ? "" : ", transparent");
    what.View = [&](vtkCamera* camera, vtkVoxelLineModel*)
    {
      camera->SetParallelProjection(isParallel);
      camera->SetParallelScale(0.3);
      camera->SetViewAngle(90.0);
      const Point at = isBent ? helix[50] : Point{ -0.05, 0.3, 0.05 };
      camera->SetPosition(at[0] + 0.01, at[1], at[2] + 0.013);
      camera->SetFocalPoint(isBent ? helix[53].data() : rod[1].data());
      camera->SetClippingRange(0.001, 10.0);
    };
    stage.Run(what);
  }
}

// Rays along axes and diagonals, many of them in planes between voxels, which hold tubes, too.
void TestDirections(ReferenceStage& stage)
{
  std::vector<Curve> curves = MakeBundle(5, 40, 121);
  // The grid: lines along all axes and diagonals, through corners of voxels.
  for (int i = 0; i < 13; ++i)
  {
    const Point d = { double((i + 14) % 3 - 1), double((i + 14) / 3 % 3 - 1),
      double((i + 14) / 9 - 1) };
    curves.push_back({ { -d[0], -d[1], -d[2] }, d });
  }
  ReferenceCase what;
  what.Lines = MakeLines(curves);
  what.Opacity = 0.5;
  what.Radius = 0.3;
  // Odd, so that the middle pixel looks exactly along the direction.
  what.Width = 81;
  what.Height = 61;
  for (int i = 0; i < 27; ++i)
  {
    const Point d = { double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1) };
    if (i == 13)
    {
      continue;
    }
    for (const bool parallel : { true, false })
    {
      std::ostringstream name;
      name << (parallel ? "parallel" : "perspective") << " along " << d[0] << " " << d[1] << " "
           << d[2];
      what.Name = name.str();
      what.View = [&](vtkCamera* camera, vtkVoxelLineModel* model)
      {
        const double voxel = model->GetVoxelSize();
        double corner[3];
        double position[3];
        for (int k = 0; k < 3; ++k)
        {
          corner[k] = model->GetOrigin()[k] + voxel * (model->GetDimensions()[k] / 2);
          position[k] = corner[k] - 12.0 * voxel * d[k];
        }
        camera->SetFocalPoint(corner);
        camera->SetPosition(position);
        camera->SetViewUp(0.0, d[1] != 0.0 ? 0.0 : 1.0, d[1] != 0.0 ? 1.0 : 0.0);
        if (d[1] != 0.0 && d[2] != 0.0)
        {
          camera->SetViewUp(
            d[0] == 0.0 ? 1.0 : 0.0, d[0] == 0.0 ? 0.0 : d[2], d[0] == 0.0 ? 0.0 : -d[1]);
        }
        camera->SetParallelProjection(parallel);
        // Four pixels per voxel: every fourth row and column of an axis lies between voxels.
        camera->SetParallelScale(0.5 * what.Height * voxel / 4.0);
        camera->SetViewAngle(60.0);
        camera->SetClippingRange(0.001, 10.0);
      };
      stage.Run(what);
    }
  }
}

// More hits than fit into the buffer of a ray, so that slabs are visited again.
void TestManyHits(ReferenceStage& stage, Checks& check)
{
  std::vector<Curve> curves;
  linesets::Random random(131);
  for (int i = 0; i < 2000; ++i)
  {
    Point a;
    Point b;
    for (int k = 0; k < 3; ++k)
    {
      a[k] = random.Uniform(-1.0, 1.0);
      b[k] = std::min(std::max(a[k] + random.Uniform(-0.8, 0.8), -1.0), 1.0);
    }
    curves.push_back({ a, b });
  }
  ReferenceCase what;
  what.Lines = MakeLines(curves);
  what.Resolution = 12;
  what.Radius = 0.9;
  what.Width = 60;
  what.Height = 45;
  for (const double opacity : { 0.005, 0.02 })
  {
    what.Opacity = opacity;
    what.Name = opacity < 0.01 ? "2000 lines, opacity 0.005" : "2000 lines, opacity 0.02";
    what.View = {};
    ReferenceResult result;
    stage.Run(what, result);
    // The native engine's buffer holds 64 hits.
    check(result.MostLayers > 2 * 64, what.Name + ": more hits than the buffer holds");
  }
  // Overflow in the first part of a slab, which must be visited again from there.
  what.Name = "2000 lines in large voxels";
  what.Resolution = 2;
  what.Radius = 0.16;
  stage.Run(what);
  what.Resolution = 12;
  what.Radius = 0.9;

  what.Name = "2000 lines, from within";
  what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
  {
    camera->SetPosition(0.9, 0.9, 0.93);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(60.0);
    camera->SetClippingRange(0.001, 10.0);
  };
  stage.Run(what);
}

// A plane opens tubes: their far walls are seen from within.
void TestClippingPlanes(ReferenceStage& stage)
{
  for (int i = 0; i < 8; ++i)
  {
    const bool isBent = i % 2 == 1;
    const int planes = 1 + i / 2 % 2;
    ReferenceCase what;
    what.Lines = MakeLines(isBent ? MakeBundle(12, 60, 141) : MakeStraightLines(20, 142));
    what.Radius = 1.2;
    what.Resolution = 24;
    what.FaceBins = isBent ? 32 : 0;
    what.PartOfTies = isBent ? 0.015 : 0.006;
    what.Width = 120;
    what.Height = 90;
    what.Opacity = i < 4 ? 1.0 : 0.4;
    what.Name = std::to_string(planes) + " clipping planes, " + (isBent ? "bent" : "straight") +
      (i < 4 ? "" : ", transparent");
    what.Place = [planes](vtkVoxelLineMapper* mapper, vtkActor*)
    {
      vtkNew<vtkPlane> front;
      front->SetOrigin(0.1, 0.0, 0.2);
      front->SetNormal(-0.5, -0.2, -1.0);
      mapper->AddClippingPlane(front);
      if (planes > 1)
      {
        vtkNew<vtkPlane> back;
        back->SetOrigin(0.0, 0.0, -0.2);
        back->SetNormal(0.5, -0.4, 1.0);
        mapper->AddClippingPlane(back);
      }
    };
    stage.Run(what);
  }
}
}

int TestVoxelLineReferenceRays(int argc, char* argv[])
{
  Checks check;
  auto messages = Listen();
  ReferenceStage stage(check, argc, argv);
  TestProjections(stage);
  TestInsideTube(stage);
  TestDirections(stage);
  TestManyHits(stage, check);
  TestClippingPlanes(stage);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
