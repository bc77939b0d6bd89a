// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lines cut into segments of equal length, and the arrays that vtkOpacitySegments writes.
 */

#ifndef vtkOpacityLineSegmentsPrivate_h
#define vtkOpacityLineSegmentsPrivate_h

#include "vtkLineVoxelizerInputPrivate.h"

#include <atomic>
#include <utility>
#include <vector>

namespace vtkOpacityLineSegments
{

/// The point arrays; see vtkOpacitySegments.
struct PointArrays
{
  int* Ids;
  float* Distances;

  /// A missing segment has the id -1 and the cut-off as its distance.
  void Set(vtkIdType point, const int ids[3], const double distances[4]) const
  {
    // What single precision cannot hold is told in units of the cut-off.
    const double cutOff = distances[3];
    const double unit = cutOff > 1e-30 && cutOff < 1e30 ? 1.0 : cutOff;
    for (int i = 0; i < 3; ++i)
    {
      this->Ids[3 * point + i] = ids[i];
    }
    for (int i = 0; i < 4; ++i)
    {
      this->Distances[4 * point + i] = static_cast<float>(distances[i] / unit);
    }
  }

  /// One segment that alone counts, or none with the id -1.
  void Set(vtkIdType point, int id) const
  {
    const int ids[3] = { id, -1, -1 };
    const double distances[4] = { id < 0 ? 1.0 : 0.0, 1.0, 1.0, 1.0 };
    this->Set(point, ids, distances);
  }
};

class Division
{
public:
  /// Find the lines, their lengths, and the first line of each point. The data must live as long.
  explicit Division(vtkPolyData* data);

  /**
   * Decide on the number of segments of each line, at least one. A length above 0 rules; with 0,
   * the total length is divided by the number. There are at most as many as the limit. Returns
   * whether that made segments longer.
   */
  bool Divide(double length, int number, int limit);

  /// Set the arrays at all points that lines use.
  void SetPoints(const PointArrays& arrays) const;

  /// Append the pairs of neighbours, in ascending order.
  void AddNeighbors(std::vector<std::pair<int, int>>& pairs) const;

  vtkIdType GetNumberOfLines() const { return static_cast<vtkIdType>(this->Lines.size()); }
  bool IsUsed(vtkIdType point) const
  {
    return this->Owners[static_cast<std::size_t>(point)] != NoOwner;
  }

  const vtkLineVoxelizerPrivate::Input& GetInput() const { return this->Source; }
  int NumberOfSegments = 0;
  /// Lines for which no segments were left, and those whose length is infinite.
  vtkIdType NumberOfLeftOutLines = 0;
  vtkIdType NumberOfInfiniteLines = 0;
  /// Points that several lines use.
  vtkIdType NumberOfSharedPoints = 0;

private:
  struct Line
  {
    double Length = 0.0;
    bool IsClosed = false;
    int First = 0;
    int Number = 0;
  };
  static constexpr vtkIdType NoOwner = VTK_ID_MAX;

  void Measure(std::size_t line, vtkIdList* ids, std::vector<std::atomic<bool>>& isShared);
  void SetPointsOfLine(std::size_t line, vtkIdList* ids, const PointArrays& arrays) const;
  double GetTotal(double length) const;

  vtkLineVoxelizerPrivate::Input Source;
  std::vector<Line> Lines;
  std::vector<std::atomic<vtkIdType>> Owners;
};

}

#endif

// VTK-HeaderTest-Exclude: vtkOpacityLineSegmentsPrivate.h
