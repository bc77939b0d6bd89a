// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that light on lines goes with all that vtkPolyDataMapper can do with them: whatever way a
// line gets to the picture, in all passes, with multisampling, clipped, by cell and by point
// colours, drawn by hardware or as triangles, its pixels have the one lit colour that is known from
// the model; and that what is not to be lit is drawn as vtkPolyDataMapper draws it.

#include "VoxelLineMapperTesting.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightsPass.h"
#include "vtkLineIllumination.h"
#include "vtkLookupTable.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlane.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

#include <functional>

using namespace VoxelLineMapperTesting;

namespace
{
const std::array<int, 3> White{ 255, 255, 255 };

// A line along x through the middle of the picture, with a point in the middle, and one upwards,
// under light from the viewer and from above: two colours.
vtkSmartPointer<vtkPolyData> MakeCross(double z = 0.0)
{
  return MakeLines({ { { -0.9, 0.0, z }, { 0.0, 0.0, z }, { 0.9, 0.0, z } },
    { { 0.5, -0.9, z }, { 0.5, -0.3, z } } });
}

constexpr double LightDirection[3] = { 0.0, 0.6, 0.8 };

struct Scene : Stage
{
  vtkNew<vtkIlluminatedLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;

  explicit Scene(vtkPolyData* lines = MakeCross(), double opacity = 1.0)
    : Stage(200, 200)
  {
    this->Mapper->SetInputData(lines);
    this->Actor = this->Add(this->Mapper, opacity);
    this->Actor->GetProperty()->SetLineWidth(7.0);
    this->Actor->GetProperty()->SetColor(1.0, 0.5, 0.25);
    this->Actor->GetProperty()->SetAmbient(0.125);
    LookAlongZ(*this);
    vtkNew<vtkLight> light;
    light->SetPosition(LightDirection);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(light);
  }
};

std::array<int, 3> GetLit(const double tangent[3], const Point& color, double ambient = 0.125)
{
  const double viewer[3] = { 0.0, 0.0, 1.0 };
  const double diffuse = vtkLineIllumination::GetDiffuseTerm(
    tangent, viewer, LightDirection, vtkLineIllumination::CylinderAveraging);
  std::array<int, 3> lit;
  for (int i = 0; i < 3; ++i)
  {
    lit[i] = static_cast<int>(std::lround(255.0 * color[i] * (ambient + diffuse)));
  }
  return lit;
}

const double AlongX[3] = { 1.0, 0.0, 0.0 };
const double AlongY[3] = { 0.0, 1.0, 0.0 };
const Point Orange{ 1.0, 0.5, 0.25 };

std::array<int, 3> Mix(const std::array<int, 3>& a, const std::array<int, 3>& b, double weightOfA)
{
  std::array<int, 3> mixed;
  for (int i = 0; i < 3; ++i)
  {
    mixed[i] = static_cast<int>(std::lround(weightOfA * a[i] + (1.0 - weightOfA) * b[i]));
  }
  return mixed;
}

// Where the lines of MakeCross() are: beside the middle and on the one upwards.
constexpr int Flat[2] = { 70, 100 };
constexpr int Upright[2] = { 150, 40 };

void CheckPixel(Checks& check, const std::string& name, const Picture& picture, const int place[2],
  const std::array<int, 3>& expected, int tolerance = 1)
{
  const auto color = picture.At(place[0], place[1]);
  check(IsNear(color, expected, tolerance),
    name + ":" + Describe(color) + ", expected" + Describe(expected));
}

void CheckCross(
  Checks& check, const std::string& name, const Picture& picture, const Point& color = Orange)
{
  CheckPixel(check, name + ", flat", picture, Flat, GetLit(AlongX, color));
  CheckPixel(check, name + ", upright", picture, Upright, GetLit(AlongY, color));
}

// Widths: pixels across the upright line.
int GetWidth(const Picture& picture)
{
  int width = 0;
  for (int x = 0; x < picture.Width; ++x)
  {
    width += picture.At(x, Upright[1]) != Background ? 1 : 0;
  }
  return width;
}

void CheckWidths(Checks& check)
{
  for (double width : { 1.0, 2.0, 12.0 })
  {
    Scene scene;
    scene.Actor->GetProperty()->SetLineWidth(width);
    const Picture picture = scene.Render();
    // One pixel may be any of two that the line runs between.
    int place[2] = { Upright[0], Upright[1] };
    place[0] -= picture.At(place[0], place[1]) == Background ? 1 : 0;
    CheckPixel(check, "width " + std::to_string(width), picture, place, GetLit(AlongY, Orange));
    check(GetWidth(picture) == static_cast<int>(width), "width " + std::to_string(width));
  }
  // Beyond what the hardware can, VTK draws two triangles per segment by a geometry shader.
  Scene scene;
  scene.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  const int width = static_cast<int>(window->GetMaximumHardwareLineWidth()) + 20;
  scene.Window->SetSize(2 * width + 200, 200);
  scene.Actor->GetProperty()->SetLineWidth(width);
  auto lines = MakeLines({ { { 0.0, -0.9, 0.0 }, { 0.0, 0.9, 0.0 } } });
  vtkNew<vtkFloatArray> powers;
  powers->SetName("power");
  powers->InsertNextValue(0.0f);
  powers->InsertNextValue(40.0f);
  lines->GetPointData()->AddArray(powers);
  scene.Mapper->SetInputData(lines);
  Picture picture = scene.Render();
  const int middle[2] = { picture.Width / 2, 100 };
  const int side[2] = { picture.Width / 2 - width / 2 + 3, 60 };
  const int beside[2] = { picture.Width / 2 - width / 2 - 3, 60 };
  CheckPixel(check, "beyond the hardware, middle", picture, middle, GetLit(AlongY, Orange));
  CheckPixel(check, "beyond the hardware, side", picture, side, GetLit(AlongY, Orange));
  CheckPixel(check, "beyond the hardware, beside", picture, beside, Background);

  // Exponents go the same way: 0 below, 40 above, 20 in the middle.
  scene.Mapper->SetSpecularPowerArrayName("power");
  vtkProperty* property = scene.Actor->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(0.0);
  property->SetSpecular(1.0);
  picture = scene.Render();
  const double viewer[3] = { 0.0, 0.0, 1.0 };
  const int specular = static_cast<int>(std::lround(255.0 *
    vtkLineIllumination::GetSpecularTerm(AlongY, viewer, LightDirection,
      40.0 * (100.5 - 10.0) / 180.0, vtkLineIllumination::CylinderAveraging,
      vtkLineIllumination::Phong)));
  CheckPixel(
    check, "beyond the hardware, exponent", picture, middle, { specular, specular, specular });
}

enum Pass
{
  Independent,
  Peeling,
  Plain
};
const char* const PassNames[] = { "order-independent", "peeling", "plain" };

void SetPass(Stage& stage, Pass pass)
{
  if (pass == Peeling)
  {
    stage.Renderer->UseDepthPeelingOn();
    stage.Renderer->SetMaximumNumberOfPeels(20);
    stage.Renderer->SetOcclusionRatio(0.0);
  }
  else if (pass == Plain)
  {
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(vtkNew<vtkLightsPass>());
    passes->AddItem(vtkNew<vtkOpaquePass>());
    passes->AddItem(vtkNew<vtkTranslucentPass>());
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> camera;
    camera->SetDelegatePass(sequence);
    vtkOpenGLRenderer::SafeDownCast(stage.Renderer)->SetPass(camera);
  }
}

// Translucent lines before and behind an opaque, unlit, white sphere.
void CheckPasses(Checks& check)
{
  const int above[2] = { 30, 100 };
  const int middle[2] = { 80, 100 };
  for (Pass pass : { Independent, Peeling, Plain })
  {
    for (double z : { 0.9, -0.9 })
    {
      Scene scene(MakeCross(z), 0.5);
      scene.AddSphere(0.0, 0.0, 0.0, 0.5)->GetProperty()->LightingOff();
      SetPass(scene, pass);
      const Picture picture = scene.Render();
      const std::string name = std::string(PassNames[pass]) + (z > 0.0 ? ", before" : ", behind");
      const auto lit = GetLit(AlongX, Orange);
      CheckPixel(check, name, picture, middle, z > 0.0 ? Mix(lit, White, 0.5) : White, 2);
      CheckPixel(check, name + ", beside", picture, above, Mix(lit, Background, 0.5), 2);
    }
  }
  // Two lines of different colours, one before the other: exact by peeling.
  const Point blue{ 0.0, 0.0, 1.0 };
  for (double z : { 0.2, -0.2 })
  {
    Scene scene(MakeCross(z), 0.5);
    vtkNew<vtkIlluminatedLineMapper> other;
    other->SetInputData(MakeCross(0.0));
    auto actor = scene.Add(other, 0.5);
    actor->GetProperty()->DeepCopy(scene.Actor->GetProperty());
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    SetPass(scene, Peeling);
    const auto first = GetLit(AlongX, z > 0.0 ? Orange : blue);
    const auto second = GetLit(AlongX, z > 0.0 ? blue : Orange);
    CheckPixel(check, "peeling, two lines", scene.Render(), middle,
      Mix(first, Mix(second, Background, 0.5), 0.5), 2);
  }
}

void CheckMultisampling(Checks& check)
{
  Scene scene;
  scene.Window->SetMultiSamples(4);
  scene.Actor->RotateZ(20.0);
  const Picture picture = scene.Render();
  const double tangent[3] = { std::cos(0.34906585), std::sin(0.34906585), 0.0 };
  const int middle[2] = { 100, 100 };
  const auto lit = GetLit(tangent, Orange);
  CheckPixel(check, "with several samples", picture, middle, lit);
  int between = 0;
  for (int y = 0; y < 200; ++y)
  {
    const auto color = picture.At(100, y);
    between += color[0] > Background[0] + 3 && color[0] < lit[0] - 3 ? 1 : 0;
  }
  check(between >= 1, "edges are smooth with several samples");
}

void CheckClipping(Checks& check)
{
  Scene scene;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-0.2, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  scene.Mapper->AddClippingPlane(plane);
  const Picture picture = scene.Render();
  const int clipped[2] = { 90, 100 };
  CheckPixel(check, "clipped, rest", picture, Flat, GetLit(AlongX, Orange));
  CheckPixel(check, "clipped", picture, clipped, Background);
  CheckPixel(check, "clipped", picture, Upright, Background);
}

// Lines in the plane of a polygon are drawn before it where VTK is told so.
void CheckCoincident(Checks& check)
{
  auto square = MakeLines({});
  for (const Point& corner :
    Curve{ { -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.0 }, { -1.0, 1.0, 0.0 } })
  {
    square->GetPoints()->InsertNextPoint(corner.data());
  }
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  square->SetPolys(polys);
  vtkNew<vtkPolyDataMapper> plane;
  plane->SetInputData(square);
  for (bool isResolved : { false, true })
  {
    // Behind the square by less than a ten-thousandth of the depth.
    Scene scene(MakeCross(-0.001));
    scene.Add(plane)->GetProperty()->LightingOff();
    if (isResolved)
    {
      vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
      scene.Mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -20.0);
    }
    const Picture picture = scene.Render();
    vtkMapper::SetResolveCoincidentTopologyToDefault();
    if (isResolved)
    {
      CheckCross(check, "coincident", picture);
    }
    else
    {
      CheckPixel(check, "behind", picture, Flat, White);
    }
  }
}

