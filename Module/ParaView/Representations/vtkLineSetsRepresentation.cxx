// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineSetsRepresentation.h"

#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkInformation.h"
#include "vtkLineSetsBlocks.h"
#include "vtkNew.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

//------------------------------------------------------------------------------
vtkLineSetsRepresentation::vtkLineSetsRepresentation()
  : Blocks(new vtkLineSetsBlocks)
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
  // ParaView observes the progress of every algorithm that has a proxy, and its client processes
  // events upon progress: in the middle of a picture those would draw other parts of the window and
  // leave their OpenGL context current.
  mapper->RemoveObservers(vtkCommand::ProgressEvent);
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
std::string vtkLineSetsRepresentation::GetArrayName(const char* name)
{
  return name && std::string(name) != "None" ? name : "";
}

//------------------------------------------------------------------------------
int vtkLineSetsRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request != vtkPVView::REQUEST_RENDER())
  {
    return this->Superclass::ProcessViewRequest(request, inInfo, outInfo);
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
  vtkPolyData* joined = this->Blocks->Join(data, attributes);
  vtkPolyDataMapper* mapper = this->GetLineMapper();
  if (mapper->GetInputDataObject(0, 0) != joined)
  {
    mapper->SetInputDataObject(joined);
  }
  this->Actor->SetEnableLOD(0);
  this->UpdateColoringParameters();
  return 1;
}

//------------------------------------------------------------------------------
void vtkLineSetsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
