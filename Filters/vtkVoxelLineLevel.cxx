// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineLevel.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineRepresentativesPrivate.h"

#include <string>

vtkStandardNewMacro(vtkVoxelLineLevel);

//------------------------------------------------------------------------------
vtkVoxelLineLevel::vtkVoxelLineLevel() = default;

//------------------------------------------------------------------------------
vtkVoxelLineLevel::~vtkVoxelLineLevel() = default;

//------------------------------------------------------------------------------
vtkVoxelLineModel* vtkVoxelLineLevel::GetOutput()
{
  return vtkVoxelLineModel::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkVoxelLineLevel::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineLevel::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineLevel::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  if (!vtkVoxelLineModel::GetData(outInfo))
  {
    vtkNew<vtkVoxelLineModel> model;
    outInfo->Set(vtkDataObject::DATA_OBJECT(), model);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineLevel::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::GetData(inputVector[0]);
  vtkVoxelLineModel* output = vtkVoxelLineModel::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  std::string error = model ? model->FindDefect() : std::string();
  if (error.empty())
  {
    const auto goesOn = [this](double progress)
    {
      this->UpdateProgress(progress);
      return !vtkLineSetsCompatibility::CheckAbort(this);
    };
    error = vtkVoxelLineRepresentatives::MakeLevel(model, this->Level, goesOn, output);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelLineLevel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
}
