// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the shadows of vtkVoxelLineMapper by a bar above a floor of bars:
// - the shadow lies where geometry has it, in parallel and perspective views, of directional,
//   positional and spot lights from either side, with an actor's matrix, and nothing changes
//   elsewhere; what lies behind a positional light casts none; that of a level lies near the same
//   place and is wider,
// - soft shadows lie within half a voxel of the level that a cone looks into, which is 2 voxels of
//   the model here, and in the right place on average (measured: 0.6 voxels off); they are wider,
//   the wider the cone; a flat floor does not shadow itself, whatever the cone,
// - transparent bars let 1 - opacity through; narrow bars of a model with radii cast narrow
// shadows,
// - lines that are thinner than a pixel or lit as lines are shadowed too; what is clipped casts no
//   shadow,
// - headlights cast none, which is told once; without the property's lighting there are none,
// - models that are empty or of a single voxel are drawn without errors,
// - nothing is computed again for camera and lights.
#include "ShadowTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkLineIllumination.h"
#include "vtkPlane.h"

using namespace VoxelLineMapperTesting;

namespace
{
using Global = vtkLineGlobalIllumination;

// Mean height of what is seen of the floor from above.
constexpr double FloorHeight = 0.95 * BarRadius;

/// Where the bar's shadow lies on the floor, for a light at a point or in the direction of it.
double FindShadow(const Point& light, bool isPositional, double floorHeight = FloorHeight)
{
  const double slope = isPositional ? light[0] / (light[2] - BarHeight) : light[0] / light[2];
  return -slope * (BarHeight - floorHeight);
}

/// How wide it is there.
double FindWidth(const Point& light, bool isPositional)
{
  const double height = isPositional ? light[2] - BarHeight : light[2];
  const double perHeight = std::hypot(light[0], height) / height;
  const double size = isPositional ? (light[2] - FloorHeight) / height : 1.0;
  return 2.0 * BarRadius * size * perHeight;
}

struct LightCase
{
  std::string Name;
  Point From;
  bool IsPositional;
  double ConeAngle;
};

std::vector<LightCase> MakeLightCases()
{
  return { { "directional", { 1.6, 0.0, 2.0 }, false, 90.0 },
    { "directional from the other side", { -2.2, 0.4, 3.0 }, false, 90.0 },
    { "positional", { 0.9, 0.1, 1.4 }, true, 90.0 },
    { "positional, far away", { -40.0, 3.0, 60.0 }, true, 120.0 },
    { "spot", { 0.9, 0.0, 1.6 }, true, 40.0 } };
}

void TestPlaces(Checks& check)
{
  const auto lines = MakeLines(MakeFloor(true));
  for (const LightCase& test : MakeLightCases())
  {
    ShadowStage stage(lines, MakeLight(test.From, test.IsPositional, test.ConeAngle));
    for (const bool perspective : { false, true })
    {
      const std::string name = test.Name + (perspective ? ", perspective" : ", parallel");
      if (perspective)
      {
        stage.LookInPerspective();
      }
      const Picture plain = stage.Render(Global::NoShadows);
      const double expected =
        stage.GetColumn(FindShadow(test.From, test.IsPositional), FloorHeight);
      const double pixel = stage.GetColumn(0.01, FloorHeight) - stage.GetColumn(0.0, FloorHeight);
      const Picture hard = stage.Render(Global::HardShadows);
      const std::vector<double> loss = GetLoss(hard, plain);
      const ShadowProfile profile(loss);
      std::cout << name << ": expected " << expected << ", hard " << profile.Describe() << "\n";
      check(profile.Depth > 0.99, name + ": the shadow is dark");
      check(std::abs(profile.Centre - expected) < 1.0, name + ": it lies in its place");
      const double width = FindWidth(test.From, test.IsPositional) * pixel / 0.01;
      check(std::abs(profile.Sum - width) < 0.06 * width,
        name + ": its width, expected " + std::to_string(width));
      // Elsewhere nothing changes.
      int changed = 0;
      for (std::size_t x = 0; x < loss.size(); ++x)
      {
        const double away = std::abs(static_cast<double>(x) + 0.5 - expected);
        changed += away > 0.5 * width + 2.0 && loss[x] != 0.0;
      }
      check(changed == 0, name + ": nothing changes where nothing is between");

      const ShadowProfile level(GetLoss(stage.Render(Global::LevelShadows), plain));
      std::cout << "  level " << level.Describe() << "\n";
      check(std::abs(level.Centre - expected) < 4.0 && level.Width > 1.2 * profile.Width &&
          level.Depth > 0.99,
        name + ": the shadow of a level is wider");
      // 2 voxels in the floor's plane, and those in height seen along the light.
      const double voxel = pixel / 0.01 * 2.0 / 64.0;
      const ShadowProfile soft(GetLoss(stage.Render(Global::SoftShadows), plain), expected, 20.0);
      std::cout << "  soft " << soft.Describe() << "\n";
      check(std::abs(soft.Centre - expected) < 4.0 * voxel && soft.Width > 1.3 * profile.Width &&
          soft.Depth > 0.2,
        name + ": a soft shadow is wider");
    }
  }
}

/// The mean place of soft shadows of bars that lie elsewhere in the voxels.
void TestSoftPlaces(Checks& check)
{
  const Point from{ 1.2, 0.0, 2.0 };
  double sum = 0.0;
  double worst = 0.0;
  constexpr int count = 8;
  for (int i = 0; i < count; ++i)
  {
    std::vector<Curve> curves = MakeFloor(false);
    const double x = -0.125 + 0.25 * (i + 0.5) / count;
    const double z = 0.5 + 0.125 * ((3 * i) % count + 0.5) / count;
    curves.push_back({ { x, -1.0, z }, { x, 1.0, z } });
    // The grid reaches above the bars, and is the same for all.
    curves.push_back({ { -1.0, -1.0, 0.9 }, { -1.0, -1.0, 1.0 } });
    ShadowStage stage(MakeLines(curves), MakeLight(from));
    const Picture plain = stage.Render(Global::NoShadows);
    const double expected = stage.GetColumn(x - from[0] / from[2] * (z - FloorHeight), FloorHeight);
    const ShadowProfile soft(GetLoss(stage.Render(Global::SoftShadows), plain), expected, 20.0);
    sum += soft.Centre - expected;
    worst = std::max(worst, std::abs(soft.Centre - expected));
  }
  std::cout << "soft shadows of several bars: displaced by " << sum / count << ", at most " << worst
            << " pixels\n";
  check(std::abs(sum / count) < 2.0 && worst < 8.0, "soft shadows lie in their place on average");
}

void TestSoftness(Checks& check)
{
  const Point from{ 0.4, 0.0, 1.0 };
  ShadowStage stage(MakeLines(MakeFloor(true)), MakeLight(from));
  const Picture plain = stage.Render(Global::NoShadows);
  const double middle = stage.GetColumn(FindShadow(from, false), FloorHeight);
  // A shadow of a level less wide than the bar's own (2 degrees) is less deep than a hard one. From
  // 6 to 10 degrees the level is the same here.
  double width = 0.0;
  double depth = 1.0;
  for (const double angle : { 2.0, 6.0, 20.0 })
  {
    stage.Light->SetShadowConeAngle(angle);
    const ShadowProfile soft(GetLoss(stage.Render(Global::SoftShadows), plain), middle, 40.0);
    std::cout << "cone of " << angle << " degrees: " << soft.Describe() << "\n";
    check(soft.Width > 1.03 * width && soft.Depth < depth,
      "softer with a cone of " + std::to_string(angle) + " degrees");
    width = soft.Width;
    depth = soft.Depth;
  }
  // The coarser the level, the wider the shadow.
  width = 0.0;
  for (int level = 1; level <= 2; ++level)
  {
    stage.Light->SetShadowLevel(level);
    const ShadowProfile wide(GetLoss(stage.Render(Global::LevelShadows), plain));
    std::cout << "level " << level << ": " << wide.Describe() << "\n";
    check(wide.Sum > 1.3 * width, "wider on level " + std::to_string(level));
    width = wide.Sum;
  }
}

/// Lights that cast no shadows of the bar.
void TestNoShadows(Checks& check, Messages* messages)
{
  const auto lines = MakeLines(MakeFloor(true));
  // Between the floor and the bar, where the ray goes on to the bar, and above it. Far away the
  // floor shadows itself.
  const Point below{ 0.04, 0.0, 0.4 };
  const Point above{ 0.15, 0.0, 0.8 };
  ShadowStage stage(lines, MakeLight(below, true));
  for (const int kind : { Global::HardShadows, Global::LevelShadows, Global::SoftShadows })
  {
    const std::string name = " of kind " + std::to_string(kind);
    stage.SetLight(MakeLight(below, true));
    const ShadowProfile none(GetLoss(stage.Render(kind), stage.Render(Global::NoShadows)),
      stage.GetColumn(0.19, FloorHeight), 10.0);
    stage.SetLight(MakeLight(above, true));
    const ShadowProfile some(
      GetLoss(stage.Render(kind), stage.Render(Global::NoShadows)), 70.0, 20.0);
    std::cout << "light below the bar: " << none.Describe() << "; above: " << some.Describe()
              << "\n";
    // Densities lie within a voxel of the level that a cone looks into: some are before the light.
    const bool isSoft = kind == Global::SoftShadows;
    check(none.Sum < (isSoft ? 0.45 * some.Sum : 0.1), "no shadow from behind the light," + name);
    check(some.Sum > 2.0, "a shadow from before it," + name);
  }

  // A floor alone, lit from above, has no shadows.
  ShadowStage floor(MakeLines(MakeFloor(false)), MakeLight({ 0.1, 0.0, 2.0 }));
  const Picture alone = floor.Render(Global::NoShadows);
  check(floor.Render(Global::HardShadows).Bytes == alone.Bytes, "a floor alone has no shadows");
  const ShadowProfile self(GetLoss(floor.Render(Global::SoftShadows), alone));
  std::cout << "floor alone, soft: " << self.Describe() << "\n";
  // Within a grid that reaches up to a bar that is out of the way, by a wide cone from aside.
  std::vector<Curve> curves = MakeFloor(false);
  curves.push_back({ { -1.0, -1.0, 1.0 }, { -1.0, 1.0, 1.0 } });
  ShadowStage wide(MakeLines(curves), MakeLight({ 0.4, 0.0, 1.0 }));
  for (const double angle : { 10.0, 20.0, 40.0, 60.0 })
  {
    wide.Light->SetShadowConeAngle(angle);
    const ShadowProfile flat(
      GetLoss(wide.Render(Global::SoftShadows), wide.Render(Global::NoShadows)), 90.0, 60.0);
    std::cout << "floor alone, cone of " << angle << ": " << flat.Describe() << "\n";
    check(flat.Depth < 0.1, "a floor alone hardly shadows itself");
  }
  check(self.Depth < 0.08, "a floor alone has hardly any soft shadow");
  check(messages->IsQuiet(), "nothing is said so far");

  // Headlights: no shadows, told once.
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  stage.SetLight(head);
  const Picture bright = stage.Render(Global::NoShadows);
  check(messages->IsQuiet(), "nothing is said without shadows");
  for (const int kind : { Global::HardShadows, Global::SoftShadows, Global::LevelShadows })
  {
    check(stage.Render(kind).Bytes == bright.Bytes, "headlights cast no shadows");
  }
  check(messages->TakeWarnings("headlights") == 1, "which is told once");
  ShadowStage dark(lines, head, 20, 20);
  head->SwitchOff();
  dark.View.Renderer->AutomaticLightCreationOff();
  dark.Render(Global::HardShadows);
  check(messages->IsQuiet(), "where no light is on there is nothing to tell");
  head->SwitchOn();
  // Beside another light it keeps its light.
  vtkNew<vtkLight> off;
  off->SwitchOff();
  stage.View.Renderer->AddLight(off);
  check(GetBrightness(stage.Render(Global::HardShadows)) > 0.0 && messages->IsQuiet(),
    "a light that is off changes nothing");
  stage.View.Renderer->AddLight(MakeLight({ 0.8, 0.0, 1.0 }));
  stage.Actor->GetProperty()->SetDiffuse(0.4);
  const ShadowProfile both(
    GetLoss(stage.Render(Global::HardShadows), stage.Render(Global::NoShadows)));
  std::cout << "beside a headlight: " << both.Describe() << "\n";
  check(both.Depth > 0.3 && both.Depth < 0.6, "beside another light only that one is missing");

  stage.Actor->GetProperty()->LightingOff();
  check(stage.Render(Global::HardShadows).Bytes == stage.Render(Global::NoShadows).Bytes &&
      stage.Render(Global::SoftShadows, Global::SphericalOcclusion).Bytes ==
        stage.Render(Global::NoShadows).Bytes,
    "without lighting there are no shadows");
  check(messages->IsQuiet(), "nothing else is said");
}

void TestTransparent(Checks& check)
{
  for (const double opacity : { 0.3, 0.7 })
  {
    ShadowStage stage(MakeLines(MakeFloor(true)), MakeLight({ 0.8, 0.0, 1.0 }));
    stage.Actor->GetProperty()->SetOpacity(opacity);
    // A floor of one layer on black: what is lost is the part of the light.
    const ShadowProfile hard(
      GetLoss(stage.Render(Global::HardShadows), stage.Render(Global::NoShadows)));
    std::cout << "opacity " << opacity << ": " << hard.Describe() << "\n";
    check(std::abs(hard.Depth - opacity) < 0.03, "a transparent bar takes its opacity");
  }
}

/// The matrix of the actor, and clipping planes.
void TestPlacement(Checks& check)
{
  // The scene squeezed and turned upside down: the matrix brings it back.
  std::vector<Curve> curves = MakeFloor(true);
  for (Curve& curve : curves)
  {
    for (Point& point : curve)
    {
      point = { -point[0] / 1.6, -point[1] / 0.8, point[2] };
    }
  }
  const Point from{ 1.6, 0.0, 2.0 };
  ShadowStage stage(MakeLines(curves), MakeLight(from));
  stage.Actor->SetScale(1.6, 0.8, 1.0);
  stage.Actor->RotateZ(180.0);
  stage.Mapper->SetRadius(BarRadius);
  const Picture plain = stage.Render(Global::NoShadows);
  for (const int kind : { Global::HardShadows, Global::SoftShadows })
  {
    const ShadowProfile profile(GetLoss(stage.Render(kind), plain));
    const double expected = stage.GetColumn(FindShadow(from, false), FloorHeight);
    std::cout << "matrix: expected " << expected << ", " << profile.Describe() << "\n";
    check(std::abs(profile.Centre - expected) < (kind == Global::HardShadows ? 1.0 : 12.0) &&
        profile.Depth > 0.1,
      "shadow with an actor's matrix");
  }

  // The bar is cut off: it is not seen, and what is not there casts no shadow.
  ShadowStage clipped(MakeLines(MakeFloor(true)), MakeLight(from));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.3);
  plane->SetNormal(0.0, 0.0, -1.0);
  clipped.Mapper->AddClippingPlane(plane);
  for (const int kind : { Global::HardShadows, Global::LevelShadows })
  {
    const ShadowProfile gone(GetLoss(clipped.Render(kind), clipped.Render(Global::NoShadows)));
    std::cout << "clipped: " << gone.Describe() << "\n";
    check(gone.Sum < 0.01, "what is clipped casts no shadow");
  }
  const ShadowProfile soft(
    GetLoss(clipped.Render(Global::SoftShadows), clipped.Render(Global::NoShadows)));
  ShadowStage floor(MakeLines(MakeFloor(false)), MakeLight(from));
  const ShadowProfile alone(
    GetLoss(floor.Render(Global::SoftShadows), floor.Render(Global::NoShadows)));
  std::cout << "clipped, soft: " << soft.Describe() << "; alone: " << alone.Describe() << "\n";
  check(soft.Depth < alone.Depth + 0.1, "what is clipped casts no soft shadow");
}

