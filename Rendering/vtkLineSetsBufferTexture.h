// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsBufferTexture
 * @brief   a buffer on the graphics device and the texture through which a shader reads it
 *
 * The context of the window must be current when it is uploaded to. It is made current where the
 * buffer is released or deleted, and where it has gone, the buffer is left behind.
 */

#ifndef vtkLineSetsBufferTexture_h
#define vtkLineSetsBufferTexture_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstddef>

class vtkOpenGLBufferObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkLineSetsBufferTexture
{
public:
  vtkLineSetsBufferTexture();
  ~vtkLineSetsBufferTexture();

  /**
   * Upload a number of texels, each of some components of a type (VTK_FLOAT and so on) and
   * size in bytes, with an internal format of OpenGL. Returns whether there was memory for them.
   */
  bool Upload(vtkOpenGLRenderWindow* window, const void* data, std::size_t texels,
    std::size_t componentSize, unsigned int format, int components, int vtkType);

  /**
   * Make room for a number of texels, whose values are undefined, in the same manner; for shaders
   * that write.
   */
  bool Allocate(vtkOpenGLRenderWindow* window, std::size_t texels, std::size_t componentSize,
    unsigned int format, int components, int vtkType);

  /// Bind it to a texture unit, if the program reads a sampler of that name: the compiler may have
  /// removed it.
  void Activate(vtkShaderProgram* program, const char* name);
  void Deactivate();

  /// Copy the buffer's first bytes back from the graphics device.
  void Download(void* data, std::size_t bytes);

  /// The texture, for others to activate.
  vtkTextureObject* GetTexture() const;

  /// OpenGL's name of the texture, 0 for none; for image units, of which VTK knows nothing.
  unsigned int GetHandle() const;

  /// Whether its texture has gone with its context, after it was uploaded.
  bool IsGone() const;

  void Release(vtkWindow* window);

  /// Leave the buffer behind without an owner: it went with its context, and must not be deleted by
  /// number in another one, which its destructor would do.
  void Forget();

  /// Clear OpenGL's errors before a call that is to be checked: those of others are theirs to
  /// report. Returns false where they do not end.
  static bool ForgetGLErrors();

  /// Bytes on the graphics device.
  std::size_t GetNumberOfBytes() const { return this->Bytes; }

private:
  vtkLineSetsBufferTexture(const vtkLineSetsBufferTexture&) = delete;
  void operator=(const vtkLineSetsBufferTexture&) = delete;

  bool CreateTexture(vtkOpenGLRenderWindow* window, std::size_t texels, unsigned int format,
    int components, int vtkType);

  vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  vtkSmartPointer<vtkTextureObject> Texture;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::size_t Bytes = 0;
};

#endif
