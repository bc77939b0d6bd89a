// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that both engines draw the same picture through the mapper: with scalars, direct colours,
// radii, lights, clipping planes, the depth of the scene, in windows that come and go; that an
// engine which cannot do what is asked says so once and leaves the rest of the scene alone; and
// that the engine is chosen by itself.

#include "VoxelLineMapperTesting.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPlane.h"

#include <functional>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr int Native = vtkVoxelLineMapper::Native;
constexpr int Shader = vtkVoxelLineMapper::Shader;

struct Case
{
  std::string Name;
  std::function<void(vtkVoxelLineMapper*, vtkPolyData*)> Prepare;
};

std::vector<Case> MakeCases()
{
  const auto scalars = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  { mapper->SetScalarRange(0.1, 0.9); };
  const auto uniform = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  { mapper->ScalarVisibilityOff(); };
  const auto direct = [](vtkVoxelLineMapper*, vtkPolyData* lines)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      const auto byte = static_cast<double>((7 * i) % 256);
      colors->InsertNextTuple4(byte, 255.0 - byte, 128.0, 255.0 - 0.5 * byte);
    }
    lines->GetPointData()->SetScalars(colors);
  };
  const auto nan = [](vtkVoxelLineMapper*, vtkPolyData* lines)
  {
    vtkDataArray* values = lines->GetPointData()->GetScalars();
    for (vtkIdType i = 20; i < 60; ++i)
    {
      values->SetComponent(i, 0, vtkMath::Nan());
    }
  };
  const auto radii = [](vtkVoxelLineMapper* mapper, vtkPolyData* lines)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName("r");
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      values->InsertNextValue(0.06 * (0.52 + 0.48 * std::sin(0.2 * static_cast<double>(i))));
    }
    lines->GetPointData()->AddArray(values);
    mapper->SetRadiusArrayName("r");
  };
  const auto clipped = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(1.0, 0.5, -0.3);
    mapper->AddClippingPlane(plane);
  };
  const auto fine = [](vtkVoxelLineMapper* mapper, vtkPolyData*) { mapper->SetFaceBins(256); };
  const auto exact = [](vtkVoxelLineMapper* mapper, vtkPolyData*) { mapper->SetFaceBins(0); };
  const auto wide = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  {
    mapper->SetResolution(64);
    mapper->SetRadius(0.07);
  };
  const auto byLength = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  {
    mapper->SetRadius(0.07);
    mapper->OpacityByPathLengthOn();
  };
  const auto interactive = [](vtkVoxelLineMapper* mapper, vtkPolyData*)
  { mapper->SetQualityToInteractive(); };
  return { { "scalars", scalars }, { "one colour", uniform }, { "direct colours", direct },
    { "NaN", nan }, { "radii", radii }, { "clipped", clipped }, { "256 bins", fine },
    { "exact points", exact }, { "tubes of several voxels", wide },
    { "opacity by path length", byLength }, { "opaque, interactive", interactive },
    { "interactive", interactive } };
}

// Lines and a sphere, three lights.
void Arrange(Stage& stage, vtkVoxelLineMapper* mapper, double opacity)
{
  auto actor = stage.Add(mapper, opacity);
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(15.0);
  actor->SetScale(1.0, 1.2, 0.9);
  stage.AddSphere(0.3, 0.0, 0.2, 0.4);
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  stage.Renderer->AddLight(head);
  vtkNew<vtkLight> spot;
  spot->SetLightTypeToSceneLight();
  spot->PositionalOn();
  spot->SetPosition(2.0, 1.0, 3.0);
  spot->SetConeAngle(25.0);
  spot->SetAttenuationValues(0.5, 0.1, 0.0);
  stage.Renderer->AddLight(spot);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(3.0, 2.5, 3.5);
  camera->SetClippingRange(2.0, 9.0);
}

void CheckSamePictures(Checks& check)
{
  const std::vector<Case> cases = MakeCases();
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const Case& test = cases[i];
    for (double opacity : { 1.0, 0.3 })
    {
      // Shaders are slow to compile where OpenGL is software: opaque and transparent in turns.
      if (i > 0 && (opacity < 1.0) == (i % 2 == 0))
      {
        continue;
      }
      auto lines = MakeHelices(4, 120);
      vtkNew<vtkVoxelLineMapper> mapper;
      mapper->SetInputData(lines);
      mapper->SetResolution(32);
      mapper->SetRadius(0.03);
      test.Prepare(mapper, lines);
      Picture pictures[2];
      for (int engine : { Native, Shader })
      {
        Stage stage(90, 75);
        mapper->SetEngine(engine);
        Arrange(stage, mapper, opacity);
        pictures[engine == Shader] = stage.Render();
        check(mapper->GetEngineInUse() == engine, test.Name + ": the engine that was set");
      }
      const Difference difference = Compare(pictures[0], pictures[1]);
      check(GetCoverage(pictures[0], Background) > 0.1, test.Name + ": something is seen");
      // Single pixels at the edges of lines may fall to either side.
      check(difference.Part < 1e-3,
        test.Name + " at opacity " + std::to_string(opacity) + Describe(difference));
    }
  }
}

