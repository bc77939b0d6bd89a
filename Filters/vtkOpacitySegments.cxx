// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpacitySegments.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkLineSetsCheckedValuePrivate.h"
#include "vtkLineSetsCompatibilityPrivate.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpacityLineSegmentsPrivate.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSurfacePatchesPrivate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

vtkStandardNewMacro(vtkOpacitySegments);

namespace
{

using vtkOpacityLineSegments::Division;
using vtkOpacityLineSegments::PointArrays;
using vtkSurfaceGeodesics::Mesh;
using vtkSurfacePatches::NearSeeds;
using vtkSurfacePatches::NumberOfNearSeeds;

void AddLine(std::string& text, const std::string& line)
{
  text += (text.empty() ? "" : "\n") + line;
}

/// The points that only vertex cells use, and what is wrong with others.
struct LonelyPoints
{
  std::vector<vtkIdType> Points;
  vtkIdType NumberOfSharedPoints = 0;
  vtkIdType NumberOfNonFinitePoints = 0;
  vtkIdType NumberOfInvalidIds = 0;

  LonelyPoints(vtkPolyData* data, const Division& lines, const Mesh& mesh)
  {
    vtkCellArray* cells = data->GetVerts();
    const vtkIdType numberOfCells = cells ? cells->GetNumberOfCells() : 0;
    const vtkIdType numberOfPoints = static_cast<vtkIdType>(mesh.VertexOfPoint.size());
    std::vector<bool> isDone(mesh.VertexOfPoint.size(), false);
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < numberOfCells; ++cell)
    {
      cells->GetCellAtId(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        const vtkIdType point = ids->GetId(i);
        if (point < 0 || point >= numberOfPoints)
        {
          ++this->NumberOfInvalidIds;
        }
        else if (!isDone[static_cast<std::size_t>(point)])
        {
          isDone[static_cast<std::size_t>(point)] = true;
          this->Add(point, lines, mesh);
        }
      }
    }
  }

private:
  void Add(vtkIdType point, const Division& lines, const Mesh& mesh)
  {
    double x[3];
    lines.GetInput().LineSets[0].Points.Get(point, x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      ++this->NumberOfNonFinitePoints;
    }
    else if (lines.IsUsed(point) || mesh.VertexOfPoint[static_cast<std::size_t>(point)] >= 0)
    {
      ++this->NumberOfSharedPoints;
    }
    else
    {
      this->Points.push_back(point);
    }
  }
};

/// How many segments each kind may have, so that all together are not too many.
struct Budget
{
  int Lines;
  int Patches;
  vtkIdType MissingPatches;
  /// Points that share a segment; 0 where there is none for them.
  vtkIdType PointsPerSegment = 1;

  Budget(vtkIdType lines, const Mesh& mesh, int numberOfPatches, vtkIdType points)
  {
    // Lines can become coarser, then points. Patches are as many as asked for if possible.
    constexpr vtkIdType all = vtkOpacitySegments::LargestNumberOfSegments;
    const vtkIdType fewestLines = std::min(lines, all);
    const vtkIdType patches = std::min<vtkIdType>(
      std::max(numberOfPatches, mesh.GetNumberOfPieces()), mesh.GetNumberOfVertices());
    this->Patches = static_cast<int>(std::min(patches, all - fewestLines));
    const vtkIdType rest = all - fewestLines - this->Patches;
    if (points > rest)
    {
      this->PointsPerSegment = rest > 0 ? (points + rest - 1) / rest : 0;
    }
    const vtkIdType forPoints = this->PointsPerSegment > 0
      ? (points + this->PointsPerSegment - 1) / this->PointsPerSegment
      : 0;
    this->Lines = static_cast<int>(all - this->Patches - forPoints);
    this->MissingPatches = patches - this->Patches;
  }
};

/// The largest distance that a piece's vertices have to any of its seeds, for pieces with fewer
/// seeds than the interpolation takes; 0 for others, where the fourth seed tells.
std::vector<double> FindCutOffs(const Mesh& mesh, const std::vector<NearSeeds>& nearSeeds)
{
  std::vector<double> cutOffs(static_cast<std::size_t>(mesh.GetNumberOfPieces()), 0.0);
  for (std::size_t vertex = 0; vertex < nearSeeds.size(); ++vertex)
  {
    double& cutOff = cutOffs[static_cast<std::size_t>(mesh.Pieces[vertex])];
    for (std::size_t i = 0; i + 1 < NumberOfNearSeeds && nearSeeds[vertex].back().Seed < 0; ++i)
    {
      const double distance = nearSeeds[vertex][i].Distance;
      cutOff = nearSeeds[vertex][i].Seed >= 0 ? std::max(cutOff, distance) : cutOff;
    }
  }
  return cutOffs;
}

