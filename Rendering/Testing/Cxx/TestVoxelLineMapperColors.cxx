// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkMapper's rules of colour: which array and component colour the lines, lookup tables of
// all kinds, direct colours, what is opaque; and that a change of table, property or camera builds
// no new model. Lines lie along x, unlit, and pixels on them are held against the lookup table
// itself.

#include "VoxelLineMapperTesting.h"
#include "vtkColorTransferFunction.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkStringArray.h"

using namespace VoxelLineMapperTesting;

namespace
{
constexpr int NumberOfBars = 4;
constexpr int PointsPerBar = 5;

// Bars along x from -1 to 1, at y = -0.75, -0.25, 0.25, 0.75.
vtkSmartPointer<vtkPolyData> MakeBars()
{
  std::vector<Curve> curves;
  for (int i = 0; i < NumberOfBars; ++i)
  {
    Curve curve;
    for (int k = 0; k < PointsPerBar; ++k)
    {
      curve.push_back({ -1.0 + 0.5 * k, -0.75 + 0.5 * i, 0.0 });
    }
    curves.push_back(curve);
  }
  return MakeLines(curves);
}

/// One mapper on the bars, seen from the front.
struct BarStage : public Stage
{
  vtkNew<vtkVoxelLineMapper> Mapper;
  vtkSmartPointer<vtkPolyData> Lines = MakeBars();
  vtkSmartPointer<vtkActor> Actor;

  BarStage()
    : Stage(200, 200)
  {
    this->Mapper->SetInputData(this->Lines);
    this->Mapper->SetRadius(0.08);
    this->Mapper->SetResolution(32);
    this->Actor = this->Add(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.0, 0.0, 10.0);
    camera->SetClippingRange(1.0, 20.0);
  }

  /// Colour of a bar at x, by rendering.
  std::array<int, 3> Sample(int bar, double x)
  {
    const Picture picture = this->Render();
    return picture.At(static_cast<int>(100.0 + 100.0 * x), 25 + 50 * bar);
  }
};

std::array<int, 3> Map(vtkScalarsToColors* table, double value)
{
  const unsigned char* color = table->MapValue(value);
  return { color[0], color[1], color[2] };
}

// A point array whose values are those of a function of bar and position.
template <typename ArrayT, typename Function>
vtkSmartPointer<ArrayT> MakePointArray(const char* name, int components, const Function& function)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(NumberOfBars * PointsPerBar);
  for (int i = 0; i < NumberOfBars; ++i)
  {
    for (int k = 0; k < PointsPerBar; ++k)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i * PointsPerBar + k, c, function(i, -1.0 + 0.5 * k, c));
      }
    }
  }
  return array;
}

void CheckLookupTables(Checks& check)
{
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkDoubleArray>(
    "s", 1, [](int i, double x, int) { return i == 3 ? 7.0 : 2.0 + x; }));

  // ScalarRange.
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.0, 0.6);
  table->Build();
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->SetScalarRange(1.0, 3.0);
  auto color = stage.Sample(0, 0.4);
  table->SetRange(1.0, 3.0);
  check(IsNear(color, Map(table, 2.4), 6), "scalars" + Describe(color));
  vtkVoxelLineModel* model = stage.Mapper->GetModel();
  const vtkMTimeType built = model->GetMTime();

  // Another table, another range, the table's own range, opacity, camera, property: no new model.
  vtkNew<vtkLookupTable> gray;
  gray->SetSaturationRange(0.0, 0.0);
  gray->SetValueRange(0.0, 1.0);
  gray->SetRange(0.0, 4.0);
  gray->Build();
  stage.Mapper->SetLookupTable(gray);
  stage.Mapper->UseLookupTableScalarRangeOn();
  color = stage.Sample(1, -0.4);
  check(IsNear(color, Map(gray, 1.6), 6), "the table's own range" + Describe(color));
  gray->SetRange(1.0, 2.0);
  gray->UseAboveRangeColorOn();
  gray->SetAboveRangeColor(1.0, 0.5, 0.0, 1.0);
  gray->UseBelowRangeColorOn();
  gray->SetBelowRangeColor(0.0, 0.5, 1.0, 1.0);
  color = stage.Sample(0, 0.5);
  check(IsNear(color, { 255, 128, 0 }, 2), "above the range" + Describe(color));
  gray->SetRange(2.5, 3.0);
  color = stage.Sample(0, -0.5);
  check(IsNear(color, { 0, 128, 255 }, 2), "below the range" + Describe(color));
  gray->SetScaleToLog10();
  gray->SetRange(1.0, 10.0);
  color = stage.Sample(3, 0.0);
  check(IsNear(color, Map(gray, 7.0), 4), "logarithmic" + Describe(color));

  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(1.0, 1.0, 0.0, 0.0);
  function->AddRGBPoint(3.0, 0.0, 0.0, 1.0);
  stage.Mapper->SetLookupTable(function);
  color = stage.Sample(2, 0.5);
  check(IsNear(color, Map(function, 2.5), 4), "a colour transfer function" + Describe(color));

  stage.Actor->GetProperty()->SetOpacity(0.5);
  color = stage.Sample(2, 0.5);
  check(IsNear(color, { 45, 26, 146 }, 4), "opacity of the property" + Describe(color));
  stage.Actor->GetProperty()->SetOpacity(1.0);
  stage.Mapper->ScalarVisibilityOff();
  color = stage.Sample(2, 0.5);
  check(IsNear(color, { 0, 255, 0 }, 2), "no scalars" + Describe(color));
  stage.Mapper->ScalarVisibilityOn();
  color = stage.Sample(2, 0.5);
  check(IsNear(color, Map(function, 2.5), 4), "scalars again" + Describe(color));
  stage.Mapper->SetRadius(0.1);
  stage.Actor->RotateZ(1.0);
  stage.Render();
  check(stage.Mapper->GetModel() == model && model->GetMTime() == built,
    "table, range, opacity, visibility of scalars, radius and actor build no new model");
}

