// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the representative lines of vtkVoxelLineLevel in cases whose averages can be told by hand:
 * one line, bundles along and against each other, crossing lines, lines that end or stay inside a
 * voxel, ends that meet on a face; values, colours and radii; bad input; and what
 * vtkVoxelLineGeometry makes of a level.
 */

#include "VoxelLineTesting.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkVoxelLineGeometry.h"
#include "vtkVoxelLineLevel.h"

#include <limits>
#include <set>

using namespace VoxelLineTesting;

namespace
{

constexpr int GridSize = 8;

/// A model with voxels of size 1, from 0 to 8 along each axis.
vtkSmartPointer<vtkVoxelLineModel> MakeUnitModel(Checks& check, vtkPolyData* lines, int bins = 32)
{
  vtkNew<vtkLineVoxelizer> voxelizer;
  voxelizer->SetInputData(lines);
  voxelizer->SetResolution(GridSize);
  voxelizer->SetFaceBins(bins);
  voxelizer->UseCustomBoundsOn();
  voxelizer->SetCustomBounds(0, GridSize, 0, GridSize, 0, GridSize);
  voxelizer->SetRadiusArrayName(lines->GetPointData()->HasArray("Radius") ? "Radius" : "");
  voxelizer->Update();
  check(voxelizer->GetOutput()->GetVoxelSize() == 1.0, "voxels of size 1");
  return voxelizer->GetOutput();
}

vtkSmartPointer<vtkVoxelLineModel> MakeLevel(Checks& check, vtkVoxelLineModel* model, int level)
{
  vtkNew<vtkVoxelLineLevel> filter;
  filter->SetInputData(model);
  filter->SetLevel(level);
  filter->Update();
  vtkSmartPointer<vtkVoxelLineModel> output = filter->GetOutput();
  check(output->FindDefect().empty(), "no defect: " + output->FindDefect());
  bool isPlaced = output->GetVoxelSize() == model->GetVoxelSize() * (1 << level);
  for (int axis = 0; axis < 3; ++axis)
  {
    isPlaced = isPlaced && output->GetOrigin()[axis] == model->GetOrigin()[axis] &&
      output->GetDimensions()[axis] ==
        static_cast<int>(std::ceil(model->GetDimensions()[axis] / std::pow(2.0, level)));
  }
  check(isPlaced, "placement of the level");
  check(output->GetNumberOfSegments() == output->GetNumberOfOccupiedVoxels(),
    "one segment for each voxel");
  return output;
}

/// The segment of a voxel; a failure where there is none.
Segment FindSegment(Checks& check, const std::vector<Segment>& segments, std::array<int, 3> voxel)
{
  for (const Segment& segment : segments)
  {
    if (segment.Voxel == voxel)
    {
      return segment;
    }
  }
  check(false, "a segment in the voxel");
  return {};
}

/// Whether a segment goes between two points, within a tolerance; in this direction.
bool IsAlong(const Segment& segment, const Point& start, const Point& end, double tolerance)
{
  return Length(segment.Start - start) <= tolerance && Length(segment.End - end) <= tolerance;
}

/// Half the diagonal of a face's bin, twice: of the model and of the level, in voxels of the
/// latter.
double BinOf(int bins)
{
  return bins > 0 ? 2.0 * std::sqrt(0.5) / bins : 1e-5;
}

/// The same inside a voxel, with 32 bins on its faces; so are the ends of lines rounded.
constexpr double InteriorBin = 1.7320508 / 12;

/// A single line is its own representative, in a chain that hangs together, with both its ends.
void TestOneLine(Checks& check, int bins)
{
  const Point start = { 0.3, 0.4, 0.6 };
  const Point end = { 7.6, 4.3, 6.9 };
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeUnitModel(check, MakeLines({ { start, end } }), bins);
  for (int level = 0; level <= 3; ++level)
  {
    const std::string name = std::to_string(bins) + " bins, level " + std::to_string(level);
    vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, level);
    const std::vector<Segment> segments = DecodeModel(output);
    const double size = 1 << level;
    // Inside a voxel, bins are coarser.
    const double inside = bins > 0 ? std::sqrt(3.0) / output->GetInteriorBins() : 1e-5;
    double farthest = 0.0;
    std::set<std::array<int, 3>> voxels;
    for (const Segment& segment : DecodeModel(model))
    {
      voxels.insert(
        { segment.Voxel[0] >> level, segment.Voxel[1] >> level, segment.Voxel[2] >> level });
    }
    for (const Segment& segment : segments)
    {
      farthest = std::max({ farthest, Distance(size * segment.Start, start, end),
        Distance(size * segment.End, start, end) });
      check(voxels.count(segment.Voxel) == 1, name + ": a voxel that the line goes through");
    }
    check(segments.size() == voxels.size(), name + ": all voxels that the line goes through");
    check(farthest <= size * std::max(inside, BinOf(bins)), name + ": the line itself");
    const std::vector<Segment> chain = Chain(segments, 0);
    check(chain.size() == segments.size() && !chain.empty() &&
        Length(size * chain.front().Start - start) <= size * inside &&
        Length(size * chain.back().End - end) <= size * inside,
      name + ": a chain from end to end");
  }
}

