// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityPass
 * @brief   optimizes the opacity of all actors of a renderer together
 *
 * Points, lines and surfaces of several actors, each with a vtkFourierOpacityMapper, fade for each
 * other, and are blended with each other in the order of their depth, before and behind opaque
 * actors. It takes the place of the translucent pass:
 *
 * @code{.cpp}
 * vtkNew<vtkFourierOpacityPass> pass;
 * pass->GetOptimization()->SetForegroundWeight(100.0);
 * vtkNew<vtkRenderStepsPass> steps;
 * steps->SetTranslucentPass(pass);
 * renderer->SetPass(steps);
 * @endcode
 *
 * The parameters are those of the pass; what the mappers have for themselves has no effect. What is
 * important is told by each mapper's array.
 *
 * <b>Other translucent props</b> have no part in this: TranslucentPass draws them afterwards, over
 * what this pass has drawn, whatever their depth. A warning tells their number, once.
 *
 * <b>Selection.</b> vtkHardwareSelector selects nothing in VTK while a renderer has a render pass:
 * set the renderer's pass to nullptr for the time of the selection. What was faint in the last
 * picture of this pass is then left out, as vtkFourierOpacityMapper tells.
 *
 * <b>Needs</b> OpenGL 4.2. Where there is less, or no memory, an error says so, once, and the
 * actors are not drawn.
 *
 * @sa vtkFourierOpacityMapper vtkOpacityOptimization vtkRenderStepsPass
 */

#ifndef vtkFourierOpacityPass_h
#define vtkFourierOpacityPass_h

#include "vtkRenderPass.h"
#include "vtkRenderingLineSetsModule.h" // For export macro

#include <memory> // For std::unique_ptr

class vtkOpacityOptimization;

class VTKRENDERINGLINESETS_EXPORT vtkFourierOpacityPass : public vtkRenderPass
{
public:
  static vtkFourierOpacityPass* New();
  vtkTypeMacro(vtkFourierOpacityPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How opacity is optimized; may be shared. Default: an object of the pass's own; nullptr brings
   * such a one back.
   */
  virtual void SetOptimization(vtkOpacityOptimization* optimization);
  vtkOpacityOptimization* GetOptimization();
  ///@}

  ///@{
  /**
   * Draws translucent props whose mapper is no vtkFourierOpacityMapper. Default a
   * vtkTranslucentPass; with nullptr they are not drawn.
   */
  virtual void SetTranslucentPass(vtkRenderPass* pass);
  vtkRenderPass* GetTranslucentPass();
  ///@}

  /**
   * Forget the opacities of earlier pictures. What a picture does not show keeps them, and its
   * neighbours are smoothed with it, so that a picture depends on those before it; the next one
   * does not.
   */
  void ForgetOpacities();

  /// Bytes on the graphics device for sums, layers and opacities; and those of the sums alone,
  /// which the paper counts. 0 before the first picture.
  vtkIdType GetNumberOfBytes();
  vtkIdType GetNumberOfSumBytes();

  ///@{
  /**
   * Fragments of the last picture that was made with lists: their number, the number of those that
   * were dropped since they did not fit (a warning tells it), and their mean number over the pixels
   * that have any.
   */
  vtkIdType GetNumberOfFragments();
  vtkIdType GetNumberOfDroppedFragments();
  double GetMeanDepthComplexity();
  ///@}

  /// Number of pictures whose mean was drawn last (AccumulationFrames); 0 before the first one.
  int GetNumberOfAccumulatedPictures();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkFourierOpacityPass();
  ~vtkFourierOpacityPass() override;

private:
  vtkFourierOpacityPass(const vtkFourierOpacityPass&) = delete;
  void operator=(const vtkFourierOpacityPass&) = delete;

  void DrawOthers(const vtkRenderState* state);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
