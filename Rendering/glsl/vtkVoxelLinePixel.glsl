// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ray of one pixel: its interval between the near plane, the far plane, the clipping planes and
// the opaque scene, its way through the model, its colour and depth. Common subset of GLSL and C++
// with GLM. The engine supplies RayOrigins[3], RayDirections[3], HalfPixel, NearestS, FarthestS, DepthZ,
// DepthW, PlaneCount, Planes[], RegionPlaneCount and RegionPlanes[] as vtkVoxelLineFrame tells.
//
// A region of the scene that is drawn by itself is no clipped scene: a tube that the ray entered
// before the region is not cut open by it. Its layer belongs to where it is seen first, so that the
// pictures of regions side by side, laid over each other in order, are the picture of all.

// s at which a point has a depth from 0 to 1.
Real distanceOfDepth(Real depth)
{
  Real z = Real(2) * depth - Real(1);
  return (z * DepthW.x - DepthZ.x) / (DepthZ.y - z * DepthW.y);
}

Real depthOfDistance(Real s)
{
  return Real(0.5) * (DepthZ.x + s * DepthZ.y) / (DepthW.x + s * DepthW.y) + Real(0.5);
}

// Narrows an interval of s to the half space that a plane keeps.
void clipToPlane(vec4 plane, vec3 origin, vec3 direction, LS_INOUT(Real) start, LS_INOUT(Real) end)
{
  vec3 normal = vec3(plane);
  Real atOrigin = dot(normal, origin) + plane.w;
  Real perS = dot(normal, direction);
  if (perS > Real(0))
  {
    start = max(start, -atOrigin / perS);
  }
  else if (perS < Real(0))
  {
    end = min(end, -atOrigin / perS);
  }
  else if (atOrigin < Real(0))
  {
    end = start;
  }
}

// Casts the ray through the point (x,y) of the viewport, in pixels. sceneDepth is the depth of the
// opaque scene, 1 where there is none. color is not multiplied by its opacity.
void castPixel(Real x, Real y, Real sceneDepth, LS_OUT(vec4) color, LS_OUT(Real) depth)
{
  vec3 origin = RayOrigins[0] + RayOrigins[1] * x + RayOrigins[2] * y;
  vec3 direction = RayDirections[0] + RayDirections[1] * x + RayDirections[2] * y;
  Real start = NearestS;
  Real end = FarthestS;
  if (sceneDepth < Real(1))
  {
    end = min(end, distanceOfDepth(sceneDepth));
  }
  for (int i = 0; i < PlaneCount; ++i)
  {
    clipToPlane(Planes[i], origin, direction, start, end);
  }
  Real drawnFrom = -Beyond;
  Real drawnTo = Beyond;
  for (int i = 0; i < RegionPlaneCount; ++i)
  {
    clipToPlane(RegionPlanes[i], origin, direction, drawnFrom, drawnTo);
  }
  color = vec4(Real(0));
  depth = Real(1);
  HasLayer = false;
  FirstCurve = -1;
  Forgot = false;
  Real size = length(direction);
  if (!(max(start, drawnFrom) < min(end, drawnTo)) || !(size > Real(0)))
  {
    return;
  }
  Ray.Pixel = vec2(HalfPixel.x, HalfPixel.y / size);
  Ray.DrawnFrom = drawnFrom * size;
  Ray.DrawnTo = drawnTo * size;
  castRay(origin, direction / size, start * size, end * size);
  if (HasLayer && RayOpacity > Real(0))
  {
    color = vec4(RayColor / RayOpacity, RayOpacity);
    depth = clamp(depthOfDistance(FirstDistance / size), Real(0), Real(1));
  }
}
