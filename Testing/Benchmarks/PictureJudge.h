// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Holds the methods' pictures against exact ones.
 */

#ifndef PictureJudge_h
#define PictureJudge_h

#include "BenchmarkMethod.h"
#include "OcclusionJudge.h"

#include "vtkNew.h" // For pictures

#include <limits> // For what is not known
#include <memory> // For the method

class vtkImageData;

namespace linesets
{
/// A method, its picture, and how that and its occlusion compare; NaN where it was not compared.
struct BenchmarkEntry
{
  std::unique_ptr<BenchmarkMethod> Method;
  vtkNew<vtkImageData> Picture;
  double Rmse = std::numeric_limits<double>::quiet_NaN();
  double Ssim = std::numeric_limits<double>::quiet_NaN();
  /// Against the picture whose importance is summed for all pixels (OpacityJudge.h).
  double FullRmse = std::numeric_limits<double>::quiet_NaN();
  double FullSsim = std::numeric_limits<double>::quiet_NaN();
  double DecodedRmse = std::numeric_limits<double>::quiet_NaN();
  OcclusionMeasures Occlusion;
};

class PictureJudge
{
public:
  /// The lines and the view of the pictures.
  explicit PictureJudge(const BenchmarkInput& input);

  /// Compare a method's picture of lines as the options ask. Pictures of methods with shadows or
  /// occlusion are not: exact ones have neither.
  void Judge(BenchmarkEntry& entry);

private:
  void DrawExact(BenchmarkMethod& method);

  const BenchmarkInput& Input;
  bool Drawn = false;
  vtkNew<vtkImageData> Exact;
};

/// Write a PNG file; returns whether that went well.
bool WriteImage(vtkImageData* image, const std::string& fileName);
}

#endif
