// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the segments of lines: that they have equal lengths and as many as asked for, that their
 * ids follow the lines, that opacity is interpolated linearly between their centres, on closed
 * lines too, which segments are neighbours, and to which line a shared point belongs.
 */

#include "OpacitySegmentTesting.h"

using namespace OpacitySegmentTesting;

namespace
{

double GetLength(const Curve& curve, std::size_t last)
{
  double length = 0.0;
  for (std::size_t i = 1; i <= last; ++i)
  {
    length += Length(curve[i] - curve[i - 1]);
  }
  return length;
}

void TestDivision(Checks& check)
{
  const std::vector<Curve> curves = MakeSmoothCurves(20, 300);
  vtkSmartPointer<vtkPolyData> lines = MakeLines(curves);
  double total = 0.0;
  for (const Curve& curve : curves)
  {
    total += GetLength(curve, curve.size() - 1);
  }
  Segments segments;
  segments.Filter->SetNumberOfLineSegments(400);
  for (bool isByLength : { false, true })
  {
    const std::string name = isByLength ? "by length" : "by number";
    const double wanted = isByLength ? 0.05 : total / 400.0;
    segments.Filter->SetSegmentLength(isByLength ? 0.05 : 0.0);
    segments.Update(lines);
    segments.CheckArrays(check, name);
    check(!segments.Observer->GetWarning(), name + ": no warning");
    int first = 0;
    vtkIdType point = 0;
    std::vector<std::pair<int, int>> pairs;
    for (const Curve& curve : curves)
    {
      const double length = GetLength(curve, curve.size() - 1);
      const int number = std::max(1, static_cast<int>(std::lround(length / wanted)));
      const double step = length / number;
      for (std::size_t i = 0; i < curve.size(); ++i, ++point)
      {
        // A function that is linear between the centres is interpolated exactly.
        const double position = GetLength(curve, i) / step;
        double value = 0.0;
        const auto w = segments.GetWeights(point);
        for (int j = 0; j < 3; ++j)
        {
          value += w[static_cast<std::size_t>(j)] * (segments.GetId(point, j) - first + 0.5);
        }
        const double expected = std::min(std::max(position, 0.5), number - 0.5);
        const double own = segments.GetId(point) - first;
        if (!check(std::abs(value - expected) < 1e-5 && own <= position + 1e-9 &&
                position <= own + 1.0 + 1e-9 && own >= 0 && own < number,
              name + ": linear interpolation"))
        {
          return;
        }
        if (segments.GetId(point, 1) >= 0)
        {
          check(std::abs(segments.GetDistance(point, 0) + segments.GetDistance(point, 1) - step) <
                1e-6 &&
              std::abs(segments.GetDistance(point, 3) - step) < 1e-6 &&
              segments.GetId(point, 2) == -1,
            name + ": distances are in world units");
        }
        else
        {
          check(segments.GetDistance(point, 0) == 0.0 && segments.GetDistance(point, 3) == 1.0,
            name + ": the end alone counts");
        }
      }
      for (int i = 1; i < number; ++i)
      {
        pairs.emplace_back(first + i - 1, first + i);
      }
      first += number;
    }
    check(segments.Filter->GetNumberOfSegmentsOfLines() == first &&
        segments.Filter->GetNumberOfSegments() == first,
      name + ": number of segments");
    check(isByLength || std::abs(first - 400) <= 10, name + ": about as many as asked for");
    check(segments.GetPairs() == pairs, name + ": neighbours");
  }
}

void TestClosedLines(Checks& check)
{
  // A square of side 1 that starts in the middle of a side, closed by an id or by coordinates.
  std::vector<Point> points = { { 0.5, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.5, 0.0, 0.0 } };
  for (vtkIdType last : { 0, 5 })
  {
    vtkSmartPointer<vtkPolyData> square = MakeData(points);
    square->SetLines(MakeCells({ { 0, 1, 2, 3, 4, last } }));
    Segments segments;
    segments.Filter->SetNumberOfLineSegments(8);
    segments.Update(square);
    segments.CheckArrays(check, "closed");
    using Pairs = std::vector<std::pair<int, int>>;
    check(segments.GetPairs() ==
        Pairs{ { 0, 1 }, { 0, 7 }, { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 5 }, { 5, 6 }, { 6, 7 } },
      "the last segment of a closed line is next to the first");
    check(segments.GetId(0) == 0 && segments.GetId(0, 1) == 7 &&
        std::abs(segments.GetWeights(0)[1] - 0.5) < 1e-6,
      "interpolation goes on across the seam");
    check(last == 0 ||
        (segments.GetId(5) == 7 && segments.GetId(5, 1) == 0 &&
          std::abs(segments.GetWeights(5)[1] - 0.5) < 1e-6),
      "and on its other side");
    check(segments.Filter->GetNumberOfSharedPoints() == 0, "a closed line shares no point");
    segments.Filter->SetNumberOfLineSegments(2);
    segments.Update(square);
    check(segments.GetPairs() == Pairs{ { 0, 1 } }, "two segments are neighbours once");
    segments.Filter->SetNumberOfLineSegments(1);
    segments.Update(square);
    check(segments.GetPairs().empty() && segments.GetId(2) == 0 && segments.GetId(2, 1) == -1,
      "a single segment has no neighbour");
  }
}

void TestSharedPoints(Checks& check)
{
  // Two lines cross in point 1; a triangle and vertices use points of them.
  vtkSmartPointer<vtkPolyData> data =
    MakeData({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 1.0, -1.0, 0.0 },
      { 1.0, 1.0, 0.0 }, { 5.0, 5.0, 5.0 }, { 6.0, 6.0, 6.0 }, { 7.0, 7.0, 7.0 } });
  data->SetLines(MakeCells({ { 0, 1, 2 }, { 3, 1, 4 } }));
  data->SetPolys(MakeCells({ { 4, 2, 5 } }));
  data->SetVerts(MakeCells({ { 6, 5 }, { 0, 6 }, { 7 } }));
  Segments segments;
  segments.Filter->SetSegmentLength(1.0);
  segments.Filter->SetNumberOfPatches(1);
  segments.Update(data);
  segments.CheckArrays(check, "shared points");
  check(segments.GetId(0) == 0 && segments.GetId(1) < 2 && segments.GetId(3) == 2 &&
      segments.GetId(4) == 3,
    "a point belongs to the first line that uses it");
  check(segments.GetId(2) == 1 && segments.GetId(5) == 4, "lines go before surfaces");
  check(segments.GetId(6) == 5 && segments.GetId(7) == 6 && segments.GetWeights(7)[0] == 1.0,
    "points that only vertices use follow, each once");
  check(segments.Filter->GetNumberOfSegmentsOfLines() == 4 &&
      segments.Filter->GetNumberOfSegmentsOfSurfaces() == 1 &&
      segments.Filter->GetNumberOfSegmentsOfPoints() == 2,
    "numbers of each kind");
  // 1 by lines, 2 and 4 by the triangle, 5 and 0 by vertices.
  check(segments.Filter->GetNumberOfSharedPoints() == 5, "shared points are counted");
}

