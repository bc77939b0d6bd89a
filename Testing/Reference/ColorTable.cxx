// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorTable.h"

#include "vtkScalarsToColors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linesets
{
namespace
{
constexpr int NumberOfEntries = 65536;

std::array<double, 4> MapValue(vtkScalarsToColors* table, double value)
{
  std::array<double, 4> entry;
  const unsigned char* rgba = table->MapValue(value);
  for (int i = 0; i < 4; ++i)
  {
    entry[i] = rgba[i] / 255.0;
  }
  return entry;
}
}

//------------------------------------------------------------------------------
ColorTable::ColorTable(vtkScalarsToColors* table)
{
  table->Build();
  std::copy_n(table->GetRange(), 2, this->Range);
  const double width = this->Range[1] - this->Range[0];
  for (int i = 0; i < NumberOfEntries; ++i)
  {
    this->Entries.push_back(MapValue(table, this->Range[0] + width * i / (NumberOfEntries - 1.0)));
  }
  const double far = width > 0.0 ? width : std::abs(this->Range[0]) + 1.0;
  this->Below = MapValue(table, this->Range[0] - far);
  this->Above = MapValue(table, this->Range[1] + far);
  this->NaN = MapValue(table, std::numeric_limits<double>::quiet_NaN());
}

//------------------------------------------------------------------------------
const std::array<double, 4>& ColorTable::Map(double value) const
{
  if (std::isnan(value) || this->Entries.empty())
  {
    return this->NaN;
  }
  if (value < this->Range[0])
  {
    return this->Below;
  }
  if (value > this->Range[1])
  {
    return this->Above;
  }
  const double width = this->Range[1] - this->Range[0];
  const double position = width > 0.0 ? (value - this->Range[0]) / width : 0.0;
  return this->Entries[static_cast<int>(position * (NumberOfEntries - 1.0) + 0.5)];
}

//------------------------------------------------------------------------------
bool ColorTable::IsOpaque() const
{
  const auto opaque = [](const std::array<double, 4>& entry) { return entry[3] >= 1.0; };
  return opaque(this->Below) && opaque(this->Above) && opaque(this->NaN) &&
    std::all_of(this->Entries.begin(), this->Entries.end(), opaque);
}
}
