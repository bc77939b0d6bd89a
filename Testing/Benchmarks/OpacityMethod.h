// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Points, lines and surfaces drawn by vtkFourierOpacityMapper, which fades what hides the
 * important.
 */

#ifndef OpacityMethod_h
#define OpacityMethod_h

#include "BenchmarkMethod.h"

#include "vtkOpacityOptimization.h" // For the kinds of blending

#include <array> // For weights

class vtkFourierOpacityMapper;
class vtkOpacitySegments;

namespace linesets
{
class OpacityMethod : public BenchmarkMethod
{
public:
  struct Variant
  {
    const char* Name;
    vtkOpacityOptimization::BlendingType Blending;
  };

  /// All of them.
  static const std::vector<Variant>& GetVariants();

  /// The one of this name, or nullptr.
  static const Variant* FindVariant(const std::string& name);

  /// Weights p, q, r and lambda, and steps of smoothing, that suit a scene.
  struct SceneDefaults
  {
    const char* Scene;
    std::array<double, 4> Weights;
    int Smoothing;
  };

  /// Those of the scenes that need others than the defaults of vtkOpacityOptimization. The last
  /// one, without a name, is these.
  static const std::vector<SceneDefaults>& GetSceneDefaults();

  explicit OpacityMethod(const std::string& name);
  ~OpacityMethod() override;

  /// The exact picture: importance and colours by sorted fragments, with the importance of one of
  /// so many pixels of a row and a column.
  static std::unique_ptr<OpacityMethod> MakeExact(int importanceReduction);

  void Prepare(BenchmarkInput& input) override;
  double Update(BenchmarkInput& input) override;
  void PrepareForPicture() override;
  void Describe(JsonObject& object) override;

  /// Fragments that did not fit into the lists of the last frame.
  long long GetNumberOfDroppedFragments();

  /// Mean number of fragments of the last frame over the pixels that have any.
  double GetMeanDepthComplexity();

private:
  void SetOptimization(const BenchmarkOptions& options);
  double RunFilter(BenchmarkInput& input);
  bool UsesLists() const;

  vtkOpacityOptimization::BlendingType Blending;
  int ExactReduction = 0; // 0: not the exact picture
  vtkNew<vtkOpacitySegments> Filter;
  vtkNew<vtkFourierOpacityMapper> Mapper;
};
}

#endif
