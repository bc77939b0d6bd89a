// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The vector fields of the benchmark scenes.
 */

#ifndef SceneFields_h
#define SceneFields_h

#include "LineTracer.h"
#include "PeriodicGrid.h"

#include "vtkSmartPointer.h" // For the image

#include <array>   // For modes
#include <cstdint> // For seeds
#include <vector>  // For modes and grids

class vtkImageData;

namespace linesets
{
/**
 * The tornado of Crawfis and Max, "Texture splats for 3D scalar and vector field visualization",
 * 1993, in its common form at time 0, on the unit cube. At each height z the funnel has a centre
 * that winds about the middle and a radius R(z); air circles about the centre, slower outside the
 * funnel's wall, and rises in its core.
 */
class TornadoField : public VectorField
{
public:
  bool Evaluate(const double point[3], double time, double vector[3]) const override;

  /// Centre of the funnel at height z, and the distance from it at which air no longer circles.
  static void GetCore(double z, double center[2], double& radius);

  /// Distance of a point from the funnel's centre over that distance.
  static double GetCoreDistance(const double point[3]);
};

/// The attractor of Lorenz, 1963, with sigma = 10, rho = 28, beta = 8/3.
class LorenzField : public VectorField
{
public:
  bool Evaluate(const double point[3], double time, double vector[3]) const override;
};

/**
 * Electric field of a water molecule as three point charges, -2 at the origin (oxygen) and 1 at
 * both hydrogen atoms; lengths in angstrom. The domain is a cube of 12 angstrom without small
 * spheres about the charges.
 */
class WaterField : public VectorField
{
public:
  static constexpr double OxygenRadius = 0.1;
  bool Evaluate(const double point[3], double time, double vector[3]) const override;

  /// Distance to the nearest of the three atoms.
  static double GetAtomDistance(const double point[3]);
};

/**
 * Wind on a slab of 2 x 1 x 0.25 over times 0 to 1: a jet along x, travelling waves of a stream
 * function (divergence-free in the plane) that lean with height, and slow vertical waves that
 * vanish at the bottom and the top.
 */
class WindField : public VectorField
{
public:
  explicit WindField(std::uint64_t seed);
  bool Evaluate(const double point[3], double time, double vector[3]) const override;

private:
  struct Wave
  {
    double Amplitude;
    double Number[3];
    double Frequency;
    double Phase;
  };
  std::vector<Wave> Waves;
};

/**
 * Divergence-free turbulence with the energy spectrum k^(-5/3) for wave numbers 1 to 24: a sum of
 * random Fourier modes, sampled on a periodic grid of 128^3 points and interpolated linearly.
 * Clipped at the unit cube.
 */
class TurbulenceField : public VectorField
{
public:
  explicit TurbulenceField(std::uint64_t seed);
  bool Evaluate(const double point[3], double time, double vector[3]) const override;

private:
  static constexpr int Size = 128;
  PeriodicGrid Grid;
};

/**
 * Point vectors of an image, interpolated linearly; the domain ends where their length falls below
 * a threshold.
 */
class ImageField : public VectorField
{
public:
  /// Throws std::runtime_error where the image has no point vectors.
  ImageField(vtkImageData* image, double slowest);
  bool Evaluate(const double point[3], double time, double vector[3]) const override;

private:
  double Slowest;
  double Origin[3];
  double Spacing[3];
  int Dimensions[3];
  std::vector<std::array<float, 3>> Vectors;
};
}

#endif
