// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause

// The displacement field is a sum of all Fourier modes with integer wave vectors up to a wave
// number, with Gaussian amplitudes, sampled on a periodic grid. Where the density contrast of the
// linear theory has the amplitude d_k, the displacement has i k / k^2 d_k. The sum over three axes
// is taken one axis after the other: 41 terms for each of three partial sums in place of 41^3.
// Density is that of the points in the cells of a grid, shared among the eight nearest cells.
#include "PointScene.h"

#include "PeriodicGrid.h"
#include "Random.h"
#include "SceneImportance.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace linesets
{
namespace
{
using Complex = std::complex<float>;

constexpr std::uint64_t Seed = 1970;
constexpr int Size = 128;             // of the grid of displacements
constexpr int LargestWaveNumber = 20; // 6.4 cells of the grid
constexpr int Numbers = 2 * LargestWaveNumber + 1;
constexpr double SmoothWaveNumber = 11.0; // where the spectrum falls off
constexpr double SpectralIndex = -1.6;
constexpr double Contrast = 1.2; // standard deviation of the density in linear theory

// Amplitudes d_k of density for wave vectors (x, y, z) from -LargestWaveNumber on, x fastest. Since
// only the real part of the sum counts, z < 0 is left out.
std::vector<std::complex<double>> MakeAmplitudes()
{
  Random random(Seed);
  std::vector<std::complex<double>> amplitudes;
  double sum = 0.0;
  for (int z = 0; z <= LargestWaveNumber; ++z)
  {
    for (int y = -LargestWaveNumber; y <= LargestWaveNumber; ++y)
    {
      for (int x = -LargestWaveNumber; x <= LargestWaveNumber; ++x)
      {
        const double k = std::sqrt(static_cast<double>(x * x + y * y + z * z));
        double size = 0.0;
        if (k > 0.0 && k <= LargestWaveNumber)
        {
          const double fall = k / SmoothWaveNumber;
          size = std::sqrt(std::pow(k, SpectralIndex) * std::exp(-fall * fall));
        }
        // A complex normal number: its length by Rayleigh's distribution, and its phase.
        const double length = size * std::sqrt(-2.0 * std::log(1.0 - random.Uniform()));
        amplitudes.push_back(std::polar(length, random.Uniform(0.0, 2.0 * vtkMath::Pi())));
        sum += 0.5 * length * length;
      }
    }
  }
  for (std::complex<double>& amplitude : amplitudes)
  {
    amplitude *= Contrast / std::sqrt(sum);
  }
  return amplitudes;
}

// Sums of `terms` terms along the slowest axis of planes of `width` values: out[p] is the sum of
// in[k] exp(i 2 pi (first + k) p / Size).
void SumAlongAxis(const Complex* in, int terms, int first, std::size_t width,
  const std::vector<Complex>& roots, Complex* out)
{
  std::fill_n(out, Size * width, Complex(0.0f, 0.0f));
  for (int position = 0; position < Size; ++position)
  {
    Complex* sum = out + position * width;
    for (int k = 0; k < terms; ++k)
    {
      const Complex root = roots[(((first + k) * position) % Size + Size) % Size];
      const Complex* term = in + k * width;
      for (std::size_t i = 0; i < width; ++i)
      {
        // Written out, since operator* also cares for infinite values, which takes longer.
        sum[i] += Complex(root.real() * term[i].real() - root.imag() * term[i].imag(),
          root.real() * term[i].imag() + root.imag() * term[i].real());
      }
    }
  }
}

// One component of the displacement.
void SumModes(const std::vector<std::complex<double>>& amplitudes, int axis,
  const std::vector<Complex>& roots, PeriodicGrid& grid)
{
  constexpr int planes = LargestWaveNumber + 1;
  constexpr std::size_t planeSize = static_cast<std::size_t>(Size) * Size;
  // Sums over x and y for each z of the wave vectors.
  std::vector<Complex> sums(planes * planeSize);
  vtkSMPTools::For(0, planes, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Complex> terms(Numbers * Numbers); // y fastest
      std::vector<Complex> rows(Size * Numbers);     // by x, then y of the wave vectors
      std::vector<Complex> columns(Numbers * Size);  // the other way round
      for (int z = static_cast<int>(begin); z < end; ++z)
      {
        for (int y = 0; y < Numbers; ++y)
        {
          for (int x = 0; x < Numbers; ++x)
          {
            const int wave[3] = { x - LargestWaveNumber, y - LargestWaveNumber, z };
            const int square = wave[0] * wave[0] + wave[1] * wave[1] + wave[2] * wave[2];
            // The period is 2 pi for waves of number 1, and 1 for the cube.
            const double factor = square > 0 ? wave[axis] / (2.0 * vtkMath::Pi() * square) : 0.0;
            terms[x * Numbers + y] = Complex(std::complex<double>(0.0, factor) *
              amplitudes[(static_cast<std::size_t>(z) * Numbers + y) * Numbers + x]);
          }
        }
        SumAlongAxis(terms.data(), Numbers, -LargestWaveNumber, Numbers, roots, rows.data());
        for (int x = 0; x < Size; ++x)
        {
          for (int y = 0; y < Numbers; ++y)
          {
            columns[static_cast<std::size_t>(y) * Size + x] = rows[x * Numbers + y];
          }
        }
        SumAlongAxis(
          columns.data(), Numbers, -LargestWaveNumber, Size, roots, &sums[z * planeSize]);
      }
    });
  vtkSMPTools::For(0, Size, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int z = static_cast<int>(begin); z < end; ++z)
      {
        std::array<float, 3>* out = grid.GetSlice(z);
        for (std::size_t i = 0; i < planeSize; ++i)
        {
          out[i][axis] = 0.0f;
        }
        for (int k = 0; k < planes; ++k)
        {
          const Complex root = roots[(k * z) % Size];
          const Complex* term = &sums[k * planeSize];
          for (std::size_t i = 0; i < planeSize; ++i)
          {
            out[i][axis] += root.real() * term[i].real() - root.imag() * term[i].imag();
          }
        }
      }
    });
}

