// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards opacity by the length of a ray's way inside tubes:
// - the opacity of each pixel is that of the lengths which all decoded segments give in double
//   precision, for straight and bent lines and tubes of several radii, for rays that start and end
//   inside and outside of tubes, and, for rays to lights, what straight tubes let through,
// - the colour is that of the walls where the ray comes in,
// - opaque and thin tubes stay as they are,
// - the mapper's switch: default, copy, text, and that a picture is made again.
#include "CapsulesFromModel.h"
#include "VoxelLineReferenceTesting.h"

#include "vtkLineVoxelizer.h"
#include "vtkVoxelLineFrameBuilder.h"
#include "vtkVoxelLineNativeEngine.h"

#include <map>

using namespace VoxelLineMapperTesting;

namespace
{
using linesets::Capsule;

constexpr int Size = 60;
// Depth of what is cast: s from 0 to this.
constexpr float Depth = 200.0f;

struct Tubes
{
  vtkSmartPointer<vtkVoxelLineModel> Model;
  /// In voxels.
  std::vector<Capsule> Capsules;
  double Radius;
};

Tubes MakeTubes(vtkPolyData* lines, int bins, double radius, const std::string& radiusArray = {})
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(20);
  voxelizer->SetFaceBins(bins);
  voxelizer->SetRadiusArrayName(radiusArray);
  voxelizer->Update();
  Tubes tubes;
  tubes.Model = voxelizer->GetOutput();
  const double size = tubes.Model->GetVoxelSize();
  tubes.Radius = tubes.Model->GetRadii() ? tubes.Model->GetMaximumRadius() / size : radius;
  tubes.Capsules = linesets::MakeCapsulesFromModel(tubes.Model, radius * size).Capsules;
  for (Capsule& capsule : tubes.Capsules)
  {
    for (int i = 0; i < 3; ++i)
    {
      capsule.Start[i] /= size;
      capsule.End[i] /= size;
    }
    capsule.StartRadius /= size;
    capsule.EndRadius /= size;
  }
  return tubes;
}

/// Parallel rays across the grid.
vtkVoxelLineFrame MakeFrame(const Tubes& tubes, const glm::dvec3& along, double opacity)
{
  vtkVoxelLineFrame frame;
  frame.Width = Size;
  frame.Height = Size;
  const glm::dvec3 direction = glm::normalize(along);
  const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(0.3, 1.0, 0.2)));
  const glm::dvec3 up = glm::cross(right, direction);
  const double pixel = 26.0 / Size;
  const glm::dvec3 center(10.0);
  frame.Origin[0] = glm::vec3(center - 0.5 * Depth * direction - 0.5 * Size * pixel * (right + up));
  frame.Origin[1] = glm::vec3(pixel * right);
  frame.Origin[2] = glm::vec3(pixel * up);
  frame.Direction[0] = glm::vec3(direction);
  frame.Direction[1] = frame.Direction[2] = glm::vec3(0.0f);
  frame.NearestS = 0.0f;
  frame.FarthestS = Depth;
  frame.DepthZ = glm::vec2(-1.0f, 2.0f / Depth);
  frame.DepthW = glm::vec2(1.0f, 0.0f);
  frame.Radius = static_cast<float>(tubes.Radius);
  frame.Opacity = static_cast<float>(opacity);
  frame.Lighting = false;
  frame.EarlyTermination = 2.0f;
  frame.OpacityByPathLength = true;
  return frame;
}

struct Hit
{
  double Entry;
  double Exit;
  std::size_t Capsule;
};

/// Radius of a tube at a distance along a ray.
double RadiusAt(const Capsule& capsule, const glm::dvec3& origin, const glm::dvec3& d, double t)
{
  const glm::dvec3 x = origin + t * d;
  const double s = linesets::GetCapsulePosition(capsule, &x[0]);
  return capsule.StartRadius + s * (capsule.EndRadius - capsule.StartRadius);
}

