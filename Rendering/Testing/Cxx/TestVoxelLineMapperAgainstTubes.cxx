// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards that the mapper fits into VTK's scene: camera, actor's matrix, lights, property and depth
// must mean the same for it as for polygons. The picture is held against vtkTubeFilter with many
// sides, drawn by vtkPolyDataMapper, together with a sphere that the lines run through.

#include "VoxelLineMapperTesting.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkTubeFilter.h"

#include <functional>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double Radius = 0.04;

struct Setting
{
  std::string Name;
  double Opacity = 1.0;
  std::function<void(vtkActor*)> Place;
  std::function<void(vtkRenderer*)> View;
};

Picture Draw(vtkMapper* mapper, const Setting& setting, bool tubes)
{
  Stage stage(300, 240);
  auto actor = stage.Add(mapper, setting.Opacity);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(1.0, 0.6, 0.2);
  property->SetAmbient(0.15);
  property->SetAmbientColor(0.5, 0.5, 1.0);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.4);
  property->SetSpecularPower(12.0);
  property->SetSpecularColor(0.8, 1.0, 0.9);
  // A tube is one layer with us.
  property->SetBackfaceCulling(tubes && setting.Opacity < 1.0);
  if (setting.Place)
  {
    setting.Place(actor);
  }
  auto sphere = stage.AddSphere(0.3, 0.2, 0.1, 0.5);
  sphere->SetUserMatrix(actor->GetMatrix());
  vtkRenderer* renderer = stage.Renderer;
  if (tubes && setting.Opacity < 1.0)
  {
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(100);
    renderer->SetOcclusionRatio(0.0);
  }
  renderer->ResetCamera();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->Azimuth(30.0);
  camera->Elevation(25.0);
  camera->Zoom(1.4);
  if (setting.View)
  {
    setting.View(renderer);
  }
  renderer->ResetCameraClippingRange();
  return stage.Render();
}

void AddLight(vtkRenderer* renderer, int type, double x, double y, double z)
{
  vtkNew<vtkLight> light;
  light->SetLightType(type);
  if (type != VTK_LIGHT_TYPE_HEADLIGHT)
  {
    light->SetPosition(x, y, z);
  }
  light->SetColor(0.5, 0.7, 0.6);
  light->SetIntensity(0.9);
  renderer->AddLight(light);
}

void AddSpot(vtkRenderer* renderer, double coneAngle)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetPosition(1.0, 2.5, 2.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(coneAngle);
  light->SetExponent(3.0);
  light->SetAttenuationValues(0.3, 0.1, 0.05);
  renderer->AddLight(light);
}

std::vector<Setting> MakeSettings()
{
  const auto parallel = [](vtkRenderer* renderer)
  { renderer->GetActiveCamera()->ParallelProjectionOn(); };
  const auto wide = [](vtkRenderer* renderer)
  {
    // Inside the lines, with a window off the axis.
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetViewAngle(100.0);
    camera->SetPosition(0.1, 0.15, 1.2);
    camera->SetWindowCenter(0.3, 0.2);
  };
  const auto place = [](vtkActor* actor)
  {
    actor->SetScale(1.0, 2.0, 0.7);
    actor->RotateX(20.0);
    actor->SetPosition(1e5, -3e5, 2e5);
  };
  const auto kit = [](vtkRenderer* renderer)
  {
    AddLight(renderer, VTK_LIGHT_TYPE_HEADLIGHT, 0.0, 0.0, 0.0);
    AddLight(renderer, VTK_LIGHT_TYPE_CAMERA_LIGHT, 1.0, 1.0, 1.0);
    AddLight(renderer, VTK_LIGHT_TYPE_SCENE_LIGHT, -2.0, 3.0, 1.0);
  };
  const auto spot = [](vtkRenderer* renderer)
  {
    AddLight(renderer, VTK_LIGHT_TYPE_HEADLIGHT, 0.0, 0.0, 0.0);
    AddSpot(renderer, 20.0);
  };
  const auto bulb = [](vtkRenderer* renderer) { AddSpot(renderer, 90.0); };
  const auto dark = [](vtkRenderer* renderer)
  {
    renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> light;
    light->SwitchOff();
    renderer->AddLight(light);
  };
  // Without light the colour is shown as it is, whatever the coefficients.
  const auto plain = [](vtkActor* actor)
  {
    actor->GetProperty()->SetAmbient(0.0);
    actor->GetProperty()->SetDiffuse(1.0);
  };
  const auto unlit = [plain](vtkActor* actor)
  {
    plain(actor);
    actor->GetProperty()->LightingOff();
  };
  return { { "a headlight", 1.0, {}, {} }, { "parallel", 1.0, {}, parallel },
    { "wide angle, off axis", 1.0, {}, wide }, { "stretched, far away", 1.0, place, {} },
    { "stretched, far away, parallel", 1.0, place, parallel }, { "three lights", 1.0, {}, kit },
    { "a spot light", 1.0, {}, spot }, { "a bulb", 1.0, {}, bulb },
    { "no light", 1.0, plain, dark }, { "unlit", 1.0, unlit, {} }, { "transparent", 0.3, {}, {} },
    { "transparent, stretched, far away", 0.3, place, {} } };
}
}

int TestVoxelLineMapperAgainstTubes(int, char*[])
{
  Checks check;
  const KeptDisplay display;
  auto lines = MakeHelices();
  lines->GetPointData()->SetScalars(nullptr);

  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(lines);
  tube->SetRadius(Radius);
  tube->SetNumberOfSides(32);
  tube->CappingOff();
  vtkNew<vtkPolyDataMapper> tubeMapper;
  tubeMapper->SetInputConnection(tube->GetOutputPort());
  tubeMapper->ScalarVisibilityOff();

  for (const Setting& setting : MakeSettings())
  {
    vtkNew<vtkVoxelLineMapper> mapper;
    mapper->SetInputData(lines);
    mapper->SetRadius(Radius);
    // Exact points: the difference is then that of the tubes, which are polygons with flat ends.
    mapper->SetFaceBins(0);
    mapper->SetInteriorTolerance(0.0);
    mapper->SetEarlyTermination(1.0);
    const Picture ours = Draw(mapper, setting, false);
    const Picture theirs = Draw(tubeMapper, setting, true);
    const Difference difference = Compare(ours, theirs);
    const double coverage = GetCoverage(theirs, Background);
    std::cout << setting.Name << ": coverage " << coverage << Describe(difference) << std::endl;
    check(coverage > 0.1, setting.Name + ": something is seen");
    // Tubes have 32 corners and flat ends, ours are round: pixels at their edges are other ones.
    check(difference.Rms < 10.0, setting.Name + ": root of the mean square" + Describe(difference));
    std::vector<int> errors;
    for (std::size_t i = 0; i < ours.Bytes.size(); ++i)
    {
      if (theirs.At(static_cast<int>(i / 3) % theirs.Width,
            static_cast<int>(i / 3) / theirs.Width) != Background)
      {
        errors.push_back(std::abs(int(ours.Bytes[i]) - int(theirs.Bytes[i])));
      }
    }
    std::sort(errors.begin(), errors.end());
    check(!errors.empty() && errors[errors.size() / 2] <= 3 && errors[errors.size() * 9 / 10] <= 10,
      setting.Name + ": the middle and nine tenths of the differences");
  }
  return check.GetResult();
}