void TestRadii(Checks& check)
{
  auto lines = MakeLines(MakeFloor(true));
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("r");
  const vtkIdType points = lines->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i)
  {
    radii->InsertNextValue(i < points - 2 ? BarRadius : 0.4 * BarRadius);
  }
  lines->GetPointData()->AddArray(radii);
  ShadowStage wide(lines, MakeLight({ 0.8, 0.0, 1.0 }));
  ShadowStage narrow(lines, MakeLight({ 0.8, 0.0, 1.0 }));
  narrow.Mapper->SetRadiusArrayName("r");
  for (const int kind : { Global::HardShadows, Global::SoftShadows })
  {
    const ShadowProfile a(GetLoss(wide.Render(kind), wide.Render(Global::NoShadows)));
    const ShadowProfile b(GetLoss(narrow.Render(kind), narrow.Render(Global::NoShadows)));
    std::cout << "narrow bar: " << b.Sum / a.Sum << " of a wide one's shadow\n";
    check(b.Sum > 0.2 * a.Sum && b.Sum < 0.65 * a.Sum, "a narrow bar has a narrow shadow");
  }
}

/// Tubes that are lit as lines, in one way or the other.
void TestLines(Checks& check)
{
  const Point from{ 0.8, 0.0, 1.0 };
  ShadowStage lit(MakeLines(MakeFloor(true)), MakeLight(from));
  lit.Mapper->GetIllumination()->SetModelToMaximumReflection();
  // Less than a pixel, with a bar that does not fall between all pixels' centres.
  std::vector<Curve> curves = MakeFloor(false);
  curves.push_back({ { -0.1, -1.0, BarHeight }, { 0.1, 1.0, BarHeight } });
  ShadowStage thin(MakeLines(curves), MakeLight(from));
  thin.Mapper->SetRadius(0.006);
  for (ShadowStage* stage : { &lit, &thin })
  {
    const std::string name = stage == &lit ? "lit as lines" : "thin";
    const double expected =
      stage->GetColumn(FindShadow(from, false, stage == &lit ? FloorHeight : 0.0), 0.0);
    for (const int kind : { Global::HardShadows, Global::SoftShadows })
    {
      const ShadowProfile profile(
        GetLoss(stage->Render(kind), stage->Render(Global::NoShadows)), expected, 20.0);
      std::cout << name << ": expected " << expected << ", " << profile.Describe() << "\n";
      check(std::abs(profile.Centre - expected) < (kind == Global::HardShadows ? 1.0 : 9.0),
        name + ": the shadow lies in its place");
      // That of the thin bar is 1.15 pixels wide. Of a single bar a soft shadow holds, depending on
      // where the samples of a cone lie to it, from 0.4 on of what a hard one does.
      const bool isHard = kind == Global::HardShadows;
      check(profile.Sum > (stage == &lit ? (isHard ? 4.0 : 2.0) : (isHard ? 0.9 : 0.5)),
        name + ": there is a shadow");
    }
  }
}

