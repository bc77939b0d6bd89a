// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkVoxelLineLightFields
 * @brief   what shadows and ambient occlusion are looked up in: densities, occlusion, a level
 *
 * Brings up to date what a frame's global illumination needs of a model, and nothing else: the
 * densities and the occlusion of voxels when the model or the opacity of its lines changed, the
 * representative lines when the model changed. Then it fills the frame's part about them.
 */

#ifndef vtkVoxelLineLightFields_h
#define vtkVoxelLineLightFields_h

#include "vtkVoxelLineFrame.h"
#include "vtkVoxelLineOcclusion.h"

#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkLineGlobalIllumination;
class vtkVoxelLineDensities;
class vtkVoxelLineLevel;
class vtkVoxelLineModel;

class VTKRENDERINGLINESETS_EXPORT vtkVoxelLineLightFields
{
public:
  /// Cones of soft shadows begin so far outside the tube, in voxels: densities reach about as far
  /// from the line itself. The measurement is in docs/global-illumination.md.
  static constexpr float ConeMargin = 0.75f;

  vtkVoxelLineLightFields();
  ~vtkVoxelLineLightFields();

  /**
   * For a frame with view, lights, colours and radius. progress is told how much of a long
   * computation is done, and returns whether to go on. Returns an empty string, or else why shadows
   * or occlusion are left out.
   */
  std::string Update(vtkVoxelLineFrame& frame, vtkVoxelLineModel* model,
    vtkLineGlobalIllumination* illumination, const std::function<bool(double)>& progress);

  /// The representative lines for a frame with LevelRays; nullptr without.
  vtkVoxelLineModel* GetLevelModel() const;

  /// Seconds that the last Update() took which had something to compute.
  double GetBuildTime() const { return this->BuildTime; }

  /// Bytes of what is kept on the processor.
  vtkIdType GetNumberOfBytes() const;

private:
  vtkVoxelLineLightFields(const vtkVoxelLineLightFields&) = delete;
  void operator=(const vtkVoxelLineLightFields&) = delete;

  vtkMTimeType GetLatestTime() const;
  bool UpdateDensities(const vtkVoxelLineFrame& frame, vtkVoxelLineModel* model);
  bool UpdateLevel(vtkVoxelLineFrame& frame, vtkVoxelLineModel* model, int level);

  vtkSmartPointer<vtkVoxelLineDensities> Densities;
  vtkVoxelLineOcclusion Occlusion;
  vtkSmartPointer<vtkVoxelLineLevel> Level;
  bool HasLevel = false;
  double BuildTime = 0.0;
};

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineLightFields.h
