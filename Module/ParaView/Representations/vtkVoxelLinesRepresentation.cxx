// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinesRepresentation.h"

#include "vtkVoxelLineMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkVoxelLinesRepresentation);

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::vtkVoxelLinesRepresentation()
{
  vtkNew<vtkVoxelLineMapper> mapper;
  this->SetLineMapper(mapper);
}

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::~vtkVoxelLinesRepresentation() = default;

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
