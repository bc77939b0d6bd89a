// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// Guards occlusion by brute force: against the solid angles of a ball and of a long tube, that it
// ends at the reach, and which of the tubes that hold the point count.

#include "CapsuleGrid.h"
#include "ReferenceTesting.h"
#include "SphericalOcclusion.h"

using namespace linesets;

namespace
{
constexpr int Directions = 20000;
constexpr double Tolerance = 1e-3;

double GetOcclusion(const std::vector<Capsule>& capsules, double reach)
{
  const CapsuleGrid grid(capsules);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  return SphericalOcclusion(capsules, grid, reach, Directions).GetOcclusion(origin);
}

Capsule MakeBall(double x, double y, double z, double radius, vtkIdType curve)
{
  return MakeCapsule(x, y, z, x, y, z, radius, curve);
}
}

int TestSphericalOcclusion(int, char*[])
{
  Checker checker;
  // Of a ball of radius 1 at distance 3, the sine of half the angle is 1/3.
  const double ball = 0.5 * (1.0 - std::sqrt(8.0 / 9.0));
  checker.CheckNear(GetOcclusion({ MakeBall(1, 2, -2, 1, 0) }, 10), ball, Tolerance, "a ball");
  checker.CheckNear(
    GetOcclusion({ MakeBall(1, 2, -2, 1, 0) }, 1.99), 0.0, 0.0, "a ball out of reach");
  // Of the triangle of sides 3, 2.5 and 1, the cosine of the angle at the point is 0.95.
  checker.CheckNear(
    GetOcclusion({ MakeBall(1, 2, -2, 1, 0) }, 2.5), 0.025, Tolerance, "a ball partly in reach");
  // Of a long tube of radius 1 at distance 2, the sine of half the angle is 1/2.
  checker.CheckNear(GetOcclusion({ MakeCapsule(2, 0, -4000, 2, 0, 4000, 1) }, 1e4), 1.0 / 6.0,
    Tolerance, "a long tube");

  const Capsule own = MakeCapsule(0, 0, -1, 0, 0, 1, 0.5, 7);
  const Capsule next = MakeCapsule(0, 0, 1, 0, 0, 3, 0.5, 7);
  checker.CheckNear(GetOcclusion({ own, next }, 10), 0.0, 0.0, "the own tube");
  checker.CheckNear(GetOcclusion({ own, MakeBall(0, 0.2, 0, 0.5, 8) }, 10), 0.0, 0.0,
    "another that holds the point");
  checker.CheckNear(GetOcclusion({ own, MakeBall(3, 0, 0, 1, 7) }, 10), ball, Tolerance,
    "the own curve that comes back");
  checker.CheckNear(GetOcclusion({ own, MakeBall(3, 0, 0, 1, 8), MakeBall(5, 0, 0, 1, 9) }, 10),
    ball, Tolerance, "tubes behind each other");
  checker.CheckNear(GetOcclusion({ own, MakeBall(3, 0, 0, 1, 8), MakeBall(-3, 0, 0, 1, 9) }, 10),
    2.0 * ball, Tolerance, "tubes on two sides");
  return checker.GetExitCode();
}
