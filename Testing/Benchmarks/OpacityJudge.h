// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Holds the pictures of opacity optimization against exact ones.
 *
 * These are drawn with all fragments sorted, both for the sums of importance and for the colours,
 * by a method of their own with the same camera, weights and segments. One sums importance for as
 * few pixels as the methods do, so that it tells the error of series and blending alone; another
 * one for all pixels.
 */

#ifndef OpacityJudge_h
#define OpacityJudge_h

#include "PictureJudge.h"

#include "vtkNew.h" // For pictures

#include <functional> // For drawing
#include <string>     // For errors

namespace linesets
{
class OpacityJudge
{
public:
  /// Makes a picture of a method that is prepared, named for files where the name is not empty.
  using DrawFunction =
    std::function<void(BenchmarkMethod& method, vtkImageData* picture, const std::string& name)>;

  OpacityJudge(BenchmarkInput& input, DrawFunction draw);

  /// Compare a method's picture. Throws std::runtime_error where there is no exact one.
  void Judge(BenchmarkEntry& entry);

private:
  struct Exact
  {
    vtkNew<vtkImageData> Picture;
    double DepthComplexity = 0.0;
    bool Drawn = false;
    std::string Error;
  };

  const Exact& GetExact(Exact& exact, int reduction, const std::string& name);
  void DrawExact(Exact& exact, int reduction, const std::string& name);

  BenchmarkInput& Input;
  DrawFunction Draw;
  Exact Reduced;
  Exact Full;
};
}

#endif
