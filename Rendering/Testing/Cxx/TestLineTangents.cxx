// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the tangents of lines at inner points, ends, seams, repeated and shared points, far from
// the origin, for points that are not finite, and their independence of the number of threads.

#include "VoxelLineMapperTesting.h"
#include "vtkFloatArray.h"
#include "vtkLineTangents.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <limits>
#include <random>

using namespace VoxelLineMapperTesting;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

Point GetTangent(const vtkLineTangents& result, vtkIdType id)
{
  float values[3];
  result.Tangents->GetTypedTuple(id, values);
  return { values[0], values[1], values[2] };
}

std::string Describe(const Point& p)
{
  std::ostringstream text;
  text << " (" << p[0] << " " << p[1] << " " << p[2] << ")";
  return text.str();
}

// Expected tangents need not be unit vectors; null stands for null.
void CheckTangents(Checks& check, const std::string& name, const vtkLineTangents& result,
  const std::vector<Point>& expected)
{
  if (!check(result.Tangents &&
          result.Tangents->GetNumberOfTuples() == static_cast<vtkIdType>(expected.size()),
        name + ": number of tangents"))
  {
    return;
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    Point unit = expected[i];
    vtkMath::Normalize(unit.data());
    const Point tangent = GetTangent(result, static_cast<vtkIdType>(i));
    const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(unit.data(), tangent.data()));
    check(distance < 1e-6,
      name + ": tangent " + std::to_string(i) + Describe(tangent) + ", expected" + Describe(unit));
  }
}

void CheckLine(Checks& check, const std::string& name, const Curve& curve,
  const std::vector<Point>& expected, vtkIdType withoutExtent = 0, vtkIdType notFinite = 0)
{
  const vtkLineTangents result = vtkLineTangents::Compute(MakeLines({ curve }));
  CheckTangents(check, name, result, expected);
  check(result.LinesWithoutExtent == withoutExtent && result.PointsNotFinite == notFinite &&
      result.InvalidIds == 0,
    name + ": counts");
  check(result.Copies.empty() && !result.Lines, name + ": no copies");
}

void CheckSingleLines(Checks& check)
{
  const Point a{ 0.0, 0.0, 0.0 };
  const Point b{ 1.0, 0.0, 0.0 };
  const Point c{ 1.0, 2.0, 0.0 };
  const Point d{ 0.0, 2.0, 3.0 };
  const Point x{ 1.0, 0.0, 0.0 };
  const Point y{ 0.0, 1.0, 0.0 };
  const Point null{ 0.0, 0.0, 0.0 };
  const Point nan{ 0.0, vtkMath::Nan(), 0.0 };
  const Point far{ Infinity, 0.0, 0.0 };
  const Point ac{ 1.0, 2.0, 0.0 };
  const Point bd{ -1.0, 2.0, 3.0 };
  const Point cd{ -1.0, 0.0, 3.0 };
  const Point ca{ -1.0, -2.0, 0.0 };
  const Point db{ 1.0, -2.0, -3.0 };
  const Point ab = x;
  CheckLine(check, "two points", { a, b }, { ab, ab });
  CheckLine(check, "open", { a, b, c, d }, { ab, ac, bd, cd });
  CheckLine(
    check, "closed by coordinates", { a, b, c, d, a }, { db, ac, bd, { -1.0, -2.0, 0.0 }, db });
  CheckLine(check, "closed triangle", { a, b, c, a },
    { { 0.0, -2.0, 0.0 }, ac, { -1.0, 0.0, 0.0 }, { 0.0, -2.0, 0.0 } });
  CheckLine(check, "there and back", { a, b, a }, { ab, { -1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 } });
  CheckLine(check, "repeated inside", { a, b, b, b, c }, { ab, ac, ac, ac, y });
  CheckLine(check, "repeated at the ends", { a, a, b, c, c }, { ab, ab, ac, y, y });
  CheckLine(check, "repeated at the seam", { a, a, b, c, d, a, a }, { db, db, ac, bd, ca, db, db });
  CheckLine(check, "no extent", { b, b, b }, { null, null, null }, 1);
  CheckLine(check, "a single point", { b }, { null });
  CheckLine(check, "NaN at the end", { a, b, nan }, { ab, ab, null }, 0, 1);
  CheckLine(check, "NaN inside", { a, b, nan, c, d }, { ab, ab, null, cd, cd }, 0, 1);
  CheckLine(check, "alone beside NaN", { a, nan, c }, { null, null, null }, 0, 1);
  CheckLine(check, "infinite", { a, b, far, far }, { ab, ab, null, null }, 0, 2);
  CheckLine(check, "NaN in a closed line", { a, b, nan, d, a },
    { db, ab, null, { 0.0, -2.0, -3.0 }, db }, 0, 1);
  // Differences that are tiny, huge, or lost in single precision.
  CheckLine(check, "tiny", { { 0.0, 0.0, 0.0 }, { 0.0, 1e-300, 0.0 } }, { y, y });
  CheckLine(check, "huge", { { 0.0, -1.5e308, 0.0 }, { 0.0, 1.5e308, 0.0 } }, { y, y });
  CheckLine(
    check, "far from the origin", { { 1e9, 1e9, 0.0 }, { 1e9, 1e9 + 1e-3, 0.0 } }, { y, y });
}

