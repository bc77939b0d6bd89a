// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Traces many lines of a vector field, each with the same number of vertices.
 *
 * Classical Runge-Kutta steps of fourth order. Each line has its own stream of random numbers and
 * its own place in the result, so that the result does not depend on the threads.
 */

#ifndef LineTracer_h
#define LineTracer_h

#include "Random.h"

#include "vtkSmartPointer.h" // For the result
#include "vtkType.h"         // For vtkIdType

#include <functional> // For the seeds

class vtkPolyData;

namespace linesets
{
class VectorField
{
public:
  virtual ~VectorField() = default;

  /// Vector at a point and a time; false outside the domain.
  virtual bool Evaluate(const double point[3], double time, double vector[3]) const = 0;
};

struct TraceOptions
{
  vtkIdType Lines = 1000;
  int Vertices = 250;
  std::uint64_t Seed = 1;
  /// Where a line begins; `line` is its number.
  std::function<void(vtkIdType line, Random& random, double point[3])> MakeSeed;
  /// Length of a step (along the direction of the field), or its time where ByTime is set.
  double Step = 0.01;
  /// Largest number of steps of a line; 0 means Vertices - 1.
  int Steps = 0;
  /// Path lines: the step is a time, the field is unsteady, and the line starts at time 0.
  bool ByTime = false;
  /// Runge-Kutta steps for each step.
  int Substeps = 1;
  /// Trace to both sides of the seed.
  bool BothWays = false;
  /// Against the field.
  bool Backward = false;
  /// A line with fewer steps is given up for another seed, up to Attempts times; then the longest
  /// one is kept.
  int FewestSteps = 1;
  int Attempts = 50;
};

/**
 * Lines with a point array "speed" (float), the length of the field's vector. A line that ended
 * before its last vertex is sampled again at equal arc length, so that all have the same number.
 * Throws std::runtime_error where no seed gave a line.
 */
vtkSmartPointer<vtkPolyData> TraceLines(const VectorField& field, const TraceOptions& options);
}

#endif