void CheckNaN(Checks& check)
{
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkFloatArray>(
    "s", 1, [](int i, double x, int) { return i == 1 ? vtkMath::Nan() : x; }));
  vtkNew<vtkLookupTable> table;
  table->SetRange(-1.0, 1.0);
  table->SetNanColor(1.0, 0.0, 1.0, 1.0);
  table->Build();
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->UseLookupTableScalarRangeOn();
  auto color = stage.Sample(1, 0.25);
  check(IsNear(color, { 255, 0, 255 }, 2), "NaN" + Describe(color));
  color = stage.Sample(0, 0.25);
  check(IsNear(color, Map(table, 0.25), 6), "beside NaN" + Describe(color));
  check(!stage.Mapper->HasTranslucentPolygonalGeometry(), "an opaque table is opaque");
  table->SetNanColor(1.0, 0.0, 1.0, 0.5);
  check(stage.Mapper->HasTranslucentPolygonalGeometry(), "a translucent colour of NaN is seen");
}

void CheckOpacityOfTable(Checks& check)
{
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkFloatArray>(
    "s", 1, [](int i, double, int) { return static_cast<double>(i); }));
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(4);
  table->SetRange(0.0, 3.0);
  for (int i = 0; i < 4; ++i)
  {
    table->SetTableValue(i, 1.0, 1.0, 1.0, 0.25 * (i + 1));
  }
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->UseLookupTableScalarRangeOn();
  check(stage.Mapper->HasTranslucentPolygonalGeometry(), "the table is translucent");
  for (int i = 0; i < 4; ++i)
  {
    const auto color = stage.Sample(i, 0.0);
    const double a = 0.25 * (i + 1);
    const std::array<int, 3> expected{ static_cast<int>(a * 255 + (1 - a) * Background[0]),
      static_cast<int>(a * 255 + (1 - a) * Background[1]),
      static_cast<int>(a * 255 + (1 - a) * Background[2]) };
    check(IsNear(color, expected, 3), "opacity from the table" + Describe(color));
  }
}

void CheckIndexedTable(Checks& check)
{
  BarStage stage;
  // Categories that no byte stands for exactly.
  const double values[] = { 0.0, 1.0, 3.0, 7.0 };
  stage.Lines->GetPointData()->SetScalars(
    MakePointArray<vtkDoubleArray>("s", 1, [&values](int i, double, int) { return values[i]; }));
  vtkNew<vtkLookupTable> table;
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(4);
  const double colors[4][3] = { { 1, 0, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 1, 1, 1 } };
  for (int i = 0; i < 4; ++i)
  {
    table->SetAnnotation(vtkVariant(values[i]), std::to_string(i));
    table->SetTableValue(i, colors[i][0], colors[i][1], colors[i][2], 1.0);
  }
  stage.Mapper->SetLookupTable(table);
  for (int i = 0; i < 4; ++i)
  {
    const auto color = stage.Sample(i, 0.0);
    const std::array<int, 3> expected{ static_cast<int>(255 * colors[i][0]),
      static_cast<int>(255 * colors[i][1]), static_cast<int>(255 * colors[i][2]) };
    check(IsNear(color, expected, 1), "category " + std::to_string(i) + Describe(color));
  }
}

