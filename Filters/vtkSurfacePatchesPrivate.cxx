// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfacePatchesPrivate.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>

namespace vtkSurfacePatches
{

namespace
{

using vtkSurfaceGeodesics::Infinity;
using vtkSurfaceGeodesics::Mesh;
using vtkSurfaceGeodesics::Tolerance;

std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// Distances and vertices, the nearest first.
using Entry = std::pair<double, int>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

/// Whether a distance is better than another one, beyond rounding.
bool IsNearer(double distance, double other)
{
  return distance < other * (1.0 - Tolerance);
}

/// How often a vertex spreads the distance of one seed at most. It becomes nearer after it has
/// spread where triangles are obtuse, mostly once. Where a surface is rough on the scale of its
/// edges, the planes of its triangles contradict each other, and distances would improve each other
/// for long.
constexpr int MostSpreads = 4;

/// The mean length of the edges.
double FindMeanEdge(const Mesh& mesh)
{
  double sum = 0.0;
  double count = 0.0;
  for (int vertex = 0; vertex < mesh.GetNumberOfVertices(); ++vertex)
  {
    for (const auto* corner = mesh.Begin(vertex); corner != mesh.End(vertex); ++corner)
    {
      sum += corner->Lengths[0];
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// The distance of each vertex to the nearest of the seeds so far.
class NearestDistances
{
public:
  explicit NearestDistances(const Mesh& mesh)
    : Surface(mesh)
    , Margin(2.0 * FindMeanEdge(mesh))
    , Nearest(mesh.Pieces.size(), Infinity)
    , Tentative(mesh.Pieces.size(), 0.0)
    , Spreads(mesh.Pieces.size(), 0)
    , Round(mesh.Pieces.size(), 0)
    , Largest((mesh.Pieces.size() + BlockSize - 1) / BlockSize, Infinity)
    , IsStale(this->Largest.size(), true)
  {
  }

  void AddSeed(int seed)
  {
    ++this->CurrentRound;
    this->Reached.clear();
    this->Improve(seed, 0.0);
    while (!this->Waiting.empty())
    {
      const double distance = this->Waiting.top().first;
      const int vertex = this->Waiting.top().second;
      this->Waiting.pop();
      double& nearest = this->Nearest[Index(vertex)];
      // The vertex became nearer since.
      if (distance > this->Tentative[Index(vertex)])
      {
        continue;
      }
      ++this->Spreads[Index(vertex)];
      if (distance < nearest)
      {
        nearest = distance;
        this->IsStale[Index(vertex) / BlockSize] = true;
      }
      this->Spread(vertex, distance);
    }
  }

  /// The vertex of a piece that is farthest from one of it, the first one of several; the distances
  /// of that vertex are forgotten again.
  int FindOpposite(int vertex)
  {
    this->AddSeed(vertex);
    int farthest = vertex;
    for (int other : this->Reached)
    {
      const double distance = this->Nearest[Index(other)];
      const double best = this->Nearest[Index(farthest)];
      farthest = distance > best || (distance == best && other < farthest) ? other : farthest;
    }
    for (int other : this->Reached)
    {
      this->Nearest[Index(other)] = Infinity;
    }
    return farthest;
  }

  /// The vertex farthest from all seeds, the first one of several, and its distance. Blocks of
  /// vertices know their largest distance; it is only computed anew where it matters.
  std::pair<int, double> FindFarthest()
  {
    std::size_t best = 0;
    double largest = -1.0;
    for (std::size_t block = 0; block < this->Largest.size(); ++block)
    {
      // Distances only become smaller: an old largest one bounds the new one.
      if (this->Largest[block] > largest && this->IsStale[block])
      {
        const auto begin = this->Nearest.begin() + static_cast<std::ptrdiff_t>(block * BlockSize);
        const std::size_t rest = this->Nearest.size() - block * BlockSize;
        this->Largest[block] =
          *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(std::min(rest, BlockSize)));
        this->IsStale[block] = false;
      }
      if (this->Largest[block] > largest)
      {
        largest = this->Largest[block];
        best = block;
      }
    }
    const auto begin = this->Nearest.begin() + static_cast<std::ptrdiff_t>(best * BlockSize);
    const auto found = std::find(begin, this->Nearest.end(), largest);
    return { static_cast<int>(found - this->Nearest.begin()), largest };
  }

private:
  static constexpr std::size_t BlockSize = 1024;

  double GetTentative(int vertex) const
  {
    return this->Round[Index(vertex)] == this->CurrentRound ? this->Tentative[Index(vertex)]
                                                            : Infinity;
  }

  void Improve(int vertex, double distance)
  {
    const double old = this->GetTentative(vertex);
    if (!IsNearer(distance, old))
    {
      return;
    }
    if (old == Infinity)
    {
      this->Reached.push_back(vertex);
      this->Spreads[Index(vertex)] = 0;
    }
    else if (this->Spreads[Index(vertex)] >= MostSpreads)
    {
      return;
    }
    this->Round[Index(vertex)] = this->CurrentRound;
    this->Tentative[Index(vertex)] = distance;
    if (distance < this->Nearest[Index(vertex)] + this->Margin)
    {
      this->Waiting.emplace(distance, vertex);
    }
  }

  void Spread(int vertex, double distance)
  {
    vtkSurfaceGeodesics::Spread(
      this->Surface, vertex, distance, [this](int other) { return this->GetTentative(other); },
      [this](int other, double found) { this->Improve(other, found); });
  }

  const Mesh& Surface;
  /// A seed spreads a little beyond its patch, so that distances inside are found through triangles
  /// of which all corners have theirs: about one more ring of vertices, across which the distances
  /// to two seeds differ by two edges more.
  const double Margin;
  std::vector<double> Nearest;
  /// Distances of the newest seed, and how often they spread; valid where the round is the current
  /// one.
  std::vector<double> Tentative;
  std::vector<std::uint8_t> Spreads;
  std::vector<std::uint32_t> Round;
  std::uint32_t CurrentRound = 0;
  /// The vertices that it reached.
  std::vector<int> Reached;
  std::vector<double> Largest;
  std::vector<bool> IsStale;
  Queue Waiting;
};

/// Spreads all seeds, in turns, so that the work of each turn is in one place of the memory. Labels
/// improve until nothing changes, so that the order matters for the time alone.
class NearSeedFinder
{
public:
  explicit NearSeedFinder(const Mesh& mesh)
    : Surface(mesh)
    , Labels(mesh.Pieces.size())
  {
  }

  /// step: how far a seed spreads before the next one has its turn.
  bool Find(const std::vector<int>& seeds, double step, const ProgressFunction& goesOn)
  {
    this->Queues.resize(seeds.size());
    std::vector<int> active;
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      active.push_back(static_cast<int>(i));
      this->Improve(seeds[i], active.back(), 0.0);
    }
    while (!active.empty())
    {
      double limit = Infinity;
      for (int seed : active)
      {
        limit = std::min(limit, this->Queues[Index(seed)].top().first + step);
      }
      for (int seed : active)
      {
        if (!this->SpreadSeed(seed, limit, goesOn))
        {
          return false;
        }
      }
      active.erase(std::remove_if(active.begin(), active.end(),
                     [this](int seed) { return this->Queues[Index(seed)].empty(); }),
        active.end());
    }
    return true;
  }

  /// Of two seeds that are equally far, up to rounding, the one placed first comes first.
  NearSeeds GetNearSeeds(std::size_t vertex) const
  {
    auto labels = this->Labels[vertex];
    for (std::size_t i = KeptSeeds - 1; i > 0; --i)
    {
      Label& near = labels[i - 1];
      Label& far = labels[i];
      if (far.Seed >= 0 && far.Seed < near.Seed && !IsNearer(near.Distance, far.Distance))
      {
        std::swap(near.Seed, far.Seed);
        far.Distance = near.Distance;
      }
    }
    NearSeeds result;
    for (std::size_t i = 0; i < NumberOfNearSeeds; ++i)
    {
      result[i].Seed = labels[i].Seed;
      result[i].Distance = labels[i].Distance;
    }
    return result;
  }

private:
  /// More labels are kept than are needed, so that the last ones of those have their distances
  /// through triangles too: both ends of an edge mostly have a label if it is not the last one.
  static constexpr std::size_t KeptSeeds = NumberOfNearSeeds + 2;

  struct Label
  {
    int Seed = -1;
    int Spreads = 0;
    double Distance = Infinity;
  };

  /// Spread a seed up to a distance.
  bool SpreadSeed(int seed, double limit, const ProgressFunction& goesOn)
  {
    // Each vertex is taken up about once for each label.
    const double total = static_cast<double>(KeptSeeds * this->Labels.size());
    Queue& queue = this->Queues[Index(seed)];
    while (!queue.empty() && queue.top().first <= limit)
    {
      const double distance = queue.top().first;
      const int vertex = queue.top().second;
      queue.pop();
      // A label that became nearer, or was driven out, is no longer found.
      Label* label = this->Find(vertex, seed);
      if (!label || label->Distance != distance)
      {
        continue;
      }
      ++label->Spreads;
      this->Spread(vertex, seed, distance);
      ++this->Count;
      if (this->Count % 16384 == 0 &&
        !goesOn(std::min(1.0, static_cast<double>(this->Count) / total)))
      {
        return false;
      }
    }
    return true;
  }

  Label* Find(int vertex, int seed)
  {
    for (Label& label : this->Labels[Index(vertex)])
    {
      if (label.Seed == seed)
      {
        return &label;
      }
    }
    return nullptr;
  }

  double GetDistance(int vertex, int seed)
  {
    const Label* label = this->Find(vertex, seed);
    return label ? label->Distance : Infinity;
  }

  void Improve(int vertex, int seed, double distance)
  {
    auto& labels = this->Labels[Index(vertex)];
    if (!(distance < labels.back().Distance))
    {
      return;
    }
    std::size_t slot = 0;
    while (slot + 1 < KeptSeeds && labels[slot].Seed != seed)
    {
      ++slot;
    }
    // The last one is either that of the seed, or is driven out.
    const bool isKnown = labels[slot].Seed == seed;
    const int spreads = isKnown ? labels[slot].Spreads : 0;
    if (!IsNearer(distance, labels[slot].Distance) || spreads >= MostSpreads)
    {
      return;
    }
    for (; slot > 0 && labels[slot - 1].Distance > distance; --slot)
    {
      labels[slot] = labels[slot - 1];
    }
    labels[slot] = { seed, spreads, distance };
    this->Queues[Index(seed)].emplace(distance, vertex);
  }

  void Spread(int vertex, int seed, double distance)
  {
    vtkSurfaceGeodesics::Spread(
      this->Surface, vertex, distance,
      [this, seed](int other) { return this->GetDistance(other, seed); },
      [this, seed](int other, double found) { this->Improve(other, seed, found); });
  }

  const Mesh& Surface;
  std::vector<std::array<Label, KeptSeeds>> Labels;
  std::vector<Queue> Queues;
  vtkIdType Count = 0;
};

/// How far seeds spread in a turn: about a quarter of the distance between them, if the surface is
/// a grid of its mean edge length, but an edge at least.
double FindStep(const Mesh& mesh, std::size_t numberOfSeeds)
{
  const double verticesPerSeed = static_cast<double>(mesh.Pieces.size()) /
    static_cast<double>(std::max<std::size_t>(numberOfSeeds, 1));
  return FindMeanEdge(mesh) * std::max(1.0, 0.25 * std::sqrt(verticesPerSeed));
}

}

//------------------------------------------------------------------------------
std::vector<int> PlaceSeeds(const Mesh& mesh, int number, const ProgressFunction& goesOn)
{
  NearestDistances distances(mesh);
  std::vector<int> seeds;
  const std::size_t size = static_cast<std::size_t>(std::max(number, 0));
  const std::size_t numberOfPieces = std::min(size, mesh.FirstVertices.size());
  const auto mayGoOn = [&]()
  {
    return seeds.size() % 16 != 0 ||
      goesOn(static_cast<double>(seeds.size()) / static_cast<double>(size));
  };
  while (seeds.size() < numberOfPieces && mayGoOn())
  {
    seeds.push_back(distances.FindOpposite(mesh.FirstVertices[seeds.size()]));
    distances.AddSeed(seeds.back());
  }
  while (seeds.size() >= numberOfPieces && seeds.size() < size && mayGoOn())
  {
    const std::pair<int, double> farthest = distances.FindFarthest();
    if (!(farthest.second > 0.0))
    {
      break;
    }
    seeds.push_back(farthest.first);
    distances.AddSeed(farthest.first);
  }
  return seeds;
}

//------------------------------------------------------------------------------
std::vector<NearSeeds> FindNearSeeds(
  const Mesh& mesh, const std::vector<int>& seeds, const ProgressFunction& goesOn)
{
  NearSeedFinder finder(mesh);
  std::vector<NearSeeds> result;
  if (finder.Find(seeds, FindStep(mesh, seeds.size()), goesOn))
  {
    result.reserve(mesh.Pieces.size());
    for (std::size_t vertex = 0; vertex < mesh.Pieces.size(); ++vertex)
    {
      result.push_back(finder.GetNearSeeds(vertex));
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, int>> FindNeighbors(
  const Mesh& mesh, const std::vector<NearSeeds>& nearSeeds)
{
  std::vector<std::pair<int, int>> pairs;
  for (int vertex = 0; vertex < static_cast<int>(nearSeeds.size()); ++vertex)
  {
    const int here = nearSeeds[Index(vertex)][0].Seed;
    for (const vtkSurfaceGeodesics::Corner* corner = mesh.Begin(vertex); corner != mesh.End(vertex);
         ++corner)
    {
      for (int end : corner->Ends)
      {
        const int there = nearSeeds[Index(end)][0].Seed;
        if (here < there)
        {
          pairs.emplace_back(here, there);
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}
