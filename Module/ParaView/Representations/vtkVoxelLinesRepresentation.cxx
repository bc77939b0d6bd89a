// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinesRepresentation.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVoxelLineMapper.h"

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
void vtkVoxelLinesRepresentation::SetRadiusArrayName(const char* name)
{
  if (auto* mapper = vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper()))
  {
    mapper->SetRadiusArrayName(GetArrayName(name));
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkVoxelLinesRepresentation::GetArraysInUse()
{
  auto* mapper = vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper());
  if (!mapper)
  {
    return {};
  }
  return { mapper->GetRadiusArrayName() };
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