PeriodicGrid MakeDisplacements()
{
  const std::vector<std::complex<double>> amplitudes = MakeAmplitudes();
  const std::vector<Complex> roots = GetUnitRoots(Size);
  PeriodicGrid grid(Size);
  for (int axis = 0; axis < 3; ++axis)
  {
    SumModes(amplitudes, axis, roots, grid);
  }
  return grid;
}

// Number of points per cell of a periodic grid, shared among the eight nearest cells by their
// distance along the axes.
class DensityGrid
{
public:
  explicit DensityGrid(vtkFloatArray* points)
    : CellsPerSide(static_cast<int>(std::min(
        128.0, std::max(4.0, std::cbrt(0.5 * static_cast<double>(points->GetNumberOfTuples()))))))
    , Counts(static_cast<std::size_t>(CellsPerSide) * CellsPerSide * CellsPerSide, 0.0f)
  {
    // One after the other, so that sums do not depend on threads.
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
    {
      const float* point = points->GetPointer(3 * i);
      this->ForCorners({ { point[0], point[1], point[2] } },
        [this](std::size_t cell, float weight) { this->Counts[cell] += weight; });
    }
  }

  /// Interpolated linearly. More than 0 for a point that was counted.
  double Get(const double point[3]) const
  {
    float sum = 0.0f;
    this->ForCorners({ { static_cast<float>(point[0]), static_cast<float>(point[1]),
                       static_cast<float>(point[2]) } },
      [this, &sum](std::size_t cell, float weight) { sum += weight * this->Counts[cell]; });
    return sum;
  }

private:
  template <typename Functor>
  void ForCorners(const std::array<float, 3>& point, Functor&& functor) const
  {
    std::size_t corners[3][2];
    float weights[3][2];
    std::size_t stride = 1;
    for (int i = 0; i < 3; ++i)
    {
      const float position = point[i] * static_cast<float>(this->CellsPerSide);
      const int cell = static_cast<int>(position);
      weights[i][1] = position - static_cast<float>(cell);
      weights[i][0] = 1.0f - weights[i][1];
      corners[i][0] = (cell % this->CellsPerSide) * stride;
      corners[i][1] = ((cell + 1) % this->CellsPerSide) * stride;
      stride *= this->CellsPerSide;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      const int x = corner & 1;
      const int y = (corner >> 1) & 1;
      const int z = corner >> 2;
      functor(corners[0][x] + corners[1][y] + corners[2][z],
        weights[0][x] * weights[1][y] * weights[2][z]);
    }
  }

  const int CellsPerSide;
  std::vector<float> Counts;
};

vtkSmartPointer<vtkCellArray> MakeVertexCells(vtkIdType count)
{
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> ids;
  offsets->SetNumberOfValues(count + 1);
  ids->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetValue(i, i);
    ids->SetValue(i, i);
  }
  offsets->SetValue(count, count);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

// The displaced points and how far each went.
void MovePoints(const PeriodicGrid& displacements, vtkFloatArray* points, vtkFloatArray* speeds)
{
  vtkSMPTools::For(0, points->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Random random(Seed + 1, static_cast<std::uint64_t>(i));
        double point[3];
        for (double& x : point)
        {
          x = random.Uniform();
        }
        double way[3];
        displacements.Evaluate(point, way);
        for (int axis = 0; axis < 3; ++axis)
        {
          double x = point[axis] + way[axis];
          x -= std::floor(x);
          points->SetTypedComponent(i, axis, static_cast<float>(x));
        }
        speeds->SetValue(i, static_cast<float>(vtkMath::Norm(way)));
      }
    });
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePointScene(vtkIdType count)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> speeds;
  speeds->SetName("speed");
  speeds->SetNumberOfTuples(count);
  MovePoints(MakeDisplacements(), coordinates, speeds);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetVerts(MakeVertexCells(count));
  result->GetPointData()->SetScalars(speeds);
  const DensityGrid densities(coordinates);
  AddImportance(result,
    [&densities](vtkIdType, const double point[3]) { return std::log(densities.Get(point)); });
  return result;
}
}