void TestSmallModels(Checks& check, Messages* messages)
{
  const std::vector<vtkSmartPointer<vtkPolyData>> inputs = { MakeLines({}),
    MakeLines({ { { 0.0, 0.0, 0.0 }, { 0.1, 0.1, 0.05 } } }), MakeLines(MakeFloor(false)) };
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    for (const int resolution : { 1, 3 })
    {
      ShadowStage stage(inputs[i], MakeLight({ 0.3, 0.2, 1.0 }), 40, 40);
      stage.Mapper->SetResolution(resolution);
      stage.Light->SetShadowLevel(5);
      stage.Light->SetOcclusionSamples(4);
      for (int kind = Global::NoShadows; kind <= Global::SoftShadows; ++kind)
      {
        const bool isSeen = GetBrightness(stage.Render(kind, kind)) > 0.0;
        check(isSeen == (i > 0),
          "small model " + std::to_string(i) + " of resolution " + std::to_string(resolution) +
            " with shadows and occlusion " + std::to_string(kind));
        check(messages->IsQuiet(), "nothing is said about a small model");
      }
    }
  }
  // A light without a direction.
  ShadowStage stage(inputs[2], MakeLight({ 0.0, 0.0, 0.0 }), 40, 40);
  stage.Mapper->GetIllumination()->SetModelToMaximumReflection();
  for (int kind = Global::NoShadows; kind <= Global::SoftShadows; ++kind)
  {
    stage.Render(kind);
  }
  check(messages->IsQuiet(), "nothing is said about a light without a direction");
}

