// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Guards the shader functions of opacity optimization, compiled as C++ in single and double
// precision: the three kinds of series against sums term by term, the share that a fragment has in
// its own sum, totals, limits and convergence, the optimal opacity; and that weights without that
// share make less than half of the error of the paper's weights.

#include "FourierOpacityTesting.h"

#include <glm/glm.hpp>

#include <limits>

using namespace FourierOpacityTesting;

namespace ShaderTesting
{
using namespace glm;

#define LS_OUT(T) T&

// The functions with the sums of one pixel.
template <typename R, int Kind, int Count>
struct Pixel
{
  using Real = R;
  using vec4 = glm::vec<4, R>;
  static constexpr int FourierSeries = Kind;
  static constexpr int FourierCount = Count;

  R Coefficients[Count] = {};
  R fourierCoefficient(int i) const { return this->Coefficients[i]; }

#include "glsl/vtkFourierOpacity.glsl"

  void Add(R depth, R value)
  {
    const FourierTerms terms = this->fourierTerms(depth);
    for (int i = 0; i < Count; ++i)
    {
      this->Coefficients[i] += value * terms.value[i];
    }
  }

  explicit Pixel(const Values& values = {})
  {
    for (std::size_t i = 0; i < values.GetCount(); ++i)
    {
      this->Add(static_cast<R>(values.Depths[i]), static_cast<R>(values.Sizes[i]));
    }
  }

  R GetFront(R depth, R value)
  {
    R share;
    const R sum = this->fourierSum(depth, share);
    return this->fourierFront(sum, share, value, this->fourierTotal());
  }
};

#undef LS_OUT
}

