// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the values that the model keeps of the curves: scalars of points and cells in 8 bits over
 * their finite range, NaN apart, components and magnitudes, direct colours, radii, several inputs;
 * and what happens to arrays that do not fit.
 */

#include "VoxelLineTesting.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <functional>
#include <limits>

using namespace VoxelLineTesting;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Largest = std::numeric_limits<double>::max();

/// A line set, a voxelizer on it, and what it says.
struct Scene
{
  vtkSmartPointer<vtkPolyData> Lines;
  vtkNew<vtkLineVoxelizer> Voxelizer;
  vtkNew<MessageObserver> Observer;

  Scene()
    : Lines(MakeLines({ { { 0.0, 0.0, 0.0 }, { 0.5, 0.1, 0.0 }, { 1.0, 0.3, 0.2 } },
        { { 0.0, 0.9, 0.0 }, { 0.6, 0.6, 0.6 }, { 1.0, 0.8, 0.0 } } }))
  {
    this->Voxelizer->SetInputData(this->Lines);
    this->Voxelizer->SetResolution(16);
    this->Voxelizer->SetFaceBins(256);
  }

  vtkVoxelLineModel* Run() { return Update(this->Voxelizer, this->Observer); }

  bool Warns(const std::string& text)
  {
    return !this->Observer->GetError() && this->Observer->NumberOfWarnings == 1 &&
      this->Observer->WarningMessage.find(text) != std::string::npos;
  }

  /// Add an array with a value for each point, or each cell, and component.
  vtkSmartPointer<vtkDataArray> Add(vtkDataSetAttributes* data, vtkIdType size, int components,
    const std::function<double(vtkIdType, int)>& value, int type = VTK_DOUBLE)
  {
    vtkSmartPointer<vtkDataArray> array;
    array.TakeReference(vtkDataArray::CreateDataArray(type));
    array->SetName("Values");
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i, c, value(i, c));
      }
    }
    data->SetScalars(array);
    return array;
  }
};

double ValueOf(vtkVoxelLineModel* model, vtkIdType segment, int end)
{
  const int byte = model->GetAttributes()->GetTypedComponent(segment, end);
  const double* range = model->GetAttributeRange();
  if (model->GetHasNaNAttribute() && byte == 255)
  {
    return NaN;
  }
  return range[0] + byte / (model->GetHasNaNAttribute() ? 254.0 : 255.0) * (range[1] - range[0]);
}

double WorldX(vtkVoxelLineModel* model, const Point& local)
{
  return model->GetOrigin()[0] + local[0] * model->GetVoxelSize();
}

/// A scalar that is an affine function of x must be that everywhere on the lines.
void CheckAffine(
  Checks& check, vtkVoxelLineModel* model, double a, double b, const std::string& name)
{
  if (!check(model->GetAttributeKind() == vtkVoxelLineModel::Scalar && model->GetAttributes() &&
          model->GetAttributes()->GetNumberOfComponents() == 2,
        name + ": scalars"))
  {
    return;
  }
  const double step = (model->GetAttributeRange()[1] - model->GetAttributeRange()[0]) / 254.0;
  // Half a step of the bytes, and the error of the end points: half an interior bin.
  const double bound =
    0.5 * step + std::abs(b) * 0.5 * model->GetVoxelSize() / model->GetInteriorBins() + 1e-9;
  double largest = 0.0;
  for (const Segment& segment : DecodeModel(model))
  {
    largest = std::max(
      largest, std::abs(ValueOf(model, segment.Index, 0) - (a + b * WorldX(model, segment.Start))));
    largest = std::max(
      largest, std::abs(ValueOf(model, segment.Index, 1) - (a + b * WorldX(model, segment.End))));
  }
  check(largest <= bound,
    name + ": values within " + std::to_string(bound) + ", not " + std::to_string(largest));
}