/// Diameters of tubes that a ray passes from first to last, over all curves.
double FindDiameters(const Tubes& tubes, const glm::dvec3& origin, const glm::dvec3& direction,
  double first, double last)
{
  std::map<vtkIdType, std::vector<Hit>> curves;
  for (std::size_t i = 0; i < tubes.Capsules.size(); ++i)
  {
    Hit hit{ 0.0, 0.0, i };
    if (linesets::IntersectCapsule(
          tubes.Capsules[i], &origin[0], &direction[0], hit.Entry, hit.Exit) &&
      hit.Exit > first && hit.Entry < last)
    {
      curves[tubes.Capsules[i].Curve].push_back(hit);
    }
  }
  double diameters = 0.0;
  for (auto& [curve, hits] : curves)
  {
    std::sort(
      hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.Entry < b.Entry; });
    double upTo = -1e30;
    bool fromInside = false;
    for (const Hit& hit : hits)
    {
      const bool begins = hit.Entry > upTo;
      fromInside = begins ? hit.Entry < first : fromInside;
      const double from = begins ? hit.Entry : upTo;
      upTo = std::max(upTo, hit.Exit);
      const double way = std::min(upTo, last) - std::max(from, first);
      // Where a ray starts inside, the far wall is seen.
      if (way > 0.0 && !(fromInside && upTo > last) && (begins || upTo == hit.Exit))
      {
        const double at = fromInside ? hit.Exit : from;
        diameters += way / (2.0 * RadiusAt(tubes.Capsules[hit.Capsule], origin, direction, at));
      }
    }
  }
  return diameters;
}

void TestOpacity(Checks& check, const Tubes& tubes, const glm::dvec3& along, double first,
  double last, double largest, const std::string& name)
{
  const double opacity = 0.3;
  vtkVoxelLineFrame frame = MakeFrame(tubes, along, opacity);
  frame.NearestS = static_cast<float>(first);
  frame.FarthestS = static_cast<float>(last);
  vtkVoxelLinePicture picture;
  vtkVoxelLineNativeEngine::Render(tubes.Model, frame, picture);
  int seen = 0;
  int wrong = 0;
  double worst = 0.0;
  for (int i = 0; i < Size * Size; ++i)
  {
    const glm::dvec3 origin = glm::dvec3(frame.Origin[0]) +
      (i % Size + 0.5) * glm::dvec3(frame.Origin[1]) +
      (i / Size + 0.5) * glm::dvec3(frame.Origin[2]);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(frame.Direction[0]));
    const double diameters = FindDiameters(tubes, origin, direction, first, last);
    const double expected = 1.0 - std::pow(1.0 - opacity, diameters);
    const double error = std::abs(picture.Color[4 * i + 3] / 255.0 - expected);
    seen += diameters > 0.0 ? 1 : 0;
    wrong += error > largest ? 1 : 0;
    worst = std::max(worst, error);
  }
  std::cout << name << ": " << seen << " pixels, " << wrong << " wrong, largest error " << worst
            << "\n";
  check(seen > Size * Size / 10, name + ": something is seen");
  // Rays at a seam between segments.
  check(wrong <= 2, name + ": the opacity is that of the lengths");
}

/// The picture with the switch on and off.
std::array<vtkVoxelLinePicture, 2> RenderBoth(const Tubes& tubes, vtkVoxelLineFrame frame)
{
  std::array<vtkVoxelLinePicture, 2> pictures;
  for (int i = 0; i < 2; ++i)
  {
    frame.OpacityByPathLength = i == 0;
    vtkVoxelLineNativeEngine::Render(tubes.Model, frame, pictures[i]);
  }
  return pictures;
}

/// A single tube has one layer per pixel: its colour does not depend on its opacity.
void TestColor(Checks& check)
{
  const Tubes tubes = MakeTubes(MakeLines({ { { -1.0, -0.9, -1.0 }, { 1.0, 0.8, 0.9 } } }), 0, 2.0);
  vtkVoxelLineFrame frame = MakeFrame(tubes, { 0.4, 0.2, 1.0 }, 0.5);
  frame.Lighting = true;
  frame.Light.Lights.resize(1);
  frame.Light.Lights[0].Kind = 0;
  frame.Light.Lights[0].Direction = glm::normalize(glm::vec3(-0.3f, 0.5f, 1.0f));
  frame.Light.Lights[0].Color = glm::vec3(1.0f);
  const auto [on, off] = RenderBoth(tubes, frame);
  int seen = 0;
  int worst = 0;
  for (int i = 0; i < 4 * Size * Size; ++i)
  {
    // At the edges, opacities near 0 leave nothing of the colour.
    if (i % 4 < 3 && on.Color[i - i % 4 + 3] > 2)
    {
      seen += off.Color[i] > 100 ? 1 : 0;
      worst = std::max(worst, std::abs(static_cast<int>(on.Color[i]) - off.Color[i]));
    }
  }
  check(seen > 300, "a lit tube is seen");
  check(worst <= 1, "the light is that of the wall where the ray comes in");
}

