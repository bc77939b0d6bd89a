// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lines drawn by vtkVoxelLineMapper, plain or with shadows and ambient occlusion.
 */

#ifndef VoxelMethod_h
#define VoxelMethod_h

#include "BenchmarkMethod.h"

#include "vtkLineGlobalIllumination.h" // For the kinds of shadows
#include "vtkNew.h"                    // For members

class vtkVoxelLineMapper;

namespace linesets
{
class VoxelMethod : public BenchmarkMethod
{
public:
  /// A method with more than plain voxel has.
  struct Variant
  {
    const char* Name;
    vtkLineGlobalIllumination::ShadowType Shadows;
    vtkLineGlobalIllumination::OcclusionType Occlusion;
  };

  /// All of them.
  static const std::vector<Variant>& GetVariants();

  /// The one of this name, or nullptr.
  static const Variant* FindVariant(const std::string& name);

  VoxelMethod(const std::string& name, const std::string& engine);
  ~VoxelMethod() override;

  void Prepare(BenchmarkInput& input) override;
  double Update(BenchmarkInput& input) override;
  void Describe(JsonObject& object) override;
  vtkVoxelLineModel* GetModel() override;

private:
  void SetGlobalIllumination(const BenchmarkOptions& options);
  void DescribeGlobalIllumination(JsonObject& object);

  const Variant* Global; // nullptr: plain
  vtkNew<vtkVoxelLineMapper> Mapper;
};
}

#endif
