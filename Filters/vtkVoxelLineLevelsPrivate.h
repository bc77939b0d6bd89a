// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which levels of detail a grid has: level 0 has the voxels of the grid, and each further level
 * half as many along each axis, rounded up, until there is a single one.
 */

#ifndef vtkVoxelLineLevelsPrivate_h
#define vtkVoxelLineLevelsPrivate_h

#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <string>

namespace vtkVoxelLineLevels
{

/// Voxels along an axis at a level: ceil(size / 2^level), by whole numbers.
inline int SizeOf(int size, int level)
{
  return size > 0 ? ((size - 1) >> level) + 1 : 0;
}

/// Number of levels of a grid; 0 where it has no voxels.
inline int CountLevels(const int dimensions[3])
{
  if (std::min({ dimensions[0], dimensions[1], dimensions[2] }) < 1)
  {
    return 0;
  }
  const int largest = std::max({ dimensions[0], dimensions[1], dimensions[2] });
  int levels = 1;
  while (SizeOf(largest, levels - 1) > 1)
  {
    ++levels;
  }
  return levels;
}

/// What is wrong with a level, or an empty string. A model without segments is empty at any level.
inline std::string FindLevelError(vtkVoxelLineModel* model, int level)
{
  const bool isEmpty = !model || model->GetNumberOfSegments() == 0;
  const int levels = isEmpty ? 0 : CountLevels(model->GetDimensions());
  if (level >= 0 && (isEmpty || level < levels))
  {
    return std::string();
  }
  const std::string text = "Level is " + std::to_string(level) + "; ";
  return text +
    (isEmpty ? std::string("it must be 0 or above.")
             : "the model has the levels 0 to " + std::to_string(levels - 1) + ".");
}

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineLevelsPrivate.h
