// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tubes that an occlusion ray meets leave of its light. Common subset of GLSL and C++ with
// GLM. vtkVoxelLineOcclusionRay.glsl tells the method.

// Whether an occlusion ray is under way.
bool OcclusionRay = false;
// What part of the light has come through so far.
Real Transmittance;
// Hits that begin up to here are those of the tube that the ray starts in or on.
Real OccluderStart;
// The stretch within that tube's curve: where it ends as far as is known, and whether that changed.
// Only where all lines are opaque.
uint OwnCurve;
Real OwnLeave;
bool OwnGrew;

// Whether a point of a tube's surface lies on its wall, not on the spheres at its ends. A tube of
// which one sphere holds the other is all wall, since no neighbour has its surface in common.
bool isOnWall(vec3 x, vec3 a, vec3 b, Real ra, Real rb)
{
  vec3 ba = b - a;
  Real rr = ra - rb;
  Real d2 = dot(ba, ba) - rr * rr;
  Real y = dot(ba, x - a) - ra * rr;
  return d2 <= Real(0) || (y >= Real(0) && y < d2);
}

// An opaque tube: it ends the light, unless it belongs to the stretch that the ray starts in.
void meetOpaqueTube(uint segment, int brick, Real entry, Real leave)
{
  if (entry <= OccluderStart)
  {
    if (!OnLevel && leave > OwnLeave)
    {
      OwnCurve = fetchCurve(segment, brick);
      OwnLeave = leave;
      OwnGrew = true;
    }
  }
  else if (entry > OwnLeave || fetchCurve(segment, brick) != OwnCurve)
  {
    Transmittance = Real(0);
  }
  else if (leave > OwnLeave)
  {
    OwnLeave = leave;
    OwnGrew = true;
  }
}

// How far the ray goes in a tube that it enters at x, in diameters, as if the tube were straight and
// had no ends.
Real diametersInside(vec3 x, vec3 a, vec3 b, Real ra, Real rb)
{
  vec3 ba = b - a;
  Real baba = dot(ba, ba);
  Real along = dot(ba, Ray.Direction);
  Real across2 = baba > Real(0) ? Real(1) - along * along / baba : Real(1);
  return max(-dot(Ray.Direction, tubeNormal(x, a, b, ra, rb)), Real(0)) / max(across2, Real(1e-6));
}

// A tube that an occlusion ray crosses from entry to leave, where it is at x, relative to the voxel.
void meetOccluder(uint segment, int brick, vec3 x, vec3 a, vec3 b, Real ra, Real rb, Real entry,
  Real leave)
{
  if (leave <= Real(0) || entry >= Ray.End)
  {
    return;
  }
  if (AllOpaque)
  {
    meetOpaqueTube(segment, brick, entry, leave);
  }
  else if (entry > OccluderStart && isOnWall(x, a, b, ra, rb))
  {
    Real opacity = segmentColor(segment, tubeParameter(x, a, b)).w * Opacity;
    Real clear = Real(1) - clamp(opacity, Real(0), Real(1));
    if (OpacityByPathLength && clear > Real(0))
    {
      clear = pow(clear, diametersInside(x, a, b, ra, rb));
    }
    Transmittance *= clear;
  }
}
