// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The geometry of the benchmark. All is made from fixed seeds, and each scene has a point array
 * "speed" as its scalars, and one "importance" in [0,1] for opacity optimization.
 *
 * | name | lines x vertices | what | important |
 * |---|---|---|---|
 * | tornado | 1000 x 250 | streamlines of the tornado of Crawfis and Max | near the core |
 * | carotid | 4700 x 410 | streamlines of blood flow, from carotid.vti | high speed |
 * | turbulence | 50 000 x 220 | streamlines in a cube of divergence-free turbulence | high speed |
 * | forecast | 212 000 x 13 | path lines of an unsteady wind over a flat domain | updraft |
 * | lorenz | 10 000 x 250 | trajectories of the Lorenz attractor | between the lobes: near z axis |
 * | water | 4098 x 216 | field lines of a water molecule, from around the oxygen | near the atoms |
 * | points | 3 000 000 points | matter that gathers in a cosmic web (PointScene.h) | dense |
 * | surfaces | 20 of 200 x 250 | nested stream surfaces (SurfaceScene.h) | near the core |
 *
 * The counts are those of Kanzler et al., 2019, Table 1, for the first four, and, for water, close
 * to the 883 564 vertices of Mallo et al., 2005, Table 1; their data is not public. Points are of
 * the order of the sets of points of Baeza Rojo et al., 2019.
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
  /// Number of lines and of vertices per line; 0 means those of the table above. For points, Lines
  /// is their number and Vertices is 0; for surfaces, Lines is that of each surface, at least 2.
  vtkIdType Lines = 0;
  int Vertices = 0;
  /// Folder that holds carotid.vti.
  std::string DataFolder;
};

/// Names of the scenes, in the order of the table.
std::vector<std::string> GetSceneNames();

/// Whether a scene is made of lines; false for points and surfaces.
bool IsSceneOfLines(const std::string& name);

/// Throws std::invalid_argument where there is no scene of this name and size.
void CheckSceneOptions(const std::string& name, const SceneOptions& options);

/// Make a scene. Throws std::invalid_argument as CheckSceneOptions, std::runtime_error where the
/// data is missing.
vtkSmartPointer<vtkPolyData> MakeScene(const std::string& name, const SceneOptions& options);

/// Read a file, .vtp or legacy .vtk, of lines, or of vertices or polygons where it has no lines.
/// Throws std::runtime_error where that fails.
vtkSmartPointer<vtkPolyData> ReadScene(const std::string& fileName);
}

#endif