/// Lines side by side: their mean, whichever way each of them goes, and in whatever order.
void TestBundles(Checks& check)
{
  const std::vector<std::array<double, 2>> offsets = { { 0.1, 0.3 }, { 0.3, 0.5 }, { 0.8, 0.1 },
    { 0.4, 0.9 }, { 0.5, 0.2 } };
  const Point mean = { 0.0, 0.42, 0.4 };
  for (const unsigned reversed : { 0u, 1u, 2u, 6u, 9u, 21u, 30u })
  {
    for (const bool isBackwards : { false, true })
    {
      std::vector<Curve> curves;
      for (std::size_t i = 0; i < offsets.size(); ++i)
      {
        const std::size_t j = isBackwards ? offsets.size() - 1 - i : i;
        Curve curve = { { 0.0, 2.0 + offsets[j][0], 3.0 + offsets[j][1] },
          { 8.0, 2.0 + offsets[j][0], 3.0 + offsets[j][1] } };
        if (reversed >> j & 1u)
        {
          std::reverse(curve.begin(), curve.end());
        }
        curves.push_back(curve);
      }
      const std::string name = "bundle " + std::to_string(reversed) + (isBackwards ? "b" : "a");
      vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines(curves));
      vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, 0);
      const std::vector<Segment> segments = DecodeModel(output);
      check(segments.size() == 8, name + ": eight voxels");
      for (const Segment& segment : segments)
      {
        const double x = segment.Voxel[0];
        Point start = { x, 2.0 + mean[1], 3.0 + mean[2] };
        Point end = { x + 1.0, 2.0 + mean[1], 3.0 + mean[2] };
        // All are equally long: the first one gives direction and curve.
        if (reversed >> (isBackwards ? 4 : 0) & 1u)
        {
          std::swap(start, end);
        }
        const bool isEnd = segment.Voxel[0] == 0 || segment.Voxel[0] == 7;
        // There, rounding decides which line is the longest.
        check(isEnd
            ? IsAlong(segment, start, end, InteriorBin) || IsAlong(segment, end, start, InteriorBin)
            : IsAlong(segment, start, end, BinOf(32)) && segment.Curve == 0,
          name + ": the mean");
      }
    }
  }
}

