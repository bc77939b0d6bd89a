// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards vtkLineMerging: how long pieces are and how far they deviate from their lines, that
 * nothing is lost, what is not merged, the length on the screen, and that threads change nothing.
 */

#include "VoxelLineMapperTesting.h"
#include "vtkIdList.h"
#include "vtkLineMerging.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPTools.h"

#include <limits>

using namespace VoxelLineMapperTesting;

namespace
{
double GetDistance(const double a[3], const double b[3])
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

// Distance of a point from the piece between two others.
double GetDistance(const double p[3], const double a[3], const double b[3])
{
  double ab[3];
  double ap[3];
  vtkMath::Subtract(b, a, ab);
  vtkMath::Subtract(p, a, ap);
  const double size2 = vtkMath::Dot(ab, ab);
  const double t = size2 > 0.0 ? std::min(1.0, std::max(0.0, vtkMath::Dot(ap, ab) / size2)) : 0.0;
  const double nearest[3] = { a[0] + t * ab[0], a[1] + t * ab[1], a[2] + t * ab[2] };
  return GetDistance(p, nearest);
}

struct Quality
{
  double LongestPiece = 0.0; ///< of more than one segment
  double Deviation = 0.0;
  bool IsWhole = true; ///< pieces follow each other from the first point of each line to the last
};

// Walks along the lines and their pieces at the same time. Points of a line have ascending ids.
Quality Judge(vtkPolyData* data, const std::vector<unsigned int>& indices)
{
  Quality quality;
  std::size_t next = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line)
  {
    data->GetLines()->GetCellAtId(line, ids);
    const vtkIdType last = ids->GetNumberOfIds() - 1;
    vtkIdType place = 0;
    while (place < last)
    {
      if (next + 1 >= indices.size() || indices[next] != ids->GetId(place))
      {
        quality.IsWhole = false;
        return quality;
      }
      const vtkIdType begin = place;
      while (place < last && ids->GetId(place) != indices[next + 1])
      {
        ++place;
      }
      quality.IsWhole = quality.IsWhole && place > begin && ids->GetId(place) == indices[next + 1];
      double a[3];
      double b[3];
      data->GetPoint(indices[next], a);
      data->GetPoint(indices[next + 1], b);
      double arc = 0.0;
      for (vtkIdType i = begin + 1; i <= place; ++i)
      {
        double p[3];
        double q[3];
        data->GetPoint(ids->GetId(i - 1), p);
        data->GetPoint(ids->GetId(i), q);
        arc += GetDistance(p, q);
        quality.Deviation = std::max(quality.Deviation, GetDistance(p, a, b));
      }
      if (place > begin + 1)
      {
        quality.LongestPiece = std::max(quality.LongestPiece, arc);
      }
      next += 2;
    }
  }
  quality.IsWhole = quality.IsWhole && next == indices.size();
  return quality;
}

void CheckPieces(Checks& check)
{
  auto helices = MakeHelices(600, 120);
  const std::size_t all = vtkLineMerging::GetIndices(helices, 0.0).size();
  check(all == 2u * 600u * 119u, "length 0 keeps every segment");
  std::size_t before = all;
  for (double length : { 0.1, 0.3, 1.0, 3.0 })
  {
    const auto indices = vtkLineMerging::GetIndices(helices, length);
    const Quality quality = Judge(helices, indices);
    check(quality.IsWhole, "pieces follow each other");
    check(
      quality.LongestPiece <= length * 1.000001, "pieces are no longer than what was asked for");
    check(quality.Deviation <= 0.125 * length,
      "pieces deviate by " + std::to_string(quality.Deviation / length) + " lengths");
    check(indices.size() <= before, "longer pieces are fewer");
    before = indices.size();
  }
  check(before < all / 4, "pieces are merged");

  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 },
    [&]()
    {
      check(vtkLineMerging::GetIndices(helices, 0.3) == vtkLineMerging::GetIndices(helices, 0.3),
        "one thread repeats itself");
    });
  const auto many = vtkLineMerging::GetIndices(helices, 0.3);
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 },
    [&]() { check(vtkLineMerging::GetIndices(helices, 0.3) == many, "threads change nothing"); });
}

