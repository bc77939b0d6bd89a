// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMLineMapperProxy.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

vtkStandardNewMacro(vtkSMLineMapperProxy);

//------------------------------------------------------------------------------
vtkSMLineMapperProxy::vtkSMLineMapperProxy() = default;

//------------------------------------------------------------------------------
vtkSMLineMapperProxy::~vtkSMLineMapperProxy() = default;

//------------------------------------------------------------------------------
vtkTypeUInt32 vtkSMLineMapperProxy::FindDrawingLocation()
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(this->GetClientSideObject());
  if (!mapper)
  {
    return this->Location;
  }
  auto* lines = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const bool hasLines = lines && lines->GetNumberOfPoints() > 0;
  return hasLines ? vtkPVSession::CLIENT : vtkPVSession::RENDER_SERVER;
}

//------------------------------------------------------------------------------
void vtkSMLineMapperProxy::UpdatePropertyInformation()
{
  this->CreateVTKObjects();
  const vtkTypeUInt32 location = this->Location;
  this->Location = this->FindDrawingLocation();
  this->Superclass::UpdatePropertyInformation();
  this->Location = location;
}

//------------------------------------------------------------------------------
void vtkSMLineMapperProxy::UpdatePropertyInformation(vtkSMProperty* property)
{
  this->CreateVTKObjects();
  const vtkTypeUInt32 location = this->Location;
  this->Location = this->FindDrawingLocation();
  this->Superclass::UpdatePropertyInformation(property);
  this->Location = location;
}

//------------------------------------------------------------------------------
void vtkSMLineMapperProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
