// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineMerging
 * @brief   lines with the segments left out that are too short to be seen
 *
 * Line sets often have many points to a pixel, and the time to draw lines goes by the segment.
 * Consecutive segments of a line are merged into one piece, from the first point to the last, as
 * long as the piece is no longer than a given length, measured along the line, and deviates from
 * the line by no more than an eighth of it. For that, half of sqrt(length^2 - chord^2) is taken,
 * which no point of a curve of this length between the ends of this chord exceeds.
 */

#ifndef vtkLineMerging_h
#define vtkLineMerging_h

#include "vtkRenderingLineSetsModule.h" // For export macro

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

class VTKRENDERINGLINESETS_EXPORT vtkLineMerging
{
public:
  /// Points of a line whose number is a multiple of this are kept, so that a part of a line that
  /// begins at one is merged as the line is.
  static constexpr int BlockSize = 32;

  /**
   * Two point indices for each piece, line by line, in the order of the lines of the data.
   * Everything is kept that is longer than the length (in data units), or next to points that are
   * not finite. The result does not depend on threads.
   */
  static std::vector<unsigned int> GetIndices(vtkPolyData* data, double length);

  /// Length of the longest segment, in data units; segments that are not finite do not count.
  static double GetLongestSegment(vtkPolyData* data);

  /**
   * Length in data units that is nowhere longer than so many pixels on the screen, for what lies
   * within bounds (six numbers, data coordinates). Matrices act on columns: data to view
   * coordinates, and view to clip coordinates. 0 where the data may reach to the camera.
   */
  static double GetLength(double pixels, const double bounds[6], vtkMatrix4x4* viewFromData,
    vtkMatrix4x4* clipFromView, const int viewportSize[2]);
};

#endif

// VTK-HeaderTest-Exclude: vtkLineMerging.h
