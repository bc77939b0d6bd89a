// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineTangents.h"

#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Vector = std::array<double, 3>;

// Consecutive points of a line at one place.
struct Place
{
  Vector Position;
  bool IsFinite;
  // One past the last of its points, counted along the line.
  vtkIdType End;
};

struct Counts
{
  vtkIdType LinesWithoutExtent = 0;
  vtkIdType PointsNotFinite = 0;
};

// Unit vector from a to b. Returns false where there is none.
bool GetDirection(const Vector& a, const Vector& b, Vector& direction)
{
  // Halves, whose difference is finite wherever the points are.
  direction = { 0.5 * b[0] - 0.5 * a[0], 0.5 * b[1] - 0.5 * a[1], 0.5 * b[2] - 0.5 * a[2] };
  double square = vtkMath::Dot(direction.data(), direction.data());
  if (!(square > 1e-200 && square < 1e200))
  {
    // Squares of tiny or huge numbers may be 0 or infinite.
    const double largest =
      std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
    if (largest == 0.0)
    {
      return false;
    }
    for (double& x : direction)
    {
      x /= largest;
    }
    square = vtkMath::Dot(direction.data(), direction.data());
  }
  const double factor = 1.0 / std::sqrt(square);
  for (double& x : direction)
  {
    x *= factor;
  }
  return true;
}

// Tangents of one line.
class Line
{
public:
  Line(vtkPoints* points, vtkFloatArray* tangents)
    : Points(points)
    , Tangents(tangents)
  {
  }

  // ids are those of the input, outputIds where the tangents go.
  void Compute(vtkIdList* ids, vtkIdList* outputIds, Counts& counts)
  {
    this->FindPlaces(ids, counts);
    const std::size_t size = this->Places.size();
    const bool isClosed = size > 3 && this->Places.front().IsFinite &&
      this->Places.front().Position == this->Places.back().Position;
    vtkIdType vertex = 0;
    bool hasExtent = false;
    for (std::size_t i = 0; i < size; ++i)
    {
      const Place* before = i > 0 ? &this->Places[i - 1] : nullptr;
      const Place* after = i + 1 < size ? &this->Places[i + 1] : nullptr;
      if (isClosed)
      {
        // The seam is both the first and the last place.
        before = before ? before : &this->Places[size - 2];
        after = after ? after : &this->Places[1];
      }
      const Vector tangent = GetTangent(this->Places[i], before, after);
      hasExtent |= tangent != Vector{};
      for (; vertex < this->Places[i].End; ++vertex)
      {
        const vtkIdType id = outputIds->GetId(vertex);
        if (id >= 0 && id < this->Tangents->GetNumberOfTuples())
        {
          const float values[3] = { static_cast<float>(tangent[0]), static_cast<float>(tangent[1]),
            static_cast<float>(tangent[2]) };
          this->Tangents->SetTypedTuple(id, values);
        }
      }
    }
    const bool isFinite = std::all_of(
      this->Places.begin(), this->Places.end(), [](const Place& place) { return place.IsFinite; });
    counts.LinesWithoutExtent += ids->GetNumberOfIds() > 1 && isFinite && !hasExtent ? 1 : 0;
  }

private:
  void FindPlaces(vtkIdList* ids, Counts& counts)
  {
    this->Places.clear();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      Place place;
      place.Position = { 0.0, 0.0, 0.0 };
      place.IsFinite = false;
      place.End = i + 1;
      if (id >= 0 && id < this->Points->GetNumberOfPoints())
      {
        this->Points->GetPoint(id, place.Position.data());
        place.IsFinite = std::all_of(
          place.Position.begin(), place.Position.end(), [](double x) { return std::isfinite(x); });
        counts.PointsNotFinite += place.IsFinite ? 0 : 1;
      }
      if (place.IsFinite && !this->Places.empty() && this->Places.back().Position == place.Position)
      {
        this->Places.back().End = place.End;
      }
      else
      {
        this->Places.push_back(place);
      }
    }
  }

  static Vector GetTangent(const Place& place, const Place* before, const Place* after)
  {
    Vector tangent{};
    const bool hasBefore = place.IsFinite && before && before->IsFinite;
    const bool hasAfter = place.IsFinite && after && after->IsFinite;
    if (hasBefore && hasAfter && GetDirection(before->Position, after->Position, tangent))
    {
      return tangent;
    }
    if ((hasAfter && GetDirection(place.Position, after->Position, tangent)) ||
      (hasBefore && GetDirection(before->Position, place.Position, tangent)))
    {
      return tangent;
    }
    return Vector{};
  }

  vtkPoints* Points;
  vtkFloatArray* Tangents;
  std::vector<Place> Places;
};

