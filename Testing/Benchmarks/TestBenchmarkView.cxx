// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the views of the benchmark: the camera turns by 2 degrees per frame at the same distance,
// and the light from the right is where a light of the camera is in the first view, but stays
// there.

#include "BenchmarkMethod.h"
#include "BenchmarkView.h"
#include "ReferenceTesting.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>

using namespace linesets;

int TestBenchmarkView(int, char*[])
{
  Checker checker;
  BenchmarkInput input;
  const double bounds[6] = { 10.0, 14.0, -3.0, 2.0, 100.0, 101.0 };
  std::copy_n(bounds, 6, input.Bounds);
  input.Camera = vtkSmartPointer<vtkCamera>::New();
  PlaceCamera(input, 0);
  double first[3];
  input.Camera->GetDirectionOfProjection(first);
  const double distance = input.Camera->GetDistance();

  vtkSmartPointer<vtkLight> light = MakeLightFromRight(input.Camera);
  vtkNew<vtkLight> follower;
  follower->SetLightTypeToCameraLight();
  follower->SetPosition(1.0, 0.4, 0.7);
  follower->SetFocalPoint(0.0, 0.0, 0.0);
  follower->SetTransformMatrix(input.Camera->GetCameraLightTransformMatrix());
  double expected[3];
  follower->GetTransformedPosition(expected);
  for (int frame = 0; frame < 2; ++frame)
  {
    PlaceCamera(input, frame);
    for (int i = 0; i < 3; ++i)
    {
      checker.CheckNear(light->GetPosition()[i], expected[i], 1e-9, "position of the light");
      checker.CheckNear(
        light->GetFocalPoint()[i], input.Camera->GetFocalPoint()[i], 1e-9, "aim of the light");
    }
  }
  checker.Check(light->LightTypeIsSceneLight() && !light->GetPositional(), "kind of light");

  double direction[3];
  input.Camera->GetDirectionOfProjection(direction);
  for (double* vector : { first, direction })
  {
    vector[2] = 0.0;
    vtkMath::Normalize(vector);
  }
  const double degrees =
    vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(first, direction));
  checker.CheckNear(degrees, 2.0, 1e-6, "turn per frame");
  checker.CheckNear(input.Camera->GetDistance(), distance, 1e-9, "distance");
  return checker.GetExitCode();
}
