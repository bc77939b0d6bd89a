// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From the capsules that a ray crosses to the layers that it sees.
 *
 * A curve is the union of its capsules. Each connected stretch of the ray inside that union is one
 * layer, however many capsules it crosses: a joint is not blended twice. The layer is shaded where
 * the ray enters the stretch. Where the visible part of the ray begins inside a stretch (the camera
 * or a clipping plane is inside a tube), there is no such point: the layer then lies at the far
 * side of the first-entered capsule.
 */

#ifndef RayLayers_h
#define RayLayers_h

#include "vtkType.h" // For vtkIdType

#include <vector> // For hits and layers

namespace linesets
{
/// A stretch of a ray inside one capsule.
struct CapsuleHit
{
  double Entry;
  double Exit;
  vtkIdType Curve;
  vtkIdType Capsule;
};

/// What one curve adds to a pixel at one depth.
struct RayLayer
{
  double Position;   ///< where it is shaded and placed
  vtkIdType Curve;   ///< curve of the capsule
  vtkIdType Capsule; ///< capsule that is shaded
  bool FromInside;   ///< Position is an exit: turn the normal to the viewer
};

/**
 * Layers on the interval [first, last] of a ray, nearest first; equal positions in the order of
 * curve and capsule. The hits may come in any order and are sorted in place. A layer whose position
 * is beyond the interval is not visible and is left out.
 */
void FindLayers(
  std::vector<CapsuleHit>& hits, double first, double last, std::vector<RayLayer>& layers);
}

#endif
