// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Opacity acceleration: what lies behind many layers is not told apart any more. Common subset of GLSL
// and C++ with GLM.
//
// Once a ray has reached a given opacity, the rest of its way goes through the densities of the
// lines, level by level coarser (Danskin and Hanrahan 1992, as in Kanzler et al. 2019, Sec. 4.1.1).
// They tell how much of what is behind the lines is still seen; the colour of the rest is taken to
// be that of the layers in front.

// Levels are coarser by one with each doubling of the way; half of it is as wide as a voxel.
const Real AccelerationSpread = Real(0.5);

// Ends the ray behind the layer that it sees at a distance.
void accelerate(Real seen)
{
  Real depth = coneDepth(Ray.Origin + Ray.Direction * seen, Ray.Direction, ConeStart, min(Ray.Limit, Ray.DrawnTo) - seen,
    AccelerationSpread);
  Real rest = (Real(1) - RayOpacity) * (Real(1) - exp(-depth));
  RayColor += RayColor * (rest / RayOpacity);
  RayOpacity += rest;
  Finished = true;
}