/// Set the arrays at the points of surfaces that no line uses.
void SetPatches(const Mesh& mesh, const std::vector<NearSeeds>& nearSeeds, int firstId,
  const Division& lines, const PointArrays& arrays)
{
  const std::vector<double> cutOffs = FindCutOffs(mesh, nearSeeds);
  const auto setPoint = [&](vtkIdType point)
  {
    const int vertex = mesh.VertexOfPoint[static_cast<std::size_t>(point)];
    if (vertex < 0 || lines.IsUsed(point))
    {
      return;
    }
    const NearSeeds& seeds = nearSeeds[static_cast<std::size_t>(vertex)];
    if (seeds[0].Seed < 0 || seeds[1].Seed < 0)
    {
      arrays.Set(point, seeds[0].Seed < 0 ? -1 : firstId + seeds[0].Seed);
      return;
    }
    const std::size_t piece =
      static_cast<std::size_t>(mesh.Pieces[static_cast<std::size_t>(vertex)]);
    const double cutOff = mesh.Unit * (seeds[3].Seed < 0 ? cutOffs[piece] : seeds[3].Distance);
    int ids[3];
    double distances[4];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const bool isThere = seeds[i].Seed >= 0;
      ids[i] = isThere ? firstId + seeds[i].Seed : -1;
      distances[i] = isThere ? mesh.Unit * seeds[i].Distance : cutOff;
    }
    distances[3] = cutOff;
    arrays.Set(point, ids, distances);
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(mesh.VertexOfPoint.size()), 16384,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        setPoint(point);
      }
    });
}

/// Add the arrays to the output, with no segment at any point.
PointArrays MakeArrays(vtkPolyData* output)
{
  const vtkIdType numberOfPoints = output->GetNumberOfPoints();
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkOpacitySegments::GetIdsName());
  ids->SetNumberOfComponents(3);
  ids->SetNumberOfTuples(numberOfPoints);
  vtkNew<vtkFloatArray> distances;
  distances->SetName(vtkOpacitySegments::GetDistancesName());
  distances->SetNumberOfComponents(4);
  distances->SetNumberOfTuples(numberOfPoints);
  std::fill_n(ids->GetPointer(0), 3 * numberOfPoints, -1);
  std::fill_n(distances->GetPointer(0), 4 * numberOfPoints, 1.0f);
  output->GetPointData()->AddArray(ids);
  output->GetPointData()->AddArray(distances);
  return { ids->GetPointer(0), distances->GetPointer(0) };
}

/// Add the arrays that tell of the segments to the output.
void SetFieldData(vtkPolyData* output, const std::vector<std::pair<int, int>>& pairs, int count)
{
  vtkNew<vtkIntArray> neighbors;
  neighbors->SetName(vtkOpacitySegments::GetNeighborsName());
  neighbors->SetNumberOfComponents(2);
  neighbors->SetNumberOfTuples(static_cast<vtkIdType>(pairs.size()));
  int* values = neighbors->GetPointer(0);
  for (const std::pair<int, int>& pair : pairs)
  {
    *values++ = pair.first;
    *values++ = pair.second;
  }
  vtkNew<vtkIntArray> number;
  number->SetName(vtkOpacitySegments::GetCountName());
  number->InsertNextValue(count);
  output->GetFieldData()->AddArray(neighbors);
  output->GetFieldData()->AddArray(number);
}

/// Points of surfaces that lines use too.
vtkIdType CountShared(const Division& lines, const Mesh& mesh)
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < mesh.VertexOfPoint.size(); ++i)
  {
    count += mesh.VertexOfPoint[i] >= 0 && lines.IsUsed(static_cast<vtkIdType>(i)) ? 1 : 0;
  }
  return count;
}

/// What becomes coarser where there would be too many segments.
std::string DescribeLimit(const Division& lines, bool isCoarser, const Budget& budget)
{
  std::string text = "There would be more than " +
    std::to_string(vtkOpacitySegments::LargestNumberOfSegments) +
    " segments, beyond which single precision does not tell their ids apart:";
  if (isCoarser)
  {
    text += " segments of lines are longer than asked for, " +
      std::to_string(lines.NumberOfSegments) + " in all;";
  }
  if (lines.NumberOfLeftOutLines > 0)
  {
    text += " " + std::to_string(lines.NumberOfLeftOutLines) + " lines have no segment;";
  }
  if (budget.MissingPatches > 0)
  {
    text += " surfaces have " + std::to_string(budget.MissingPatches) + " patches fewer;";
  }
  if (budget.PointsPerSegment > 1)
  {
    text += " " + std::to_string(budget.PointsPerSegment) + " points share a segment;";
  }
  if (budget.PointsPerSegment == 0)
  {
    text += " points have no segment;";
  }
  text.back() = '.';
  return text + " Ask for fewer segments, or pass the geometry in parts.";
}

