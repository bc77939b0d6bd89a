// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVoxelLinesRepresentation.h"

#include "vtkLineGlobalIllumination.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkVoxelLineMapper.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkVoxelLinesRepresentation);

namespace
{
bool HasGlobalIllumination(vtkVoxelLineMapper* mapper)
{
  vtkLineGlobalIllumination* global = mapper->GetGlobalIllumination();
  return global->GetShadows() != vtkLineGlobalIllumination::NoShadows ||
    global->GetOcclusion() != vtkLineGlobalIllumination::NoOcclusion;
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
void vtkVoxelLinesRepresentation::SetRadiusArrayName(const char* name)
{
  if (auto* mapper = vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper()))
  {
    mapper->SetRadiusArrayName(GetArrayName(name));
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkVoxelLinesRepresentation::GetArraysInUse()
{
  auto* mapper = vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper());
  if (!mapper)
  {
    return {};
  }
  return { mapper->GetRadiusArrayName() };
}

//------------------------------------------------------------------------------
vtkVoxelLineMapper* vtkVoxelLinesRepresentation::GetVoxelLineMapper()
{
  return vtkVoxelLineMapper::SafeDownCast(this->GetLineMapper());
}

//------------------------------------------------------------------------------
bool vtkVoxelLinesRepresentation::NeedsOrderedCompositing()
{
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  return this->Superclass::NeedsOrderedCompositing() || mapper->GetSubPixelCoverage() ||
    mapper->GetAccumulationFrames() > 1 || HasGlobalIllumination(mapper);
}

//------------------------------------------------------------------------------
vtkVoxelLinesRepresentation::Measures vtkVoxelLinesRepresentation::MeasureLines(vtkPolyData* lines)
{
  vtkVoxelLineMapper* mapper = this->GetVoxelLineMapper();
  if (this->MeasuredLines != lines || this->MeasuredLinesTime != lines->GetMTime() ||
    this->MeasuredMapperTime != mapper->GetMTime())
  {
    this->Measured = mapper->MeasureLines(lines);
    this->MeasuredLines = lines;
    this->MeasuredLinesTime = lines->GetMTime();
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
  this->MeasuredMapperTime = mapper->GetMTime();
  return HasGlobalIllumination(mapper) ? std::numeric_limits<double>::infinity() : margin;
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::SetRegion(const double region[6])
{
  this->GetVoxelLineMapper()->SetRegion(region);
  this->MeasuredMapperTime = this->GetVoxelLineMapper()->GetMTime();
}

//------------------------------------------------------------------------------
void vtkVoxelLinesRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
