// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that vtkFourierOpacityPass fades and blends several actors together: an actor's opacity
// follows Eq. 2 from the importance of another one, of points, lines and surfaces; squares of
// several actors, interleaved, are the same picture as those of one and as blending on the CPU;
// with opaque actors among them, matrices of actors and a shared mapper; hidden, added and removed
// actors; other translucent props.

#include "FourierOpacityPassTesting.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

using namespace FourierOpacityTesting;

namespace
{
constexpr Method Methods[] = { { Optimization::Fourier, Optimization::SeriesImportance },
  { Optimization::PaperFourier, Optimization::SeriesImportance },
  { Optimization::Bins, Optimization::SeriesImportance },
  { Optimization::WeightedAverage, Optimization::ExactImportance },
  { Optimization::WeightedBlended, Optimization::SeriesImportance },
  { Optimization::FragmentLists, Optimization::ExactImportance } };

enum Kind
{
  Points,
  Lines,
  Surfaces
};
constexpr const char* KindNames[] = { "points", "lines", "surfaces" };

// A black square of 15 pixels, as a point, a wide line or a surface.
vtkSmartPointer<vtkPolyData> MakeBlack(Kind kind, double x, double y, double z, double importance)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const double s = 7.5 / 32.0;
  std::vector<Point> corners;
  switch (kind)
  {
    case Points:
      corners = { { x, y, z } };
      break;
    case Lines:
      corners = { { x - s, y, z }, { x + s, y, z } };
      break;
    default:
      corners = { { x - s, y - s, z }, { x + s, y - s, z }, { x + s, y + s, z },
        { x - s, y + s, z } };
      break;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> array;
  array->SetName("Importance");
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const Point& corner : corners)
  {
    cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
    array->InsertNextValue(static_cast<float>(importance));
  }
  data->SetPoints(points);
  (kind == Points ? data->SetVerts(cells)
                  : (kind == Lines ? data->SetLines(cells) : data->SetPolys(cells)));
  data->GetPointData()->AddArray(array);
  return data;
}

// White squares in front of or behind black things of other actors, which do not cover them.
void CheckFading(Checks& check, PassStage& stage, Kind kind, const Method& method)
{
  stage.Renderer->RemoveAllViewProps();
  Optimization* by = stage.GetOptimization();
  SetMethod(by, method);
  by->SetImportanceReduction(1);
  by->SetForegroundWeight(7.0);
  by->SetBackgroundWeight(3.0);
  const std::string name = std::string(KindNames[kind]) + ", " + GetName(method);
  std::vector<std::pair<Point, double>> expected;
  for (int i = 0; i < 4; ++i)
  {
    const double x = i % 2 ? 0.5 : -0.5;
    const double y = i / 2 ? 0.5 : -0.5;
    const double own = 0.2 * i;
    // Of three at different depths, the white one is first, second, last or second.
    const int order[4][3] = { { 0, 1, 2 }, { 1, 0, 2 }, { 2, 0, 1 }, { 1, 0, 2 } };
    const double depths[3] = { 0.2, 0.55, 0.85 };
    Values values;
    values.Depths = { depths[order[i][0]], depths[order[i][1]], depths[order[i][2]] };
    values.Sizes = { own * own, 0.8 * 0.8, 0.5 * 0.5 };
    // An actor of the ends alone would be culled.
    std::vector<Square> white{ { x, y, GetZ(values.Depths[0]), 0.4, { 255, 255, 255, 255 } } };
    AddEnds(white);
    stage.AddItem(MakeStack(white, { own, 0.0, 0.0 }));
    for (int k = 1; k < 3; ++k)
    {
      auto black =
        stage.AddItem(MakeBlack(kind, x, y, GetZ(values.Depths[k]), std::sqrt(values.Sizes[k])));
      black->GetProperty()->SetColor(0.0, 0.0, 0.0);
      black->GetProperty()->SetPointSize(15.0);
      black->GetProperty()->SetLineWidth(15.0);
    }
    const double front = method.Importance == Optimization::ExactImportance
      ? values.GetExactFront(0)
      : values.GetSeriesFront(Cosines, 2 * by->GetNumberOfBands() + 1, 0);
    const double behind = std::max(values.GetTotal() - values.Sizes[0] - front, 0.0);
    expected.push_back({ { x, y, 0.0 }, GetOptimalOpacity(own, front, behind, by) });
  }
  const Picture picture = stage.Stage::Render();
  for (const auto& place : expected)
  {
    // Where the black ones do not reach.
    const int px = static_cast<int>((place.first[0] + 1.0) * 32.0) + 10;
    const int py = static_cast<int>((place.first[1] + 1.0) * 32.0) + 10;
    const double grey = 255.0 * place.second;
    CheckColor(check, name, picture.At(px, py), { grey, grey, grey }, 1.6);
  }
}

