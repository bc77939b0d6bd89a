// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLineIlluminationTable.h"

#include "vtkLineIllumination.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

namespace
{
// 2 / (2 + m) of the largest m.
constexpr double LastRow = 2.0 / (2.0 + vtkLineIllumination::LargestSpecularPower);
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkLineIlluminationTable> vtkLineIlluminationTable::Get(double tolerance)
{
  static std::mutex mutex;
  static std::map<double, std::weak_ptr<const vtkLineIlluminationTable>> tables;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const vtkLineIlluminationTable> table = tables[tolerance].lock();
  int columns = 3;
  int rows = 3;
  while (!table)
  {
    std::shared_ptr<vtkLineIlluminationTable> candidate(
      new vtkLineIlluminationTable(columns, rows));
    double alongColumns;
    double alongRows;
    double inCells;
    candidate->Measure(alongColumns, alongRows, inCells);
    candidate->LargestError = std::max({ alongColumns, alongRows, inCells });
    if (candidate->LargestError <= tolerance)
    {
      table = candidate;
      tables[tolerance] = table;
    }
    else if (alongColumns > alongRows)
    {
      columns += (columns + 3) / 4;
    }
    else
    {
      rows += (rows + 3) / 4;
    }
  }
  return table;
}

//------------------------------------------------------------------------------
vtkLineIlluminationTable::vtkLineIlluminationTable(int columns, int rows)
  : Columns(columns)
  , Rows(rows)
  , Values(static_cast<std::size_t>(columns) * rows)
{
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      this->Values[static_cast<std::size_t>(j) * columns + i] = static_cast<float>(
        vtkLineIlluminationTable::Evaluate(i / (columns - 1.0), j / (rows - 1.0)));
    }
  }
}

//------------------------------------------------------------------------------
double vtkLineIlluminationTable::Evaluate(double x, double row)
{
  const double m = std::max(0.0, 2.0 / (LastRow + row * (1.0 - LastRow)) - 2.0);
  const double w = x / std::sqrt(1.0 + m * m / (10.0 * m + 100.0));
  return w > 0.0 ? vtkLineIllumination::GetPowerIntegral(m, std::min(w, 1.0)) / w : 1.0;
}

//------------------------------------------------------------------------------
void vtkLineIlluminationTable::Measure(
  double& alongColumns, double& alongRows, double& inCells) const
{
  alongColumns = 0.0;
  alongRows = 0.0;
  inCells = 0.0;
  const auto error = [this](double x, double row)
  { return std::abs(this->Interpolate(x, row) - vtkLineIlluminationTable::Evaluate(x, row)); };
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      const double x = i / (this->Columns - 1.0);
      const double row = j / (this->Rows - 1.0);
      const double nextX = std::min(1.0, x + 0.5 / (this->Columns - 1.0));
      const double nextRow = std::min(1.0, row + 0.5 / (this->Rows - 1.0));
      alongColumns = std::max(alongColumns, error(nextX, row));
      alongRows = std::max(alongRows, error(x, nextRow));
      inCells = std::max(inCells, error(nextX, nextRow));
    }
  }
}
