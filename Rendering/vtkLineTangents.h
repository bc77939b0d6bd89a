// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineTangents
 * @brief   directions of the lines of a vtkPolyData at their points
 *
 * At an inner point of a line the tangent runs from the point before to the one after (central
 * difference), at an end from or to the only neighbour. A closed line, whose last point is its
 * first one, by id or by coordinates, has its neighbours across the seam. Points that repeat the
 * one before have its tangent. Where the neighbours coincide, the tangent runs to the next one. A
 * point with a coordinate that is not finite parts the line and has a null tangent, as has a line
 * without extent.
 *
 * A point that is used more than once, by several lines or by one that crosses itself, has several
 * tangents: the first use keeps the point, each further one asks for a copy of it.
 *
 * Differences are taken in double precision, so that lines far from the origin keep their
 * directions. Results do not depend on the number of threads.
 */

#ifndef vtkLineTangents_h
#define vtkLineTangents_h

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;

struct VTKRENDERINGLINESETS_EXPORT vtkLineTangents
{
  /// Unit or null vectors: one for each point of the input, then one for each copy. Null where
  /// there are no lines.
  vtkSmartPointer<vtkFloatArray> Tangents;
  /// The points of the input that the copies copy.
  std::vector<vtkIdType> Copies;
  /// The lines with the ids of copies; null without copies.
  vtkSmartPointer<vtkCellArray> Lines;
  /// Lines of two points or more, all finite, that have no extent.
  vtkIdType LinesWithoutExtent = 0;
  /// Points of lines with a coordinate that is NaN or infinite, as often as lines use them.
  vtkIdType PointsNotFinite = 0;
  /// Ids of points in lines that do not exist; they have no tangent.
  vtkIdType InvalidIds = 0;

  /// Compute all of that from the lines of a data set.
  static vtkLineTangents Compute(vtkPolyData* input);
};

#endif

// VTK-HeaderTest-Exclude: vtkLineTangents.h
