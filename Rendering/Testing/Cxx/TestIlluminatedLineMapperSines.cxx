// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the picture that tells the two light models apart (Mallo et al. 2005, Fig. 3): a stack of
// sine curves, lit from the right. Upper half: with highlights, lower half: diffuse only. Left:
// maximum reflection, whose slopes to the left and to the right look alike. Right: cylinder
// averaging, where the light's side is plain to see.

#include "PictureTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLight.h"
#include "vtkLineIllumination.h"

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double Periods = 3.0;
const double Pi = std::acos(-1.0);

// Sine curves in planes of constant height, waving towards the viewer.
vtkSmartPointer<vtkPolyData> MakeSines(double low, double high)
{
  std::vector<Curve> curves;
  for (double y = low; y < high; y += 0.02)
  {
    Curve curve;
    for (int i = 0; i <= 240; ++i)
    {
      const double x = 2.0 * i / 240.0 - 1.0;
      curve.push_back({ x, y, 0.2 * std::sin(Periods * Pi * x) });
    }
    curves.push_back(curve);
  }
  return MakeLines(curves);
}

void AddSines(vtkRenderer* renderer, double low, double high, double specular, int model)
{
  vtkNew<vtkIlluminatedLineMapper> mapper;
  mapper->SetInputData(MakeSines(low, high));
  mapper->GetIllumination()->SetModel(model);
  mapper->GetIllumination()->StretchDynamicRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(0.4, 0.6, 1.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(specular);
  property->SetSpecularPower(40.0);
  property->SetLineWidth(2.0f);
}

// Mean brightness of the lines where they run towards the right and away from the viewer
// (sign 1), or towards him (sign -1), in the lower half.
double GetBrightness(const Picture& picture, int sign)
{
  double sum = 0.0;
  int count = 0;
  for (int y = picture.Height / 10; y < picture.Height * 4 / 10; ++y)
  {
    for (int i = 0; i < picture.Width; ++i)
    {
      // The view shows x from -1 to 1.
      const double x = 2.0 * (i + 0.5) / picture.Width - 1.0;
      if (sign * std::cos(Periods * Pi * x) < -0.5)
      {
        sum += picture.At(i, y)[1];
        ++count;
      }
    }
  }
  return sum / count;
}
}

int TestIlluminatedLineMapperSines(int argc, char* argv[])
{
  Checks check;
  Stage stage(400, 300);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  LookAlongZ(stage);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(1.0, 0.0, 0.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  stage.Renderer->AddLight(light);
  for (int model :
    { vtkLineIllumination::MaximumReflection, vtkLineIllumination::CylinderAveraging })
  {
    stage.Renderer->RemoveAllViewProps();
    stage.Window->SetSize(300, 300);
    AddSines(stage.Renderer, 0.05, 0.95, 0.6, model);
    AddSines(stage.Renderer, -0.95, -0.05, 0.0, model);
    const Picture picture = stage.Render();
    // z falls with x where the cosine is negative: these slopes face the light.
    const double lit = GetBrightness(picture, 1);
    const double away = GetBrightness(picture, -1);
    std::cout << "Model " << model << ": slopes to the light " << lit << ", away " << away << "\n";
    if (model == vtkLineIllumination::MaximumReflection)
    {
      check(std::abs(lit - away) < 0.02 * lit, "maximum reflection does not tell the light's side");
    }
    else
    {
      check(lit > 2.0 * away, "averaging tells the light's side");
    }
  }

  // Both side by side.
  stage.Renderer->RemoveAllViewProps();
  stage.Window->SetSize(400, 200);
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  AddSines(stage.Renderer, 0.05, 0.95, 0.6, vtkLineIllumination::MaximumReflection);
  AddSines(stage.Renderer, -0.95, -0.05, 0.0, vtkLineIllumination::MaximumReflection);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(0.0, 0.0, 0.0);
  right->SetActiveCamera(stage.Renderer->GetActiveCamera());
  right->AddLight(light);
  AddSines(right, 0.05, 0.95, 0.6, vtkLineIllumination::CylinderAveraging);
  AddSines(right, -0.95, -0.05, 0.0, vtkLineIllumination::CylinderAveraging);
  stage.Window->AddRenderer(right);
  const int result = FinishPicture(stage.Window, argc, argv);
  return check.GetResult() == EXIT_SUCCESS ? result : EXIT_FAILURE;
}
