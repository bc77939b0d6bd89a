// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the way from camera, actor and grid to the single precision numbers of a frame: a ray
// through the pixel that a point is projected to must pass that point, at its depth, whatever the
// projection, and wherever in the world data, actor and camera are.

#include "VoxelLineMapperTesting.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkTransform.h"
#include "vtkVoxelLineFrameBuilder.h"

#include <functional>
#include <random>

using namespace VoxelLineMapperTesting;
using Builder = vtkVoxelLineFrameBuilder;

namespace
{
struct Case
{
  std::string Name;
  Builder::Grid Grid;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkTransform> Actor;
};

void Prepare(Case& test, const std::function<void(Case&)>& change)
{
  test.Grid.VoxelSize = 0.5;
  test.Grid.Dimensions[0] = 256;
  test.Grid.Dimensions[1] = 200;
  test.Grid.Dimensions[2] = 100;
  change(test);
  double corners[2][4];
  for (int i = 0; i < 3; ++i)
  {
    corners[0][i] = test.Grid.Origin[i];
    corners[1][i] = test.Grid.Origin[i] + test.Grid.VoxelSize * test.Grid.Dimensions[i];
  }
  double center[3];
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (corners[0][i] + corners[1][i]);
  }
  test.Actor->TransformPoint(center, center);
  // The camera of the case stands relative to the centre.
  double position[3];
  test.Camera->GetPosition(position);
  for (int i = 0; i < 3; ++i)
  {
    position[i] += center[i];
  }
  test.Camera->SetFocalPoint(center);
  test.Camera->SetPosition(position);
}

Builder::View MakeView(Case& test, int width, int height)
{
  Builder::View view;
  view.ViewportSize[0] = view.PictureSize[0] = width;
  view.ViewportSize[1] = view.PictureSize[1] = height;
  vtkMatrix4x4::DeepCopy(view.ViewFromWorld, test.Camera->GetModelViewTransformMatrix());
  vtkMatrix4x4::DeepCopy(view.ClipFromView,
    test.Camera->GetProjectionTransformMatrix(static_cast<double>(width) / height, -1.0, 1.0));
  vtkMatrix4x4::DeepCopy(view.WorldFromData, test.Actor->GetMatrix());
  return view;
}

void Apply(const double matrix[16], const double in[4], double out[4])
{
  vtkMatrix4x4::MultiplyPoint(matrix, in, out);
}

// Pixel (of the picture) and depth of a grid-local point.
void Project(const Builder::View& view, const Builder::Grid& grid, const double local[3],
  double pixel[2], double& depth)
{
  double a[4];
  double b[4];
  for (int i = 0; i < 3; ++i)
  {
    a[i] = grid.Origin[i] + grid.VoxelSize * local[i];
  }
  a[3] = 1.0;
  Apply(view.WorldFromData, a, b);
  Apply(view.ViewFromWorld, b, a);
  Apply(view.ClipFromView, a, b);
  for (int i = 0; i < 2; ++i)
  {
    pixel[i] = 0.5 * (b[i] / b[3] + 1.0) * view.ViewportSize[i] - view.PictureOrigin[i];
  }
  depth = 0.5 * b[2] / b[3] + 0.5;
}

