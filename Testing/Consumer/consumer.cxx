// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLineVoxelizer.h" // Public headers of both modules are there.
#include "vtkVoxelLineMapper.h"

#include "vtkNew.h"

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkVoxelLineMapper> mapper;
  std::cout << mapper->GetClassName() << "\n";
  return EXIT_SUCCESS;
}
