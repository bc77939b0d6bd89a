// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards vtkFourierOpacityMapper as an object: what it copies and prints; that its modification
// time follows the optimization, whose changes make no buffers of vertices anew; that no shaders
// are made anew while nothing changes, and all of them where they must be; bytes on the device; and
// that opacities of surfaces, lines and points of any size are the same for importance that is
// summed at full and at reduced resolution.

#include "FourierOpacityScene.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkTexture.h"

using namespace FourierOpacityTesting;

namespace
{
void CheckCopy(Checks& check)
{
  vtkNew<vtkFourierOpacityMapper> mapper;
  check(mapper->GetImportanceArrayName().empty() && mapper->GetImportanceRange()[0] == 1.0 &&
      mapper->GetImportanceRange()[1] == 0.0 && mapper->GetNumberOfLineSegments() == 0 &&
      mapper->GetNumberOfPatches() == 500,
    "defaults");
  check(mapper->GetNumberOfBytes() == 0 && mapper->GetNumberOfSumBytes() == 0 &&
      mapper->GetNumberOfFragments() == 0 && mapper->GetNumberOfAccumulatedPictures() == 0,
    "nothing before the first picture");
  check(!mapper->HasOpaqueGeometry() && mapper->HasTranslucentPolygonalGeometry(), "translucent");
  mapper->SetImportanceArrayName("some array");
  mapper->SetImportanceRange(-2.0, 3.5);
  mapper->SetNumberOfLineSegments(1234);
  mapper->SetNumberOfPatches(56);
  mapper->SetScalarRange(4.0, 5.0);
  mapper->GetOptimization()->SetEmphasis(7.25);
  auto data = MakeScene();
  mapper->SetInputData(data);

  vtkNew<vtkFourierOpacityMapper> copy;
  copy->ShallowCopy(mapper);
  check(copy->GetImportanceArrayName() == "some array" && copy->GetImportanceRange()[0] == -2.0 &&
      copy->GetImportanceRange()[1] == 3.5 && copy->GetNumberOfLineSegments() == 1234 &&
      copy->GetNumberOfPatches() == 56 && copy->GetOptimization() == mapper->GetOptimization() &&
      copy->GetInput() == data && copy->GetScalarRange()[1] == 5.0,
    "a copy has all of it");
  // From another kind of mapper, and to one.
  vtkNew<vtkPolyDataMapper> other;
  other->SetScalarRange(8.0, 9.0);
  copy->ShallowCopy(other);
  check(copy->GetScalarRange()[0] == 8.0 && copy->GetNumberOfPatches() == 56,
    "a copy of another kind of mapper");
  other->ShallowCopy(mapper);
  check(other->GetInput() == data, "another kind of mapper as a copy");

  std::ostringstream text;
  mapper->Print(text);
  for (const char* part : { "ImportanceArrayName: some array", "ImportanceRange: -2 3.5",
         "NumberOfLineSegments: 1234", "NumberOfPatches: 56",
         "Optimization:", "RegularizationWeight: 1", "ForegroundWeight: 50", "BackgroundWeight: 50",
         "Emphasis: 7.25", "SmoothingIterations: 15", "TransitionTime: 0", "NumberOfBands: 5",
         "Subset: 1", "ImportanceReduction: 2", "DepthReduction: 1", "HalfFloats: 1", "Blending: 0",
         "Importance: 0", "DepthScale: 0", "TightDepth: ", "OpaqueThreshold: 0.98", "HaloWidth: 0",
         "HaloDepth: 0.05", "AccumulationFrames: 1", "MaximumListMemory: 1024" })
  {
    check(text.str().find(part) != std::string::npos, std::string("prints ") + part);
  }
}

void CheckTime(Checks& check)
{
  vtkNew<vtkFourierOpacityMapper> mapper;
  const std::function<void()> changes[] = { [&] { mapper->SetImportanceArrayName("a"); },
    [&] { mapper->SetImportanceRange(0.0, 2.0); }, [&] { mapper->SetNumberOfLineSegments(7); },
    [&] { mapper->SetNumberOfPatches(7); },
    [&] { mapper->SetOptimization(vtkNew<Optimization>()); },
    [&] { mapper->GetOptimization()->SetHaloWidth(2.0); },
    [&] { mapper->SetOptimization(nullptr); }, [&] { mapper->SetOptimization(nullptr); } };
  int i = 0;
  for (const auto& change : changes)
  {
    const vtkMTimeType time = mapper->GetMTime();
    change();
    check(mapper->GetMTime() > time, "change " + std::to_string(i) + " is told");
    ++i;
  }
  const vtkMTimeType time = mapper->GetMTime();
  mapper->SetImportanceArrayName("a");
  mapper->SetImportanceRange(0.0, 2.0);
  mapper->SetNumberOfLineSegments(7);
  mapper->SetNumberOfPatches(7);
  mapper->SetOptimization(mapper->GetOptimization());
  check(mapper->GetMTime() == time, "nothing is told where nothing changed");
  check(mapper->GetOptimization() != nullptr, "there always is an optimization");
}

/// Counts how often buffers of vertices, and shaders, are made.
class CountingMapper : public vtkFourierOpacityMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkFourierOpacityMapper);
  int Count = 0;
  int Shaders = 0;

