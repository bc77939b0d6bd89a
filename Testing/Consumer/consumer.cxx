// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLineVoxelizer.h"
#include "vtkVoxelLineMapper.h"

#include "vtkNew.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  vtkNew<vtkVoxelLineMapper> mapper;
  std::cout << voxelizer->GetClassName() << " " << mapper->GetClassName() << "\n";
  return EXIT_SUCCESS;
}