// A table of four colours over 0 to 4; values in the middle of a colour's range.
vtkSmartPointer<vtkLookupTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(4);
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 1.0, 0.0);
  table->SetTableValue(2, 0.0, 0.0, 1.0);
  table->SetTableValue(3, 1.0, 1.0, 0.0);
  table->SetRange(0.0, 4.0);
  table->Build();
  return table;
}

void CheckScalars(Checks& check)
{
  const Point red{ 1.0, 0.0, 0.0 };
  const Point blue{ 0.0, 0.0, 1.0 };
  for (const std::string kind : { "cells", "points", "points mapped per pixel" })
  {
    auto lines = MakeCross();
    vtkNew<vtkFloatArray> scalars;
    scalars->SetName("s");
    if (kind == "cells")
    {
      scalars->InsertNextValue(0.5f);
      scalars->InsertNextValue(2.5f);
      lines->GetCellData()->SetScalars(scalars);
    }
    else
    {
      for (float value : { 0.5f, 0.5f, 0.5f, 2.5f, 2.5f })
      {
        scalars->InsertNextValue(value);
      }
      lines->GetPointData()->SetScalars(scalars);
    }
    // A shared point: its copy has the colour of the point, the lines those of their cells.
    for (bool isShared : { false, true })
    {
      if (isShared)
      {
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell({ 0, 1 });
        cells->InsertNextCell({ 4, 3 });
        cells->InsertNextCell({ 1, 2 });
        lines->SetLines(cells);
        if (kind == "cells")
        {
          scalars->InsertNextValue(0.5f);
        }
      }
      Scene scene(lines);
      scene.Mapper->SetLookupTable(MakeTable());
      scene.Mapper->UseLookupTableScalarRangeOn();
      scene.Mapper->SetInterpolateScalarsBeforeMapping(kind == "points mapped per pixel");
      const std::string name = "scalars of " + kind + (isShared ? ", shared points" : "");
      const Picture picture = scene.Render();
      const int right[2] = { 130, 100 };
      CheckPixel(check, name + ", flat", picture, Flat, GetLit(AlongX, red));
      CheckPixel(check, name + ", right", picture, right, GetLit(AlongX, red));
      CheckPixel(check, name + ", upright", picture, Upright, GetLit(AlongY, blue));
    }
  }
}

