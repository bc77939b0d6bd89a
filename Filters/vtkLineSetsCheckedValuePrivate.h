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

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsCheckedValuePrivate.h