void CheckVectors(Checks& check)
{
  BarStage stage;
  stage.Lines->GetPointData()->AddArray(MakePointArray<vtkDoubleArray>("v", 3,
    [](int i, double x, int c) { return c == 0 ? 3.0 * x : (c == 1 ? 4.0 * x : 1.0 + i); }));
  stage.Mapper->SetScalarModeToUsePointFieldData();
  stage.Mapper->SelectColorArray("v");
  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.0, 0.6);
  table->SetRange(0.0, 7.0);
  table->Build();
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->UseLookupTableScalarRangeOn();

  table->SetVectorModeToComponent();
  table->SetVectorComponent(2);
  auto color = stage.Sample(3, 0.2);
  check(IsNear(color, Map(table, 4.0), 6), "component 2" + Describe(color));
  table->SetVectorComponent(1);
  color = stage.Sample(3, 0.5);
  check(IsNear(color, Map(table, 2.0), 6), "component 1" + Describe(color));
  table->SetVectorModeToMagnitude();
  color = stage.Sample(3, 0.5);
  check(IsNear(color, Map(table, std::sqrt(6.25 + 16.0)), 6), "magnitude" + Describe(color));
  table->SetVectorComponent(0);
  table->SetVectorSize(2);
  color = stage.Sample(3, 0.5);
  check(IsNear(color, Map(table, 2.5), 6), "magnitude of two" + Describe(color));
  stage.Mapper->ColorByArrayComponent("v", 2);
  color = stage.Sample(1, 0.5);
  check(IsNear(color, Map(table, 2.0), 6), "component of the mapper" + Describe(color));
}

void CheckDirectColors(Checks& check)
{
  const std::array<int, 3> expected[] = { { 100, 100, 100 }, { 100, 100, 100 }, { 100, 150, 200 },
    { 100, 150, 200 } };
  for (int components = 1; components <= 4; ++components)
  {
    BarStage stage;
    stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkUnsignedCharArray>("c", components,
      [components](int, double, int c)
      { return components == 2 && c == 1 ? 255 : (c == 3 ? 255 : 100 + 50 * c); }));
    auto color = stage.Sample(2, 0.3);
    check(IsNear(color, expected[components - 1], 1),
      "direct colours of " + std::to_string(components) + " components" + Describe(color));
    check(!stage.Mapper->HasTranslucentPolygonalGeometry(), "direct colours are opaque");
    stage.Mapper->SetColorModeToMapScalars();
    stage.Mapper->SetScalarRange(0.0, 255.0);
    color = stage.Sample(2, 0.3);
    check(!IsNear(color, expected[components - 1], 10), "mapped instead" + Describe(color));
  }

  // Opacity of its own, and along the line.
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkUnsignedCharArray>(
    "c", 4, [](int, double x, int c) { return c == 3 ? 128 : (c == 0 ? 127.0 * (1.0 + x) : 0); }));
  check(stage.Mapper->HasTranslucentPolygonalGeometry(), "direct colours are translucent");
  auto color = stage.Sample(1, 0.5);
  check(IsNear(color, { 108, 25, 51 }, 4), "translucent direct colour" + Describe(color));

  // Floating point colours, per cell.
  vtkNew<vtkFloatArray> cells;
  cells->SetName("cells");
  cells->SetNumberOfComponents(3);
  for (int i = 0; i < NumberOfBars; ++i)
  {
    cells->InsertNextTuple3(0.25 * i, 1.0, 0.0);
  }
  stage.Lines->GetCellData()->AddArray(cells);
  stage.Mapper->SetScalarModeToUseCellFieldData();
  stage.Mapper->SelectColorArray("cells");
  stage.Mapper->SetColorModeToDirectScalars();
  color = stage.Sample(2, 0.0);
  check(IsNear(color, { 127, 255, 0 }, 2), "floating point colours" + Describe(color));
}

// A table's factor of opacity counts for neither kind; the range of a table that makes colours of
// vectors does.
void CheckTableOfDirectColors(Checks& check)
{
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkUnsignedCharArray>(
    "c", 3, [](int, double, int c) { return c == 0 ? 255 : 0; }));
  vtkNew<vtkLookupTable> table;
  table->SetAlpha(0.3);
  table->SetRange(0.0, 1.0);
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->UseLookupTableScalarRangeOn();
  auto color = stage.Sample(1, 0.2);
  check(
    IsNear(color, { 255, 0, 0 }, 1), "direct colours without the table's alpha" + Describe(color));
  check(!stage.Mapper->HasTranslucentPolygonalGeometry() && table->GetAlpha() == 0.3,
    "opaque, and the table as it was");

  stage.Lines->GetPointData()->SetScalars(
    MakePointArray<vtkDoubleArray>("v", 3, [](int, double, int c) { return c == 1 ? 1.0 : 0.5; }));
  table->SetVectorModeToRGBColors();
  stage.Mapper->SetArrayComponent(-1);
  color = stage.Sample(1, 0.2);
  check(IsNear(color, { 127, 255, 127 }, 2), "colours of vectors" + Describe(color));
  vtkVoxelLineModel* model = stage.Mapper->GetModel();
  const vtkMTimeType built = model->GetMTime();
  stage.Render();
  check(model->GetMTime() == built, "the same table builds no new model");
  table->SetRange(0.0, 2.0);
  color = stage.Sample(1, 0.2);
  check(IsNear(color, { 63, 127, 63 }, 2), "another range of the table" + Describe(color));
}

