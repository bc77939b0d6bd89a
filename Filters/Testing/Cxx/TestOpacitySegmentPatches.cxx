// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the patches of surfaces: geodesic distances against exact ones on a plane and a sphere,
 * that each point has its nearest seeds, that seeds are placed as far from each other as the
 * farthest-point property says, weights that are continuous, which patches are neighbours, and that
 * all kinds of polygons, pieces, and points that are not merged are treated alike.
 */

#include "OpacitySegmentTesting.h"
#include "vtkIdList.h"
#include "vtkSphereSource.h"

using namespace OpacitySegmentTesting;

namespace
{

/// The points that are seeds, by id.
std::vector<Point> FindSeeds(Checks& check, const Segments& segments)
{
  const std::vector<Point> points = GetPoints(segments.Output);
  std::vector<Point> seeds(static_cast<std::size_t>(segments.Filter->GetNumberOfSegments()));
  std::set<int> found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (segments.GetDistance(static_cast<vtkIdType>(i), 0) == 0.0)
    {
      const int id = segments.GetId(static_cast<vtkIdType>(i));
      seeds[static_cast<std::size_t>(id)] = points[i];
      check(found.insert(id).second, "each seed is one point");
    }
  }
  check(found.size() == seeds.size(), "each patch has a seed");
  return seeds;
}

/// How far distances are from exact ones.
struct Errors
{
  /// Of a seed that is told, relative to its distance.
  double Relative = 0.0;
  /// Of the three that are told against the three smallest exact ones, and of the cut-off.
  double Nearest = 0.0;
  double CutOff = 0.0;
};

template <typename DistanceT>
Errors FindErrors(Checks& check, const Segments& segments, DistanceT&& distance)
{
  const std::vector<Point> seeds = FindSeeds(check, segments);
  const std::vector<Point> points = GetPoints(segments.Output);
  Errors errors;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<double> exact;
    for (const Point& seed : seeds)
    {
      exact.push_back(distance(points[i], seed));
    }
    double found[4];
    for (int j = 0; j < 4; ++j)
    {
      found[j] = segments.GetDistance(static_cast<vtkIdType>(i), j);
    }
    for (int j = 0; j < 3; ++j)
    {
      const int id = segments.GetId(static_cast<vtkIdType>(i), j);
      const double own = exact[static_cast<std::size_t>(id)];
      errors.Relative = std::max(errors.Relative, std::abs(found[j] - own) / std::max(own, 1e-3));
    }
    std::sort(exact.begin(), exact.end());
    for (std::size_t j = 0; j < 3; ++j)
    {
      errors.Nearest = std::max(errors.Nearest, std::abs(found[j] - exact[j]));
    }
    errors.CutOff = std::max(errors.CutOff, std::abs(found[3] - exact[3]));
  }
  return errors;
}

void TestPlane(Checks& check)
{
  const int n = 50;
  for (double jitter : { 0.0, 0.5 })
  {
    Segments segments;
    segments.Filter->SetNumberOfPatches(40);
    segments.Update(MakeGrid(n, jitter, 5));
    segments.CheckArrays(check, "plane");
    check(segments.Filter->GetNumberOfSegmentsOfSurfaces() == 40, "as many as asked for");
    const auto errors =
      FindErrors(check, segments, [](const Point& a, const Point& b) { return Length(a - b); });
    // All but a few fourth distances are exact; those are off by a fraction of an edge.
    std::cout << "plane: " << errors.Relative << ", " << errors.Nearest * n << " and "
              << errors.CutOff * n << " edges" << std::endl;
    check(errors.Relative < 1e-6 && errors.Nearest * n < 1e-5 && errors.CutOff * n < 0.1,
      "distances on a plane");
  }
}

