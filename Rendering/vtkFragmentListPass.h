// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFragmentListPass
 * @brief   draws translucent props exactly, whatever their number and order
 *
 * All translucent fragments of a pixel are stored on the graphics device, sorted by depth and
 * blended from front to back; what comes out is blended over what the framebuffer holds. Unlike
 * depth peeling the picture needs no number of layers, and the geometry is drawn twice only, once
 * to count the fragments and once to store them (Carpenter, "The A-buffer, an antialiased hidden
 * surface method", SIGGRAPH 1984; Yang, Hensley, Grün and Thibieroz, "Real-time concurrent linked
 * list construction on the GPU", Computer Graphics Forum 29(4), 2010; here each pixel's fragments
 * lie next to each other instead of being linked). Where they take more memory than
 * MaximumNumberOfBytes, the picture is drawn in strips of pixel rows, once per strip, with the same
 * result.
 *
 * The pass takes the place of the translucent one:
 *
 * @code{.cpp}
 * vtkNew<vtkFragmentListPass> lists;
 * vtkNew<vtkRenderStepsPass> steps;
 * steps->SetTranslucentPass(lists);
 * vtkOpenGLRenderer::SafeDownCast(renderer)->SetPass(steps);
 * @endcode
 *
 * In a vtkSequencePass it comes after the opaque pass. It draws the translucent polygonal geometry
 * of all props whose shaders have VTK's tags for depth peeling: those of vtkPolyDataMapper and of
 * this module's mappers among others.
 *
 * <b>What is exact.</b> Opacities and depths are stored as the shaders give them, in single
 * precision; components of colour, after lighting, with a relative error below 1e-4. Fragments of
 * equal depth are ordered by colour and opacity, so that no order of props and cells makes a
 * difference to any bit. Fragments are taken at the middle of a pixel, also where the window has
 * several samples per pixel: edges of translucent props are not smoothed, as with VTK's other
 * passes. Fragments behind opaque props are not stored.
 *
 * <b>What may be missing.</b> The pass needs OpenGL 4.2, or 3.3 with
 * GL_ARB_shader_image_load_store. Where that is missing, or there is no memory, an error says so
 * once, and the delegate draws alone, blending in the order of the props; so it does for a hardware
 * selector (which VTK heeds only in renderers without a pass). A pixel row whose fragments do not
 * fit into MaximumNumberOfBytes loses some: NumberOfDroppedFragments tells how many, and a warning
 * whenever the number changes.
 *
 * @sa vtkDualDepthPeelingPass vtkOrderIndependentTranslucentPass vtkRenderStepsPass
 */

#ifndef vtkFragmentListPass_h
#define vtkFragmentListPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkOpenGLRenderWindow;

class VTKRENDERINGLINESETS_EXPORT vtkFragmentListPass : public vtkOpenGLRenderPass
{
public:
  static vtkFragmentListPass* New();
  vtkTypeMacro(vtkFragmentListPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The pass that draws the translucent props, called once to count and once per strip to store.
   * Default: a vtkTranslucentPass. With nullptr nothing is drawn, and a warning says so.
   */
  virtual void SetTranslucentPass(vtkRenderPass* pass);
  vtkRenderPass* GetTranslucentPass();
  ///@}

  ///@{
  /**
   * Largest size of the buffer of fragments on the graphics device in bytes, 16 per fragment.
   * Default: 1073741824 (1 GiB); 16 at least. Buffers that need more than the limit, or than
   * OpenGL's own (GL_MAX_TEXTURE_BUFFER_SIZE fragments), are filled strip by strip of the picture.
   */
  virtual void SetMaximumNumberOfBytes(vtkIdType bytes);
  vtkGetMacro(MaximumNumberOfBytes, vtkIdType);
  ///@}

  ///@{
  /**
   * About the last picture: the number of fragments, the largest number of them in one pixel, their
   * mean over the pixels that have any, and the strips that the picture took. 0 where nothing was
   * translucent or the delegate drew alone.
   */
  vtkGetMacro(NumberOfFragments, vtkIdType);
  vtkGetMacro(LargestDepthComplexity, vtkIdType);
  vtkGetMacro(MeanDepthComplexity, double);
  vtkGetMacro(NumberOfStrips, int);
  ///@}

  /**
   * Number of fragments of the last picture that are missing in it: those of their pixel row did
   * not fit into MaximumNumberOfBytes, or a prop drew more of them for storing than for counting,
   * or software OpenGL (Mesa's llvmpipe) ended blending after 65535 fragments of a pixel.
   */
  vtkGetMacro(NumberOfDroppedFragments, vtkIdType);

  /// Bytes on the graphics device that the pass holds.
  vtkIdType GetNumberOfBytes();

  ///@{
  /// Called by the renderer and the mappers.
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  ///@}

protected:
  vtkFragmentListPass();
  ~vtkFragmentListPass() override;

  vtkIdType MaximumNumberOfBytes = vtkIdType(1) << 30;
  vtkIdType NumberOfFragments = 0;
  vtkIdType NumberOfDroppedFragments = 0;
  vtkIdType LargestDepthComplexity = 0;
  double MeanDepthComplexity = 0.0;
  int NumberOfStrips = 0;

private:
  vtkFragmentListPass(const vtkFragmentListPass&) = delete;
  void operator=(const vtkFragmentListPass&) = delete;

  void RenderDelegate(const vtkRenderState* state);
  std::string RenderLists(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
  std::string CountFragments(const vtkRenderState* state, vtkOpenGLRenderWindow* window);
  void StoreFragments(const vtkRenderState* state, vtkOpenGLRenderWindow* window, int strip);
  std::string BlendFragments(vtkOpenGLRenderWindow* window);
  void UpdateStatistics();
  void ReportErrorOnce(const std::string& error);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
