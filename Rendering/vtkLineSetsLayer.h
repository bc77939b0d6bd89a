// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsLayer
 * @brief   draws a picture with depth into whatever render pass is active
 *
 * A mapper that has ray cast its picture (colour with opacity, and depth) hands it to this class,
 * which draws it as one quad over the viewport. The quad's shader has VTK's tags, so that the
 * render passes that the prop's property keys name (vtkOpenGLRenderPass::RenderPasses()) can insert
 * their code as they do with polygons: order-independent translucency, dual depth peeling. Blend
 * and depth state are the pass's own and are left alone. Pixels of opacity 0 are discarded, and
 * the picture's depth is written, so that other props intersect the layer rightly.
 *
 * The layer keeps its textures between draws and nothing else: programs stay in the window's
 * shader cache, so that a change of window or of pass needs no care.
 */

#ifndef vtkLineSetsLayer_h
#define vtkLineSetsLayer_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <string>

class vtkAbstractMapper;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkLineSetsLayer
{
public:
  vtkLineSetsLayer();
  ~vtkLineSetsLayer();

  /**
   * Take a picture from memory: four bytes of colour, not multiplied by opacity, and one depth (0
   * to 1) per pixel, row by row from the bottom. Returns false where the textures cannot be made.
   */
  bool SetPicture(vtkOpenGLRenderWindow* window, int width, int height, const std::uint8_t* color,
    const float* depth);

  /// Take a picture that already lies in textures, RGBA and one float of depth; they are not
  /// copied.
  void SetTextures(vtkTextureObject* color, vtkTextureObject* depth);

  /// Whether there is a picture that lies on the graphics device still.
  bool HasPicture() const;

  /**
   * Draw the picture with its first pixel on pixel (originX, originY) of the framebuffer that is
   * bound for drawing. mapper and prop are what the active render passes are told. depthOffset is
   * added to every depth. Returns an empty string, or else what went wrong.
   */
  std::string Draw(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop,
    int originX, int originY, float depthOffset = 0.0f);

  /// Bytes of the textures of SetPicture().
  vtkIdType GetNumberOfBytes() const;

  /// Release the textures; may be called several times.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkLineSetsLayer(const vtkLineSetsLayer&) = delete;
  void operator=(const vtkLineSetsLayer&) = delete;

  vtkShaderProgram* ReadyProgram(
    vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, vtkProp* prop, std::string& error);

  vtkNew<vtkTextureObject> OwnColor;
  vtkNew<vtkTextureObject> OwnDepth;
  // What is drawn: the two above, or somebody else's.
  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsLayer.h
