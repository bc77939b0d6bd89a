// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinesRepresentation.h"

#include "vtkLineGlobalIllumination.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkVoxelLineMapper.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkVoxelLinesRepresentation);

namespace
{
//------------------------------------------------------------------------------
bool HasGlobalIllumination(vtkVoxelLineMapper* mapper)
{
  vtkLineGlobalIllumination* global = mapper->GetGlobalIllumination();
  return global->GetShadows() != vtkLineGlobalIllumination::NoShadows ||
    global->GetOcclusion() != vtkLineGlobalIllumination::NoOcclusion;
}

//------------------------------------------------------------------------------
/// Those of the settings that what is measured depends on: the arrays of radii and colours.
std::string DescribeMeasured(vtkVoxelLineMapper* mapper)
{
  std::ostringstream text;
  text << mapper->GetRadiusArrayName() << '\n' << mapper->GetScalarVisibility();
  if (mapper->GetScalarVisibility())
  {
    const char* name = mapper->GetArrayName();
    vtkScalarsToColors* table = mapper->GetLookupTable();
    text << '\n'
         << (name ? name : "") << '\n'
         << mapper->GetScalarMode() << ' ' << mapper->GetArrayAccessMode() << ' '
         << mapper->GetArrayId() << ' ' << mapper->GetArrayComponent() << ' '
         << mapper->GetColorMode() << ' ' << table->GetVectorMode() << ' '
         << table->GetVectorComponent() << ' ' << table->GetVectorSize();
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::vtkVoxelLinesRepresentation()
{
  vtkNew<vtkVoxelLineMapper> mapper;
  this->SetLineMapper(mapper);
}

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::~vtkVoxelLinesRepresentation() = default;

//------------------------------------------------------------------------------
vtkVoxelLineMapper* vtkVoxelLinesRepresentation::GetVoxelLineMapper()
{
  return vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper());
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::SetRadiusArrayName(const char* name)
{
  this->GetVoxelLineMapper()->SetRadiusArrayName(GetArrayName(name));
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkVoxelLinesRepresentation::GetArraysInUse()
{
  return { this->GetVoxelLineMapper()->GetRadiusArrayName() };
}

//------------------------------------------------------------------------------
bool vtkVoxelLinesRepresentation::NeedsOrderedCompositing()
{
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  return this->Superclass::NeedsOrderedCompositing() || mapper->GetSubPixelCoverage() ||
    mapper->GetAccumulationFrames() > 1 || HasGlobalIllumination(mapper);
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::LeaveStaleMeasures()
{
  // Another array of radii or colours would be held against the ranges of the one before.
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  if (mapper->GetUseCustomRanges() && this->MeasuredSettings != DescribeMeasured(mapper))
  {
    mapper->SetUseCustomRanges(false);
  }
}

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::Measures vtkVoxelLinesRepresentation::MeasureLines(vtkPolyData* lines)
{
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  std::string settings = DescribeMeasured(mapper);
  if (this->MeasuredLines != lines || this->MeasuredLinesTime != lines->GetMTime() ||
    this->MeasuredSettings != settings)
  {
    this->Measured = mapper->MeasureLines(lines);
    this->MeasuredLines = lines;
    this->MeasuredLinesTime = lines->GetMTime();
    this->MeasuredSettings = std::move(settings);
  }
  return this->Measured;
}

//------------------------------------------------------------------------------
double vtkVoxelLinesRepresentation::SetSharedMeasures(const Measures* measures)
{
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  const bool hasBounds = measures && measures->Bounds[0] <= measures->Bounds[1];
  mapper->SetUseCustomBounds(hasBounds);
  mapper->SetUseCustomRanges(measures != nullptr);
  double margin = 0.0;
  if (hasBounds)
  {
    mapper->SetCustomBounds(measures->Bounds);
    mapper->SetCustomAttributeRange(measures->AttributeRange);
    mapper->SetCustomMaximumRadius(measures->MaximumRadius);
    // The tubes that reach into the part, and all of the lines in the voxels that these are in, by
    // which they are rounded. Thin tubes are as wide as a pixel, which should be no more than some
    // voxels.
    const double* bounds = measures->Bounds;
    const double side =
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
    const double voxel = side / mapper->GetResolution();
    const double fixed = mapper->GetRadius() > 0.0 ? mapper->GetRadius() : side / 512.0;
    const double radius = measures->MaximumRadius > 0.0 ? measures->MaximumRadius : fixed;
    margin = std::max(radius, 2.0 * voxel) + voxel;
    // Rays begin before the part.
    margin += mapper->GetOpacityByPathLength() ? 4.0 * radius + 2.0 * voxel : 0.0;
  }
  return HasGlobalIllumination(mapper) ? std::numeric_limits<double>::infinity() : margin;
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::SetRegion(const double region[6])
{
  this->GetVoxelLineMapper()->SetRegion(region);
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
