// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that bad input neither crashes nor is lost in silence: the valid rest is drawn and lit,
// what is replaced is counted and said once.

#include "VoxelLineMapperTesting.h"
#include "vtkFloatArray.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkIlluminatedLineVertices.h"
#include "vtkLight.h"
#include "vtkLineIllumination.h"
#include "vtkMath.h"
#include "vtkStringArray.h"
#include "vtkWeakPointer.h"

#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
const double NaN = vtkMath::Nan();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double LightDirection[3] = { 0.0, 0.6, 0.8 };

// A line along x through the middle of the picture; a second one may follow.
const Curve Good{ { -0.8, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.8, 0.0, 0.0 } };
constexpr int Middle[2] = { 100, 100 };

struct Scene : Stage
{
  vtkNew<vtkIlluminatedLineMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;

  explicit Scene(vtkPolyData* lines)
    : Stage(200, 200)
  {
    this->Mapper->SetInputData(lines);
    this->Actor = this->Add(this->Mapper);
    this->Actor->GetProperty()->SetLineWidth(7.0);
    this->Actor->GetProperty()->SetDiffuse(0.5);
    this->Actor->GetProperty()->SetSpecular(0.5);
    this->Actor->GetProperty()->SetSpecularPower(20.0);
    LookAlongZ(*this);
    vtkNew<vtkLight> light;
    light->SetPosition(LightDirection);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(light);
  }
};

// Grey of a line with that tangent and exponent.
int GetLit(const Point& tangent, double power = 20.0)
{
  const double viewer[3] = { 0.0, 0.0, 1.0 };
  const int model = vtkLineIllumination::CylinderAveraging;
  return static_cast<int>(std::lround(127.5 *
    (vtkLineIllumination::GetDiffuseTerm(tangent.data(), viewer, LightDirection, model) +
      vtkLineIllumination::GetSpecularTerm(
        tangent.data(), viewer, LightDirection, power, model, vtkLineIllumination::Phong))));
}

const Point AlongX{ 1.0, 0.0, 0.0 };
const Point AlongY{ 0.0, 1.0, 0.0 };

void CheckGrey(
  Checks& check, const std::string& name, const Picture& picture, int x, int y, int expected)
{
  const auto color = picture.At(x, y);
  check(IsNear(color, { expected, expected, expected }, 1),
    name + ":" + Describe(color) + ", expected " + std::to_string(expected));
}

void CheckMiddle(Checks& check, const std::string& name, const Picture& picture, int expected)
{
  CheckGrey(check, name, picture, Middle[0], Middle[1], expected);
}

void CheckGeometry(Checks& check, Messages* messages)
{
  struct
  {
    const char* Name;
    std::vector<Curve> Curves;
    const char* Warning;
  } cases[] = {
    { "good lines", { Good }, "" },
    { "a line without points", { {}, Good }, "" },
    { "a line of one point", { { { 0.0, 0.5, 0.0 } }, Good }, "" },
    { "a line without length", { { { 0.0, 0.5, 0.0 }, { 0.0, 0.5, 0.0 } }, Good },
      "1 lines have no extent" },
    { "a NaN", { { { 0.0, 0.5, 0.0 }, { 0.1, NaN, 0.0 } }, Good }, "1 points of lines" },
    { "infinite points",
      { { { Infinity, 0.5, 0.0 }, { 0.1, 0.5, -Infinity }, { 0.2, 0.5, 0.0 }, { 0.3, 0.5, 0.0 } },
        Good },
      "2 points of lines" },
    { "repeated points",
      { { { -0.8, 0.0, 0.0 }, { -0.8, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 },
        { 0.8, 0.0, 0.0 }, { 0.8, 0.0, 0.0 } } },
      "" },
  };
  for (const auto& test : cases)
  {
    Scene scene(MakeLines(test.Curves));
    scene.Render();
    const Picture picture = scene.Render();
    CheckMiddle(check, test.Name, picture, GetLit(AlongX));
    const std::string warning = test.Warning;
    if (!warning.empty())
    {
      check(messages->TakeWarnings(warning) == 1, warning + ": one warning");
    }
    check(messages->IsQuiet(), std::string(test.Name) + ": nothing else is said");
  }

  // A line without tangents is lit as if it lay across.
  Scene scene(MakeLines({ Good }));
  scene.Mapper->SetTangentArrayName("t");
  check(GetLit({ 0.0, 0.0, 0.0 }) == GetLit(AlongX), "across");

  // Nothing at all, and no lines.
  for (bool hasPoints : { false, true })
  {
    Scene empty(hasPoints ? MakeLines({}) : vtkSmartPointer<vtkPolyData>::New());
    check(GetCoverage(empty.Render(), Background) == 0.0, "nothing is drawn of nothing");
  }
  Scene none(nullptr);
  none.Render();
  messages->TakeErrors("No input");
  check(messages->IsQuiet(), "nothing else is said about nothing");
}

