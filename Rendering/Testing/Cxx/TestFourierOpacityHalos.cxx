// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards halos of lines, pixel by pixel against their definition: a line that crosses behind
// another one is interrupted in the background's colour, the farther from the other one the farther
// behind it lies; halos have no importance; points and surfaces have none; for parallel and
// perspective views, thin and wide lines, opaque and transparent ones, blended by series or by
// lists, by the mapper and by the pass.

#include "FourierOpacityPassTesting.h"

using namespace FourierOpacityTesting;

namespace
{
constexpr int Size = 64;
constexpr int Blendings[] = { Optimization::Fourier, Optimization::FragmentLists };
const Point Behind{ Background[0], Background[1], Background[2] };
const Point Front{ 255.0, 255.0, 255.0 };
const Point Rear{ 250.0, 40.0, 10.0 };

/// A crossing: a line from below to above in front of one from left to right.
struct Crossing
{
  double LineWidth = 1.0;
  double HaloWidth = 6.0;
  double HaloDepth = 0.05;
  /// How far the rear one lies behind the front one, as a part of the range of depths.
  double Gap = 0.5;
  double Opacity = 1.0;
  bool IsPerspective = false;
  int Blending = Optimization::Fourier;

  std::string GetName() const
  {
    std::ostringstream name;
    name << MethodNames[this->Blending] << (this->IsPerspective ? ", perspective" : "") << ", line "
         << this->LineWidth << ", halo " << this->HaloWidth << " of depth " << this->HaloDepth
         << ", gap " << this->Gap << ", opacity " << this->Opacity;
    return name.str();
  }

  // Where something of a depth (0 to 1) is seen at (x, y).
  Point Place(double x, double y, double depth) const
  {
    const double scale = this->IsPerspective ? (10.0 - GetZ(depth)) / 10.0 : 1.0;
    return { x * scale, y * scale, GetZ(depth) };
  }

  vtkSmartPointer<vtkPolyData> MakeLines() const
  {
    // Through the middle of a pixel.
    const double c = 1.0 / Size;
    const double front = 0.2;
    const double rear = front + this->Gap;
    auto data = VoxelLineMapperTesting::MakeLines(
      { { this->Place(c, -0.8, front), this->Place(c, 0.8, front) },
        { this->Place(-0.8, c, rear), this->Place(0.8, c, rear) },
        // Outside of the view, at the ends of the depth.
        { this->Place(4.0, 0.0, 0.0), this->Place(4.0, 0.0, 1.0) } });
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (const Point& color : { Front, Rear, Rear })
    {
      colors->InsertNextTuple3(color[0], color[1], color[2]);
      colors->InsertNextTuple3(color[0], color[1], color[2]);
    }
    data->GetPointData()->SetScalars(colors);
    vtkNew<vtkFloatArray> importance;
    importance->SetName("Importance");
    importance->SetNumberOfValues(6);
    importance->Fill(0.0);
    data->GetPointData()->AddArray(importance);
    return data;
  }

  void Set(Stage& stage, vtkProperty* property, Optimization* by) const
  {
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetParallelProjection(!this->IsPerspective);
    if (this->IsPerspective)
    {
      camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(0.1)));
    }
    property->SetLineWidth(static_cast<float>(this->LineWidth));
    property->SetOpacity(this->Opacity);
    by->SetBlending(this->Blending);
    by->SetHaloWidth(this->HaloWidth);
    by->SetHaloDepth(this->HaloDepth);
  }

  /// What a pixel of the rear line shows, so many pixels from the middle of the front one.
  Point GetExpected(int distance) const
  {
    const auto mix = [this](const Point& a, const Point& b)
    {
      Point mixed;
      for (int k = 0; k < 3; ++k)
      {
        mixed[k] = this->Opacity * a[k] + (1.0 - this->Opacity) * b[k];
      }
      return mixed;
    };
    const double margin = std::abs(distance) - 0.5 * this->LineWidth;
    const Point rear = mix(Rear, Behind);
    if (margin < 0.0)
    {
      return mix(Front, rear);
    }
    if (margin > this->HaloWidth)
    {
      return rear;
    }
    const bool isBefore = this->HaloDepth * margin / this->HaloWidth < this->Gap;
    return isBefore ? mix(Behind, rear) : mix(Rear, Behind);
  }
};

