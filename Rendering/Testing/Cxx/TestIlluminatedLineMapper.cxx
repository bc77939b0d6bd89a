// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the picture of lit curves, coloured by scalars, that run through a sphere.

#include "VoxelLineMapperTesting.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindowInteractor.h"

using namespace VoxelLineMapperTesting;

int TestIlluminatedLineMapper(int argc, char* argv[])
{
  vtkNew<vtkIlluminatedLineMapper> mapper;
  mapper->SetInputData(MakeHelices(8, 300));
  mapper->SetScalarRange(0.0, 1.0);
  Stage stage(300, 300);
  auto actor = stage.Add(mapper, 1.0);
  actor->GetProperty()->SetLineWidth(3.0);
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetDiffuse(0.9);
  actor->GetProperty()->SetSpecular(0.6);
  actor->GetProperty()->SetSpecularPower(60.0);
  stage.AddSphere(0.3, 0.0, 0.2, 0.5);
  stage.Renderer->GetActiveCamera()->SetPosition(4.0, 3.0, 3.5);
  stage.Renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  stage.Renderer->ResetCamera();
  stage.Renderer->GetActiveCamera()->Zoom(1.4);
  stage.Window->Render();

  const int result = vtkRegressionTestImage(stage.Window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(stage.Window);
    interactor->Start();
  }
  return !result;
}