// Largest distance, in pixels across the ray, between points and the rays through their pixels, and
// largest error of their depths.
void Measure(const Builder::View& view, const Builder::Grid& grid, const vtkVoxelLineFrame& frame,
  double& largestOffset, double& largestDepth)
{
  std::mt19937 generator(7);
  const auto uniform = [&generator]() { return generator() / 4294967296.0; };
  largestOffset = 0.0;
  largestDepth = 0.0;
  for (int k = 0; k < 200; ++k)
  {
    const double local[3] = { grid.Dimensions[0] * uniform(), grid.Dimensions[1] * uniform(),
      grid.Dimensions[2] * uniform() };
    double pixel[2];
    double depth;
    Project(view, grid, local, pixel, depth);
    const auto x = static_cast<float>(pixel[0]);
    const auto y = static_cast<float>(pixel[1]);
    const glm::vec3 origin = frame.Origin[0] + x * frame.Origin[1] + y * frame.Origin[2];
    const glm::vec3 direction =
      frame.Direction[0] + x * frame.Direction[1] + y * frame.Direction[2];
    const glm::vec3 point(
      static_cast<float>(local[0]), static_cast<float>(local[1]), static_cast<float>(local[2]));
    const float s = glm::dot(point - origin, direction) / glm::dot(direction, direction);
    const glm::vec3 seen = origin + s * direction;
    // The size of a pixel there.
    const float size = glm::length(frame.Origin[1] + s * frame.Direction[1]);
    largestOffset = std::max(largestOffset, static_cast<double>(glm::length(seen - point) / size));
    const float found =
      0.5f * (frame.DepthZ[0] + s * frame.DepthZ[1]) / (frame.DepthW[0] + s * frame.DepthW[1]) +
      0.5f;
    if (depth > 0.0 && depth < 1.0)
    {
      largestDepth = std::max(largestDepth, std::abs(found - depth));
    }
  }
}

// Half a pixel at all distances of the grid, and what follows from it for the widths of tubes.
void CheckWidths(Checks& check, const std::string& name, vtkVoxelLineFrame frame)
{
  const double ends[2] = { std::max(frame.NearestS, frame.BoxS.x),
    std::min(frame.FarthestS, frame.BoxS.y) };
  double largest = 0.0;
  for (int i = 0; i <= 10; ++i)
  {
    const auto s = static_cast<float>(ends[0] + 0.1 * i * (ends[1] - ends[0]));
    double half = 0.0;
    for (int k = 1; k < 3; ++k)
    {
      half = std::max(half, 0.5 * glm::length(frame.Origin[k] + s * frame.Direction[k]));
    }
    const double found = frame.HalfPixel.x + s * frame.HalfPixel.y;
    check(std::abs(found / half - 1.0) < 1e-5, name + ": half a pixel");
    largest = std::max(largest, half);
  }
  frame.Radius = 0.1f;
  const auto isAs = [&](double smallest, bool widen, bool narrow, bool thin)
  {
    const double most = 2.0;
    const bool isLimited = Builder::SetWidths(frame, smallest, widen, most);
    check(isLimited == (frame.ThinTubes && largest > most), name + ": the limit is told");
    // Tubes are widened as far as a pixel reaches, up to a limit.
    const bool limits = frame.ThinTubes
      ? frame.LargestRadius >= 0.999 * std::min(std::max(largest, 0.1), most) &&
        frame.LargestRadius <= std::min(1.1 * largest + 0.1, most)
      : frame.LargestRadius == frame.Radius;
    return frame.NarrowTubes == narrow && frame.ThinTubes == thin && limits;
  };
  check(isAs(2.01 * largest, true, false, false), name + ": wide tubes");
  check(isAs(1.99 * largest, true, true, false), name + ": tubes below two pixels");
  check(isAs(1.01 * largest, true, true, false), name + ": tubes above a pixel");
  check(isAs(0.99 * largest, true, true, true), name + ": tubes below a pixel");
  check(isAs(0.5 * largest, false, false, false), name + ": tubes that are not widened");
}