// Whether the point at a place in a line needs no tangent of its own beside that of another point
// of the line: it repeats the one before, or closes the line.
bool IsRepeated(vtkIdList* ids, vtkIdType i)
{
  const vtkIdType id = ids->GetId(i);
  return i > 0 &&
    (id == ids->GetId(i - 1) || (i == ids->GetNumberOfIds() - 1 && id == ids->GetId(0)));
}

// A part of the lines; memory is taken for all.
vtkSmartPointer<vtkCellArray> CopyFirstLines(vtkCellArray* lines, vtkIdType count)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->AllocateExact(lines->GetNumberOfCells(), lines->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < count; ++line)
  {
    lines->GetCellAtId(line, ids);
    result->InsertNextCell(ids);
  }
  return result;
}

// Give all uses of a point but the first one a copy of it.
void SeparateUses(vtkCellArray* lines, vtkIdType numberOfPoints, vtkLineTangents& result)
{
  std::vector<bool> isUsed(static_cast<std::size_t>(numberOfPoints), false);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> newIds;
  for (vtkIdType line = 0; line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellAtId(line, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    newIds->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const vtkIdType id = ids->GetId(i);
      vtkIdType newId = id;
      if (id < 0 || id >= numberOfPoints)
      {
        ++result.InvalidIds;
      }
      else if (IsRepeated(ids, i))
      {
        newId = newIds->GetId(id == ids->GetId(i - 1) ? i - 1 : 0);
      }
      else if (isUsed[id])
      {
        newId = numberOfPoints + static_cast<vtkIdType>(result.Copies.size());
        result.Copies.push_back(id);
      }
      else
      {
        isUsed[id] = true;
      }
      newIds->SetId(i, newId);
    }
    if (!result.Copies.empty() && !result.Lines)
    {
      // The first copy of all: the lines before this one are as they were.
      result.Lines = CopyFirstLines(lines, line);
    }
    if (result.Lines)
    {
      result.Lines->InsertNextCell(newIds);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkLineTangents vtkLineTangents::Compute(vtkPolyData* input)
{
  vtkLineTangents result;
  vtkCellArray* lines = input->GetLines();
  vtkPoints* points = input->GetPoints();
  if (!points || !lines || lines->GetNumberOfCells() == 0)
  {
    return result;
  }
  const vtkIdType numberOfPoints = points->GetNumberOfPoints();
  SeparateUses(lines, numberOfPoints, result);

  result.Tangents = vtkSmartPointer<vtkFloatArray>::New();
  result.Tangents->SetNumberOfComponents(3);
  result.Tangents->SetNumberOfTuples(numberOfPoints + static_cast<vtkIdType>(result.Copies.size()));
  result.Tangents->FillValue(0.0f);

  // Lines share no tangents any more: each is written by the thread of its line.
  vtkSMPThreadLocal<Counts> counts;
  vtkSMPThreadLocalObject<vtkIdList> localIds;
  vtkSMPThreadLocalObject<vtkIdList> localOutputIds;
  vtkSMPTools::For(0, lines->GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      Counts& localCounts = counts.Local();
      vtkIdList* ids = localIds.Local();
      vtkIdList* outputIds = localOutputIds.Local();
      Line line(points, result.Tangents);
      for (vtkIdType i = begin; i < end; ++i)
      {
        lines->GetCellAtId(i, ids);
        if (result.Lines)
        {
          result.Lines->GetCellAtId(i, outputIds);
        }
        line.Compute(ids, result.Lines ? outputIds : ids, localCounts);
      }
    });
  for (const Counts& local : counts)
  {
    result.LinesWithoutExtent += local.LinesWithoutExtent;
    result.PointsNotFinite += local.PointsNotFinite;
  }
  return result;
}
