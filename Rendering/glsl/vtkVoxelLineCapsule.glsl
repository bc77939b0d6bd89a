// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A tube around a segment: the convex hull of two spheres (a, ra) and (b, rb). With equal radii it
// is a capsule, else a round cone. Common subset of GLSL and C++ with GLM.
//
// A point x lies on the cone that touches both spheres where, with y = (b-a).(x-a) - ra (ra-rb) and
// d2 = |b-a|^2 - (ra-rb)^2, |d2 (x-a) - y (b-a)|^2 = d2 (...)^2; it belongs to the body where
// 0 < y < d2. On a line x = o + t d this is a quadratic equation in t.

// Interval [entry, leave] of the line o + t d (|d| = 1) inside the tube. Returns whether there is any.
bool intersectTube(vec3 o, vec3 d, vec3 a, vec3 b, Real ra, Real rb, LS_OUT(Real) entry,
  LS_OUT(Real) leave)
{
  // Measure t from the point of the line nearest to the middle of the tube, so that all
  // numbers below are about the tube's own size.
  vec3 ba = b - a;
  Real shift = dot(d, a + ba * Real(0.5) - o);
  vec3 oa = o + d * shift - a;

  Real bad = dot(ba, d);
  Real baoa = dot(ba, oa);
  Real doa = dot(d, oa);
  Real dob = doa - bad;
  vec3 ob = oa - ba;

  // The tube is convex: its interval spans all places where the line crosses one of its parts.
  entry = Real(1e30);
  leave = Real(-1e30);
  Real discriminant = ra * ra - dot(oa - d * doa, oa - d * doa);
  if (discriminant >= Real(0))
  {
    Real root = sqrt(discriminant);
    entry = -doa - root;
    leave = -doa + root;
  }
  discriminant = rb * rb - dot(ob - d * dob, ob - d * dob);
  if (discriminant >= Real(0))
  {
    Real root = sqrt(discriminant);
    entry = min(entry, -dob - root);
    leave = max(leave, -dob + root);
  }

  Real rr = ra - rb;
  Real baba = dot(ba, ba);
  Real d2 = baba - rr * rr;
  Real k2 = d2 - bad * bad;
  // Along the axis (k2 about 0) only the spheres matter; where one sphere holds the other, too.
  if (d2 > Real(0) && abs(k2) > Real(1e-6) * d2)
  {
    Real k1 = d2 * doa - baoa * bad + bad * rr * ra;
    Real k0 = d2 * dot(oa, oa) - baoa * baoa + Real(2) * baoa * rr * ra - baba * ra * ra;
    Real h = k1 * k1 - k0 * k2;
    if (h >= Real(0))
    {
      Real root = sqrt(h);
      Real t0 = (-k1 - root) / k2;
      Real t1 = (-k1 + root) / k2;
      Real y0 = baoa - ra * rr + t0 * bad;
      Real y1 = baoa - ra * rr + t1 * bad;
      if (y0 > Real(0) && y0 < d2)
      {
        entry = min(entry, t0);
        leave = max(leave, t0);
      }
      if (y1 > Real(0) && y1 < d2)
      {
        entry = min(entry, t1);
        leave = max(leave, t1);
      }
    }
  }
  entry += shift;
  leave += shift;
  return entry <= leave;
}

// Outward unit normal of the tube at a point x of its surface.
vec3 tubeNormal(vec3 x, vec3 a, vec3 b, Real ra, Real rb)
{
  vec3 ba = b - a;
  vec3 xa = x - a;
  Real rr = ra - rb;
  Real baba = dot(ba, ba);
  Real d2 = baba - rr * rr;
  Real y = dot(ba, xa) - ra * rr;
  vec3 n;
  if (d2 <= Real(0))
  {
    n = rr > Real(0) ? xa : x - b;
  }
  else if (y <= Real(0))
  {
    n = xa;
  }
  else if (y >= d2)
  {
    n = x - b;
  }
  else
  {
    n = xa * d2 - ba * y;
  }
  Real size = length(n);
  return size > Real(0) ? n / size : vec3(Real(0), Real(0), Real(1));
}

// Position of x along the axis, 0 at a to 1 at b, clamped; 0 for a tube without length.
Real tubeParameter(vec3 x, vec3 a, vec3 b)
{
  vec3 ba = b - a;
  Real baba = dot(ba, ba);
  return baba > Real(0) ? clamp(dot(x - a, ba) / baba, Real(0), Real(1)) : Real(0);
}
