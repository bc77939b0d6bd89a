// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineGlobalIllumination
 * @brief   shadows and ambient occlusion that lines cast upon each other
 *
 * vtkLineIllumination tells how a line reflects the light that reaches it; this class, how much of
 * it does (Kanzler, Rautenhaus and Westermann, "A Voxel-based Rendering Pipeline for Large 3D Line
 * Sets", 2019, Secs. 4.1.2 and 4.1.3). An object holds the parameters; one may be shared by several
 * vtkVoxelLineMapper, each of which lights the lines of its own model. By default nothing is
 * computed.
 *
 * <b>Shadows</b> are cast for every light that is switched on, directional or positional, but for
 * headlights: from the camera's position no shadow is seen. Where headlights are all that there is,
 * as in a renderer that was given no light, a warning says so once.
 * - Hard shadows: a ray to the light is tested against the tubes.
 * - Level shadows: the same against the representative lines of a coarser level, one per voxel
 *   and 2^ShadowLevel times as wide (vtkVoxelLineLevel): fewer, wider and more contiguous shadows.
 * - Soft shadows: a cone to the light goes through the densities of the lines
 *   (vtkVoxelLineDensities), each part of its way through the level whose voxels are as wide as the
 *   cone is there. No pattern of single lines remains.
 *
 * <b>Ambient occlusion</b> dims light by how much of what surrounds a point is filled by lines,
 * within OcclusionRadius:
 * - Spherical occlusion: over all directions, independent of the way in which the surface
 *   faces, so that it tells how a line lies among others and does not vary around a tube. It is
 *   computed once per voxel, by cones through the densities, and interpolated. It is computed again
 *   when the model or the opacity of its lines changes, and not for camera or lights.
 * - Hemisphere by densities, hemisphere by tubes: over the directions above the surface, for each
 *   pixel by OcclusionSamples rays, through densities or against the tubes. They show what
 *   spherical occlusion stands for, at many times its cost.
 *
 * Occlusion multiplies all light, as vtkSSAOPass does, not just the ambient term, which most scenes
 * of VTK do not use.
 *
 * <b>Densities and opacity.</b> Lines that are spread at random with density d (length times
 * opacity per volume) and radius r let the part exp(-d 2r pi/4) per unit of length through, where
 * pi/4 is the mean of the sine of the angle between a line and the ray. That is what densities
 * are taken for, rather than for opacities as in the paper, so that wider tubes cast deeper
 * shadows, and results can be held against rays through the tubes themselves.
 *
 * <b>Clipping planes</b> of the mapper cut off shadows and occlusion of hemispheres: a line that is
 * clipped takes no light from others. Spherical occlusion, which belongs to the model, does not
 * know them.
 *
 * @sa vtkVoxelLineMapper vtkLineIllumination vtkVoxelLineDensities vtkVoxelLineLevel
 */

#ifndef vtkLineGlobalIllumination_h
#define vtkLineGlobalIllumination_h

#include "vtkObject.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

class VTKRENDERINGLINESETS_EXPORT vtkLineGlobalIllumination : public vtkObject
{
public:
  static vtkLineGlobalIllumination* New();
  vtkTypeMacro(vtkLineGlobalIllumination, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What stops light on its way.
  enum ShadowType
  {
    NoShadows = 0,    ///< nothing
    HardShadows = 1,  ///< the tubes
    LevelShadows = 2, ///< the representative lines of a level
    SoftShadows = 3   ///< the densities, along a cone
  };

  /// How what surrounds a point dims its light.
  enum OcclusionType
  {
    NoOcclusion = 0,        ///< not at all
    SphericalOcclusion = 1, ///< from all sides, per voxel
    HemisphereDensity = 2,  ///< from above the surface, by densities
    HemisphereTubes = 3     ///< from above the surface, by tubes
  };

  ///@{
  /**
   * What stops light on its way to a line (ShadowType): HardShadows are cast by the tubes,
   * LevelShadows by fewer and wider lines that stand for them, SoftShadows by the density of the
   * lines. Headlights cast none. Default NoShadows. Another value is an error.
   */
  virtual void SetShadows(int type);
  vtkGetMacro(Shadows, int);
  void SetShadowsToNone() { this->SetShadows(NoShadows); }
  void SetShadowsToHard() { this->SetShadows(HardShadows); }
  void SetShadowsToLevel() { this->SetShadows(LevelShadows); }
  void SetShadowsToSoft() { this->SetShadows(SoftShadows); }
  ///@}

  ///@{
  /**
   * Level of detail whose representative lines cast level shadows, 1 to 12; where the model
   * has fewer levels, its coarsest one is taken. Default 1, as in the paper. A value out of range
   * is an error.
   */
  virtual void SetShadowLevel(int level);
  vtkGetMacro(ShadowLevel, int);
  ///@}

  ///@{
  /**
   * Full opening angle of the cones of soft shadows, in degrees, 0 to 60: how large the light seems
   * to be. The wider, the softer, and the faster. Above about 37 degrees shadows get no softer any
   * more: coarser densities so near to a point would count lines behind it. Default 10. A value
   * out of range is an error.
   */
  virtual void SetShadowConeAngle(double degrees);
  vtkGetMacro(ShadowConeAngle, double);
  ///@}

  ///@{
  /**
   * How what surrounds a point dims its light (OcclusionType): SphericalOcclusion looks to all
   * sides of a voxel and is computed once; HemisphereDensity and HemisphereTubes look to above the
   * surface for each pixel, through densities or the tubes, at many times the cost. Default
   * NoOcclusion. Another value is an error.
   */
  virtual void SetOcclusion(int type);
  vtkGetMacro(Occlusion, int);
  void SetOcclusionToNone() { this->SetOcclusion(NoOcclusion); }
  void SetOcclusionToSpherical() { this->SetOcclusion(SphericalOcclusion); }
  void SetOcclusionToHemisphereDensity() { this->SetOcclusion(HemisphereDensity); }
  void SetOcclusionToHemisphereTubes() { this->SetOcclusion(HemisphereTubes); }
  ///@}

  ///@{
  /**
   * Radius of influence of ambient occlusion, in voxels of the model, 1 to 4096. Default 15, as in
   * the paper. A value out of range is an error.
   */
  virtual void SetOcclusionRadius(double voxels);
  vtkGetMacro(OcclusionRadius, double);
  ///@}

  ///@{
  /**
   * Number of rays per point for occlusion of hemispheres, 1 to 10000. Default 64. A value out of
   * range is an error.
   */
  virtual void SetOcclusionSamples(int samples);
  vtkGetMacro(OcclusionSamples, int);
  ///@}

  ///@{
  /**
   * Exponent s of ambient occlusion, 0 to 10: light is multiplied by (1 - o)^s with the occlusion o
   * of a hemisphere, and by min(1, 2 (1 - o))^s with that of the sphere, of which a surface hides
   * half by itself. Default 1. A value out of range is an error.
   */
  virtual void SetOcclusionStrength(double strength);
  vtkGetMacro(OcclusionStrength, double);
  ///@}

protected:
  vtkLineGlobalIllumination() = default;
  ~vtkLineGlobalIllumination() override = default;

  int Shadows = NoShadows;
  int ShadowLevel = 1;
  double ShadowConeAngle = 10.0;
  int Occlusion = NoOcclusion;
  double OcclusionRadius = 15.0;
  int OcclusionSamples = 64;
  double OcclusionStrength = 1.0;

private:
  vtkLineGlobalIllumination(const vtkLineGlobalIllumination&) = delete;
  void operator=(const vtkLineGlobalIllumination&) = delete;
};

#endif
