// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards how tubes thinner than a pixel go with other actors: what is behind them shines through,
// in any order of actors, in all passes and from the first frame on; the mapper's answer whether it
// is translucent follows the cameras; radii that vary, down to 0; selection; the switch.

#include "RenderPassTesting.h"

#include "vtkAssembly.h"
#include "vtkFollower.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <set>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr std::array<int, 3> Black{ 0, 0, 0 };
constexpr std::array<int, 3> Red{ 255, 0, 0 };
constexpr std::array<int, 3> White{ 255, 255, 255 };

// In a window of 200 x 200 pixels and the view of LookAlongZ() a pixel is 0.01 wide.
constexpr int Size = 200;
constexpr double Pixel = 2.0 / Size;

// A line across the window, through the middle of a row of pixels, at a depth.
vtkSmartPointer<vtkPolyData> MakeRow(double z, double length = 0.9)
{
  return MakeLines({ { { -length, 0.5 * Pixel, z }, { length, 0.5 * Pixel, z } } });
}

vtkSmartPointer<vtkVoxelLineMapper> MakeMapper(vtkPolyData* lines, double width)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetRadius(0.5 * width * Pixel);
  mapper->SetResolution(32);
  mapper->SetFaceBins(0);
  return mapper;
}

// Red, without light.
vtkSmartPointer<vtkActor> AddRow(Stage& stage, vtkMapper* mapper, double opacity = 1.0)
{
  auto actor = stage.Add(mapper, opacity);
  actor->GetProperty()->SetColor(1.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  return actor;
}

void AddWhiteSphere(Stage& stage, double z)
{
  stage.AddSphere(0.0, 0.0, z, 0.4)->GetProperty()->LightingOff();
}

// A line half a pixel wide, in front of a sphere or behind it, added before or after it.
void CheckSphere(Checks& check, Pass pass)
{
  for (const double opacity : { 1.0, 0.5 })
  {
    for (const bool linesFirst : { true, false })
    {
      for (const double z : { 0.5, -0.5 })
      {
        Stage stage(Size, Size);
        auto mapper = MakeMapper(MakeRow(z), 0.5);
        if (linesFirst)
        {
          AddRow(stage, mapper, opacity);
        }
        AddWhiteSphere(stage, 0.0);
        if (!linesFirst)
        {
          AddRow(stage, mapper, opacity);
        }
        SetPass(stage, pass);
        LookAlongZ(stage);
        for (int frame = 1; frame <= 2; ++frame)
        {
          const Picture picture = stage.Render();
          const std::string name = std::string(PassNames[pass]) + ", opacity " +
            std::to_string(opacity) + (linesFirst ? ", lines first" : ", sphere first") +
            (z > 0.0 ? ", in front" : ", behind") + ", frame " + std::to_string(frame);
          const auto over = picture.At(Size / 2, Size / 2);
          const auto expected = z > 0.0 ? Mix(Red, White, 0.5 * opacity) : White;
          check(IsNear(over, expected, 2), name + ": over the sphere" + Describe(over));
          const auto beside = picture.At(Size / 2 + 60, Size / 2);
          check(IsNear(beside, Mix(Red, Background, 0.5 * opacity), 2),
            name + ": beside the sphere" + Describe(beside));
          const auto above = picture.At(Size / 2 + 60, Size / 2 + 1);
          check(IsNear(above, Background, 1), name + ": a single row" + Describe(above));
          check(mapper->GetNumberOfPictures() == frame, name + ": one picture per frame");
        }
      }
    }
  }
}

// An actor that does not tell that it draws in the translucent pass.
class SilentActor : public vtkOpenGLActor
{
public:
  static SilentActor* New();
  vtkTypeMacro(SilentActor, vtkOpenGLActor);

  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    this->Render(vtkRenderer::SafeDownCast(viewport), this->Mapper);
    return 1;
  }
};
vtkStandardNewMacro(SilentActor);

