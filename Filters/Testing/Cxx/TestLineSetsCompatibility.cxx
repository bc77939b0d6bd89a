// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
// Guards: the version header reports an algorithm's abort flag in every version of VTK.

#include "vtkLineSetsCompatibilityPrivate.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <iostream>

int TestLineSetsCompatibility(int, char*[])
{
  vtkNew<vtkSphereSource> algorithm;
  if (vtkLineSetsCompatibility::CheckAbort(algorithm))
  {
    std::cerr << "An algorithm that nobody stopped reports an abort.\n";
    return EXIT_FAILURE;
  }
  algorithm->SetAbortExecute(1);
  if (!vtkLineSetsCompatibility::CheckAbort(algorithm))
  {
    std::cerr << "An algorithm that was stopped reports no abort.\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
