// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneImportance.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace linesets
{
namespace
{
constexpr double LowQuantile = 0.76;
constexpr double HighQuantile = 0.98;

// Replace the values of each line, `vertices` long, by weighted means along it. End values stay.
void SmoothLines(std::vector<float>& values, vtkIdType vertices, int smoothings)
{
  const vtkIdType lines = static_cast<vtkIdType>(values.size()) / vertices;
  vtkSMPTools::For(0, lines,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType line = begin; line < end; ++line)
      {
        float* value = values.data() + line * vertices;
        for (int i = 0; i < smoothings; ++i)
        {
          float before = value[0];
          for (vtkIdType j = 1; j + 1 < vertices; ++j)
          {
            const float mean = 0.25f * (before + 2.0f * value[j] + value[j + 1]);
            before = value[j];
            value[j] = mean;
          }
        }
      }
    });
}

// What a point stands for: the mean of the lengths of its two segments where it is on a line.
double GetWeight(vtkPolyData* data, vtkIdType id, vtkIdType vertices)
{
  if (vertices == 0)
  {
    return 1.0;
  }
  const vtkIdType first = id - id % vertices;
  double before[3];
  double after[3];
  data->GetPoint(std::max(id - 1, first), before);
  data->GetPoint(std::min(id + 1, first + vertices - 1), after);
  return 0.5 * std::sqrt(vtkMath::Distance2BetweenPoints(before, after));
}

// The weight of values in intervals of equal width, which are fine enough for quantiles.
class Histogram
{
public:
  // One after the other, so that sums do not depend on threads.
  Histogram(vtkPolyData* data, const std::vector<float>& values, vtkIdType vertices)
    : Weights(65536, 0.0)
  {
    const auto range = std::minmax_element(values.begin(), values.end());
    this->Low = *range.first;
    this->Width = (static_cast<double>(*range.second) - this->Low) / this->Weights.size();
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double place = this->Width > 0.0 ? (values[i] - this->Low) / this->Width : 0.0;
      const std::size_t bin = std::min(static_cast<std::size_t>(place), this->Weights.size() - 1);
      this->Weights[bin] += GetWeight(data, static_cast<vtkIdType>(i), vertices);
    }
  }

  float GetQuantile(double quantile) const
  {
    const double wanted =
      quantile * std::accumulate(this->Weights.begin(), this->Weights.end(), 0.0);
    double sum = 0.0;
    std::size_t bin = 0;
    while (bin + 1 < this->Weights.size() && sum + this->Weights[bin] < wanted)
    {
      sum += this->Weights[bin++];
    }
    return static_cast<float>(this->Low + this->Width * static_cast<double>(bin));
  }

private:
  std::vector<double> Weights;
  double Low;
  double Width;
};

std::string GetArrayNames(vtkPointData* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names += std::string(names.empty() ? "" : " ") + (name ? name : "(unnamed)");
  }
  return names.empty() ? "none" : names;
}

vtkDataArray* FindImportance(vtkPointData* data, const std::string& name)
{
  if (!name.empty())
  {
    vtkDataArray* array = data->GetArray(name.c_str());
    if (!array)
    {
      throw std::runtime_error("importance: no array of numbers " + name +
        " at the points, whose arrays are: " + GetArrayNames(data));
    }
    if (array->GetNumberOfComponents() != 1)
    {
      throw std::runtime_error("importance: the array " + name + " has " +
        std::to_string(array->GetNumberOfComponents()) + " components in place of 1");
    }
    return array;
  }
  vtkDataArray* array = data->GetArray("importance");
  if (!array || array->GetNumberOfComponents() != 1)
  {
    array = data->GetScalars();
  }
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}
}

//------------------------------------------------------------------------------
void AddImportance(vtkPolyData* data, const Quantity& quantity, vtkIdType vertices, int smoothings)
{
  const vtkIdType count = data->GetNumberOfPoints();
  std::vector<float> values(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        double point[3];
        data->GetPoint(i, point);
        values[i] = static_cast<float>(quantity(i, point));
      }
    });
  if (smoothings > 0)
  {
    SmoothLines(values, vertices, smoothings);
  }
  vtkNew<vtkFloatArray> importance;
  importance->SetName("importance");
  importance->SetNumberOfTuples(count);
  data->GetPointData()->AddArray(importance);
  if (count == 0)
  {
    return;
  }
  const Histogram histogram(data, values, vertices);
  const float low = histogram.GetQuantile(LowQuantile);
  const float high = histogram.GetQuantile(HighQuantile);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float u = values[i] >= high ? 1.0f
          : values[i] <= low              ? 0.0f
                                          : (values[i] - low) / (high - low);
        importance->SetValue(i, u * u * (3.0f - 2.0f * u));
      }
    });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> MakeImportance(vtkPolyData* data, const std::string& name)
{
  vtkDataArray* array = FindImportance(data->GetPointData(), name);
  if (!array)
  {
    return nullptr;
  }
  const vtkIdType count = array->GetNumberOfTuples();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  vtkIdType infinite = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      ++infinite;
      continue;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (infinite == count)
  {
    throw std::runtime_error("importance: no finite value");
  }
  const bool scaled = low < 0.0 || high > 1.0;
  const double start = scaled ? low : 0.0;
  const double width = scaled && high > low ? high - low : 1.0;
  auto importance = vtkSmartPointer<vtkFloatArray>::New();
  importance->SetName("importance");
  importance->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = array->GetComponent(i, 0);
    importance->SetValue(
      i, std::isfinite(value) ? static_cast<float>((value - start) / width) : 0.0f);
  }
  if (scaled)
  {
    std::cerr << "importance: values from " << low << " to " << high << " are scaled to [0,1]\n";
  }
  if (infinite > 0)
  {
    std::cerr << "importance: " << infinite << " of " << count << " values are not finite: 0\n";
  }
  return importance;
}
}