namespace
{
using ShaderTesting::Pixel;

constexpr const char* SeriesNames[] = { "cosines", "sines and cosines", "bins" };

Values MakeValues(Random& random, int count, double low, double high)
{
  Values values;
  for (int i = 0; i < count; ++i)
  {
    // Numbers that single precision holds.
    values.Depths.push_back(static_cast<float>(random(0.0, 1.0)));
    values.Sizes.push_back(static_cast<float>(random(low, high)));
  }
  return values;
}

template <typename R, int Kind, int Count>
void CheckSeries(Checks& check)
{
  const std::string name = std::string(SeriesNames[Kind]) + ", " + std::to_string(Count) +
    " sums, " + std::to_string(8 * sizeof(R)) + " bits";
  const double eps = sizeof(R) == 4 ? 3e-6 : 1e-13;
  const Series series = static_cast<Series>(Kind);
  Random random(11);
  for (int round = 0; round < 20; ++round)
  {
    const Values values = MakeValues(random, 20, 0.0, 3.0);
    Pixel<R, Kind, Count> pixel(values);
    const double total = values.GetTotal();
    check(std::abs(pixel.fourierTotal() - total) < eps * total, name + ": total");
    R share;
    check(std::abs(pixel.fourierSum(R(0), share)) < eps * total, name + ": sum up to 0");
    check(std::abs(pixel.fourierSum(R(1), share) - total) < eps * total, name + ": sum up to 1");
    for (int i = 0; i < 20; ++i)
    {
      const double d = static_cast<float>(random(0.0, 1.0));
      const double expected = values.GetSum(series, Count, d, static_cast<std::size_t>(-1));
      const double sum = pixel.fourierSum(static_cast<R>(d), share);
      check(std::abs(sum - expected) < eps * total,
        name + ": sum " + std::to_string(sum) + " instead of " + std::to_string(expected));
      check(std::abs(share - GetResponse(series, Count, d, d)) < 10.0 * eps, name + ": own share");
    }
    for (std::size_t i = 0; i < values.GetCount(); ++i)
    {
      const double front =
        pixel.GetFront(static_cast<R>(values.Depths[i]), static_cast<R>(values.Sizes[i]));
      const double others = total - values.Sizes[i];
      check(front >= 0.0 && front <= others * (1.0 + eps), name + ": front sum within limits");
      check(std::abs(front - values.GetSeriesFront(series, Count, i)) < 4.0 * eps * total,
        name + ": front sum");
    }

    // Another order of adding.
    Pixel<R, Kind, Count> other;
    for (int i : Shuffle(MakeOrder(values.GetCount()), round + 1))
    {
      other.Add(static_cast<R>(values.Depths[i]), static_cast<R>(values.Sizes[i]));
    }
    for (int i = 0; i < Count; ++i)
    {
      check(std::abs(other.Coefficients[i] - pixel.Coefficients[i]) < eps * total,
        name + ": order of adding");
    }
  }

  // A fragment alone has nothing in front of it, wherever it is; before clamping, up to rounding.
  for (int i = 0; i <= 1000; ++i)
  {
    const R d = static_cast<R>(i) / R(1000);
    for (R value : { R(1e-4), R(0.5), R(9.2) })
    {
      Pixel<R, Kind, Count> pixel;
      pixel.Add(d, value);
      R share;
      const R sum = pixel.fourierSum(d, share);
      check(std::abs(sum - share * value) <= R(4.0 * eps) * value,
        name + ": alone at " + std::to_string(d));
      check(pixel.GetFront(d, value) <= R(eps) * value, name + ": alone, clamped");
    }
  }
}

template <int Kind, int Count>
void CheckBothPrecisions(Checks& check)
{
  CheckSeries<float, Kind, Count>(check);
  CheckSeries<double, Kind, Count>(check);
}

// Mean error of the front sums of random layers, as a part of the total; and how many of the sums
// would have left their range.
template <int Kind, int Bands>
double GetMeanError(int* clamped = nullptr)
{
  constexpr int Count = 2 * Bands + 1;
  Random random(5);
  double error = 0.0;
  int samples = 0;
  for (int round = 0; round < 100; ++round)
  {
    const Values values = MakeValues(random, 10, 0.1, 3.0);
    Pixel<float, Kind, Count> pixel(values);
    const auto total = static_cast<float>(values.GetTotal());
    for (std::size_t i = 0; i < values.GetCount(); ++i)
    {
      const auto d = static_cast<float>(values.Depths[i]);
      const auto value = static_cast<float>(values.Sizes[i]);
      error += std::abs(pixel.GetFront(d, value) - values.GetExactFront(i)) / total;
      ++samples;
      float share;
      const float sum = pixel.fourierSum(d, share) - share * value;
      if (clamped && (sum < -1e-4f * total || sum > total - value + 1e-4f * total))
      {
        ++*clamped;
      }
    }
  }
  return error / samples;
}

template <int Kind>
void CheckConvergence(Checks& check)
{
  int clamped = 0;
  const double errors[] = { GetMeanError<Kind, 1>(), GetMeanError<Kind, 2>(),
    GetMeanError<Kind, 5>(&clamped), GetMeanError<Kind, 16>(), GetMeanError<Kind, 32>(),
    GetMeanError<Kind, 64>() };
  std::cout << SeriesNames[Kind] << ": mean error with 1, 2, 5, 16, 32, 64 bands:";
  for (double error : errors)
  {
    std::cout << " " << error;
  }
  std::cout << "; of 1000 sums with 5 bands, " << clamped << " are clamped\n";
  for (int i = 1; i < 6; ++i)
  {
    check(errors[i] < errors[i - 1], std::string(SeriesNames[Kind]) + ": more bands, less error");
  }
  check(errors[5] < 0.25 * errors[2] && errors[5] < 0.015,
    std::string(SeriesNames[Kind]) + ": 64 bands come near");
  check(Kind == EqualBins || clamped > 10, "sums that would leave their range are among them");
}

template <typename R>
void CheckOptimalOpacity(Checks& check)
{
  using V = glm::vec<4, R>;
  Pixel<R, 0, 3> f;
  vtkNew<Optimization> weights;
  Random random(3);
  const R eps = sizeof(R) == 4 ? R(2e-5) : R(1e-12);
  for (double lambda : { 0.01, 0.5, 2.0, 10.0, 100.0 })
  {
    weights->SetEmphasis(lambda);
    for (int i = 0; i < 200; ++i)
    {
      const R g = static_cast<R>(i % 10 == 0 ? 0.1 * (i / 20) : random(0.0, 1.0));
      const R front = static_cast<R>(i % 7 == 0 ? 0.0 : random(0.0, 100.0));
      const R behind = static_cast<R>(i % 5 == 0 ? 0.0 : random(0.0, 100.0));
      weights->SetRegularizationWeight(random(0.1, 10.0));
      weights->SetForegroundWeight(i % 3 == 0 ? 0.0 : random(0.0, 500.0));
      weights->SetBackgroundWeight(i % 4 == 0 ? 0.0 : random(0.0, 500.0));
      const V w(weights->GetRegularizationWeight(), weights->GetForegroundWeight(),
        weights->GetBackgroundWeight(), weights->GetEmphasis());
      const R opacity = f.optimalOpacity(g, front, behind, w);
      check(opacity >= R(0) && opacity <= R(1), "optimal opacity is in [0,1]");
      check(std::abs(opacity - GetOptimalOpacity(g, front, behind, weights)) < eps, "Eq. 2");
      check(f.optimalOpacity(g, front + R(1), behind, w) <= opacity &&
          f.optimalOpacity(g, front, behind + R(1), w) <= opacity,
        "more importance around, less opacity");
      check(f.optimalOpacity(glm::min(g + R(0.1), R(1)), front, behind, w) >= opacity,
        "more importance, more opacity");
      check(f.optimalOpacity(R(1), front, behind, w) == R(1), "importance 1 is opaque");
      check(f.optimalOpacity(g, front, behind, V(w.x, R(0), R(0), w.w)) == R(1), "q = r = 0");
      check(f.optimalOpacity(g, R(0), R(0), w) == R(1), "nothing important around");
    }
  }
  check(f.optimalOpacity(R(1.0001), R(1), R(1), V(R(1))) == R(1), "importance above 1");

  check(f.opticalDepth(R(0)) == R(0), "optical depth of 0");
  for (R opacity : { R(0.01), R(0.5), R(0.98), R(0.9999), R(1) })
  {
    check(std::abs(f.opticalDepth(opacity) - GetOpticalDepth(opacity)) < R(1e-3),
      "optical depth of " + std::to_string(opacity));
  }
  check(std::abs(f.colorWeight(R(0.5), R(1)) - R(0.5) * std::exp(R(-1))) < R(1e-6), "weight");
  check(f.colorWeight(R(0.001), R(1e4)) > R(0), "a weight does not vanish");
}

// Mean error of the colours of random stacks, each channel from 0 to 1. Of what is important, a
// part of the layers is nearly opaque; the rest has an opacity by chance.
struct Errors
{
  double Paper = 0.0;
  double Corrected = 0.0; ///< the paper's series without the own share
  double CosineSeries = 0.0;
};

Errors GetColorErrors(int layers, double part, double highest)
{
  constexpr int Count = 11;
  const int rounds = 400;
  Random random(17);
  Errors errors;
  for (int round = 0; round < rounds; ++round)
  {
    Values values;
    std::vector<double> alphas;
    std::vector<Point> colors;
    std::vector<double> depths;
    for (int i = 0; i < layers; ++i)
    {
      depths.push_back(random(0.0, 1.0));
    }
    std::sort(depths.begin(), depths.end());
    Point exact{ 0.0, 0.0, 0.0 };
    double through = 1.0;
    for (int i = 0; i < layers; ++i)
    {
      alphas.push_back(random(0.0, 1.0) < part ? 0.99 : random(0.01, highest));
      colors.push_back({ random(0.0, 1.0), random(0.0, 1.0), random(0.0, 1.0) });
      values.Depths.push_back(depths[i]);
      values.Sizes.push_back(-std::log(1.0 - alphas.back()));
      for (int k = 0; k < 3; ++k)
      {
        exact[k] += through * alphas[i] * colors[i][k];
      }
      through *= 1.0 - alphas[i];
    }
    Pixel<float, SinesAndCosines, Count> paper(values);
    Pixel<float, Cosines, Count> cosines(values);
    Point sums[3] = {};
    double weights[3] = {};
    for (int i = 0; i < layers; ++i)
    {
      const auto alpha = static_cast<float>(alphas[i]);
      const auto d = static_cast<float>(depths[i]);
      const auto value = static_cast<float>(values.Sizes[i]);
      float share;
      const float here = std::min(std::max(paper.fourierSum(d, share), 0.0f), paper.fourierTotal());
      const float weight[3] = { alpha / (1.0f - alpha) * std::exp(-here),
        paper.colorWeight(alpha, paper.GetFront(d, value)),
        cosines.colorWeight(alpha, cosines.GetFront(d, value)) };
      for (int method = 0; method < 3; ++method)
      {
        weights[method] += weight[method];
        for (int k = 0; k < 3; ++k)
        {
          sums[method][k] += weight[method] * colors[i][k];
        }
      }
    }
    double* sum[3] = { &errors.Paper, &errors.Corrected, &errors.CosineSeries };
    for (int method = 0; method < 3; ++method)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double color = sums[method][k] / weights[method] * (1.0 - through);
        *sum[method] += std::abs(color - exact[k]) / (3.0 * rounds);
      }
    }
  }
  return errors;
}

