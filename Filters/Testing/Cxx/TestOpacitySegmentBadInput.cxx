// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards that input which cannot be used never costs the valid rest, is counted, and is told in one
 * warning; that empty input gives empty arrays; and that ids stay exact in single precision.
 */

#include "OpacitySegmentTesting.h"

#include <limits>

using namespace OpacitySegmentTesting;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// One warning that has the text and no error; no warning at all for an empty text.
void CheckWarning(Checks& check, const Segments& segments, const std::string& text)
{
  const MessageObserver* observer = segments.Observer;
  check(observer->NumberOfErrors == 0 && observer->NumberOfWarnings == (text.empty() ? 0 : 1) &&
      observer->WarningMessage.find(text) != std::string::npos,
    "a warning with '" + text + "': " + observer->WarningMessage + observer->ErrorMessage);
}

void TestEmpty(Checks& check)
{
  Segments segments;
  vtkNew<vtkPolyData> nothing;
  segments.Update(nothing);
  segments.CheckArrays(check, "nothing");
  CheckWarning(check, segments, "");
  check(segments.Filter->GetNumberOfSegments() == 0, "nothing: no segments");

  vtkSmartPointer<vtkPolyData> points = MakeData({ { 0.0, 0.0, 0.0 }, { 1.0, 2.0, 3.0 } });
  segments.Update(points);
  segments.CheckArrays(check, "points without cells");
  CheckWarning(check, segments, "");
  check(segments.GetId(0) == -1 && segments.GetId(1, 2) == -1 && segments.GetDistance(1, 0) == 1.0,
    "points that nothing uses have no segment");

  nothing->SetLines(MakeCells({ { 0, 1 } }));
  nothing->SetPolys(MakeCells({ { 0, 1, 2 } }));
  nothing->SetStrips(MakeCells({ { 0, 1, 2, 3 } }));
  nothing->SetVerts(MakeCells({ { 0 } }));
  segments.Update(nothing);
  segments.CheckArrays(check, "cells without points");
  CheckWarning(check, segments, "do not exist");
  check(segments.Filter->GetNumberOfInvalidIds() == 2 + 3 + 4 + 1, "all ids are counted");

  nothing->SetLines(MakeCells({ {} }));
  nothing->SetPolys(MakeCells({ {} }));
  nothing->SetStrips(MakeCells({ {} }));
  nothing->SetVerts(MakeCells({ {} }));
  segments.Update(nothing);
  segments.CheckArrays(check, "cells of no points");
}

void TestLines(Checks& check)
{
  for (double bad : { NaN, Infinity, -Infinity })
  {
    vtkSmartPointer<vtkPolyData> data = MakeLines({ { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 } },
      { { 0.0, 1.0, 0.0 }, { 2.0, 1.0, 0.0 }, { 3.0, bad, 0.0 }, { 4.0, 1.0, 0.0 },
        { 6.0, 1.0, 0.0 }, { bad, 0.0, 0.0 }, { 7.0, 0.0, 0.0 } } });
    Segments segments;
    segments.Filter->SetSegmentLength(1.0);
    segments.Update(data);
    segments.CheckArrays(check, "lines with bad points");
    CheckWarning(check, segments, "2 points that are not finite");
    check(segments.Filter->GetNumberOfSegments() == 4 + 2 + 2 &&
        segments.Filter->GetNumberOfNonFinitePoints() == 2,
      "lines are parted at bad points");
    check(segments.GetId(1) == 3 && segments.GetId(3) == 5 && segments.GetId(4) == -1 &&
        segments.GetId(5) == 6 && segments.GetId(6) == 7 && segments.GetId(7) == -1 &&
        segments.GetId(8) == -1,
      "ids around bad points");
    check(segments.GetPairs().size() == 5, "no neighbours across bad points");
  }

  // Lines of one point, of no length, with repeated points, with ids that do not exist.
  vtkSmartPointer<vtkPolyData> data =
    MakeData({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 },
      { 4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 5.0, 0.0, 0.0 }, { 6.0, 0.0, 0.0 } });
  data->SetLines(MakeCells({ { 0 }, { 1, 1 }, { 2, 2, 3, 3 }, { 4, 5 }, { 6, 99, 7 }, { -1, 7 } }));
  Segments segments;
  segments.Filter->SetSegmentLength(0.5);
  segments.Update(data);
  segments.CheckArrays(check, "short lines");
  CheckWarning(check, segments, "2 point ids that do not exist, 1 lines of fewer than two points");
  check(segments.GetId(0) == -1 && segments.GetId(1) == 0 && segments.GetId(2) == 1 &&
      segments.GetId(3) == 2 && segments.GetId(4) == 3 && segments.GetId(5) == 3 &&
      segments.GetId(6) == -1 && segments.Filter->GetNumberOfSegments() == 4,
    "short lines have one segment each");
}