protected:
  void ReplaceShaderValues(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override
  {
    ++this->Shaders;
    this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  }
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override
  {
    ++this->Count;
    this->Superclass::BuildBufferObjects(renderer, actor);
  }
};
vtkStandardNewMacro(CountingMapper);

void CheckBuffers(Checks& check)
{
  Stage stage(40, 40);
  LookAlongZ(stage);
  vtkNew<CountingMapper> mapper;
  mapper->SetInputData(MakeScene());
  mapper->SetImportanceArrayName("Importance");
  stage.Add(mapper);
  const Picture first = stage.Render();
  check(mapper->Count > 0, "buffers are made");
  Optimization* by = mapper->GetOptimization();
  const std::function<void()> changes[] = { [] {}, [&] { by->SetForegroundWeight(3.0); },
    [&] { by->SetBlendingToBins(); }, [&] { by->SetImportanceToExact(); },
    [&] { by->SetHaloWidth(3.0); }, [&] { by->SetNumberOfBands(9); },
    [&] { by->SetAccumulationFrames(3); },
    [&] { stage.Renderer->GetActiveCamera()->Azimuth(10.0); } };
  int i = 0;
  for (const auto& change : changes)
  {
    stage.Render();
    const int count = mapper->Count;
    change();
    stage.Render();
    check(mapper->Count == count, "no buffers are made by change " + std::to_string(i));
    ++i;
  }
  check(Compare(stage.Render(), first).Largest > 10, "the changes have an effect");
  const int count = mapper->Count;
  mapper->SetImportanceRange(0.0, 0.5);
  stage.Render();
  check(mapper->Count > count, "buffers are made for another range of importance");
}

/// A grid of quads and lines in front of it, with normals and texture coordinates.
vtkSmartPointer<vtkPolyData> MakeSurfaceAndLines()
{
  auto data = MakeScene();
  data->GetCellData()->Initialize();
  const vtkIdType quads = data->GetNumberOfPoints();
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < 5; ++i)
  {
    const double y = -0.6 + 0.3 * i;
    lines->InsertNextCell({ data->GetPoints()->InsertNextPoint(-0.8, y, 0.95),
      data->GetPoints()->InsertNextPoint(0.8, y + 0.1, 0.95) });
  }
  data->SetLines(lines);
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> places;
  places->SetName("Places");
  places->SetNumberOfComponents(2);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double t = static_cast<double>(i % 7) / 6.0;
    importance->InsertNextValue(static_cast<float>(i < quads ? 0.1 * (i / 4) : 0.0));
    normals->InsertNextTuple3(0.6 * t, 0.0, std::sqrt(1.0 - 0.36 * t * t));
    places->InsertNextTuple2(i % 4 == 1 || i % 4 == 2 ? 1.0 : 0.0, i % 4 >= 2 ? 1.0 : 0.0);
    colors->InsertNextTuple4(255.0 * t, 200.0 - 100.0 * t, 90.0, 120.0 + 130.0 * t);
  }
  data->GetPointData()->AddArray(importance);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(places);
  data->GetPointData()->SetScalars(colors);
  return data;
}

