// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines drawn as triangles of vtkTubeFilter, opaque or in one of VTK's translucent passes.
 */

#ifndef TubeMethod_h
#define TubeMethod_h

#include "BenchmarkMethod.h"

class vtkTubeFilter;

namespace linesets
{
class TubeMethod : public BenchmarkMethod
{
public:
  /// `name` is tubes, peeling or oit.
  explicit TubeMethod(const std::string& name);
  ~TubeMethod() override;

  void Prepare(BenchmarkInput& input) override;
  double Update(BenchmarkInput& input) override;
  void Describe(JsonObject& object) override;

private:
  double RunFilter(BenchmarkInput& input);

  bool Translucent;
  int Peels = 0;
  long long Segments = 0;
  vtkNew<vtkTubeFilter> Filter;
  vtkNew<vtkPolyDataMapper> Mapper;
};
}

#endif