// The shader engine's model and textures belong to a window.
void CheckWindows(Checks& check)
{
  auto lines = MakeHelices(3, 100);
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(lines);
  mapper->SetResolution(32);
  mapper->SetRadius(0.03);
  mapper->SetEngineToShader();
  Picture first;
  {
    Stage one(60, 50);
    Arrange(one, mapper, 0.5);
    first = one.Render();
    check(mapper->GetGraphicsMemory() > mapper->GetModel()->GetNumberOfBytes() / 2,
      "the model counts as graphics memory");
    Stage two(50, 60);
    Arrange(two, mapper, 0.5);
    const Picture second = two.Render();
    check(Compare(first, one.Render()).Largest == 0, "the first of two windows again");
    check(Compare(second, two.Render()).Largest == 0, "the second of two windows again");
    one.Window->SetSize(40, 40);
    one.Render();
    one.Window->SetSize(60, 50);
    check(Compare(first, one.Render()).Largest == 0, "after a change of size");
    mapper->ReleaseGraphicsResources(one.Window);
    mapper->ReleaseGraphicsResources(one.Window);
    check(mapper->GetGraphicsMemory() == 0, "no graphics memory after release");
    check(Compare(first, one.Render()).Largest == 0, "after release");
  }
  Stage three(60, 50);
  Arrange(three, mapper, 0.5);
  check(Compare(first, three.Render()).Largest == 0, "in a new window");
}

vtkSmartPointer<vtkVoxelLineMapper> MakeShaderMapper()
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(MakeHelices(3, 100));
  mapper->SetResolution(32);
  mapper->SetRadius(0.03);
  mapper->SetEngineToShader();
  return mapper;
}

// What the engine made in one window must not be deleted in another one, where its numbers name
// what others made.
void CheckForeignContext(Checks& check)
{
  Stage bystanders(60, 50);
  auto native = MakeShaderMapper();
  native->SetEngineToNative();
  Arrange(bystanders, native, 0.5);
  auto mapper = MakeShaderMapper();
  Stage one(60, 50);
  Arrange(one, mapper, 0.5);
  const Picture first = one.Render();
  const Picture other = bystanders.Render();
  auto guest = bystanders.Add(mapper, 0.5);
  guest->SetPosition(0.2, 0.0, 0.0);
  const Picture both = bystanders.Render();
  check(Compare(first, one.Render()).Largest == 0, "the engine's first window after the other");
  check(
    Compare(both, bystanders.Render()).Largest == 0, "lines of two mappers in the other window");
  check(Compare(first, one.Render()).Largest == 0, "the first window again");
  // Now the engine's things lie in the first window, and the other one is current.
  bystanders.Renderer->RemoveActor(guest);
  guest = nullptr;
  bystanders.Window->MakeCurrent();
  one.Renderer->RemoveAllViewProps();
  mapper = nullptr;
  bystanders.Window->MakeCurrent();
  check(
    Compare(other, bystanders.Render()).Largest == 0, "the other window, after the mapper is gone");
}

void CheckLimit(Checks& check, Messages* messages)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(3, 100));
  mapper->SetResolution(32);
  mapper->SetRadius(0.03);
  for (int i = 0; i < 9; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(-5.0, 0.0, 0.0);
    plane->SetNormal(1.0, 0.0, 0.0);
    mapper->AddClippingPlane(plane);
  }
  mapper->SetEngineToShader();
  Stage stage(60, 50);
  Arrange(stage, mapper, 1.0);
  check(messages->IsQuiet(), "nothing said so far");
  const double sphereOnly = GetCoverage(stage.Render(), Background);
  stage.Render();
  check(messages->TakeErrors("9 clipping planes") == 1, "one error about too many planes");
  mapper->SetEngineToNative();
  const double all = GetCoverage(stage.Render(), Background);
  check(sphereOnly > 0.005 && all > sphereOnly + 0.05, "the rest of the scene is drawn");
}

void CheckChoice(Checks& check)
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetInputData(MakeHelices(2, 50));
  mapper->SetResolution(16);
  Stage stage(20, 20);
  Arrange(stage, mapper, 1.0);
  stage.Render();
  const std::string capabilities = stage.Window->ReportCapabilities();
  const bool software = capabilities.find("llvmpipe") != std::string::npos ||
    capabilities.find("softpipe") != std::string::npos;
  std::cout << "software: " << software << std::endl;
  check(
    mapper->GetEngineInUse() == (software ? Native : Shader), "the engine that suits the renderer");
}
}

int TestVoxelLineMapperEngines(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  CheckSamePictures(check);
  CheckWindows(check);
  CheckForeignContext(check);
  CheckLimit(check, messages);
  CheckChoice(check);
  check(messages->IsQuiet(), "no other errors and no warnings");
  return check.GetResult();
}