/// Two lines exactly against each other do not cancel; those that cross are averaged as they are.
void TestPairs(Checks& check)
{
  const Curve there = { { 0.0, 2.25, 2.5 }, { 8.0, 2.25, 2.5 } };
  const Curve back = { { 8.0, 2.75, 2.5 }, { 0.0, 2.75, 2.5 } };
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines({ there, back }));
  for (int level = 0; level <= 1; ++level)
  {
    const int size = 1 << level;
    for (const Segment& segment : DecodeModel(MakeLevel(check, model, level)))
    {
      const double x = segment.Voxel[0];
      const bool isEnd = segment.Voxel[0] == 0 || segment.Voxel[0] == 8 / size - 1;
      check(IsAlong(segment, { x, 2.5 / size, 2.5 / size }, { x + 1.0, 2.5 / size, 2.5 / size },
              isEnd ? InteriorBin : BinOf(32)),
        "antiparallel lines at level " + std::to_string(level));
    }
  }

  // Along x and y through the middle of voxel (2,2,2): mean start (1/4, 1/4), mean end (3/4, 3/4),
  // each a quarter from two faces, of which the first, across x, is taken.
  const Curve across = { { 2.5, 0.0, 2.5 }, { 2.5, 8.0, 2.5 } };
  const Curve along = { { 0.0, 2.5, 2.5 }, { 8.0, 2.5, 2.5 } };
  model = MakeUnitModel(check, MakeLines({ across, along }), 64);
  vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, 0);
  const Segment middle = FindSegment(check, DecodeModel(output), { 2, 2, 2 });
  // The neighbours' ends lie on the faces too, in the middle: joined, they meet half-way.
  check(IsAlong(middle, { 2.0, 2.375, 2.5 }, { 3.0, 2.625, 2.5 }, 0.04), "crossing lines");
  const Segment before = FindSegment(check, DecodeModel(output), { 1, 2, 2 });
  const Segment after = FindSegment(check, DecodeModel(output), { 3, 2, 2 });
  check(before.End == middle.Start && after.Start == middle.End, "crossing lines are connected");
}

/// The representative goes the way of the longest line, though its axis is made by others.
void TestDirection(Checks& check)
{
  // Lines at -85 and at 80 degrees: both go along with the longest, at 0; together, those at 80
  // turn round to -100, and the sum is at more than 90 degrees to the longest.
  std::vector<Curve> curves(1, { { 2.02, 2.5, 2.5 }, { 2.98, 2.5, 2.5 } });
  for (int i = 0; i < 39; ++i)
  {
    const double angle = (i < 20 ? -85.0 : 80.0) / 57.2957795;
    const Point half = { 0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.0 };
    const Point middle = { 2.5, 2.5, 2.5 };
    curves.push_back({ middle - half, middle + half });
  }
  for (const bool isReversed : { false, true })
  {
    vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines(curves), 0);
    const Segment segment =
      FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 });
    const Point chord = (isReversed ? -1.0 : 1.0) * (segment.End - segment.Start);
    check(
      segment.Curve == 0 && chord[0] > 0.0 && chord[1] > 0.5, "the direction of the longest line");
    std::reverse(curves[0].begin(), curves[0].end());
  }
}

/// Two ends on one face meet in the bin of their mean.
void TestJoin(Checks& check)
{
  // In voxel (1,0,0), the second line comes in from above, so that the mean of the starts is at
  // 0.6, while that of the ends in voxel (0,0,0) is at 0.2.
  const Curve first = { { 0.0, 0.2, 0.5 }, { 2.0, 0.2, 0.5 } };
  const Curve second = { { 1.04, 1.5, 0.5 }, { 1.05, 1.0, 0.5 }, { 2.0, 0.6, 0.5 } };
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines({ first, second }));
  const std::vector<Segment> segments = DecodeModel(MakeLevel(check, model, 0));
  const Segment left = FindSegment(check, segments, { 0, 0, 0 });
  const Segment right = FindSegment(check, segments, { 1, 0, 0 });
  check(left.End == right.Start, "two ends on a face meet");
  check(IsAlong(left, { 0.0, 0.2, 0.5 }, { 1.0, 0.4, 0.5 }, InteriorBin) &&
      std::abs(left.End[1] - 0.4) < 1.5 / 32,
    "in their mean");
  check(std::abs(right.End[0] - 2.0) < 1e-9 && std::abs(right.End[1] - 0.4) < 1.5 / 32,
    "other ends stay");
  // The codes spell the same bin on either side.
  check((left.EndCode ^ right.StartCode) == 1u << 10, "the same bin on either side");
}

