// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OcclusionJudge.h"

#include "CapsuleGrid.h"
#include "CapsulesFromModel.h"
#include "Random.h"
#include "SphericalOcclusion.h"
#include "ViewRays.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLineGlobalIllumination.h"
#include "vtkSMPTools.h"
#include "vtkVoxelLineLightFields.h"
#include "vtkVoxelLineModel.h"
#include "vtkVoxelLineOcclusion.h"
#include "vtkVoxelLineSegmentsPrivate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numeric>
#include <stdexcept>

namespace linesets
{
namespace
{
constexpr int Directions = 2500;
constexpr int PointsPerVoxel = 8;
constexpr int Repetitions = 3;
// Rays that miss all lines before the view is taken to be empty.
constexpr int LargestNumberOfTries = 100000;

// Streams of random numbers.
constexpr std::uint64_t LineSeed = 1;
constexpr std::uint64_t VoxelSeed = 2;
constexpr std::uint64_t ViewSeed = 3;

using Point = std::array<double, 3>;

double GetLength(const Capsule& capsule)
{
  return std::hypot(capsule.End[0] - capsule.Start[0], capsule.End[1] - capsule.Start[1],
    capsule.End[2] - capsule.Start[2]);
}

Point GetAxisPoint(const Capsule& capsule, double position)
{
  Point point;
  for (std::size_t i = 0; i < 3; ++i)
  {
    point[i] = capsule.Start[i] + position * (capsule.End[i] - capsule.Start[i]);
  }
  return point;
}

/// A point on the axis of a capsule.
struct Place
{
  std::size_t Capsule = 0;
  Point Position;
};

/// Places at ascending lengths along the capsules from number first up to last, without last.
std::vector<Place> FindPlaces(const std::vector<Capsule>& capsules, std::size_t first,
  std::size_t last, const std::vector<double>& lengths)
{
  std::vector<Place> places;
  std::size_t index = first;
  double behind = 0.0;
  for (const double length : lengths)
  {
    // Sums of lengths are rounded: none may lead past the last capsule.
    double own = GetLength(capsules[index]);
    while (behind + own <= length && index + 1 < last)
    {
      behind += own;
      own = GetLength(capsules[++index]);
    }
    const double position = own > 0.0 ? std::min((length - behind) / own, 1.0) : 0.0;
    places.push_back({ index, GetAxisPoint(capsules[index], position) });
  }
  return places;
}

double SumLengths(const std::vector<Capsule>& capsules, std::size_t first, std::size_t last)
{
  return std::accumulate(capsules.begin() + static_cast<std::ptrdiff_t>(first),
    capsules.begin() + static_cast<std::ptrdiff_t>(last), 0.0,
    [](double sum, const Capsule& capsule) { return sum + GetLength(capsule); });
}

/// Places spread evenly over the length of all lines: one in each of as many equal parts.
std::vector<Place> SpreadPlaces(const std::vector<Capsule>& capsules, int count)
{
  const double total = SumLengths(capsules, 0, capsules.size());
  Random random(LineSeed);
  std::vector<double> lengths;
  for (int i = 0; i < count; ++i)
  {
    lengths.push_back(total * (i + random.Uniform()) / count);
  }
  return FindPlaces(capsules, 0, capsules.size(), lengths);
}

/// The voxel of a place: where its value is, and its segments, which are capsules of the same
/// numbers.
struct PlaceVoxel
{
  std::size_t Value = 0;
  std::size_t First = 0;
  std::size_t Last = 0;
};

/// Of places in ascending order.
std::vector<PlaceVoxel> FindVoxels(vtkVoxelLineModel* model, const std::vector<Place>& places)
{
  std::vector<PlaceVoxel> voxels(places.size());
  const auto isBefore = [](const Place& place, std::size_t capsule)
  { return place.Capsule < capsule; };
  const vtkVoxelLineSegments::Reader reader(model);
  for (vtkIdType brick = 0; brick < reader.GetNumberOfBricks(); ++brick)
  {
    reader.VisitVoxels(brick,
      [&](const int voxel[3], vtkIdType firstSegment, vtkIdType lastSegment)
      {
        PlaceVoxel found;
        found.Value = static_cast<std::size_t>(
          64 * brick + voxel[0] % 4 + 4 * (voxel[1] % 4) + 16 * (voxel[2] % 4));
        found.First = static_cast<std::size_t>(firstSegment);
        found.Last = static_cast<std::size_t>(lastSegment);
        auto place = std::lower_bound(places.begin(), places.end(), found.First, isBefore);
        for (; place != places.end() && place->Capsule < found.Last; ++place)
        {
          voxels[static_cast<std::size_t>(place - places.begin())] = found;
        }
      });
  }
  return voxels;
}

/// The nearest capsule whose surface a ray from outside meets; false where there is none.
bool FindNearest(
  const std::vector<Capsule>& capsules, const CapsuleGrid& grid, const Ray& ray, Place& place)
{
  double nearest = ray.Length;
  bool isFound = false;
  CapsuleGrid::Walk walk(grid, ray.ModelOrigin, ray.ModelDirection, 0.0, ray.Length);
  for (; walk.IsValid(); walk.Next())
  {
    for (const std::uint32_t index : walk)
    {
      double entry;
      double exit;
      if (IntersectCapsule(capsules[index], ray.ModelOrigin, ray.ModelDirection, entry, exit) &&
        entry >= 0.0 && entry < nearest)
      {
        nearest = entry;
        place.Capsule = index;
        isFound = true;
      }
    }
    if (isFound && nearest <= walk.GetExit())
    {
      break;
    }
  }
  if (isFound)
  {
    Point point;
    for (std::size_t i = 0; i < 3; ++i)
    {
      point[i] = ray.ModelOrigin[i] + nearest * ray.ModelDirection[i];
    }
    const Capsule& capsule = capsules[place.Capsule];
    place.Position = GetAxisPoint(capsule, GetCapsulePosition(capsule, point.data()));
  }
  return isFound;
}

/// Places under random pixels.
std::vector<Place> SeePlaces(
  const CapsuleScene& scene, const CapsuleGrid& grid, const BenchmarkInput& input)
{
  const BenchmarkOptions& options = input.Options;
  const ViewRays view(input.Camera, options.Width, options.Height, nullptr, scene.Origin);
  std::vector<Place> places;
  Random random(ViewSeed);
  for (int misses = 0; static_cast<int>(places.size()) < options.OcclusionPlaces;)
  {
    const double x = std::floor(random.Uniform(0.0, options.Width)) + 0.5;
    const double y = std::floor(random.Uniform(0.0, options.Height)) + 0.5;
    Place place;
    if (FindNearest(scene.Capsules, grid, view.GetRay(x, y), place))
    {
      places.push_back(place);
    }
    else if (++misses > LargestNumberOfTries + 1000 * options.OcclusionPlaces)
    {
      throw std::runtime_error("too little of the view is covered by lines");
    }
  }
  return places;
}

/// Values of voxels as the ray casters look them up.
class ValueField
{
public:
  ValueField(vtkVoxelLineModel* model, const std::vector<std::uint8_t>& values)
    : BrickGrid(model->GetBrickGrid())
    , Values(values)
    , VoxelSize(model->GetVoxelSize())
  {
    model->GetDimensions(this->Dimensions);
    model->GetBrickDimensions(this->BrickDimensions);
  }

