// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityStage
 * @brief   one of the draws of all geometry of which a picture with optimized opacity is made
 *
 * vtkFourierOpacityPainter describes it, and vtkFourierOpacityMapper draws its geometry with
 * shaders that vtkFourierOpacityShader makes of the description.
 */

#ifndef vtkFourierOpacityStage_h
#define vtkFourierOpacityStage_h

#include <functional>
#include <string>

class vtkShaderProgram;

struct vtkFourierOpacityStage
{
  enum KindType
  {
    ImportanceSums, ///< squared importance into the sums of a pixel, and bounds of the depth
    Opacities,      ///< optimal opacity of fragments, of which each element keeps the smallest
    ImportanceList, ///< importance and element of each fragment into lists
    OpaqueLayer,    ///< colours of fragments that count as opaque
    OpticalDepth,   ///< optical depth into the sums of a pixel
    Colors,         ///< weighted colours
    ColorList,      ///< colours and opacities of each fragment into lists
    Selection       ///< what vtkHardwareSelector draws, without what is too faint to be seen
  };
  KindType Kind = ImportanceSums;

  /// Extensions of GLSL that the fragment shader needs, as directives.
  std::string Extensions;
  /// Declarations for the fragment shader.
  std::string Declarations;
  /// Code for the fragment shader's main function; it writes the outputs. %OPACITY, %COLOR and %Z
  /// stand for opacity, colour and depth of the fragment.
  std::string Code;

  /// Whether the shaders need the importance of a fragment, its element, its opacity.
  bool NeedsImportance = false;
  bool NeedsElement = false;
  bool NeedsOpacity = false;
  bool WritesDepth = false;
  /// Smallest opacity of what is drawn, as text of GLSL; empty where all is drawn. Points of less
  /// are left out before they are made fragments of.
  std::string LeastOpacity;
  /// Pixels of a row of the full picture to one of the picture that it draws.
  int Reduction = 1;
  /// The same to one of the sums that it adds to or reads; how much of that a fragment covers is
  /// what the shader finds in fourierCoverage.
  int SumReduction = 1;
  /// Width of the halos of lines in pixels; 0 where there are none.
  double HaloWidth = 0.0;
  /// How far they lean back, as a part of the range of depths.
  double HaloDepth = 0.0;

  /// Set what the shaders need in the program in use.
  std::function<void(vtkShaderProgram*)> SetParameters;

  /// First element of the mapper that draws, among those of all.
  int FirstElement = 0;

  /// Tells shaders apart that differ; MakeKey() sets it when all else is set.
  std::size_t Key = 0;
  void MakeKey()
  {
    this->Key =
      std::hash<std::string>()(std::to_string(this->Kind) + (this->HaloWidth > 0.0 ? "halo" : "") +
        this->LeastOpacity + this->Extensions + this->Declarations + this->Code);
  }
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityStage.h
