// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Patches of a surface: seeds spread evenly, and for each vertex the seeds nearest to it.
 */

#ifndef vtkSurfacePatchesPrivate_h
#define vtkSurfacePatchesPrivate_h

#include "vtkSurfaceGeodesicsPrivate.h"

#include <functional>
#include <utility>

namespace vtkSurfacePatches
{

/// Is called with the fraction of the work done; returns whether to go on.
using ProgressFunction = std::function<bool(double)>;

/**
 * Geodesic farthest-point sampling (Eldar et al., "The farthest point strategy for progressive
 * image sampling", 1997). The first seed of each connected piece is its vertex farthest from its
 * first one; each further seed is the vertex farthest from all seeds, the first one of several.
 * The distances of a new seed spread only as far as it is the nearest one, so that all of them
 * together take O(n log n log k) time. Returns the seeds in the order in which they were placed,
 * first those of the pieces, as many as asked for, but at most one for each vertex.
 */
std::vector<int> PlaceSeeds(
  const vtkSurfaceGeodesics::Mesh& mesh, int number, const ProgressFunction& goesOn);

/// One seed that is near to a vertex.
struct NearSeed
{
  int Seed = -1;
  double Distance = vtkSurfaceGeodesics::Infinity;
};

/// Seeds that are found for each vertex: three and the cut-off.
constexpr std::size_t NumberOfNearSeeds = 4;
using NearSeeds = std::array<NearSeed, NumberOfNearSeeds>;

/**
 * The seeds nearest to each vertex, nearest first; fewer where a piece has no more. All seeds
 * spread at once, each only as far as it is among the nearest ones.
 */
std::vector<NearSeeds> FindNearSeeds(const vtkSurfaceGeodesics::Mesh& mesh,
  const std::vector<int>& seeds, const ProgressFunction& goesOn);

/// Pairs of seeds whose patches an edge joins, the smaller one first, each once, sorted.
std::vector<std::pair<int, int>> FindNeighbors(
  const vtkSurfaceGeodesics::Mesh& mesh, const std::vector<NearSeeds>& nearSeeds);

}

#endif

// VTK-HeaderTest-Exclude: vtkSurfacePatchesPrivate.h