void TestScalars(Checks& check)
{
  {
    Scene scene;
    vtkVoxelLineModel* model = scene.Run();
    check(model->GetAttributeKind() == vtkVoxelLineModel::NoAttribute && !model->GetAttributes(),
      "no array, no attributes");
  }
  Scene scene;
  vtkPolyData* lines = scene.Lines;
  const auto x = [lines](vtkIdType i, int) { return lines->GetPoint(i)[0]; };
  for (int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    scene.Add(
      lines->GetPointData(), 6, 1, [&](vtkIdType i, int c) { return 3.0 - 7.0 * x(i, c); }, type);
    CheckAffine(check, scene.Run(), 3.0, -7.0, "point scalars");
    check(!scene.Observer->GetWarning(), "point scalars: no complaint");
  }
  vtkVoxelLineModel* model = scene.Run();
  check(model->GetAttributeRange()[0] == -4.0 && model->GetAttributeRange()[1] == 3.0,
    "range of the scalars");

  scene.Voxelizer->GenerateAttributesOff();
  check(!scene.Run()->GetAttributes(), "attributes can be left out");
  scene.Voxelizer->GenerateAttributesOn();

  // Components and magnitude of vectors.
  scene.Add(lines->GetPointData(), 6, 3,
    [&](vtkIdType i, int c) { return c == 0 ? 3.0 * x(i, 0) : (c == 1 ? -4.0 * x(i, 0) : 0.0); });
  CheckAffine(check, scene.Run(), 0.0, 3.0, "component 0");
  scene.Voxelizer->SetAttributeComponent(1);
  CheckAffine(check, scene.Run(), 0.0, -4.0, "component 1");
  scene.Voxelizer->SetAttributeComponent(-1);
  CheckAffine(check, scene.Run(), 0.0, 5.0, "magnitude");
  scene.Voxelizer->SetAttributeComponent(7);
  model = scene.Run();
  check(scene.Warns("has 3 components, and AttributeComponent is 7"), "component 7 of 3: said");
  check(model->GetAttributeRange()[1] == 0.0, "component 7 of 3: the last one");
  check(model->GetAttributes()->GetValue(0) == 0 && ValueOf(model, 0, 0) == 0.0,
    "constant scalars: byte 0, and the value comes back");
  scene.Voxelizer->SetAttributeComponent(0);

  // By name, of points and cells.
  scene.Add(lines->GetPointData(), 6, 1, x)->SetName("X");
  scene.Add(lines->GetPointData(), 6, 1, [&](vtkIdType i, int c) { return 2.0 * x(i, c); });
  lines->GetPointData()->AddArray(scene.Add(lines->GetPointData(), 6, 1, x));
  vtkSmartPointer<vtkDataArray> named =
    scene.Add(lines->GetPointData(), 6, 1, [&](vtkIdType i, int c) { return 1.0 + x(i, c); });
  named->SetName("Named");
  scene.Add(lines->GetPointData(), 6, 1, x);
  lines->GetPointData()->AddArray(named);
  scene.Voxelizer->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Named");
  CheckAffine(check, scene.Run(), 1.0, 1.0, "by name");
  scene.Voxelizer->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Missing");
  check(!scene.Run()->GetAttributes() && scene.Warns("No input has an array named Missing"),
    "an array that is not there: said");
}

void TestCells(Checks& check)
{
  Scene scene;
  scene.Add(scene.Lines->GetCellData(), 2, 1, [](vtkIdType i, int) { return i == 0 ? -2.0 : 6.0; });
  vtkVoxelLineModel* model = scene.Run();
  bool isRight = model->GetAttributes() != nullptr;
  for (const Segment& segment : DecodeModel(model))
  {
    const double value = segment.Curve == 0 ? -2.0 : 6.0;
    isRight = isRight && ValueOf(model, segment.Index, 0) == value &&
      ValueOf(model, segment.Index, 1) == value;
  }
  check(isRight, "cell scalars: the same at both ends");
  check(!scene.Observer->GetWarning(), "cell scalars: no complaint");
}