/// Lines that begin, end or stay inside a voxel.
void TestInside(Checks& check)
{
  const double bin = InteriorBin;
  // Two that end inside: the mean of the ends stays inside.
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check,
    MakeLines(
      { { { 2.0, 2.2, 2.5 }, { 2.6, 2.2, 2.5 } }, { { 2.0, 2.4, 2.5 }, { 2.4, 2.8, 2.5 } } }));
  Segment segment = FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 });
  check(IsAlong(segment, { 2.0, 2.3, 2.5 }, { 2.5, 2.5, 2.5 }, bin), "lines that end in a voxel");
  // One ends inside, the other goes on: the mean is put on the nearest face.
  model = MakeUnitModel(check,
    MakeLines(
      { { { 2.0, 2.2, 2.5 }, { 2.6, 2.2, 2.5 } }, { { 2.0, 2.4, 2.5 }, { 4.0, 2.4, 2.5 } } }));
  segment = FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 });
  check(IsAlong(segment, { 2.0, 2.3, 2.5 }, { 3.0, 2.3, 2.5 }, 0.1) && segment.End[0] == 3.0 &&
      segment.Curve == 1,
    "one line that ends in a voxel");
  // A line inside, and a point.
  model = MakeUnitModel(check, MakeLines({ { { 2.2, 2.2, 2.5 }, { 2.6, 2.2, 2.5 } } }));
  segment = FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 });
  check(IsAlong(segment, { 2.2, 2.2, 2.5 }, { 2.6, 2.2, 2.5 }, bin), "a line inside a voxel");
  model = MakeUnitModel(check, MakeLines({ { { 2.2, 2.2, 2.5 }, { 2.2, 2.2, 2.5 } } }));
  for (int level = 0; level <= 3; ++level)
  {
    const std::vector<Segment> segments = DecodeModel(MakeLevel(check, model, level));
    check(segments.size() == 1 && segments[0].Start == segments[0].End &&
        Length(std::pow(2.0, level) * segments[0].Start - Point{ 2.2, 2.2, 2.5 }) <
          std::pow(2.0, level) * bin,
      "a point");
  }
  // Lines up and down cancel, as they are at right angles to the first; what is left of its length
  // is less than a bin. It stands for all of them.
  std::vector<Curve> cross(1, { { 2.1, 2.5, 2.5 }, { 2.9, 2.5, 2.5 } });
  for (int i = 0; i < 10; ++i)
  {
    cross.push_back({ { 2.5, 2.1, 2.5 }, { 2.5, 2.9, 2.5 } });
    cross.push_back({ { 2.5, 2.9, 2.5 }, { 2.5, 2.1, 2.5 } });
  }
  model = MakeUnitModel(check, MakeLines(cross));
  segment = FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 });
  check(IsAlong(segment, { 2.1, 2.5, 2.5 }, { 2.9, 2.5, 2.5 }, bin) && segment.Curve == 0,
    "an average that is a point gives way to the longest line");
}

/// A ring inside a voxel of a level, and a curve that comes back into a voxel.
void TestReturns(Checks& check)
{
  Curve ring;
  for (int i = 0; i <= 64; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (i % 64 + 0.3) / 64;
    ring.push_back({ 2.0 + 1.3 * std::cos(angle), 2.0 + 1.3 * std::sin(angle), 2.1 });
  }
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines({ ring }));
  std::vector<Segment> segments = DecodeModel(MakeLevel(check, model, 2));
  check(segments.size() == 1 && segments[0].Start == segments[0].End,
    "a ring in a voxel begins where it ends");

  // Through the first voxel of level 2, and around its corner into it again.
  const Curve hook = { { 0.2, 0.4, 1.9 }, { 6.0, 0.4, 1.9 }, { 6.0, 6.0, 1.9 }, { 2.0, 6.0, 1.9 },
    { 2.3, 4.0, 1.9 }, { 2.6, 2.0, 1.9 } };
  model = MakeUnitModel(check, MakeLines({ hook }));
  const Segment twice = FindSegment(check, DecodeModel(MakeLevel(check, model, 2)), { 0, 0, 0 });
  // The means of two passages, the latter joined with the next voxel's start at 0.1.
  check(IsAlong(twice, { 0.0, 0.55, 0.475 }, { 1.0, 0.2, 0.475 }, 0.06),
    "a curve that comes back has two passages");
}