void CheckRow(
  Checks& check, const std::string& name, const Crossing& crossing, const Picture& picture)
{
  // Series tell layers apart that are not too near; weights of opaque ones do not matter.
  const double tolerance =
    crossing.Opacity < 1.0 && crossing.Blending == Optimization::Fourier ? 30.0 : 2.0;
  for (int distance = -20; distance <= 20; ++distance)
  {
    CheckColor(check, name + ", at " + std::to_string(distance),
      picture.At(Size / 2 + distance, Size / 2), crossing.GetExpected(distance), tolerance);
  }
  // The front line is not interrupted by the halo of the rear one.
  for (int distance : { -20, -3, 3, 20 })
  {
    const Point through = picture.At(Size / 2, Size / 2 + distance)[0] > 0
      ? ToPoint(picture.At(Size / 2, Size / 2 + distance))
      : Point{};
    check(through[0] > (crossing.Opacity < 1.0 ? 60.0 : 250.0), name + ": the front line");
  }
}

void CheckCrossings(Checks& check)
{
  std::vector<Crossing> crossings;
  for (int blending : Blendings)
  {
    for (bool isPerspective : { false, true })
    {
      for (double line : { 1.0, 3.0 })
      {
        for (double gap : { 0.5, 0.03, 0.012 })
        {
          Crossing crossing;
          crossing.Blending = blending;
          crossing.IsPerspective = isPerspective;
          crossing.LineWidth = line;
          crossing.Gap = gap;
          crossings.push_back(crossing);
        }
      }
    }
    Crossing wide;
    wide.Blending = blending;
    wide.HaloWidth = 12.0;
    wide.HaloDepth = 1.0;
    crossings.push_back(wide);
    wide.HaloDepth = 0.0;
    wide.Gap = 0.01;
    crossings.push_back(wide);
    wide.HaloWidth = 1.75;
    crossings.push_back(wide);
    Crossing clear;
    clear.Blending = blending;
    clear.Opacity = 0.5;
    crossings.push_back(clear);
    clear.LineWidth = 3.0;
    crossings.push_back(clear);
  }
  OpacityStage stage(Size, Size);
  PassStage pass(Size, Size);
  for (const Crossing& crossing : crossings)
  {
    crossing.Set(stage, stage.Actor->GetProperty(), stage.GetOptimization());
    const Picture picture = stage.Render(crossing.MakeLines());
    CheckRow(check, crossing.GetName(), crossing, picture);

    pass.Renderer->RemoveAllViewProps();
    auto actor = pass.AddItem(crossing.MakeLines());
    crossing.Set(pass, actor->GetProperty(), pass.GetOptimization());
    CheckSame(check, crossing.GetName() + ": the pass", pass.Render(), picture, 1);
  }
}

// Without halos the picture is that of a mapper that never had any.
void CheckNone(Checks& check)
{
  for (double width : { 1.0, 3.0 })
  {
    Crossing crossing;
    crossing.LineWidth = width;
    crossing.HaloWidth = 0.0;
    OpacityStage never(Size, Size);
    crossing.Set(never, never.Actor->GetProperty(), never.GetOptimization());
    const Picture expected = never.Render(crossing.MakeLines());
    OpacityStage stage(Size, Size);
    crossing.HaloWidth = 6.0;
    crossing.Set(stage, stage.Actor->GetProperty(), stage.GetOptimization());
    const Picture with = stage.Render(crossing.MakeLines());
    check(Compare(with, expected).Largest > 100, "a halo is seen");
    stage.GetOptimization()->SetHaloWidth(0.0);
    CheckSame(check, "without the halo again", stage.Stage::Render(), expected);
    for (int distance = 3; distance < 20; ++distance)
    {
      CheckColor(check, "no halo", expected.At(Size / 2 + distance, Size / 2), Rear, 1.0);
    }
    stage.GetOptimization()->SetHaloWidth(6.0);
    CheckSame(check, "the halo again", stage.Stage::Render(), with);
  }
}

// Lists blend exactly; the series comes near.
void CheckMethods(Checks& check)
{
  Picture pictures[2];
  for (int i = 0; i < 2; ++i)
  {
    Stage stage(100, 100);
    vtkNew<vtkFourierOpacityMapper> mapper;
    mapper->SetInputData(MakeHelices(6, 200));
    mapper->SetImportanceArrayName("t");
    mapper->SetScalarRange(0.0, 1.0);
    mapper->GetOptimization()->SetBlending(Blendings[i]);
    mapper->GetOptimization()->SetHaloWidth(3.0);
    auto actor = stage.Add(mapper);
    actor->GetProperty()->SetLineWidth(2.0);
    stage.Renderer->GetActiveCamera()->SetPosition(4.0, 3.0, 3.5);
    stage.Renderer->ResetCamera();
    pictures[i] = stage.Render();
    mapper->GetOptimization()->SetHaloWidth(0.0);
    check(Compare(stage.Render(), pictures[i]).Rms > 5.0, "halos are seen in a scene");
  }
  const Difference difference = Compare(pictures[0], pictures[1]);
  check(difference.Rms < 8.0,
    "halos by series and by lists" + VoxelLineMapperTesting::Describe(difference));
}