/// On a regular grid, many points are equally far from two seeds: they belong to the first one.
void TestTies(Checks& check)
{
  Segments segments;
  segments.Filter->SetNumberOfPatches(40);
  segments.Update(MakeGrid(40, 0.0));
  const std::vector<Point> seeds = FindSeeds(check, segments);
  const std::vector<Point> points = GetPoints(segments.Output);
  int ties = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::size_t first = 0;
    for (std::size_t k = 1; k < seeds.size(); ++k)
    {
      first = Length(points[i] - seeds[k]) < Length(points[i] - seeds[first]) - 1e-12 ? k : first;
    }
    const int id = segments.GetId(static_cast<vtkIdType>(i));
    ties += std::abs(segments.GetDistance(static_cast<vtkIdType>(i), 0) -
              segments.GetDistance(static_cast<vtkIdType>(i), 1)) < 1e-6
      ? 1
      : 0;
    check(id == static_cast<int>(first), "of two seeds that are equally far, the first one counts");
  }
  check(ties > 20, "there are ties");
}

void TestSphere(Checks& check)
{
  const int resolutions[] = { 26, 51 };
  const double limits[] = { 0.008, 0.0045 };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(2 * resolutions[i]);
    sphere->SetPhiResolution(resolutions[i]);
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    sphere->Update();
    Segments segments;
    segments.Filter->SetNumberOfPatches(20);
    segments.Update(sphere->GetOutput());
    segments.CheckArrays(check, "sphere");
    const Errors errors = FindErrors(check, segments,
      [](const Point& a, const Point& b) { return 2.0 * std::asin(0.5 * Length(a - b)); });
    std::cout << "sphere: " << errors.Relative << ", " << errors.Nearest << ", " << errors.CutOff
              << std::endl;
    check(
      errors.Relative < limits[i] && errors.Nearest < limits[i] && errors.CutOff < 1.5 * limits[i],
      "distances on a sphere");
  }
}

/// Long triangles in planes that contradict each other: distances do not improve for minutes, and
/// lie between those through the air and those along edges.
void TestSlivers(Checks& check)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(100);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  std::vector<Point> points = GetPoints(sphere->GetOutput());
  for (Point& point : points)
  {
    point[0] *= 10.0;
  }
  vtkSmartPointer<vtkPolyData> data = MakeData(points);
  data->SetPolys(sphere->GetOutput()->GetPolys());
  Segments segments;
  segments.Filter->SetNumberOfPatches(100);
  segments.Update(data);
  segments.CheckArrays(check, "slivers");
  const std::vector<Point> seeds = FindSeeds(check, segments);
  double smallest = 1e30;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int id = segments.GetId(static_cast<vtkIdType>(i), j);
      const double air = Length(points[i] - seeds[static_cast<std::size_t>(id)]);
      const double found = segments.GetDistance(static_cast<vtkIdType>(i), j);
      smallest = air > 0.0 ? std::min(smallest, found / air) : smallest;
    }
  }
  // The first seed is at one tip, from which Bellman-Ford along the edges bounds its distances.
  std::vector<double> alongEdges(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    alongEdges[i] = points[i] == seeds[0] ? 0.0 : 1e30;
  }
  vtkNew<vtkIdList> ids;
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    for (vtkIdType cell = 0; cell < data->GetPolys()->GetNumberOfCells(); ++cell)
    {
      data->GetPolys()->GetCellAtId(cell, ids);
      for (vtkIdType i = 0; i < 6; ++i)
      {
        const std::size_t a = static_cast<std::size_t>(ids->GetId(i % 3));
        const std::size_t b = static_cast<std::size_t>(ids->GetId((i + 1 + i / 3) % 3));
        const double way = alongEdges[a] + Length(points[a] - points[b]);
        isChanged = isChanged || way < alongEdges[b];
        alongEdges[b] = std::min(alongEdges[b], way);
      }
    }
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int j = 0; j < 3 && alongEdges[i] > 0.0; ++j)
    {
      largest = segments.GetId(static_cast<vtkIdType>(i), j) == 0
        ? std::max(largest, segments.GetDistance(static_cast<vtkIdType>(i), j) / alongEdges[i])
        : largest;
    }
  }
  std::cout << "slivers: " << smallest << " to " << largest << std::endl;
  check(largest < 1.0001, "no way is longer than along the edges");
  check(smallest > 0.9, "no way is much shorter than through the air");
}