/// A curve of many segments in a voxel of a level, the same points again and again.
void TestManyParts(Checks& check)
{
  for (const int turns : { 1, 3, 60 })
  {
    Curve curve = { { 0.2, 0.3, 0.6 } };
    for (int turn = 0; turn < turns; ++turn)
    {
      for (int i = 0; i < 7; ++i)
      {
        const double x = 0.4 + 0.5 * i;
        curve.push_back({ x, 0.4, 0.6 });
        curve.push_back({ x, 3.4, 0.6 });
      }
      curve.push_back({ 3.4, 3.6, 0.6 });
      curve.push_back({ 0.4, 3.6, 0.6 });
    }
    curve.push_back({ 0.3, 3.2, 3.7 });
    vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, MakeLines({ curve }));
    for (int level = 2; level <= 3; ++level)
    {
      const double size = 1 << level;
      const std::vector<Segment> segments = DecodeModel(MakeLevel(check, model, level));
      check(segments.size() == 1 &&
          IsAlong(
            segments[0], (1.0 / size) * curve.front(), (1.0 / size) * curve.back(), InteriorBin),
        std::to_string(turns) + " turns in a voxel of level " + std::to_string(level));
    }
  }
}

/// Attributes and radii are means over the lines, without NaN; the longest line names the curve.
void TestValues(Checks& check)
{
  const std::vector<Curve> curves = { { { 0.0, 2.3, 2.5 }, { 8.0, 2.3, 2.5 } },
    { { 8.0, 2.5, 2.5 }, { 0.0, 2.5, 2.5 } }, { { 0.0, 2.4, 2.5 }, { 8.0, 2.4, 2.5 } } };
  vtkSmartPointer<vtkPolyData> lines = MakeLines(curves);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  // Along x: from 0 to 254, from 200 to 100 (the line goes back), and none.
  for (const double value : { 0.0, 254.0, 100.0, 200.0, nan, nan })
  {
    values->InsertNextValue(value);
  }
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (const double radius : { 0.1, 0.1, 0.3, 0.3, 0.5, 0.5 })
  {
    radii->InsertNextValue(radius);
  }
  lines->GetPointData()->SetScalars(values);
  lines->GetPointData()->AddArray(radii);
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check, lines);
  check(model->GetHasNaNAttribute(), "a model with NaN");
  for (int level = 0; level <= 3; ++level)
  {
    vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, level);
    check(output->GetAttributeKind() == vtkVoxelLineModel::Scalar && output->GetHasNaNAttribute() &&
        output->GetAttributeRange()[1] == 254.0 &&
        output->GetMaximumRadius() == model->GetMaximumRadius(),
      "kinds of values");
    for (const Segment& segment : DecodeModel(output))
    {
      for (int end = 0; end < 2; ++end)
      {
        // Where the lines end, rounding decides which one is the longest and gives the direction.
        const double x =
          std::lround((end == 0 ? segment.Start : segment.End)[0]) * std::pow(2.0, level) / 8.0;
        const double expected = 0.5 * (254.0 * x + 200.0 - 100.0 * x);
        check(std::abs(output->GetAttributes()->GetComponent(segment.Index, end) - expected) <= 1.5,
          "mean of values, level " + std::to_string(level));
        check(std::abs(output->GetRadii()->GetComponent(segment.Index, end) / 255.0 *
                  output->GetMaximumRadius() -
                0.3) < 0.003,
          "mean of radii");
      }
    }
  }

  // Where there is nothing but NaN, the mean is NaN.
  vtkSmartPointer<vtkPolyData> apart = MakeLines(
    { { { 0.5, 2.3, 2.5 }, { 7.5, 2.3, 2.5 } }, { { 0.5, 6.3, 2.5 }, { 7.5, 6.3, 2.5 } } });
  vtkNew<vtkDoubleArray> some;
  for (const double value : { 0.0, 254.0, nan, nan })
  {
    some->InsertNextValue(value);
  }
  apart->GetPointData()->SetScalars(some);
  vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, MakeUnitModel(check, apart), 1);
  for (const Segment& segment : DecodeModel(output))
  {
    check(
      (output->GetAttributes()->GetComponent(segment.Index, 0) == 255.0) == (segment.Voxel[1] == 3),
      "NaN where all are NaN");
  }

  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Values");
  colors->SetNumberOfComponents(4);
  const unsigned char color[6][4] = { { 10, 20, 30, 40 }, { 10, 20, 30, 40 }, { 40, 80, 90, 100 },
    { 40, 80, 90, 100 }, { 100, 200, 0, 250 }, { 100, 200, 0, 250 } };
  for (const auto& tuple : color)
  {
    colors->InsertNextTypedTuple(tuple);
  }
  lines->GetPointData()->SetScalars(colors);
  model = MakeUnitModel(check, lines);
  output = MakeLevel(check, model, 1);
  const int expected[4] = { 50, 100, 40, 130 };
  for (vtkIdType i = 0; i < output->GetNumberOfSegments(); ++i)
  {
    for (int component = 0; component < 8; ++component)
    {
      check(output->GetAttributes()->GetComponent(i, component) == expected[component % 4],
        "mean of colours");
    }
  }

  // The last of three lines is the longest in its voxel.
  model = MakeUnitModel(check,
    MakeLines({ { { 2.0, 2.9, 2.5 }, { 2.1, 3.0, 2.5 } }, { { 2.9, 2.0, 2.5 }, { 3.0, 2.1, 2.5 } },
      { { 2.0, 2.1, 2.5 }, { 3.0, 2.9, 2.5 } } }));
  check(FindSegment(check, DecodeModel(MakeLevel(check, model, 0)), { 2, 2, 2 }).Curve == 2,
    "the longest line names the curve");
}