void CheckCase(Checks& check, const std::string& name, const std::function<void(Case&)>& change)
{
  Case test;
  Prepare(test, change);
  const Builder::View whole = MakeView(test, 640, 480);
  Builder::View part = whole;
  part.PictureOrigin[0] = 400;
  part.PictureOrigin[1] = 17;
  part.PictureSize[0] = 100;
  part.PictureSize[1] = 50;
  for (const Builder::View* view : { &whole, static_cast<const Builder::View*>(&part) })
  {
    vtkVoxelLineFrame frame;
    const std::string error = Builder::SetView(frame, *view, test.Grid);
    check(error.empty(), name + ": " + error);
    CheckWidths(check, name, frame);
    check(frame.Width == view->PictureSize[0] && frame.Height == view->PictureSize[1],
      name + ": size of the frame");
    double offset;
    double depth;
    Measure(*view, test.Grid, frame, offset, depth);
    // A hundredth of a pixel is not seen; a depth buffer has 24 bits, the arithmetic here as well.
    check(offset < 0.01, name + ": rays miss points by " + std::to_string(offset) + " pixels");
    check(depth < 2e-6, name + ": depth is off by " + std::to_string(depth * 1e6) + "e-6");

    // Near and far plane.
    for (int side = 0; side < 2; ++side)
    {
      const float s = side == 0 ? frame.NearestS : frame.FarthestS;
      const float z =
        (frame.DepthZ[0] + s * frame.DepthZ[1]) / (frame.DepthW[0] + s * frame.DepthW[1]);
      check(std::abs(z - (side == 0 ? -1.0f : 1.0f)) < 1e-3f,
        name + ": depth " + std::to_string(z) + " where rays begin or end");
    }
    // s is counted in world units from a plane near the grid.
    double range[2];
    test.Camera->GetClippingRange(range);
    const double span = frame.FarthestS - static_cast<double>(frame.NearestS);
    check(std::abs(span / (range[1] - range[0]) - 1.0) < 1e-3, name + ": unit of s");

    // Back from a pixel's depth to the data.
    const double local[3] = { 100.0, 90.0, 40.0 };
    double pixel[2];
    Project(*view, test.Grid, local, pixel, depth);
    double position[3];
    Builder::GetDataPosition(frame, test.Grid, static_cast<int>(std::floor(pixel[0])),
      static_cast<int>(std::floor(pixel[1])), depth, position);
    const double pixelSize =
      glm::length(frame.Origin[1]) + glm::length(frame.Direction[1]) * std::abs(frame.FarthestS);
    for (int i = 0; i < 3; ++i)
    {
      const double voxel = (position[i] - test.Grid.Origin[i]) / test.Grid.VoxelSize;
      check(std::abs(voxel - local[i]) < 2.0 * pixelSize + 0.1, name + ": position of a depth");
    }
  }
}

void CheckViews(Checks& check)
{
  const auto standard = [](Case& test)
  {
    test.Camera->SetPosition(100.0, 150.0, 300.0);
    test.Camera->SetClippingRange(100.0, 700.0);
  };
  CheckCase(check, "perspective", standard);
  CheckCase(check, "parallel",
    [&](Case& test)
    {
      standard(test);
      test.Camera->ParallelProjectionOn();
      test.Camera->SetParallelScale(60.0);
    });
  CheckCase(check, "off axis, sheared",
    [&](Case& test)
    {
      standard(test);
      test.Camera->SetWindowCenter(0.4, -0.3);
      test.Camera->SetViewShear(0.1, 0.2, 1.0);
    });
  CheckCase(check, "explicit projection",
    [&](Case& test)
    {
      standard(test);
      vtkNew<vtkMatrix4x4> matrix;
      matrix->DeepCopy(test.Camera->GetProjectionTransformMatrix(1.3, -1.0, 1.0));
      matrix->SetElement(0, 1, 0.2);
      matrix->SetElement(0, 2, -0.3);
      test.Camera->SetExplicitProjectionTransformMatrix(matrix);
      test.Camera->UseExplicitProjectionTransformMatrixOn();
    });
  CheckCase(check, "far camera, narrow angle",
    [](Case& test)
    {
      test.Camera->SetPosition(1e7, 2e7, 3e7);
      test.Camera->SetViewAngle(2e-4);
      test.Camera->SetClippingRange(3.7e7, 3.8e7);
    });
  CheckCase(check, "actor stretched, turned and mirrored",
    [&](Case& test)
    {
      standard(test);
      test.Actor->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
      test.Actor->Scale(1.0, -2.0, 0.4);
      test.Actor->Translate(10.0, 20.0, -5.0);
    });
  CheckCase(check, "data far from the origin",
    [&](Case& test)
    {
      standard(test);
      test.Grid.Origin[0] = 1e9;
      test.Grid.Origin[1] = -2e9;
      test.Grid.Origin[2] = 3e9;
    });
  CheckCase(check, "data far from the origin, brought back by the actor",
    [&](Case& test)
    {
      standard(test);
      test.Grid.Origin[0] = 1e8;
      test.Grid.Origin[1] = 1e8;
      test.Actor->Scale(0.5, 1.0, 1.0);
      test.Actor->Translate(-1e8, -1e8, 0.0);
    });
  CheckCase(check, "tiny data",
    [](Case& test)
    {
      test.Grid.VoxelSize = 1e-12;
      test.Camera->SetPosition(2e-10, 3e-10, 6e-10);
      test.Camera->SetClippingRange(2e-10, 14e-10);
    });
}

