// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests with a baseline picture share: the scene of the mappers' own pictures, and the end.
 */

#ifndef PictureTesting_h
#define PictureTesting_h

#include "VoxelLineMapperTesting.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindowInteractor.h"

namespace VoxelLineMapperTesting
{
/// Helices, coloured by scalars, that run through a sphere, seen from aside.
struct HelicesStage : Stage
{
  vtkSmartPointer<vtkActor> Actor;

  HelicesStage(vtkPolyDataMapper* mapper, double opacity)
    : Stage(300, 300)
  {
    mapper->SetInputDataObject(MakeHelices(8, 300));
    mapper->SetScalarRange(0.0, 1.0);
    this->Actor = this->Add(mapper, opacity);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetAmbient(0.1);
    property->SetDiffuse(0.9);
    property->SetSpecular(0.4);
    property->SetSpecularPower(30.0);
    this->AddSphere(0.3, 0.0, 0.2, 0.5);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(4.0, 3.0, 3.5);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCamera();
    camera->Zoom(1.4);
  }
};

/// Compare the window with the baseline, or leave it open to look at where the command line says
/// so. Returns the exit status of the test.
inline int FinishPicture(vtkRenderWindow* window, int argc, char* argv[])
{
  window->Render();
  const int result = vtkRegressionTestImage(window);
  if (result == vtkRegressionTester::DO_INTERACTOR)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->Start();
  }
  return !result;
}
}

#endif
