// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineDensity.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineSegmentsPrivate.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkVoxelLineDensity);

namespace
{

/// Placement of the voxel centres: extent, origin and spacing of the image.
struct Placement
{
  explicit Placement(vtkVoxelLineModel* model)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Extent[2 * axis + 1] = model ? model->GetDimensions()[axis] - 1 : -1;
      this->Spacing[axis] = model ? model->GetVoxelSize() : 1.0;
      this->Origin[axis] = model ? model->GetOrigin()[axis] + 0.5 * this->Spacing[axis] : 0.0;
    }
  }

  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  double Origin[3];
  double Spacing[3];
};

/// Sum of the lengths of the segments [first, last), in voxels.
double SumLengths(const vtkVoxelLineSegments::Reader& reader, vtkIdType first, vtkIdType last)
{
  double sum = 0.0;
  for (vtkIdType i = first; i < last; ++i)
  {
    double start[3];
    double end[3];
    reader.GetPoints(i, start, end);
    sum += std::sqrt(vtkMath::Distance2BetweenPoints(start, end));
  }
  return sum;
}

}

//------------------------------------------------------------------------------
vtkVoxelLineDensity::vtkVoxelLineDensity() = default;

//------------------------------------------------------------------------------
vtkVoxelLineDensity::~vtkVoxelLineDensity() = default;

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
  const Placement placement(vtkVoxelLineModel::GetData(inputVector[0]));
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), placement.Extent, 6);
  outInfo->Set(vtkDataObject::ORIGIN(), placement.Origin, 3);
  outInfo->Set(vtkDataObject::SPACING(), placement.Spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_FLOAT, 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelLineDensity::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkVoxelLineModel* model = vtkVoxelLineModel::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(outputVector);
  image->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->Level != 0)
  {
    vtkErrorMacro("Level is " << this->Level << "; the model has level 0 only.");
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1;
  }
  const std::string defect = model ? model->FindDefect() : std::string();
  if (!defect.empty())
  {
    vtkErrorMacro(<< defect);
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1;
  }
  if (!model || model->GetNumberOfSegments() == 0)
  {
    return 1;
  }

  const Placement placement(model);
  image->SetExtent(const_cast<int*>(placement.Extent));
  image->SetOrigin(placement.Origin);
  image->SetSpacing(placement.Spacing);
  vtkNew<vtkFloatArray> density;
  density->SetName("Density");
  density->SetNumberOfTuples(image->GetNumberOfPoints());
  density->FillValue(0.0f);
  image->GetPointData()->SetScalars(density);
  this->UpdateProgress(0.1);
  if (vtkLineSetsCompatibility::CheckAbort(this))
  {
    return 1;
  }

  const vtkVoxelLineSegments::Reader reader(model);
  const int* dimensions = model->GetDimensions();
  float* values = density->GetPointer(0);
  // Each voxel belongs to one brick, and its sum has one order: threads change nothing.
  vtkSMPTools::For(0, reader.GetNumberOfBricks(), 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType brick = begin; brick < end; ++brick)
      {
        reader.VisitVoxels(brick,
          [&](const int voxel[3], vtkIdType first, vtkIdType last)
          {
            const vtkIdType index = voxel[0] +
              dimensions[0] * (voxel[1] + static_cast<vtkIdType>(dimensions[1]) * voxel[2]);
            values[index] = static_cast<float>(this->Opacity * SumLengths(reader, first, last));
          });
      }
    });
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelLineDensity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
}
