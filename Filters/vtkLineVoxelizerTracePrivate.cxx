// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineVoxelizerTracePrivate.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vtkLineVoxelizerPrivate
{

namespace
{

/// A piece is ended at this many vertices, so that its simplification takes bounded time however
/// many vertices a curve has in one voxel.
constexpr std::size_t LargestPiece = 512;

double Clamp(double value, double low, double high)
{
  return std::min(std::max(value, low), high);
}

double SquaredDistance(const double a[3], const double b[3])
{
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/// Squared distance between a point and the segment from a to b, which may be a point.
double SquaredDistance(const double point[3], const double a[3], const double b[3])
{
  const double d[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double length2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  if (!(length2 > 0.0))
  {
    return SquaredDistance(point, a);
  }
  const double t = Clamp(
    ((point[0] - a[0]) * d[0] + (point[1] - a[1]) * d[1] + (point[2] - a[2]) * d[2]) / length2, 0.0,
    1.0);
  const double nearest[3] = { a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2] };
  return SquaredDistance(point, nearest);
}

/// Linear interpolation; where one of the values is NaN, the nearer vertex has its way.
float Mix(float from, float to, float t)
{
  const float mixed = from + t * (to - from);
  return std::isnan(mixed) ? (t < 0.5f ? from : to) : mixed;
}

/// The point at parameter t of an edge, clamped to the face of the voxel where it leaves.
Sample MakeCrossing(
  const Sample& from, const Sample& to, double t, const int voxel[3], int axis, int plane)
{
  Sample crossing;
  for (int i = 0; i < 3; ++i)
  {
    crossing.Point[i] = Clamp(from.Point[i] + t * (to.Point[i] - from.Point[i]), voxel[i],
      static_cast<double>(voxel[i]) + 1);
  }
  crossing.Point[axis] = plane;
  for (int i = 0; i < 4; ++i)
  {
    crossing.Attribute[i] = Mix(from.Attribute[i], to.Attribute[i], static_cast<float>(t));
  }
  crossing.Radius = Mix(from.Radius, to.Radius, static_cast<float>(t));
  return crossing;
}

std::uint8_t ByteOf(float value, int largest)
{
  if (std::isnan(value))
  {
    return 255;
  }
  return static_cast<std::uint8_t>(value * static_cast<float>(largest) + 0.5f);
}

}

//------------------------------------------------------------------------------
CurveTracer::CurveTracer(
  const Grid& grid, int faceBins, double interiorTolerance, const Payload& payload)
  : Cells(grid)
  , Codec(faceBins)
  , Tolerance2(interiorTolerance * interiorTolerance)
  , Values(payload)
  , Layout(this->Codec, payload)
{
}

//------------------------------------------------------------------------------
void CurveTracer::VoxelOf(const double point[3], int voxel[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // Points are not negative, so that the cast rounds down; the upper bound is in the last voxel.
    voxel[axis] = std::min(static_cast<int>(point[axis]), this->Cells.Dimensions[axis] - 1);
  }
}

//------------------------------------------------------------------------------
CurveTracer::CodedPoint CurveTracer::CodeInterior(const double point[3]) const
{
  CodedPoint coded{ 0, { 0.0, 0.0, 0.0 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    coded.Point[axis] = Clamp(point[axis] - this->Voxel[axis], 0.0, 1.0);
  }
  if (this->Codec.FaceBins == 0)
  {
    for (double& coordinate : coded.Point)
    {
      coordinate = static_cast<float>(coordinate);
    }
    return coded;
  }
  coded.Code = this->Codec.InteriorCode(coded.Point);
  this->Codec.Decode(coded.Code, coded.Point);
  return coded;
}

//------------------------------------------------------------------------------
CurveTracer::CodedPoint CurveTracer::CodeFace(const double point[3], int axis, int side) const
{
  CodedPoint coded{ 0, { 0.0, 0.0, 0.0 } };
  coded.Point[axis] = side;
  const int uAxis = (axis + 1) % 3;
  const int vAxis = (axis + 2) % 3;
  const double u = point[uAxis] - this->Voxel[uAxis];
  const double v = point[vAxis] - this->Voxel[vAxis];
  const int bins = this->Codec.FaceBins;
  if (bins == 0)
  {
    coded.Point[uAxis] = static_cast<float>(u);
    coded.Point[vAxis] = static_cast<float>(v);
    return coded;
  }
  const std::uint32_t uBin = vtkVoxelLineEncoding::Codec::Bin(u, bins);
  const std::uint32_t vBin = vtkVoxelLineEncoding::Codec::Bin(v, bins);
  coded.Code = this->Codec.FaceCode(static_cast<std::uint32_t>(2 * axis + side), uBin, vBin);
  coded.Point[uAxis] = (uBin + 0.5) / bins;
  coded.Point[vAxis] = (vBin + 0.5) / bins;
  return coded;
}

//------------------------------------------------------------------------------
CurveTracer::CodedPoint CurveTracer::Opposite(const CodedPoint& point, int axis) const
{
  CodedPoint opposite = point;
  opposite.Point[axis] = 1.0 - point.Point[axis];
  if (this->Codec.FaceBins != 0)
  {
    opposite.Code = this->Codec.Opposite(point.Code);
  }
  return opposite;
}

//------------------------------------------------------------------------------
void CurveTracer::AddCurve(const std::vector<Sample>& curve, Trace& trace)
{
  this->Target = &trace;
  this->HasPoint = false;
  const std::size_t first = trace.Cells.size();

  this->VoxelOf(curve.front().Point, this->Voxel);
  this->BeginPiece(curve.front(), this->CodeInterior(curve.front().Point));
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    this->Walk(curve[i - 1], curve[i]);
    if (i + 1 == curve.size() || this->Piece.size() >= LargestPiece)
    {
      const CodedPoint code = this->CodeInterior(curve[i].Point);
      this->EndPiece(curve[i], code);
      this->BeginPiece(curve[i], code);
    }
    else
    {
      this->Piece.push_back(curve[i]);
    }
  }

  if (trace.Cells.size() == first && this->HasPoint)
  {
    this->Write(
      this->PointSample, this->PointSample, this->PointCode, this->PointCode, this->PointVoxel);
    --trace.NumberOfCollapsed;
  }
  trace.CurveSizes.push_back(static_cast<std::uint32_t>(trace.Cells.size() - first));
}

//------------------------------------------------------------------------------
void CurveTracer::Walk(const Sample& from, const Sample& to)
{
  int target[3];
  this->VoxelOf(to.Point, target);
  int steps = 0;
  int remaining[3];
  int step[3];
  double parameter[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    remaining[axis] = std::abs(target[axis] - this->Voxel[axis]);
    step[axis] = target[axis] > this->Voxel[axis] ? 1 : -1;
    steps += remaining[axis];
  }
  if (steps == 0)
  {
    return;
  }

  const auto parameterOf = [&](int axis)
  {
    if (remaining[axis] == 0)
    {
      return 2.0; // Behind the end of the edge: never chosen.
    }
    const int plane = this->Voxel[axis] + (step[axis] > 0 ? 1 : 0);
    const double t = (plane - from.Point[axis]) / (to.Point[axis] - from.Point[axis]);
    // The ends are in different voxels, so that t is in [0,1]; unless a processor that flushes
    // subnormal numbers makes it NaN.
    return t > 0.0 ? std::min(t, 1.0) : 0.0;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    parameter[axis] = parameterOf(axis);
  }

  for (; steps > 0; --steps)
  {
    int axis = parameter[1] < parameter[0] ? 1 : 0;
    axis = parameter[2] < parameter[axis] ? 2 : axis;
    const int side = step[axis] > 0 ? 1 : 0;
    const Sample crossing =
      MakeCrossing(from, to, parameter[axis], this->Voxel, axis, this->Voxel[axis] + side);
    const CodedPoint code = this->CodeFace(crossing.Point, axis, side);
    this->EndPiece(crossing, code);
    this->Voxel[axis] += step[axis];
    this->BeginPiece(crossing, this->Opposite(code, axis));
    --remaining[axis];
    parameter[axis] = parameterOf(axis);
  }
}

//------------------------------------------------------------------------------
void CurveTracer::BeginPiece(const Sample& entry, const CodedPoint& code)
{
  this->Piece.clear();
  this->Piece.push_back(entry);
  this->Entry = code;
}

//------------------------------------------------------------------------------
void CurveTracer::EndPiece(const Sample& exit, const CodedPoint& code)
{
  this->Piece.push_back(exit);
  std::size_t first = 0;
  CodedPoint start = this->Entry;
  // The ends of the stretches that are still to be judged, the next one last.
  this->Ends.assign(1, this->Piece.size() - 1);
  while (!this->Ends.empty())
  {
    const std::size_t last = this->Ends.back();
    double distance2 = 0.0;
    const std::size_t farthest = this->FindFarthest(first, last, distance2);
    if (distance2 > this->Tolerance2)
    {
      this->Ends.push_back(farthest);
      continue;
    }
    this->Ends.pop_back();
    const CodedPoint end = this->Ends.empty() ? code : this->CodeInterior(this->Piece[last].Point);
    this->AddSegment(first, last, start, end);
    first = last;
    start = end;
  }
}

//------------------------------------------------------------------------------
std::size_t CurveTracer::FindFarthest(std::size_t first, std::size_t last, double& distance2) const
{
  std::size_t farthest = first;
  distance2 = 0.0;
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double candidate =
      SquaredDistance(this->Piece[i].Point, this->Piece[first].Point, this->Piece[last].Point);
    if (candidate > distance2)
    {
      distance2 = candidate;
      farthest = i;
    }
  }
  return farthest;
}

//------------------------------------------------------------------------------
void CurveTracer::MeasureDeviation(
  std::size_t first, std::size_t last, const CodedPoint& start, const CodedPoint& end)
{
  double a[3];
  double b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = this->Voxel[axis] + start.Point[axis];
    b[axis] = this->Voxel[axis] + end.Point[axis];
  }
  double largest = this->Target->LargestDeviation2;
  // The distance to an end is never smaller than that to the segment and cheaper to tell.
  if (SquaredDistance(this->Piece[first].Point, a) > largest)
  {
    largest = std::max(largest, SquaredDistance(this->Piece[first].Point, a, b));
  }
  if (SquaredDistance(this->Piece[last].Point, b) > largest)
  {
    largest = std::max(largest, SquaredDistance(this->Piece[last].Point, a, b));
  }
  for (std::size_t i = first + 1; i < last; ++i)
  {
    largest = std::max(largest, SquaredDistance(this->Piece[i].Point, a, b));
  }
  this->Target->LargestDeviation2 = largest;
}