vtkSmartPointer<vtkPolyData> MakeCells(
  const Curve& points, const std::vector<std::vector<vtkIdType>>& cells)
{
  auto data = MakeLines({ points });
  vtkNew<vtkCellArray> lines;
  for (const auto& cell : cells)
  {
    lines->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  data->SetLines(lines);
  return data;
}

// Points that lines share, and ids that do not exist.
void CheckSharedPoints(Checks& check)
{
  const Curve points{ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  const Point x{ 1.0, 0.0, 0.0 };
  const Point y{ 0.0, 1.0, 0.0 };
  const Point xy{ 1.0, 1.0, 0.0 };
  const Point null{ 0.0, 0.0, 0.0 };

  // Closed by id: the seam needs no copy.
  vtkLineTangents result = vtkLineTangents::Compute(MakeCells(points, { { 0, 1, 2, 3, 0 } }));
  CheckTangents(check, "closed by id", result,
    { { 1.0, -1.0, 0.0 }, xy, { -1.0, 1.0, 0.0 }, { -1.0, -1.0, 0.0 } });
  check(result.Copies.empty() && !result.Lines, "closed by id: no copies");

  result = vtkLineTangents::Compute(MakeCells(points, { { 0, 1, 1, 2 } }));
  CheckTangents(check, "repeated id", result, { x, xy, y, null });
  check(result.Copies.empty(), "repeated id: no copies");

  // A junction: the second line gets its own 1; the third its own 1 and 2.
  const auto input = MakeCells(points, { { 0, 1 }, { 1, 2 }, { 2, 1 } });
  result = vtkLineTangents::Compute(input);
  CheckTangents(
    check, "junction", result, { x, x, y, null, y, { 0.0, -1.0, 0.0 }, { 0.0, -1.0, 0.0 } });
  if (!check(result.Copies == std::vector<vtkIdType>{ 1, 2, 1 }, "junction: copies"))
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  const std::vector<std::vector<vtkIdType>> expected{ { 0, 1 }, { 4, 2 }, { 5, 6 } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    result.Lines->GetCellAtId(i, ids);
    check(std::vector<vtkIdType>(ids->begin(), ids->end()) == expected[i], "junction: lines");
    input->GetLines()->GetCellAtId(i, ids);
    check(ids->GetId(0) == i, "junction: the input stays");
  }

  // A line that crosses itself at point 1.
  result = vtkLineTangents::Compute(MakeCells(points, { { 0, 1, 2, 1, 3 } }));
  check(result.Copies == std::vector<vtkIdType>{ 1 }, "crossing itself: one copy");
  CheckTangents(check, "crossing itself", result,
    { x, xy, { 0.0, -1.0, 0.0 }, { -1.0, 1.0, 0.0 }, { -1.0, 0.0, 0.0 } });

  result = vtkLineTangents::Compute(MakeCells(points, { { 0, 1, 4 }, { -1, 2, 3 } }));
  CheckTangents(
    check, "ids that do not exist", result, { x, x, { -1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 } });
  check(result.InvalidIds == 2, "ids that do not exist are counted");
  check(result.PointsNotFinite == 0, "they are not counted twice");

  vtkNew<vtkPolyData> empty;
  check(!vtkLineTangents::Compute(empty).Tangents, "an empty data set has no tangents");
  check(!vtkLineTangents::Compute(MakeLines({})).Tangents, "nor have points alone");
}

// Many lines with all of that: bit by bit the same with one thread and with several.
void CheckThreads(Checks& check)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<std::vector<vtkIdType>> cells;
  Curve points;
  for (int i = 0; i < 3000; ++i)
  {
    points.push_back({ coordinate(random), coordinate(random), coordinate(random) });
  }
  points[17][1] = vtkMath::Nan();
  for (int i = 0; i < 2000; ++i)
  {
    std::vector<vtkIdType> cell;
    for (unsigned int k = random() % 7; k > 0; --k)
    {
      cell.push_back(static_cast<vtkIdType>(random() % points.size()));
    }
    cells.push_back(cell);
  }
  const auto input = MakeCells(points, cells);
  vtkSMPTools::SetBackend("Sequential");
  const vtkLineTangents one = vtkLineTangents::Compute(input);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(4);
  const vtkLineTangents four = vtkLineTangents::Compute(input);
  const vtkIdType values = one.Tangents->GetNumberOfValues();
  check(four.Tangents->GetNumberOfValues() == values &&
      std::equal(one.Tangents->GetPointer(0), one.Tangents->GetPointer(0) + values,
        four.Tangents->GetPointer(0)),
    "tangents do not depend on the number of threads");
  check(one.Copies == four.Copies && one.PointsNotFinite == four.PointsNotFinite &&
      one.LinesWithoutExtent == four.LinesWithoutExtent && one.PointsNotFinite > 0,
    "nor do copies and counts");
}
}

int TestLineTangents(int, char*[])
{
  Checks check;
  CheckSingleLines(check);
  CheckSharedPoints(check);
  CheckThreads(check);
  return check.GetResult();
}
