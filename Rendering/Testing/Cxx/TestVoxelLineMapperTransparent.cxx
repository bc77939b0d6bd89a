// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the picture of lines of opacity 0.25, coloured by scalars, that run through a sphere.

#include "PictureTesting.h"

using namespace VoxelLineMapperTesting;

int TestVoxelLineMapperTransparent(int argc, char* argv[])
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetRadius(0.02);
  HelicesStage stage(mapper, 0.25);
  return FinishPicture(stage.Window, argc, argv);
}
