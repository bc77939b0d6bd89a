// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that mappers which draw one part of space each draw together what one mapper draws:
// regions, custom bounds and custom ranges. The pictures of the parts are laid over each other from
// the back to the front by the order of the actors, as processes do that share a picture.

#include "VoxelLineReferenceTesting.h"

#include "vtkActorCollection.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkPlane.h"

#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double Open = std::numeric_limits<double>::infinity();
constexpr double Cut = 0.07;

struct Setup
{
  std::string Name;
  double Opacity = 1.0;
  int Engine = vtkVoxelLineMapper::Native;
  bool ByPathLength = false;
  bool Shadows = false;
  bool Radii = false;
  std::array<double, 3> Position{ 3.0, 2.0, 2.0 };
  std::array<double, 3> Scale{ 1.0, 1.0, 1.0 };
};

vtkSmartPointer<vtkPolyData> MakeBundleWithArrays()
{
  std::vector<Curve> curves = MakeBundle(30, 80, 171);
  // Away from the cut, so that bounds differ.
  curves.push_back({ { -1.5, 0.1, 0.0 }, { -1.3, -0.2, 0.1 } });
  curves.push_back({ { 1.3, 0.1, 0.4 }, { 1.4, -0.2, 0.3 } });
  auto lines = MakeLines(curves);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  vtkNew<vtkFloatArray> values;
  values->SetName("Value");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    const double x = lines->GetPoint(i)[0];
    radii->InsertNextValue(static_cast<float>(0.03 + 0.015 * x));
    values->InsertNextValue(static_cast<float>(x));
  }
  lines->GetPointData()->AddArray(radii);
  lines->GetPointData()->AddArray(values);
  return lines;
}

// The lines that have a point on a side of the cut, or not far from it.
vtkSmartPointer<vtkPolyData> TakeSide(vtkPolyData* lines, bool low, double margin)
{
  auto side = vtkSmartPointer<vtkPolyData>::New();
  side->ShallowCopy(lines);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    bool isNear = false;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const double x = lines->GetPoint(ids->GetId(i))[0];
      isNear = isNear || (low ? x <= Cut + margin : x >= Cut - margin);
    }
    if (isNear)
    {
      cells->InsertNextCell(ids);
    }
  }
  side->SetLines(cells);
  return side;
}

vtkSmartPointer<vtkVoxelLineMapper> MakeMapper(vtkPolyData* lines, const Setup& setup)
{
  auto mapper = vtkSmartPointer<vtkVoxelLineMapper>::New();
  mapper->SetInputData(lines);
  mapper->SetResolution(24);
  mapper->SetEngine(setup.Engine);
  mapper->SetRadius(0.06);
  mapper->SetEarlyTermination(1.0);
  mapper->SetOpacityByPathLength(setup.ByPathLength);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Value");
  mapper->SetScalarRange(-1.0, 1.0);
  if (setup.Radii)
  {
    mapper->SetRadiusArrayName("Radius");
  }
  if (setup.Shadows)
  {
    mapper->GetGlobalIllumination()->SetShadowsToHard();
  }
  return mapper;
}

// A renderer for each of two parts, the second one over the first one.
struct PartStage : Stage
{
  vtkNew<vtkRenderer> Front;

  PartStage()
  {
    this->Window->SetNumberOfLayers(2);
    this->Window->AddRenderer(this->Front);
    this->Front->SetLayer(1);
    this->Front->SetActiveCamera(this->Renderer->GetActiveCamera());
  }
};

void AddPart(
  PartStage& stage, vtkVoxelLineMapper* mapper, const Setup& setup, const double region[6])
{
  mapper->SetRegion(region);
  const bool isFirst = stage.Renderer->GetActors()->GetNumberOfItems() == 0;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(setup.Opacity);
  (isFirst ? stage.Renderer : stage.Front)->AddActor(actor);
  std::array<double, 3> scale = setup.Scale;
  actor->SetScale(scale.data());
}

Picture Draw(PartStage& stage, const Setup& setup)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(setup.Position[0], setup.Position[1], setup.Position[2]);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(0.1, 20.0);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(5.0, 0.5, 2.0);
  stage.Renderer->AddLight(light);
  stage.Front->AddLight(light);
  return stage.Render();
}

Picture DrawWhole(vtkPolyData* lines, const Setup& setup)
{
  PartStage stage;
  const double region[6] = { -Open, Open, -Open, Open, -Open, Open };
  AddPart(stage, MakeMapper(lines, setup), setup, region);
  return Draw(stage, setup);
}

