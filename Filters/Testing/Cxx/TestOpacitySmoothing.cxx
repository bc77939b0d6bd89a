// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Guards the smoothing of segment opacities: that it is what its definition says, computed in
 * double precision over sets of neighbours; that it is the same for every number of threads; that
 * bad pairs and sizes do no harm; and that blending over time does not depend on the frame rate.
 */

#include "OpacitySegmentTesting.h"
#include "vtkOpacitySmoothingPrivate.h"
#include "vtkSMPTools.h"

using namespace OpacitySegmentTesting;

namespace
{

using Pairs = std::vector<std::pair<int, int>>;

vtkSmartPointer<vtkIntArray> MakeArray(const Pairs& pairs)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetNumberOfComponents(2);
  for (const auto& pair : pairs)
  {
    array->InsertNextTuple2(pair.first, pair.second);
  }
  return array;
}

std::vector<float> MakeValues(int size)
{
  std::mt19937 generator(7);
  std::vector<float> values(static_cast<std::size_t>(size));
  for (float& value : values)
  {
    value = static_cast<float>(generator() / 4294967296.0);
  }
  return values;
}

/// The definition.
std::vector<double> SmoothReference(
  const std::vector<float>& in, const Pairs& pairs, int iterations)
{
  std::vector<std::set<int>> neighbors(in.size());
  for (const auto& pair : pairs)
  {
    neighbors[static_cast<std::size_t>(pair.first)].insert(pair.second);
    neighbors[static_cast<std::size_t>(pair.second)].insert(pair.first);
  }
  std::vector<double> values(in.begin(), in.end());
  for (int k = 0; k < iterations; ++k)
  {
    std::vector<double> next = values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      double mean = 0.0;
      for (int j : neighbors[i])
      {
        mean += values[static_cast<std::size_t>(j)] / static_cast<double>(neighbors[i].size());
      }
      next[i] += neighbors[i].empty() ? 0.0 : 0.5 * (mean - values[i]);
    }
    values = next;
  }
  return values;
}

double GetLargestDifference(const std::vector<float>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() ? 0.0 : 1e30;
  for (std::size_t i = 0; i < a.size() && largest < 1e30; ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// Chains of many lengths, closed ones, lonely segments, and a part with random pairs.
Pairs MakePairs(int size)
{
  std::mt19937 generator(3);
  std::set<std::pair<int, int>> pairs;
  int first = 0;
  for (int length = 1; first + length < size / 2; length += length / 4 + 1)
  {
    for (int i = 1; i < length; ++i)
    {
      pairs.emplace(first + i - 1, first + i);
    }
    if (length % 2 == 1 && length > 2)
    {
      pairs.emplace(first, first + length - 1);
    }
    first += length;
  }
  for (int i = 0; i < size; ++i)
  {
    const int a = size / 2 + static_cast<int>(generator() % static_cast<unsigned>(size / 2));
    const int b = std::min(size - 1, a + 1 + static_cast<int>(generator() % 50));
    if (a != b)
    {
      pairs.emplace(a, b);
    }
  }
  return Pairs(pairs.begin(), pairs.end());
}

void TestValues(Checks& check)
{
  const int size = 40000;
  const Pairs pairs = MakePairs(size);
  const std::vector<float> in = MakeValues(size);
  vtkOpacitySmoothing smoothing;
  smoothing.SetNeighbors(size, MakeArray(pairs));
  check(smoothing.GetNumberOfSegments() == size && smoothing.GetNumberOfIgnoredPairs() == 0,
    "all pairs are taken");
  for (int iterations : { 0, 1, 2, 15 })
  {
    std::vector<float> out;
    check(smoothing.Smooth(in, iterations, out), "it fits");
    const double difference = GetLargestDifference(out, SmoothReference(in, pairs, iterations));
    check(difference < 1e-6,
      std::to_string(iterations) + " iterations: differs by " + std::to_string(difference));
    std::vector<float> self = in;
    smoothing.Smooth(self, iterations, self);
    check(self == out, "in place");
  }
}

void TestThreads(Checks& check)
{
  const int size = 400000;
  const std::vector<float> in = MakeValues(size);
  vtkOpacitySmoothing smoothing;
  smoothing.SetNeighbors(size, MakeArray(MakePairs(size)));
  vtkSMPTools::SetBackend("Sequential");
  std::vector<float> expected;
  smoothing.Smooth(in, 15, expected);
  vtkSMPTools::SetBackend("STDThread");
  for (int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    std::vector<float> out;
    smoothing.Smooth(in, 15, out);
    check(out == expected, std::to_string(threads) + " threads");
  }
}

void TestBadPairs(Checks& check)
{
  vtkOpacitySmoothing smoothing;
  smoothing.SetNeighbors(3, MakeArray({ { 0, 1 }, { 1, 1 }, { -1, 2 }, { 2, 3 } }));
  check(smoothing.GetNumberOfIgnoredPairs() == 3, "bad pairs are counted");
  std::vector<float> out;
  smoothing.Smooth({ 0.0f, 1.0f, 0.25f }, 1, out);
  check(out == std::vector<float>{ 0.5f, 0.5f, 0.25f }, "and the others are used");
  check(!smoothing.Smooth({ 1.0f, 0.0f }, 3, out) && out == std::vector<float>{ 1.0f, 0.0f },
    "values that do not fit are copied");
  smoothing.SetNeighbors(2, nullptr);
  check(smoothing.Smooth({ 1.0f, 0.0f }, 3, out) && out == std::vector<float>{ 1.0f, 0.0f },
    "without neighbours nothing changes");
  smoothing.SetNeighbors(0, nullptr);
  check(smoothing.Smooth({}, 3, out) && out.empty(), "nothing at all");
}

void TestBlend(Checks& check)
{
  using Smoothing = vtkOpacitySmoothing;
  for (double seconds : { 0.001, 0.016, 0.3, 2.0 })
  {
    const double whole = 1.0 - Smoothing::GetBlend(seconds, 0.5);
    const double half = 1.0 - Smoothing::GetBlend(0.5 * seconds, 0.5);
    check(std::abs(whole - half * half) < 1e-14, "two frames of half the time are one");
  }
  check(std::abs(Smoothing::GetBlend(0.5, 0.5) - 0.95) < 1e-14, "95 % after the transition time");
  check(Smoothing::GetBlend(0.0, 0.5) == 0.0 && Smoothing::GetBlend(-1.0, 0.5) == 0.0,
    "no time, no change");
  check(Smoothing::GetBlend(0.1, 0.0) == 1.0 && Smoothing::GetBlend(0.0, -1.0) == 1.0,
    "no transition, all at once");
  check(Smoothing::GetBlend(1e300, 1e-300) == 1.0, "no overflow");
}

}

int TestOpacitySmoothing(int, char*[])
{
  Checks check;
  TestValues(check);
  TestThreads(check);
  TestBadPairs(check);
  TestBlend(check);
  return check.GetResult();
}