void TestNaN(Checks& check)
{
  for (double bad : { NaN, std::numeric_limits<double>::infinity() })
  {
    Scene scene;
    // The middle point of the first line has no value: each half belongs to its nearer vertex.
    scene.Add(scene.Lines->GetPointData(), 6, 1,
      [bad](vtkIdType i, int) { return i == 1 ? bad : 10.0 + i; });
    vtkVoxelLineModel* model = scene.Run();
    check(model->GetHasNaNAttribute() && model->GetAttributeRange()[0] == 10.0 &&
        model->GetAttributeRange()[1] == 15.0,
      "NaN: finite range");
    int wrong = 0;
    int numberOfNaN = 0;
    for (const Segment& segment : DecodeModel(model))
    {
      for (int end = 0; end < 2; ++end)
      {
        const double value = ValueOf(model, segment.Index, end);
        const double where = WorldX(model, end == 0 ? segment.Start : segment.End);
        numberOfNaN += std::isnan(value);
        if (segment.Curve == 1)
        {
          wrong += std::isnan(value);
        }
        else if (std::abs(where - 0.25) > 0.01 && std::abs(where - 0.75) > 0.01)
        {
          const bool isNaNExpected = where > 0.25 && where < 0.75;
          wrong += std::isnan(value) != isNaNExpected;
          wrong +=
            !isNaNExpected && std::abs(value - (where < 0.5 ? 10.0 : 12.0)) > 0.5 * 5.0 / 254.0;
        }
      }
    }
    check(wrong == 0 && numberOfNaN > 5, "NaN: the nearer vertex has its way");
  }
  Scene scene;
  scene.Add(scene.Lines->GetPointData(), 6, 1, [](vtkIdType, int) { return NaN; });
  vtkVoxelLineModel* model = scene.Run();
  check(model->GetHasNaNAttribute() && model->GetAttributes()->GetValue(0) == 255 &&
      std::isfinite(model->GetAttributeRange()[0]) && std::isfinite(model->GetAttributeRange()[1]),
    "nothing but NaN");
  scene.Add(scene.Lines->GetPointData(), 6, 1,
    [](vtkIdType i, int) { return i % 3 == 0 ? -Largest : Largest; });
  model = scene.Run();
  int extremes = 0;
  for (vtkIdType i = 0; i < model->GetAttributes()->GetNumberOfValues(); ++i)
  {
    extremes +=
      model->GetAttributes()->GetValue(i) == 255 || model->GetAttributes()->GetValue(i) == 0;
  }
  check(!model->GetHasNaNAttribute() && extremes > 10 &&
      extremes < model->GetAttributes()->GetNumberOfValues(),
    "a range that overflows");
}

void TestColors(Checks& check)
{
  const double colors[2][4] = { { 10, 20, 30, 40 }, { 250, 130, 0, 255 } };
  for (int components = 1; components <= 4; ++components)
  {
    Scene scene;
    scene.Add(
      scene.Lines->GetCellData(), 2, components, [&](vtkIdType i, int c) { return colors[i][c]; },
      VTK_UNSIGNED_CHAR);
    vtkVoxelLineModel* model = scene.Run();
    const std::string name = std::to_string(components) + " colour components";
    if (!check(model->GetAttributeKind() == vtkVoxelLineModel::Color &&
            model->GetAttributes()->GetNumberOfComponents() == 8,
          name))
    {
      continue;
    }
    int wrong = 0;
    for (const Segment& segment : DecodeModel(model))
    {
      const double* c = colors[segment.Curve];
      const bool isGrey = components < 3;
      const double expected[4] = { c[0], isGrey ? c[0] : c[1], isGrey ? c[0] : c[2],
        components % 2 == 0 ? c[components - 1] : 255.0 };
      for (int i = 0; i < 8; ++i)
      {
        wrong += model->GetAttributes()->GetTypedComponent(segment.Index, i) != expected[i % 4];
      }
    }
    check(wrong == 0, name + ": each curve has its colour");
  }
  Scene scene;
  scene.Add(
    scene.Lines->GetPointData(), 6, 3, [](vtkIdType i, int c) { return 40.0 * i + c; },
    VTK_UNSIGNED_CHAR);
  scene.Voxelizer->DirectColorsOff();
  vtkVoxelLineModel* model = scene.Run();
  check(model->GetAttributeKind() == vtkVoxelLineModel::Scalar &&
      model->GetAttributeRange()[1] == 200.0,
    "colours as scalars");
}