// 8 bits of a scalar show where a table spreads a small part of the range: said once per model.
void CheckSteps(Checks& check, Messages* messages)
{
  BarStage stage;
  stage.Lines->GetPointData()->SetScalars(MakePointArray<vtkDoubleArray>(
    "s", 1, [](int i, double, int) { return i == 3 ? 1000.0 : 1.0 + i; }));
  vtkNew<vtkLookupTable> table;
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->UseLookupTableScalarRangeOn();
  check(messages->IsQuiet(), "nothing said so far");
  table->SetRange(0.0, 70.0);
  stage.Render();
  check(messages->IsQuiet(), "a 14th of the range is enough");
  table->SetRange(0.0, 50.0);
  stage.Render();
  table->SetRange(0.0, 40.0);
  stage.Render();
  check(messages->TakeWarnings(
          "1 to 1000, and the lookup table spreads a small part of it, 0 to 50") == 1,
    "one warning about a 20th of the range");
  stage.Lines->GetPointData()->GetScalars()->Modified();
  stage.Lines->Modified();
  table->SetRange(10.0, 1000.0);
  table->SetScaleToLog10();
  stage.Render();
  check(messages->IsQuiet(), "two decades are enough");
  table->SetRange(1.0, 1000.0);
  stage.Render();
  stage.Render();
  check(messages->TakeWarnings("logarithmically over 1 to 1000") == 1,
    "one warning about three decades");
}

void CheckCellScalars(Checks& check)
{
  BarStage stage;
  vtkNew<vtkFloatArray> cells;
  cells->SetName("cells");
  for (int i = 0; i < NumberOfBars; ++i)
  {
    cells->InsertNextValue(static_cast<float>(i));
  }
  stage.Lines->GetCellData()->SetScalars(cells);
  stage.Mapper->SetScalarRange(0.0, 3.0);
  vtkScalarsToColors* table = stage.Mapper->GetLookupTable();
  for (int i = 0; i < NumberOfBars; ++i)
  {
    const auto color = stage.Sample(i, 0.1);
    check(IsNear(color, Map(table, i), 6), "scalars of cells" + Describe(color));
  }
  // An array's own table becomes the mapper's.
  vtkNew<vtkLookupTable> own;
  own->SetHueRange(0.1, 0.2);
  own->Build();
  cells->SetLookupTable(own);
  cells->Modified();
  const auto color = stage.Sample(3, 0.1);
  own->SetRange(0.0, 3.0);
  check(stage.Mapper->GetLookupTable() == own && IsNear(color, Map(own, 3.0), 6),
    "the array's own table" + Describe(color));
}

void CheckArraysThatDoNotFit(Checks& check, Messages* messages)
{
  const std::array<int, 3> green{ 0, 255, 0 };
  check(messages->IsQuiet(), "nothing said so far");
  BarStage stage;
  vtkNew<vtkFloatArray> tooShort;
  tooShort->SetName("short");
  tooShort->SetNumberOfValues(3);
  tooShort->FillValue(1.0f);
  stage.Lines->GetPointData()->AddArray(tooShort);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(NumberOfBars * PointsPerBar);
  stage.Lines->GetPointData()->AddArray(words);
  stage.Mapper->SetScalarModeToUsePointFieldData();
  const std::pair<const char*, const char*> cases[] = { { "short", "3 tuples" },
    { "missing", "no array named" }, { "words", "does not hold numbers" } };
  for (const auto& [name, text] : cases)
  {
    stage.Mapper->SelectColorArray(name);
    const auto color = stage.Sample(1, 0.2);
    stage.Render();
    check(IsNear(color, green, 2), std::string(name) + ": the property's colour" + Describe(color));
    check(messages->TakeWarnings(text) == 1, std::string(name) + ": one warning");
  }
  check(messages->IsQuiet(), "no errors");
}
}

int TestVoxelLineMapperColors(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckLookupTables(check);
  CheckNaN(check);
  CheckOpacityOfTable(check);
  CheckIndexedTable(check);
  CheckVectors(check);
  CheckDirectColors(check);
  CheckTableOfDirectColors(check);
  CheckSteps(check, messages);
  CheckCellScalars(check);
  CheckArraysThatDoNotFit(check, messages);
  return check.GetResult();
}
