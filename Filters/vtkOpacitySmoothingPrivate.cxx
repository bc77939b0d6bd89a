// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpacitySmoothingPrivate.h"

#include "vtkIntArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// Longest run that is one piece of work.
constexpr int LongestRun = 4096;

/// Runs that one task works on, and segments from which on threads are worth their start.
constexpr vtkIdType RunsPerTask = 8;
constexpr int SegmentsForThreads = 1 << 18;

}

//------------------------------------------------------------------------------
void vtkOpacitySmoothing::SetNeighbors(int numberOfSegments, vtkIntArray* pairs)
{
  this->NumberOfSegments = std::max(numberOfSegments, 0);
  this->NumberOfIgnoredPairs = 0;
  const std::size_t size = static_cast<std::size_t>(this->NumberOfSegments);
  const vtkIdType numberOfPairs =
    pairs && pairs->GetNumberOfComponents() == 2 ? pairs->GetNumberOfTuples() : 0;
  const int* pair = numberOfPairs > 0 ? pairs->GetPointer(0) : nullptr;
  const auto isValid = [this](const int* ends)
  {
    return ends[0] != ends[1] && std::min(ends[0], ends[1]) >= 0 &&
      std::max(ends[0], ends[1]) < this->NumberOfSegments;
  };
  this->Offsets.assign(size + 1, 0);
  for (vtkIdType i = 0; i < numberOfPairs; ++i)
  {
    if (!isValid(pair + 2 * i))
    {
      ++this->NumberOfIgnoredPairs;
      continue;
    }
    ++this->Offsets[static_cast<std::size_t>(pair[2 * i]) + 1];
    ++this->Offsets[static_cast<std::size_t>(pair[2 * i + 1]) + 1];
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Offsets[i + 1] += this->Offsets[i];
  }
  this->Neighbors.resize(static_cast<std::size_t>(this->Offsets.back()));
  std::vector<vtkIdType> next(this->Offsets.begin(), this->Offsets.end() - 1);
  for (vtkIdType i = 0; i < numberOfPairs; ++i)
  {
    const int* ends = pair + 2 * i;
    for (int j = 0; j < 2 && isValid(ends); ++j)
    {
      const vtkIdType slot = next[static_cast<std::size_t>(ends[j])]++;
      this->Neighbors[static_cast<std::size_t>(slot)] = ends[1 - j];
    }
  }
  this->MakeRuns();
}

//------------------------------------------------------------------------------
void vtkOpacitySmoothing::MakeRuns()
{
  this->Runs.clear();
  for (int i = 0; i < this->NumberOfSegments; ++i)
  {
    const vtkIdType begin = this->Offsets[static_cast<std::size_t>(i)];
    const vtkIdType end = this->Offsets[static_cast<std::size_t>(i) + 1];
    bool isChain = end - begin == 2;
    if (isChain)
    {
      const int a = this->Neighbors[static_cast<std::size_t>(begin)];
      const int b = this->Neighbors[static_cast<std::size_t>(begin) + 1];
      isChain = std::min(a, b) == i - 1 && std::max(a, b) == i + 1;
    }
    if (this->Runs.empty() || this->Runs.back().IsChain != isChain ||
      i - this->Runs.back().First >= LongestRun)
    {
      this->Runs.push_back({ i, i, isChain });
    }
    this->Runs.back().Last = i + 1;
  }
}

//------------------------------------------------------------------------------
void vtkOpacitySmoothing::SmoothRun(const Run& run, const float* in, float* out) const
{
  if (run.IsChain)
  {
    for (int i = run.First; i < run.Last; ++i)
    {
      out[i] = 0.5f * in[i] + 0.25f * (in[i - 1] + in[i + 1]);
    }
    return;
  }
  for (int i = run.First; i < run.Last; ++i)
  {
    const std::size_t begin = static_cast<std::size_t>(this->Offsets[static_cast<std::size_t>(i)]);
    const std::size_t end =
      static_cast<std::size_t>(this->Offsets[static_cast<std::size_t>(i) + 1]);
    float sum = 0.0f;
    for (std::size_t j = begin; j < end; ++j)
    {
      sum += in[this->Neighbors[j]];
    }
    out[i] = begin < end ? 0.5f * in[i] + 0.5f * (sum / static_cast<float>(end - begin)) : in[i];
  }
}

//------------------------------------------------------------------------------
bool vtkOpacitySmoothing::Smooth(
  const std::vector<float>& in, int iterations, std::vector<float>& out)
{
  const bool isFitting = in.size() == static_cast<std::size_t>(this->NumberOfSegments);
  if (&in != &out)
  {
    out = in;
  }
  if (!isFitting)
  {
    return false;
  }
  this->Buffer.resize(out.size());
  const vtkIdType numberOfRuns = static_cast<vtkIdType>(this->Runs.size());
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const auto smooth = [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        this->SmoothRun(this->Runs[static_cast<std::size_t>(i)], out.data(), this->Buffer.data());
      }
    };
    if (this->NumberOfSegments < SegmentsForThreads)
    {
      smooth(0, numberOfRuns);
    }
    else
    {
      vtkSMPTools::For(0, numberOfRuns, RunsPerTask, smooth);
    }
    out.swap(this->Buffer);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOpacitySmoothing::Fill(
  const std::vector<unsigned char>& hasValue, std::vector<float>& values) const
{
  const auto size = static_cast<std::size_t>(this->NumberOfSegments);
  if (hasValue.size() != size || values.size() != size)
  {
    return false;
  }
  // Breadth first: the step in which a segment gets its value, 0 for those that have one.
  constexpr int never = std::numeric_limits<int>::max();
  std::vector<int> steps(size, never);
  std::vector<int> front;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (hasValue[i])
    {
      steps[i] = 0;
      front.push_back(static_cast<int>(i));
    }
  }
  if (front.size() == size)
  {
    return true;
  }
  std::vector<int> next;
  for (int step = 1; !front.empty(); ++step)
  {
    next.clear();
    for (int segment : front)
    {
      const auto i = static_cast<std::size_t>(segment);
      for (vtkIdType j = this->Offsets[i]; j < this->Offsets[i + 1]; ++j)
      {
        const int neighbor = this->Neighbors[static_cast<std::size_t>(j)];
        if (steps[static_cast<std::size_t>(neighbor)] == never)
        {
          steps[static_cast<std::size_t>(neighbor)] = step;
          next.push_back(neighbor);
        }
      }
    }
    for (int segment : next)
    {
      const auto i = static_cast<std::size_t>(segment);
      float sum = 0.0f;
      int count = 0;
      for (vtkIdType j = this->Offsets[i]; j < this->Offsets[i + 1]; ++j)
      {
        const auto neighbor =
          static_cast<std::size_t>(this->Neighbors[static_cast<std::size_t>(j)]);
        if (steps[neighbor] == step - 1)
        {
          sum += values[neighbor];
          ++count;
        }
      }
      values[i] = sum / static_cast<float>(count);
    }
    front.swap(next);
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkOpacitySmoothing::GetBlend(double seconds, double transitionTime)
{
  if (!(transitionTime > 0.0))
  {
    return 1.0;
  }
  return seconds > 0.0 ? -std::expm1(-std::log(20.0) * (seconds / transitionTime)) : 0.0;
}
