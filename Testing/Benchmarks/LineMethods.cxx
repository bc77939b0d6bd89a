// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineMethods.h"

#include "JsonObject.h"

#include "vtkActor.h"
#include "vtkIlluminatedLineMapper.h"
#include "vtkLineIllumination.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <limits>

namespace linesets
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
LineTubeMethod::LineTubeMethod() = default;

//------------------------------------------------------------------------------
LineTubeMethod::~LineTubeMethod() = default;

//------------------------------------------------------------------------------
void LineTubeMethod::Prepare(BenchmarkInput& input)
{
  this->Segments = CountLineSegments(input.Geometry);
  this->Mapper->SetInputData(input.Geometry);
  this->SetMapper(this->Mapper, input);
  this->Actor->GetProperty()->RenderLinesAsTubesOn();
  this->Actor->GetProperty()->SetLineWidth(static_cast<float>(2.0 * input.PixelRadius));
}

//------------------------------------------------------------------------------
double LineTubeMethod::Update(BenchmarkInput& input)
{
  this->Mapper->SetInputData(input.Geometry);
  return NotANumber;
}

//------------------------------------------------------------------------------
void LineTubeMethod::Describe(JsonObject& object)
{
  object.Add("segments", this->Segments);
}

//------------------------------------------------------------------------------
LineMethod::LineMethod(const std::string& name)
{
  if (name == "lines")
  {
    this->Mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    return;
  }
  this->Illuminated = vtkSmartPointer<vtkIlluminatedLineMapper>::New();
  this->Mapper = this->Illuminated;
  vtkLineIllumination* illumination = this->Illuminated->GetIllumination();
  if (name == "illuminated-max")
  {
    illumination->SetModelToMaximumReflection();
  }
  else if (name == "illuminated-blinn")
  {
    illumination->SetReflectionToBlinn();
  }
  else if (name == "illuminated-direct")
  {
    illumination->SetEvaluationToDirect();
  }
}

//------------------------------------------------------------------------------
LineMethod::~LineMethod() = default;

//------------------------------------------------------------------------------
void LineMethod::Prepare(BenchmarkInput& input)
{
  this->Segments = CountLineSegments(input.Geometry);
  if (this->Illuminated)
  {
    this->Illuminated->GetIllumination()->SetStretchDynamicRange(input.Options.Stretch);
  }
  this->Mapper->SetInputData(input.Geometry);
  this->SetMapper(this->Mapper, input);
  this->Actor->GetProperty()->SetLineWidth(static_cast<float>(input.Options.LineWidth));
  this->Actor->GetProperty()->SetPointSize(static_cast<float>(input.Options.LineWidth));
}

//------------------------------------------------------------------------------
double LineMethod::Update(BenchmarkInput& input)
{
  this->Mapper->SetInputData(input.Geometry);
  return NotANumber;
}

//------------------------------------------------------------------------------
void LineMethod::Describe(JsonObject& object)
{
  if (this->Segments > 0)
  {
    object.Add("segments", this->Segments);
  }
  if (this->Illuminated)
  {
    object.Add("drawn", static_cast<long long>(this->Illuminated->GetNumberOfDrawnSegments()));
  }
}
}