void TestSurfaces(Checks& check)
{
  // Triangles that are points, edges or slivers, ids that do not exist, a point that is not finite.
  const int n = 12;
  std::vector<Point> points = MakeGridPoints(n, 0.5);
  std::vector<Cell> cells = MakeGridTriangles(n);
  const vtkIdType first = static_cast<vtkIdType>(points.size());
  points.push_back({ 5.0, 0.0, 0.0 });
  points.push_back({ 6.0, 0.0, 0.0 });
  points.push_back({ 7.0, 0.0, 0.0 });
  points.push_back({ NaN, 0.0, 0.0 });
  points.push_back({ 8.0, 0.0, 0.0 });
  cells.push_back({ first, first + 1, first + 2 });     // no area
  cells.push_back({ first + 2, first + 4, first + 4 }); // an edge
  cells.push_back({ 3, 3, 3 });
  cells.push_back({ first + 4, first + 3, first + 2 });
  cells.push_back({ first + 3, first + 3, first + 3 });
  cells.push_back({ 0, 1, 1000000 });
  cells.push_back({ 0, 1, -7 });
  cells.push_back({ 4, 5 });
  cells.push_back({ 6 });
  cells.push_back({ first, first + 1, first, first + 1, first + 2, first }); // crosses itself
  vtkSmartPointer<vtkPolyData> data = MakeData(points);
  data->SetPolys(MakeCells(cells));
  data->SetStrips(MakeCells({ { 0, 1 }, { 5, 6, 7, -1 } }));
  data->SetVerts(MakeCells({ { first + 3, -2 }, { 10000 } }));
  Segments segments;
  segments.Filter->SetNumberOfPatches(20);
  segments.Update(data);
  segments.CheckArrays(check, "bad cells");
  CheckWarning(check, segments, "1 points of surfaces are not finite");
  CheckWarning(check, segments, "4 polygons or strips are ignored: they have 3 point ids");
  CheckWarning(check, segments, "1 points of vertex cells are not finite");
  CheckWarning(check, segments, "2 point ids of vertex cells do not exist");
  check(segments.GetId(first + 3) == -1, "a point that is not finite has no segment");
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(points.size()); ++i)
  {
    check(i == first + 3 || segments.GetId(i) >= 0, "the others have one");
  }
  // The chain of edges is one piece, the second one.
  int smallest = segments.GetId(first);
  for (vtkIdType i : { first + 1, first + 2, first + 4 })
  {
    smallest = std::min(smallest, segments.GetId(i));
  }
  check(smallest == 1 && segments.Filter->GetNumberOfSegmentsOfSurfaces() == 20,
    "degenerate triangles connect");
}

void TestExtremes(Checks& check)
{
  // Coordinates near the ends of double precision, for lines and surfaces: weights do not suffer.
  for (double scale : { 1e-300, 1e-30, 1.0, 1e30, 1e300 })
  {
    std::vector<Point> points = MakeGridPoints(12, 0.5);
    for (Point& point : points)
    {
      point = scale * point;
    }
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    for (int i = 0; i < 9; ++i)
    {
      points.push_back({ scale * i, 0.0, scale });
    }
    vtkSmartPointer<vtkPolyData> data = MakeData(points);
    data->SetPolys(MakeCells(MakeGridTriangles(12)));
    data->SetLines(MakeCells({ { first, first + 1, first + 2, first + 3, first + 4, first + 5,
      first + 6, first + 7, first + 8 } }));
    Segments segments;
    segments.Filter->SetNumberOfLineSegments(3);
    segments.Filter->SetNumberOfPatches(15);
    segments.Update(data);
    segments.CheckArrays(check, "coordinates of about " + std::to_string(scale));
    CheckWarning(check, segments, "");
    check(segments.Filter->GetNumberOfSegments() == 18, "as many segments as at any scale");
    check(std::abs(segments.GetWeights(first + 2)[1] - 0.25) < 1e-5, "weights along the line");
    int blended = 0;
    for (vtkIdType i = 0; i < first; ++i)
    {
      blended += segments.GetWeights(i)[1] > 0.05 ? 1 : 0;
    }
    check(blended > 80, "weights on the surface: " + std::to_string(blended));
  }
  const double largest = std::numeric_limits<double>::max();
  Segments segments;
  segments.Update(MakeLines({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } },
    { { -largest, 0.0, 0.0 }, { largest, 0.0, 0.0 } } }));
  segments.CheckArrays(check, "a line that is too long");
  CheckWarning(check, segments, "1 lines are longer than double precision holds");
  check(segments.GetId(0) == 0 && segments.GetId(2) == segments.Filter->GetNumberOfSegments() - 1,
    "each has its segments");
}

void TestLimit(Checks& check)
{
  constexpr int limit = vtkOpacitySegments::LargestNumberOfSegments;
  vtkSmartPointer<vtkPolyData> data = MakeData({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 },
    { 0.0, 1.0, 0.0 }, { 1e-3, 1.0, 0.0 }, { 5.0, 5.0, 5.0 } });
  data->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
  data->SetVerts(MakeCells({ { 4 } }));
  Segments segments;
  segments.Filter->SetSegmentLength(1e-12);
  segments.Update(data);
  CheckWarning(check, segments, "single precision");
  const int number = segments.Filter->GetNumberOfSegments();
  check(number <= limit && number > limit - 3, "as many as possible: " + std::to_string(number));
  check(segments.GetId(4) == number - 1 && static_cast<float>(number - 1) == number - 1.0,
    "the last id is exact in single precision");
  check(std::abs(segments.GetId(2) / 1.0 / number - 1.0 / 1.001) < 1e-6,
    "segments of all lines are longer alike");

  // More points than ids: some share one.
  const vtkIdType size = 17000000;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(size);
  std::fill_n(static_cast<float*>(points->GetVoidPointer(0)), 3 * size, 0.0f);
  vtkNew<vtkPolyData> many;
  many->SetPoints(points);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell(static_cast<int>(size));
  for (vtkIdType i = 0; i < size; ++i)
  {
    verts->InsertCellPoint(i);
  }
  many->SetVerts(verts);
  segments.Update(many);
  CheckWarning(check, segments, "2 points share a segment");
  check(segments.Filter->GetNumberOfSegmentsOfPoints() == size / 2 && segments.GetId(1) == 0 &&
      segments.GetId(size - 1) == size / 2 - 1,
    "ids of points that share a segment");
}

}

int TestOpacitySegmentBadInput(int, char*[])
{
  Checks check;
  TestEmpty(check);
  TestLines(check);
  TestSurfaces(check);
  TestExtremes(check);
  TestLimit(check);
  return check.GetResult();
}
