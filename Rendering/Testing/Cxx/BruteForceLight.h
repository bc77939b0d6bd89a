// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the tests of shadows and ambient occlusion take for the truth: rays through all tubes of a
 * model, each segment of it a capsule, in double precision. Lengths are in voxels of the model,
 * positions grid-local.
 */

#ifndef BruteForceLight_h
#define BruteForceLight_h

#include "CapsuleGrid.h"
#include "CapsulesFromModel.h"
#include "RayLayers.h"

#include "vtkVoxelLineModel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace BruteForceLight
{
using Directions = std::vector<glm::dvec3>;

constexpr double GoldenAngle = 2.39996322972865332;

/// Directions that cover the sphere evenly.
inline Directions MakeSphere(int count)
{
  Directions directions;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double side = std::sqrt(1.0 - z * z);
    directions.emplace_back(side * std::cos(GoldenAngle * i), side * std::sin(GoldenAngle * i), z);
  }
  return directions;
}

/// Directions that cover a cone of a full opening angle, in radians, evenly.
inline Directions MakeCone(const glm::dvec3& axis, double angle, int count)
{
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 v = glm::cross(axis, u);
  Directions directions;
  for (int i = 0; i < count; ++i)
  {
    const double up = 1.0 - (1.0 - std::cos(0.5 * angle)) * (i + 0.5) / count;
    const double side = std::sqrt(1.0 - up * up);
    directions.push_back(
      up * axis + side * std::cos(GoldenAngle * i) * u + side * std::sin(GoldenAngle * i) * v);
  }
  return directions;
}

/// The tubes of a model.
class Tubes
{
public:
  /// radius: in voxels, where the model has no radii.
  Tubes(vtkVoxelLineModel* model, double radius)
  {
    const double size = model->GetVoxelSize();
    this->Capsules = linesets::MakeCapsulesFromModel(model, radius * size).Capsules;
    for (linesets::Capsule& capsule : this->Capsules)
    {
      for (int i = 0; i < 3; ++i)
      {
        capsule.Start[i] /= size;
        capsule.End[i] /= size;
      }
      capsule.StartRadius /= size;
      capsule.EndRadius /= size;
    }
    this->Grid = std::make_unique<linesets::CapsuleGrid>(this->Capsules);
  }

  const std::vector<linesets::Capsule>& GetCapsules() const { return this->Capsules; }

  /// The curves that hold a point, grown by a little for points on a surface.
  std::vector<vtkIdType> FindCurvesAt(const glm::dvec3& point) const
  {
    std::vector<vtkIdType> curves;
    const glm::dvec3 direction(0.0, 0.0, 1.0);
    for (linesets::CapsuleGrid::Walk walk(*this->Grid, &point[0], &direction[0], 0.0, 1e-9);
         walk.IsValid(); walk.Next())
    {
      for (const std::uint32_t index : walk)
      {
        const linesets::Capsule& capsule = this->Capsules[index];
        if (linesets::GetCapsuleDistance(capsule, &point[0]) <= Tolerance)
        {
          curves.push_back(capsule.Curve);
        }
      }
    }
    return curves;
  }

  /// The first tube that a ray meets, and where; -1 where there is none.
  vtkIdType FindFirst(const glm::dvec3& origin, const glm::dvec3& direction, double& nearest) const
  {
    vtkIdType found = -1;
    nearest = 1e9;
    for (linesets::CapsuleGrid::Walk walk(*this->Grid, &origin[0], &direction[0], 0.0, 1e6);
         walk.IsValid() && !(nearest < 1e9); walk.Next())
    {
      for (const std::uint32_t index : walk)
      {
        double entry;
        double exit;
        if (linesets::IntersectCapsule(
              this->Capsules[index], &origin[0], &direction[0], entry, exit) &&
          entry > 0.0 && entry < nearest && entry <= walk.GetExit())
        {
          nearest = entry;
          found = index;
        }
      }
    }
    return found;
  }

  /// Part of the rays from a point, each as long as end, that meet a tube, but for the stretches of
  /// curves in which they start.
  double GetBlockedPart(const glm::dvec3& origin, const Directions& directions, double end) const
  {
    const std::vector<vtkIdType> own = this->FindCurvesAt(origin);
    int blocked = 0;
    for (const glm::dvec3& direction : directions)
    {
      blocked += this->IsBlocked(origin, direction, end, own) ? 1 : 0;
    }
    return static_cast<double>(blocked) / static_cast<double>(directions.size());
  }

private:
  static constexpr double Tolerance = 1e-6;

  bool IsBlocked(const glm::dvec3& origin, const glm::dvec3& direction, double end,
    const std::vector<vtkIdType>& own) const
  {
    std::vector<linesets::CapsuleHit> ownHits;
    for (linesets::CapsuleGrid::Walk walk(*this->Grid, &origin[0], &direction[0], 0.0, end);
         walk.IsValid(); walk.Next())
    {
      for (const std::uint32_t index : walk)
      {
        const linesets::Capsule& capsule = this->Capsules[index];
        linesets::CapsuleHit hit;
        if (!linesets::IntersectCapsule(capsule, &origin[0], &direction[0], hit.Entry, hit.Exit) ||
          hit.Exit <= 0.0 || hit.Entry >= end)
        {
          continue;
        }
        if (std::find(own.begin(), own.end(), capsule.Curve) == own.end())
        {
          return true;
        }
        hit.Curve = capsule.Curve;
        hit.Capsule = index;
        ownHits.push_back(hit);
      }
    }
    // Its own curves again, farther on; those that hold the start are layers from inside.
    std::vector<linesets::RayLayer> layers;
    linesets::FindLayers(ownHits, Tolerance * 10.0, end, layers);
    return std::any_of(layers.begin(), layers.end(),
      [](const linesets::RayLayer& layer) { return !layer.FromInside; });
  }

  std::vector<linesets::Capsule> Capsules;
  std::unique_ptr<linesets::CapsuleGrid> Grid;
};

/// Differences between values and the truth.
struct Errors
{
  double Sum = 0.0;
  double Squares = 0.0;
  double Truth = 0.0;
  int Count = 0;

  void Add(double value, double truth)
  {
    this->Sum += value - truth;
    this->Squares += (value - truth) * (value - truth);
    this->Truth += truth;
    ++this->Count;
  }
  double GetBias() const { return this->Sum / this->Count; }
  double GetRmse() const { return std::sqrt(this->Squares / this->Count); }
  double GetMeanTruth() const { return this->Truth / this->Count; }
};
}

#endif