/// What is looked up is computed for changes that it depends on, and for no others.
void TestChanges(Checks& check)
{
  ShadowStage stage(MakeLines(MakeFloor(true)), MakeLight({ 0.8, 0.0, 1.0 }), 40, 30);
  vtkVoxelLineMapper* mapper = stage.Mapper;
  check(mapper->GetLightBuildTime() == 0.0, "nothing is computed at first");
  stage.Render(Global::HardShadows);
  check(mapper->GetLightBuildTime() == 0.0, "hard shadows need nothing");
  int steps = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&steps);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void* done)
    { *static_cast<int*>(data) += *static_cast<double*>(done) < 1.0 ? 1 : 0; });
  mapper->AddObserver(vtkCommand::ProgressEvent, count);
  for (const std::array<int, 2>& kinds :
    { std::array<int, 2>{ Global::SoftShadows, Global::SphericalOcclusion },
      std::array<int, 2>{ Global::LevelShadows, Global::NoOcclusion } })
  {
    const std::string name = "shadows of kind " + std::to_string(kinds[0]) + ": ";
    double seconds = mapper->GetLightBuildTime();
    const auto renderAndSee = [&](bool isBuilt, const std::string& what)
    {
      const vtkIdType pictures = mapper->GetNumberOfPictures();
      steps = 0;
      stage.Render(kinds[0], kinds[1]);
      check(mapper->GetNumberOfPictures() == pictures + 1, name + what + ": a picture");
      check((mapper->GetLightBuildTime() != seconds) == isBuilt, name + what + ": time");
      check((steps > 2) == (isBuilt && kinds[1] != 0), name + what + ": progress");
      seconds = mapper->GetLightBuildTime();
    };
    renderAndSee(true, "the first time");
    check(seconds > 0.0, name + "it takes some time");
    stage.View.Renderer->GetActiveCamera()->Azimuth(5.0);
    renderAndSee(false, "camera");
    stage.SetLight(MakeLight({ -0.8, 0.0, 1.0 }));
    renderAndSee(false, "light");
    stage.Light->SetShadowConeAngle(stage.Light->GetShadowConeAngle() + 3.0);
    stage.Actor->GetProperty()->SetColor(0.5, 0.6, 0.7);
    stage.Actor->RotateZ(1.0);
    renderAndSee(false, "cone, colour, matrix");
    stage.Actor->GetProperty()->SetOpacity(0.9);
    renderAndSee(kinds[0] == Global::SoftShadows, "opacity");
    stage.Actor->GetProperty()->SetOpacity(1.0);
    renderAndSee(kinds[0] == Global::SoftShadows, "opacity again");
    mapper->SetResolution(mapper->GetResolution() + 1);
    renderAndSee(true, "model");
    stage.Light->SetOcclusionRadius(stage.Light->GetOcclusionRadius() - 1.0);
    renderAndSee(kinds[1] != 0, "radius of occlusion");
    mapper->SetRadius(0.9 * mapper->GetRadius());
    renderAndSee(kinds[1] != 0, "radius of tubes");
  }
}