// From two sides of the cut, the farther one first. Each knows its lines only, if nothing needs
// all.
Picture DrawParts(vtkPolyData* lines, const Setup& setup, bool shares, double margin)
{
  const vtkLineVoxelizer::Measures all = MakeMapper(lines, setup)->MeasureLines(lines);
  PartStage stage;
  for (const bool isFar : { true, false })
  {
    const bool low = isFar == (setup.Position[0] > Cut);
    const bool needsAll = setup.Shadows || setup.ByPathLength;
    auto part = needsAll ? vtkSmartPointer<vtkPolyData>(lines) : TakeSide(lines, low, margin);
    auto mapper = MakeMapper(part, setup);
    mapper->SetUseCustomBounds(shares);
    mapper->SetCustomBounds(all.Bounds);
    mapper->SetUseCustomRanges(shares);
    mapper->SetCustomAttributeRange(all.AttributeRange);
    mapper->SetCustomMaximumRadius(all.MaximumRadius);
    const double cut = Cut * setup.Scale[0];
    const double region[6] = { low ? -Open : cut, low ? cut : Open, -Open, Open, -Open, Open };
    AddPart(stage, mapper, setup, region);
  }
  return Draw(stage, setup);
}

// The same with clipping planes, which open tubes.
Picture DrawClipped(vtkPolyData* lines, const Setup& setup)
{
  PartStage stage;
  for (const bool isFar : { true, false })
  {
    const bool low = isFar == (setup.Position[0] > Cut);
    auto mapper = MakeMapper(lines, setup);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(Cut, 0.0, 0.0);
    plane->SetNormal(low ? -1.0 : 1.0, 0.0, 0.0);
    mapper->AddClippingPlane(plane);
    const double region[6] = { -Open, Open, -Open, Open, -Open, Open };
    AddPart(stage, mapper, setup, region);
  }
  return Draw(stage, setup);
}

// The radius and a voxel.
constexpr double Margin = 0.06 + 3.1 / 24.0;

void CheckParts(Checks& check, vtkPolyData* lines, const Setup& setup)
{
  const Picture whole = DrawWhole(lines, setup);
  const Difference difference = Compare(whole, DrawParts(lines, setup, true, Margin));
  std::cout << setup.Name << ": " << Describe(difference) << "\n";
  check(difference.Rms < 1.0 &&
      (setup.ByPathLength ? difference.Part < 0.001 : difference.Largest <= 3),
    setup.Name + ": " + Describe(difference));
}

void CheckPictures(Checks& check, vtkPolyData* lines)
{
  for (const int engine : { vtkVoxelLineMapper::Native, vtkVoxelLineMapper::Shader })
  {
    const std::string name = engine == vtkVoxelLineMapper::Native ? "native" : "shader";
    Setup setup;
    setup.Engine = engine;
    setup.Name = name + ", opaque";
    CheckParts(check, lines, setup);
    setup.Opacity = 0.25;
    setup.Name = name + ", transparent";
    CheckParts(check, lines, setup);
    setup.Position = { -3.0, 1.0, -2.0 };
    setup.Scale = { 0.8, 1.1, 1.0 };
    setup.Name = name + ", transparent, scaled, from the other side";
    CheckParts(check, lines, setup);
    setup.Radii = true;
    setup.Name = name + ", transparent, radii";
    CheckParts(check, lines, setup);
  }
  Setup setup;
  setup.Opacity = 0.25;
  setup.ByPathLength = true;
  setup.Name = "by path length";
  CheckParts(check, lines, setup);
  setup.ByPathLength = false;
  setup.Position = { 0.5, 0.4, 4.0 };
  setup.Name = "along the cut";
  CheckParts(check, lines, setup);
  setup.Shadows = true;
  setup.Name = "shadows of what is outside";
  CheckParts(check, lines, setup);
}

void CheckSensitivity(Checks& check, vtkPolyData* lines)
{
  Setup setup;
  setup.Opacity = 0.25;
  const Picture whole = DrawWhole(lines, setup);
  check(Compare(whole, DrawParts(lines, setup, false, Margin)).Largest > 10,
    "grids of their own give another picture");
  check(Compare(whole, DrawParts(lines, setup, true, -0.3)).Largest > 10,
    "lines that are missing give another picture");
  check(
    Compare(whole, DrawClipped(lines, setup)).Largest > 10, "clipping planes give another picture");
}

void CheckProperties(Checks& check, Messages* messages, vtkPolyData* lines)
{
  auto mapper = MakeMapper(lines, Setup());
  const double wrong[6] = { 0.0, std::nan(""), 0.0, 1.0, 0.0, 1.0 };
  mapper->SetRegion(wrong);
  check(messages->TakeErrors("Region is not a number") == 1, "NaN is told");
  check(mapper->GetRegion()[0] == -Open, "the region stays");
  // A radius of its own follows from the shared bounds.
  mapper->SetRadius(0.0);
  mapper->UseCustomBoundsOn();
  mapper->SetCustomBounds(-4.0, 4.0, -2.0, 2.0, -2.0, 2.0);
  check(std::abs(mapper->GetRadiusInUse() - 8.0 / 512.0) < 1e-12, "automatic radius");
  check(std::abs(mapper->GetModel()->GetVoxelSize() - 8.0 / 24.0) < 1e-12, "voxels");
}
}

int TestVoxelLineMapperRegion(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto messages = Listen();
  auto lines = MakeBundleWithArrays();
  CheckPictures(check, lines);
  CheckSensitivity(check, lines);
  CheckProperties(check, messages, lines);
  check(messages->IsQuiet(), "nothing else is said");
  return check.GetResult();
}