void TestWeights(Checks& check)
{
  double w[3];
  const int ids[3] = { 4, 5, 6 };
  const float distances[4] = { 1.0f, 2.0f, 3.0f, 4.0f };
  vtkOpacitySegments::GetWeights(ids, distances, w);
  check(std::abs(w[0] - 0.5) < 1e-12 && std::abs(w[1] - 1.0 / 3.0) < 1e-12 &&
      std::abs(w[2] - 1.0 / 6.0) < 1e-12,
    "weights by hand");
  const int missing[3] = { 4, -1, -1 };
  vtkOpacitySegments::GetWeights(missing, distances, w);
  check(w[0] == 1.0 && w[1] == 0.0 && w[2] == 0.0, "missing segments have no weight");
  const float equal[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  vtkOpacitySegments::GetWeights(ids, equal, w);
  check(w[0] == 1.0 && w[1] == 0.0 && w[2] == 0.0, "no cut-off: the first one counts");
  const int none[3] = { -1, -1, -1 };
  vtkOpacitySegments::GetWeights(none, distances, w);
  check(w[0] == 0.0 && w[1] == 0.0 && w[2] == 0.0, "no segment: no weight");
}

}

int TestOpacitySegmentLines(int, char*[])
{
  Checks check;
  TestDivision(check);
  TestClosedLines(check);
  TestSharedPoints(check);
  TestWeights(check);
  return check.GetResult();
}
