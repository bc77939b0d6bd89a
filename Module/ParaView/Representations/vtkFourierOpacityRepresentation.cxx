// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityRepresentation.h"

#include "vtkFourierOpacityMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

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
std::vector<std::string> vtkFourierOpacityRepresentation::GetArraysInUse()
{
  auto* mapper = vtkFourierOpacityMapper::SafeDownCast(this->GetLineMapper());
  if (!mapper)
  {
    return {};
  }
  return { mapper->GetImportanceArrayName(), mapper->GetTangentArrayName(),
    mapper->GetSpecularPowerArrayName() };
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::CheckLines(vtkPolyData* lines)
{
  this->CheckColorArray(lines);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