/// What is left out, in sentences.
std::string DescribeDropped(const Division& lines, const Mesh& mesh, const LonelyPoints& points)
{
  std::string text = lines.GetInput().DescribeDropped();
  const auto add = [&text](vtkIdType number, const std::string& what)
  {
    if (number > 0)
    {
      AddLine(text, std::to_string(number) + " " + what);
    }
  };
  add(mesh.NumberOfNonFinitePoints, "points of surfaces are not finite and left out.");
  add(mesh.NumberOfIgnoredCells,
    "polygons or strips are ignored: they have " + std::to_string(mesh.NumberOfInvalidIds) +
      " point ids that do not exist, or are strips of fewer than three points.");
  add(points.NumberOfNonFinitePoints, "points of vertex cells are not finite and left out.");
  add(points.NumberOfInvalidIds, "point ids of vertex cells do not exist and are left out.");
  add(lines.NumberOfInfiniteLines,
    "lines are longer than double precision holds; each is one segment. Scale the coordinates.");
  return text;
}

// As many segments as opacity needs to follow the importance along lines, but no more than their
// points can tell apart.
int GetDefaultNumberOfLineSegments(vtkCellArray* lines)
{
  const vtkIdType wanted =
    std::min(16 * lines->GetNumberOfCells(), lines->GetNumberOfConnectivityIds() / 4);
  return static_cast<int>(std::min<vtkIdType>(
    std::max<vtkIdType>(wanted, 50000), vtkOpacitySegments::LargestNumberOfSegments));
}
}

//------------------------------------------------------------------------------
void vtkOpacitySegments::SetNumberOfLineSegments(int number)
{
  vtkLineSetsSetInRange(this, "NumberOfLineSegments", this->NumberOfLineSegments, number, 0,
    int{ LargestNumberOfSegments });
}

//------------------------------------------------------------------------------
void vtkOpacitySegments::SetSegmentLength(double length)
{
  vtkLineSetsSetInRange(
    this, "SegmentLength", this->SegmentLength, length, 0.0, std::numeric_limits<double>::max());
}

//------------------------------------------------------------------------------
void vtkOpacitySegments::SetNumberOfPatches(int number)
{
  vtkLineSetsSetInRange(
    this, "NumberOfPatches", this->NumberOfPatches, number, 1, int{ LargestNumberOfSegments });
}

//------------------------------------------------------------------------------
void vtkOpacitySegments::GetWeights(const int ids[3], const float distances[4], double weights[3])
{
  const double cutOff = distances[3];
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    weights[i] = ids[i] >= 0 && cutOff > 0.0 ? std::max(0.0, 1.0 - distances[i] / cutOff) : 0.0;
    sum += weights[i];
  }
  if (!(sum > 0.0))
  {
    weights[0] = ids[0] >= 0 ? 1.0 : 0.0;
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    weights[i] /= sum;
  }
}

//------------------------------------------------------------------------------
int vtkOpacitySegments::GetNumberOfSegments() const
{
  return this->NumberOfSegmentsOfLines + this->NumberOfSegmentsOfSurfaces +
    this->NumberOfSegmentsOfPoints;
}