vtkSmartPointer<vtkFloatArray> MakeArray(
  const std::string& name, int components, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  for (double value : values)
  {
    array->InsertNextValue(static_cast<float>(value));
  }
  return array;
}

void CheckWrongArrays(Checks& check, Messages* messages)
{
  struct
  {
    const char* Name;
    const char* Warning;
  } cases[] = { { "missing", "no point array \"missing\"" }, { "text", "no numbers" },
    { "short", "2 tuples of 3" }, { "long", "4 tuples of 1" }, { "pairs", "3 tuples of 2" } };
  auto lines = MakeLines({ Good });
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->SetNumberOfValues(3);
  lines->GetPointData()->AddArray(text);
  lines->GetPointData()->AddArray(MakeArray("short", 3, { 0.0, 1.0, 0.0, 0.0, 1.0, 0.0 }));
  lines->GetPointData()->AddArray(MakeArray("long", 1, { 500.0, 500.0, 500.0, 500.0 }));
  lines->GetPointData()->AddArray(MakeArray("pairs", 2, { 1.0, 2.0, 1.0, 2.0, 1.0, 2.0 }));
  for (const auto& test : cases)
  {
    for (bool isPower : { false, true })
    {
      Scene scene(lines);
      if (isPower)
      {
        scene.Mapper->SetSpecularPowerArrayName(test.Name);
      }
      else
      {
        scene.Mapper->SetTangentArrayName(test.Name);
      }
      scene.Render();
      CheckMiddle(check, test.Name, scene.Render(), GetLit(AlongX));
      check(messages->TakeWarnings(test.Warning) == 1, std::string(test.Name) + ": one warning");
      // Another change of the input does not say it again.
      lines->GetPoints()->Modified();
      scene.Render();
      check(messages->IsQuiet(), std::string(test.Name) + ": nothing else is said");
    }
  }
}

void CheckBadValues(Checks& check, Messages* messages)
{
  // Tangents given: along y, null, NaN. Points beside lines do not count.
  auto lines = MakeLines({ Good });
  lines->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  lines->GetPointData()->AddArray(
    MakeArray("t", 3, { 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, NaN, 0.0, 0.0, 0.0, 0.0 }));
  {
    Scene scene(lines);
    scene.Mapper->SetTangentArrayName("t");
    const Picture picture = scene.Render();
    CheckGrey(check, "a given tangent", picture, 22, 100, GetLit({ 0.025, 1.0, 0.0 }));
    CheckMiddle(check, "a null tangent", picture, GetLit(AlongX));
    CheckGrey(check, "a tangent that is NaN", picture, 170, 100, GetLit(AlongX));
    check(messages->TakeWarnings("2 tangents in the point array \"t\"") == 1,
      "one warning about tangents");
  }
  // Exponents: 100, those that count as the model's, and one that is too large.
  for (const auto& [value, expected] : std::vector<std::pair<double, double>>{ { 100.0, 100.0 },
         { NaN, 20.0 }, { -3.0, 20.0 }, { 5000.0, 1000.0 }, { Infinity, 1000.0 } })
  {
    lines->GetPointData()->AddArray(MakeArray("p", 1, { value, value, value, NaN }));
    Scene scene(lines);
    scene.Mapper->SetSpecularPowerArrayName("p");
    // Across the mirrored light, where the exponent matters.
    scene.Mapper->GetIllumination()->StretchDynamicRangeOff();
    CheckMiddle(
      check, "exponent " + std::to_string(value), scene.Render(), GetLit(AlongX, expected));
    const bool isInvalid = !(value >= 0.0);
    const std::string warning = std::string("holds ") + (isInvalid ? "3" : "0") +
      " exponents that are negative or NaN, which the exponent of the light model replaces, and " +
      (value > 1000.0 ? "3" : "0") + " above 1000";
    check(messages->TakeWarnings(warning) == (value == 100.0 ? 0 : 1), "one warning: " + warning);
    // The exponent in use may change without new buffers.
    if (isInvalid)
    {
      scene.Actor->GetProperty()->SetSpecularPower(3.0);
      CheckMiddle(check, "another exponent", scene.Render(), GetLit(AlongX, 3.0));
    }
  }
  check(messages->IsQuiet(), "nothing else is said about values");
}

