// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vectors on a grid that fills the unit cube and goes on periodically.
 */

#ifndef PeriodicGrid_h
#define PeriodicGrid_h

#include <array>   // For vectors
#include <complex> // For roots
#include <cstddef> // For sizes
#include <vector>  // For the vectors

namespace linesets
{
class PeriodicGrid
{
public:
  /// A cube of size^3 zero vectors.
  explicit PeriodicGrid(int size)
    : Size(size)
    , Vectors(static_cast<std::size_t>(size) * size * size, std::array<float, 3>{})
  {
  }

  /// The size * size vectors at height z, x fastest.
  std::array<float, 3>* GetSlice(int z)
  {
    return &this->Vectors[static_cast<std::size_t>(z) * this->Size * this->Size];
  }

  /// Linear interpolation; no coordinate may be negative.
  void Evaluate(const double point[3], double vector[3]) const;

private:
  int Size;
  std::vector<std::array<float, 3>> Vectors;
};

/// exp(i 2 pi k / size) for k from 0 to size - 1.
std::vector<std::complex<float>> GetUnitRoots(int size);

/// Linear interpolation in the cell whose eight corners are given by their indices along the axes.
void Interpolate(const std::vector<std::array<float, 3>>& values, const std::size_t corners[3][2],
  const double weights[3], double result[3]);
}

#endif
