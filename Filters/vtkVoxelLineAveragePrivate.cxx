// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMath.h"
#include "vtkVoxelLineRepresentativesPrivate.h"

#include <algorithm>
#include <cmath>

namespace vtkVoxelLineRepresentatives
{

namespace
{

using Vector = std::array<double, 3>;

constexpr std::uint8_t NaNByte = 255;

/// How often the common direction is found anew from the lines turned towards the last one.
constexpr int NumberOfTurns = 2;

Vector ChordOf(const Passage& passage)
{
  Vector chord;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    chord[axis] = static_cast<double>(passage.End.Point[axis]) - passage.Start.Point[axis];
  }
  return chord;
}

/// Whether a passage is to be flipped to go along an axis: at more than 90 degrees to it.
bool IsAgainst(const Vector& chord, const Vector& axis)
{
  return vtkMath::Dot(chord.data(), axis.data()) < 0.0;
}

/// The passage with the longest chord, the first of several.
const Passage* FindLongest(const Passage* first, const Passage* last)
{
  const Passage* longest = first;
  double largest = -1.0;
  for (const Passage* passage = first; passage != last; ++passage)
  {
    const Vector chord = ChordOf(*passage);
    const double length2 = vtkMath::Dot(chord.data(), chord.data());
    if (length2 > largest)
    {
      largest = length2;
      longest = passage;
    }
  }
  return longest;
}

/// Direction that the passages, each turned to its side, have together; that of the longest first.
Vector FindAxis(const Passage* first, const Passage* last, const Passage& longest)
{
  Vector axis = ChordOf(longest);
  for (int turn = 0; turn < NumberOfTurns && last - first > 1; ++turn)
  {
    Vector sum = { 0.0, 0.0, 0.0 };
    for (const Passage* passage = first; passage != last; ++passage)
    {
      const Vector chord = ChordOf(*passage);
      const double sign = IsAgainst(chord, axis) ? -1.0 : 1.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        sum[i] += sign * chord[i];
      }
    }
    axis = sum;
  }
  // The representative goes the way of the curve that it is named after.
  if (IsAgainst(ChordOf(longest), axis))
  {
    vtkMath::MultiplyScalar(axis.data(), -1.0);
  }
  return axis;
}

/// Sums of what lies at one end of the passages.
class EndMean
{
public:
  EndMean(const AveragingRules& rules, const std::array<int, 3>& voxel)
    : Rules(rules)
    , Voxel(voxel)
    , Scale(1.0 / (1 << rules.Level))
  {
  }

  void Add(const PassageEnd& end)
  {
    bool isInside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      // Exact: a power of two.
      const double local = this->Scale * end.Point[axis] - this->Voxel[axis];
      isInside = isInside && local > 0.0 && local < 1.0;
      this->Point[axis] += local;
    }
    this->IsInside = this->IsInside && isInside;
    ++this->Number;
    this->Radius += end.Radius;
    if (this->Rules.HasNaN && end.Attribute[0] == NaNByte)
    {
      return;
    }
    ++this->NumberOfValues;
    for (std::size_t i = 0; i < this->Rules.AttributeSize; ++i)
    {
      this->Attribute[i] += end.Attribute[i];
    }
  }

  Vector GetPoint() const
  {
    const double n = this->Number;
    return { this->Point[0] / n, this->Point[1] / n, this->Point[2] / n };
  }

  /// Whether no line reaches the boundary of the voxel here.
  bool GetIsInside() const { return this->IsInside; }

  /// Everything but the point.
  void Write(RepresentativeEnd& end) const
  {
    end.Attribute = {};
    for (std::size_t i = 0; i < this->Rules.AttributeSize; ++i)
    {
      end.Attribute[i] = this->NumberOfValues > 0
        ? static_cast<std::uint8_t>(std::lround(this->Attribute[i] / this->NumberOfValues))
        : NaNByte;
    }
    end.Radius = static_cast<std::uint8_t>(std::lround(this->Radius / this->Number));
  }

private:
  const AveragingRules& Rules;
  const std::array<int, 3>& Voxel;
  const double Scale;
  Vector Point = { 0.0, 0.0, 0.0 };
  bool IsInside = true;
  int Number = 0;
  double Radius = 0.0;
  int NumberOfValues = 0;
  std::array<double, 4> Attribute = { 0.0, 0.0, 0.0, 0.0 };
};

/// The middle of the bin that a coordinate falls into; itself where points are exact.
float SnapCoordinate(double coordinate, int bins)
{
  return static_cast<float>(bins == 0
      ? std::min(std::max(coordinate, 0.0), 1.0)
      : (vtkVoxelLineEncoding::Codec::Bin(coordinate, bins) + 0.5) / bins);
}

/// Put an end on the face of the voxel that is nearest to a point inside it, the first of several.
void SnapToBoundary(const Vector& point, int bins, RepresentativeEnd& end)
{
  std::int8_t face = 0;
  double nearest = 2.0;
  for (int i = 0; i < 6; ++i)
  {
    const double coordinate = point[static_cast<std::size_t>(i) / 2];
    const double distance = i % 2 == 0 ? coordinate : 1.0 - coordinate;
    if (distance < nearest)
    {
      nearest = distance;
      face = static_cast<std::int8_t>(i);
    }
  }
  end.Face = face;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::size_t i = static_cast<std::size_t>(axis);
    end.Local[i] = axis == face / 2 ? static_cast<float>(face % 2) : SnapCoordinate(point[i], bins);
  }
}

/// Keep an end inside the voxel.
void SnapToInside(const Vector& point, int interiorBins, RepresentativeEnd& end)
{
  end.Face = NoFace;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    end.Local[axis] = SnapCoordinate(point[axis], interiorBins);
  }
}

bool IsPoint(const Representative& line)
{
  return line.Ends[0].Local == line.Ends[1].Local;
}

}

//------------------------------------------------------------------------------
Representative Average(const AveragingRules& rules, const std::array<int, 3>& voxel,
  const Passage* first, const Passage* last)
{
  const Passage* longest = FindLongest(first, last);
  const Vector axis = FindAxis(first, last, *longest);
  std::array<EndMean, 2> means = { EndMean(rules, voxel), EndMean(rules, voxel) };
  for (const Passage* passage = first; passage != last; ++passage)
  {
    const bool isFlipped = IsAgainst(ChordOf(*passage), axis);
    means[isFlipped ? 1 : 0].Add(passage->Start);
    means[isFlipped ? 0 : 1].Add(passage->End);
  }

  Representative line;
  line.Voxel = voxel;
  line.Curve = longest->Curve;
  for (std::size_t i = 0; i < 2; ++i)
  {
    RepresentativeEnd& end = line.Ends[i];
    means[i].Write(end);
    if (means[i].GetIsInside())
    {
      SnapToInside(means[i].GetPoint(), rules.InteriorBins, end);
    }
    else
    {
      SnapToBoundary(means[i].GetPoint(), rules.FaceBins, end);
    }
  }
  if (IsPoint(line) && last - first > 1)
  {
    // The average says nothing; one of the lines says more.
    return Average(rules, voxel, longest, longest + 1);
  }
  return line;
}

}
