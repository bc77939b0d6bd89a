// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelizeLinesFilter.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLineVoxelizer.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVoxelLineGeometry.h"

#include <cstring>

vtkStandardNewMacro(vtkVoxelizeLinesFilter);

//------------------------------------------------------------------------------
vtkVoxelizeLinesFilter::vtkVoxelizeLinesFilter() = default;

//------------------------------------------------------------------------------
vtkVoxelizeLinesFilter::~vtkVoxelizeLinesFilter() = default;

//------------------------------------------------------------------------------
void vtkVoxelizeLinesFilter::SetRadiusArrayName(const char* name)
{
  const std::string array = name && std::strcmp(name, "None") != 0 ? name : "";
  if (this->RadiusArrayName != array)
  {
    this->RadiusArrayName = array;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkVoxelizeLinesFilter::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkVoxelizeLinesFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  int numberOfOthers = 0;
  const std::vector<Block> blocks =
    FindBlocks(vtkDataObject::GetData(inputVector[0]), numberOfOthers);
  this->TellOthers(numberOfOthers);
  // Every rank takes part, whatever it has.
  double bounds[6];
  const bool hasLines = this->FindBounds(blocks, bounds);
  if (blocks.empty())
  {
    return 1;
  }

  vtkNew<vtkLineVoxelizer> voxelizer;
  this->SetUpVoxelizer(voxelizer, bounds);
  voxelizer->SetUseCustomBounds(hasLines);
  voxelizer->SetRadiusArrayName(this->RadiusArrayName);
  for (const Block& block : blocks)
  {
    voxelizer->AddInputDataObject(block.Lines);
  }
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputConnection(voxelizer->GetOutputPort());
  geometry->SetLevel(this->Level);
  geometry->SetJoin(this->Join);
  if (!this->RunInside(voxelizer, 0.0, 0.6) || !this->RunInside(geometry, 0.6, 1.0))
  {
    return 1;
  }
  output->ShallowCopy(geometry->GetOutput());
  // The connections of the voxelizer are the blocks.
  if (auto* inputs = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("InputId")))
  {
    for (vtkIdType i = 0; i < inputs->GetNumberOfValues(); ++i)
    {
      inputs->SetValue(i, blocks[static_cast<std::size_t>(inputs->GetValue(i))].FlatIndex);
    }
  }
  if (vtkDataArray* attribute = output->GetPointData()->GetArray("Attribute"))
  {
    attribute->SetName(this->GetChosenArrayName());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkVoxelizeLinesFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Join: " << (this->Join ? "On" : "Off") << "\n";
  os << indent << "RadiusArrayName: " << this->RadiusArrayName << "\n";
}
