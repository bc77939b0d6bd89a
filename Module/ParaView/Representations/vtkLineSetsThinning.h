// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsThinning
 * @brief   every n-th line of a data set, to be drawn while the user interacts
 *
 * n follows from the number of points that are to remain: 100 D^2, where D = 10 + 150 r is the
 * number of divisions along an axis by which ParaView decimates surfaces at the LOD resolution r
 * (0 to 1, default 0.5: 722500 points); but it is at least 2. So the time of a frame has a bound,
 * however many lines there are. Of several ranks, each keeps an equal part of these points, by an n
 * that follows from its own lines. Points of hidden blocks count, so that showing and hiding leaves
 * the other lines as they are. Lines are kept whole, with their arrays; the points of the others
 * are left out. The result is kept as long as data and resolution are the same.
 */

#ifndef vtkLineSetsThinning_h
#define vtkLineSetsThinning_h

#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

class vtkDataObject;

class vtkLineSetsThinning
{
public:
  /// Whether the data has lines and neither polygons nor strips, of which none can be left out.
  static bool IsPossible(vtkDataObject* data);

  /// A data set of the same structure with fewer lines in each leaf.
  vtkDataObject* Thin(vtkDataObject* data, double resolution);

private:
  vtkSmartPointer<vtkDataObject> Data;
  vtkSmartPointer<vtkDataObject> Thinned;
  vtkTimeStamp ThinTime;
  double Resolution = -1.0;
};

#endif
// VTK-HeaderTest-Exclude: vtkLineSetsThinning.h
