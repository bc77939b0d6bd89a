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
vtkIlluminatedLineMapper* vtkIlluminatedLinesRepresentation::GetIlluminatedLineMapper()
{
  return vtkIlluminatedLineMapper::SafeDownCast(this->GetLineMapper());
}

//------------------------------------------------------------------------------
void vtkIlluminatedLinesRepresentation::SetTangentArrayName(const char* name)
{
  this->GetIlluminatedLineMapper()->SetTangentArrayName(GetArrayName(name));
}

//------------------------------------------------------------------------------
void vtkIlluminatedLinesRepresentation::SetSpecularPowerArrayName(const char* name)
{
  this->GetIlluminatedLineMapper()->SetSpecularPowerArrayName(GetArrayName(name));
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIlluminatedLinesRepresentation::GetArraysInUse()
{
  vtkIlluminatedLineMapper* mapper = this->GetIlluminatedLineMapper();
  return { mapper->GetTangentArrayName(), mapper->GetSpecularPowerArrayName() };
}

//------------------------------------------------------------------------------
void vtkIlluminatedLinesRepresentation::CheckLines(vtkPolyData* lines)
{
  this->CheckColorArray(lines);
  this->CheckCells(lines);
}

//------------------------------------------------------------------------------
double vtkIlluminatedLinesRepresentation::SetSharedMeasures(const Measures* measures)
{
  vtkIlluminatedLineMapper* mapper = this->GetIlluminatedLineMapper();
  const bool hasBounds = measures && measures->Bounds[0] <= measures->Bounds[1];
  mapper->SetUseCustomBounds(hasBounds);
  if (hasBounds)
  {
    mapper->SetCustomBounds(measures->Bounds);
  }
  // A fragment belongs to where the axis of its line is.
  return 0.0;
}

//------------------------------------------------------------------------------
void vtkIlluminatedLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