  double GetValue(std::size_t i) const { return this->Values[i] / 255.0; }

  /// Trilinear between the voxels of the bricks that there are, at a point relative to the model's
  /// origin.
  double Interpolate(const Point& point) const
  {
    double low[3];
    double part[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double x = point[axis] / this->VoxelSize - 0.5;
      low[axis] = std::floor(x);
      part[axis] = x - low[axis];
    }
    double sum = 0.0;
    double weights = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      int voxel[3];
      double weight = 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int isHigh = corner >> axis & 1;
        voxel[axis] =
          std::min(std::max(static_cast<int>(low[axis]) + isHigh, 0), this->Dimensions[axis] - 1);
        weight *= isHigh != 0 ? part[axis] : 1.0 - part[axis];
      }
      const auto cell = static_cast<vtkIdType>(voxel[0] / 4 +
        this->BrickDimensions[0] *
          (voxel[1] / 4 + static_cast<vtkIdType>(this->BrickDimensions[1]) * (voxel[2] / 4)));
      const auto brick = static_cast<vtkIdType>(this->BrickGrid->GetComponent(cell, 0));
      if (brick >= 0)
      {
        const vtkIdType i = 64 * brick + voxel[0] % 4 + 4 * (voxel[1] % 4) + 16 * (voxel[2] % 4);
        sum += weight * this->GetValue(static_cast<std::size_t>(i));
        weights += weight;
      }
    }
    return weights > 0.0 ? sum / weights : 0.0;
  }

private:
  vtkDataArray* BrickGrid;
  const std::vector<std::uint8_t>& Values;
  double VoxelSize;
  int Dimensions[3];
  int BrickDimensions[3];
};

/// Root of the mean square, and mean, of value - exact.
struct Differences
{
  double Rmse = 0.0;
  double Bias = 0.0;
};

/// Differences at so many places, by threads; both functions get the number of the place.
Differences Compare(std::size_t count, const std::function<double(std::size_t)>& value,
  const std::function<double(std::size_t)>& exact)
{
  std::vector<double> differences(count);
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        differences[i] = value(i) - exact(i);
      }
    });
  Differences result;
  for (const double difference : differences)
  {
    result.Rmse += difference * difference;
    result.Bias += difference;
  }
  result.Rmse = std::sqrt(result.Rmse / static_cast<double>(count));
  result.Bias /= static_cast<double>(count);
  return result;
}

