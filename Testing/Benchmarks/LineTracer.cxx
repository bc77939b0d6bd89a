// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LineTracer.h"

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
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace linesets
{
namespace
{
struct Vertex
{
  std::array<double, 3> Point;
  double Speed;
};
using Line = std::vector<Vertex>;

// The tracer of one line after the other; one per thread.
class Tracer
{
public:
  Tracer(const VectorField& field, const TraceOptions& options)
    : Field(field)
    , Options(options)
    , Steps(options.Steps > 0 ? options.Steps : options.Vertices - 1)
  {
  }

  // The longest line that the attempts gave; empty where all seeds were outside.
  const Line& Trace(vtkIdType number)
  {
    Random random(this->Options.Seed, number);
    this->Best.clear();
    for (int attempt = 0; attempt < this->Options.Attempts; ++attempt)
    {
      Vertex seed;
      this->Options.MakeSeed(number, random, seed.Point.data());
      this->TraceFrom(seed);
      if (this->Current.size() > this->Best.size())
      {
        std::swap(this->Current, this->Best);
      }
      if (static_cast<int>(this->Best.size()) > this->Options.FewestSteps)
      {
        break;
      }
    }
    return this->Best;
  }

private:
  bool Evaluate(const double point[3], double time, double vector[3], double& speed) const
  {
    if (!this->Field.Evaluate(point, time, vector))
    {
      return false;
    }
    speed = vtkMath::Norm(vector);
    if (this->Options.ByTime)
    {
      return true;
    }
    if (!(speed > 1e-12))
    {
      return false;
    }
    vtkMath::MultiplyScalar(vector, 1.0 / speed);
    return true;
  }

  // One step of fourth order. The speed is that at the new point.
  bool Step(Vertex& vertex, double& time, double step) const
  {
    const double half[4] = { 0.0, 0.5, 0.5, 1.0 };
    const double weight[4] = { 1.0, 2.0, 2.0, 1.0 };
    double sum[3] = { 0.0, 0.0, 0.0 };
    double slope[3] = { 0.0, 0.0, 0.0 };
    double speed;
    for (int stage = 0; stage < 4; ++stage)
    {
      double point[3];
      for (int i = 0; i < 3; ++i)
      {
        point[i] = vertex.Point[i] + half[stage] * step * slope[i];
      }
      if (!this->Evaluate(point, time + half[stage] * step, slope, speed))
      {
        return false;
      }
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += weight[stage] * slope[i];
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      vertex.Point[i] += step * sum[i] / 6.0;
    }
    time += step;
    return this->Evaluate(vertex.Point.data(), time, slope, vertex.Speed);
  }

  // Appends up to `count` vertices.
  void Extend(Vertex vertex, double direction, int count, Line& line) const
  {
    const double step = direction * this->Options.Step / this->Options.Substeps;
    double time = 0.0;
    for (int i = 0; i < count; ++i)
    {
      for (int substep = 0; substep < this->Options.Substeps; ++substep)
      {
        if (!this->Step(vertex, time, step))
        {
          return;
        }
      }
      line.push_back(vertex);
    }
  }

  void TraceFrom(Vertex seed)
  {
    this->Current.clear();
    this->Behind.clear();
    double vector[3];
    if (!this->Evaluate(seed.Point.data(), 0.0, vector, seed.Speed))
    {
      return;
    }
    const double direction = this->Options.Backward ? -1.0 : 1.0;
    if (this->Options.BothWays)
    {
      this->Extend(seed, -direction, this->Steps / 2, this->Behind);
    }
    this->Current.assign(this->Behind.rbegin(), this->Behind.rend());
    this->Current.push_back(seed);
    this->Extend(
      seed, direction, this->Steps - static_cast<int>(this->Behind.size()), this->Current);
    const int missing = this->Steps + 1 - static_cast<int>(this->Current.size());
    if (this->Options.BothWays && missing > 0)
    {
      // The way ahead ended early: go on behind.
      this->Behind.clear();
      this->Extend(this->Current.front(), -direction, missing, this->Behind);
      this->Current.insert(this->Current.begin(), this->Behind.rbegin(), this->Behind.rend());
    }
  }

  const VectorField& Field;
  const TraceOptions& Options;
  const int Steps;
  Line Best;
  Line Current;
  Line Behind;
};

// Sample a line at `count` points of equal arc length.
void Resample(const Line& line, int count, Line& result)
{
  std::vector<double> lengths(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    lengths[i] = lengths[i - 1] +
      std::sqrt(vtkMath::Distance2BetweenPoints(line[i - 1].Point.data(), line[i].Point.data()));
  }
  result.clear();
  std::size_t segment = 0;
  for (int i = 0; i < count; ++i)
  {
    const double length = lengths.back() * i / (count - 1.0);
    while (segment + 2 < line.size() && lengths[segment + 1] < length)
    {
      ++segment;
    }
    const double width = lengths[segment + 1] - lengths[segment];
    const double u = width > 0.0 ? std::min(1.0, (length - lengths[segment]) / width) : 0.0;
    const Vertex& a = line[segment];
    const Vertex& b = line[segment + 1];
    Vertex vertex;
    for (int axis = 0; axis < 3; ++axis)
    {
      vertex.Point[axis] = a.Point[axis] + u * (b.Point[axis] - a.Point[axis]);
    }
    vertex.Speed = a.Speed + u * (b.Speed - a.Speed);
    result.push_back(vertex);
  }
}

vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType lines, int vertices)
{
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> ids;
  offsets->SetNumberOfValues(lines + 1);
  ids->SetNumberOfValues(lines * vertices);
  for (vtkIdType i = 0; i <= lines; ++i)
  {
    offsets->SetValue(i, i * vertices);
  }
  for (vtkIdType i = 0; i < lines * vertices; ++i)
  {
    ids->SetValue(i, i);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> TraceLines(const VectorField& field, const TraceOptions& options)
{
  const vtkIdType count = options.Lines * options.Vertices;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> speeds;
  speeds->SetName("speed");
  speeds->SetNumberOfTuples(count);
  std::atomic<bool> failed{ false };
  vtkSMPTools::For(0, options.Lines, 64,
    [&](vtkIdType begin, vtkIdType end)
    {
      Tracer tracer(field, options);
      Line sampled;
      for (vtkIdType number = begin; number < end; ++number)
      {
        const Line* line = &tracer.Trace(number);
        if (line->size() < 2)
        {
          failed = true;
          continue;
        }
        if (static_cast<int>(line->size()) != options.Vertices)
        {
          Resample(*line, options.Vertices, sampled);
          line = &sampled;
        }
        for (int i = 0; i < options.Vertices; ++i)
        {
          const vtkIdType point = number * options.Vertices + i;
          for (int axis = 0; axis < 3; ++axis)
          {
            coordinates->SetTypedComponent(point, axis, static_cast<float>((*line)[i].Point[axis]));
          }
          speeds->SetValue(point, static_cast<float>((*line)[i].Speed));
        }
      }
    });
  if (failed)
  {
    throw std::runtime_error("no seed gave a line");
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(MakeCells(options.Lines, options.Vertices));
  result->GetPointData()->SetScalars(speeds);
  return result;
}
}