void TestFarthestPoints(Checks& check)
{
  Segments segments;
  segments.Filter->SetNumberOfPatches(60);
  vtkSmartPointer<vtkPolyData> grid = MakeGrid(40, 0.5);
  segments.Update(grid);
  const std::vector<Point> seeds = FindSeeds(check, segments);
  const std::vector<Point> points = GetPoints(grid);
  // The first one is the farthest from the first vertex, and each further one the farthest from
  // those before it: a seed that is not would leave a vertex farther away.
  std::vector<double> nearest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    nearest[i] = Length(points[i] - points[0]);
  }
  for (std::size_t k = 0; k < seeds.size(); ++k)
  {
    std::size_t index = 0;
    while (points[index] != seeds[k])
    {
      ++index;
    }
    const double lack = *std::max_element(nearest.begin(), nearest.end()) - nearest[index];
    check(lack < 1e-6,
      "seed " + std::to_string(k) + " is the farthest vertex: " + std::to_string(lack));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double distance = Length(points[i] - seeds[k]);
      nearest[i] = k == 0 ? distance : std::min(nearest[i], distance);
    }
  }
}

void TestContinuity(Checks& check)
{
  // Along an edge of length h, each distance and the cut-off c change by h at most, and so does
  // a weight by 2 h / c, before the division by their sum. Six segments may be involved.
  const int n = 150;
  Segments segments;
  segments.Filter->SetNumberOfPatches(15);
  vtkSmartPointer<vtkPolyData> grid = MakeGrid(n, 0.5);
  segments.Update(grid);
  const std::vector<Point> points = GetPoints(grid);
  double largest = 0.0;
  const auto rawSum = [&](vtkIdType point)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum += 1.0 - segments.GetDistance(point, i) / segments.GetDistance(point, 3);
    }
    return sum;
  };
  for (const Cell& cell : MakeGridTriangles(n))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const vtkIdType ends[2] = { cell[i], cell[(i + 1) % 3] };
      std::map<int, double> change;
      for (int side = 0; side < 2; ++side)
      {
        const auto w = segments.GetWeights(ends[side]);
        for (std::size_t j = 0; j < 3; ++j)
        {
          change[segments.GetId(ends[side], static_cast<int>(j))] += side == 0 ? w[j] : -w[j];
        }
      }
      double total = 0.0;
      for (const auto& entry : change)
      {
        total += std::abs(entry.second);
      }
      const double h = Length(
        points[static_cast<std::size_t>(ends[0])] - points[static_cast<std::size_t>(ends[1])]);
      const double bound =
        h / segments.GetDistance(ends[0], 3) / std::max(rawSum(ends[0]), rawSum(ends[1]));
      largest = std::max(largest, total / bound);
    }
  }
  std::cout << "continuity: " << largest << std::endl;
  check(largest < 12.0, "weights change little along an edge");
}

void TestNeighbors(Checks& check)
{
  const int n = 40;
  Segments segments;
  segments.Filter->SetNumberOfPatches(30);
  segments.Update(MakeGrid(n, 0.5));
  std::set<std::pair<int, int>> expected;
  for (const Cell& cell : MakeGridTriangles(n))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int a = segments.GetId(cell[i]);
      const int b = segments.GetId(cell[(i + 1) % 3]);
      if (a != b)
      {
        expected.emplace(std::min(a, b), std::max(a, b));
      }
    }
  }
  const auto pairs = segments.GetPairs();
  check(std::vector<std::pair<int, int>>(expected.begin(), expected.end()) == pairs,
    "patches that an edge joins are neighbours");
}

