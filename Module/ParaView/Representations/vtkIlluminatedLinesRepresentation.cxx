// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedLinesRepresentation.h"

#include "vtkIlluminatedLineMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkIlluminatedLinesRepresentation);

//------------------------------------------------------------------------------
vtkIlluminatedLinesRepresentation::vtkIlluminatedLinesRepresentation()
{
  vtkNew<vtkIlluminatedLineMapper> mapper;
  this->SetLineMapper(mapper);
}

//------------------------------------------------------------------------------
vtkIlluminatedLinesRepresentation::~vtkIlluminatedLinesRepresentation() = default;

//------------------------------------------------------------------------------
void vtkIlluminatedLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