void CheckImpossibleViews(Checks& check)
{
  Case test;
  Prepare(test, [](Case& c) { c.Camera->SetPosition(0.0, 0.0, 300.0); });
  const Builder::View good = MakeView(test, 64, 48);
  vtkVoxelLineFrame frame;
  check(Builder::SetView(frame, good, test.Grid).empty(), "a view that is fine");
  Builder::View bad = good;
  bad.WorldFromData[0] = 0.0;
  check(!Builder::SetView(frame, bad, test.Grid).empty(), "an actor of no extent is told");
  bad = good;
  bad.ViewFromWorld[3] = std::numeric_limits<double>::quiet_NaN();
  check(!Builder::SetView(frame, bad, test.Grid).empty(), "a camera that is not finite is told");
  bad = good;
  bad.ClipFromView[12] = 0.1;
  check(!Builder::SetView(frame, bad, test.Grid).empty(), "a slanted projection is told");
}

// Half spaces of the world, in grid-local coordinates.
void CheckClippingPlanes(Checks& check)
{
  Case test;
  Prepare(test,
    [](Case& c)
    {
      c.Camera->SetPosition(0.0, 0.0, 300.0);
      c.Grid.Origin[0] = 5e8;
      c.Actor->RotateZ(30.0);
      c.Actor->Scale(2.0, 1.0, 3.0);
    });
  const Builder::View view = MakeView(test, 64, 48);
  const double inside[3] = { 17.0, 120.0, 60.0 };
  double world[3];
  for (int i = 0; i < 3; ++i)
  {
    world[i] = test.Grid.Origin[i] + test.Grid.VoxelSize * inside[i];
  }
  test.Actor->TransformPoint(world, world);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(world);
  plane->SetNormal(1.0, 2.0, -1.0);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  vtkVoxelLineFrame frame;
  Builder::SetClippingPlanes(frame, planes, view, test.Grid);
  if (!check(frame.ClippingPlanes.size() == 1, "one clipping plane"))
  {
    return;
  }
  std::mt19937 generator(3);
  for (int k = 0; k < 100; ++k)
  {
    double local[3];
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      local[i] = test.Grid.Dimensions[i] * (generator() / 4294967296.0);
      point[i] = test.Grid.Origin[i] + test.Grid.VoxelSize * local[i];
    }
    test.Actor->TransformPoint(point, point);
    const double expected = plane->EvaluateFunction(point);
    const glm::vec4& p = frame.ClippingPlanes[0];
    const double found = p[0] * local[0] + p[1] * local[1] + p[2] * local[2] + p[3];
    // Points within a thousandth of a voxel of the plane may be on either side.
    check(std::abs(found) < 1e-3 || (found > 0.0) == (expected > 0.0), "side of a clipping plane");
  }
  Builder::SetClippingPlanes(frame, nullptr, view, test.Grid);
  check(frame.ClippingPlanes.empty(), "no clipping planes");
}

