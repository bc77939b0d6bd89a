// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what the ray caster draws of a model: the picture must be that of the reference renderer,
// which intersects the decoded segments in double precision without any grid walk of ours. Here the
// cases are shapes and data: crowded voxels, radii, joints, ends, encodings, scalars, placement.
// TestVoxelLineReferenceRays has those of camera, rays and hit buffers.

#include "VoxelLineReferenceTesting.h"

#include "CapsulesFromLines.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"

using namespace VoxelLineMapperTesting;

namespace
{
// More lines than 255, the limit of a byte, in one voxel.
void TestCrowdedVoxel(ReferenceStage& stage, Checks& check)
{
  std::vector<Curve> curves;
  linesets::Random random(11);
  for (int i = 0; i < 1000; ++i)
  {
    const double y = random.Uniform(-0.1, 0.1);
    const double z = random.Uniform(-0.1, 0.1);
    curves.push_back({ { -1.0, y, z }, { 1.0, y, z } });
  }
  ReferenceCase what;
  what.Lines = MakeLines(curves);
  what.Resolution = 8;
  what.Radius = 0.02;
  // Up to 76 layers per pixel have many more edges than other cases.
  what.EdgePixels = 8;
  vtkIdType voxels = 0;
  what.View = [&voxels](vtkCamera* camera, vtkVoxelLineModel* model)
  {
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.6, 0.5, 0.8);
    camera->SetViewAngle(30.0);
    camera->SetClippingRange(0.01, 10.0);
    voxels = model->GetNumberOfOccupiedVoxels();
  };
  for (const double opacity : { 1.0, 0.25 })
  {
    what.Name = opacity < 1.0 ? "1000 lines in a voxel, transparent" : "1000 lines in a voxel";
    what.Opacity = opacity;
    what.FaceBins = opacity < 1.0 ? 0 : 2048;
    ReferenceResult result;
    stage.Run(what, result);
    const auto segments = static_cast<vtkIdType>(result.Scene.Capsules.size());
    check(segments >= 8000, what.Name + ": 8 voxels in a row hold all lines");
    check(segments > 255 * voxels, what.Name + ": voxels hold more than 255");
  }
}

// Tubes that reach into neighbours of their voxel, of the next one, and of the one after.
void TestRadii(ReferenceStage& stage)
{
  for (const double radius : { 0.2, 0.9, 1.5, 3.0 })
  {
    for (const double opacity : { 1.0, 0.3 })
    {
      std::ostringstream name;
      name << "radius " << radius << " opacity " << opacity;
      ReferenceCase what;
      what.Name = name.str();
      what.Lines = MakeLines(MakeBundle(8, 60, 21));
      what.Radius = radius;
      what.Opacity = opacity;
      what.Resolution = 24;
      stage.Run(what);
    }
  }
}

