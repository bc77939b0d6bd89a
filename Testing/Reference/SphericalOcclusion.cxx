// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SphericalOcclusion.h"

#include "RayLayers.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
namespace
{
const double GoldenAngle = std::acos(-1.0) * (3.0 - std::sqrt(5.0));

// Whether a ray of unit direction passes the ball about a capsule; a test that costs less than
// IntersectCapsule, and hardly any capsule of a cell is hit.
bool PassesNear(const Capsule& capsule, const double origin[3], const double direction[3])
{
  double distance2 = 0.0;
  double along = 0.0;
  double length2 = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double toMiddle = 0.5 * (capsule.Start[i] + capsule.End[i]) - origin[i];
    const double axis = capsule.End[i] - capsule.Start[i];
    distance2 += toMiddle * toMiddle;
    along += toMiddle * direction[i];
    length2 += axis * axis;
  }
  const double radius = std::max(capsule.StartRadius, capsule.EndRadius);
  // (length / 2 + radius)^2 is at most twice the sum of the squares; the rest is for rounding.
  return distance2 - along * along <= 1.000001 * (0.5 * length2 + 2.0 * radius * radius);
}

// Follows rays one after the other.
class Follower
{
public:
  Follower(const std::vector<Capsule>& capsules, const CapsuleGrid& grid, double reach)
    : Capsules(capsules)
    , Grid(grid)
    , Reach(reach)
  {
  }

  bool IsStopped(const double origin[3], const double direction[3])
  {
    this->Hits.clear();
    this->StartCurves.clear();
    bool isFirst = true;
    CapsuleGrid::Walk walk(this->Grid, origin, direction, 0.0, this->Reach);
    for (; walk.IsValid(); walk.Next())
    {
      const std::size_t known = this->Hits.size();
      this->AddHits(walk, origin, direction);
      if (isFirst)
      {
        // The first cell has all capsules that hold the origin.
        this->FindStartCurves();
        isFirst = false;
      }
      if (this->HasOtherCurve(known))
      {
        return true;
      }
    }
    // The curves that the ray starts in may come back. A capsule of several cells is there several
    // times, which makes no further layer.
    FindLayers(this->Hits, 0.0, this->Reach, this->Layers);
    return std::any_of(this->Layers.begin(), this->Layers.end(),
      [](const RayLayer& layer) { return !layer.FromInside; });
  }

private:
  void AddHits(const CapsuleGrid::Walk& walk, const double origin[3], const double direction[3])
  {
    for (const std::uint32_t index : walk)
    {
      const Capsule& capsule = this->Capsules[index];
      CapsuleHit hit;
      if (PassesNear(capsule, origin, direction) &&
        IntersectCapsule(capsule, origin, direction, hit.Entry, hit.Exit) && hit.Exit > 0.0 &&
        hit.Entry < this->Reach)
      {
        hit.Curve = capsule.Curve;
        hit.Capsule = static_cast<vtkIdType>(index);
        this->Hits.push_back(hit);
      }
    }
  }

  void FindStartCurves()
  {
    for (const CapsuleHit& hit : this->Hits)
    {
      if (hit.Entry < 0.0)
      {
        this->StartCurves.push_back(hit.Curve);
      }
    }
  }

  // Whether a hit from number `first` on is of a curve that the ray does not start in.
  bool HasOtherCurve(std::size_t first) const
  {
    return std::any_of(this->Hits.begin() + static_cast<std::ptrdiff_t>(first), this->Hits.end(),
      [this](const CapsuleHit& hit)
      {
        return std::find(this->StartCurves.begin(), this->StartCurves.end(), hit.Curve) ==
          this->StartCurves.end();
      });
  }

  const std::vector<Capsule>& Capsules;
  const CapsuleGrid& Grid;
  double Reach;
  std::vector<CapsuleHit> Hits;
  std::vector<vtkIdType> StartCurves;
  std::vector<RayLayer> Layers;
};
}

//------------------------------------------------------------------------------
SphericalOcclusion::SphericalOcclusion(
  const std::vector<Capsule>& capsules, const CapsuleGrid& grid, double reach, int directions)
  : Capsules(capsules)
  , Grid(grid)
  , Reach(reach)
{
  for (int i = 0; i < directions; ++i)
  {
    const double up = 1.0 - 2.0 * (i + 0.5) / directions;
    const double side = std::sqrt(1.0 - up * up);
    this->Directions.push_back(
      { side * std::cos(GoldenAngle * i), side * std::sin(GoldenAngle * i), up });
  }
}

//------------------------------------------------------------------------------
double SphericalOcclusion::GetOcclusion(const double point[3]) const
{
  Follower follower(this->Capsules, this->Grid, this->Reach);
  const auto stopped = std::count_if(this->Directions.begin(), this->Directions.end(),
    [&](const std::array<double, 3>& direction)
    { return follower.IsStopped(point, direction.data()); });
  return static_cast<double>(stopped) / static_cast<double>(this->Directions.size());
}
}
