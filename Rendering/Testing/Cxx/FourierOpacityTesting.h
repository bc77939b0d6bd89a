// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What tests of opacity optimization share: stacks of upright squares in a window, and in double
 * precision what importance and blending must make of them. Nothing here uses the shaders'
 * recurrences: series are summed term by term from their definition, and a fragment is left out of
 * the sum of the others where the shaders subtract it.
 */

#ifndef FourierOpacityTesting_h
#define FourierOpacityTesting_h

#include "FragmentListTesting.h"

#include "vtkFourierOpacityMapper.h"
#include "vtkMath.h"
#include "vtkOpacityOptimization.h"

#include <functional>

namespace FourierOpacityTesting
{
using namespace FragmentListTesting;
using Optimization = vtkOpacityOptimization;

/// Kinds of series, as glsl/vtkFourierOpacity.glsl numbers them.
enum Series
{
  Cosines = 0,
  SinesAndCosines = 1,
  EqualBins = 2
};

/// Random numbers that are the same in every run and on every machine.
class Random
{
public:
  explicit Random(int seed) { this->Sequence->SetSeed(seed); }
  double operator()(double low, double high)
  {
    this->Sequence->Next();
    return this->Sequence->GetRangeValue(low, high);
  }

private:
  vtkNew<vtkMinimalStandardRandomSequence> Sequence;
};

/// What a value of 1 at depth e adds to the sum up to depth d, of a series of so many sums.
inline double GetResponse(Series series, int sums, double d, double e)
{
  const double pi = vtkMath::Pi();
  double response = d;
  switch (series)
  {
    case Cosines:
      for (int k = 1; k < sums; ++k)
      {
        response += 2.0 / (pi * k) * std::sin(pi * k * d) * std::cos(pi * k * e);
      }
      return response;
    case SinesAndCosines:
      // Eq. 5 with the coefficients of Eq. 8 of a single value.
      for (int k = 1; k <= (sums - 1) / 2; ++k)
      {
        const double a = 2.0 * std::cos(2.0 * pi * k * e);
        const double b = 2.0 * std::sin(2.0 * pi * k * e);
        response += a / (2.0 * pi * k) * std::sin(2.0 * pi * k * d) +
          b / (2.0 * pi * k) * (1.0 - std::cos(2.0 * pi * k * d));
      }
      return response;
    default:
    {
      const double bin = std::min(std::floor(e * sums), sums - 1.0);
      return std::min(std::max(d * sums - bin, 0.0), 1.0);
    }
  }
}

/// Values at depths in [0,1].
struct Values
{
  std::vector<double> Depths;
  std::vector<double> Sizes;

  std::size_t GetCount() const { return this->Depths.size(); }
  double GetTotal() const { return std::accumulate(this->Sizes.begin(), this->Sizes.end(), 0.0); }
  /// Sum up to a depth by a series, but for one of the values.
  double GetSum(Series series, int sums, double depth, std::size_t leftOut) const
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < this->GetCount(); ++j)
    {
      sum +=
        j == leftOut ? 0.0 : this->Sizes[j] * GetResponse(series, sums, depth, this->Depths[j]);
    }
    return sum;
  }
  /// What the others in front of a value sum up to: exactly, and by a series, which is clamped to
  /// what the others have in all.
  double GetExactFront(std::size_t i) const
  {
    double sum = 0.0;
    for (std::size_t j = 0; j < this->GetCount(); ++j)
    {
      sum += this->Depths[j] < this->Depths[i] ? this->Sizes[j] : 0.0;
    }
    return sum;
  }
  double GetSeriesFront(Series series, int sums, std::size_t i) const
  {
    const double others = std::max(this->GetTotal() - this->Sizes[i], 0.0);
    return std::min(std::max(this->GetSum(series, sums, this->Depths[i], i), 0.0), others);
  }
};

/// Eq. 2, from the squared importance of the others in front and behind.
inline double GetOptimalOpacity(double g, double front, double behind, Optimization* weights)
{
  const double fade = std::pow(1.0 - g, 2.0 * weights->GetEmphasis());
  const double p = weights->GetRegularizationWeight();
  return p /
    (p + fade * (weights->GetBackgroundWeight() * front + weights->GetForegroundWeight() * behind));
}

/// Depth of a square between -0.9 and 0.9, from the viewer.
inline double GetDepth(const Square& square)
{
  return (0.9 - square.Z) / 1.8;
}

inline double GetZ(double depth)
{
  return 0.9 - 1.8 * depth;
}

inline double GetOpticalDepth(double opacity)
{
  return -std::log(1.0 - std::min(opacity, 0.9999));
}

/// What of the optimization changes how a stack is blended.
struct Blending
{
  int Method = Optimization::Fourier;
  int Bands = 5;
  bool Tight = true;
  double OpaqueThreshold = 0.98;

  void Set(Optimization* optimization) const
  {
    optimization->SetBlending(this->Method);
    optimization->SetNumberOfBands(this->Bands);
    optimization->SetTightDepth(this->Tight);
    optimization->SetOpaqueThreshold(this->OpaqueThreshold);
  }
};

constexpr const char* MethodNames[] = { "Fourier", "Fourier of the paper", "bins",
  "weighted average", "weighted blended", "lists" };

template <typename Color>
Point ToPoint(const Color& color)
{
  return { static_cast<double>(color[0]), static_cast<double>(color[1]),
    static_cast<double>(color[2]) };
}

