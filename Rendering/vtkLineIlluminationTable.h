// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineIlluminationTable
 * @brief   table of the mean E_m(w) of a power of the sine, by which highlights of lines are
 * averaged
 *
 * One table of two dimensions serves every exponent, Phong's and Blinn's reflection. Its axes are
 * chosen so that E_m is smooth in both: rows by 2 / (2 + m), from m = 1000 to m = 0, and columns
 * by x = w sqrt(s) with s = 1 + m^2 / (10 m + 100), from 0 to 1; beyond, E_m falls as 1 / w. So its
 * size does not grow with the exponent. It follows from the largest error that is allowed with
 * linear interpolation, by measuring the error in the middle of cells and edges.
 */

#ifndef vtkLineIlluminationTable_h
#define vtkLineIlluminationTable_h

#include "vtkRenderingLineSetsModule.h" // For export macro

#include <memory>
#include <vector>

class VTKRENDERINGLINESETS_EXPORT vtkLineIlluminationTable
{
public:
  /// The smallest table of a tolerance. Those who ask for the same tolerance share one.
  static std::shared_ptr<const vtkLineIlluminationTable> Get(double tolerance);

  int GetColumns() const { return this->Columns; }
  int GetRows() const { return this->Rows; }
  const std::vector<float>& GetValues() const { return this->Values; }

  /// Largest error that was measured between the values.
  double GetLargestError() const { return this->LargestError; }

  /// The table at x and row, both from 0 to 1, with linear interpolation.
  template <typename Real>
  Real Interpolate(Real x, Real row) const
  {
    const Real u = Clamp(x) * static_cast<Real>(this->Columns - 1);
    const Real v = Clamp(row) * static_cast<Real>(this->Rows - 1);
    const int i = static_cast<int>(u) < this->Columns - 2 ? static_cast<int>(u) : this->Columns - 2;
    const int j = static_cast<int>(v) < this->Rows - 2 ? static_cast<int>(v) : this->Rows - 2;
    const Real s = u - static_cast<Real>(i);
    const Real t = v - static_cast<Real>(j);
    const float* low = this->Values.data() + static_cast<std::size_t>(j) * this->Columns + i;
    const float* high = low + this->Columns;
    return (Real(1) - t) * ((Real(1) - s) * low[0] + s * low[1]) +
      t * ((Real(1) - s) * high[0] + s * high[1]);
  }

  /// E_m at x and row, in double precision.
  static double Evaluate(double x, double row);

private:
  vtkLineIlluminationTable(int columns, int rows);

  template <typename Real>
  static Real Clamp(Real x)
  {
    return x > Real(0) ? (x < Real(1) ? x : Real(1)) : Real(0); // NaN becomes 0
  }
  /// Largest error in the middle of edges along columns and along rows, and of cells.
  void Measure(double& alongColumns, double& alongRows, double& inCells) const;

  int Columns;
  int Rows;
  std::vector<float> Values;
  double LargestError = 0.0;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineIlluminationTable.h
