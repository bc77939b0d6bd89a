// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Smooths one value per segment along the geometry, and over time.
 *
 * Each iteration replaces a value by the mean of itself and the mean of its neighbours' values of
 * the iteration before (uniform Laplacian smoothing with a step of 1/2). See Baeza Rojo et al.,
 * 2019, Sec. 4.2, step 3, which takes 15 iterations. A step of 1/2 damps what alternates between
 * neighbours to nothing, where a step of 1 would keep it for ever.
 */

#ifndef vtkOpacitySmoothingPrivate_h
#define vtkOpacitySmoothingPrivate_h

#include "vtkFiltersLineSetsModule.h" // For export macro
#include "vtkType.h"

#include <vector>

class vtkIntArray;

class VTKFILTERSLINESETS_EXPORT vtkOpacitySmoothing
{
public:
  /**
   * Set the number of segments and the pairs of neighbours, as vtkOpacitySegments tells them.
   * Segments without neighbours keep their value. Pairs of a segment with itself, or with one that
   * does not exist, are left out and counted. Without an array, there are no neighbours.
   */
  void SetNeighbors(int numberOfSegments, vtkIntArray* pairs);

  int GetNumberOfSegments() const { return this->NumberOfSegments; }
  int GetNumberOfIgnoredPairs() const { return this->NumberOfIgnoredPairs; }

  /**
   * Smooth one value per segment. Both vectors may be the same. Without iterations, or if the size
   * does not fit, the values are copied; the result tells whether it fitted. The values do not
   * depend on the number of threads.
   */
  bool Smooth(const std::vector<float>& in, int iterations, std::vector<float>& out);

  /**
   * Give each segment that has no value yet, but a way along neighbours to one that has, the mean
   * of its neighbours that are nearest to such a one. The others keep what they have. Returns
   * whether the sizes fitted.
   */
  bool Fill(const std::vector<unsigned char>& hasValue, std::vector<float>& values) const;

  /**
   * Fraction of the way from the shown value to its goal that a frame goes which takes this long:
   * 1 - 20^(-seconds / transition time). After the transition time, 95 % of the way is done,
   * whatever the length of the frames. 1 without a transition time, 0 where no time passes.
   */
  static double GetBlend(double seconds, double transitionTime);

private:
  /// A run of segments [First, Last). In a chain, the neighbours of each are those beside it.
  struct Run
  {
    int First;
    int Last;
    bool IsChain;
  };

  void MakeRuns();
  void SmoothRun(const Run& run, const float* in, float* out) const;

  int NumberOfSegments = 0;
  int NumberOfIgnoredPairs = 0;
  /// Neighbours of all segments in a row, and where those of each begin.
  std::vector<vtkIdType> Offsets;
  std::vector<int> Neighbors;
  std::vector<Run> Runs;
  std::vector<float> Buffer;
};

#endif

// VTK-HeaderTest-Exclude: vtkOpacitySmoothingPrivate.h
