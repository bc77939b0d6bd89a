// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityStages
 * @brief   shader code of the stages of opacity optimization
 *
 * The functions of glsl/vtkFourierOpacity.glsl do the arithmetic; here they are put together for
 * what vtkOpacityOptimization asks for. Nothing of this touches the graphics device.
 */

#ifndef vtkFourierOpacityStages_h
#define vtkFourierOpacityStages_h

#include "vtkFourierOpacityStage.h"

#include <string>

class vtkOpacityOptimization;

struct vtkFourierOpacityStages
{
  /// What vtkOpacityOptimization asks for, as the stages need it.
  int Blending = 0;
  int Series = 0; ///< kind of series, as in glsl/vtkFourierOpacity.glsl
  int Sums = 0;   ///< number of sums
  int Subset = 1;
  /// Pixels of a row of the full picture to one of the sums of importance and their bounds of
  /// depth, of the sums of optical depth, and of the widened bounds.
  int ImportanceReduction = 1;
  int DepthReduction = 1;
  int WidenedReduction = 1;
  bool HasTotals = false;     ///< the optical depth of each pixel is summed apart
  bool HasHalfFloats = false; ///< colours and sums but the first one are half floats
  bool Exact = false;         ///< importance is summed exactly
  bool HasSums = true;        ///< colours are blended by sums of optical depth
  bool HasLists = false;      ///< colours are blended by fragment lists
  bool HasBounds = false;
  bool HasOpaqueLayer = false;
  double HaloWidth = 0.0;
  double HaloDepth = 0.0;
  bool IsLogarithmic = false;
  float OpaqueThreshold = 2.0f;

  vtkFourierOpacityStages(vtkOpacityOptimization* optimization, bool isParallel);

  /// Textures of sums to which one draw writes: those from first on, and perhaps the bounds.
  struct Outputs
  {
    int First = 0;
    int Count = 0;
    bool Bounds = false;
  };
  vtkFourierOpacityStage SumImportance(const Outputs& outputs) const;
  vtkFourierOpacityStage FindOpacities() const;
  vtkFourierOpacityStage DrawOpaqueLayer() const;
  vtkFourierOpacityStage SumOpticalDepth(const Outputs& outputs) const;
  vtkFourierOpacityStage AddColors() const;
  static vtkFourierOpacityStage Select();
  vtkFourierOpacityStage ListImportance() const;
  vtkFourierOpacityStage ListColors() const;

  /// Fragment shaders of quads.
  std::string Widen() const;
  /// The result; colours multiplied by opacity, for sums of pictures, or not.
  std::string Finish(bool multiplied) const;
  /// The mean of pictures from their sum.
  std::string ShowMean() const;
  /// What walks a sorted list of fragments: finds opacities, or blends colours.
  std::string ResolveImportance() const;
  static std::string ResolveColors();

private:
  std::string GetDeclarations(bool readsSums) const;
  std::string WriteSums(const Outputs& outputs) const;
  /// What stages that draw with opacity have in common; code that leaves out what the opaque layer
  /// has, and code that finds the depth among the terms of the series.
  vtkFourierOpacityStage BeginStage(vtkFourierOpacityStage::KindType kind) const;
  std::string DiscardOpaque() const;
  std::string FindDepth() const;
  /// The same at the resolution of the sums, without what is hidden.
  std::string FindReducedDepth() const;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityStages.h