// Squares of three actors are those of one.
void CheckTogether(Checks& check)
{
  Scene one;
  PassScene several;
  for (const Method& method : Methods)
  {
    SetMethod(one.GetOptimization(), method);
    const Picture expected = one.Render();
    SetMethod(several.GetOptimization(), method);
    // A pass blends with the background what the mapper rounds before.
    CheckSame(check, GetName(method) + ": several actors", several.Render(), expected, 1);
    CheckSame(check, GetName(method) + ": again", several.Render(), expected, 1);
    check(several.Pass->GetNumberOfRenderedProps() == 3, "number of props");
    check(several.Pass->GetNumberOfSumBytes() == one.Mapper->GetNumberOfSumBytes() &&
        several.Pass->GetNumberOfBytes() > several.Pass->GetNumberOfSumBytes(),
      "bytes");
    if (method.Blending == Optimization::FragmentLists)
    {
      check(several.Pass->GetNumberOfFragments() == one.Mapper->GetNumberOfFragments() &&
          several.Pass->GetNumberOfFragments() > 0 &&
          several.Pass->GetMeanDepthComplexity() == one.Mapper->GetMeanDepthComplexity() &&
          several.Pass->GetNumberOfDroppedFragments() == 0,
        "numbers of fragments");
    }
  }
}

// Squares of several actors as the CPU blends them, over something opaque that hides some.
void CheckBlending(Checks& check)
{
  PassStage stage(32, 32);
  for (int method = 0; method < 6; ++method)
  {
    Blending by;
    by.Method = method;
    by.Set(stage.GetOptimization());
    for (int opaque : { -1, 0, 5, 10 })
    {
      stage.Renderer->RemoveAllViewProps();
      std::vector<Square> squares = MakeSquares(10, 20, 160);
      for (int i = 0; i < 3; ++i)
      {
        std::vector<Square> part;
        for (std::size_t k = i; k < squares.size(); k += 3)
        {
          part.push_back(squares[k]);
        }
        // An actor of the ends alone would be culled.
        if (i == 1)
        {
          AddEnds(part);
        }
        stage.AddItem(MakeStack(part));
      }
      std::array<int, 3> behind = Background;
      if (opaque >= 0)
      {
        // Behind that many of them, the first ones being in front.
        const double z = 0.9 - 1.8 * opaque / 10.0;
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(MakeStack({ { 0.0, 0.0, z, 0.5, { 10, 240, 60, 255 } } }));
        stage.AddItem(mapper)->ForceOpaqueOn();
        behind = { 10, 240, 60 };
        squares.resize(opaque);
      }
      CheckColor(check,
        std::string(MethodNames[method]) + ", something opaque behind " + std::to_string(opaque),
        stage.Render().At(16, 16), BlendBy(by, squares, behind), 2.0);
    }
  }
}

// Points that a matrix puts where they are now.
void Unmake(vtkPolyData* data, vtkMatrix4x4* matrix)
{
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(matrix, inverse);
  vtkPoints* points = data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    points->GetPoint(i, point);
    inverse->MultiplyPoint(point, point);
    points->SetPoint(i, point);
  }
}

void CheckMatrices(Checks& check)
{
  for (const Method& method : { Methods[0], Methods[5] })
  {
    PassScene plain(method);
    const Picture expected = plain.Render();
    PassStage stage;
    SetMethod(stage.GetOptimization(), method);
    const SceneSquares squares;
    for (int i = 0; i < 3; ++i)
    {
      auto data = squares.MakePart(i, 3);
      auto actor = vtkSmartPointer<vtkActor>::New();
      actor->GetProperty()->LightingOff();
      if (i == 1)
      {
        actor->SetScale(0.5, 2.0, 4.0);
        actor->RotateZ(30.0);
        actor->SetPosition(0.2, -0.5, 3.0);
      }
      else if (i == 2)
      {
        vtkNew<vtkTransform> transform;
        transform->RotateWXYZ(70.0, 1.0, 2.0, 3.0);
        transform->Scale(-3.0, 3.0, 3.0);
        actor->SetUserTransform(transform);
      }
      vtkNew<vtkMatrix4x4> matrix;
      actor->GetMatrix(matrix);
      Unmake(data, matrix);
      actor->SetMapper(MakeOpacityMapper(data));
      stage.Renderer->AddActor(actor);
    }
    stage.AddSphere(0.1, -0.3, 0.0, 0.25)->GetProperty()->SetColor(0.3, 0.9, 0.2);
    const Difference difference = Compare(stage.Render(), expected);
    // Edges may move by a rounding.
    check(difference.Part < 0.01,
      GetName(method) + ": matrices" + VoxelLineMapperTesting::Describe(difference));
  }
}

