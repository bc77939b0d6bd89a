// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Chebyshev distance of every cell of a grid to the nearest occupied one.
 *
 * The distance is the largest of the three axis distances, so that it can be made axis by axis:
 * after a pass along an axis, a cell holds min over its column of max(offset, value before).
 * Each pass is exact up to the clamp; it works on rows of bytes, many cells at a time.
 */

#ifndef vtkVoxelLineDistancePrivate_h
#define vtkVoxelLineDistancePrivate_h

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkVoxelLineDistance
{

/// The pass along x: distances within one row, by a sweep to either side.
inline void SweepRow(std::uint8_t* row, int size, int largest)
{
  int distance = largest;
  for (int x = 0; x < size; ++x)
  {
    distance = row[x] == 0 ? 0 : std::min(distance + 1, largest);
    row[x] = static_cast<std::uint8_t>(distance);
  }
  distance = largest;
  for (int x = size - 1; x >= 0; --x)
  {
    distance = row[x] == 0 ? 0 : std::min(distance + 1, largest);
    row[x] = static_cast<std::uint8_t>(std::min<int>(row[x], distance));
  }
}

/// Row i of a pass along y or z: rows of the given width, stride apart, i of count.
inline void MinimizeRow(const std::uint8_t* source, std::uint8_t* target, std::ptrdiff_t stride,
  int i, int count, int width)
{
  const std::uint8_t* here = source + i * stride;
  std::copy_n(here, width, target);
  for (int offset = 1; offset < std::max(count - i, i + 1); ++offset)
  {
    // No farther row can lower a distance that is not above the offset.
    if (*std::max_element(target, target + width) <= offset)
    {
      return;
    }
    const std::uint8_t* before = i - offset >= 0 ? here - offset * stride : here;
    const std::uint8_t* after = i + offset < count ? here + offset * stride : here;
    const std::uint8_t floor = static_cast<std::uint8_t>(offset);
    for (int x = 0; x < width; ++x)
    {
      // max(offset, here) is never below what target has already, so a missing row does no harm.
      const std::uint8_t nearest = std::min(before[x], after[x]);
      target[x] = std::min(target[x], std::max(floor, nearest));
    }
  }
}

/**
 * Turn values of 0 for occupied cells and anything else for empty ones into distances, clamped at
 * largest, at most 255. x is fastest. The result does not depend on the number of threads.
 */
inline void Transform(std::vector<std::uint8_t>& cells, const int dimensions[3], int largest)
{
  const std::ptrdiff_t width = dimensions[0];
  const std::ptrdiff_t slice = width * dimensions[1];
  std::vector<std::uint8_t> other(cells.size());
  const vtkIdType rows = static_cast<vtkIdType>(dimensions[1]) * dimensions[2];
  vtkSMPTools::For(0, rows, 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        SweepRow(cells.data() + row * width, dimensions[0], largest);
      }
    });
  vtkSMPTools::For(0, rows, 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const std::ptrdiff_t y = row % dimensions[1];
        const std::ptrdiff_t z = row / dimensions[1];
        MinimizeRow(cells.data() + z * slice, other.data() + row * width, width,
          static_cast<int>(y), dimensions[1], dimensions[0]);
      }
    });
  vtkSMPTools::For(0, rows, 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const std::ptrdiff_t y = row % dimensions[1];
        const std::ptrdiff_t z = row / dimensions[1];
        MinimizeRow(other.data() + y * width, cells.data() + row * width, slice,
          static_cast<int>(z), dimensions[2], dimensions[0]);
      }
    });
}

}

#endif

// VTK-HeaderTest-Exclude: vtkVoxelLineDistancePrivate.h