// The flags of vtkProperty and arrays that would disturb VTK's own light on lines.
void CheckUndisturbed(Checks& check)
{
  auto lines = MakeCross();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 5; ++i)
  {
    normals->InsertNextTuple3(0.0, -0.6, -0.8);
  }
  Scene scene(lines);
  for (bool hasNormals : { false, true })
  {
    lines->GetPointData()->SetNormals(hasNormals ? normals.Get() : nullptr);
    for (int interpolation : { VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR })
    {
      for (int representation : { VTK_SURFACE, VTK_WIREFRAME })
      {
        scene.Actor->GetProperty()->SetInterpolation(interpolation);
        scene.Actor->GetProperty()->SetRepresentation(representation);
        CheckCross(check,
          "interpolation " + std::to_string(interpolation) + (hasNormals ? ", normals" : ""),
          scene.Render());
      }
    }
  }
}

// The same picture as that of vtkPolyDataMapper.
void CheckAsPlain(
  Checks& check, const std::string& name, const std::function<void(Scene&, vtkActor*)>& change)
{
  auto data = MakeCross();
  Picture pictures[2];
  for (int plain : { 0, 1 })
  {
    Scene scene(data);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    if (plain)
    {
      scene.Actor->SetMapper(mapper);
    }
    change(scene, scene.Actor);
    pictures[plain] = scene.Render();
  }
  const Difference difference = Compare(pictures[0], pictures[1]);
  check(difference.Largest == 0 && GetCoverage(pictures[0], Background) > 0.0001,
    name + " as vtkPolyDataMapper" + Describe(difference));
}

