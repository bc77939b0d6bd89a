// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Setters of values that must lie in a range.
 */

#ifndef vtkLineSetsCheckedValuePrivate_h
#define vtkLineSetsCheckedValuePrivate_h

#include "vtkObject.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>

/// Set a member of an object and mark it modified, where that changes anything. A value out of
/// range, or NaN, is an error that names the range, and the member keeps its value.
template <typename T>
void vtkLineSetsSetInRange(
  vtkObject* self, const char* name, T& member, T value, T lowest, T highest)
{
  // NaN is in no range.
  if (!(value >= lowest && value <= highest))
  {
    vtkErrorWithObjectMacro(self, << name << " " << value << " is not valid: it must be from "
                                  << lowest << " to " << highest << ". It stays " << member << ".");
    return;
  }
  if (member != value)
  {
    member = value;
    self->Modified();
  }
}

/// Set the six sides of a box, infinite where it is open, and mark the object modified, where that
/// changes anything. A side that is NaN is an error, and all sides keep their values.
inline void vtkLineSetsSetRegion(vtkObject* self, double (&member)[6], const double value[6])
{
  if (std::any_of(value, value + 6, [](double side) { return std::isnan(side); }))
  {
    vtkErrorWithObjectMacro(self,
      "A side of Region is not a number. It must be one, or infinite where the region is "
      "open; all sides stay as they are.");
  }
  else if (!std::equal(value, value + 6, member))
  {
    std::copy_n(value, 6, member);
    self->Modified();
  }
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsCheckedValuePrivate.h
