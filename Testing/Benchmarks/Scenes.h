// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The line sets of the benchmark. All are made from fixed seeds, and each has a point array
 * "speed" as its scalars.
 *
 * | name | lines x vertices | what |
 * |---|---|---|
 * | tornado | 1000 x 250 | streamlines of the tornado of Crawfis and Max |
 * | carotid | 4700 x 410 | streamlines of blood flow, from carotid.vti |
 * | turbulence | 50 000 x 220 | streamlines that fill a cube of divergence-free turbulence |
 * | forecast | 212 000 x 13 | path lines of an unsteady wind over a flat domain |
 * | lorenz | 10 000 x 250 | trajectories of the Lorenz attractor |
 * | water | 4098 x 216 | field lines of a water molecule, seeded on a subdivided sphere |
 *
 * The counts are those of Kanzler et al., 2019, Table 1, for the first four, and, for water, close
 * to the 883 564 vertices of Mallo et al., 2005, Table 1; their data is not public.
 */

#ifndef Scenes_h
#define Scenes_h

#include "vtkSmartPointer.h" // For the result
#include "vtkType.h"         // For vtkIdType

#include <string> // For names
#include <vector> // For names

class vtkPolyData;

namespace linesets
{
struct SceneOptions
{
  /// Number of lines and of vertices per line; 0 means those of the table above.
  vtkIdType Lines = 0;
  int Vertices = 0;
  /// Folder that holds carotid.vti.
  std::string DataFolder;
};

/// Names of the scenes, in the order of the table.
std::vector<std::string> GetSceneNames();

/// Make a scene. Throws std::invalid_argument for an unknown name, std::runtime_error where the
/// data is missing.
vtkSmartPointer<vtkPolyData> MakeScene(const std::string& name, const SceneOptions& options);

/// Read the lines of a file, .vtp or legacy .vtk. Throws std::runtime_error where that fails.
vtkSmartPointer<vtkPolyData> ReadScene(const std::string& fileName);
}

#endif