void CheckColorErrors(Checks& check)
{
  for (int layers : { 4, 10, 50 })
  {
    const Errors mixed = GetColorErrors(layers, 0.2, 0.3);
    const Errors low = GetColorErrors(layers, 0.0, 0.1);
    std::cout << layers << " layers: error of the paper " << mixed.Paper << ", without own share "
              << mixed.Corrected << ", cosines " << mixed.CosineSeries << "; low opacity "
              << low.Paper << ", " << low.Corrected << ", " << low.CosineSeries << "\n";
    // The more layers, the less a fragment's own share counts.
    const double part = layers < 50 ? 0.5 : 0.8;
    const std::string name = std::to_string(layers) + " layers: ";
    check(mixed.CosineSeries < part * mixed.Paper, name + "cosines against the paper");
    check(mixed.Corrected < (layers < 50 ? 0.5 : 0.9) * mixed.Paper, name + "without own share");
    check(low.CosineSeries < 1.1 * low.Paper + 1e-4, name + "low opacity");
  }
}

// Half floats may be infinite.
void CheckInfiniteSums(Checks& check)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Pixel<double, Cosines, 11> pixel;
  check(pixel.fourierFront(infinite, 0.5, 2.0, 10.0) == 8.0, "an infinite sum: all others");
  check(pixel.fourierFront(-infinite, 0.5, 2.0, 10.0) == 0.0, "minus infinity: nothing");
  check(pixel.fourierFront(infinite - infinite, 0.5, 2.0, 10.0) == 0.0, "no number: nothing");
}
}

int TestFourierOpacityFunctions(int, char*[])
{
  Checks check;
  CheckBothPrecisions<Cosines, 3>(check);
  CheckBothPrecisions<Cosines, 11>(check);
  CheckBothPrecisions<Cosines, 33>(check);
  CheckBothPrecisions<SinesAndCosines, 3>(check);
  CheckBothPrecisions<SinesAndCosines, 11>(check);
  CheckBothPrecisions<SinesAndCosines, 33>(check);
  CheckBothPrecisions<EqualBins, 3>(check);
  CheckBothPrecisions<EqualBins, 11>(check);
  CheckBothPrecisions<EqualBins, 33>(check);
  CheckConvergence<Cosines>(check);
  CheckConvergence<SinesAndCosines>(check);
  CheckConvergence<EqualBins>(check);
  CheckOptimalOpacity<float>(check);
  CheckOptimalOpacity<double>(check);
  CheckColorErrors(check);
  CheckInfiniteSums(check);
  return check.GetResult();
}
