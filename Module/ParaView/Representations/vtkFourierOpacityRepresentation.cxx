// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityRepresentation.h"

#include "vtkFourierOpacityMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <limits>

vtkStandardNewMacro(vtkFourierOpacityRepresentation);

//------------------------------------------------------------------------------
vtkFourierOpacityRepresentation::vtkFourierOpacityRepresentation()
{
  vtkNew<vtkFourierOpacityMapper> mapper;
  this->SetLineMapper(mapper);
}

//------------------------------------------------------------------------------
vtkFourierOpacityRepresentation::~vtkFourierOpacityRepresentation() = default;

//------------------------------------------------------------------------------
double vtkFourierOpacityRepresentation::SetSharedMeasures(const Measures* vtkNotUsed(measures))
{
  return std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::SetRegion(const double region[6])
{
  vtkFourierOpacityMapper::SafeDownCast(this->GetLineMapper())->SetRegion(region);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