void TestBadInput(Checks& check)
{
  vtkNew<vtkVoxelLineLevel> filter;
  check(filter->GetLevel() == 1, "default level");
  vtkNew<MessageObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeUnitModel(check, MakeLines({ { { 0.0, 2.3, 2.5 }, { 7.9, 5.3, 2.5 } } }));
  filter->SetInputData(model);
  for (const int level : { -1, 4, 40 })
  {
    observer->Clear();
    filter->SetLevel(level);
    filter->Update();
    check(observer->NumberOfErrors == 1 &&
        observer->ErrorMessage.find("Level is " + std::to_string(level)) != std::string::npos &&
        observer->ErrorMessage.find("levels 0 to 3") != std::string::npos &&
        filter->GetErrorCode() == vtkErrorCode::UserError &&
        filter->GetOutput()->GetNumberOfSegments() == 0,
      "a level that does not exist");
  }
  observer->Clear();
  filter->SetLevel(3);
  filter->Update();
  check(observer->NumberOfErrors == 0 && filter->GetErrorCode() == vtkErrorCode::NoError &&
      filter->GetOutput()->GetNumberOfSegments() == 1,
    "the last level");

  // Stopped half-way, there is nothing; afterwards everything.
  struct Stopper : vtkCommand
  {
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  };
  vtkSmartPointer<Stopper> stopper;
  stopper.TakeReference(new Stopper);
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  filter->SetLevel(1);
  filter->Update();
  check(
    filter->GetOutput()->GetNumberOfSegments() == 0 && filter->GetOutput()->FindDefect().empty(),
    "an aborted update");
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  check(filter->GetOutput()->GetNumberOfSegments() > 0, "an update after it");

  vtkNew<vtkVoxelLineModel> empty;
  filter->SetInputData(empty);
  filter->SetLevel(40);
  filter->Update();
  check(observer->NumberOfErrors == 0 && filter->GetOutput()->GetNumberOfSegments() == 0 &&
      filter->GetOutput()->FindDefect().empty(),
    "an empty model is empty at any level");
  filter->SetLevel(-1);
  filter->Update();
  check(observer->NumberOfErrors == 1, "but not below 0");
  observer->Clear();
  vtkNew<vtkVoxelLineModel> incomplete;
  incomplete->ShallowCopy(model);
  incomplete->SetBrickGrid(nullptr);
  filter->SetInputData(incomplete);
  filter->SetLevel(1);
  filter->Update();
  check(observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("BrickGrid is missing") != std::string::npos &&
      filter->GetOutput()->GetNumberOfSegments() == 0,
    "an incomplete model");
}

