// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards what soft shadows and ambient occlusion leave of the light, by pixels of pictures of
// random straight lines against 2500 rays through the tubes in double precision. In brackets what
// was measured, of light from 0 to 1; bounds have some margin.
// - soft shadows, over the cone of ShadowConeAngle (10 degrees: bias +0.02, RMSE 0.20, as light of
//   so narrow a cone depends on single lines; 30: +0.01, 0.11; 60: +0.03, 0.09),
// - occlusion of the hemisphere above the surface by 64 rays through the tubes (bias 0.01, RMSE
//   0.04; by 400 RMSE 0.01) and through densities (bias +0.05, RMSE 0.07), and of the sphere about
//   the axis, which leaves min(1, 2 (1 - occlusion)) (bias +0.03, RMSE 0.07),
// - and that light does not depend on where the voxels lie: a grid shifted by half a voxel changes
//   the mean of the picture by 0.2 % (soft shadows), 0.15 % (spherical) and 0.2 % (hemisphere by
//   densities), single pixels on average by 8.6, 4.0 and 4.0 % of that mean.
#include "BruteForceLight.h"
#include "ShadowTesting.h"
#include "ViewRays.h"

#include "vtkSMPTools.h"

using namespace VoxelLineMapperTesting;
using BruteForceLight::Errors;

namespace
{
using Global = vtkLineGlobalIllumination;

constexpr int Resolution = 64;
constexpr double VoxelSize = 2.0 / Resolution;

/// Random lines in the cube from -1 to 1, and two short ones in corners, beyond it by some length,
/// that tell where the grid lies.
vtkSmartPointer<vtkPolyData> MakeMedium(int count, double beyond)
{
  std::vector<Curve> curves = MakeStraightLines(count, 21);
  const double a = 1.0 + beyond;
  const double b = a - 0.01;
  curves.push_back({ { -a, -a, -a }, { -b, -b, -b } });
  curves.push_back({ { a, a, a }, { b, b, b } });
  return MakeLines(curves);
}

/// A medium of tubes of half a voxel's radius, whose middle is seen from some way off.
struct MediumStage : ShadowStage
{
  MediumStage(vtkPolyData* lines, int width, int height)
    : ShadowStage(lines, MakeLight({ 1.3, 1.0, 2.0 }), width, height)
  {
    this->Mapper->SetResolution(Resolution);
    this->Mapper->SetFaceBins(0);
    this->Mapper->SetRadius(0.5 * VoxelSize);
    this->Mapper->SubPixelCoverageOff();
    vtkCamera* camera = this->View.Renderer->GetActiveCamera();
    camera->SetParallelScale(0.7);
    camera->SetPosition(3.0, 1.0, 9.0);
  }
};

/// What is seen in a pixel.
struct Seen
{
  int X;
  int Y;
  glm::dvec3 Point;
  glm::dvec3 Axis;
  glm::dvec3 Normal;
  double Truth;
  double AxisTruth;
};

glm::dvec3 ToVector(const double v[3])
{
  return glm::dvec3(v[0], v[1], v[2]);
}

/// Every so many pixels in which a tube is brightly lit.
std::vector<Seen> FindSeen(
  MediumStage& stage, const BruteForceLight::Tubes& tubes, const Picture& plain, int stride)
{
  vtkVoxelLineModel* model = stage.Mapper->GetModel();
  double origin[3];
  model->GetOrigin(origin);
  const linesets::ViewRays rays(
    stage.View.Renderer->GetActiveCamera(), plain.Width, plain.Height, nullptr, origin);
  std::vector<Seen> found;
  for (int i = 0; i < plain.Width * plain.Height; i += stride)
  {
    Seen seen{};
    seen.X = i % plain.Width;
    seen.Y = i / plain.Width;
    if (plain.At(seen.X, seen.Y)[0] < 100)
    {
      continue;
    }
    const linesets::Ray ray = rays.GetRay(seen.X + 0.5, seen.Y + 0.5);
    const glm::dvec3 start = ToVector(ray.ModelOrigin) / model->GetVoxelSize();
    const glm::dvec3 direction = glm::normalize(ToVector(ray.ModelDirection));
    double way;
    const vtkIdType index = tubes.FindFirst(start, direction, way);
    if (index < 0)
    {
      continue;
    }
    const linesets::Capsule& capsule = tubes.GetCapsules()[index];
    seen.Point = start + way * direction;
    linesets::GetCapsuleNormal(capsule, &seen.Point[0], &seen.Normal[0]);
    seen.Axis = ToVector(capsule.Start) +
      linesets::GetCapsulePosition(capsule, &seen.Point[0]) *
        (ToVector(capsule.End) - ToVector(capsule.Start));
    found.push_back(seen);
  }
  return found;
}

template <typename Function>
void ForAll(std::vector<Seen>& pixels, const Function& function)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        function(pixels[static_cast<std::size_t>(i)]);
      }
    });
}

Errors Judge(const std::vector<Seen>& pixels, const Picture& with, const Picture& without,
  const std::string& name, double Seen::*truth = &Seen::Truth)
{
  Errors errors;
  for (const Seen& seen : pixels)
  {
    errors.Add(
      static_cast<double>(with.At(seen.X, seen.Y)[0]) / without.At(seen.X, seen.Y)[0], seen.*truth);
  }
  std::cout << name << ": " << errors.Count << " pixels, mean " << errors.GetMeanTruth()
            << ", bias " << errors.GetBias() << ", RMSE " << errors.GetRmse() << "\n";
  return errors;
}

