// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards the intervals of lines in capsules and round cones, and their normals: each is compared
// with the distance function, which is found by a search along the axis.

#include "Capsule.h"
#include "ReferenceTesting.h"

#include "vtkMath.h"

using namespace linesets;

namespace
{
enum class Kind
{
  Capsule,
  Cone,
  Nested,
  Point,
  Needle,
  Count
};

Capsule MakeRandomCapsule(Random& random, Kind kind)
{
  Capsule capsule = MakeCapsule(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1),
    random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(0.05, 0.6));
  switch (kind)
  {
    case Kind::Cone:
      capsule.EndRadius = random.Uniform(0.0, 0.8);
      break;
    case Kind::Nested:
      capsule.EndRadius = capsule.StartRadius + 4.0;
      break;
    case Kind::Point:
      for (int i = 0; i < 3; ++i)
      {
        capsule.End[i] = capsule.Start[i];
      }
      break;
    case Kind::Needle:
      capsule.StartRadius = random.Uniform(1e-4, 1e-3);
      capsule.EndRadius = capsule.StartRadius;
      break;
    default:
      break;
  }
  return capsule;
}

void GetPoint(const double origin[3], const double direction[3], double t, double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] = origin[i] + t * direction[i];
  }
}

void CheckNormal(Checker& checker, const Capsule& capsule, const double point[3])
{
  double normal[3];
  GetCapsuleNormal(capsule, point, normal);
  const double step = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    double before[3] = { point[0], point[1], point[2] };
    double after[3] = { point[0], point[1], point[2] };
    before[i] -= step;
    after[i] += step;
    const double slope =
      (GetCapsuleDistance(capsule, after) - GetCapsuleDistance(capsule, before)) / (2.0 * step);
    // Across the seam of cone and sphere the curvature jumps, so that the quotient is off by
    // step / radius.
    checker.CheckNear(normal[i], slope, 1e-4 + 2.0 * step / 1e-4, "normal is the gradient");
  }
}

// Number of rays that hit.
int CheckRay(Checker& checker, const Capsule& capsule, const double origin[3],
  const double direction[3], bool normals)
{
  double entry = 0.0;
  double exit = 0.0;
  const bool hit = IntersectCapsule(capsule, origin, direction, entry, exit);
  const double length = vtkMath::Norm(direction);
  double point[3];
  const int steps = 400;
  for (int i = 0; i <= steps; ++i)
  {
    const double t = (-8.0 + 16.0 * i / steps) / length;
    GetPoint(origin, direction, t, point);
    const double distance = GetCapsuleDistance(capsule, point);
    const bool inside = hit && t > entry && t < exit;
    checker.Check(inside ? distance < 1e-9 : distance > -1e-9, "inside where the distance says so");
  }
  if (!hit)
  {
    return 0;
  }
  for (const double t : { entry, exit })
  {
    GetPoint(origin, direction, t, point);
    checker.CheckNear(GetCapsuleDistance(capsule, point), 0.0, 1e-9, "ends on the surface");
    if (normals)
    {
      CheckNormal(checker, capsule, point);
    }
  }
  GetPoint(origin, direction, 0.5 * (entry + exit), point);
  checker.Check(GetCapsuleDistance(capsule, point) < 0.0, "the middle is inside");
  return 1;
}

void CheckRandomRays(Checker& checker)
{
  Random random(7);
  int hits = 0;
  for (int trial = 0; trial < 1500; ++trial)
  {
    const Kind kind = static_cast<Kind>(trial % static_cast<int>(Kind::Count));
    const Capsule capsule = MakeRandomCapsule(random, kind);
    double origin[3];
    double direction[3];
    for (int i = 0; i < 3; ++i)
    {
      // Aim at a point near the axis.
      const double u = random.Uniform();
      const double target = capsule.Start[i] + u * (capsule.End[i] - capsule.Start[i]) +
        random.Uniform(-0.8, 0.8) * capsule.StartRadius;
      origin[i] = random.Uniform(-3, 3);
      direction[i] = (target - origin[i]) * (trial % 3 == 0 ? 0.1 : 1.0);
    }
    hits +=
      CheckRay(checker, capsule, origin, direction, kind == Kind::Capsule || kind == Kind::Cone);
  }
  checker.Check(hits > 700, "most random rays hit, " + std::to_string(hits));
}

// Rays along and across the axis, where the cone's equation loses its quadratic or linear term.
void CheckSpecialRays(Checker& checker)
{
  const Capsule capsule = MakeCapsule(0, 0, 0, 2, 0, 0, 0.5);
  double entry;
  double exit;
  const double along[3] = { 1, 0, 0 };
  const double onAxis[3] = { -5, 0, 0 };
  checker.Check(IntersectCapsule(capsule, onAxis, along, entry, exit), "along the axis");
  checker.CheckNear(entry, 4.5, 1e-12, "entry along the axis");
  checker.CheckNear(exit, 7.5, 1e-12, "exit along the axis");
  const double beside[3] = { -5, 0.3, 0 };
  checker.Check(IntersectCapsule(capsule, beside, along, entry, exit), "beside the axis");
  checker.CheckNear(entry, 4.6, 1e-12, "entry beside the axis");
  const double touching[3] = { -5, 0.5, 0 };
  checker.Check(!IntersectCapsule(capsule, touching, along, entry, exit), "touching is a miss");
  const double across[3] = { 0, 2, 0 };
  const double below[3] = { 1, -3, 0 };
  checker.Check(IntersectCapsule(capsule, below, across, entry, exit), "across the axis");
  checker.CheckNear(entry, 1.25, 1e-12, "t counts directions, not lengths");
  // A ray parallel to a generator of the cone: slope k = 0.5, half angle 30 degrees.
  Capsule cone = MakeCapsule(0, 0, 0, 2, 0, 0, 1.5);
  cone.EndRadius = 0.5;
  const double generator[3] = { std::sqrt(0.75), -0.5, 0.0 };
  const double start[3] = { -3.0, 2.0, 0.1 };
  checker.Check(CheckRay(checker, cone, start, generator, true) == 1, "parallel to a generator");
  const double nowhere[3] = { 0, 0, 0 };
  checker.Check(!IntersectCapsule(capsule, below, nowhere, entry, exit), "no direction, no hit");
  Capsule empty = capsule;
  empty.StartRadius = 0.0;
  empty.EndRadius = -1.0;
  checker.Check(!IntersectCapsule(empty, below, across, entry, exit), "no radius, no hit");
  checker.CheckNear(GetCapsulePosition(capsule, below), 0.5, 1e-12, "position along the axis");
  checker.CheckNear(GetCapsulePosition(capsule, beside), 0.0, 1e-12, "position is clamped");
}
}

int TestCapsuleInterval(int, char*[])
{
  Checker checker;
  CheckRandomRays(checker);
  CheckSpecialRays(checker);
  return checker.GetExitCode();
}