void CheckLights(Checks& check, Messages* messages)
{
  Scene scene(MakeLines({ Good }));
  scene.Renderer->RemoveAllLights();
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetPosition(LightDirection);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(i < 16 ? 1.0 / 16.0 : 1.0);
    scene.Renderer->AddLight(light);
  }
  scene.Render();
  CheckMiddle(check, "too many lights", scene.Render(), GetLit(AlongX));
  check(messages->TakeWarnings("the last 4 are left out") == 1, "one warning about lights");
  check(messages->IsQuiet(), "nothing else is said about lights");
}

Point GetPoint(vtkPolyData* data, vtkIdType id)
{
  Point point;
  data->GetPoint(id, point.data());
  return point;
}

// Arrays of the wrong length beside points that are copied; an array's own lookup table.
void CheckCopies(Checks& check, Messages* messages)
{
  auto lines = MakeLines({ Good, { { 0.0, 0.7, 0.0 }, { 0.0, 0.3, 0.0 } } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  cells->InsertNextCell({ 1, 2 });
  cells->InsertNextCell({ 3, 4 });
  cells->InsertNextCell({ 3, 1 });
  lines->SetLines(cells);
  lines->GetPointData()->AddArray(MakeArray("short", 3, { 0.0, 1.0, 0.0, 0.0, 1.0, 0.0 }));
  lines->GetPointData()->AddArray(MakeArray("long", 1, { 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }));
  Scene scene(lines);
  const Picture picture = scene.Render();
  CheckGrey(check, "shared points, left", picture, 60, 100, GetLit(AlongX));
  CheckGrey(check, "shared points, right", picture, 140, 100, GetLit(AlongX));
  CheckGrey(check, "shared points, above", picture, 100, 130, GetLit(AlongY));
  check(lines->GetNumberOfPoints() == 5 && lines->GetPointData()->GetNumberOfArrays() == 2,
    "the input stays as it is");

  // What the mapper draws: points 1, 3 and 1 once more, whatever the lengths of other arrays.
  lines->GetPointData()->SetScalars(MakeArray("s", 1, { 1.0, 2.0, 3.0, 4.0, 5.0 }));
  lines->GetPointData()->GetScalars()->CreateDefaultLookupTable();
  vtkIlluminatedLineVertices vertices;
  check(vertices.Update(lines, "", ""), "made");
  check(!vertices.Update(lines, "", ""), "not made again");
  vtkPolyData* data = vertices.GetData();
  vtkPointData* from = lines->GetPointData();
  vtkPointData* to = data->GetPointData();
  check(data->GetNumberOfPoints() == 8 && to->GetArray(0) == from->GetArray(0) &&
      to->GetArray(1) == from->GetArray(1),
    "arrays of another length are no part of copies");
  vtkDataArray* scalars = to->GetScalars();
  bool areCopied = scalars && scalars->GetNumberOfTuples() == 8 &&
    scalars->GetLookupTable() == from->GetScalars()->GetLookupTable();
  const int ids[] = { 0, 1, 2, 3, 4, 1, 3, 1 };
  for (int i = 0; areCopied && i < 8; ++i)
  {
    areCopied = scalars->GetComponent(i, 0) == 1.0 + ids[i] &&
      vtkMath::Distance2BetweenPoints(GetPoint(data, i).data(), GetPoint(lines, ids[i]).data()) ==
        0.0;
  }
  check(areCopied, "copies have the values of their points");
  lines->GetPointData()->RemoveArray("s");

  // The input goes and another comes, with and without shared points.
  scene.Mapper->SetInputData(MakeLines({ Good }));
  CheckMiddle(check, "another input", scene.Render(), GetLit(AlongX));
  vtkWeakPointer<vtkPolyData> last = scene.Mapper->GetInput();
  scene.Mapper->RemoveAllInputs();
  check(!last, "an input that goes is let go");
  scene.Mapper->SetInputData(lines);
  CheckGrey(check, "the first input again", scene.Render(), 60, 100, GetLit(AlongX));
  lines->GetPoints()->SetPoint(0, 0.0, -0.8, 0.0);
  lines->GetPoints()->Modified();
  lines->Modified();
  CheckGrey(check, "moved points", scene.Render(), 100, 40, GetLit(AlongY));
  check(messages->IsQuiet(), "nothing is said about copies");
}
}

int TestIlluminatedLineMapperBadInput(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckGeometry(check, messages);
  CheckWrongArrays(check, messages);
  CheckBadValues(check, messages);
  CheckLights(check, messages);
  CheckCopies(check, messages);
  return check.GetResult();
}
