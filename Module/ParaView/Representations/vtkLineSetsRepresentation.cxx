// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsRepresentation.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkInformation.h"
#include "vtkLineSetsBlocks.h"
#include "vtkLineSetsShare.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::vtkLineSetsRepresentation()
  : Blocks(new vtkLineSetsBlocks)
  , Shared(new vtkLineSetsShare)
{
  // A line mapper draws less while the user interacts by itself, from the same model.
  this->SuppressLOD = true;
}

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::~vtkLineSetsRepresentation() = default;

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::SetLineMapper(vtkPolyDataMapper* mapper)
{
  if (!mapper || mapper == this->Mapper)
  {
    return;
  }
  this->Mapper->Delete();
  this->LODMapper->Delete();
  this->Mapper = mapper;
  this->Mapper->Register(this);
  this->LODMapper = mapper;
  this->LODMapper->Register(this);
  // Connects the new mapper with all else.
  this->SetupDefaults();
  this->MarkModified();
}

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkLineSetsRepresentation::GetLineMapper()
{
  return vtkPolyDataMapper::SafeDownCast(this->Mapper);
}

//------------------------------------------------------------------------------
int vtkLineSetsRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request != vtkPVView::REQUEST_RENDER())
  {
    const int done = this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
    if (done && request == vtkPVView::REQUEST_UPDATE() && !this->GetUseDataPartitions())
    {
      // The view parts space by these lines, but they are handed on here, not by the view.
      vtkPVRenderView::SetOrderedCompositingConfiguration(
        inInfo, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
    }
    return done;
  }
  // The superclass would give the composite data set to the mapper.
  if (!this->vtkPVDataRepresentation::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  vtkDataObject* data = vtkPVView::GetDeliveredPiece(inInfo, this);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  if (data)
  {
    this->PopulateBlockAttributes(attributes, data);
  }
  this->Actor->SetEnableLOD(0);
  // What is measured depends on what colours the lines.
  this->UpdateColoringParameters();
  vtkPolyData* lines = this->Share(this->Blocks->Join(data, attributes), inInfo);
  vtkPolyDataMapper* mapper = this->GetLineMapper();
  if (mapper->GetInputDataObject(0, 0) != lines)
  {
    mapper->SetInputDataObject(lines);
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkLineSetsRepresentation::Share(vtkPolyData* lines, vtkInformation* viewInfo)
{
  this->Shared->SetView(vtkPVRenderView::SafeDownCast(viewInfo->Get(vtkPVView::VIEW())));
  if (!this->Shared->IsParted())
  {
    this->SetSharedMeasures(nullptr);
    this->SetRegion(this->Shared->GetRegion().data());
    return lines;
  }
  const Measures measures = this->Shared->Reduce(this->MeasureLines(lines), lines);
  const double margin = this->SetSharedMeasures(&measures);
  // A view that has data partitioned by ranks already leaves it where it is.
  const bool moves = this->Shared->IsOrdered() && !this->GetUseDataPartitions();
  vtkPolyData* mine = lines;
  if (moves)
  {
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    mine = this->Shared->Distribute(lines, matrix, margin);
  }
  this->SetRegion(
    moves ? this->Shared->GetRegion().data() : vtkLineSetsDistribution::GetOpenBox().data());
  return mine;
}

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::Measures vtkLineSetsRepresentation::MeasureLines(vtkPolyData* lines)
{
  Measures measures;
  lines->GetBounds(measures.Bounds);
  return measures;
}

//------------------------------------------------------------------------------
double vtkLineSetsRepresentation::SetSharedMeasures(const Measures* vtkNotUsed(measures))
{
  return 0.0;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::SetRegion(const double region[6])
{
  std::vector<vtkSmartPointer<vtkPlane>> planes;
  for (int side = 0; side < 6; ++side)
  {
    if (std::isfinite(region[side]))
    {
      double normal[3] = { 0.0, 0.0, 0.0 };
      double origin[3] = { 0.0, 0.0, 0.0 };
      normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
      origin[side / 2] = region[side];
      auto plane = vtkSmartPointer<vtkPlane>::New();
      plane->SetNormal(normal);
      plane->SetOrigin(origin);
      planes.push_back(plane);
    }
  }
  const auto isSame = [](vtkPlane* a, vtkPlane* b)
  {
    return std::equal(a->GetNormal(), a->GetNormal() + 3, b->GetNormal()) &&
      std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin());
  };
  if (std::equal(
        planes.begin(), planes.end(), this->RegionPlanes.begin(), this->RegionPlanes.end(), isSame))
  {
    return;
  }
  for (vtkPlane* plane : this->RegionPlanes)
  {
    this->Mapper->RemoveClippingPlane(plane);
  }
  for (vtkPlane* plane : planes)
  {
    this->Mapper->AddClippingPlane(plane);
  }
  this->RegionPlanes = planes;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