/// What the points have, sorted by coordinates of the points; ids are told by the points of seeds.
std::vector<std::vector<double>> Describe(Checks& check, const Segments& segments)
{
  const std::vector<Point> points = GetPoints(segments.Output);
  std::vector<Point> seeds(static_cast<std::size_t>(segments.Filter->GetNumberOfSegments()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (segments.GetDistance(static_cast<vtkIdType>(i), 0) == 0.0)
    {
      seeds[static_cast<std::size_t>(segments.GetId(static_cast<vtkIdType>(i)))] = points[i];
    }
  }
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::vector<double> row(points[i].begin(), points[i].end());
    for (int j = 0; j < 4; ++j)
    {
      row.push_back(std::round(1e5 * segments.GetDistance(static_cast<vtkIdType>(i), j)));
    }
    const Point& seed = seeds[static_cast<std::size_t>(segments.GetId(static_cast<vtkIdType>(i)))];
    row.insert(row.end(), seed.begin(), seed.end());
    rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  check(rows.size() > 100, "there are points");
  return rows;
}

void TestStorage(Checks& check)
{
  const int n = 20;
  vtkSmartPointer<vtkPolyData> grid = MakeGrid(n, 0.5);
  Segments segments;
  segments.Filter->SetNumberOfPatches(12);
  segments.Update(grid);
  const auto expected = Describe(check, segments);

  // Each triangle with points of its own.
  const std::vector<Point> points = GetPoints(grid);
  std::vector<Point> soup;
  std::vector<Cell> cells;
  for (const Cell& cell : MakeGridTriangles(n))
  {
    cells.emplace_back();
    for (vtkIdType id : cell)
    {
      cells.back().push_back(static_cast<vtkIdType>(soup.size()));
      soup.push_back(points[static_cast<std::size_t>(id)]);
    }
  }
  vtkSmartPointer<vtkPolyData> separate = MakeData(soup);
  separate->SetPolys(MakeCells(cells));
  segments.Update(separate);
  segments.CheckArrays(check, "separate triangles");
  check(Describe(check, segments) == expected, "points at the same place are one vertex");

  // Points in another order, but for the first one, from which the first seed is found.
  std::vector<vtkIdType> order;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    order.push_back(static_cast<vtkIdType>(i));
  }
  std::mt19937 generator(9);
  for (std::size_t i = order.size() - 1; i > 1; --i)
  {
    std::swap(order[i], order[1 + generator() % i]);
  }
  std::vector<Point> shuffled(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    shuffled[static_cast<std::size_t>(order[i])] = points[i];
  }
  cells = MakeGridTriangles(n);
  for (Cell& cell : cells)
  {
    for (vtkIdType& id : cell)
    {
      id = order[static_cast<std::size_t>(id)];
    }
  }
  vtkSmartPointer<vtkPolyData> mixed = MakeData(shuffled);
  mixed->SetPolys(MakeCells(cells));
  segments.Update(mixed);
  check(Describe(check, segments) == expected, "the order of the points does not matter");
}

