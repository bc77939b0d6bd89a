// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that light on lines goes with all that vtkPolyDataMapper can do with them: whatever way a
// line gets to the picture, in all passes, with multisampling, clipped, by cell and by point
// colours, drawn by hardware or as triangles, its pixels have the one lit colour that is known from
// the model.

#include "IlluminatedLineTesting.h"
#include "RenderPassTesting.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"

using namespace IlluminatedLineTesting;

namespace
{
const std::array<int, 3> White{ 255, 255, 255 };

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
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
