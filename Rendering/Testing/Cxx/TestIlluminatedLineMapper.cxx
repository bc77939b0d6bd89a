// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the picture of lit curves, coloured by scalars, that run through a sphere.

#include "PictureTesting.h"
#include "vtkIlluminatedLineMapper.h"

using namespace VoxelLineMapperTesting;

int TestIlluminatedLineMapper(int argc, char* argv[])
{
  vtkNew<vtkIlluminatedLineMapper> mapper;
  HelicesStage stage(mapper, 1.0);
  stage.Actor->GetProperty()->SetLineWidth(3.0);
  stage.Actor->GetProperty()->SetSpecular(0.6);
  stage.Actor->GetProperty()->SetSpecularPower(60.0);
  return FinishPicture(stage.Window, argc, argv);
}