// A picture is replayed only where nothing changed: every field of the frame counts.
void CheckSamePicture(Checks& check)
{
  vtkVoxelLineFrame frame;
  for (auto& color : frame.ColorTable)
  {
    color = glm::vec4(1.0f);
  }
  for (int i = 0; i < 3; ++i)
  {
    frame.Origin[i] = glm::vec3(1.0f);
    frame.Direction[i] = glm::vec3(1.0f);
  }
  frame.Coloring = vtkVoxelLineFrame::Table;
  frame.Light.Lights.resize(1);
  frame.ClippingPlanes.emplace_back(1.0f);
  check(Builder::IsSamePicture(frame, frame), "a frame is the same as itself");
  // A camera that is set to where it was need not get the very same numbers.
  vtkVoxelLineFrame rounded = frame;
  rounded.Origin[0] *= 1.0000002f;
  rounded.NearestS *= 1.0000002f;
  check(Builder::IsSamePicture(frame, rounded), "rounding makes no other picture");
  using Change = std::function<void(vtkVoxelLineFrame&)>;
  const std::vector<Change> changes = { [](vtkVoxelLineFrame& f) { f.Width = 3; },
    [](vtkVoxelLineFrame& f) { f.Height = 3; }, [](vtkVoxelLineFrame& f) { f.Origin[2].z = 0.0f; },
    [](vtkVoxelLineFrame& f) { f.Direction[1].x = 0.0f; },
    [](vtkVoxelLineFrame& f) { f.NearestS = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.FarthestS = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.DepthZ.y = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.DepthW.x = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.ViewFromLocal[3].x = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.NormalFromLocal[2].x = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.ClippingPlanes[0].w = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.ClippingPlanes.clear(); },
    [](vtkVoxelLineFrame& f) { f.Radius = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.LargestRadius = 3.0f; },
    [](vtkVoxelLineFrame& f) { f.NarrowTubes = true; },
    [](vtkVoxelLineFrame& f) { f.ThinTubes = true; },
    [](vtkVoxelLineFrame& f) { f.LitAsLines = true; },
    [](vtkVoxelLineFrame& f) { f.OpacityByPathLength = true; },
    [](vtkVoxelLineFrame& f) { f.Interactive = true; },
    [](vtkVoxelLineFrame& f) { f.AccelerationOpacity = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Global.Shadows = 1; },
    [](vtkVoxelLineFrame& f) { f.Global.Occlusion = 1; },
    [](vtkVoxelLineFrame& f) { f.Global.Lights.emplace_back(1.0f); },
    [](vtkVoxelLineFrame& f) { f.Global.ConeSpread = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Global.DensitiesTime = 3; },
    [](vtkVoxelLineFrame& f) { f.SecondaryRays = true; },
    [](vtkVoxelLineFrame& f) { f.LevelRays = true; },
    [](vtkVoxelLineFrame& f) { f.ShadowLevel = 2; },
    [](vtkVoxelLineFrame& f) { f.Coloring = vtkVoxelLineFrame::Direct; },
    [](vtkVoxelLineFrame& f) { f.ColorTable[255].w = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.HasNaN = true; },
    [](vtkVoxelLineFrame& f) { f.AmbientColor.x = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.DiffuseColor.y = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.SpecularColor.z = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Ambient = 0.5f; }, [](vtkVoxelLineFrame& f) { f.Diffuse = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Specular = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.SpecularPower = 5.0f; },
    [](vtkVoxelLineFrame& f) { f.Opacity = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Lighting = false; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Color.x = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Kind = 2; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Direction.x = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Position.x = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Attenuation.x = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].CosConeAngle = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights[0].Exponent = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Light.Lights.clear(); },
    [](vtkVoxelLineFrame& f) { f.Light.ParallelView = true; },
    [](vtkVoxelLineFrame& f) { f.Light.Model = 1; },
    [](vtkVoxelLineFrame& f) { f.Light.Reflection = 1; },
    [](vtkVoxelLineFrame& f) { f.Light.StretchDynamicRange = true; },
    [](vtkVoxelLineFrame& f) { f.Light.Table = vtkLineIlluminationTable::Get(0.01); },
    [](vtkVoxelLineFrame& f) { f.EarlyTermination = 0.5f; },
    [](vtkVoxelLineFrame& f) { f.Picking = true; } };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    vtkVoxelLineFrame other = frame;
    changes[i](other);
    check(!Builder::IsSamePicture(frame, other), "change " + std::to_string(i) + " is seen");
  }
}
}

int TestVoxelLineFrameBuilder(int, char*[])
{
  Checks check;
  CheckViews(check);
  CheckImpossibleViews(check);
  CheckClippingPlanes(check);
  CheckSamePicture(check);
  return check.GetResult();
}