/// End points of all edges, in the order of their coordinates, whichever way they go.
std::vector<std::array<Point, 2>> EdgesOf(vtkPolyData* lines)
{
  std::vector<std::array<Point, 2>> edges;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    lines->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      std::array<Point, 2> edge;
      lines->GetPoint(ids->GetId(i - 1), edge[0].data());
      lines->GetPoint(ids->GetId(i), edge[1].data());
      edges.push_back(edge);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Stretches of one curve that do not hang together, and a ring among them, are all there.
void TestStretches(Checks& check)
{
  Curve ring;
  for (int i = 0; i <= 16; ++i)
  {
    const double angle = 2.0 * 3.14159265358979323846 * (i % 16 + 0.3) / 16;
    ring.push_back({ 6.0 + std::cos(angle), 6.0 + std::sin(angle), 6.1 });
  }
  vtkSmartPointer<vtkVoxelLineModel> model = MakeUnitModel(check,
    MakeLines({ { { 0.3, 0.5, 0.5 }, { 3.7, 0.6, 0.7 } }, ring,
      { { 0.3, 4.5, 0.5 }, { 3.7, 7.6, 0.7 } } }));
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputData(model);
  geometry->Update();
  const std::vector<std::array<Point, 2>> expected = EdgesOf(geometry->GetOutput());
  // All three have bricks of their own; let them be of one curve.
  model->GetBrickCurves()->Fill(0.0);
  model->Modified();
  geometry->Update();
  check(
    geometry->GetOutput()->GetNumberOfLines() == 3 && EdgesOf(geometry->GetOutput()) == expected,
    "three stretches of a curve");
}

/// vtkVoxelLineGeometry gives the lines of a level.
void TestGeometry(Checks& check)
{
  vtkSmartPointer<vtkVoxelLineModel> model =
    MakeModel(check, MakeLines(MakeSmoothCurves(60, 50)), 24, 32);
  vtkNew<vtkVoxelLineGeometry> geometry;
  geometry->SetInputData(model);
  vtkNew<vtkVoxelLineGeometry> direct;
  for (int level = 1; level <= 5; ++level)
  {
    const std::string name = "geometry of level " + std::to_string(level);
    vtkSmartPointer<vtkVoxelLineModel> output = MakeLevel(check, model, level);
    direct->SetInputData(output);
    direct->JoinOff();
    direct->Update();
    geometry->SetLevel(level);
    geometry->JoinOff();
    geometry->Update();
    const std::vector<std::array<Point, 2>> expected = EdgesOf(direct->GetOutput());
    check(expected.size() == static_cast<std::size_t>(output->GetNumberOfSegments()) &&
        EdgesOf(geometry->GetOutput()) == expected,
      name);
    geometry->JoinOn();
    geometry->Update();
    check(EdgesOf(geometry->GetOutput()) == expected &&
        (level > 2 ||
          geometry->GetOutput()->GetNumberOfLines() < direct->GetOutput()->GetNumberOfLines()),
      name + ", joined");
  }
  vtkNew<MessageObserver> observer;
  geometry->AddObserver(vtkCommand::ErrorEvent, observer);
  geometry->SetLevel(6);
  geometry->Update();
  check(observer->NumberOfErrors == 1 &&
      observer->ErrorMessage.find("levels 0 to 5") != std::string::npos &&
      geometry->GetErrorCode() == vtkErrorCode::UserError &&
      geometry->GetOutput()->GetNumberOfPoints() == 0,
    "geometry of a level that does not exist");
}

}

int TestVoxelLineLevel(int, char*[])
{
  Checks check;
  for (const int bins : { 4, 32, 256, 0 })
  {
    TestOneLine(check, bins);
  }
  TestBundles(check);
  TestPairs(check);
  TestDirection(check);
  TestJoin(check);
  TestInside(check);
  TestReturns(check);
  TestManyParts(check);
  TestValues(check);
  TestBadInput(check);
  TestStretches(check);
  TestGeometry(check);
  return check.GetResult();
}