//------------------------------------------------------------------------------
std::string vtkOpacitySegments::Execute(
  vtkPolyData* input, vtkPolyData* output, std::string& warning)
{
  const PointArrays arrays = MakeArrays(output);
  std::vector<std::pair<int, int>> neighbors;
  SetFieldData(output, neighbors, 0);
  if (input->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    return "The input has more than 2^31-1 points, and vertices of surfaces are counted in 31 "
           "bits. Pass it in parts.";
  }
  const auto goesOn = [this](double from, double to, double fraction)
  {
    if (!vtkLineSetsCompatibility::CheckAbort(this))
    {
      this->UpdateProgress(from + (to - from) * fraction);
    }
    return !vtkLineSetsCompatibility::CheckAbort(this);
  };
  Division lines(input);
  if (!goesOn(0.0, 0.1, 1.0))
  {
    return std::string();
  }
  Mesh mesh;
  mesh.Read(input);
  const LonelyPoints points(input, lines, mesh);
  if (!goesOn(0.1, 0.2, 1.0))
  {
    return std::string();
  }

  const vtkIdType numberOfPoints = static_cast<vtkIdType>(points.Points.size());
  const Budget budget(lines.GetNumberOfLines(), mesh, this->NumberOfPatches, numberOfPoints);
  const int numberOfSegments = this->NumberOfLineSegments > 0
    ? this->NumberOfLineSegments
    : GetDefaultNumberOfLineSegments(input->GetLines());
  const bool isCoarser = lines.Divide(this->SegmentLength, numberOfSegments, budget.Lines);
  lines.SetPoints(arrays);
  lines.AddNeighbors(neighbors);
  this->NumberOfSegmentsOfLines = lines.NumberOfSegments;

  const std::vector<int> seeds = vtkSurfacePatches::PlaceSeeds(
    mesh, budget.Patches, [&](double fraction) { return goesOn(0.2, 0.6, fraction); });
  if (!goesOn(0.2, 0.6, 1.0))
  {
    return std::string();
  }
  const std::vector<NearSeeds> nearSeeds = vtkSurfacePatches::FindNearSeeds(
    mesh, seeds, [&](double fraction) { return goesOn(0.6, 0.95, fraction); });
  if (!goesOn(0.6, 0.95, 1.0))
  {
    return std::string();
  }
  SetPatches(mesh, nearSeeds, lines.NumberOfSegments, lines, arrays);
  for (const std::pair<int, int>& pair : vtkSurfacePatches::FindNeighbors(mesh, nearSeeds))
  {
    neighbors.emplace_back(
      lines.NumberOfSegments + pair.first, lines.NumberOfSegments + pair.second);
  }
  this->NumberOfSegmentsOfSurfaces = static_cast<int>(seeds.size());

  const int firstPoint = lines.NumberOfSegments + this->NumberOfSegmentsOfSurfaces;
  for (vtkIdType i = 0; i < numberOfPoints && budget.PointsPerSegment > 0; ++i)
  {
    const int segment = static_cast<int>(i / budget.PointsPerSegment);
    arrays.Set(points.Points[static_cast<std::size_t>(i)], firstPoint + segment);
    this->NumberOfSegmentsOfPoints = segment + 1;
  }
  SetFieldData(output, neighbors, this->GetNumberOfSegments());

  this->NumberOfSharedPoints =
    lines.NumberOfSharedPoints + points.NumberOfSharedPoints + CountShared(lines, mesh);
  this->NumberOfNonFinitePoints = lines.GetInput().NumberOfNonFinitePoints +
    mesh.NumberOfNonFinitePoints + points.NumberOfNonFinitePoints;
  this->NumberOfInvalidIds =
    lines.GetInput().NumberOfInvalidIds + mesh.NumberOfInvalidIds + points.NumberOfInvalidIds;
  warning = DescribeDropped(lines, mesh, points);
  if (isCoarser || budget.MissingPatches > 0 || budget.PointsPerSegment != 1)
  {
    AddLine(warning, DescribeLimit(lines, isCoarser, budget));
  }
  return std::string();
}

//------------------------------------------------------------------------------
int vtkOpacitySegments::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(input);
  this->SetErrorCode(vtkErrorCode::NoError);
  this->NumberOfSegmentsOfLines = 0;
  this->NumberOfSegmentsOfSurfaces = 0;
  this->NumberOfSegmentsOfPoints = 0;
  this->NumberOfSharedPoints = 0;
  this->NumberOfNonFinitePoints = 0;
  this->NumberOfInvalidIds = 0;

  std::string warning;
  std::string error;
  try
  {
    error = this->Execute(input, output, warning);
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory to part the geometry into segments; pass it in parts.";
  }
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  if (!error.empty() || vtkLineSetsCompatibility::CheckAbort(this))
  {
    output->Initialize();
    this->NumberOfSegmentsOfLines = 0;
    this->NumberOfSegmentsOfSurfaces = 0;
    this->NumberOfSegmentsOfPoints = 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpacitySegments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLineSegments: " << this->NumberOfLineSegments << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NumberOfSegmentsOfLines: " << this->NumberOfSegmentsOfLines << "\n";
  os << indent << "NumberOfSegmentsOfSurfaces: " << this->NumberOfSegmentsOfSurfaces << "\n";
  os << indent << "NumberOfSegmentsOfPoints: " << this->NumberOfSegmentsOfPoints << "\n";
  os << indent << "NumberOfSharedPoints: " << this->NumberOfSharedPoints << "\n";
  os << indent << "NumberOfNonFinitePoints: " << this->NumberOfNonFinitePoints << "\n";
  os << indent << "NumberOfInvalidIds: " << this->NumberOfInvalidIds << "\n";
}