struct ShaderStage : Stage
{
  vtkNew<CountingMapper> Mapper;
  vtkSmartPointer<vtkPolyData> Data = MakeSurfaceAndLines();
  vtkSmartPointer<vtkActor> Actor;

  ShaderStage()
    : Stage(40, 40)
  {
    LookAlongZ(*this);
    this->Mapper->SetInputData(this->Data);
    this->Mapper->SetImportanceArrayName("Importance");
    this->Mapper->SetImportanceRange(0.0, 1.0);
    this->Actor = this->Add(this->Mapper);
    this->Actor->GetProperty()->SetLineWidth(3.0);
    this->Actor->GetProperty()->SetColor(0.9, 0.6, 0.2);
    this->Actor->GetProperty()->SetOpacity(0.8);
    this->Renderer->SetAutomaticLightCreation(0);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(3.0, 1.0, 5.0);
    this->Renderer->AddLight(light);
  }
};

// Changes for which shaders must be made anew, in the order in which they are made.
const std::pair<const char*, std::function<void(ShaderStage&)>> ShaderChanges[] = {
  { "no scalars", [](ShaderStage& stage) { stage.Mapper->ScalarVisibilityOff(); } },
  { "another light",
    [](ShaderStage& stage)
    {
      vtkNew<vtkLight> light;
      light->SetLightTypeToSceneLight();
      light->SetPosition(-4.0, 2.0, 1.0);
      light->SetColor(0.2, 0.9, 0.3);
      stage.Renderer->AddLight(light);
    } },
  { "a light with a cone",
    [](ShaderStage& stage)
    {
      auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
      light->PositionalOn();
      light->SetConeAngle(8.0);
    } },
  { "flat", [](ShaderStage& stage) { stage.Actor->GetProperty()->SetInterpolationToFlat(); } },
  { "Gouraud",
    [](ShaderStage& stage) { stage.Actor->GetProperty()->SetInterpolationToGouraud(); } },
  { "no normals", [](ShaderStage& stage) { stage.Data->GetPointData()->SetNormals(nullptr); } },
  { "a texture",
    [](ShaderStage& stage)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(2, 2, 1);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
      for (int i = 0; i < 12; ++i)
      {
        bytes[i] = static_cast<unsigned char>(i % 3 == i / 3 ? 255 : 60);
      }
      vtkNew<vtkTexture> texture;
      texture->SetInputData(image);
      stage.Data->GetPointData()->SetActiveTCoords("Places");
      stage.Actor->SetTexture(texture);
    } },
  { "perspective",
    [](ShaderStage& stage)
    {
      stage.Renderer->GetActiveCamera()->ParallelProjectionOff();
      stage.Renderer->GetActiveCamera()->SetViewAngle(12.0);
    } },
  { "scalars", [](ShaderStage& stage) { stage.Mapper->ScalarVisibilityOn(); } },
  { "no lighting", [](ShaderStage& stage) { stage.Actor->GetProperty()->LightingOff(); } }
};

// The shaders of the stages of a picture are kept for the next one; where they must be others, the
// next picture is that of a mapper that begins anew.
void CheckShaders(Checks& check, const Method& method, double haloWidth)
{
  const std::string name = GetName(method) + (haloWidth > 0.0 ? " with halos, " : ", ");
  ShaderStage stage;
  SetMethod(stage.Mapper->GetOptimization(), method);
  stage.Mapper->GetOptimization()->SetHaloWidth(haloWidth);
  Picture last = stage.Render();
  check(stage.Mapper->Shaders > 3, name + "shaders are made");
  for (std::size_t i = 0; i < std::size(ShaderChanges); ++i)
  {
    stage.Render();
    stage.Mapper->Shaders = 0;
    stage.Render();
    stage.Renderer->GetActiveCamera()->Modified();
    stage.Render();
    check(stage.Mapper->Shaders == 0,
      name + std::to_string(stage.Mapper->Shaders) +
        " shaders are made anew for nothing before \"" + ShaderChanges[i].first + "\"");
    ShaderChanges[i].second(stage);
    const Picture picture = stage.Render();
    stage.Mapper->ReleaseGraphicsResources(stage.Window);
    CheckSame(check, name + ShaderChanges[i].first, picture, stage.Render());
    check(Compare(picture, last).Largest > 5, name + ShaderChanges[i].first + ": shows");
    last = picture;
  }
}