void TestWrongLengths(Checks& check)
{
  {
    Scene scene;
    scene.Add(scene.Lines->GetPointData(), 4, 1, [](vtkIdType i, int) { return 1.0 * i; });
    vtkVoxelLineModel* model = scene.Run();
    check(scene.Warns("has 4 tuples where there are 6 points"), "wrong length: both named, once");
    check(!model->GetAttributes() && model->GetNumberOfCurves() == 2,
      "wrong length: the lines are there without values");
  }
  {
    Scene scene;
    scene.Add(scene.Lines->GetCellData(), 3, 1, [](vtkIdType i, int) { return 1.0 * i; });
    scene.Run();
    check(scene.Warns("has 3 tuples where there are 2 cells"), "wrong length of cell data");
  }
  {
    Scene scene;
    vtkNew<vtkStringArray> strings;
    strings->SetName("Strings");
    strings->SetNumberOfValues(6);
    scene.Lines->GetPointData()->AddArray(strings);
    scene.Voxelizer->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Strings");
    check(!scene.Run()->GetAttributes() && scene.Warns("named Strings"), "an array of strings");
  }
}

void TestRadii(Checks& check)
{
  Scene scene;
  vtkPolyData* lines = scene.Lines;
  vtkSmartPointer<vtkDataArray> radii = scene.Add(lines->GetPointData(), 6, 1,
    [lines](vtkIdType i, int) { return 0.2 + 0.6 * lines->GetPoint(i)[0]; });
  lines->GetPointData()->SetActiveScalars(nullptr);
  scene.Voxelizer->SetRadiusArrayName("Values");
  vtkVoxelLineModel* model = scene.Run();
  check(!scene.Observer->GetWarning(), "radii: no complaint");
  check(model->GetRadii() && model->GetMaximumRadius() == 0.8, "radii: largest");
  double largest = 0.0;
  for (const Segment& segment : DecodeModel(model))
  {
    for (int end = 0; end < 2; ++end)
    {
      const double radius = model->GetRadii()->GetTypedComponent(segment.Index, end) / 255.0 * 0.8;
      const double where = WorldX(model, end == 0 ? segment.Start : segment.End);
      largest = std::max(largest, std::abs(radius - (0.2 + 0.6 * where)));
    }
  }
  check(largest <= 0.5 * 0.8 / 255 + 0.6 * 0.5 * model->GetVoxelSize() / model->GetInteriorBins(),
    "radii: interpolated");

  radii->SetComponent(1, 0, -3.0);
  radii->SetComponent(2, 0, NaN);
  radii->SetComponent(3, 0, std::numeric_limits<double>::infinity());
  radii->Modified();
  model = scene.Run();
  check(scene.Warns("3 radii of array Values are negative or not finite"), "bad radii: said once");
  check(model->GetRadii() && model->GetMaximumRadius() == 0.8, "bad radii: the rest is used");
  for (const Segment& segment : Chain(DecodeModel(model), 0))
  {
    check(WorldX(model, segment.Start) < 0.55 ||
        model->GetRadii()->GetTypedComponent(segment.Index, 1) == 0,
      "bad radii: 0");
  }

  // Values in 8 bits of the largest: 0.5 / 255 of it is the smallest that is not lost.
  radii->Fill(0.5);
  radii->SetComponent(1, 0, 0.49 * 0.5 / 255);
  radii->SetComponent(2, 0, 0.51 * 0.5 / 255);
  radii->SetComponent(3, 0, 0.0);
  radii->Modified();
  scene.Run();
  check(scene.Warns("1 radii of array Values are above 0 but less than 1/510"), "lost in 8 bits");
  radii->Fill(0.5);
  radii->SetComponent(1, 0, 1e300);
  radii->SetComponent(4, 0, 4.1);
  radii->SetComponent(5, 0, 3.9);
  radii->Modified();
  model = scene.Run();
  check(scene.Warns("2 radii of array Values are more than 4 times"), "huge radii: said once");
  check(std::abs(model->GetMaximumRadius() - 4.0) < 1e-6, "huge radii: clamped");

  radii->Fill(0.0);
  radii->Modified();
  check(!scene.Run()->GetRadii() && scene.Warns("above 0"), "no radius above 0");
  radii->SetNumberOfTuples(5);
  radii->Modified();
  check(!scene.Run()->GetRadii() && scene.Warns("has 5 tuples where there are 6 points"),
    "radii of wrong length");
  scene.Voxelizer->SetRadiusArrayName("Missing");
  model = scene.Run();
  check(!model->GetRadii() && scene.Warns("Missing is not among the point data"), "missing radii");
  check(
    model->GetMaximumRadius() == 0.0 && model->GetNumberOfSegments() > 0, "lines without radii");
}