// Textures and culling are those of each actor.
void CheckProperties(Checks& check)
{
  PassStage stage(32, 32);
  auto data = MakeStack({ { 0.0, 0.0, 0.0, 0.5, { 255, 255, 255, 255 } } });
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const auto& corner :
    { std::array<double, 2>{ 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } })
  {
    coordinates->InsertNextTuple(corner.data());
  }
  data->GetPointData()->SetTCoords(coordinates);
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 4; ++i)
  {
    const double color[3] = { 200.0, 100.0, 50.0 };
    image->GetPointData()->GetScalars()->SetTuple(i, color);
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  auto actor = stage.AddItem(data);
  actor->SetTexture(texture);
  CheckColor(check, "texture", stage.Render().At(16, 16), { 200, 100, 50 }, 1.0);
  actor->SetTexture(nullptr);
  CheckColor(check, "no texture", stage.Render().At(16, 16), { 255, 255, 255 }, 1.0);
  actor->GetProperty()->FrontfaceCullingOn();
  check(stage.Render().At(16, 16) == Background, "front faces are culled");
  actor->GetProperty()->FrontfaceCullingOff();
  actor->GetProperty()->BackfaceCullingOn();
  CheckColor(check, "back faces are culled", stage.Render().At(16, 16), { 255, 255, 255 }, 1.0);
}

// Two actors of one mapper: of the left one lies something important behind.
void CheckSharedMapper(Checks& check)
{
  PassStage stage(32, 32);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  auto mapper = MakeOpacityMapper(MakeStack({ { 0.0, 0.0, 0.0, 0.3, { 255, 255, 255, 255 } } }));
  auto left = stage.AddItem(mapper);
  left->SetPosition(-0.5, 0.0, 0.5);
  auto right = stage.AddItem(mapper);
  right->SetPosition(0.5, 0.0, 0.5);
  auto black = stage.AddItem(MakeStack({ { -0.5, 0.0, -0.5, 0.3, { 0, 0, 0, 255 } } }, { 1.0 }));
  const double faint = 255.0 / 51.0;
  for (int i = 0; i < 2; ++i)
  {
    const Picture picture = stage.Render();
    CheckColor(check, "shared mapper, faded", picture.At(8, 16), { faint, faint, faint }, 1.5);
    CheckColor(check, "shared mapper, opaque", picture.At(24, 16), { 255, 255, 255 }, 1.0);
  }
  // What the one has does not become the other's when it goes.
  stage.GetOptimization()->SetTransitionTime(60.0);
  stage.Renderer->RemoveActor(left);
  CheckColor(
    check, "shared mapper, one is left", stage.Render().At(24, 16), { 255, 255, 255 }, 1.0);
  stage.GetOptimization()->SetTransitionTime(0.0);
  stage.Renderer->AddActor(left);
  // Both before each other, half transparent.
  black->VisibilityOff();
  const Square square{ 0.0, 0.0, 0.0, 0.3, { 200, 100, 50, 128 } };
  mapper->SetInputData(MakeStack({ square }));
  left->SetPosition(0.0, 0.0, 0.5);
  right->SetPosition(0.0, 0.0, -0.5);
  CheckColor(check, "shared mapper, twice at one place", stage.Render().At(16, 16),
    Blend({ square, square }, { 0, 0, 0 }), 1.6);
}

// Hidden actors have no part; those that come and go leave the others' opacities.
void CheckComingAndGoing(Checks& check)
{
  PassScene scene;
  const Picture expected = scene.Render();
  auto other = scene.AddItem(MakeStack({ { 0.0, 0.0, -0.8, 0.7, { 250, 0, 250, 255 } } }, { 1.0 }));
  const Picture with = scene.Render();
  check(Compare(with, expected).Largest > 20, "another actor is seen");
  other->VisibilityOff();
  CheckSame(check, "a hidden actor has no part", scene.Render(), expected);
  other->VisibilityOn();
  CheckSame(check, "shown again", scene.Render(), with);
  scene.Renderer->RemoveActor(other);
  CheckSame(check, "a removed actor has no part", scene.Render(), expected);

  // White before something important; opacities that are kept follow slowly, lost ones at once.
  PassStage stage(32, 32);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  auto brief = stage.AddItem(MakeStack({ { 0.5, 0.5, 0.0, 0.3, { 0, 0, 255, 255 } } }));
  stage.AddItem(MakeStack({ { -0.5, 0.0, 0.5, 0.3, { 255, 255, 255, 255 } } }));
  stage.AddItem(MakeStack({ { -0.5, 0.0, -0.5, 0.3, { 0, 0, 0, 255 } } }, { 1.0 }));
  stage.GetOptimization()->SetTransitionTime(60.0);
  const double faint = 255.0 / 51.0;
  CheckColor(check, "faded", stage.Render().At(8, 16), { faint, faint, faint }, 1.5);
  stage.GetOptimization()->SetForegroundWeight(0.0);
  brief->VisibilityOff();
  check(stage.Render().At(8, 16)[0] < 80, "opacities are kept where an actor is hidden");
  stage.Renderer->RemoveActor(brief);
  check(stage.Render().At(8, 16)[0] < 80, "opacities are kept where an actor is removed");
  stage.Renderer->AddActor(brief);
  check(stage.Render().At(8, 16)[0] < 80, "opacities are kept where an actor is added");
  stage.AddItem(MakeStack({ { 0.5, -0.5, 0.0, 0.3, { 0, 0, 255, 255 } } }));
  check(stage.Render().At(8, 16)[0] < 80, "opacities are kept where another one is added");
}

