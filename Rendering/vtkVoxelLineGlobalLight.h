// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineGlobalLight
 * @brief   shadows and ambient occlusion of one picture, as engines take them
 *
 * Part of vtkVoxelLineFrame; vtkVoxelLineLightFields fills it. Directions, positions and lengths
 * are grid-local.
 */

#ifndef vtkVoxelLineGlobalLight_h
#define vtkVoxelLineGlobalLight_h

#include "vtkType.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

class vtkVoxelLineDensities;
class vtkVoxelLineOcclusion;

struct vtkVoxelLineGlobalLight
{
  /// vtkLineGlobalIllumination::ShadowType, or none where no light casts any.
  int Shadows = 0;
  /// vtkLineGlobalIllumination::OcclusionType.
  int Occlusion = 0;
  /// For each light: direction to it (w = 0) or position (w = 1); w = -1: it casts no shadow.
  std::vector<glm::vec4> Lights;
  /// Width of a cone of soft shadows per its length, and where it begins.
  float ConeSpread = 0.0f;
  float ConeStart = 1.0f;
  /// Of ambient occlusion.
  float OcclusionRadius = 15.0f;
  int OcclusionSamples = 64;
  float OcclusionStrength = 1.0f;
  /// Optical depth per voxel for a density of 1.
  float Extinction = 0.0f;

  /// What is read, where it is needed; with the times of their contents.
  vtkVoxelLineDensities* Densities = nullptr;
  vtkMTimeType DensitiesTime = 0;
  vtkVoxelLineOcclusion* SphericalOcclusion = nullptr;
  vtkMTimeType SphericalOcclusionTime = 0;

  bool operator==(const vtkVoxelLineGlobalLight& other) const
  {
    // Lights may differ by the rounding of the view.
    return this->Shadows == other.Shadows && this->Occlusion == other.Occlusion &&
      std::equal(this->Lights.begin(), this->Lights.end(), other.Lights.begin(), other.Lights.end(),
        [](const glm::vec4& a, const glm::vec4& b)
        { return glm::length(a - b) <= 1e-5f * glm::length(a); }) &&
      this->ConeSpread == other.ConeSpread && this->ConeStart == other.ConeStart &&
      this->OcclusionRadius == other.OcclusionRadius &&
      this->OcclusionSamples == other.OcclusionSamples &&
      this->OcclusionStrength == other.OcclusionStrength && this->Extinction == other.Extinction &&
      this->Densities == other.Densities && this->DensitiesTime == other.DensitiesTime &&
      this->SphericalOcclusion == other.SphericalOcclusion &&
      this->SphericalOcclusionTime == other.SphericalOcclusionTime;
  }
};

#endif