void CheckNotLit(Checks& check)
{
  CheckAsPlain(
    check, "lighting off", [](Scene&, vtkActor* actor) { actor->GetProperty()->LightingOff(); });
  CheckAsPlain(check, "no light",
    [](Scene& scene, vtkActor*)
    {
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AutomaticLightCreationOff();
    });
  CheckAsPlain(
    check, "tubes", [](Scene&, vtkActor* actor) { actor->GetProperty()->RenderLinesAsTubesOn(); });
  CheckAsPlain(check, "points",
    [](Scene&, vtkActor* actor) { actor->GetProperty()->SetRepresentationToPoints(); });

  // Other cells of the same data set.
  auto data = MakeCross();
  data->GetPoints()->InsertNextPoint(-0.8, 0.8, 0.0);
  data->GetPoints()->InsertNextPoint(-0.2, 0.8, 0.0);
  data->GetPoints()->InsertNextPoint(-0.2, 0.3, 0.0);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 5, 6, 7 });
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 1 });
  for (int representation : { VTK_SURFACE, VTK_WIREFRAME })
  {
    Picture pictures[3];
    for (int kind : { 0, 1, 2 })
    {
      // 0: lines alone, 1: all, 2: all but the lines by vtkPolyDataMapper.
      vtkNew<vtkPolyData> part;
      part->SetPoints(data->GetPoints());
      part->SetLines(kind == 2 ? vtkNew<vtkCellArray>().Get() : data->GetLines());
      if (kind > 0)
      {
        part->SetPolys(polys);
        part->SetVerts(verts);
      }
      Scene scene(part);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(part);
      if (kind == 2)
      {
        scene.Actor->SetMapper(mapper);
      }
      scene.Actor->GetProperty()->SetRepresentation(representation);
      scene.Actor->GetProperty()->SetPointSize(13.0);
      pictures[kind] = scene.Render();
    }
    bool isSum = true;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const auto all = pictures[1].At(x, y);
        const auto others = pictures[2].At(x, y);
        isSum &= all == others || (all == pictures[0].At(x, y));
        isSum &= all != Background || (others == Background && pictures[0].At(x, y) == Background);
      }
    }
    check(isSum && GetCoverage(pictures[2], Background) > 0.01,
      "other cells are drawn as vtkPolyDataMapper draws them");
  }
}