//------------------------------------------------------------------------------
void CurveTracer::AddSegment(
  std::size_t first, std::size_t last, const CodedPoint& start, const CodedPoint& end)
{
  this->MeasureDeviation(first, last, start, end);
  if (start.Code == end.Code && std::equal(start.Point, start.Point + 3, end.Point))
  {
    ++this->Target->NumberOfCollapsed;
    if (!this->HasPoint)
    {
      this->HasPoint = true;
      this->PointSample = this->Piece[first];
      this->PointCode = start;
      std::copy_n(this->Voxel, 3, this->PointVoxel);
    }
    return;
  }
  this->Write(this->Piece[first], this->Piece[last], start, end, this->Voxel);
}

//------------------------------------------------------------------------------
void CurveTracer::Write(const Sample& first, const Sample& last, const CodedPoint& start,
  const CodedPoint& end, const int voxel[3])
{
  constexpr int size = vtkVoxelLineModel::BrickSize;
  const int* bricks = this->Cells.BrickDimensions;
  this->Target->Cells.push_back(static_cast<std::uint32_t>(
    voxel[0] / size + bricks[0] * (voxel[1] / size + bricks[1] * (voxel[2] / size))));

  std::vector<std::uint32_t>& records = this->Target->Records;
  const std::size_t offset = records.size();
  records.resize(offset + this->Layout.Stride);
  std::uint32_t* words = records.data() + offset;
  if (this->Codec.FaceBins == 0)
  {
    float points[6];
    for (int axis = 0; axis < 3; ++axis)
    {
      points[axis] = static_cast<float>(start.Point[axis]);
      points[3 + axis] = static_cast<float>(end.Point[axis]);
    }
    std::memcpy(words, points, sizeof(points));
  }
  else
  {
    this->Codec.Pack(start.Code, end.Code, words);
  }

  std::uint8_t* bytes = reinterpret_cast<std::uint8_t*>(words + this->Layout.Words);
  bytes = this->WriteAttribute(first, bytes);
  bytes = this->WriteAttribute(last, bytes);
  if (this->Values.HasRadii)
  {
    *bytes++ = ByteOf(first.Radius, 255);
    *bytes++ = ByteOf(last.Radius, 255);
  }
  *bytes = static_cast<std::uint8_t>(
    voxel[0] % size + size * (voxel[1] % size + size * (voxel[2] % size)));
}

//------------------------------------------------------------------------------
std::uint8_t* CurveTracer::WriteAttribute(const Sample& sample, std::uint8_t* bytes) const
{
  for (int i = 0; i < this->Values.AttributeSize; ++i)
  {
    *bytes++ = ByteOf(sample.Attribute[i], this->Values.LargestByte);
  }
  return bytes;
}

}