// Actors that are drawn in the opaque pass by wish, parts of an assembly and followers, which have
// another actor draw, are not lost; but for the first ones, what is behind them and drawn later
// shines through.
void CheckOtherActors(Checks& check)
{
  const auto expected = Mix(Red, Background, 0.5);
  Stage opaque(Size, Size);
  AddRow(opaque, MakeMapper(MakeRow(0.0), 0.5))->ForceOpaqueOn();
  LookAlongZ(opaque);
  for (int frame = 0; frame < 2; ++frame)
  {
    const auto pixel = opaque.Render().At(Size / 2, Size / 2);
    check(IsNear(pixel, expected, 2), "opaque by wish" + Describe(pixel));
  }

  // The assembly makes the tubes thin, at first and in a later frame.
  for (const double scale : { 0.25, 1.0 })
  {
    Stage stage(Size, Size);
    auto actor = AddRow(stage, MakeMapper(MakeRow(0.0), 2.0));
    stage.Renderer->RemoveActor(actor);
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(actor);
    assembly->SetScale(scale);
    stage.Renderer->AddActor(assembly);
    AddWhiteSphere(stage, -0.6);
    LookAlongZ(stage);
    stage.Render();
    assembly->SetScale(0.25);
    // The row stays in the middle of its pixels.
    assembly->SetPosition(0.0, 0.375 * Pixel, 0.0);
    for (int frame = 0; frame < 2; ++frame)
    {
      const auto pixel = stage.Render().At(Size / 2, Size / 2);
      check(IsNear(pixel, Mix(Red, White, 0.5), 2), "part of an assembly" + Describe(pixel));
    }
  }

  Stage stage(Size, Size);
  vtkNew<SilentActor> silent;
  silent->SetMapper(MakeMapper(MakeRow(0.0), 0.5));
  silent->GetProperty()->SetColor(1.0, 0.0, 0.0);
  silent->GetProperty()->LightingOff();
  stage.Renderer->AddActor(silent);
  LookAlongZ(stage);
  for (int frame = 0; frame < 2; ++frame)
  {
    const auto pixel = stage.Render().At(Size / 2, Size / 2);
    check(IsNear(pixel, expected, 2), "an actor that does not tell its pass" + Describe(pixel));
  }
  stage.Renderer->RemoveActor(silent);

  vtkNew<vtkFollower> follower;
  follower->SetMapper(MakeMapper(MakeRow(0.0), 0.5));
  follower->GetProperty()->SetColor(1.0, 0.0, 0.0);
  follower->GetProperty()->LightingOff();
  follower->SetCamera(stage.Renderer->GetActiveCamera());
  stage.Renderer->AddActor(follower);
  AddWhiteSphere(stage, -0.6);
  LookAlongZ(stage);
  for (int frame = 0; frame < 2; ++frame)
  {
    const auto pixel = stage.Render().At(Size / 2, Size / 2);
    check(IsNear(pixel, Mix(Red, White, 0.5), 2), "a follower" + Describe(pixel));
  }
}

// Two views of the same actor, one of which makes its tubes thin.
void CheckTwoRenderers(Checks& check)
{
  Stage stage(Size, Size);
  auto mapper = MakeMapper(MakeRow(0.0), 4.0);
  auto actor = AddRow(stage, mapper);
  LookAlongZ(stage);
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  other->AddActor(actor);
  vtkCamera* camera = other->GetActiveCamera();
  camera->DeepCopy(stage.Renderer->GetActiveCamera());
  camera->SetParallelScale(8.0);
  stage.Window->AddRenderer(other);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture picture = stage.Render();
    const auto near = picture.At(50, Size / 2);
    check(IsNear(near, Red, 1), "the near view" + Describe(near));
    // The row lies on the edge between two rows of pixels there, at a sixteenth from it.
    const auto far = picture.At(150, Size / 2);
    check(IsNear(far, Mix(Red, Black, 0.5), 2), "the far view" + Describe(far));
  }
}