void TestSoftShadows(Checks& check)
{
  MediumStage stage(MakeMedium(350, 0.0), 80, 60);
  const Picture plain = stage.Render(Global::NoShadows);
  const BruteForceLight::Tubes tubes(stage.Mapper->GetModel(), 0.5);
  std::vector<Seen> pixels = FindSeen(stage, tubes, plain, 41);
  check(pixels.size() > 70, "enough pixels");
  for (const double degrees : { 10.0, 60.0 })
  {
    const BruteForceLight::Directions cone = BruteForceLight::MakeCone(
      glm::normalize(glm::dvec3(1.3, 1.0, 2.0)), degrees * Pi / 180.0, 2500);
    ForAll(
      pixels, [&](Seen& seen) { seen.Truth = 1.0 - tubes.GetBlockedPart(seen.Point, cone, 1e4); });
    stage.Light->SetShadowConeAngle(degrees);
    const Picture soft = stage.Render(Global::SoftShadows);
    const std::string name = "soft shadows, cone of " + std::to_string(degrees);
    const Errors errors = Judge(pixels, soft, plain, name);
    check(std::abs(errors.GetBias()) < 0.05, name + ": mean");
    check(errors.GetRmse() < (degrees < 20.0 ? 0.23 : 0.14), name + ": RMSE");
  }
}

void TestHemispheres(Checks& check)
{
  MediumStage stage(MakeMedium(350, 0.0), 80, 60);
  const Picture plain = stage.Render(Global::NoShadows);
  const BruteForceLight::Tubes tubes(stage.Mapper->GetModel(), 0.5);
  std::vector<Seen> pixels = FindSeen(stage, tubes, plain, 41);
  check(pixels.size() > 70, "enough pixels");
  const BruteForceLight::Directions sphere = BruteForceLight::MakeSphere(2500);
  ForAll(pixels,
    [&](Seen& seen)
    {
      seen.Truth = 1.0 -
        tubes.GetBlockedPart(seen.Point, BruteForceLight::MakeCone(seen.Normal, Pi, 2500), 15.0);
      seen.AxisTruth = std::min(1.0, 2.0 - 2.0 * tubes.GetBlockedPart(seen.Axis, sphere, 15.0));
    });
  const Errors tubes64 =
    Judge(pixels, stage.Render(0, Global::HemisphereTubes), plain, "hemispheres by tubes");
  check(std::abs(tubes64.GetBias()) < 0.02 && tubes64.GetRmse() < 0.05, "hemispheres by tubes");
  const Errors densities =
    Judge(pixels, stage.Render(0, Global::HemisphereDensity), plain, "hemispheres by densities");
  check(
    std::abs(densities.GetBias()) < 0.08 && densities.GetRmse() < 0.12, "hemispheres by densities");
  const Errors spherical = Judge(pixels, stage.Render(0, Global::SphericalOcclusion), plain,
    "spherical occlusion", &Seen::AxisTruth);
  check(std::abs(spherical.GetBias()) < 0.07 && spherical.GetRmse() < 0.12, "spherical occlusion");
  stage.Light->SetOcclusionSamples(400);
  const Errors tubes400 =
    Judge(pixels, stage.Render(0, Global::HemisphereTubes), plain, "hemispheres by 400 rays");
  check(std::abs(tubes400.GetBias()) < 0.005 && tubes400.GetRmse() < 0.6 * tubes64.GetRmse(),
    "more rays, a smaller error");
}

/// The same lines in a grid that is shifted by half a voxel.
void TestShiftedGrid(Checks& check)
{
  MediumStage here(MakeMedium(500, 0.0), 120, 90);
  MediumStage there(MakeMedium(500, 0.5 * VoxelSize), 120, 90);
  there.Mapper->SetResolution(Resolution + 1);
  double origins[2][3];
  here.Mapper->GetModel()->GetOrigin(origins[0]);
  there.Mapper->GetModel()->GetOrigin(origins[1]);
  const double voxel = here.Mapper->GetModel()->GetVoxelSize();
  check(std::abs(there.Mapper->GetModel()->GetVoxelSize() / voxel - 1.0) < 1e-3,
    "voxels of the same size");
  for (int axis = 0; axis < 3; ++axis)
  {
    check(std::abs((origins[0][axis] - origins[1][axis]) / voxel - 0.5) < 0.05,
      "a grid that is shifted by half a voxel");
  }
  struct Kind
  {
    std::string Name;
    int Shadows;
    int Occlusion;
    double LargestChange; // of a pixel, on average, of the picture's mean
  };
  for (const Kind& kind :
    { Kind{ "none", 0, 0, 1e-4 }, Kind{ "soft shadows", Global::SoftShadows, 0, 0.11 },
      Kind{ "spherical occlusion", 0, Global::SphericalOcclusion, 0.055 },
      Kind{ "hemispheres by densities", 0, Global::HemisphereDensity, 0.055 } })
  {
    const Picture a = here.Render(kind.Shadows, kind.Occlusion);
    const Picture b = there.Render(kind.Shadows, kind.Occlusion);
    double change = 0.0;
    for (std::size_t i = 0; i < a.Bytes.size(); ++i)
    {
      change += std::abs(static_cast<double>(a.Bytes[i]) - b.Bytes[i]);
    }
    const double whole = GetBrightness(a);
    const double mean = GetBrightness(b) / whole - 1.0;
    std::cout << "shifted grid, " << kind.Name << ": mean change " << change / whole
              << ", change of the mean " << mean << "\n";
    check(change / whole < kind.LargestChange, "a shifted grid, pixels: " + kind.Name);
    check(std::abs(mean) < 0.01, "a shifted grid, mean of the picture: " + kind.Name);
  }
}
}

int TestVoxelLineMapperSoftLight(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  TestSoftShadows(check);
  TestHemispheres(check);
  TestShiftedGrid(check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
