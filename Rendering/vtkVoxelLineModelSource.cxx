// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLineModelSource.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkLineVoxelizer.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVoxelLineModel.h"

#include <algorithm>

namespace
{
// The array that colours the lines, in the copy of the input that the voxelizer gets.
constexpr const char* AttributeName = "vtkVoxelLineMapperAttribute";

// The smallest byte of a model's radii, but for segments without any width.
int FindSmallestByte(vtkVoxelLineModel* model)
{
  vtkUnsignedCharArray* radii = model->GetRadii();
  const unsigned char* bytes = radii->GetPointer(0);
  int smallest = 255;
  for (vtkIdType i = 0; i + 1 < radii->GetNumberOfValues(); i += 2)
  {
    const int least = std::min(bytes[i], bytes[i + 1]);
    smallest = bytes[i] + bytes[i + 1] > 0 ? std::min(smallest, least) : smallest;
  }
  return smallest;
}
}

//------------------------------------------------------------------------------
vtkVoxelLineModelSource::vtkVoxelLineModelSource()
  : Voxelizer(vtkSmartPointer<vtkLineVoxelizer>::New())
{
}

//------------------------------------------------------------------------------
vtkVoxelLineModelSource::~vtkVoxelLineModelSource() = default;

//------------------------------------------------------------------------------
void vtkVoxelLineModelSource::SetModel(vtkVoxelLineModel* model)
{
  if (this->Input)
  {
    // The old one's output is left to whom it was given.
    this->Voxelizer = vtkSmartPointer<vtkLineVoxelizer>::New();
  }
  this->Input = nullptr;
  this->Source = vtkVoxelLineColoring::Source();
  this->Model = model;
}

//------------------------------------------------------------------------------
double vtkVoxelLineModelSource::Build(
  vtkMapper* mapper, vtkPolyData* lines, const Parameters& parameters, std::string& warning)
{
  const bool sameInput =
    this->Input == lines && this->InputTime == lines->GetMTime() && this->Model;
  // Attributes that are not shown are neither made nor, where they have been made, thrown away.
  vtkVoxelLineColoring::Source source;
  if (mapper->GetScalarVisibility())
  {
    source = vtkVoxelLineColoring::Select(mapper, lines);
    warning = source.Warning;
  }
  else if (sameInput)
  {
    source = this->Source;
  }
  if (!sameInput || !(source == this->Source))
  {
    this->SetInput(mapper, lines, source);
  }
  this->SetParameters(parameters);

  const vtkMTimeType before = this->Model ? this->Model->GetMTime() : 0;
  const double start = vtkTimerLog::GetUniversalTime();
  this->Voxelizer->Update();
  this->Model = this->Voxelizer->GetOutput();
  return this->Model && this->Model->GetMTime() != before ? vtkTimerLog::GetUniversalTime() - start
                                                          : -1.0;
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelSource::SetParameters(const Parameters& parameters)
{
  this->Voxelizer->SetResolution(parameters.Resolution);
  this->Voxelizer->SetFaceBins(parameters.FaceBins);
  this->Voxelizer->SetInteriorTolerance(parameters.InteriorTolerance);
  this->Voxelizer->SetRadiusArrayName(parameters.RadiusArrayName);
  this->Voxelizer->SetAttributeComponent(this->Source.Component);
  this->Voxelizer->SetDirectColors(this->Source.Direct);
  this->Voxelizer->SetUseCustomBounds(parameters.UseCustomBounds);
  this->Voxelizer->SetUseCustomRanges(parameters.UseCustomRanges);
  // What is not used must not build the model again.
  if (parameters.UseCustomBounds)
  {
    this->Voxelizer->SetCustomBounds(parameters.Custom.Bounds);
  }
  if (parameters.UseCustomRanges)
  {
    this->Voxelizer->SetCustomAttributeRange(parameters.Custom.AttributeRange);
    this->Voxelizer->SetCustomMaximumRadius(parameters.Custom.MaximumRadius);
  }
}

//------------------------------------------------------------------------------
vtkLineVoxelizer::Measures vtkVoxelLineModelSource::Measure(
  vtkMapper* mapper, vtkPolyData* lines, const Parameters& parameters)
{
  vtkVoxelLineColoring::Source source;
  if (mapper->GetScalarVisibility())
  {
    source = vtkVoxelLineColoring::Select(mapper, lines);
  }
  vtkVoxelLineModelSource other;
  other.SetInput(mapper, lines, source);
  other.SetParameters(parameters);
  return other.Voxelizer->MeasureInput();
}

//------------------------------------------------------------------------------
void vtkVoxelLineModelSource::SetInput(
  vtkMapper* mapper, vtkPolyData* lines, const vtkVoxelLineColoring::Source& source)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(lines);
  vtkSmartPointer<vtkDataArray> array = vtkVoxelLineColoring::Convert(mapper, source);
  if (array)
  {
    // Under a name of its own, without changing the array of the input.
    auto named = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    named->ShallowCopy(array);
    named->SetName(AttributeName);
    vtkDataSetAttributes* data = source.PerCell
      ? static_cast<vtkDataSetAttributes*>(copy->GetCellData())
      : static_cast<vtkDataSetAttributes*>(copy->GetPointData());
    data->AddArray(named);
    this->Voxelizer->SetInputArrayToProcess(0, 0, 0,
      source.PerCell ? vtkDataObject::FIELD_ASSOCIATION_CELLS
                     : vtkDataObject::FIELD_ASSOCIATION_POINTS,
      AttributeName);
  }
  this->Voxelizer->SetGenerateAttributes(array != nullptr);
  this->Voxelizer->SetInputDataObject(copy);
  this->Input = lines;
  this->InputTime = lines->GetMTime();
  this->Source = source;
}

//------------------------------------------------------------------------------
bool vtkVoxelLineModelSource::HasTranslucentColors()
{
  if (this->Model &&
    (this->TranslucencyModel != this->Model || this->TranslucencyTime != this->Model->GetMTime()))
  {
    this->TranslucencyModel = this->Model;
    this->TranslucencyTime = this->Model->GetMTime();
    this->TranslucentColors = vtkVoxelLineColoring::HasTranslucentColors(this->Model);
  }
  return this->Model && this->TranslucentColors;
}

//------------------------------------------------------------------------------
double vtkVoxelLineModelSource::GetSmallestRadius()
{
  if (this->RadiusModel != this->Model || this->RadiusTime != this->Model->GetMTime())
  {
    this->RadiusModel = this->Model;
    this->RadiusTime = this->Model->GetMTime();
    this->SmallestRadius = this->Model->GetMaximumRadius() * FindSmallestByte(this->Model) / 255.0;
  }
  return this->SmallestRadius;
}
