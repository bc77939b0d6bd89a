// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineGlobalIllumination.h"

#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLineGlobalIllumination);

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadows(int type)
{
  vtkLineSetsSetInRange<int>(this, "Shadows", this->Shadows, type, NoShadows, SoftShadows);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadowLevel(int level)
{
  vtkLineSetsSetInRange(this, "ShadowLevel", this->ShadowLevel, level, 1, 12);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadowConeAngle(double degrees)
{
  vtkLineSetsSetInRange(this, "ShadowConeAngle", this->ShadowConeAngle, degrees, 0.0, 60.0);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusion(int type)
{
  vtkLineSetsSetInRange<int>(
    this, "Occlusion", this->Occlusion, type, NoOcclusion, HemisphereTubes);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionRadius(double voxels)
{
  vtkLineSetsSetInRange(this, "OcclusionRadius", this->OcclusionRadius, voxels, 1.0, 4096.0);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionSamples(int samples)
{
  vtkLineSetsSetInRange(this, "OcclusionSamples", this->OcclusionSamples, samples, 1, 10000);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionStrength(double strength)
{
  vtkLineSetsSetInRange(this, "OcclusionStrength", this->OcclusionStrength, strength, 0.0, 10.0);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* shadows[] = { "NoShadows", "HardShadows", "LevelShadows", "SoftShadows" };
  const char* occlusions[] = { "NoOcclusion", "SphericalOcclusion", "HemisphereDensity",
    "HemisphereTubes" };
  os << indent << "Shadows: " << shadows[this->Shadows] << "\n";
  os << indent << "ShadowLevel: " << this->ShadowLevel << "\n";
  os << indent << "ShadowConeAngle: " << this->ShadowConeAngle << "\n";
  os << indent << "Occlusion: " << occlusions[this->Occlusion] << "\n";
  os << indent << "OcclusionRadius: " << this->OcclusionRadius << "\n";
  os << indent << "OcclusionSamples: " << this->OcclusionSamples << "\n";
  os << indent << "OcclusionStrength: " << this->OcclusionStrength << "\n";
}
