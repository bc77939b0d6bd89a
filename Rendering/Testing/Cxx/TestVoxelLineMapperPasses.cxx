// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that the lines enter every kind of translucent pass rightly: alone they must look the same
// in all of them; with other actors, what is in front must hide what is behind, in both directions;
// and rays are cast once per frame, however often a pass draws.

#include "RenderPassTesting.h"

using namespace VoxelLineMapperTesting;

namespace
{
// Two straight lines along y, one in front of the other as seen along z, wide enough to probe.
vtkSmartPointer<vtkPolyData> MakeBars(double zFront, double zBack)
{
  return MakeLines({ { { 0.0, -1.0, zFront }, { 0.0, 1.0, zFront } },
    { { 0.0, -1.0, zBack }, { 0.0, 1.0, zBack } } });
}

vtkSmartPointer<vtkVoxelLineMapper> MakeMapper(vtkPolyData* lines, double radius)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(radius);
  mapper->SetResolution(64);
  mapper->SetFaceBins(0);
  return mapper;
}

// A helix set at several opacities: the passes must agree among themselves.
void CheckSamePictures(Checks& check)
{
  auto lines = MakeHelices(5, 150);
  for (double opacity : { 1.0, 0.25 })
  {
    Picture pictures[3];
    for (Pass pass : { Independent, Peeling, Plain })
    {
      auto mapper = MakeMapper(lines, 0.04);
      mapper->SetScalarRange(0.0, 1.0);
      Stage stage;
      stage.Add(mapper, opacity);
      stage.AddSphere(0.0, 0.0, 0.0, 0.5);
      SetPass(stage, pass);
      stage.Renderer->ResetCamera();
      pictures[pass] = stage.Render();
      check(mapper->GetNumberOfPictures() == 1,
        std::string(PassNames[pass]) + ": one picture in the first frame, not " +
          std::to_string(mapper->GetNumberOfPictures()));
      stage.Render();
      check(mapper->GetNumberOfPictures() == 2,
        std::string(PassNames[pass]) + ": one picture in the second frame");
      check(mapper->GetTimeToDraw() > 0.0, "the time to draw is told");
    }
    const double coverage = GetCoverage(pictures[Plain], Background);
    check(coverage > 0.2, "something is seen");
    for (Pass pass : { Independent, Peeling })
    {
      // VTK's passes keep sums in 8 or 16 bits.
      const Difference difference = Compare(pictures[pass], pictures[Plain]);
      check(difference.Largest <= 2,
        std::string(PassNames[pass]) + " and plain at opacity " + std::to_string(opacity) +
          Describe(difference));
    }
  }
}

// Bars of opacity 0.5 with flat colours against a sphere: every pixel's value is known.
void CheckTransparentLinesAndOpaqueSphere(Checks& check, Pass pass)
{
  const std::array<int, 3> red{ 255, 0, 0 };
  const std::array<int, 3> white{ 255, 255, 255 };
  struct
  {
    double Front;
    double Back;
    std::array<int, 3> Expected;
    const char* Name;
  } cases[] = { { 1.0, 0.8, Mix(red, white, 0.75), "both in front" },
    { 1.0, -0.8, Mix(red, white, 0.5), "one in front, one behind" },
    { -0.8, -1.0, white, "both behind" }, { 1.0, 0.0, Mix(red, white, 0.5), "one inside" } };
  for (const auto& test : cases)
  {
    Stage stage;
    auto actor = stage.Add(MakeMapper(MakeBars(test.Front, test.Back), 0.1), 0.5);
    actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    actor->GetProperty()->LightingOff();
    auto sphere = stage.AddSphere(0.0, 0.0, 0.0, 0.5);
    sphere->GetProperty()->LightingOff();
    SetPass(stage, pass);
    LookAlongZ(stage);
    const std::string name = std::string(PassNames[pass]) + ", " + test.Name;
    const Picture picture = stage.Render();
    const auto center = picture.At(picture.Width / 2, picture.Height / 2);
    check(IsNear(center, test.Expected, 2), name + ": colour over the sphere" + Describe(center));
    // Above the sphere there is only the background behind both bars.
    const auto above = picture.At(picture.Width / 2, picture.Height * 9 / 10);
    check(IsNear(above, Mix(red, Background, 0.75), 2),
      name + ": colour beside the sphere" + Describe(above));
  }
}