/// What is opaque does not become transparent, however short the way, nor is it counted twice.
void TestOpaque(Checks& check, const Tubes& tubes)
{
  vtkVoxelLineFrame frame = MakeFrame(tubes, { 0.4, 0.2, 1.0 }, 1.0);
  auto pictures = RenderBoth(tubes, frame);
  check(pictures[0].Color == pictures[1].Color && pictures[0].Depth == pictures[1].Depth,
    "opaque tubes stay as they are");
  frame.Radius = 0.2f;
  frame.ThinTubes = frame.NarrowTubes = true;
  frame.HalfPixel = glm::vec2(0.4f, 0.0f);
  frame.LargestRadius = 0.4f;
  pictures = RenderBoth(tubes, frame);
  check(*std::max_element(pictures[1].Color.begin(), pictures[1].Color.end()) > 0,
    "thin tubes are seen");
  check(pictures[0].Color == pictures[1].Color, "opaque thin tubes stay as they are");
}

/// Rays to lights, from outside: for straight tubes but at their ends.
void TestSecondaryRays(Checks& check, const Tubes& tubes)
{
  vtkVoxelLineFrame frame = MakeFrame(tubes, { 0.4, 0.2, 1.0 }, 0.3);
  frame.SecondaryRays = true;
  std::vector<vtkVoxelLineSecondaryRay> rays;
  linesets::Random random(41);
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 target(random.Uniform(0, 20), random.Uniform(0, 20), random.Uniform(0, 20));
    const glm::dvec3 direction = glm::normalize(
      glm::dvec3(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1) + 0.01));
    rays.push_back({ glm::vec3(target - 50.0 * direction), glm::vec3(direction), 1e30f });
  }
  const auto through = vtkVoxelLineNativeEngine::CastSecondaryRays(tubes.Model, frame, rays);
  int differ = 0;
  int dimmed = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    const double diameters = FindDiameters(
      tubes, glm::dvec3(rays[i].Origin), glm::normalize(glm::dvec3(rays[i].Direction)), 0.0, 1e30);
    differ += std::abs(std::pow(0.7, diameters) - through[i]) > 1e-3 ? 1 : 0;
    dimmed += diameters > 0.0 ? 1 : 0;
  }
  std::cout << "Rays to lights: " << dimmed << " dimmed, " << differ << " differ\n";
  check(dimmed > 500, "some rays are dimmed");
  check(differ < 0.1 * dimmed, "rays to lights are dimmed by their way inside");
}

void TestSwitch(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  check(!mapper->GetOpacityByPathLength(), "off by default");
  const vtkMTimeType before = mapper->GetMTime();
  mapper->OpacityByPathLengthOn();
  check(mapper->GetMTime() > before, "the switch modifies the mapper");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetOpacityByPathLength(), "a copy has the switch of its original");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("OpacityByPathLength: On") != std::string::npos, "the switch is printed");
}
}

int TestVoxelLineMapperPathLength(int, char*[])
{
  Checks check;
  auto messages = Listen();
  const Tubes straight = MakeTubes(MakeLines(MakeStraightLines(20, 31)), 0, 0.8);
  const Tubes bent = MakeTubes(MakeLines(MakeBundle(8, 60, 32)), 32, 0.8);
  const std::pair<const Tubes*, const char*> shapes[] = { { &straight, "straight" },
    { &bent, "bent" } };
  for (const auto& [tubes, text] : shapes)
  {
    const std::string name(text);
    TestOpacity(check, *tubes, { 0.4, 0.2, 1.0 }, 0.0, Depth, 0.003, name);
    TestOpacity(check, *tubes, { -1.0, 0.1, 0.3 }, 0.0, Depth, 0.003, name + ", other side");
    TestOpacity(
      check, *tubes, { 0.4, 0.2, 1.0 }, 0.0, 0.5 * Depth, 0.003, name + ", to the middle");
    TestOpacity(
      check, *tubes, { 0.4, 0.2, 1.0 }, 0.5 * Depth, Depth, 0.003, name + ", from the middle");
  }
  auto lines = MakeLines(MakeStraightLines(20, 33));
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radii");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    radii->InsertNextValue(i % 2 ? 0.12 : 0.04);
  }
  lines->GetPointData()->AddArray(radii);
  TestOpacity(check, MakeTubes(lines, 0, 0.0, "radii"), { 0.4, 0.2, 1.0 }, 0.0, Depth, 0.008,
    "several radii");
  TestColor(check);
  TestOpaque(check, bent);
  TestSecondaryRays(check, MakeTubes(MakeLines(MakeStraightLines(80, 34)), 0, 0.2));
  TestSwitch(check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
