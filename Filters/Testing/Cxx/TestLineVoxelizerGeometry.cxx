// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards what a voxel line model keeps of the curves: for every encoding, each curve is one
 * connected chain in the right voxels, begins and ends where the curve does, stays within the
 * bounds of its tolerance and its bins, and is at no place farther from the curve than
 * LargestDeviation says.
 */

#include "VoxelLineTesting.h"

#include <algorithm>

using namespace VoxelLineTesting;

namespace
{

/// Largest distance of densely sampled points of a polyline from the nearest of the segments.
double FarthestSample(const Curve& from, const std::vector<std::pair<Point, Point>>& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i + 1 < from.size(); ++i)
  {
    const int samples = 1 + static_cast<int>(Length(from[i + 1] - from[i]) / 0.05);
    for (int s = 0; s <= samples; ++s)
    {
      const Point point = from[i] + (static_cast<double>(s) / samples) * (from[i + 1] - from[i]);
      double nearest = 1e30;
      for (const auto& segment : to)
      {
        nearest = std::min(nearest, Distance(point, segment.first, segment.second));
      }
      largest = std::max(largest, nearest);
    }
  }
  return largest;
}

void CheckCurve(Checks& check, vtkVoxelLineModel* model, const std::vector<Segment>& chain,
  const Curve& curve, const std::string& name)
{
  if (!check(!chain.empty(), name + ": one connected chain"))
  {
    return;
  }
  const double n = model->GetFaceBins();
  const double m = model->GetInteriorBins();
  // Half the diagonal of a bin; single precision where end points are exact.
  const double faceError = n > 0 ? std::sqrt(0.5) / n : 1e-6;
  const double interiorError = n > 0 ? std::sqrt(0.75) / m + 1e-12 : 1e-6;

  Curve local;
  for (const Point& point : curve)
  {
    local.push_back(ToLocal(model, point));
  }
  check(Length(chain.front().Start - local.front()) <= interiorError, name + ": begins right");
  check(Length(chain.back().End - local.back()) <= interiorError, name + ": ends right");

  std::vector<std::pair<Point, Point>> segments;
  Curve modelCurve(1, chain.front().Start);
  for (const Segment& segment : chain)
  {
    segments.emplace_back(segment.Start, segment.End);
    modelCurve.push_back(segment.End);
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = segment.Voxel[axis];
      isInside = isInside && std::min(segment.Start[axis], segment.End[axis]) >= low &&
        std::max(segment.Start[axis], segment.End[axis]) <= low + 1.0;
    }
    check(isInside, name + ": segment lies in its voxel");
  }
  std::vector<std::pair<Point, Point>> edges;
  for (std::size_t i = 0; i + 1 < local.size(); ++i)
  {
    edges.emplace_back(local[i], local[i + 1]);
  }
  // The tolerance is 0.1 voxels, and each end adds at most its bin's error.
  const double bound = 0.1 + std::max(faceError, interiorError) + 1e-9;
  const double toModel = FarthestSample(local, segments);
  const double toCurve = FarthestSample(modelCurve, edges);
  const double told = model->GetLargestDeviation() / model->GetVoxelSize();
  check(toModel <= bound,
    name + ": the curve is at most " + std::to_string(bound) + " from the model, not " +
      std::to_string(toModel));
  check(toCurve <= bound,
    name + ": the model is at most " + std::to_string(bound) + " from the curve, not " +
      std::to_string(toCurve));
  check(toModel <= told + 1e-9, name + ": LargestDeviation holds");
}

}

int TestLineVoxelizerGeometry(int, char*[])
{
  Checks check;
  const std::vector<Curve> curves = MakeSmoothCurves(12, 60);
  vtkSmartPointer<vtkPolyData> lines = MakeLines(curves);
  for (int bins : { 0, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048 })
  {
    for (int resolution : { 1, 7, 24 })
    {
      const std::string name =
        std::to_string(bins) + " bins, resolution " + std::to_string(resolution);
      vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, lines, resolution, bins);
      const std::vector<Segment> segments = DecodeModel(model);
      check(static_cast<vtkIdType>(segments.size()) == model->GetNumberOfSegments(),
        name + ": every segment belongs to a voxel");
      check(model->GetNumberOfCurves() == 12, name + ": all curves");
      double largest = 0.0;
      for (const Segment& segment : segments)
      {
        double start[3];
        double end[3];
        model->GetSegmentPoints(segment.Index, start, end);
        for (int axis = 0; axis < 3; ++axis)
        {
          largest =
            std::max(largest, std::abs(start[axis] + segment.Voxel[axis] - segment.Start[axis]));
          largest =
            std::max(largest, std::abs(end[axis] + segment.Voxel[axis] - segment.End[axis]));
        }
        check(model->GetSegmentCurve(segment.Brick, segment.Index) == segment.Curve,
          name + ": GetSegmentCurve");
      }
      check(largest == 0.0, name + ": GetSegmentPoints");
      for (std::size_t i = 0; i < curves.size(); ++i)
      {
        CheckCurve(check, model,
          Chain(segments, static_cast<vtkIdType>(i), ToLocal(model, curves[i].front())), curves[i],
          name + ", curve " + std::to_string(i));
      }
    }
  }
  return check.GetResult();
}
