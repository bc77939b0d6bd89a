// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Capsule.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The hull of two spheres with centres A and B = A + L d and radii rA, rB is the union of the
// spheres about A + s d with radius rA - k s, k = (rA - rB) / L, 0 <= s <= L. Where |k| >= 1 one
// end sphere holds the other. Else the envelope of the spheres is a cone whose normals all have the
// component k along the axis: sphere s touches it at the axial coordinate y = s + (rA - k s) k and
// the distance (rA - k s) sqrt(1 - k^2) from the axis. Solving for s, a point with axial coordinate
// y lies on the cone at the distance (rA - k y) / sqrt(1 - k^2) from the axis, where
// k rA <= y <= L + k rB. A line's interval is then bounded by the outermost of its hits with the
// two spheres and with that part of the cone, since the hull is convex and all of them belong to
// it.

namespace linesets
{
namespace
{
struct Axis
{
  double Direction[3];
  double Length;
  double StartRadius;
  double EndRadius;
  double Slope; // k above
  // 0 or 1 where the start or the end sphere is the whole capsule, -1 else.
  int Sphere;
};

Axis MakeAxis(const Capsule& capsule)
{
  Axis axis;
  vtkMath::Subtract(capsule.End, capsule.Start, axis.Direction);
  axis.Length = vtkMath::Norm(axis.Direction);
  axis.StartRadius = std::max(0.0, capsule.StartRadius);
  axis.EndRadius = std::max(0.0, capsule.EndRadius);
  axis.Slope = 0.0;
  axis.Sphere = -1;
  if (axis.Length <= std::abs(axis.StartRadius - axis.EndRadius))
  {
    axis.Sphere = axis.StartRadius >= axis.EndRadius ? 0 : 1;
    return axis;
  }
  vtkMath::MultiplyScalar(axis.Direction, 1.0 / axis.Length);
  axis.Slope = (axis.StartRadius - axis.EndRadius) / axis.Length;
  return axis;
}

struct Interval
{
  double Entry = std::numeric_limits<double>::infinity();
  double Exit = -std::numeric_limits<double>::infinity();

