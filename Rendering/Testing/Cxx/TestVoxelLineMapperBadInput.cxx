// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that bad input neither crashes nor is lost in silence: the valid rest is drawn, what is
// left out is said once, and properties out of range are errors that keep the last valid value.

#include "VoxelLineMapperTesting.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkLineVoxelizer.h"
#include "vtkMath.h"
#include "vtkPlane.h"

#include <functional>
#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

const Curve Good{ { -1.0, -1.0, 0.0 }, { 0.0, 0.2, 0.3 }, { 1.0, 1.0, 0.0 } };

struct InputCase
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Lines;
  /// Part of the one warning that is said; empty: none.
  std::string Warning;
  bool IsDrawn = true;
};

vtkSmartPointer<vtkPolyData> MakeShifted(double shift)
{
  Curve curve = Good;
  for (Point& point : curve)
  {
    for (double& x : point)
    {
      x += shift;
    }
  }
  return MakeLines({ curve });
}

// The point ids of a curve's cell, one of which does not exist.
vtkSmartPointer<vtkPolyData> MakeInvalidIds()
{
  auto lines = MakeLines({ Good, Good });
  lines->GetLines()->ReplaceCellAtId(1, { 0, 1, 12345 });
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeVerticesOnly()
{
  auto lines = MakeLines({ Good });
  lines->SetVerts(lines->GetLines());
  lines->SetLines(nullptr);
  return lines;
}

vtkSmartPointer<vtkPolyData> MakeWithScalars(int numberOfValues, double value)
{
  auto lines = MakeLines({ Good });
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("s");
  scalars->SetNumberOfValues(numberOfValues);
  scalars->FillValue(static_cast<float>(value));
  lines->GetPointData()->SetScalars(scalars);
  return lines;
}

std::vector<InputCase> MakeCases()
{
  const double nan = vtkMath::Nan();
  return { { "good lines", MakeLines({ Good }), "", true },
    { "an empty polydata", vtkSmartPointer<vtkPolyData>::New(), "", false },
    { "points without cells", MakeLines({}), "", false },
    { "vertices, no lines", MakeVerticesOnly(), "no lines", false },
    { "a NaN among the points",
      MakeLines({ Good, { { 0.0, 0.0, 0.0 }, { nan, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }), "finite",
      true },
    { "an infinite point",
      MakeLines({ Good, { { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 }, { 0.0, -Infinity, 0.0 } } }),
      "finite", true },
    { "only NaN", MakeLines({ { { nan, nan, nan }, { nan, nan, nan } } }), "finite", false },
    { "a line of one point", MakeLines({ Good, { { 0.0, 0.0, 0.0 } } }), "point", true },
    { "a line of no point", MakeLines({ Good, {} }), "point", true },
    { "an id that does not exist", MakeInvalidIds(), "id", true },
    { "a line without length", MakeLines({ Good, { { 0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 } } }), "",
      true },
    { "nothing but a line without length", MakeLines({ { { 0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 } } }),
      "", true },
    { "repeated points",
      MakeLines({ { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }),
      "", true },
    { "a planar line", MakeLines({ { { -1.0, -1.0, 0.0 }, { 1.0, 1.0, 0.0 } } }), "", true },
    { "a line along an axis", MakeLines({ { { -1.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } }), "", true },
    { "coordinates near 1e9", MakeShifted(1e9), "", true },
    { "scalars too short", MakeWithScalars(2, 1.0), "2 tuples", true },
    { "scalars all NaN", MakeWithScalars(3, nan), "", true },
    { "scalars all equal", MakeWithScalars(3, 5.0), "", true } };
}

void CheckInputs(Checks& check, Messages* messages)
{
  for (const InputCase& test : MakeCases())
  {
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetInputData(test.Lines);
    Stage stage;
    auto actor = stage.Add(mapper);
    stage.AddSphere(0.0, 0.0, 0.0, 1e-3);
    if (test.IsDrawn)
    {
      stage.Renderer->ResetCamera(mapper->GetBounds());
      mapper->SetRadius(0.05 * actor->GetLength());
      if (mapper->GetRadius() == 0.0)
      {
        mapper->SetRadius(1.0);
        stage.Renderer->ResetCamera(mapper->GetBounds());
      }
    }
    else
    {
      stage.Renderer->ResetCamera(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
    }
    stage.Window->Render();
    const Picture picture = stage.Render();
    const double coverage = GetCoverage(picture, Background);
    check(test.IsDrawn ? coverage > 0.005 : coverage < 0.005,
      test.Name + ": covers " + std::to_string(coverage));
    if (!test.Warning.empty())
    {
      check(messages->TakeWarnings(test.Warning) == 1, test.Name + ": one warning");
    }
    check(messages->IsQuiet(), test.Name + ": nothing else is said");
  }
}

// No input, the wrong input, no renderer's camera reset on it.
void CheckNoInput(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  Stage stage;
  stage.Add(mapper);
  // VTK's cullers leave out actors without bounds.
  stage.Renderer->GetCullers()->RemoveAllItems();
  stage.Render();
  stage.Render();
  check(messages->TakeErrors("no input") == 1, "one error about no input");
  check(mapper->GetModel() == nullptr && !vtkMath::AreBoundsInitialized(mapper->GetBounds()),
    "no model and no bounds without input");
  mapper->SetInputData(MakeLines({ Good }));
  stage.Renderer->ResetCamera();
  check(GetCoverage(stage.Render(), Background) > 1e-4, "drawn when the input comes");
  mapper->SetInputConnection(nullptr);
  stage.Render();
  check(messages->TakeErrors("no input") == 1, "one error when the input goes");
  vtkNew<vtkVoxelLineModel> empty;
  mapper->SetInputData(empty);
  stage.Render();
  check(messages->IsQuiet(), "an empty model is nothing to speak of");
}

void CheckProperties(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetRadius(0.5);
  mapper->SetResolution(100);
  mapper->SetFaceBins(64);
  mapper->SetInteriorTolerance(0.25);
  mapper->SetEarlyTermination(0.5);
  mapper->SetEngine(vtkVoxelLineMapper::Native);
  const double nan = vtkMath::Nan();
  const std::vector<std::pair<std::string, std::function<void()>>> wrong = {
    { "Radius", [&] { mapper->SetRadius(-1.0); } }, { "Radius", [&] { mapper->SetRadius(nan); } },
    { "Radius", [&] { mapper->SetRadius(Infinity); } },
    { "Resolution", [&] { mapper->SetResolution(0); } },
    { "Resolution", [&] { mapper->SetResolution(-5); } },
    { "Resolution", [&] { mapper->SetResolution(1 << 20); } },
    { "FaceBins", [&] { mapper->SetFaceBins(1); } },
    { "FaceBins", [&] { mapper->SetFaceBins(33); } },
    { "FaceBins", [&] { mapper->SetFaceBins(-2); } },
    { "FaceBins", [&] { mapper->SetFaceBins(4096); } },
    { "InteriorTolerance", [&] { mapper->SetInteriorTolerance(-0.1); } },
    { "InteriorTolerance", [&] { mapper->SetInteriorTolerance(nan); } },
    { "EarlyTermination", [&] { mapper->SetEarlyTermination(1.01); } },
    { "EarlyTermination", [&] { mapper->SetEarlyTermination(-0.01); } },
    { "EarlyTermination", [&] { mapper->SetEarlyTermination(nan); } },
    { "Engine", [&] { mapper->SetEngine(3); } }, { "Engine", [&] { mapper->SetEngine(-1); } }
  };
  const vtkMTimeType time = mapper->GetMTime();
  for (const auto& [name, set] : wrong)
  {
    set();
    check(messages->TakeErrors(name) == 1, "an error about " + name);
  }
  check(mapper->GetRadius() == 0.5 && mapper->GetResolution() == 100 &&
      mapper->GetFaceBins() == 64 && mapper->GetInteriorTolerance() == 0.25 &&
      mapper->GetEarlyTermination() == 0.5 && mapper->GetEngine() == vtkVoxelLineMapper::Native &&
      mapper->GetMTime() == time,
    "the last valid values stay");
  check(messages->IsQuiet(), "nothing else is said");
  mapper->SetInteriorTolerance(Infinity);
  check(mapper->GetInteriorTolerance() == Infinity && messages->IsQuiet(),
    "an infinite InteriorTolerance keeps no point inside voxels");

  // 0 is an automatic radius: 1/512 of the longest side.
  mapper->SetInputData(MakeLines({ { { 0.0, 0.0, 0.0 }, { 20.48, 0.0, 1.0 } } }));
  mapper->SetRadius(0.0);
  check(std::abs(mapper->GetRadiusInUse() - 0.04) < 1e-12, "the automatic radius");
}

// A radius far beyond the lines: drawn, told once, and no crash.
void CheckHugeRadius(Checks& check, Messages* messages)
{
  for (double radius : { 100.0, 1e9, 1e30, 1e300 })
  {
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetInputData(MakeLines({ { { -0.5, 0.0, 0.0 }, { 0.5, 0.0, 0.0 } } }));
    mapper->SetResolution(8);
    mapper->SetRadius(radius);
    mapper->SetEngineToNative();
    Stage stage(32, 24);
    stage.Add(mapper);
    // On the lines: a camera that is to show 1e300 has no finite matrix.
    stage.Renderer->ResetCamera(-0.5, 0.5, -0.5, 0.5, -0.5, 0.5);
    stage.Window->Render();
    stage.Window->Render();
    check(messages->TakeWarnings("times the size of all lines") == 1, "a huge radius is told once");
  }
  check(messages->IsQuiet(), "nothing else is said");
}

// Radii per point: used, missing, not usable.
void CheckRadii(Checks& check, Messages* messages)
{
  auto lines = MakeLines({ { { -1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } });
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("r");
  for (double r : { 0.1, 0.2, 0.3 })
  {
    radii->InsertNextValue(r);
  }
  lines->GetPointData()->AddArray(radii);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(lines);
  mapper->SetResolution(32);
  mapper->SetRadius(0.01);
  mapper->SetRadiusArrayName("r");
  Stage stage(200, 200);
  stage.Add(mapper);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetPosition(0.0, 0.0, 10.0);
  camera->SetClippingRange(1.0, 20.0);
  const Picture picture = stage.Render();
  const int expected[][2] = { { 25, 12 }, { 100, 20 }, { 175, 27 } };
  for (const auto& [x, radius] : expected)
  {
    int height = 0;
    for (int y = 0; y < 200; ++y)
    {
      height += picture.At(x, y) != Background ? 1 : 0;
    }
    check(std::abs(height - 2 * radius) <= 3,
      "radius at " + std::to_string(x) + ": " + std::to_string(0.5 * height));
  }
  check(std::abs(mapper->GetRadiusInUse() - 0.3) < 1e-6, "the largest radius is told");
  check(messages->IsQuiet(), "nothing said about good radii");

  mapper->SetRadiusArrayName("missing");
  check(GetCoverage(stage.Render(), Background) < 0.05, "the mapper's radius instead");
  stage.Render();
  check(messages->TakeWarnings("missing") == 1, "one warning about missing radii");
}

// What was made of lines goes with them, except for whom GetModel() gave it.
void CheckInputGoes(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineModel> empty;
  for (vtkVoxelLineModel* next : { static_cast<vtkVoxelLineModel*>(nullptr), empty.Get() })
  {
    auto lines = MakeLines({ Good });
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetInputData(lines);
    const vtkSmartPointer<vtkVoxelLineModel> model = mapper->GetModel();
    vtkPoints* points = lines->GetPoints();
    check(points->GetReferenceCount() == 2, "lines and mapper hold the points");
    mapper->SetInputData(next);
    check(mapper->GetModel() == next, "the new input is the model");
    check(points->GetReferenceCount() == 1, "the mapper lets the points go");
    check(model->GetReferenceCount() == 1 && model->GetNumberOfSegments() > 0,
      "the mapper lets the model go, as it is");
    mapper->SetInputData(lines);
    check(mapper->GetModel() && mapper->GetModel()->GetNumberOfSegments() > 0, "lines again");
  }
  check(messages->IsQuiet(), "nothing is said");
}

// A shared model that lacks an array: an error, and nothing but the rest is drawn.
void CheckDefectiveModel(Checks& check, Messages* messages)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(MakeLines({ Good }));
  voxelizer->Update();
  vtkVoxelLineModel* model = voxelizer->GetOutput();
  const vtkSmartPointer<vtkDataArray> grid = model->GetBrickGrid();
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(model);
  mapper->SetRadius(0.1);
  Stage stage;
  stage.Add(mapper);
  stage.Renderer->ResetCamera();
  for (int engine : { vtkVoxelLineMapper::Native, vtkVoxelLineMapper::Shader })
  {
    mapper->SetEngine(engine);
    model->SetBrickGrid(nullptr);
    check(GetCoverage(stage.Render(), Background) == 0.0, "a model without its grid is not drawn");
    stage.Render();
    check(messages->TakeErrors("BrickGrid is missing") == 1, "one error about the missing grid");
    model->SetBrickGrid(grid);
    check(GetCoverage(stage.Render(), Background) > 0.01, "drawn when the grid comes");
  }
  check(messages->IsQuiet(), "nothing but the missing grid is said");
}

// Matrices that nothing can be seen by; clipping planes that leave nothing.
void CheckScene(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeLines({ Good }));
  mapper->SetRadius(0.1);
  Stage stage;
  auto actor = stage.Add(mapper);
  auto sphere = stage.AddSphere(-0.8, 0.8, 0.0, 0.2);
  stage.Renderer->ResetCamera();
  const double whole = GetCoverage(stage.Render(), Background);
  sphere->VisibilityOff();
  const double lines = GetCoverage(stage.Render(), Background);
  sphere->VisibilityOn();
  check(lines > 0.01 && whole > lines, "both are seen");
  actor->SetScale(1.0, 0.0, 1.0);
  const double rest = GetCoverage(stage.Render(), Background);
  stage.Render();
  check(std::abs(rest - (whole - lines)) < 0.01, "the rest of the scene is drawn");
  check(messages->TakeErrors("cannot be inverted") == 1, "one error about the actor's matrix");
  actor->SetScale(1.0);
  check(GetCoverage(stage.Render(), Background) == whole, "drawn again");

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 100.0);
  mapper->AddClippingPlane(plane);
  check(
    std::abs(GetCoverage(stage.Render(), Background) - (whole - lines)) < 0.01, "all is clipped");
  check(messages->IsQuiet(), "nothing else is said");
}

// vtkProperty lets an exponent through that is not a number.
void CheckExponent(Checks& check, Messages* messages)
{
  Stage stage(80, 80);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(3, 100));
  mapper->SetRadius(0.05);
  auto actor = stage.Add(mapper);
  actor->GetProperty()->SetSpecular(0.5);
  actor->GetProperty()->SetSpecularPower(std::numeric_limits<double>::quiet_NaN());
  const Picture picture = stage.Render();
  stage.Render();
  check(messages->TakeWarnings("SpecularPower") == 1, "an exponent that is NaN is told once");
  actor->GetProperty()->SetSpecularPower(1.0);
  check(Compare(picture, stage.Render()).Largest == 0, "an exponent that is NaN is taken for 1");
  check(GetCoverage(picture, Background) > 0.05, "something is drawn");
}

// Very many lines in a picture of few pixels.
void CheckHugePixels(Checks& check, Messages* messages)
{
  Stage stage(8, 8);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(400, 2000));
  mapper->SetRadius(0.0005);
  stage.Add(mapper);
  stage.Render();
  stage.Render();
  check(
    messages->TakeWarnings("Pixels are more than") == 1, "pixels beyond the limit are told once");
  mapper->SetResolution(16);
  stage.Render();
  check(messages->IsQuiet(), "a lower resolution has no such limit");
}
}

int TestVoxelLineMapperBadInput(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckInputs(check, messages);
  CheckNoInput(check, messages);
  CheckProperties(check, messages);
  CheckHugeRadius(check, messages);
  CheckRadii(check, messages);
  CheckInputGoes(check, messages);
  CheckDefectiveModel(check, messages);
  CheckScene(check, messages);
  CheckExponent(check, messages);
  CheckHugePixels(check, messages);
  return check.GetResult();
}