/// A stack, in any order, as a method blends it over a colour, in units of a byte.
inline Point BlendBy(
  const Blending& by, std::vector<Square> squares, const std::array<int, 3>& background)
{
  if (by.Method == Optimization::FragmentLists)
  {
    return Blend(squares, background);
  }
  Point behind = ToPoint(background);
  std::stable_sort(
    squares.begin(), squares.end(), [](const Square& a, const Square& b) { return a.Z > b.Z; });
  if (by.Method == Optimization::Fourier && by.OpaqueThreshold <= 0.9999)
  {
    const auto isOpaque = [&](const Square& square)
    { return square.Color[3] / 255.0 >= by.OpaqueThreshold; };
    const auto first = std::find_if(squares.begin(), squares.end(), isOpaque);
    if (first != squares.end())
    {
      // Of several at one depth, the last one drawn.
      const double z = first->Z;
      for (const Square& square : squares)
      {
        if (square.Z == z && isOpaque(square))
        {
          behind = ToPoint(square.Color);
        }
      }
      const auto isHidden = [&](const Square& square) { return square.Z < z || isOpaque(square); };
      squares.erase(std::remove_if(squares.begin(), squares.end(), isHidden), squares.end());
    }
  }
  // What has no opacity is not drawn, and does not count.
  const auto isNothing = [](const Square& square) { return square.Color[3] == 0; };
  squares.erase(std::remove_if(squares.begin(), squares.end(), isNothing), squares.end());

  Values depths;
  double through = 1.0;
  double meanOpacity = 0.0;
  for (const Square& square : squares)
  {
    const double opacity = std::min(square.Color[3] / 255.0, 0.9999);
    depths.Depths.push_back(GetDepth(square));
    depths.Sizes.push_back(GetOpticalDepth(opacity));
    through *= 1.0 - opacity;
    meanOpacity += opacity / static_cast<double>(squares.size());
  }
  if (by.Method == Optimization::WeightedAverage)
  {
    through = std::pow(1.0 - meanOpacity, static_cast<double>(squares.size()));
  }
  if (by.Method == Optimization::Fourier && by.Tight && !squares.empty())
  {
    const double low = depths.Depths.front();
    const double size = depths.Depths.back() - low;
    for (double& depth : depths.Depths)
    {
      depth = size > 0.0 ? (depth - low) / size : 0.5;
    }
  }

  const int sums = 2 * by.Bands + 1;
  Point sum{ 0.0, 0.0, 0.0 };
  double weights = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const double opacity = std::min(squares[i].Color[3] / 255.0, 0.9999);
    const double d = depths.Depths[i];
    double weight = opacity;
    switch (by.Method)
    {
      case Optimization::Fourier:
        weight *= std::exp(-depths.GetSeriesFront(Cosines, sums, i));
        break;
      case Optimization::PaperFourier:
      {
        const double here = depths.GetSum(SinesAndCosines, sums, d, static_cast<std::size_t>(-1));
        weight *= std::exp(-std::min(std::max(here, 0.0), depths.GetTotal())) / (1.0 - opacity);
        break;
      }
      case Optimization::Bins:
        weight *= std::exp(-depths.GetSeriesFront(EqualBins, sums, i));
        break;
      case Optimization::WeightedBlended:
        // McGuire and Bavoil, 2013: colours are multiplied by opacity before they are weighted, and
        // the weight of Eq. 10 has it once more.
        weight *= opacity * std::max(1e-2, 3e3 * std::pow(1.0 - d, 3.0));
        break;
      default:
        break;
    }
    for (int k = 0; k < 3; ++k)
    {
      sum[k] += weight * squares[i].Color[k];
    }
    weights += weight;
  }
  Point color;
  for (int k = 0; k < 3; ++k)
  {
    color[k] = (weights > 0.0 ? sum[k] / weights * (1.0 - through) : 0.0) +
      (weights > 0.0 ? through : 1.0) * behind[k];
  }
  return color;
}

/// Squares as one input, in some order, with a cell array "Importance" (0 where there is no value).
inline vtkSmartPointer<vtkPolyData> MakeStack(const std::vector<Square>& squares,
  const std::vector<double>& importance = {}, const std::vector<int>& order = {})
{
  const std::vector<int> cells = order.empty() ? MakeOrder(squares.size()) : order;
  auto data = MakePolyData(squares, cells);
  vtkNew<vtkFloatArray> array;
  array->SetName("Importance");
  for (int i : cells)
  {
    array->InsertNextValue(importance.empty() ? 0.0f : static_cast<float>(importance[i]));
  }
  data->GetCellData()->AddArray(array);
  return data;
}

/// Two specks outside of the view that make the scene reach from -0.9 to 0.9.
inline void AddEnds(std::vector<Square>& squares)
{
  for (double z : { 0.9, -0.9 })
  {
    squares.push_back({ 4.0, 0.0, z, 0.01, { 255, 255, 255, 255 } });
  }
}

/// An off-screen window that looks along -z at what lies between -1 and 1.
struct OpacityStage : Stage
{
  vtkNew<vtkFourierOpacityMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;

  explicit OpacityStage(int width = 32, int height = 32)
    : Stage(width, height)
  {
    LookAlongZ(*this);
    this->Mapper->SetImportanceArrayName("Importance");
    this->Mapper->SetImportanceRange(0.0, 1.0);
    this->Actor = this->Add(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
  }

  Optimization* GetOptimization() { return this->Mapper->GetOptimization(); }

  Picture Render(vtkPolyData* data)
  {
    this->Mapper->SetInputData(data);
    return Stage::Render();
  }
};

inline std::string Describe(const Point& color)
{
  std::ostringstream text;
  text << " (" << color[0] << " " << color[1] << " " << color[2] << ")";
  return text.str();
}

/// Check a colour against an expected one.
inline void CheckColor(Checks& check, const std::string& name, const std::array<int, 3>& color,
  const Point& expected, double tolerance)
{
  check(IsExact(color, expected, tolerance),
    name + ": " + VoxelLineMapperTesting::Describe(color) + " instead of" + Describe(expected));
}
}

#endif