// Opaque bars and an opaque sphere, and opaque bars behind a translucent sphere.
void CheckOpaqueLines(Checks& check, Pass pass)
{
  const std::array<int, 3> red{ 255, 0, 0 };
  const std::array<int, 3> white{ 255, 255, 255 };
  for (double z : { 1.0, -1.0 })
  {
    for (double sphereOpacity : { 1.0, 0.4 })
    {
      Stage stage;
      auto actor = stage.Add(MakeMapper(MakeBars(z, z), 0.1));
      actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
      actor->GetProperty()->LightingOff();
      auto sphere = stage.AddSphere(0.0, 0.0, 0.0, 0.5, sphereOpacity);
      sphere->GetProperty()->LightingOff();
      sphere->GetProperty()->BackfaceCullingOn();
      SetPass(stage, pass);
      LookAlongZ(stage);
      const Picture picture = stage.Render();
      const auto center = picture.At(picture.Width / 2, picture.Height / 2);
      const auto expected = z > 0.0 ? red : Mix(white, red, sphereOpacity);
      check(IsNear(center, expected, 2),
        std::string(PassNames[pass]) + ", opaque bar at " + std::to_string(z) +
          ", sphere of opacity " + std::to_string(sphereOpacity) + Describe(center));
    }
  }
}

// Two translucent actors: exact with depth peeling. The first picture counts, drawn while a
// framebuffer of several targets is bound.
void CheckTwoTranslucentActors(Checks& check, int engine)
{
  const std::array<int, 3> red{ 255, 0, 0 };
  const std::array<int, 3> white{ 255, 255, 255 };
  const std::string name = engine == vtkVoxelLineMapper::Shader ? "shader engine" : "native engine";
  for (double z : { 1.0, -1.0 })
  {
    Stage stage;
    auto mapper = MakeMapper(MakeBars(z, z), 0.1);
    mapper->SetEngine(engine);
    auto actor = stage.Add(mapper, 0.5);
    actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    actor->GetProperty()->LightingOff();
    auto sphere = stage.AddSphere(0.0, 0.0, 0.0, 0.5, 0.4);
    sphere->GetProperty()->LightingOff();
    SetPass(stage, Peeling);
    LookAlongZ(stage);
    const Picture picture = stage.Render();
    const auto center = picture.At(picture.Width / 2, picture.Height / 2);
    // Two bars at the same place are two curves: two layers. The sphere has two walls.
    const auto bars = [&](const std::array<int, 3>& behind) { return Mix(red, behind, 0.75); };
    const auto walls = [&](const std::array<int, 3>& behind) { return Mix(white, behind, 0.64); };
    const auto expected = z > 0.0 ? bars(walls(Background)) : walls(bars(Background));
    check(IsNear(center, expected, 4),
      name + ", peeling, translucent bars at " + std::to_string(z) + Describe(center));
    check(mapper->GetNumberOfPictures() == 1, name + ": several peels, one picture");
  }
}

// Opacity of colours and the actor's wishes decide the pass.
void CheckForcedPasses(Checks& check)
{
  const std::array<int, 3> red{ 255, 0, 0 };
  for (int wish = 0; wish < 2; ++wish)
  {
    Stage stage;
    auto actor = stage.Add(MakeMapper(MakeBars(0.5, 0.0), 0.1), wish == 0 ? 0.5 : 1.0);
    actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
    actor->GetProperty()->LightingOff();
    actor->SetForceOpaque(wish == 0);
    actor->SetForceTranslucent(wish == 1);
    LookAlongZ(stage);
    const Picture picture = stage.Render();
    const auto center = picture.At(picture.Width / 2, picture.Height / 2);
    check(IsNear(center, wish == 0 ? Mix(red, Background, 0.75) : red, 2),
      std::string(wish == 0 ? "forced opaque" : "forced translucent") + Describe(center));
  }
}

// A framebuffer with several samples per pixel is resolved before its depth is read. (VTK 9.1's
// depth peeling draws nothing translucent there, polygons included.)
void CheckMultisampling(Checks& check, Pass pass)
{
  const std::array<int, 3> red{ 255, 0, 0 };
  const std::array<int, 3> white{ 255, 255, 255 };
  Stage stage;
  stage.Window->SetMultiSamples(4);
  auto actor = stage.Add(MakeMapper(MakeBars(1.0, -0.8), 0.1), 0.5);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  auto sphere = stage.AddSphere(0.0, 0.0, 0.0, 0.5);
  sphere->GetProperty()->LightingOff();
  SetPass(stage, pass);
  LookAlongZ(stage);
  const Picture picture = stage.Render();
  const auto center = picture.At(picture.Width / 2, picture.Height / 2);
  check(IsNear(center, Mix(red, white, 0.5), 2),
    std::string(PassNames[pass]) + " with several samples" + Describe(center));
}
}

int TestVoxelLineMapperPasses(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckSamePictures(check);
  for (Pass pass : { Independent, Peeling, Plain })
  {
    CheckTransparentLinesAndOpaqueSphere(check, pass);
    CheckOpaqueLines(check, pass);
  }
  for (int engine : { vtkVoxelLineMapper::Native, vtkVoxelLineMapper::Shader })
  {
    CheckTwoTranslucentActors(check, engine);
  }
  CheckForcedPasses(check);
  CheckMultisampling(check, Independent);
  CheckMultisampling(check, Plain);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