// What has another mapper is drawn last, by the pass for it.
void CheckOthers(Checks& check, Messages* messages)
{
  PassStage stage(32, 32);
  const Square behind{ 0.0, 0.0, 0.3, 0.5, { 250, 120, 20, 130 } };
  const Square other{ 0.0, 0.0, -0.3, 0.5, { 20, 60, 240, 130 } };
  auto actor = stage.AddItem(MakeStack({ behind }));
  stage.AddItem(MakeMapper({ other }));
  // The other one is nearer to the viewer in the picture, whatever its depth.
  Square shown = other;
  shown.Z = 0.9;
  const Point expected = Blend({ behind, shown }, Background);
  for (int i = 0; i < 3; ++i)
  {
    CheckColor(check, "another prop", stage.Render().At(16, 16), expected, 1.6);
  }
  check(messages->TakeWarnings(
          "1 translucent props are no actors with a vtkFourierOpacityMapper: they are "
          "drawn over") == 1,
    "other props are told once");
  check(stage.Pass->GetNumberOfRenderedProps() == 2, "number of props");
  stage.Pass->SetTranslucentPass(nullptr);
  CheckColor(
    check, "no pass for others", stage.Render().At(16, 16), Blend({ behind }, Background), 1.6);
  messages->TakeWarnings("");
  // Another one more.
  stage.AddItem(MakeMapper({ other }));
  stage.Render();
  stage.Render();
  check(messages->TakeWarnings(
          "2 translucent props are no actors with a vtkFourierOpacityMapper: they are not "
          "drawn") == 1,
    "what is not drawn is told once");
  // By themselves they are drawn as ever, and nothing is to be told.
  stage.Pass->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  actor->VisibilityOff();
  CheckColor(
    check, "others alone", stage.Render().At(16, 16), Blend({ other, other }, Background), 1.6);
}

// The parameters are those of the pass.
void CheckParameters(Checks& check)
{
  PassScene scene;
  const Picture expected = scene.Render();
  for (vtkActor* actor : scene.Actors)
  {
    vtkFourierOpacityMapper::SafeDownCast(actor->GetMapper())
      ->GetOptimization()
      ->SetForegroundWeight(0.0);
  }
  CheckSame(check, "parameters of mappers have no effect", scene.Render(), expected);
  const vtkMTimeType time = scene.Pass->GetMTime();
  vtkNew<Optimization> other;
  other->SetForegroundWeight(0.0);
  scene.Pass->SetOptimization(other);
  check(
    scene.Pass->GetOptimization() == other && scene.Pass->GetMTime() > time, "other parameters");
  check(Compare(scene.Render(), expected).Largest > 20, "parameters of the pass have an effect");
  scene.Pass->SetOptimization(nullptr);
  CheckSame(check, "parameters of the pass's own", scene.Render(), expected);

  std::ostringstream text;
  scene.Pass->Print(text);
  for (const char* part : { "Optimization:", "ForegroundWeight: 50", "TranslucentPass:\n" })
  {
    check(text.str().find(part) != std::string::npos, std::string("prints ") + part);
  }
  scene.Pass->SetTranslucentPass(nullptr);
  text.str("");
  scene.Pass->Print(text);
  check(text.str().find("TranslucentPass: (none)") != std::string::npos, "prints no pass");
}
}

int TestFourierOpacityPass(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  PassStage stage(64, 64);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  for (Kind kind : { Points, Lines, Surfaces })
  {
    CheckFading(check, stage, kind, { Optimization::FragmentLists, Optimization::ExactImportance });
    CheckFading(
      check, stage, kind, { Optimization::FragmentLists, Optimization::SeriesImportance });
  }
  CheckTogether(check);
  CheckBlending(check);
  CheckMatrices(check);
  CheckProperties(check);
  CheckSharedMapper(check);
  CheckComingAndGoing(check);
  CheckOthers(check, messages);
  CheckParameters(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
