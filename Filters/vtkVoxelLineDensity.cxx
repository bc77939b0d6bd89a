// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineDensity.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVoxelLineDensities.h"
#include "vtkVoxelLineLevelsPrivate.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkVoxelLineDensity);

namespace
{

/// Placement of the voxel centres of a level: extent, origin and spacing of the image.
struct Placement
{
  Placement(vtkVoxelLineModel* model, int level)
  {
    if (!model || !vtkVoxelLineLevels::FindLevelError(model, level).empty())
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Extent[2 * axis + 1] =
        vtkVoxelLineLevels::SizeOf(model->GetDimensions()[axis], level) - 1;
      this->Spacing[axis] = std::ldexp(model->GetVoxelSize(), level);
      this->Origin[axis] = model->GetOrigin()[axis] + 0.5 * this->Spacing[axis];
    }
  }

  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
};

/// Write a level of densities into an image of the same size.
void CopyLevel(vtkVoxelLineDensities* densities, int level, vtkImageData* image)
{
  if (level > 0)
  {
    image->GetPointData()->SetScalars(densities->GetValues(level));
    return;
  }
  vtkNew<vtkFloatArray> density;
  density->SetName("Density");
  density->SetNumberOfValues(image->GetNumberOfPoints());
  image->GetPointData()->SetScalars(density);
  float* values = density->GetPointer(0);
  int size[3];
  densities->GetDimensions(0, size);
  vtkSMPTools::For(0, static_cast<vtkIdType>(size[1]) * size[2], 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          values[row * size[0] + x] = densities->GetVoxel(
            0, x, static_cast<int>(row % size[1]), static_cast<int>(row / size[1]));
        }
      }
    });
}

/// Hand the progress of the densities on to the filter, and its abort back.
void OnProgress(vtkObject* caller, unsigned long, void* filter, void* progress)
{
  vtkAlgorithm* algorithm = static_cast<vtkAlgorithm*>(filter);
  algorithm->UpdateProgress(0.9 * *static_cast<double*>(progress));
  if (vtkLineSetsCompatibility::CheckAbort(algorithm))
  {
    static_cast<vtkVoxelLineDensities*>(caller)->SetAbortBuild(true);
  }
}

}

//------------------------------------------------------------------------------
vtkVoxelLineDensity::vtkVoxelLineDensity() = default;

//------------------------------------------------------------------------------
vtkVoxelLineDensity::~vtkVoxelLineDensity() = default;

//------------------------------------------------------------------------------
void vtkVoxelLineDensity::SetOpacityFunction(vtkPiecewiseFunction* function)
{
  if (this->OpacityFunction != function)
  {
    this->OpacityFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkVoxelLineDensity::GetOpacityFunction() const
{
  return this->OpacityFunction;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkVoxelLineDensity::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->OpacityFunction ? std::max(time, this->OpacityFunction->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkVoxelLineDensity::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkVoxelLineModel");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineDensity::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int port = 0;
  if (vtkAlgorithm* producer = this->GetInputAlgorithm(0, 0, port))
  {
    producer->Update(port);
  }
  const Placement placement(vtkVoxelLineModel::GetData(inputVector[0]), this->Level);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), placement.Extent, 6);
  outInfo->Set(vtkDataObject::ORIGIN(), placement.Origin, 3);
  outInfo->Set(vtkDataObject::SPACING(), placement.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensity::SetOpacities(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities)
{
  densities->SetOpacity(this->Opacity);
  densities->SetUseColorOpacity(this->UseColorOpacity);
  if (!this->OpacityFunction || model->GetNumberOfSegments() == 0)
  {
    return;
  }
  if (model->GetAttributeKind() != vtkVoxelLineModel::Scalar)
  {
    vtkWarningMacro("OpacityFunction is set, but the model has no scalar attributes that it could "
                    "be applied to; all lines have Opacity.");
    return;
  }
  std::array<double, vtkVoxelLineDensities::TableSize> table;
  const double largest = model->GetHasNaNAttribute() ? 254.0 : 255.0;
  const double* range = model->GetAttributeRange();
  for (std::size_t byte = 0; byte < table.size(); ++byte)
  {
    const double fraction = static_cast<double>(byte) / largest;
    table[byte] = fraction > 1.0
      ? this->NaNOpacity
      : this->OpacityFunction->GetValue((1.0 - fraction) * range[0] + fraction * range[1]);
  }
  densities->SetOpacityTable(table.data());
}

//------------------------------------------------------------------------------
bool vtkVoxelLineDensity::BuildDensities(vtkVoxelLineModel* model, vtkVoxelLineDensities* densities)
{
  std::string error = model ? model->FindDefect() : std::string();
  if (error.empty())
  {
    error = vtkVoxelLineLevels::FindLevelError(model, this->Level);
  }
  if (error.empty() && !std::isfinite(this->Opacity))
  {
    error = "Opacity is " + std::to_string(this->Opacity) + "; it must be finite.";
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
    return false;
  }
  if (!model)
  {
    return false;
  }
  vtkNew<vtkCallbackCommand> onProgress;
  onProgress->SetCallback(OnProgress);
  onProgress->SetClientData(this);
  densities->AddObserver(vtkCommand::ProgressEvent, onProgress);
  this->SetOpacities(model, densities);
  const bool isBuilt = densities->Build(model);
  densities->RemoveObserver(onProgress);
  if (!isBuilt && !densities->GetAbortBuild())
  {
    // It has told why.
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  return isBuilt && densities->GetNumberOfLevels() > 0;
}

//------------------------------------------------------------------------------
int vtkVoxelLineDensity::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(outputVector);
  image->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNew<vtkVoxelLineDensities> densities;
  if (!this->BuildDensities(model, densities))
  {
    return 1;
  }
  Placement placement(model, this->Level);
  image->SetExtent(placement.Extent);
  image->SetOrigin(placement.Origin);
  image->SetSpacing(placement.Spacing);
  CopyLevel(densities, this->Level, image);
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "OpacityFunction: " << this->OpacityFunction.Get() << "\n";
  os << indent << "NaNOpacity: " << this->NaNOpacity << "\n";
  os << indent << "UseColorOpacity: " << (this->UseColorOpacity ? "On" : "Off") << "\n";
}