// Nothing is computed or uploaded anew but for the input and its arrays.
void CheckUploads(Checks& check)
{
  Scene scene;
  scene.Render();
  const auto getTime = [&]
  { return scene.Mapper->GetVBOs()->GetVBO("lineTangentMC")->GetUploadTime().GetMTime(); };
  vtkMTimeType time = getTime();
  scene.Renderer->GetActiveCamera()->Azimuth(1.0);
  scene.Actor->RotateZ(1.0);
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.Mapper->GetIllumination()->SetSpecularPower(300.0);
  scene.Mapper->ScalarVisibilityOff();
  vtkNew<vtkLight> light;
  scene.Renderer->AddLight(light);
  scene.Render();
  check(getTime() == time, "no upload for camera, actor, property, model and lights");
  scene.Mapper->GetInput()->Modified();
  scene.Render();
  check(getTime() > time, "an upload for a changed input");
}

// What the frame before was drawn with must not matter.
void CheckChanges(Checks& check)
{
  Scene scene;
  CheckCross(check, "at first", scene.Render());
  scene.Actor->GetProperty()->LightingOff();
  scene.Render();
  scene.Actor->GetProperty()->LightingOn();
  CheckCross(check, "lighting on again", scene.Render());
  const vtkMTimeType time = scene.Mapper->GetMTime();
  scene.Mapper->GetIllumination()->SetModelToMaximumReflection();
  check(scene.Mapper->GetMTime() > time, "the mapper changes with its model");
  CheckPixel(check, "maximum reflection", scene.Render(), Upright,
    { static_cast<int>(std::lround(255 * 0.925)), 118, 59 });
  scene.Mapper->SetIllumination(nullptr);
  CheckCross(check, "the default model again", scene.Render());

  // One mapper in two viewports under different lights, and in another window.
  vtkNew<vtkRenderer> other;
  vtkNew<vtkLight> light;
  light->SetPosition(0.0, 0.0, 1.0);
  light->SetIntensity(0.5);
  other->AddLight(light);
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(0.0, 0.0, 1.0);
  lamp->SetIntensity(0.25);
  other->AddLight(lamp);
  other->AddActor(scene.Actor);
  other->SetActiveCamera(scene.Renderer->GetActiveCamera());
  other->SetBackground(scene.Renderer->GetBackground());
  scene.Window->SetSize(400, 200);
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetViewport(0.5, 0.0, 1.0, 1.0);
  scene.Window->AddRenderer(other);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Picture picture = scene.Render();
    CheckCross(check, "left viewport", picture);
    const double across = 0.125 + 0.75 * std::atan(1.0);
    const int place[2] = { 200 + Upright[0], Upright[1] };
    CheckPixel(check, "right viewport", picture, place,
      { static_cast<int>(std::lround(255 * across)), static_cast<int>(std::lround(127.5 * across)),
        static_cast<int>(std::lround(63.75 * across)) });
  }
  Scene second;
  second.Actor->SetMapper(scene.Mapper);
  CheckCross(check, "second window", second.Render());
  CheckCross(check, "first window again", scene.Render());
  second.Actor->SetMapper(nullptr);
  second.Renderer->RemoveAllViewProps();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  CheckCross(check, "after release", scene.Render());

  vtkNew<vtkIlluminatedLineMapper> copy;
  scene.Mapper->GetIllumination()->StretchDynamicRangeOn();
  scene.Mapper->SetTangentArrayName("t");
  scene.Mapper->SetSpecularPowerArrayName("p");
  copy->ShallowCopy(scene.Mapper);
  check(copy->GetIllumination() == scene.Mapper->GetIllumination() &&
      copy->GetTangentArrayName() == "t" && copy->GetSpecularPowerArrayName() == "p" &&
      copy->GetInput() == scene.Mapper->GetInput(),
    "a shallow copy has all");
  std::ostringstream text;
  copy->Print(text);
  for (const char* name : { "TangentArrayName: t", "SpecularPowerArrayName: p", "Illumination:" })
  {
    check(text.str().find(name) != std::string::npos, std::string("printed: ") + name);
  }
}
}

int TestIlluminatedLineMapperPasses(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckWidths(check);
  CheckPasses(check);
  CheckMultisampling(check);
  CheckClipping(check);
  CheckCoincident(check);
  CheckScalars(check);
  CheckUndisturbed(check);
  CheckNotLit(check);
  CheckUploads(check);
  CheckChanges(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
