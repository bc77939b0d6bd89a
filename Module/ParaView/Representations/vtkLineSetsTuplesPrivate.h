// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tuples of some of the points or cells.
 */

#ifndef vtkLineSetsTuplesPrivate_h
#define vtkLineSetsTuplesPrivate_h

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"

/// Copies the tuples with the ids, of all arrays, in the order of the ids. An id may occur again.
inline void vtkLineSetsCopyTuples(
  vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  // Else ids of the input, which tell what was selected, would be left out.
  to->CopyAllOn(vtkDataSetAttributes::COPYTUPLE);
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->CopyData(from, ids);
}

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsTuplesPrivate.h
