// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// The synthesis of TurbulenceField. A shell of wave numbers k gets a few random integer wave
// vectors and the energy k^(-5/3), shared among them; each mode a exp(i 2 pi k.x) has a random
// complex amplitude perpendicular to k, so that the divergence of the sum is 0. Since the vectors
// are integer, exp(i 2 pi k.x) on the grid is a product of three tabulated numbers.
#include "SceneFields.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace linesets
{
namespace
{
using Complex = std::complex<float>;

constexpr int LargestWaveNumber = 24;
constexpr int ModesPerShell = 12;

struct Mode
{
  int Number[3];
  float Real[3]; // amplitude, real and imaginary part
  float Imaginary[3];
};

// A uniform direction by rejection from the cube.
void GetDirection(Random& random, double direction[3])
{
  double length2;
  do
  {
    for (int i = 0; i < 3; ++i)
    {
      direction[i] = random.Uniform(-1.0, 1.0);
    }
    length2 = vtkMath::Dot(direction, direction);
  } while (length2 > 1.0 || length2 < 1e-4);
  vtkMath::Normalize(direction);
}

void SetAmplitude(Random& random, const double along[3], double size, float amplitude[3])
{
  double direction[3];
  double across[3];
  do
  {
    GetDirection(random, direction);
    vtkMath::Cross(direction, along, across);
  } while (vtkMath::Norm(across) < 0.1);
  vtkMath::Normalize(across);
  for (int i = 0; i < 3; ++i)
  {
    amplitude[i] = static_cast<float>(size * across[i]);
  }
}

std::vector<Mode> MakeModes(std::uint64_t seed)
{
  Random random(seed);
  std::vector<Mode> modes;
  for (int shell = 1; shell <= LargestWaveNumber; ++shell)
  {
    const double size = std::sqrt(std::pow(shell, -5.0 / 3.0) / ModesPerShell);
    for (int i = 0; i < ModesPerShell; ++i)
    {
      Mode mode;
      double number[3];
      do
      {
        GetDirection(random, number);
        for (int axis = 0; axis < 3; ++axis)
        {
          number[axis] = std::floor(shell * number[axis] + 0.5);
          mode.Number[axis] = static_cast<int>(number[axis]);
        }
      } while (vtkMath::Norm(number) == 0.0);
      vtkMath::Normalize(number);
      SetAmplitude(random, number, size, mode.Real);
      SetAmplitude(random, number, size, mode.Imaginary);
      modes.push_back(mode);
    }
  }
  return modes;
}
}

//------------------------------------------------------------------------------
TurbulenceField::TurbulenceField(std::uint64_t seed)
  : Grid(Size)
{
  const std::vector<Mode> modes = MakeModes(seed);
  // roots[k * x mod Size] = exp(i 2 pi k x / Size)
  const std::vector<Complex> roots = GetUnitRoots(Size);
  const auto power = [&roots](int number, int position)
  { return roots[((number * position) % Size + Size) % Size]; };
  vtkSMPTools::For(0, Size, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> rows[3];
      for (int z = static_cast<int>(begin); z < end; ++z)
      {
        for (int y = 0; y < Size; ++y)
        {
          for (std::vector<float>& row : rows)
          {
            row.assign(Size, 0.0f);
          }
          for (const Mode& mode : modes)
          {
            const Complex phase = power(mode.Number[1], y) * power(mode.Number[2], z);
            float real[Size];
            float imaginary[Size];
            for (int x = 0; x < Size; ++x)
            {
              const Complex root = power(mode.Number[0], x);
              real[x] = root.real() * phase.real() - root.imag() * phase.imag();
              imaginary[x] = root.real() * phase.imag() + root.imag() * phase.real();
            }
            for (int i = 0; i < 3; ++i)
            {
              for (int x = 0; x < Size; ++x)
              {
                rows[i][x] += mode.Real[i] * real[x] - mode.Imaginary[i] * imaginary[x];
              }
            }
          }
          std::array<float, 3>* out = this->Grid.GetSlice(z) + y * Size;
          for (int x = 0; x < Size; ++x)
          {
            out[x] = { { rows[0][x], rows[1][x], rows[2][x] } };
          }
        }
      }
    });
}
}
