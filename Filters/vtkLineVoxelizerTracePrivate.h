// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cuts curves at the faces of a grid and codes the pieces as segments of a vtkVoxelLineModel.
 *
 * A curve is walked edge by edge with a digital differential analyzer. The voxel of a vertex is a
 * function of its position alone, so that an edge crosses a known number of faces: that is the
 * number of steps, whatever rounding does, and a walk always ends. Of the faces left to cross, the
 * one with the smallest parameter is next; a tie at a voxel edge or corner goes to the lowest axis,
 * and the crossing point is clamped to the face. The point is quantized once and used on both sides
 * of the face, so that the end of a segment is the start of the next one.
 *
 * The vertices that a curve has inside a voxel make a piece with its entry and exit. Where the
 * piece deviates too far from the chord, its farthest vertex is kept as a point inside the voxel,
 * and both halves are judged again (Douglas and Peucker 1973).
 */

#ifndef vtkLineVoxelizerTracePrivate_h
#define vtkLineVoxelizerTracePrivate_h

#include "vtkVoxelLineEncodingPrivate.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkLineVoxelizerPrivate
{

/// Placement of the voxels, see vtkVoxelLineModel.
struct Grid
{
  int Dimensions[3] = { 0, 0, 0 };
  int BrickDimensions[3] = { 0, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double VoxelSize = 1.0;
};

/// A point of a curve in grid-local coordinates, with its attribute and radius, both in [0,1].
struct Sample
{
  double Point[3];
  float Attribute[4];
  float Radius;
};

/// What the segments carry besides their end points.
struct Payload
{
  /// 0, 1 (scalar) or 4 (red, green, blue, opacity) attribute values per end point.
  int AttributeSize = 0;
  /// Largest byte that a scalar takes: 254 where 255 marks NaN.
  int LargestByte = 255;
  bool HasRadii = false;
};

/// How a traced segment lies in memory, in one place, since it will be fetched in another order:
/// its words, then bytes: attributes of both ends, radii of both ends, its voxel's bit in the mask.
struct RecordLayout
{
  RecordLayout(const vtkVoxelLineEncoding::Codec& codec, const Payload& payload)
    : Words(static_cast<std::size_t>(codec.Words))
    , AttributeBytes(2 * static_cast<std::size_t>(payload.AttributeSize))
    , RadiusBytes(payload.HasRadii ? 2 : 0)
    , Stride(this->Words + (this->AttributeBytes + this->RadiusBytes + 1 + 3) / 4)
  {
  }
  /// The bytes of a record; radii follow AttributeBytes, the voxel bit follows these.
  const std::uint8_t* GetBytes(const std::uint32_t* record) const
  {
    return reinterpret_cast<const std::uint8_t*>(record + this->Words);
  }
  std::uint8_t GetVoxelBit(const std::uint32_t* record) const
  {
    return this->GetBytes(record)[this->AttributeBytes + this->RadiusBytes];
  }

  std::size_t Words;
  std::size_t AttributeBytes;
  std::size_t RadiusBytes;
  /// Words from one record to the next.
  std::size_t Stride;
};

/// Segments in the order in which the curves are walked.
struct Trace
{
  /// Index of the brick cell of each segment.
  std::vector<std::uint32_t> Cells;
  std::vector<std::uint32_t> Records;
  /// Number of segments of each curve.
  std::vector<std::uint32_t> CurveSizes;
  std::int64_t NumberOfCollapsed = 0;
  /// Squared, in voxels.
  double LargestDeviation2 = 0.0;
};

class CurveTracer
{
public:
  CurveTracer(const Grid& grid, int faceBins, double interiorTolerance, const Payload& payload);

  /// Append the segments of one curve of two points or more.
  void AddCurve(const std::vector<Sample>& curve, Trace& trace);

private:
  /// An end point as the model will have it, in voxel-local coordinates.
  struct CodedPoint
  {
    std::uint32_t Code;
    double Point[3];
  };

  void VoxelOf(const double point[3], int voxel[3]) const;
  CodedPoint CodeInterior(const double point[3]) const;
  CodedPoint CodeFace(const double point[3], int axis, int side) const;
  CodedPoint Opposite(const CodedPoint& point, int axis) const;

  void Walk(const Sample& from, const Sample& to);
  void BeginPiece(const Sample& entry, const CodedPoint& code);
  void EndPiece(const Sample& exit, const CodedPoint& code);
  std::size_t FindFarthest(std::size_t first, std::size_t last, double& distance2) const;
  void MeasureDeviation(
    std::size_t first, std::size_t last, const CodedPoint& start, const CodedPoint& end);
  void AddSegment(
    std::size_t first, std::size_t last, const CodedPoint& start, const CodedPoint& end);
  void Write(const Sample& first, const Sample& last, const CodedPoint& start,
    const CodedPoint& end, const int voxel[3]);
  std::uint8_t* WriteAttribute(const Sample& sample, std::uint8_t* bytes) const;

  const Grid& Cells;
  const vtkVoxelLineEncoding::Codec Codec;
  const double Tolerance2;
  const Payload Values;
  const RecordLayout Layout;

  /// The voxel that the walk is in, and the curve inside it.
  int Voxel[3] = { 0, 0, 0 };
  std::vector<Sample> Piece;
  CodedPoint Entry;
  std::vector<std::size_t> Ends;

  /// The first collapsed segment of the curve, in case that nothing else remains of it.
  bool HasPoint = false;
  Sample PointSample;
  CodedPoint PointCode;
  int PointVoxel[3] = { 0, 0, 0 };

  Trace* Target = nullptr;
};

}

#endif

// VTK-HeaderTest-Exclude: vtkLineVoxelizerTracePrivate.h
