// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines drawn as OpenGL's lines.
 */

#ifndef LineMethods_h
#define LineMethods_h

#include "BenchmarkMethod.h"

class vtkIlluminatedLineMapper;

namespace linesets
{
/// Lines that vtkProperty shades as tubes.
class LineTubeMethod : public BenchmarkMethod
{
public:
  LineTubeMethod();
  ~LineTubeMethod() override;

  void Prepare(BenchmarkInput& input) override;
  double Update(BenchmarkInput& input) override;
  void Describe(JsonObject& object) override;

private:
  long long Segments = 0;
  vtkNew<vtkPolyDataMapper> Mapper;
};

/// Lines one pixel wide (or as wide as was asked for), without and with light. Without, also points
/// of the same size, and surfaces, which have the light that lines have not.
class LineMethod : public BenchmarkMethod
{
public:
  /// `name` is lines or a name that begins with illuminated.
  explicit LineMethod(const std::string& name);
  ~LineMethod() override;

  void Prepare(BenchmarkInput& input) override;
  double Update(BenchmarkInput& input) override;
  void Describe(JsonObject& object) override;

private:
  long long Segments = 0;
  vtkSmartPointer<vtkIlluminatedLineMapper> Illuminated; // null: without light
  vtkSmartPointer<vtkPolyDataMapper> Mapper;
};
}

#endif