// A curve is one layer, also where its segments overlap at joints.
void TestJoints(ReferenceStage& stage, Checks& check)
{
  ReferenceCase what;
  what.Opacity = 0.25;
  what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
  {
    camera->SetPosition(0.0, 0.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.1, 10.0);
  };
  ReferenceResult bent;
  what.Name = "bent line";
  what.Radius = 1.0;
  what.Lines = MakeLines({ { { -1.0, -0.5, 0.1 }, { 0.0, 0.7, 0.0 }, { 1.0, -0.5, -0.2 } } });
  stage.Run(what, bent);
  check(bent.MostLayers == 1, "bent line: one layer at the joint");

  ReferenceResult loop;
  what.Name = "closed loop";
  Curve circle;
  for (int i = 0; i <= 40; ++i)
  {
    circle.push_back({ std::cos(Pi * i / 20.0), std::sin(Pi * i / 20.0), 0.2 });
  }
  circle.back() = circle.front();
  what.Lines = MakeLines({ circle });
  stage.Run(what, loop);
  check(loop.MostLayers == 1, "closed loop: one layer where it closes");

  ReferenceResult helix;
  what.Name = "helix";
  what.Lines = MakeLines({ MakeHelix(1.0, 1.6, 3.0, 120) });
  stage.Run(what, helix);
  check(helix.MostLayers >= 2, "helix: front and back are layers of their own");

  ReferenceResult wound;
  what.Name = "helix smaller than a voxel";
  what.Radius = 0.1;
  what.Lines =
    MakeLines({ MakeHelix(0.05, 0.1, 3.0, 120), { { -1.0, 0.0, 0.0 }, { 1.0, 0.3, 0.0 } } });
  what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
  {
    camera->SetPosition(0.0, 0.0, 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(18.0);
    camera->SetClippingRange(0.1, 10.0);
  };
  stage.Run(what, wound);
  check(wound.Scene.Capsules.size() > 40, "helix smaller than a voxel: points inside are kept");
}

// Curves whose numbers agree in their lowest bits must stay two layers where they cross.
void TestCrossing(ReferenceStage& stage, Checks& check)
{
  std::vector<Curve> curves;
  for (int i = 0; i <= 64; ++i)
  {
    const double y = 0.5 + 0.008 * i;
    curves.push_back({ { -1.0, y, 0.0 }, { 1.0, y, 0.0 } });
  }
  curves[0] = { { -1.0, -1.0, 0.02 }, { 1.0, 0.5, 0.02 } };
  curves[32] = { { -1.0, 0.5, -0.01 }, { 1.0, -1.0, -0.01 } };
  curves[64] = { { 0.0, -1.0, 0.0 }, { 0.0, 0.5, 0.0 } };
  ReferenceCase what;
  what.Name = "curves 0, 32 and 64 crossing";
  what.Lines = MakeLines(curves);
  what.Opacity = 0.25;
  what.Radius = 0.7;
  what.View = [](vtkCamera* camera, vtkVoxelLineModel*)
  {
    camera->SetPosition(0.0, -0.25, 3.0);
    camera->SetFocalPoint(0.0, -0.25, 0.0);
    camera->SetClippingRange(0.1, 10.0);
  };
  ReferenceResult result;
  stage.Run(what, result);
  check(result.LayersAt(100, 75) == 3, "curves 0, 32 and 64 crossing: three layers");
}

// Ends are round, and a line need not touch any face of its voxel.
void TestEnds(ReferenceStage& stage)
{
  std::vector<Curve> curves;
  linesets::Random random(31);
  for (int i = 0; i < 60; ++i)
  {
    Point a;
    Point b;
    for (int k = 0; k < 3; ++k)
    {
      a[k] = random.Uniform(-1.0, 1.0);
      b[k] = a[k] + random.Uniform(-0.05, 0.05);
    }
    curves.push_back({ a, b });
  }
  curves.push_back({ { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } });
  ReferenceCase what;
  what.Lines = MakeLines(curves);
  for (const double opacity : { 1.0, 0.4 })
  {
    what.Name = opacity < 1.0 ? "lines within voxels, transparent" : "lines within voxels";
    what.Opacity = opacity;
    stage.Run(what);
  }
}

// Round cones.
void TestRadiusArray(ReferenceStage& stage)
{
  ReferenceCase what;
  what.Lines = MakeLines(MakeBundle(6, 40, 41));
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radii");
  for (vtkIdType i = 0; i < what.Lines->GetNumberOfPoints(); ++i)
  {
    radii->InsertNextValue(0.07 + 0.065 * std::sin(0.9 * static_cast<double>(i)));
  }
  what.Lines->GetPointData()->AddArray(radii);
  what.RadiusArray = "radii";
  what.Radius = 0.0;
  for (const double opacity : { 1.0, 0.3 })
  {
    what.Name = opacity < 1.0 ? "radius per point, transparent" : "radius per point";
    what.Opacity = opacity;
    stage.Run(what);
  }
}

// One word, two words and exact points.
void TestEncodings(ReferenceStage& stage, Checks& check)
{
  for (const int bins : { 0, 2048, 64, 32, 4, 2 })
  {
    ReferenceCase what;
    what.Name = "face bins " + std::to_string(bins);
    what.Lines = MakeLines(MakeBundle(10, 50, 51));
    what.FaceBins = bins;
    what.Opacity = 0.5;
    int words = 0;
    what.View = [&words](vtkCamera*, vtkVoxelLineModel* model)
    { words = model->GetSegmentWords(); };
    stage.Run(what);
    check(words == (bins == 0 ? 6 : (bins > 32 ? 2 : 1)), what.Name + ": words of a segment");
  }
}

// A scalar that is not a number has a colour of its own, on its half of a segment.
void SplitNaN(linesets::CapsuleScene& scene)
{
  std::vector<linesets::Capsule> split;
  for (const linesets::Capsule& capsule : scene.Capsules)
  {
    split.push_back(capsule);
    if (std::isnan(capsule.StartValue) == std::isnan(capsule.EndValue))
    {
      continue;
    }
    split.push_back(capsule);
    linesets::Capsule& first = split[split.size() - 2];
    linesets::Capsule& second = split.back();
    for (int i = 0; i < 3; ++i)
    {
      first.End[i] = second.Start[i] = 0.5 * (capsule.Start[i] + capsule.End[i]);
    }
    first.EndValue = capsule.StartValue;
    second.StartValue = capsule.EndValue;
  }
  scene.Capsules.swap(split);
}

void TestScalars(ReferenceStage& stage, Checks& check)
{
  ReferenceCase what;
  what.Name = "scalars with NaN";
  what.Lines = MakeLines(MakeBundle(6, 50, 61));
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalars");
  for (vtkIdType i = 0; i < what.Lines->GetNumberOfPoints(); ++i)
  {
    scalars->InsertNextValue(i % 9 < 3 ? vtkMath::Nan() : std::sin(0.1 * static_cast<double>(i)));
  }
  what.Lines->GetPointData()->SetScalars(scalars);
  what.Radius = 0.8;
  what.Opacity = 0.6;
  what.Place = [](vtkVoxelLineMapper* mapper, vtkActor*)
  {
    vtkNew<vtkLookupTable> table;
    // Neighbouring colours differ by less than 2: the table is looked up by one or the other.
    table->SetHueRange(0.6, 0.3);
    table->SetNanColor(1.0, 1.0, 1.0, 1.0);
    table->Build();
    mapper->SetLookupTable(table);
    mapper->SetScalarRange(-1.0, 1.0);
  };
  what.Adapt = SplitNaN;
  ReferenceResult result;
  stage.Run(what, result);
  check(std::any_of(result.Scene.Capsules.begin(), result.Scene.Capsules.end(),
          [](const linesets::Capsule& capsule) { return std::isnan(capsule.StartValue); }),
    "scalars with NaN: there are some");
}

// Grids of one voxel along one or two axes, far away, and matrices that are not rigid.
void TestPlacement(ReferenceStage& stage)
{
  std::vector<Curve> plane = MakeBundle(10, 60, 71);
  for (Curve& curve : plane)
  {
    for (Point& point : curve)
    {
      point[2] = 0.25;
    }
  }
  ReferenceCase what;
  what.Opacity = 0.5;
  what.Name = "planar data";
  what.Lines = MakeLines(plane);
  stage.Run(what);

  what.Name = "one line";
  what.Lines = MakeLines({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } });
  stage.Run(what);

  std::vector<Curve> far = MakeBundle(8, 60, 72);
  for (Curve& curve : far)
  {
    for (Point& point : curve)
    {
      point = { point[0] + 1e9, point[1] - 1e9, point[2] + 1e9 };
    }
  }
  what.Name = "offset of 1e9";
  what.Lines = MakeLines(far);
  stage.Run(what);

  what.Name = "stretched actor";
  what.Lines = MakeLines(MakeBundle(8, 60, 73));
  what.Place = [](vtkVoxelLineMapper*, vtkActor* actor)
  {
    actor->SetScale(1.0, 2.0, 0.5);
    actor->RotateX(25.0);
    actor->RotateZ(40.0);
    actor->SetPosition(3.0, -2.0, 1.0);
  };
  for (const double opacity : { 1.0, 0.5 })
  {
    what.Opacity = opacity;
    what.Name = opacity < 1.0 ? "stretched actor, transparent" : "stretched actor";
    stage.Run(what);
  }
}