// An important line: points before its halo stay opaque, one before the line itself fades.
void CheckImportance(Checks& check)
{
  const double c = 1.0 / Size;
  auto data = MakeLines({ { { c, -0.8, -0.5 }, { c, 0.8, -0.5 } } });
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  importance->InsertNextValue(1.0f);
  importance->InsertNextValue(1.0f);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->InsertNextTuple3(0, 0, 0);
  colors->InsertNextTuple3(0, 0, 0);
  for (int i = 0; i < 3; ++i)
  {
    vertices->InsertNextCell(
      { data->GetPoints()->InsertNextPoint(c + 2.0 * 5 * i / Size, c + 0.3 * i, 0.5) });
    importance->InsertNextValue(0.0f);
    colors->InsertNextTuple3(255, 255, 255);
  }
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(importance);
  data->GetPointData()->SetScalars(colors);
  OpacityStage stage(Size, Size);
  stage.GetOptimization()->SetHaloWidth(15.0);
  stage.GetOptimization()->SetImportanceReduction(1);
  const Picture picture = stage.Render(data);
  check(picture.At(32, 32)[0] < 10, "a point before the important line fades");
  for (int i : { 1, 2 })
  {
    const int y = static_cast<int>((1.0 + c + 0.3 * i) * Size / 2);
    check(picture.At(32 + 5 * i, y)[0] == 255,
      "a point before the halo is opaque: " + std::to_string(picture.At(32 + 5 * i, y)[0]));
  }
}

// What are no lines has no halos: points, surfaces, and lines that are drawn as points or tubes.
void CheckOthers(Checks& check)
{
  const Crossing crossing;
  for (int kind = 0; kind < 4; ++kind)
  {
    auto data = kind == 0 ? MakeScene() : crossing.MakeLines();
    if (kind == 1)
    {
      vtkNew<vtkCellArray> vertices;
      for (vtkIdType i = 0; i < 4; ++i)
      {
        vertices->InsertNextCell({ i });
      }
      data->SetLines(nullptr);
      data->SetVerts(vertices);
    }
    OpacityStage stage(Size, Size);
    vtkProperty* property = stage.Actor->GetProperty();
    property->SetPointSize(9.0);
    property->SetLineWidth(5.0);
    property->SetRepresentation(kind == 2 ? VTK_POINTS : VTK_SURFACE);
    property->SetRenderLinesAsTubes(kind == 3);
    const Picture expected = stage.Render(data);
    check(GetCoverage(expected, Background) > 0.02, "something is drawn");
    stage.GetOptimization()->SetHaloWidth(8.0);
    CheckSame(check, "no halo of kind " + std::to_string(kind), stage.Stage::Render(), expected);
  }
}

// A bent line has no gaps from its own halo, and halos of the background's colour as it is now.
void CheckBend(Checks& check)
{
  Curve curve;
  for (int i = 0; i <= 200; ++i)
  {
    const double angle = vtkMath::Pi() * i / 100.0;
    curve.push_back({ 0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.4 * std::sin(2.0 * angle) });
  }
  auto data = MakeLines({ curve });
  OpacityStage stage(Size, Size);
  stage.Actor->GetProperty()->SetLineWidth(3.0);
  stage.Mapper->SetImportanceArrayName("");
  vtkNew<vtkFloatArray> none;
  none->SetNumberOfValues(data->GetNumberOfPoints());
  none->Fill(0.0);
  data->GetPointData()->SetScalars(none);
  stage.Mapper->ScalarVisibilityOff();
  const Picture expected = stage.Render(data);
  stage.GetOptimization()->SetHaloWidth(5.0);
  const Picture with = stage.Stage::Render();
  int lost = 0;
  int drawn = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const bool isLine = expected.At(x, y)[0] > 200;
      drawn += isLine ? 1 : 0;
      lost += isLine && with.At(x, y)[0] < 200 ? 1 : 0;
    }
  }
  // Where pieces meet at an angle, pixels at the edge may change hands.
  check(drawn > 200 && lost <= drawn / 50,
    "pixels that a line loses to its own halo: " + std::to_string(lost) + " of " +
      std::to_string(drawn));

  const Crossing crossing;
  OpacityStage other(Size, Size);
  crossing.Set(other, other.Actor->GetProperty(), other.GetOptimization());
  other.Render(crossing.MakeLines());
  other.Renderer->SetBackground(0.0, 0.6, 0.2);
  CheckColor(check, "another background", other.Stage::Render().At(Size / 2 + 3, Size / 2),
    { 0.0, 153.0, 51.0 }, 1.0);
}
}

int TestFourierOpacityHalos(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  CheckCrossings(check);
  CheckNone(check);
  CheckMethods(check);
  CheckImportance(check);
  CheckOthers(check);
  CheckBend(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
