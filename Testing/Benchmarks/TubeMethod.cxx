// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TubeMethod.h"

#include "JsonObject.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

#include <stdexcept>

namespace linesets
{
//------------------------------------------------------------------------------
TubeMethod::TubeMethod(const std::string& name)
  : Translucent(name != "tubes")
{
  vtkLineSetsCompatibility::SetUseOIT(this->Renderer.Get(), name == "oit");
  if (name == "peeling")
  {
    this->Renderer->SetUseDepthPeeling(true);
    this->Renderer->SetOcclusionRatio(0.0);
  }
  this->Filter->SetNumberOfSides(8);
  this->Filter->CappingOff();
  this->Filter->SetVaryRadiusToVaryRadiusOff();
}

//------------------------------------------------------------------------------
TubeMethod::~TubeMethod() = default;

//------------------------------------------------------------------------------
double TubeMethod::RunFilter(BenchmarkInput& input)
{
  const auto start = std::chrono::steady_clock::now();
  this->Filter->SetInputData(input.Geometry);
  this->Filter->SetRadius(input.Radius);
  this->Filter->Update();
  return GetMilliseconds(start);
}

//------------------------------------------------------------------------------
void TubeMethod::Prepare(BenchmarkInput& input)
{
  if (this->Translucent && input.Options.Opacity >= 1.0)
  {
    throw std::runtime_error("needs an opacity below 1");
  }
  if (this->Name == "peeling")
  {
    // vtkRenderer documents 0 as no limit, but vtkDualDepthPeelingPass then peels nothing and
    // blends all tubes in the order of the cells.
    this->Peels = input.Options.Peels;
    this->Renderer->SetMaximumNumberOfPeels(this->Peels > 0 ? this->Peels : VTK_INT_MAX);
  }
  this->Segments = CountLineSegments(input.Geometry);
  if (!input.Tubes)
  {
    input.TubeMilliseconds = this->RunFilter(input);
    // Apart from the filter's output, which changes where lines move.
    input.Tubes = vtkSmartPointer<vtkPolyData>::New();
    input.Tubes->ShallowCopy(this->Filter->GetOutput());
  }
  this->BuildMilliseconds = input.TubeMilliseconds;
  this->Mapper->SetInputData(input.Tubes);
  this->SetMapper(this->Mapper, input);
  this->Actor->GetProperty()->BackfaceCullingOn();
}

//------------------------------------------------------------------------------
double TubeMethod::Update(BenchmarkInput& input)
{
  const double milliseconds = this->RunFilter(input);
  this->Mapper->SetInputData(this->Filter->GetOutput());
  return milliseconds;
}

//------------------------------------------------------------------------------
void TubeMethod::Describe(JsonObject& object)
{
  vtkPolyData* tubes = this->Mapper->GetInput();
  // Positions and normals as floats, colours as bytes, strips as three indices per triangle.
  const long long points = tubes->GetNumberOfPoints();
  vtkCellArray* strips = tubes->GetStrips();
  const long long triangles = strips->GetNumberOfConnectivityIds() - 2 * strips->GetNumberOfCells();
  if (this->Peels > 0)
  {
    object.Add("peels", this->Peels);
  }
  const int colorBytes = tubes->GetPointData()->GetScalars() ? 4 : 0;
  object.Add("gpu_bytes", points * (24 + colorBytes) + triangles * 12);
  object.Add("segments", this->Segments);
}
}