// What the model loses by default: the lines as they came, not as they were decoded.
void TestOriginalLines(ReferenceStage& stage, Checks& check)
{
  ReferenceCase what;
  what.Name = "original lines";
  what.Lines = MakeLines(MakeBundle(40, 300, 81));
  what.Resolution = 256;
  what.Radius = 0.5;
  what.View = [](vtkCamera* camera, vtkVoxelLineModel*) { camera->Zoom(8.0); };
  linesets::LineOptions options;
  vtkSmartPointer<vtkPolyData> lines = what.Lines;
  ReferenceResult decoded;
  stage.Run(what, decoded);

  what.Name = "original lines, decoded against original";
  double voxel = 0.0;
  what.View = [&voxel](vtkCamera* camera, vtkVoxelLineModel* model)
  {
    camera->Zoom(8.0);
    voxel = model->GetVoxelSize();
  };
  what.Adapt = [&](linesets::CapsuleScene& scene)
  {
    options.Radius = 0.5 * voxel;
    scene = linesets::MakeCapsulesFromLines(lines, options);
  };
  what.IsExact = false;
  ReferenceResult original;
  stage.Run(what, original);
  const double similarity = linesets::GetStructuralSimilarity(original.Ours, original.Theirs);
  std::cout << "structural similarity " << similarity << std::endl;
  check(similarity >= 0.98, "original lines: structural similarity " + std::to_string(similarity));
}
}

int TestVoxelLineReference(int argc, char* argv[])
{
  Checks check;
  auto messages = Listen();
  ReferenceStage stage(check, argc, argv);
  TestCrowdedVoxel(stage, check);
  TestRadii(stage);
  TestJoints(stage, check);
  TestCrossing(stage, check);
  TestEnds(stage);
  TestRadiusArray(stage);
  TestEncodings(stage, check);
  TestScalars(stage, check);
  TestPlacement(stage);
  TestOriginalLines(stage, check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
