// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsSceneDepth
 * @brief   depth of what has been drawn so far, for rays that must stop there
 *
 * It reads from the framebuffer that is bound for reading: in plain rendering that is the one drawn
 * to; order-independent translucency binds its own, which holds a copy of the opaque depth, for
 * both; dual depth peeling draws to its own but leaves the renderer's bound for reading. A
 * framebuffer with several samples per pixel is resolved first. Bindings are restored.
 */

#ifndef vtkLineSetsSceneDepth_h
#define vtkLineSetsSceneDepth_h

#include "vtkNew.h"
#include "vtkType.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkLineSetsSceneDepth
{
public:
  vtkLineSetsSceneDepth();
  ~vtkLineSetsSceneDepth();

  /**
   * Where the current viewport's first pixel lies in the framebuffer bound for reading: viewport is
   * GL's, tiledOrigin the renderer's (vtkViewport::GetTiledSizeAndOrigin()).
   */
  static void GetReadOrigin(vtkOpenGLRenderWindow* window, const int viewport[4],
    const int tiledOrigin[2], int readOrigin[2]);

  /// Smallest distance of two depths that Read() and Copy() tell apart, 0 where the framebuffer
  /// bound for reading holds the floating point numbers that were drawn.
  static double GetReadStep(vtkOpenGLRenderWindow* window);

  /// Read the depths of a rectangle, row by row from the bottom, 0 to 1.
  bool Read(vtkOpenGLRenderWindow* window, const int origin[2], int width, int height,
    std::vector<float>& depth);

  /**
   * Copy the depths of a rectangle into a texture, which stays the property of this object;
   * nullptr on failure.
   */
  vtkTextureObject* Copy(vtkOpenGLRenderWindow* window, const int origin[2], int width, int height);

  /// The texture that Copy() returned last; it has no handle before.
  vtkTextureObject* GetTexture() { return this->Texture; }

  /// Depths of the texture that Copy() returned, as Read() gives them; none for nullptr.
  static std::vector<float> Download(vtkTextureObject* texture);

  /// Bytes of the texture.
  vtkIdType GetNumberOfBytes() const;

  /// Release the texture; may be called several times.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkLineSetsSceneDepth(const vtkLineSetsSceneDepth&) = delete;
  void operator=(const vtkLineSetsSceneDepth&) = delete;

  vtkNew<vtkTextureObject> Texture;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsSceneDepth.h