/// A flat surface of squares, as quads, strips or large polygons, has the plane's distances.
void TestPolygons(Checks& check)
{
  const vtkIdType n = 16;
  const std::vector<Point> points = MakeGridPoints(n, 0.0);
  std::vector<Cell> quads;
  std::vector<Cell> strips;
  std::vector<Cell> polygons;
  for (vtkIdType i = 0; i < n; ++i)
  {
    strips.emplace_back();
    for (vtkIdType j = 0; j <= n; ++j)
    {
      strips.back().push_back(i * (n + 1) + j);
      strips.back().push_back((i + 1) * (n + 1) + j);
    }
    for (vtkIdType j = 0; j < n; ++j)
    {
      const vtkIdType a = i * (n + 1) + j;
      quads.push_back({ a, a + 1, a + n + 2, a + n + 1 });
    }
    for (vtkIdType j = 0; j < n; j += 2)
    {
      // Two squares with six corners.
      const vtkIdType a = i * (n + 1) + j;
      polygons.push_back({ a, a + 1, a + 2, a + n + 3, a + n + 2, a + n + 1 });
    }
  }
  for (const auto& cells : { quads, strips, polygons })
  {
    vtkSmartPointer<vtkPolyData> data = MakeData(points);
    cells == strips ? data->SetStrips(MakeCells(cells)) : data->SetPolys(MakeCells(cells));
    Segments segments;
    segments.Filter->SetNumberOfPatches(10);
    segments.Update(data);
    segments.CheckArrays(check, "polygons");
    check(!segments.Observer->GetWarning(), "no warning");
    const auto errors =
      FindErrors(check, segments, [](const Point& a, const Point& b) { return Length(a - b); });
    check(errors.Relative < 1e-6 && errors.Nearest * n < 1e-5 && errors.CutOff * n < 0.1,
      "distances over polygons of " + std::to_string(cells[0].size()) + " points");
  }
  // A quad like an arrow head; its shorter diagonal lies outside.
  vtkSmartPointer<vtkPolyData> arrow =
    MakeData({ { 0.0, 0.0, 0.0 }, { 1.0, 3.0, 0.0 }, { 0.0, 2.9, 0.0 }, { -1.0, 3.0, 0.0 } });
  arrow->SetPolys(MakeCells({ { 0, 1, 2, 3 } }));
  Segments segments;
  segments.Filter->SetNumberOfPatches(2);
  segments.Update(arrow);
  // The seeds are points 1 and 0, and from point 3 to 1 the way leads through the notch's corner.
  check(segments.GetId(1) == 0 && segments.GetId(0) == 1 &&
      std::abs(segments.GetDistance(3, 0) - 2.0 * std::sqrt(1.01)) < 1e-6 &&
      std::abs(segments.GetDistance(3, 1) - std::sqrt(10.0)) < 1e-6,
    "a concave quad is parted inside");
}

void TestPieces(Checks& check)
{
  // Pieces of one, two, three and many patches: three small triangles and a grid.
  std::vector<Point> points = MakeGridPoints(20, 0.5);
  std::vector<Cell> cells = MakeGridTriangles(20);
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    const double size = 0.1 * i + 0.1;
    points.push_back({ 0.0, 0.0, 3.0 + i });
    points.push_back({ size, 0.0, 3.0 + i });
    points.push_back({ 0.0, 0.9 * size, 3.0 + i });
    cells.push_back({ first, first + 1, first + 2 });
  }
  vtkSmartPointer<vtkPolyData> data = MakeData(points);
  data->SetPolys(MakeCells(cells));
  Segments segments;
  for (int number : { 1, 4, 30, 100000 })
  {
    segments.Filter->SetNumberOfPatches(number);
    segments.Update(data);
    const std::string name = std::to_string(number) + " patches";
    segments.CheckArrays(check, name);
    const int expected = std::min(std::max(number, 4), static_cast<int>(points.size()));
    check(segments.Filter->GetNumberOfSegmentsOfSurfaces() == expected,
      name + ": at least one for each piece, at most one for each vertex");
    // No patch lies on two pieces.
    std::map<int, double> heights;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        const int id = segments.GetId(static_cast<vtkIdType>(i), j);
        check(id < 0 || heights.emplace(id, points[i][2]).first->second == points[i][2],
          name + ": a patch is on one piece");
      }
    }
  }
  const vtkIdType last = static_cast<vtkIdType>(points.size()) - 1;
  check(segments.GetId(last, 2) >= 0 &&
      std::abs(segments.GetDistance(last, 3) - 0.3 * std::sqrt(1.81)) < 1e-6,
    "the cut-off of a piece with three seeds is its largest distance");
  segments.Filter->SetNumberOfPatches(4);
  segments.Update(data);
  check(segments.GetId(last, 1) == -1 && segments.GetDistance(last, 0) == 0.0 &&
      segments.GetDistance(last, 3) == 1.0,
    "a single patch of a piece counts alone");
}

}

int TestOpacitySegmentPatches(int, char*[])
{
  Checks check;
  TestPlane(check);
  TestTies(check);
  TestSphere(check);
  TestSlivers(check);
  TestFarthestPoints(check);
  TestContinuity(check);
  TestNeighbors(check);
  TestStorage(check);
  TestPolygons(check);
  TestPieces(check);
  return check.GetResult();
}
