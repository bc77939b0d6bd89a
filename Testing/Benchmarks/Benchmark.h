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
#include "Capsule.h"

#include <memory> // For the methods
#include <string> // For names
#include <vector> // For the methods

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
  struct Entry;
  void MakeInput();
  void MakeWindow();
  void SetView(int frame);
  double DrawFrame(BenchmarkMethod& method);
  void Attempt(
    BenchmarkMethod& method, const std::string& stage, void (Benchmark::*step)(BenchmarkMethod&));
  void PrepareMethod(BenchmarkMethod& method);
  void DrawFirstFrame(BenchmarkMethod& method);
  void DrawTimedFrame(BenchmarkMethod& method);
  void TakePicture(BenchmarkMethod& method);
  void Judge();
  void DrawReference(
    const CapsuleScene& scene, BenchmarkMethod& method, vtkImageData* picture) const;
  std::string Describe(Entry& entry);
  double GetPeerMedian(const std::string& name) const;

  const BenchmarkOptions& Options;
  BenchmarkInput Input;
  std::string RendererName;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<Entry> Entries;
  std::vector<std::string> Results;
};
}

#endif
