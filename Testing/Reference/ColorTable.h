// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A lookup table or transfer function, copied so that threads can read it.
 */

#ifndef ColorTable_h
#define ColorTable_h

#include <array>  // For an entry
#include <vector> // For the entries

class vtkScalarsToColors;

namespace linesets
{
/**
 * Colours and opacities of a vtkScalarsToColors, sampled at 65536 values over its range (so that
 * a step of the table may be misplaced by up to 1/131072 of the range), and its answers below,
 * above and for NaN.
 */
class ColorTable
{
public:
  ColorTable() = default;
  explicit ColorTable(vtkScalarsToColors* table);

  /// Red, green, blue and opacity, 0 to 1, for a value.
  const std::array<double, 4>& Map(double value) const;

  /// Whether all opacities are 1.
  bool IsOpaque() const;

private:
  double Range[2] = { 0.0, 1.0 };
  std::vector<std::array<double, 4>> Entries;
  std::array<double, 4> Below = { { 1.0, 1.0, 1.0, 1.0 } };
  std::array<double, 4> Above = { { 1.0, 1.0, 1.0, 1.0 } };
  std::array<double, 4> NaN = { { 1.0, 1.0, 1.0, 1.0 } };
};
}

#endif
