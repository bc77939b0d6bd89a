// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the light model, the depth and the camera of the reference against VTK's own pictures: a
// finely tessellated sphere, drawn by vtkPolyDataMapper, against the same sphere as a capsule of
// no length, for all kinds of lights, materials, projections and for actors with a matrix.

#include "ImageMeasures.h"
#include "ReferenceRenderer.h"
#include "ReferenceTesting.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

using namespace linesets;

namespace
{
constexpr int Size = 200;

class SphereScene
{
public:
  SphereScene()
  {
    this->Source->SetThetaResolution(400);
    this->Source->SetPhiResolution(400);
    this->Source->SetRadius(1.0);
    this->Source->SetCenter(0.2, 0.1, -0.3);
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.2, 0.3, 0.1);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Size, Size);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(2.0, 1.5, 4.0);
    camera->SetFocalPoint(0.1, 0.0, 0.0);
    camera->SetClippingRange(1.0, 10.0);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetInterpolationToPhong();
    property->SetColor(0.9, 0.6, 0.3);
    property->SetAmbient(0.1);
    property->SetAmbientColor(0.2, 0.9, 0.5);
    property->SetDiffuse(0.6);
    property->SetSpecular(0.4);
    property->SetSpecularPower(12.0);
    property->SetSpecularColor(0.8, 1.0, 0.9);
  }

  void Compare(Checker& checker, const std::string& what)
  {
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> grabber;
    grabber->SetInput(this->Window);
    grabber->SetInputBufferTypeToRGB();
    grabber->ReadFrontBufferOff();
    grabber->Update();
    vtkNew<vtkFloatArray> depth;
    this->Window->GetZbufferData(0, 0, Size - 1, Size - 1, depth);

    CapsuleScene capsules;
    capsules.Capsules = { MakeCapsule(0.2, 0.1, -0.3, 0.2, 0.1, -0.3, 1.0) };
    ReferenceRenderer reference(capsules);
    reference.SetView(this->Renderer, this->Actor);
    // VTK's surfaces take the direction to the camera's position in parallel views, too.
    reference.Lights.ParallelView = false;
    ReferenceImage image;
    reference.Render(image);
    vtkNew<vtkImageData> picture;
    image.ToImageData(picture);

    // The silhouette of the polygons may differ by a pixel; all else may differ by rounding.
    int silhouette = 0;
    double largestDepth = 0.0;
    int largest = 0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const bool drawn = depth->GetValue(i) < 1.0f;
      if (drawn != (image.Curve[i] >= 0))
      {
        ++silhouette;
        continue;
      }
      largestDepth = std::max(largestDepth, std::fabs(depth->GetValue(i) - image.Depth[i]));
      for (int c = 0; c < 3; ++c)
      {
        const int x = i % Size;
        const int y = i / Size;
        largest = std::max(largest,
          std::abs(static_cast<int>(grabber->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c)) -
            static_cast<int>(picture->GetScalarComponentAsDouble(x, y, 0, c))));
      }
    }
    std::cout << what << ": largest difference " << largest << ", silhouette " << silhouette
              << " pixels, depth " << largestDepth << "\n";
    checker.Check(largest <= 2, what + ": colours");
    checker.Check(silhouette <= 10, what + ": silhouette");
    checker.Check(largestDepth < 2e-3, what + ": depth");
  }

  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void SetPlacement(vtkLight* light, double x, double y, double z)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.2, 0.0, -0.2);
}

void CheckBothProjections(Checker& checker, SphereScene& scene, const std::string& what)
{
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Compare(checker, what + ", perspective");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.4);
  scene.Compare(checker, what + ", parallel");
}

void CheckLights(Checker& checker, SphereScene& scene)
{
  CheckBothProjections(checker, scene, "headlight");
  scene.Actor->SetScale(1.0, 0.6, 1.3);
  scene.Actor->RotateZ(30.0);
  CheckBothProjections(checker, scene, "headlight on a stretched actor");
  scene.Actor->GetProperty()->LightingOff();
  CheckBothProjections(checker, scene, "no lighting");
}

void CheckLightKit(Checker& checker, SphereScene& scene)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(scene.Renderer);
  CheckBothProjections(checker, scene, "light kit");
}

void CheckSceneLights(Checker& checker, SphereScene& scene)
{
  vtkNew<vtkLight> directional;
  SetPlacement(directional, 3.0, -1.0, 2.0);
  directional->SetDiffuseColor(0.9, 0.5, 0.4);
  directional->SetIntensity(0.7);
  scene.Renderer->AddLight(directional);
  CheckBothProjections(checker, scene, "directional light");
  vtkNew<vtkLight> positional;
  SetPlacement(positional, 1.0, 2.5, 1.5);
  positional->PositionalOn();
  positional->SetConeAngle(120.0);
  positional->SetAttenuationValues(0.4, 0.3, 0.1);
  scene.Renderer->AddLight(positional);
  CheckBothProjections(checker, scene, "attenuated point light");
  positional->SetConeAngle(25.0);
  positional->SetExponent(3.0);
  CheckBothProjections(checker, scene, "spot light");
}

// In parallel views all points are seen from the same direction: a light that is the same
// everywhere gives them the colour of a point in the middle of a perspective view.
void CheckParallelView(Checker& checker, SphereScene& scene)
{
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  LightSet lights = LightSet::FromRenderer(scene.Renderer);
  checker.Check(lights.ParallelView, "a parallel view is taken for one");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  checker.Check(
    !LightSet::FromRenderer(scene.Renderer).ParallelView, "a perspective view is taken for one");

  lights.Complexity = 2;
  lights.Lights.resize(1);
  lights.Lights[0].Direction[0] = 0.6;
  lights.Lights[0].Direction[2] = -0.8;
  Material material;
  material.Diffuse = 0.5;
  material.Specular = 0.5;
  material.SpecularPower = 8.0;
  const double normal[3] = { -0.28, 0.0, 0.96 };
  const double aside[3] = { 2.0, -1.0, -3.0 };
  const double middle[3] = { 0.0, 0.0, -3.0 };
  double parallel[3];
  double expected[3];
  double perspective[3];
  Shade(lights, material, nullptr, aside, normal, parallel);
  lights.ParallelView = false;
  Shade(lights, material, nullptr, middle, normal, expected);
  Shade(lights, material, nullptr, aside, normal, perspective);
  checker.Check(
    std::fabs(parallel[0] - expected[0]) < 1e-12, "the view direction in parallel views");
  checker.Check(std::fabs(parallel[0] - perspective[0]) > 0.01, "the two kinds of views differ");
}
}

int TestReferenceLighting(int, char*[])
{
  Checker checker;
  // All windows live until the end: an X server may reset itself when the last one closes.
  SphereScene scenes[3];
  CheckLights(checker, scenes[0]);
  CheckLightKit(checker, scenes[1]);
  CheckSceneLights(checker, scenes[2]);
  CheckParallelView(checker, scenes[2]);
  return checker.GetExitCode();
}
