// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityFrame
 * @brief   one picture with optimized opacity: what it is of, and how its stages are drawn
 */

#ifndef vtkFourierOpacityFrame_h
#define vtkFourierOpacityFrame_h

#include "vtkFourierOpacityStage.h"
#include "vtkFourierOpacityStages.h"
#include "vtkFourierOpacityView.h"
#include "vtkLineSetsActiveTextures.h"

#include <functional>
#include <vector>

class vtkActor;
class vtkFourierOpacityElements;
class vtkFourierOpacityMapper;
class vtkFragmentLists;
class vtkOpacityOptimization;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;

struct vtkFourierOpacityItem
{
  vtkActor* Actor = nullptr;
  vtkFourierOpacityMapper* Mapper = nullptr;
};

/// Draws one item with the shaders of a stage.
using vtkFourierOpacityDrawFunction =
  std::function<void(const vtkFourierOpacityItem&, const vtkFourierOpacityStage&)>;

struct vtkFourierOpacityFrame
{
  /// The image unit of the smallest opacities; fragment lists use the first units.
  static constexpr unsigned int SmallestUnit = 7;

  vtkFourierOpacityFrame(vtkRenderer* renderer, const std::vector<vtkFourierOpacityItem>& items,
    vtkOpacityOptimization* optimization, const vtkFourierOpacityDrawFunction& drawItem,
    const vtkFourierOpacityView& view, vtkFourierOpacityElements& elements);

  /// Set what the program in use asks for.
  void SetParameters(vtkShaderProgram* program) const;

  /// Whether opacities follow from this picture, which is not so in those that follow the first one
  /// in a sum.
  bool FindsOpacities() const { return this->Number <= 0 && !this->KeepsOpacities; }

  /// Draw all items.
  void DrawStage(vtkFourierOpacityStage& stage);

  vtkOpenGLRenderWindow* Window;
  vtkOpenGLState* State;
  const std::vector<vtkFourierOpacityItem>& Items;
  vtkOpacityOptimization* Optimization;
  const vtkFourierOpacityDrawFunction& DrawItem;
  vtkFourierOpacityView Now;
  vtkFourierOpacityStages Stages;
  vtkFourierOpacityElements& Elements;
  /// Depth of the scene, and of the opaque layer from when on that is drawn.
  vtkTextureObject* Scene = nullptr;
  /// Size of the pictures of the importance and of the sums of optical depth.
  int ReducedSize[2] = { 0, 0 };
  int DepthSize[2] = { 0, 0 };
  /// Textures to which one draw can write.
  int MostTargets = 8;
  /// What part of the way to their new values opacities go.
  double Blend = 1.0;
  int ElementShift = 0;
  /// The lists that fragments are drawn into, or null.
  vtkFragmentLists* Lists = nullptr;
  /// Whether the result goes to textures of its own.
  bool HasPicture = true;
  /// Number of pictures in the sum before this one; -1 where pictures are not summed up.
  int Number = -1;
  /// Whether this is a tile of a larger picture, and has the opacities of the whole view, of which
  /// it shows too little to find them.
  bool IsTile = false;
  bool KeepsOpacities = false;
  float MeanFactor = 1.0f;
  float Shift[2] = { 0.0f, 0.0f };
  /// Pixel of the framebuffer on which the picture's first one falls.
  int Origin[2] = { 0, 0 };
  vtkLineSetsActiveTextures Textures;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityFrame.h
