// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards what happens within and between voxels where simpler voxel models fail: many lines in a
 * voxel, many curves in a brick, curves smaller than a voxel, loops that leave where they entered,
 * lines on the planes and through the corners of the grid, and directions that are almost nothing.
 */

#include "VoxelLineTesting.h"

#include <set>

using namespace VoxelLineTesting;

namespace
{

/// Corners of the unit cube, so that the grid has known voxels.
Curve Diagonal()
{
  return { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
}

void TestManyLines(Checks& check)
{
  // All through the voxel (3,3,3) of a grid of 8, along x.
  std::vector<Curve> curves(1, Diagonal());
  for (int i = 0; i < 1000; ++i)
  {
    const double y = (3.0 + (i % 40 + 0.5) / 40) / 8;
    const double z = (3.0 + (i / 40 + 0.5) / 25) / 8;
    curves.push_back({ { 0.0, y, z }, { 1.0, y, z } });
  }
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 8, 64);
  std::set<vtkIdType> seen;
  int here = 0;
  for (const Segment& segment : DecodeModel(model))
  {
    if (segment.Voxel == std::array<int, 3>{ 3, 3, 3 })
    {
      seen.insert(segment.Curve);
      ++here;
    }
  }
  check(here == 1001 && seen.size() == 1001, "1000 parallel lines and the diagonal in one voxel");
  check(model->GetNumberOfDuplicates() == 0, "no line is another one's duplicate");
}

/// Curves in one brick: their ids need 8, 16 and 32 bits more than the words have.
void TestManyCurves(Checks& check, int numberOfCurves, int bins, int extensionBytes)
{
  std::vector<Curve> curves;
  for (int i = 0; i < numberOfCurves; ++i)
  {
    const double s = static_cast<double>(i) / numberOfCurves;
    curves.push_back({ { s, 0.1, 0.2 }, { 1.0 - s, 0.9, 0.7 } });
  }
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 1, bins);
  const std::string name =
    std::to_string(numberOfCurves) + " curves in a voxel, " + std::to_string(bins) + " bins";
  vtkDataArray* extension = model->GetCurveIdExtension();
  check((extension ? extension->GetDataTypeSize() : 0) == extensionBytes, name + ": extension");
  check(model->GetVoxelStarts()->GetDataTypeSize() == (numberOfCurves > 65535 ? 4 : 2),
    name + ": width of voxel starts");
  const std::vector<Segment> segments = DecodeModel(model);
  bool isRight = static_cast<int>(segments.size()) == numberOfCurves;
  for (std::size_t i = 0; isRight && i < segments.size(); ++i)
  {
    isRight = segments[i].Curve == static_cast<vtkIdType>(i) &&
      model->GetSegmentCurve(0, segments[i].Index) == segments[i].Curve;
  }
  check(isRight, name + ": each segment has its curve");
}

/// A helix far smaller than a voxel, and one that fills it.
void TestHelix(Checks& check, double radius, int bins)
{
  Curve helix;
  for (int i = 0; i <= 400; ++i)
  {
    const double angle = 0.05 * i;
    helix.push_back({ 0.375 + radius * std::cos(angle), 0.375 + radius * std::sin(angle),
      0.375 + radius * (i - 200) / 400 });
  }
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines({ Diagonal(), helix }), 4, bins);
  const std::string name =
    "helix of radius " + std::to_string(4 * radius) + " voxels, " + std::to_string(bins) + " bins";
  const std::vector<Segment> segments = DecodeModel(model);
  const std::vector<Segment> chain = Chain(segments, 1, ToLocal(model, helix[0]));
  if (!check(!chain.empty(), name + ": connected"))
  {
    return;
  }
  double largest = 0.0;
  for (const Point& point : helix)
  {
    double nearest = 1e30;
    for (const Segment& segment : chain)
    {
      nearest = std::min(nearest, Distance(ToLocal(model, point), segment.Start, segment.End));
    }
    largest = std::max(largest, nearest);
  }
  const double bin = bins > 0 ? std::sqrt(0.75) / model->GetInteriorBins() : 1e-6;
  check(largest <= 0.1 + bin, name + ": within tolerance, not " + std::to_string(largest));
  if (radius > 0.05)
  {
    check(chain.size() > 8, name + ": keeps its turns");
  }
}

/// A curve that comes into a voxel, goes around, and leaves where it came in.
void TestLoop(Checks& check)
{
  const Curve loop = { { 0.1, 0.3125, 0.3125 }, { 0.3, 0.3125, 0.3125 }, { 0.45, 0.45, 0.3125 },
    { 0.3, 0.3128, 0.3128 }, { 0.1, 0.3128, 0.3128 } };
  const std::vector<Curve> curves = { Diagonal(), loop };
  vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 4, 32);
  double farthest = 0.0;
  for (const Segment& segment : Chain(DecodeModel(model), 1, ToLocal(model, loop[0])))
  {
    farthest = std::max(farthest, std::max(segment.Start[0], segment.End[0]));
  }
  check(farthest > 4 * 0.45 - 0.1, "a loop that leaves by the bin it came in is kept");
  // The same without interior points, as the paper has it.
  model = MakeModel(check, MakeLines(curves), 4, 32, VTK_DOUBLE_MAX);
  check(model->GetLargestDeviation() > 0.05, "a tolerance without limit gives up the loop");
}

