// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityTargets
 * @brief   the textures that the stages of opacity optimization draw to and read from
 *
 * Sums lie four to a texture, the last ones two and one to a texture, so that no memory is left
 * idle. Those of importance lie in a corner of those of optical depth, which are needed later.
 */

#ifndef vtkFourierOpacityTargets_h
#define vtkFourierOpacityTargets_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

class vtkFourierOpacityTargets
{
public:
  vtkFourierOpacityTargets();
  ~vtkFourierOpacityTargets();

  struct Layout
  {
    int Size[2] = { 0, 0 };     ///< of the picture
    int Sums = 0;               ///< number of sums per pixel
    int SumsSize[2] = { 0, 0 }; ///< pixels that have sums
    bool HasBounds = false;     ///< of depth
    int BoundsSize[2] = { 0, 0 };
    int WidenedSize[2] = { 0, 0 };
    bool HasHalfFloats = false; ///< colours and sums but the first one
    bool HasTotals = false;     ///< optical depth of each pixel, apart from the sums
    bool HasCounts = false;     ///< number and optical depth of fragments (weighted ways)
    bool HasOpaqueLayer = false;
    bool HasPicture = false; ///< colour of the result
  };

  /// Components of the textures of so many sums: 4, 4, ..., 2, 1. Where half floats hold all but
  /// the first sum, that one comes first by itself.
  static std::vector<int> GetComponents(int sums, bool halfFloats);

  /// Make textures, or what is missing. Returns an empty string, or what there was no memory for.
  std::string Prepare(vtkOpenGLRenderWindow* window, const Layout& layout);

  std::vector<vtkSmartPointer<vtkTextureObject>> Sums;
  vtkNew<vtkTextureObject> Bounds;  ///< 1 - nearest depth, farthest depth; of each pixel
  vtkNew<vtkTextureObject> Widened; ///< the same, of each pixel and those around it
  vtkNew<vtkTextureObject> Colors;  ///< sum of weighted colours, and of weights
  vtkNew<vtkTextureObject> Counts;
  vtkNew<vtkTextureObject> Totals; ///< optical depth of each pixel, where sums are reduced
  vtkNew<vtkTextureObject> Opaque;
  vtkNew<vtkTextureObject> Color;

  /**
   * Draw to textures, with the scene's depth for depth tests or without. The framebuffer stays
   * bound until the caller restores bindings.
   */
  void Bind(const std::vector<vtkTextureObject*>& textures, vtkTextureObject* depth);

  /// Make a texture of sums of colours for others, or resize it; returns whether there was memory.
  static bool MakeColors(
    vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const int size[2]);
  static vtkIdType GetNumberOfColorBytes(vtkTextureObject* texture);

  /// Bytes of all textures, and of the sums alone.
  vtkIdType GetNumberOfBytes() const;
  vtkIdType GetNumberOfSumBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkFourierOpacityTargets(const vtkFourierOpacityTargets&) = delete;
  void operator=(const vtkFourierOpacityTargets&) = delete;

  /// Keep a texture, make it anew with another size or format, or let it go.
  bool Keep(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, bool wanted,
    const int size[2], unsigned int format);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  /// Format of each texture, for those that were ever asked for.
  std::map<vtkTextureObject*, unsigned int> Formats;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityTargets.h