void CheckBytes(Checks& check)
{
  for (int width : { 50, 31 })
  {
    OpacityStage stage(width, 40);
    stage.Mapper->SetInputData(MakeScene());
    stage.Stage::Render();
    // 2 m + 1 = 11 sums: one of 4 bytes, the others of 2.
    check(stage.Mapper->GetNumberOfSumBytes() == width * 40 * 24, "bytes of 11 sums");
    const vtkIdType all = stage.Mapper->GetNumberOfBytes();
    // Colours (8), opaque layer (4), picture (4), depth of the scene and the picture (4 or more).
    check(all >= width * 40 * (24 + 8 + 4 + 4 + 4) && all < width * 40 * 47 + 4000,
      "bytes of all: " + std::to_string(all));
    stage.GetOptimization()->SetAccumulationFrames(4);
    stage.Stage::Render();
    check(stage.Mapper->GetNumberOfBytes() == all + width * 40 * 16, "bytes of a mean");
    stage.Mapper->ReleaseGraphicsResources(stage.Window);
    check(stage.Mapper->GetNumberOfBytes() == 0 && stage.Mapper->GetNumberOfSumBytes() == 0,
      "all is released: " + std::to_string(stage.Mapper->GetNumberOfBytes()));
  }
}

enum Kind
{
  Surfaces,
  Lines,
  Points
};
constexpr const char* KindNames[] = { "surfaces", "lines", "points" };

// White squares before black lines or points that cover each pixel just once, or a surface.
vtkSmartPointer<vtkPolyData> MakeCovered(Kind kind, int size, int pixels, double importance)
{
  auto data = MakeStack({ { 0.0, 0.0, 0.5, 0.7, { 255, 255, 255, 255 } } });
  data->GetCellData()->Initialize();
  vtkPoints* points = data->GetPoints();
  vtkNew<vtkCellArray> cells;
  for (int y = 0; y < size; y += pixels)
  {
    const double top = (2.0 * y + pixels) / size - 1.0;
    if (kind == Lines)
    {
      cells->InsertNextCell(
        { points->InsertNextPoint(-1.1, top, -0.5), points->InsertNextPoint(1.1, top, -0.5) });
    }
    for (int x = 0; kind == Points && x < size; x += pixels)
    {
      cells->InsertNextCell(
        { points->InsertNextPoint((2.0 * x + pixels) / size - 1.0, top, -0.5) });
    }
  }
  if (kind == Surfaces)
  {
    vtkNew<vtkCellArray> polygons;
    polygons->InsertNextCell({ 0, 1, 2, 3 });
    polygons->InsertNextCell(
      { points->InsertNextPoint(-1.0, -1.0, -0.5), points->InsertNextPoint(1.0, -1.0, -0.5),
        points->InsertNextPoint(1.0, 1.0, -0.5), points->InsertNextPoint(-1.0, 1.0, -0.5) });
    data->SetPolys(polygons);
  }
  else
  {
    kind == Lines ? data->SetLines(cells) : data->SetVerts(cells);
  }
  vtkNew<vtkFloatArray> array;
  array->SetName("Importance");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(i < 4 ? 0.0f : static_cast<float>(importance));
    const double grey = i < 4 ? 255.0 : 0.0;
    colors->InsertNextTuple3(grey, grey, grey);
  }
  data->GetPointData()->AddArray(array);
  data->GetPointData()->SetScalars(colors);
  return data;
}