// The answer follows the cameras, the sizes of windows, the radius and the switch.
void CheckAnswer(Checks& check)
{
  Stage stage(Size, Size);
  auto mapper = MakeMapper(MakeRow(0.0), 2.5);
  auto actor = AddRow(stage, mapper);
  LookAlongZ(stage);
  check(!mapper->HasTranslucentPolygonalGeometry(), "unknown views are taken for near ones");
  stage.Render();
  check(!mapper->HasTranslucentPolygonalGeometry(), "wide tubes are opaque");
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetParallelScale(3.0);
  check(
    mapper->HasTranslucentPolygonalGeometry(), "thin tubes are translucent before they are drawn");
  stage.Render();
  check(mapper->HasTranslucentPolygonalGeometry(), "and after");
  mapper->SubPixelCoverageOff();
  check(!mapper->HasTranslucentPolygonalGeometry(), "not where coverage is off");
  stage.Render();
  mapper->SubPixelCoverageOn();
  check(mapper->HasTranslucentPolygonalGeometry(), "nor does it stay off");
  mapper->SetRadius(4.0 * mapper->GetRadius());
  check(!mapper->HasTranslucentPolygonalGeometry(), "wider tubes are opaque again");
  mapper->SetRadius(0.25 * mapper->GetRadius());
  stage.Window->SetSize(3 * Size, 3 * Size);
  check(!mapper->HasTranslucentPolygonalGeometry(), "a larger window makes tubes wider");
  stage.Window->SetSize(Size, Size);
  check(mapper->HasTranslucentPolygonalGeometry(), "a smaller one makes them thin");
  camera->SetParallelScale(1.0);
  check(!mapper->HasTranslucentPolygonalGeometry(), "a near view is opaque again");
  actor->SetScale(0.2);
  const auto moved = stage.Render().At(Size / 2, Size / 2);
  check(IsNear(moved, Mix(Red, Background, 0.5), 2), "scaled by its actor" + Describe(moved));
  stage.Renderer->RemoveActor(actor);
  stage.Render();
  Stage second(Size, Size);
  second.Renderer->AddActor(actor);
  LookAlongZ(second);
  actor->SetScale(1.0);
  second.Render();
  stage.Renderer->ResetCamera();
  stage.Render();
  second.Render();
  check(!mapper->HasTranslucentPolygonalGeometry(), "views that draw it no more are forgotten");
}

// The cells that are selected in columns of the window.
std::set<vtkIdType> Select(Stage& stage, int first, int last)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(first, 0, last, Size - 1);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  std::set<vtkIdType> cells;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    auto* ids = vtkIdTypeArray::SafeDownCast(selection->GetNode(i)->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      cells.insert(ids->GetValue(k));
    }
  }
  return cells;
}

// A needle whose radius goes from 1.5 pixels to 0, and lines of radius 0, which are invisible.
void CheckRadii(Checks& check)
{
  for (const bool coverage : { true, false })
  {
    auto lines = MakeLines({ { { -0.75, 0.5 * Pixel, 0.0 }, { 0.75, 0.5 * Pixel, 0.0 } },
      { { -0.75, 0.5, 0.0 }, { 0.75, 0.5, 0.0 } } });
    vtkNew<vtkDoubleArray> radii;
    radii->SetName("radius");
    for (const double pixels : { 1.5, 0.0, 0.0, 0.0 })
    {
      radii->InsertNextValue(pixels * Pixel);
    }
    lines->GetPointData()->AddArray(radii);
    auto mapper = MakeMapper(lines, 1.0);
    mapper->SetRadiusArrayName("radius");
    mapper->SetSubPixelCoverage(coverage);
    Stage stage(Size, Size);
    stage.Renderer->SetBackground(0.0, 0.0, 0.0);
    AddRow(stage, mapper);
    LookAlongZ(stage);
    const Picture picture = stage.Render();
    double light = 0.0;
    double upper = 0.0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        (y < 140 ? light : upper) += picture.At(x, y)[0] / 255.0;
      }
    }
    // A triangle of 150 by 3 pixels, and half a disc at its wide end.
    const double expected = 225.0 + 0.5 * 3.14159 * 2.25;
    std::cout << "needle: light " << light << ", expected " << expected << std::endl;
    check(std::abs(light / expected - 1.0) < (coverage ? 0.02 : 1.0), "light of a needle");
    check(coverage || std::abs(light / expected - 1.0) > 0.05, "its light without coverage");
    check(upper == 0.0, "lines of radius 0 are invisible");
    check(Select(stage, 0, Size - 1) == std::set<vtkIdType>{ 0 }, "and are not selected");
    // Near its end the needle covers a part of a pixel that falls as its radius does.
    const int near = picture.At(Size / 2 + 55, Size / 2)[0];
    const int nearer = picture.At(Size / 2 + 70, Size / 2)[0];
    check(!coverage ||
        (IsNear({ near, 0, 0 }, { 102, 0, 0 }, 6) && IsNear({ nearer, 0, 0 }, { 26, 0, 0 }, 6)),
      "coverage along a needle" + Describe(std::array<int, 3>{ near, nearer, 0 }));
  }
}

