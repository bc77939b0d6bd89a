// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFourierOpacityRepresentation.h"

#include "vtkDataObject.h"
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
vtkFourierOpacityMapper* vtkFourierOpacityRepresentation::GetFourierOpacityMapper()
{
  return vtkFourierOpacityMapper::SafeDownCast(this->GetLineMapper());
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::SetImportanceArray(int vtkNotUsed(index),
  int vtkNotUsed(port), int vtkNotUsed(connection), int association, const char* name)
{
  vtkFourierOpacityMapper* mapper = this->GetFourierOpacityMapper();
  mapper->SetImportanceArrayName(GetArrayName(name));
  // Without a name ParaView may leave the association open.
  const bool isChosen = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  mapper->SetImportanceArrayAssociation(isChosen && !mapper->GetImportanceArrayName().empty()
      ? association
      : vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::SetUseImportanceRange(bool use)
{
  this->UseImportanceRange = use;
  this->UpdateImportanceRange();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::SetImportanceRange(double low, double high)
{
  this->ImportanceRange[0] = low;
  this->ImportanceRange[1] = high;
  this->UpdateImportanceRange();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::UpdateImportanceRange()
{
  vtkFourierOpacityMapper* mapper = this->GetFourierOpacityMapper();
  const double low = this->ImportanceRange[0];
  const double high = this->ImportanceRange[1];
  if (this->UseImportanceRange && low > high)
  {
    vtkErrorMacro("The importance range (" << low << ", " << high
                                           << ") does not ascend: its first value counts as "
                                              "unimportant. The range of the array is used.");
  }
  if (this->UseImportanceRange && !(low > high))
  {
    mapper->SetImportanceRange(low, high);
  }
  else
  {
    // By which the mapper takes the range of the array.
    mapper->SetImportanceRange(1.0, 0.0);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkFourierOpacityRepresentation::GetArraysInUse()
{
  vtkFourierOpacityMapper* mapper = this->GetFourierOpacityMapper();
  return { mapper->GetImportanceArrayName(), mapper->GetTangentArrayName(),
    mapper->GetSpecularPowerArrayName() };
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::CheckLines(vtkPolyData* lines)
{
  this->CheckColorArray(lines);
}

//------------------------------------------------------------------------------
double vtkFourierOpacityRepresentation::SetSharedMeasures(const Measures* vtkNotUsed(measures))
{
  return std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::SetRegion(const double region[6])
{
  this->GetFourierOpacityMapper()->SetRegion(region);
}

//------------------------------------------------------------------------------
void vtkFourierOpacityRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseImportanceRange: " << (this->UseImportanceRange ? "On" : "Off") << "\n";
  os << indent << "ImportanceRange: " << this->ImportanceRange[0] << " " << this->ImportanceRange[1]
     << "\n";
}
