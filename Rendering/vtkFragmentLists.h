// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentLists
 * @brief   all fragments of all pixels on the graphics device, sorted by depth
 *
 * The fragments of a pixel lie next to each other in one buffer, not in a linked list, so that they
 * are sorted where they lie, whatever their number. A picture takes these steps:
 *
 * 1. Begin(), then the geometry is drawn: storeFragment() adds 1 to the pixel's counter.
 * 2. FinishCounting() reads the counters and sums them up over the pixels: the sums are where each
 *    pixel's fragments begin. Pixel rows are gathered to strips whose fragments fit into the
 * buffer.
 * 3. For every strip: BeginStrip(); the geometry is drawn again, and storeFragment() stores the
 *    fragments of the strip; SortStrip() sorts those of each pixel (heap sort); then a quad over
 * the strip is drawn, in whose shader getFragment() gives them out from front to back.
 * 4. End().
 *
 * Fragments of equal depth are ordered by payload, so that pictures depend on no order of drawing.
 * A row that does not fit alone loses what does not fit: in each of its pixels the fragments beyond
 * a number that is the same for all of them; which are lost depends on the order of drawing.
 * All calls from Begin() to End() need the window's context to be current. No framebuffer, test or
 * blending is touched for the caller, who draws where nothing keeps fragments from their shader and
 * where each pixel has one sample.
 */

#ifndef vtkFragmentLists_h
#define vtkFragmentLists_h

#include "vtkLineSetsBufferTexture.h"
#include "vtkNew.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace vtkLineSetsScopedState
{
class SavedImageUnit;
}

class vtkFragmentLists
{
public:
  vtkFragmentLists();
  ~vtkFragmentLists();

  /// What the window's OpenGL lacks; empty where there is all that is needed.
  static std::string GetMissingFeatures(vtkOpenGLRenderWindow* window);

  /**
   * Text for a fragment shader with VTK's tags. The extensions belong right behind the line
   * //VTK::System::Dec; InsertExtensions() puts them there. The store part declares
   * void storeFragment(ivec2 pixel, float depth, uvec3 payload). The read part, for a shader of its
   * own, declares int findFragments(ivec2 pixel), which turns to a pixel and returns the number of
   * its fragments, 0 outside of the strip; uvec4 getFragment(int index), which returns the bits of
   * the depth and the payload; and void dropFragments(int count), to be called for fragments that a
   * loop has not come to, since software OpenGL (Mesa's llvmpipe) ends loops after 65535 turns in
   * all. pixel is counted from the lists' first pixel, wherever the shader draws.
   */
  static std::string GetExtensionSource();
  static std::string GetStoreSource();
  static std::string GetReadSource();
  static void InsertExtensions(std::string& fragmentShader);

  /**
   * Colours as payload: the store part with void storeFragmentColor(ivec2 pixel, float depth, vec4
   * color) (glsl/vtkFragmentListPassStore.glsl), and the fragment shader of a quad that blends them
   * from front to back (glsl/vtkFragmentListPassResolve.glsl).
   */
  static std::string GetColorStoreSource();
  static std::string GetBlendSource();

  /**
   * Largest size of the buffer of fragments in bytes, 16 per fragment; default 1 GiB. OpenGL may
   * have a smaller limit (GL_MAX_TEXTURE_BUFFER_SIZE). Smaller buffers take more strips.
   */
  void SetMaximumNumberOfBytes(std::size_t bytes) { this->MaximumNumberOfBytes = bytes; }

  /**
   * Start a picture of a size in pixels: fragments are counted until FinishCounting(). Returns an
   * empty string, or else what went wrong; then there is nothing to end.
   */
  std::string Begin(vtkOpenGLRenderWindow* window, int width, int height);

  /// Prepare a program that has the store part, before each draw.
  void SetParameters(vtkShaderProgram* program);

  /// Make the strips. Returns an empty string, or else what went wrong; then only End() may follow.
  std::string FinishCounting();

  /// Number of strips, 0 where there are no fragments.
  int GetNumberOfStrips() const { return static_cast<int>(this->Strips.size()); }

  /// Pixel rows of a strip: first, end.
  std::array<int, 2> GetStripRows(int strip) const;

  /// Fragments of the strip are stored from here on.
  void BeginStrip(int strip);

  /**
   * Sort the fragments of each pixel, after those of the strip were stored. Returns an empty
   * string, or else what went wrong; then only End() may follow.
   */
  std::string SortStrip();

  /// Prepare a program that has the read part, for the current strip.
  void SetReadParameters(vtkShaderProgram* program);

  /// Restore OpenGL's image units, and find how many fragments were dropped.
  void End();

  ///@{
  /**
   * About the last picture: fragments, the largest number in a pixel, and their mean over the
   * pixels that have any. GetNumberOfDroppedFragments() counts those that did not fit into the
   * buffer, or were drawn for storing but not for counting, or were told to dropFragments(), and is
   * known after End().
   */
  vtkIdType GetNumberOfFragments() const { return this->NumberOfFragments; }
  vtkIdType GetNumberOfDroppedFragments() const { return this->NumberOfDroppedFragments; }
  vtkIdType GetLargestNumberPerPixel() const { return this->LargestNumberPerPixel; }
  double GetMeanNumberPerPixel() const { return this->MeanNumberPerPixel; }
  ///@}

  /// Bytes on the graphics device.
  vtkIdType GetNumberOfBytes() const;

  /// Release everything, if its context is there still; may be called several times.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkFragmentLists(const vtkFragmentLists&) = delete;
  void operator=(const vtkFragmentLists&) = delete;

  /// Rows, and the number of nodes that they need.
  struct Strip
  {
    int First;
    int End;
    std::size_t Nodes;
  };

  bool IsContextGone() const;
  void Release();
  bool Resize(int width, int height);
  void ClearCounters();
  void MeasureCounters();
  std::size_t GetMaximumNumberOfNodes() const;
  bool LimitRow(int row, std::size_t nodes);
  bool MakeStrips(std::size_t nodes);
  bool UploadRanges();
  bool AllocateNodes(std::size_t maximum);
  void BindImages(vtkShaderProgram* program);
  std::string DrawSort();

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkNew<vtkTextureObject> Room;
  vtkNew<vtkTextureObject> Ranges;
  // One number.
  vtkNew<vtkTextureObject> Dropped;
  vtkLineSetsBufferTexture Nodes;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::size_t MaximumNumberOfBytes = std::size_t(1) << 30;
  int Width = 0;
  int Height = 0;
  bool IsCounting = false;
  // Per pixel, row by row: what was counted, and as much of it as fits.
  std::vector<std::uint32_t> Counters;
  std::vector<Strip> Strips;
  int CurrentStrip = 0;
  // What was bound to image units before; bound again by End().
  std::vector<std::unique_ptr<vtkLineSetsScopedState::SavedImageUnit>> SavedUnits;

  vtkIdType NumberOfFragments = 0;
  vtkIdType NumberOfDroppedFragments = 0;
  vtkIdType LargestNumberPerPixel = 0;
  double MeanNumberPerPixel = 0.0;
};

#endif

// VTK-HeaderTest-Exclude: vtkFragmentLists.h
