// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineGlobalIllumination.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLineGlobalIllumination);

//------------------------------------------------------------------------------
template <typename T>
void vtkLineGlobalIllumination::SetInRange(
  const char* name, T& member, T value, T lowest, T highest)
{
  // NaN is in no range.
  if (!(value >= lowest && value <= highest))
  {
    vtkErrorMacro(<< name << " " << value << " is not valid: it must be from " << lowest << " to "
                  << highest << ". It stays " << member << ".");
    return;
  }
  if (member != value)
  {
    member = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadows(int type)
{
  this->SetInRange<int>("Shadows", this->Shadows, type, NoShadows, SoftShadows);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadowLevel(int level)
{
  this->SetInRange("ShadowLevel", this->ShadowLevel, level, 1, 12);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetShadowConeAngle(double degrees)
{
  this->SetInRange("ShadowConeAngle", this->ShadowConeAngle, degrees, 0.0, 60.0);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusion(int type)
{
  this->SetInRange<int>("Occlusion", this->Occlusion, type, NoOcclusion, HemisphereTubes);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionRadius(double voxels)
{
  this->SetInRange("OcclusionRadius", this->OcclusionRadius, voxels, 1.0, 4096.0);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionSamples(int samples)
{
  this->SetInRange("OcclusionSamples", this->OcclusionSamples, samples, 1, 10000);
}

//------------------------------------------------------------------------------
void vtkLineGlobalIllumination::SetOcclusionStrength(double strength)
{
  this->SetInRange("OcclusionStrength", this->OcclusionStrength, strength, 0.0, 10.0);
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