/// Mean of brute force on the lines of a voxel.
double GetExactOfVoxel(const SphericalOcclusion& exact, const std::vector<Capsule>& capsules,
  const PlaceVoxel& voxel, std::size_t number)
{
  const double total = SumLengths(capsules, voxel.First, voxel.Last);
  Random random(VoxelSeed, number);
  std::vector<double> lengths(PointsPerVoxel);
  for (double& length : lengths)
  {
    length = random.Uniform(0.0, total);
  }
  std::sort(lengths.begin(), lengths.end());
  double sum = 0.0;
  for (const Place& place : FindPlaces(capsules, voxel.First, voxel.Last, lengths))
  {
    sum += exact.GetOcclusion(place.Position.data());
  }
  return sum / PointsPerVoxel;
}

void CompareWithBruteForce(const BenchmarkInput& input, vtkVoxelLineModel* model,
  const ValueField& field, OcclusionMeasures& measures)
{
  const CapsuleScene scene = MakeCapsulesFromModel(model, input.Radius);
  const std::vector<Capsule>& capsules = scene.Capsules;
  const bool isOpaque = input.Options.Plain || scene.Colors != ColorSource::Direct ||
    std::all_of(capsules.begin(), capsules.end(),
      [](const Capsule& capsule)
      { return capsule.StartColor[3] == 255 && capsule.EndColor[3] == 255; });
  if (!isOpaque || !(SumLengths(capsules, 0, capsules.size()) > 0.0))
  {
    throw std::runtime_error(isOpaque ? "the lines have no length" : "needs opaque lines");
  }
  const CapsuleGrid grid(capsules);
  const SphericalOcclusion exact(
    capsules, grid, input.Options.OcclusionRadius * model->GetVoxelSize(), Directions);

  const std::vector<Place> places = SpreadPlaces(capsules, input.Options.OcclusionPlaces);
  const std::vector<PlaceVoxel> voxels = FindVoxels(model, places);
  const Differences inVoxels = Compare(
    places.size(), [&](std::size_t i) { return field.GetValue(voxels[i].Value); },
    [&](std::size_t i) { return GetExactOfVoxel(exact, capsules, voxels[i], i); });
  measures.VoxelRmse = inVoxels.Rmse;
  measures.VoxelBias = inVoxels.Bias;

  const auto compareAt = [&](const std::vector<Place>& at)
  {
    return Compare(
      at.size(), [&](std::size_t i) { return field.Interpolate(at[i].Position); },
      [&](std::size_t i) { return exact.GetOcclusion(at[i].Position.data()); });
  };
  const Differences onLines = compareAt(places);
  measures.LineRmse = onLines.Rmse;
  measures.LineBias = onLines.Bias;
  const Differences seen = compareAt(SeePlaces(scene, grid, input));
  measures.SeenRmse = seen.Rmse;
  measures.SeenBias = seen.Bias;
}
}

//------------------------------------------------------------------------------
OcclusionMeasures JudgeOcclusion(const BenchmarkInput& input, BenchmarkMethod& method)
{
  std::cerr << "occlusion reference of " << method.FileName << "\n";
  vtkVoxelLineModel* model = method.GetModel();
  const double radius = input.Options.OcclusionRadius;
  OcclusionMeasures measures;
  vtkVoxelLineOcclusion occlusion;
  std::vector<double> densityTimes;
  std::vector<double> occlusionTimes;
  for (int i = 0; i < Repetitions; ++i)
  {
    // What the mapper does for a frame; occlusion of hemispheres needs the densities alone.
    vtkNew<vtkLineGlobalIllumination> illumination;
    illumination->SetOcclusionToHemisphereDensity();
    illumination->SetOcclusionRadius(radius);
    vtkVoxelLineFrame frame;
    frame.Radius = static_cast<float>(input.Radius / model->GetVoxelSize());
    vtkVoxelLineLightFields fields;
    const std::string problem = fields.Update(frame, model, illumination, nullptr);
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
    }
    densityTimes.push_back(1000.0 * fields.GetBuildTime());
    occlusion.Initialize();
    const auto start = std::chrono::steady_clock::now();
    occlusion.Build(
      model, frame.Global.Densities, radius, static_cast<double>(frame.Global.Extinction));
    occlusionTimes.push_back(GetMilliseconds(start));
  }
  measures.DensityMilliseconds = GetMedian(densityTimes);
  measures.OcclusionMilliseconds = GetMedian(occlusionTimes);
  CompareWithBruteForce(input, model, ValueField(model, occlusion.GetValues()), measures);
  return measures;
}
}
