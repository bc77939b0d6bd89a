// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that bad input to opacity optimization costs nothing but itself: without usable importance
// everything is opaque, the rest of the scene is drawn, what is wrong is told once and not in every
// picture, and setters refuse what is out of range and name the range.

#include "FourierOpacityTesting.h"
#include "vtkFourierOpacityVertices.h"
#include "vtkIntArray.h"
#include "vtkOpacitySegments.h"
#include "vtkStringArray.h"

#include <limits>

using namespace FourierOpacityTesting;

namespace
{
const double NaN = vtkMath::Nan();
constexpr double Infinity = std::numeric_limits<double>::infinity();

// A green square in front of a red one, and a blue actor beside them that VTK draws.
struct Scene : OpacityStage
{
  vtkSmartPointer<vtkPolyData> Data;

  Scene()
  {
    this->Data = MakeStack({ { -0.3, 0.0, 0.5, 0.4, { 0, 255, 0, 255 } },
      { -0.3, 0.0, -0.5, 0.4, { 255, 0, 0, 255 } } });
    this->Data->GetCellData()->RemoveArray("Importance");
    this->Mapper->SetInputData(this->Data);
    this->Mapper->SetImportanceRange(1.0, 0.0);
    vtkNew<vtkPolyDataMapper> other;
    other->SetInputData(MakeStack({ { 0.7, 0.0, 0.0, 0.2, { 0, 0, 255, 255 } } }));
    this->Add(other)->GetProperty()->LightingOff();
  }
};

constexpr std::array<int, 3> Green{ 0, 255, 0 };
constexpr std::array<int, 3> Blue{ 0, 0, 255 };

// Drawn three times; each says what it has to say once.
void CheckOpaque(Checks& check, const std::string& name, Scene& scene, Messages* messages,
  const std::string& warning)
{
  scene.Stage::Render();
  scene.Stage::Render();
  const Picture picture = scene.Stage::Render();
  check(picture.At(11, 16) == Green,
    name + ": everything is opaque" + VoxelLineMapperTesting::Describe(picture.At(11, 16)));
  check(picture.At(27, 16) == Blue, name + ": the rest of the scene is drawn");
  if (!warning.empty())
  {
    check(messages->TakeWarnings(warning) == 1, name + ": one warning");
  }
  check(messages->IsQuiet(), name + ": nothing else is said");
}

vtkSmartPointer<vtkDoubleArray> MakeArray(int components, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("Importance");
  array->SetNumberOfComponents(components);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

void CheckArrays(Checks& check, Messages* messages)
{
  struct
  {
    const char* Name;
    std::vector<double> Values; ///< of the eight points
    const char* Warning;
  } cases[] = {
    { "no array", {}, "no array \"Importance\"" },
    { "too short", { 0, 1, 0 }, "has 3 tuples and should have 8" },
    { "constant", { 3, 3, 3, 3, 3, 3, 3, 3 }, "same everywhere" },
    { "nothing but NaN", { NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN }, "" },
    { "some NaN", { NaN, 0, 0, 0, 0.0, 0, 0, 1e-4 }, "importance of 1 points is not a finite" },
    { "infinite", { 0, 0, 0, 0, -Infinity, Infinity, 0, 1e-4 }, "importance of 2 points" },
    { "more than needed", { 0, 0, 0, 0, 0, 0, 0, 1e-4, 5, 6 }, "" },
  };
  for (const auto& test : cases)
  {
    Scene scene;
    // What has no importance in front of what has hardly any stays opaque.
    scene.GetOptimization()->SetForegroundWeight(0.0);
    if (!test.Values.empty())
    {
      scene.Data->GetPointData()->AddArray(MakeArray(1, test.Values));
    }
    if (std::string(test.Name) == "nothing but NaN")
    {
      scene.Stage::Render();
      scene.Stage::Render();
      check(messages->TakeWarnings("mportance") == 2, "NaN everywhere: two things are told, once");
    }
    CheckOpaque(check, test.Name, scene, messages, test.Warning);
  }

  // What is told again is only what is new.
  Scene scene;
  scene.Data->GetPointData()->AddArray(MakeArray(1, { 0, 1 }));
  CheckOpaque(check, "two tuples", scene, messages, "has 2 tuples");
  scene.Data->Modified();
  CheckOpaque(check, "two tuples again", scene, messages, "");
  scene.Data->GetPointData()->AddArray(MakeArray(1, { 0, 1, 1 }));
  CheckOpaque(check, "three tuples", scene, messages, "has 3 tuples");

  // Other kinds of arrays.
  Scene cells;
  cells.Data->GetCellData()->AddArray(MakeArray(1, { 1.0 }));
  CheckOpaque(check, "one cell", cells, messages, "has 1 tuples and should have 2");
  Scene strings;
  vtkNew<vtkStringArray> words;
  words->SetName("Importance");
  words->SetNumberOfValues(8);
  strings.Data->GetPointData()->AddArray(words);
  CheckOpaque(check, "strings", strings, messages, "no array \"Importance\"");
  Scene noScalars;
  noScalars.Mapper->SetImportanceArrayName("");
  noScalars.Data->GetCellData()->SetScalars(nullptr);
  noScalars.Actor->GetProperty()->SetColor(0.0, 1.0, 0.0);
  CheckOpaque(check, "no scalars", noScalars, messages, "no active scalars");

  // The kind that was asked for counts, though the other one has the array.
  Scene onPoints;
  onPoints.Mapper->SetImportanceArrayAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  onPoints.Data->GetPointData()->AddArray(MakeArray(1, { 0, 0, 0, 0, 1, 1, 1, 1 }));
  CheckOpaque(
    check, "on points, not on cells", onPoints, messages, "no array \"Importance\" for cells");
  Scene onCells;
  onCells.Mapper->SetImportanceArrayAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  onCells.Data->GetCellData()->AddArray(MakeArray(1, { 0, 1 }));
  CheckOpaque(
    check, "on cells, not on points", onCells, messages, "no array \"Importance\" for points");
  onCells.Mapper->SetImportanceArrayAssociation(vtkDataObject::FIELD_ASSOCIATION_NONE);
  check(messages->TakeErrors("ImportanceArrayAssociation 2 is not valid") == 1 &&
      onCells.Mapper->GetImportanceArrayAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS,
    "an association that is none of these is an error");

  // Integers are numbers: the square in front fades.
  Scene integers;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Importance");
  for (int i = 0; i < 8; ++i)
  {
    numbers->InsertNextValue(i / 4 * 100);
  }
  integers.Data->GetPointData()->AddArray(numbers);
  const Picture picture = integers.Stage::Render();
  check(IsNear(picture.At(11, 16), { 250, 5, 0 }, 2),
    "integers" + VoxelLineMapperTesting::Describe(picture.At(11, 16)));
  check(messages->IsQuiet(), "integers: nothing is said");
}

// Arrays of segments that another filter made.
void CheckSegments(Checks& check, Messages* messages)
{
  Scene scene;
  scene.GetOptimization()->SetForegroundWeight(0.0);
  scene.Data->GetPointData()->AddArray(MakeArray(1, { 0, 0, 0, 0, 0, 0, 0, 1e-4 }));
  vtkNew<vtkFloatArray> ids;
  ids->SetName(vtkOpacitySegments::GetIdsName());
  ids->SetNumberOfTuples(8);
  ids->FillValue(0.0f);
  scene.Data->GetPointData()->AddArray(ids);
  CheckOpaque(check, "ids of another type", scene, messages, "not those of vtkOpacitySegments");
  vtkNew<vtkOpacitySegments> filter;
  Scene good;
  good.GetOptimization()->SetForegroundWeight(0.0);
  good.Data->GetPointData()->AddArray(MakeArray(1, { 0, 0, 0, 0, 0, 0, 0, 1e-4 }));
  filter->SetInputData(good.Data);
  good.Mapper->SetInputConnection(filter->GetOutputPort());
  CheckOpaque(check, "ids of the filter", good, messages, "");

  // Ids that single precision cannot tell apart are told once, and each point is an element.
  for (int id : { vtkOpacitySegments::LargestNumberOfSegments - 1,
         int{ vtkOpacitySegments::LargestNumberOfSegments }, 1 << 24, 2147483647 })
  {
    const bool isGood = id < vtkOpacitySegments::LargestNumberOfSegments;
    Scene large;
    large.GetOptimization()->SetForegroundWeight(0.0);
    filter->SetInputData(large.Data);
    filter->Update();
    large.Data->ShallowCopy(filter->GetOutput());
    large.Data->GetPointData()->AddArray(MakeArray(1, { 0, 0, 0, 0, 0, 0, 0, 1e-4 }));
    large.Data->GetPointData()->GetArray(vtkOpacitySegments::GetIdsName())->SetComponent(5, 2, id);
    const std::string name = "id " + std::to_string(id);
    vtkFourierOpacityVertices vertices;
    vtkFourierOpacityVertices::Settings settings;
    settings.ArrayName = "Importance";
    vertices.Update(large.Data, settings);
    check(vertices.GetWarnings().size() == (isGood ? 0 : 1), name + ": number of warnings");
    check((vertices.GetElements() != nullptr) == isGood &&
        vertices.GetNumberOfElements() == (isGood ? id + 1 : 8),
      name + ": each point is an element where ids are not good");
    if (!isGood)
    {
      CheckOpaque(check, name, large, messages, "has the id " + std::to_string(id));
      // Neither by another range.
      large.Mapper->SetImportanceRange(0.0, 2e-4);
      CheckOpaque(check, name + ", another range", large, messages, "");
    }
  }
}

void CheckEmpty(Checks& check, Messages* messages)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPolyData> onlyPoints;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(0.5, 0.5, 0.5);
  onlyPoints->SetPoints(points);
  onlyPoints->GetPointData()->AddArray(MakeArray(1, { 0.0, 1.0 }));
  for (int method = 0; method < 6; ++method)
  {
    Scene scene;
    scene.GetOptimization()->SetBlending(method);
    scene.GetOptimization()->SetImportance(method % 2);
    for (vtkPolyData* data : { nothing.Get(), onlyPoints.Get() })
    {
      scene.Mapper->SetInputData(data);
      scene.Stage::Render();
      const Picture picture = scene.Stage::Render();
      check(picture.At(11, 16) == Background && picture.At(27, 16) == Blue,
        "nothing is drawn of nothing");
      // Nothing has no array.
      messages->TakeWarnings("importance");
      check(messages->IsQuiet(), "nothing else is said about nothing");
    }
    // Something again.
    scene.Data->GetPointData()->AddArray(MakeArray(1, { 0, 0, 0, 0, 0, 0, 0, 0.25 }));
    scene.Mapper->SetInputData(scene.Data);
    scene.GetOptimization()->SetForegroundWeight(0.0);
    const Picture picture = scene.Stage::Render();
    check(picture.At(11, 16) != Background,
      "something is drawn after nothing, " + std::string(MethodNames[method]));
    check(messages->IsQuiet(), "something after nothing: nothing is said");
  }
  Scene none;
  none.Mapper->SetInputDataObject(nullptr);
  const Picture picture = none.Stage::Render();
  check(messages->TakeErrors("No input") >= 0, "no input");
  check(picture.At(27, 16) == Blue, "no input: the rest of the scene is drawn");
  check(messages->IsQuiet(), "no input: nothing else is said");
}

void CheckSetters(Checks& check, Messages* messages)
{
  vtkNew<Optimization> by;
  struct
  {
    const char* Name;
    std::function<void(double)> Set;
    std::function<double()> Get;
    double Lowest, Highest;
    bool IsWhole;
  } setters[] = {
#define LS_VALUE(name, lowest, highest)                                                            \
  { #name, [&](double value) { by->Set##name(value); }, [&]() { return by->Get##name(); }, lowest, \
    highest, false }
#define LS_NUMBER(name, lowest, highest)                                                           \
  {                                                                                                \
#name, [&](double value) { by->Set##name(static_cast<int>(value)); },                          \
      [&]() { return static_cast<double>(by->Get##name()); }, lowest, highest, true                \
  }
    LS_VALUE(RegularizationWeight, 1e-6, 1e6),
    LS_VALUE(ForegroundWeight, 0.0, 1e6),
    LS_VALUE(BackgroundWeight, 0.0, 1e6),
    LS_VALUE(Emphasis, 0.01, 100.0),
    LS_VALUE(TransitionTime, 0.0, 60.0),
    LS_VALUE(OpaqueThreshold, 0.5, 1.0),
    LS_NUMBER(SmoothingIterations, 0, 1000),
    LS_NUMBER(NumberOfBands, 1, 16),
    LS_NUMBER(Subset, 1, 10000),
    LS_NUMBER(ImportanceReduction, 1, 8),
    LS_NUMBER(DepthReduction, 1, 8),
    LS_NUMBER(Blending, 0, 5),
    LS_NUMBER(Importance, 0, 1),
    LS_NUMBER(DepthScale, 0, 1),
    LS_NUMBER(AccumulationFrames, 1, 4096),
    LS_NUMBER(MaximumListMemory, 1, 1048576),
#undef LS_VALUE
#undef LS_NUMBER
  };
  for (const auto& setter : setters)
  {
    const std::string name = setter.Name;
    check(setter.Get() >= setter.Lowest && setter.Get() <= setter.Highest, name + ": default");
    for (double good : { setter.Lowest, setter.Highest })
    {
      const vtkMTimeType time = by->GetMTime();
      const bool isSame = setter.Get() == good;
      setter.Set(good);
      check(setter.Get() == good, name + ": an end of the range");
      check(isSame || by->GetMTime() > time, name + ": modified");
      const vtkMTimeType after = by->GetMTime();
      setter.Set(good);
      check(by->GetMTime() == after, name + ": modified by a change only");
    }
    const double old = setter.Get();
    const vtkMTimeType time = by->GetMTime();
    std::vector<double> wrong{ setter.Lowest - 1.0, setter.Highest + 1.0, -1e9, 1e9 };
    if (!setter.IsWhole)
    {
      wrong.insert(wrong.end(), { NaN, Infinity, -Infinity });
    }
    for (double bad : wrong)
    {
      setter.Set(bad);
      std::ostringstream range;
      range << name << " ";
      check(messages->TakeErrors(range.str()) == 1, name + ": one error with its name");
      check(setter.Get() == old && by->GetMTime() == time, name + ": the value stays");
      setter.Set(bad);
      std::ostringstream ends;
      if (setter.IsWhole)
      {
        ends << "must be from " << static_cast<int>(setter.Lowest) << " to "
             << static_cast<int>(setter.Highest);
      }
      else
      {
        ends << "must be from " << setter.Lowest << " to " << setter.Highest;
      }
      check(messages->TakeErrors(ends.str()) == 1, name + ": the range is named");
    }
  }

  vtkNew<vtkFourierOpacityMapper> mapper;
  for (double bad : { NaN, Infinity })
  {
    mapper->SetImportanceRange(bad, 1.0);
    mapper->SetImportanceRange(0.0, bad);
    check(messages->TakeErrors("ImportanceRange") == 2 && mapper->GetImportanceRange()[0] == 1.0 &&
        mapper->GetImportanceRange()[1] == 0.0,
      "range of importance");
  }
  for (int bad : { -1, 1 << 24 })
  {
    mapper->SetNumberOfLineSegments(bad);
    mapper->SetNumberOfPatches(bad);
    check(messages->TakeErrors(" to 16777215") == 2 && mapper->GetNumberOfLineSegments() == 0 &&
        mapper->GetNumberOfPatches() == 500,
      "numbers of segments and patches");
  }
  mapper->SetNumberOfLineSegments((1 << 24) - 1);
  mapper->SetNumberOfPatches(1);
  check(messages->IsQuiet(), "the rest of the setters say nothing");

  // An optimization of its own where there is none.
  mapper->SetOptimization(by);
  check(mapper->GetOptimization() == by, "shared optimization");
  mapper->SetOptimization(nullptr);
  check(mapper->GetOptimization() && mapper->GetOptimization() != by, "own optimization");
  std::ostringstream text;
  mapper->Print(text);
  check(text.str().find("TightDepth") != std::string::npos &&
      text.str().find("ImportanceRange: 1 0") != std::string::npos,
    "all is printed");
}
}

int TestFourierOpacityBadInput(int, char*[])
{
  Checks check;
  const KeptDisplay kept;
  auto messages = Listen();
  CheckArrays(check, messages);
  CheckSegments(check, messages);
  CheckEmpty(check, messages);
  CheckSetters(check, messages);
  return check.GetResult();
}
