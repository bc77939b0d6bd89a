// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeriodicGrid.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace linesets
{
//------------------------------------------------------------------------------
void Interpolate(const std::vector<std::array<float, 3>>& values, const std::size_t corners[3][2],
  const double weights[3], double result[3])
{
  std::fill_n(result, 3, 0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const int upper[3] = { corner & 1, (corner >> 1) & 1, corner >> 2 };
    double weight = 1.0;
    std::size_t index = 0;
    for (int i = 0; i < 3; ++i)
    {
      weight *= upper[i] ? weights[i] : 1.0 - weights[i];
      index += corners[i][upper[i]];
    }
    for (int i = 0; i < 3; ++i)
    {
      result[i] += weight * values[index][i];
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::complex<float>> GetUnitRoots(int size)
{
  std::vector<std::complex<float>> roots(size);
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / size;
    roots[i] = { static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)) };
  }
  return roots;
}

//------------------------------------------------------------------------------
void PeriodicGrid::Evaluate(const double point[3], double vector[3]) const
{
  std::size_t corners[3][2];
  double weights[3];
  std::size_t stride = 1;
  for (int i = 0; i < 3; ++i)
  {
    const double position = point[i] * this->Size;
    const int cell = static_cast<int>(position);
    weights[i] = position - cell;
    corners[i][0] = (cell % this->Size) * stride;
    corners[i][1] = ((cell + 1) % this->Size) * stride;
    stride *= this->Size;
  }
  Interpolate(this->Vectors, corners, weights, vector);
}
}