/// Edges along, on and across the planes of the grid.
void TestPlanes(Checks& check)
{
  std::vector<Curve> curves(1, Diagonal());
  // All 26 directions through grid corners, through plane points, and through general points.
  for (int x = -1; x <= 1; ++x)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int z = -1; z <= 1; ++z)
      {
        const Point d = { 0.375 * x, 0.375 * y, 0.375 * z };
        for (const Point& middle :
          { Point{ 0.5, 0.5, 0.5 }, Point{ 0.5, 0.53, 0.47 }, Point{ 0.5625, 0.5625, 0.5625 } })
        {
          if (x != 0 || y != 0 || z != 0)
          {
            curves.push_back({ middle - d, middle + d });
          }
        }
      }
    }
  }
  // To and fro over a plane, touching it, and resting on it.
  curves.push_back({ { 0.4, 0.3, 0.3 }, { 0.5, 0.3, 0.3 }, { 0.4, 0.35, 0.3 }, { 0.5, 0.4, 0.3 },
    { 0.5, 0.6, 0.3 }, { 0.6, 0.6, 0.3 }, { 0.5, 0.6, 0.3 } });
  // Bounds of the grid.
  curves.push_back({ { 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 },
    { 1.0, 0.0, 1.0 }, { 1.0, 0.0, 0.0 } });
  // Across a plane by almost nothing, and in directions that underflow.
  curves.push_back(
    { { 0.5, 0.2, 0.2 }, { std::nextafter(0.5, 0.0), 0.2, 0.2 }, { 0.5, 0.7, 0.2 } });
  curves.push_back({ { 0.0, 0.2, 0.2 }, { 1e-300, 0.8, 0.2 }, { 5e-324, 0.2, 0.2 } });
  curves.push_back({ { 1e-300, 1e-300, 0.0 }, { 2e-300, 3e-300, 1.0 } });
  for (int bins : { 0, 2, 32, 2048 })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeModel(check, MakeLines(curves), 8, bins);
    const std::vector<Segment> segments = DecodeModel(model);
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      const std::string name =
        "grid planes, " + std::to_string(bins) + " bins, curve " + std::to_string(i);
      const std::vector<Segment> chain =
        Chain(segments, static_cast<vtkIdType>(i), ToLocal(model, curves[i].front()));
      if (!check(!chain.empty(), name + ": connected"))
      {
        continue;
      }
      const double bin = bins > 0 ? std::sqrt(0.75) / model->GetInteriorBins() + 1e-12 : 1e-6;
      check(
        Length(chain.front().Start - ToLocal(model, curves[i].front())) <= bin, name + ": start");
      check(Length(chain.back().End - ToLocal(model, curves[i].back())) <= bin, name + ": end");
      // At most one segment per voxel that an edge crosses, and a few for the ties.
      check(chain.size() <= 30 * curves[i].size(), name + ": no more segments than needed");
    }
  }
}

/// Curves of very many points inside one voxel: time must not grow with their square.
void TestCrowdedVoxel(Checks& check)
{
  std::mt19937 generator(3);
  const auto uniform = [&generator]() { return generator() / 4294967296.0; };
  Curve crowd;
  Curve zigzag;
  constexpr int size = 200000;
  for (int i = 0; i < size; ++i)
  {
    crowd.push_back({ 0.3 + 0.15 * uniform(), 0.3 + 0.15 * uniform(), 0.3 + 0.15 * uniform() });
    // Its farthest point is always the last but one, so that each split takes off a single point.
    const double swing = 0.12 * i / size;
    zigzag.push_back({ 0.625 + (i % 2 == 0 ? swing : -swing), 0.625, 0.625 });
  }
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines({ Diagonal(), crowd, zigzag }), 4, 32);
  check(model->GetNumberOfSegments() > 100000, "a crowded voxel keeps its points");
  check(model->GetLargestDeviation() / model->GetVoxelSize() < 0.1 + std::sqrt(0.75) / 12,
    "a crowded voxel keeps the tolerance");
}

}

int TestLineVoxelizerVoxels(int, char*[])
{
  Checks check;
  TestManyLines(check);
  TestManyCurves(check, 64, 32, 0);
  TestManyCurves(check, 65, 32, 1);
  TestManyCurves(check, 64 * 256 + 1, 32, 2);
  TestManyCurves(check, 4096, 64, 0);
  TestManyCurves(check, 4097, 64, 1);
  TestManyCurves(check, 1, 0, 0);
  TestManyCurves(check, 70000, 0, 4);
  for (int bins : { 0, 8, 32, 512 })
  {
    TestHelix(check, 0.1, bins);
    TestHelix(check, 0.01, bins);
    TestHelix(check, 0.2, bins);
  }
  TestLoop(check);
  TestPlanes(check);
  TestCrowdedVoxel(check);
  return check.GetResult();
}