void TestSeveralInputs(Checks& check)
{
  // Values in the second and third input; the range is over both.
  Scene scene;
  vtkSmartPointer<vtkPolyData> inputs[2];
  for (int i = 0; i < 2; ++i)
  {
    inputs[i] = MakeLines(
      { { { 0.0, i + 0.2, 0.0 }, { 1.0, i + 0.2, 0.0 } } }, i == 0 ? VTK_FLOAT : VTK_DOUBLE);
    scene.Add(inputs[i]->GetPointData(), 2, 1, [i](vtkIdType j, int) { return 10.0 * i + j; });
    scene.Voxelizer->AddInputData(inputs[i]);
  }
  vtkVoxelLineModel* model = scene.Run();
  check(scene.Warns("1 of 3 inputs have no values"), "an input without values: said once");
  check(model->GetHasNaNAttribute() && model->GetAttributeRange()[0] == 0.0 &&
      model->GetAttributeRange()[1] == 11.0,
    "several inputs: one range");
  check(model->GetNumberOfCurves() == 4, "several inputs: all curves");
  const std::vector<Segment> segments = DecodeModel(model);
  for (vtkIdType curve = 0; curve < 4; ++curve)
  {
    const vtkIdType input = curve < 2 ? 0 : curve - 1;
    check(model->GetCurveCells()->GetComponent(curve, 0) == static_cast<double>(input) &&
        model->GetCurveCells()->GetComponent(curve, 1) == (curve == 1 ? 1.0 : 0.0),
      "several inputs: input and cell of each curve");
    const std::vector<Segment> chain = Chain(segments, curve);
    const double first = chain.empty() ? -1.0 : ValueOf(model, chain.front().Index, 0);
    const double last = chain.empty() ? -1.0 : ValueOf(model, chain.back().Index, 1);
    check(curve < 2 ? std::isnan(first) && std::isnan(last)
                    : std::abs(first - 10.0 * (curve - 2)) < 0.03 &&
          std::abs(last - (10.0 * (curve - 2) + 1.0)) < 0.03,
      "several inputs: values of each");
  }

  // An input without lines lacks nothing.
  scene.Voxelizer->RemoveAllInputs();
  vtkNew<vtkPolyData> empty;
  empty->SetLines(nullptr);
  scene.Voxelizer->AddInputData(empty);
  scene.Voxelizer->AddInputData(inputs[0]);
  scene.Voxelizer->SetRadiusArrayName("Values");
  model = scene.Run();
  check(!scene.Observer->GetWarning() && !model->GetHasNaNAttribute() && model->GetRadii() &&
      model->GetCurveCells()->GetComponent(0, 0) == 1.0,
    "an input without lines");
}

}

int TestLineVoxelizerAttributes(int, char*[])
{
  Checks check;
  TestScalars(check);
  TestCells(check);
  TestNaN(check);
  TestColors(check);
  TestWrongLengths(check);
  TestRadii(check);
  TestSeveralInputs(check);
  return check.GetResult();
}