// What covers a pixel just once hides as much at any resolution.
void CheckCoverage(Checks& check)
{
  constexpr int size = 64;
  constexpr double importance = 0.6;
  struct
  {
    Kind What;
    int Pixels;
  } cases[] = { { Surfaces, size }, { Lines, 1 }, { Lines, 4 }, { Lines, 8 }, { Points, 1 },
    { Points, 2 }, { Points, 8 } };
  for (int importanceBy : { Optimization::ExactImportance, Optimization::SeriesImportance })
  {
    for (const auto& test : cases)
    {
      OpacityStage stage(size, size);
      stage.Renderer->SetBackground(0.0, 0.0, 0.0);
      stage.Mapper->SetNumberOfLineSegments(1);
      stage.Mapper->SetNumberOfPatches(1);
      stage.Mapper->SetInputData(MakeCovered(test.What, size, test.Pixels, importance));
      stage.Actor->GetProperty()->SetLineWidth(static_cast<float>(test.Pixels));
      stage.Actor->GetProperty()->SetPointSize(static_cast<float>(test.Pixels));
      Optimization* by = stage.GetOptimization();
      by->SetImportance(importanceBy);
      by->SetForegroundWeight(4.0);
      by->SetBackgroundWeight(0.0);
      by->SetSmoothingIterations(0);
      const double exact = 255.0 * GetOptimalOpacity(0.0, 0.0, importance * importance, by);
      for (int reduction : { 1, 2, 4, 8 })
      {
        by->SetImportanceReduction(reduction);
        const int grey = stage.Stage::Render().At(size / 2, size / 2)[0];
        const std::string name = std::string(KindNames[test.What]) + " of " +
          std::to_string(test.Pixels) + " pixels, reduction " + std::to_string(reduction);
        // A series sums up to all of it between the two depths, nearly.
        const double tolerance = importanceBy == Optimization::ExactImportance ? 2.0 : 12.0;
        check(std::abs(grey - exact) < tolerance,
          name + ": grey " + std::to_string(grey) + " instead of " + std::to_string(exact));
      }
    }
  }
}

// Two actors of one mapper: white before something important, and the other way round.
void CheckSharedMapper(Checks& check)
{
  OpacityStage stage(32, 32);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  stage.Mapper->SetInputData(MakeStack(
    { { 0.0, 0.0, 0.4, 0.3, { 255, 255, 255, 255 } }, { 0.2, 0.0, -0.4, 0.1, { 0, 0, 0, 255 } } },
    { 0.0, 1.0 }));
  stage.Mapper->SetNumberOfPatches(1);
  stage.Actor->SetPosition(-0.5, 0.0, 0.0);
  auto other = stage.Add(stage.Mapper);
  other->GetProperty()->LightingOff();
  other->RotateY(180.0);
  other->SetPosition(0.5, 0.0, 0.0);
  stage.GetOptimization()->SetBackgroundWeight(0.0);
  stage.GetOptimization()->SetImportanceToExact();
  stage.GetOptimization()->SetTransitionTime(60.0);
  for (int i = 0; i < 3; ++i)
  {
    const Picture picture = stage.Stage::Render();
    check(picture.At(6, 16)[0] < 10, "an actor of a shared mapper fades");
    check(picture.At(26, 16)[0] > 250, "another actor of the mapper does not");
  }
}

// A scene of surfaces looks nearly the same.
void CheckReduced(Checks& check)
{
  Scene scene;
  scene.GetOptimization()->SetImportanceReduction(1);
  const Picture full = scene.Render();
  for (int reduction : { 2, 4 })
  {
    scene.GetOptimization()->SetImportanceReduction(reduction);
    const Difference difference = Compare(scene.Render(), full);
    check(difference.Rms < 3.0,
      "importance by " + std::to_string(reduction) + VoxelLineMapperTesting::Describe(difference));
  }
}
}

int TestFourierOpacityMapper(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  CheckCopy(check);
  // VTK 9.1 says this of itself when it copies.
  check(messages->TakeWarnings("ShaderCode was deprecated") >= 0, "no other warnings");
  CheckTime(check);
  CheckBuffers(check);
  CheckShaders(check, {}, 0.0);
  CheckShaders(check, {}, 4.0);
  CheckShaders(check, { Optimization::Bins, Optimization::ExactImportance }, 0.0);
  CheckShaders(check, { Optimization::FragmentLists, Optimization::ExactImportance }, 4.0);
  CheckBytes(check);
  CheckCoverage(check);
  CheckSharedMapper(check);
  CheckReduced(check);
  check(messages->IsQuiet(), "no errors and no warnings");
  return check.GetResult();
}
