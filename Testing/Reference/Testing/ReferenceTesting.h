// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tests of the reference renderer share.
 */

#ifndef ReferenceTesting_h
#define ReferenceTesting_h

#include "Capsule.h"
#include "Random.h"

#include <cmath>    // For fabs
#include <cstdlib>  // For EXIT_SUCCESS
#include <iostream> // For messages
#include <string>   // For messages

namespace linesets
{
/// Counts failures and tells the first ones.
class Checker
{
public:
  bool Check(bool condition, const std::string& what)
  {
    if (!condition && ++this->Failures <= 10)
    {
      std::cerr << "failed: " << what << "\n";
    }
    return condition;
  }

  bool CheckNear(double value, double expected, double tolerance, const std::string& what)
  {
    const bool near = std::fabs(value - expected) <= tolerance;
    return this->Check(near,
      what + ": " + std::to_string(value) + " instead of " + std::to_string(expected) +
        ", off by " + std::to_string(std::fabs(value - expected)));
  }

  int GetExitCode() const
  {
    if (this->Failures > 0)
    {
      std::cerr << this->Failures << " checks failed\n";
    }
    return this->Failures > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
  }

private:
  int Failures = 0;
};

inline Capsule MakeCapsule(double x0, double y0, double z0, double x1, double y1, double z1,
  double radius, vtkIdType curve = 0)
{
  Capsule capsule;
  const double start[3] = { x0, y0, z0 };
  const double end[3] = { x1, y1, z1 };
  for (int i = 0; i < 3; ++i)
  {
    capsule.Start[i] = start[i];
    capsule.End[i] = end[i];
  }
  capsule.StartRadius = radius;
  capsule.EndRadius = radius;
  capsule.Curve = curve;
  return capsule;
}

/// Random walks in the unit cube, with random radii up to `radius` and random values.
inline CapsuleScene MakeRandomCurves(
  int curves, int segments, double radius, std::uint64_t seed, double step = 0.15)
{
  CapsuleScene scene;
  for (int curve = 0; curve < curves; ++curve)
  {
    Random random(seed, curve);
    Capsule capsule;
    for (double& x : capsule.End)
    {
      x = random.Uniform();
    }
    capsule.EndRadius = radius * random.Uniform();
    capsule.EndValue = random.Uniform();
    capsule.Curve = curve;
    for (int i = 0; i < segments; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        capsule.Start[axis] = capsule.End[axis];
        capsule.End[axis] += random.Uniform(-step, step);
      }
      capsule.StartRadius = capsule.EndRadius;
      capsule.EndRadius = radius * random.Uniform();
      capsule.StartValue = capsule.EndValue;
      capsule.EndValue = random.Uniform();
      scene.Capsules.push_back(capsule);
    }
  }
  return scene;
}
}

#endif