void CheckSpecialLines(Checks& check)
{
  using Indices = std::vector<unsigned int>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // A hairpin: its turn must not be cut off, although it is short enough.
  auto hairpin = MakeLines({ { { 0, 0, 0 }, { 0.4, 0, 0 }, { 0, 0, 0 } } });
  check(vtkLineMerging::GetIndices(hairpin, 1.0) == Indices{ 0, 1, 1, 2 }, "a hairpin");
  auto straight = MakeLines({ { { 0, 0, 0 }, { 0.4, 0, 0 }, { 0.8, 0, 0 }, { 1.2, 0, 0 } } });
  check(vtkLineMerging::GetIndices(straight, 1.0) == Indices{ 0, 2, 2, 3 }, "a straight line");
  auto uneven = MakeLines({ { { 0, 0, 0 }, { 5, 0, 0 }, { 5.1, 0, 0 }, { 5.2, 0, 0 } } });
  check(vtkLineMerging::GetIndices(uneven, 1.0) == Indices{ 0, 1, 1, 3 }, "a long segment stays");
  auto repeated = MakeLines({ { { 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 } } });
  check(vtkLineMerging::GetIndices(repeated, 1.0) == Indices{ 0, 2 }, "repeated points");
  auto broken = MakeLines(
    { { { 0, 0, 0 }, { 0.1, 0, 0 }, { nan, 0, 0 }, { 0.3, 0, 0 }, { 0.4, 0, 0 }, { 0.5, 0, 0 } } });
  const auto indices = vtkLineMerging::GetIndices(broken, 1.0);
  check(indices == Indices{ 0, 1, 1, 2, 2, 3, 3, 5 }, "points that are not finite part a line");
  check(vtkLineMerging::GetIndices(vtkNew<vtkPolyData>(), 1.0).empty(), "no lines");
  vtkNew<vtkPolyData> unknown;
  unknown->SetPoints(straight->GetPoints());
  vtkNew<vtkCellArray> cells;
  const vtkIdType ids[4] = { 0, 1, 1000000, 2 };
  cells->InsertNextCell(4, ids);
  unknown->SetLines(cells);
  check(vtkLineMerging::GetIndices(unknown, 1.0) == Indices{ 0, 1, 1, 1000000, 1000000, 2 } &&
      vtkLineMerging::GetLongestSegment(unknown) == 0.4,
    "points that do not exist part a line");
}

void CheckLengths(Checks& check)
{
  const double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  const int size[2] = { 400, 300 };
  vtkNew<vtkCamera> camera;
  camera->SetPosition(0.0, 0.0, 5.0);
  camera->SetClippingRange(1.0, 20.0);
  vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0);
  // The nearest face is 4 away, where the view is 8 tan(15 degrees) high.
  // Towards the corner, what moves in depth moves sideways by a slope of sqrt(2) / 4.
  const double expected =
    2.0 * 8.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)) / 300.0 / std::sqrt(1.0 + 2.0 / 16.0);
  double length = vtkLineMerging::GetLength(2.0, bounds, view, projection, size);
  check(std::abs(length - expected) < 1e-6, "length in perspective: " + std::to_string(length));

  // A wide view: no step of this length, in whatever direction, moves a point by more pixels.
  camera->SetViewAngle(120.0);
  vtkMatrix4x4* wide = camera->GetProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0);
  length = vtkLineMerging::GetLength(2.0, bounds, view, wide, size);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      double pixels[2][2];
      for (int side = 0; side < 2; ++side)
      {
        double p[4] = { corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0,
          1.0 };
        p[axis] *= side ? 1.0 - length : 1.0;
        view->MultiplyPoint(p, p);
        wide->MultiplyPoint(p, p);
        pixels[side][0] = 0.5 * size[0] * p[0] / p[3];
        pixels[side][1] = 0.5 * size[1] * p[1] / p[3];
      }
      farthest =
        std::max(farthest, std::hypot(pixels[1][0] - pixels[0][0], pixels[1][1] - pixels[0][1]));
    }
  }
  check(farthest <= 2.0 && farthest > 0.5, "a step in a wide view: " + std::to_string(farthest));
  camera->SetViewAngle(30.0);
  projection = camera->GetProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0);

  vtkNew<vtkMatrix4x4> scaled;
  scaled->SetElement(0, 0, 0.5);
  scaled->SetElement(1, 1, 3.0);
  vtkNew<vtkMatrix4x4> both;
  vtkMatrix4x4::Multiply4x4(view, scaled, both);
  length = vtkLineMerging::GetLength(2.0, bounds, both, projection, size);
  check(std::abs(length - expected * std::sqrt(1.125 / (1.0 + 9.25 / 16.0)) / 3.0) < 1e-6,
    "the largest scale counts");

  camera->SetPosition(0.0, 0.0, 0.5);
  length = vtkLineMerging::GetLength(2.0, bounds, camera->GetModelViewTransformMatrix(),
    camera->GetProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0), size);
  check(length == 0.0, "nothing is merged around the camera");

  camera->SetPosition(0.0, 0.0, 5.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(6.0);
  length = vtkLineMerging::GetLength(2.0, bounds, camera->GetModelViewTransformMatrix(),
    camera->GetProjectionTransformMatrix(4.0 / 3.0, -1.0, 1.0), size);
  check(std::abs(length - 2.0 * 12.0 / 300.0) < 1e-6, "length in a parallel view");

  vtkNew<vtkMatrix4x4> nothing;
  nothing->Zero();
  check(vtkLineMerging::GetLength(2.0, bounds, nothing, projection, size) == 0.0,
    "nothing is merged where nothing can be seen");
}
}

int TestLineMerging(int, char*[])
{
  Checks check;
  CheckPieces(check);
  CheckSpecialLines(check);
  CheckLengths(check);
  return check.GetResult();
}
