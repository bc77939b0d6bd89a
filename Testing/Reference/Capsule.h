// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The primitive of the reference renderer: a segment with a radius at each end, that is, the
 * convex hull of the spheres about its two end points. With equal radii this is a capsule (a swept
 * sphere), else a round cone. All arithmetic is in double precision, and none of it is shared with
 * the ray casters that it judges.
 */

#ifndef Capsule_h
#define Capsule_h

#include "vtkType.h" // For vtkIdType

#include <vector> // For CapsuleScene

namespace linesets
{
/// One segment of a curve. Coordinates and radii are in the units of the data; coordinates are
/// relative to the origin of the scene.
struct Capsule
{
  double Start[3] = { 0.0, 0.0, 0.0 };
  double End[3] = { 0.0, 0.0, 0.0 };
  double StartRadius = 0.0;
  double EndRadius = 0.0;
  /// Scalar attribute at the ends, interpolated along the axis and then mapped through a table.
  double StartValue = 0.0;
  double EndValue = 0.0;
  /// Red, green, blue and opacity at the ends, where the scene has direct colours.
  unsigned char StartColor[4] = { 255, 255, 255, 255 };
  unsigned char EndColor[4] = { 255, 255, 255, 255 };
  /// Capsules with the same number make one curve.
  vtkIdType Curve = 0;
};

/// Where the colour of a layer comes from.
enum class ColorSource
{
  Material, ///< the material's own colours
  Scalars,  ///< StartValue and EndValue through a lookup table
  Direct    ///< StartColor and EndColor
};

/// What the reference renderer draws. The order of the capsules breaks ties between equal depths.
struct CapsuleScene
{
  std::vector<Capsule> Capsules;
  ColorSource Colors = ColorSource::Material;
  /// Point that the capsules' coordinates are relative to, so that data far from the origin of the
  /// world stays precise.
  double Origin[3] = { 0.0, 0.0, 0.0 };
};

/// Bounds of capsules with their radii; xmin > xmax where there are none.
void GetCapsuleBounds(const std::vector<Capsule>& capsules, double bounds[6]);

/**
 * Interval of t in which origin + t * direction lies inside the capsule, for all real t. The
 * direction need not have unit length. Returns false where the line misses or merely touches the
 * capsule; entry < exit else. A radius at or below 0 makes an empty sphere.
 */
bool IntersectCapsule(const Capsule& capsule, const double origin[3], const double direction[3],
  double& entry, double& exit);

/// Unit normal of the capsule's surface, for a point on it.
void GetCapsuleNormal(const Capsule& capsule, const double point[3], double normal[3]);

/// Position of a point along the axis: its projection, 0 at the start and 1 at the end, clamped.
double GetCapsulePosition(const Capsule& capsule, const double point[3]);

/**
 * Distance from a point to the surface of the capsule, negative inside. Found by minimizing over
 * the spheres along the axis, independently of IntersectCapsule; for tests.
 */
double GetCapsuleDistance(const Capsule& capsule, const double point[3]);
}

#endif