/// A long computation that is stopped leaves out occlusion, and the next frame has it.
void TestAbort(Checks& check)
{
  ShadowStage stage(MakeLines(MakeStraightLines(300, 4)), MakeLight({ 0.8, 0.0, 1.0 }), 40, 30);
  const Picture plain = stage.Render(Global::NoShadows);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* mapper, unsigned long, void*, void*)
    { static_cast<vtkVoxelLineMapper*>(mapper)->SetAbortExecute(1); });
  const unsigned long tag = stage.Mapper->AddObserver(vtkCommand::ProgressEvent, stop);
  check(stage.Render(Global::NoShadows, Global::SphericalOcclusion).Bytes == plain.Bytes,
    "a computation that is stopped leaves out occlusion");
  stage.Mapper->RemoveObserver(tag);
  check(GetBrightness(stage.View.Render()) < 0.99 * GetBrightness(plain),
    "the next frame has occlusion");
}
}

int TestVoxelLineMapperShadows(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  TestPlaces(check);
  TestSoftPlaces(check);
  TestSoftness(check);
  TestNoShadows(check, messages);
  TestTransparent(check);
  TestPlacement(check);
  TestRadii(check);
  TestLines(check);
  TestSmallModels(check, messages);
  TestChanges(check);
  TestAbort(check);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