// Light from the side on a slanted line: below a pixel of width all that is seen of it has the same
// colour, the average over its width; above two, light and shade lie side by side.
void CheckLight(Checks& check)
{
  for (const double width : { 0.6, 0.95, 3.0 })
  {
    auto mapper = MakeMapper(MakeLines({ { { -0.8, -0.3, 0.0 }, { 0.8, 0.4, 0.0 } } }), width);
    Stage stage(Size, Size);
    stage.Renderer->SetBackground(0.0, 0.0, 0.0);
    stage.Renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(-2.0, 5.0, 1.0);
    stage.Renderer->AddLight(light);
    stage.Add(mapper);
    LookAlongZ(stage);
    const Picture picture = stage.Render();
    int lowest = 255;
    int highest = 0;
    for (int x = 40; x < 160; ++x)
    {
      for (int y = 0; y < Size; ++y)
      {
        const int value = picture.At(x, y)[0];
        lowest = value > 0 ? std::min(lowest, value) : lowest;
        highest = std::max(highest, value);
      }
    }
    const std::string text = "light on a tube " + std::to_string(width) +
      " pixels wide: " + std::to_string(lowest) + " to " + std::to_string(highest);
    check(highest > 40 && (width < 1.0) == (highest - lowest <= 1), text);
  }
}

// A slanted line a tenth of a pixel wide is found in each column.
void CheckSelection(Checks& check)
{
  for (const bool coverage : { true, false })
  {
    auto mapper = MakeMapper(MakeLines({ { { 0.03, 0.9, 0.0 }, { 0.07, 0.9, 0.0 } },
                               { { -0.9, -0.3, 0.0 }, { 0.9, 0.25, 0.0 } } }),
      0.1);
    mapper->SetSubPixelCoverage(coverage);
    Stage stage(Size, Size);
    AddRow(stage, mapper, 0.3);
    LookAlongZ(stage);
    stage.Render();
    int found = 0;
    for (int x = 20; x < 180; x += 10)
    {
      found += Select(stage, x, x) == std::set<vtkIdType>{ 1 } ? 1 : 0;
    }
    check(coverage ? found == 16 : found < 8,
      "columns in which the line is found: " + std::to_string(found));
  }
}

void CheckCopy(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  check(mapper->GetSubPixelCoverage(), "coverage is on by default");
  const vtkMTimeType before = mapper->GetMTime();
  mapper->SubPixelCoverageOff();
  check(mapper->GetMTime() > before, "the switch modifies the mapper");
  vtkNew<vtkVoxelLineMapper> copy;
  copy->ShallowCopy(mapper);
  check(!copy->GetSubPixelCoverage(), "a copy has the switch of its original");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("SubPixelCoverage: Off") != std::string::npos, "the switch is printed");
}
}

int TestVoxelLineMapperThinTubes(int, char*[])
{
  Checks check;
  const auto messages = Listen();
  const KeptDisplay display;
  for (const Pass pass : { Plain, Independent, Peeling })
  {
    CheckSphere(check, pass);
  }
  CheckOtherActors(check);
  CheckTwoRenderers(check);
  CheckAnswer(check);
  CheckRadii(check);
  CheckLight(check);
  CheckSelection(check);
  CheckCopy(check);
  check(messages->IsQuiet(), "nothing is said");
  return check.GetResult();
}
