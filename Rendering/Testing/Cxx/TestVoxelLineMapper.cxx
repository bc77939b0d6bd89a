// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the picture of opaque lines, coloured by scalars, that run through a sphere.

#include "PictureTesting.h"

using namespace VoxelLineMapperTesting;

int TestVoxelLineMapper(int argc, char* argv[])
{
  vtkNew<vtkVoxelLineMapper> mapper;
  mapper->SetRadius(0.02);
  HelicesStage stage(mapper, 1.0);
  return FinishPicture(stage.Window, argc, argv);
}
