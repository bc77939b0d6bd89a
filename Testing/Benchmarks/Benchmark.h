// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A run of linesets-bench: the methods in turn, frame by frame, and what is measured.
 */

#ifndef Benchmark_h
#define Benchmark_h

#include "BenchmarkMethod.h"
#include "BenchmarkOptions.h"
#include "MovingLines.h"
#include "PictureJudge.h"

#include <functional> // For steps
#include <memory>     // For the moving lines
#include <string>     // For names
#include <vector>     // For the methods

class vtkImageData;
class vtkRenderWindow;

namespace linesets
{
class Benchmark
{
public:
  explicit Benchmark(const BenchmarkOptions& options);
  ~Benchmark();

  /// Do all of it. Throws where not even the scene can be made. Returns whether all methods worked.
  bool Run();

  /// One line of JSON per method.
  std::vector<std::string> GetResults() const;

private:
  void MakeInput();
  void MakeWindow();
  void MakeEntries();
  double DrawFrame(BenchmarkMethod& method);
  void Attempt(
    BenchmarkMethod& method, const std::string& stage, const std::function<void()>& step);
  void PrepareMethod(BenchmarkMethod& method);
  void DrawFirstFrame(BenchmarkMethod& method);
  void DrawTimedFrame(BenchmarkMethod& method);
  void DrawTimedFrames();
  void TakePicture(BenchmarkMethod& method, vtkImageData* picture, const std::string& name);
  void DrawReference(BenchmarkMethod& method, vtkImageData* picture, const std::string& name);
  void TakePictures();
  void JudgeOcclusions();

  BenchmarkInput Input;
  std::unique_ptr<MovingLines> Moving; // null: the lines stay
  std::string RendererName;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<BenchmarkEntry> Entries;
  std::vector<std::string> Results;
};
}

#endif