  void Add(double t)
  {
    this->Entry = std::min(this->Entry, t);
    this->Exit = std::max(this->Exit, t);
  }
};

// Roots of a t^2 + 2 b t + c = 0 without cancellation; returns their number.
int SolveQuadratic(double a, double b, double c, double roots[2])
{
  const double discriminant = b * b - a * c;
  if (discriminant <= 0.0)
  {
    return 0;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  int count = 0;
  if (a != 0.0)
  {
    roots[count++] = q / a;
  }
  if (q != 0.0)
  {
    roots[count++] = c / q;
  }
  return count;
}

void AddSphere(Interval& interval, const double center[3], double radius, const double origin[3],
  const double direction[3])
{
  double m[3];
  vtkMath::Subtract(origin, center, m);
  double roots[2];
  const int count = SolveQuadratic(vtkMath::Dot(direction, direction), vtkMath::Dot(m, direction),
    vtkMath::Dot(m, m) - radius * radius, roots);
  for (int i = 0; i < count; ++i)
  {
    interval.Add(roots[i]);
  }
}

void AddCone(Interval& interval, const Capsule& capsule, const Axis& axis, const double origin[3],
  const double direction[3])
{
  double m[3];
  vtkMath::Subtract(origin, capsule.Start, m);
  const double k = axis.Slope;
  const double y = vtkMath::Dot(m, axis.Direction);
  const double dy = vtkMath::Dot(direction, axis.Direction);
  // (1 - k^2) (|m + t D|^2 - (y + t dy)^2) - (rA - k (y + t dy))^2 = 0. The parts of m and D across
  // the axis are formed first, since the difference of squares would cancel.
  double across[3];
  double acrossDirection[3];
  for (int i = 0; i < 3; ++i)
  {
    across[i] = m[i] - y * axis.Direction[i];
    acrossDirection[i] = direction[i] - dy * axis.Direction[i];
  }
  const double w = 1.0 - k * k;
  const double r = axis.StartRadius - k * y;
  double roots[2];
  const int count =
    SolveQuadratic(w * vtkMath::Dot(acrossDirection, acrossDirection) - k * k * dy * dy,
      w * vtkMath::Dot(across, acrossDirection) + k * dy * r,
      w * vtkMath::Dot(across, across) - r * r, roots);
  const double lowest = k * axis.StartRadius;
  const double highest = axis.Length + k * axis.EndRadius;
  for (int i = 0; i < count; ++i)
  {
    const double hit = y + roots[i] * dy;
    if (hit >= lowest && hit <= highest)
    {
      interval.Add(roots[i]);
    }
  }
}
}

//------------------------------------------------------------------------------
void GetCapsuleBounds(const std::vector<Capsule>& capsules, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  bool first = true;
  for (const Capsule& capsule : capsules)
  {
    for (int i = 0; i < 3; ++i)
    {
      const double low = std::min(capsule.Start[i] - std::max(0.0, capsule.StartRadius),
        capsule.End[i] - std::max(0.0, capsule.EndRadius));
      const double high = std::max(capsule.Start[i] + std::max(0.0, capsule.StartRadius),
        capsule.End[i] + std::max(0.0, capsule.EndRadius));
      bounds[2 * i] = first ? low : std::min(bounds[2 * i], low);
      bounds[2 * i + 1] = first ? high : std::max(bounds[2 * i + 1], high);
    }
    first = false;
  }
}

//------------------------------------------------------------------------------
bool IntersectCapsule(const Capsule& capsule, const double origin[3], const double direction[3],
  double& entry, double& exit)
{
  const double length2 = vtkMath::Dot(direction, direction);
  if (!(length2 > 0.0))
  {
    return false;
  }
  // Start from the point of the line nearest to the middle of the capsule, for precision.
  double toMiddle[3];
  for (int i = 0; i < 3; ++i)
  {
    toMiddle[i] = 0.5 * (capsule.Start[i] + capsule.End[i]) - origin[i];
  }
  const double shift = vtkMath::Dot(toMiddle, direction) / length2;
  double near[3];
  for (int i = 0; i < 3; ++i)
  {
    near[i] = origin[i] + shift * direction[i];
  }
  const Axis axis = MakeAxis(capsule);
  Interval interval;
  if (axis.Sphere != 1)
  {
    AddSphere(interval, capsule.Start, axis.StartRadius, near, direction);
  }
  if (axis.Sphere != 0)
  {
    AddSphere(interval, capsule.End, axis.EndRadius, near, direction);
  }
  if (axis.Sphere == -1)
  {
    AddCone(interval, capsule, axis, near, direction);
  }
  if (!(interval.Entry < interval.Exit))
  {
    return false;
  }
  entry = shift + interval.Entry;
  exit = shift + interval.Exit;
  return entry < exit;
}

//------------------------------------------------------------------------------
void GetCapsuleNormal(const Capsule& capsule, const double point[3], double normal[3])
{
  const Axis axis = MakeAxis(capsule);
  double s = 0.0;
  if (axis.Sphere == -1)
  {
    vtkMath::Subtract(point, capsule.Start, normal);
    const double k = axis.Slope;
    const double y = vtkMath::Dot(normal, axis.Direction);
    s = (y - k * axis.StartRadius) / (1.0 - k * k);
    s = std::min(std::max(s, 0.0), axis.Length);
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = point[i] - (capsule.Start[i] + s * axis.Direction[i]);
    }
  }
  else
  {
    vtkMath::Subtract(point, axis.Sphere == 0 ? capsule.Start : capsule.End, normal);
  }
  vtkMath::Normalize(normal);
}

//------------------------------------------------------------------------------
double GetCapsulePosition(const Capsule& capsule, const double point[3])
{
  double along[3];
  double m[3];
  vtkMath::Subtract(capsule.End, capsule.Start, along);
  vtkMath::Subtract(point, capsule.Start, m);
  const double length2 = vtkMath::Dot(along, along);
  if (!(length2 > 0.0))
  {
    return 0.0;
  }
  return std::min(std::max(vtkMath::Dot(m, along) / length2, 0.0), 1.0);
}

//------------------------------------------------------------------------------
double GetCapsuleDistance(const Capsule& capsule, const double point[3])
{
  // The distance to the sphere at position u is convex in u: golden section search.
  const auto distance = [&](double u)
  {
    double center[3];
    for (int i = 0; i < 3; ++i)
    {
      center[i] = capsule.Start[i] + u * (capsule.End[i] - capsule.Start[i]);
    }
    const double radius = capsule.StartRadius + u * (capsule.EndRadius - capsule.StartRadius);
    return std::sqrt(vtkMath::Distance2BetweenPoints(center, point)) - radius;
  };
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = 0.0;
  double high = 1.0;
  while (high - low > 1e-12)
  {
    const double a = high - golden * (high - low);
    const double b = low + golden * (high - low);
    if (distance(a) < distance(b))
    {
      high = b;
    }
    else
    {
      low = a;
    }
  }
  return std::min({ distance(0.0), distance(1.0), distance(0.5 * (low + high)) });
}
}
