// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// State of a ray on its way through the model; vtkVoxelLineTraversal.glsl tells the method.
// Common subset of GLSL and C++ with GLM.

// A ray's geometry and its way through the slabs: all that a second ray must put aside and bring
// back.
struct RayState
{
  vec3 Origin;
  vec3 Direction;
  Real Start;
  Real End;
  Real Limit; // End before opaque hits shortened it
  // What is seen from here on, and before there, is drawn; see vtkVoxelLinePixel.glsl.
  Real DrawnFrom;
  Real DrawnTo;
  // Half a pixel at a distance t, in voxels, is Pixel.x + t Pixel.y.
  vec2 Pixel;
  // Largest radius that the ray may meet, as it is drawn.
  Real Radius;
  // How far around its way the ray looks into voxels.
  Real Reach;
  // The two minor axes, U before V, and the major one, along which the slabs lie.
  int AxisU;
  int AxisV;
  int AxisW;
  // Distance per unit of w, and u and v as functions of w: u = BaseU + SlopeU w.
  Real PerW;
  Real BaseU;
  Real BaseV;
  Real SlopeU;
  Real SlopeV;
  // Slabs per step of u and of v.
  Real PerU;
  Real PerV;
  // The ray's way over a widened slab k, widened by Reach: [LowU, HighU] + SlopeU k.
  Real LowU;
  Real HighU;
  Real LowV;
  Real HighV;
  // How far the way over a widened slab reaches from its middle, to either side.
  Real ReachU;
  Real ReachV;
  // Size of the grid along the axes, and steps between brick cells.
  int SizeU;
  int SizeV;
  int StrideU;
  int StrideV;
  int StrideW;
};
RayState Ray;

// Hits that were found and not blended yet; HitOrder lists their places, the farthest first, and
// behind them the places that are free again.
int HitCount;
int HitPlaces;
int HitOrder[HitCapacity];
Real HitEntry[HitCapacity];
Real HitLeave[HitCapacity];
uint HitSegment[HitCapacity];
int HitBrick[HitCapacity];
ivec3 HitVoxel[HitCapacity];

// Layers of tubes in which the ray starts, put off until it leaves them; and how far it goes in them.
int InsideCount;
Real InsideLeave[InsideCapacity];
Real InsideLength[InsideCapacity];
uint InsideSegment[InsideCapacity];
int InsideBrick[InsideCapacity];
ivec3 InsideVoxel[InsideCapacity];

// Whether the ray starts inside a tube.
bool StartsInside = false;
// Whether an opaque hit ends the search; not while tubes around the ray's start may yet be found.
bool Shortening = false;

// First hit that did not fit.
Real OverflowEntry;
uint OverflowSegment;
// Last hit that was blended; while visiting slabs again, hits up to it are known.
Real LastEntry;
uint LastSegment;
bool Resuming = false;

// Curves that the ray is inside of, and where it leaves them.
int ActiveCount;
uint ActiveCurve[ActiveCapacity];
Real ActiveLeave[ActiveCapacity];
// With OpacityByPathLength: the light of the wall where the ray came in, and how far it has gone
// inside, in diameters; negative where it started inside.
vec3 ActiveShade[ActiveCapacity];
Real ActivePath[ActiveCapacity];
// Place of the last hit's curve among them, and where the curve's stretch ended before that hit.
int HitSlot;
Real HitFrom;

// Result: colour multiplied by opacity, opacity; distance of the first layer (or a negative curve:
// none); curve of the first layer; whether a curve's exit had to be forgotten.
vec3 RayColor;
Real RayOpacity;
Real FirstDistance;
int FirstCurve;
bool HasLayer = false;
bool Forgot = false;
bool Finished = false;
