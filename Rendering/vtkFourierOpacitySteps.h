// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacitySteps
 * @brief   the steps of a picture with optimized opacity, and what they keep on the graphics device
 *
 * vtkFourierOpacityPainter tells the steps and when they are taken.
 */

#ifndef vtkFourierOpacitySteps_h
#define vtkFourierOpacitySteps_h

#include "vtkFourierOpacityFrame.h"
#include "vtkFourierOpacityTargets.h"
#include "vtkFragmentLists.h"
#include "vtkLineSetsBufferTexture.h"
#include "vtkLineSetsSceneDepth.h"

#include <string>
#include <vector>

class vtkTextureObject;
class vtkWindow;

class vtkFourierOpacitySteps
{
public:
  vtkFourierOpacitySteps();
  ~vtkFourierOpacitySteps();

  // Each of these returns an empty string, or what went wrong.

  /// Make room for a picture.
  std::string Prepare(vtkFourierOpacityFrame& frame);
  /// Take all steps but the last one. The scene is at a pixel of the framebuffer bound for reading.
  std::string MakePicture(vtkFourierOpacityFrame& frame, const int origin[2]);
  /// Take the last step: draw the result to what is bound, multiplied by opacity for sums.
  std::string Finish(vtkFourierOpacityFrame& frame);
  /// Draw a quad with a shader.
  std::string DrawQuad(vtkFourierOpacityFrame& frame, const std::string& source);

  /// Draw to the picture: the colour that Targets have, and depths in place of the scene's, which
  /// are needed no more.
  void BindPicture();
  vtkTextureObject* GetPictureDepth() { return this->SceneDepth.GetTexture(); }

  vtkFourierOpacityTargets Targets;

  /// Make opacities readable, those of the last picture or those of other elements; 2^shift
  /// elements share a place.
  vtkLineSetsBufferTexture& GetOpacities() { return this->Opacities; }
  std::string UploadOpacities(
    vtkOpenGLRenderWindow* window, const vtkFourierOpacityElements& elements);
  static int GetElementShift(
    vtkOpenGLRenderWindow* window, const vtkFourierOpacityElements& elements);

  const vtkFragmentLists& GetLists() const { return this->Lists; }
  vtkIdType GetNumberOfDroppedFragments() const { return this->NumberOfDroppedFragments; }
  vtkIdType GetNumberOfBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkFourierOpacitySteps(const vtkFourierOpacitySteps&) = delete;
  void operator=(const vtkFourierOpacitySteps&) = delete;

  std::string UploadValues(
    vtkOpenGLRenderWindow* window, const std::vector<float>& values, unsigned int format);
  void AddSumTextures(vtkFourierOpacityFrame& frame);
  void SumImportance(vtkFourierOpacityFrame& frame);
  std::string FindOpacities(vtkFourierOpacityFrame& frame);
  void DrawOpaqueLayer(vtkFourierOpacityFrame& frame);
  std::string Widen(vtkFourierOpacityFrame& frame);
  void SumOpticalDepth(vtkFourierOpacityFrame& frame);
  void AddColors(vtkFourierOpacityFrame& frame);
  std::string ListColors(vtkFourierOpacityFrame& frame);
  std::string DrawLists(vtkFourierOpacityFrame& frame, vtkFourierOpacityStage& stage,
    const int size[2], vtkTextureObject* target, const std::string& resolve);

  vtkLineSetsSceneDepth SceneDepth;
  vtkFragmentLists Lists;
  /// The smallest opacities of elements while they are found; then those that are shown.
  vtkLineSetsBufferTexture Opacities;
  std::vector<float> Values;
  vtkIdType NumberOfDroppedFragments = 0;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacitySteps.h
