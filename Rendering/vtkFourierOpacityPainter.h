// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityPainter
 * @brief   optimizes the opacity of some actors in a view, and blends them
 *
 * For each picture, as in Baeza Rojo et al., 2019, Sec. 4.2:
 * 1. All geometry is drawn at reduced resolution. Squared importance is added to the sums of each
 *    pixel; the nearest and the farthest depth are kept (vtkFourierOpacityTargets).
 * 2. It is drawn again: each fragment finds its optimal opacity from the sums, and each element
 *    keeps the smallest one.
 * 3. These are read back, smoothed over neighbours and in time (vtkFourierOpacityElements), and
 *    given to the vertices.
 * 4. What counts as opaque is drawn as a layer with depth, which hides what is behind it.
 * 5. The rest is drawn twice: optical depth is added to the sums, which several pixels may share,
 *    then colours are added with their weights, which the sums tell; where sums are shared, the
 *    optical depth of each pixel is added up beside its colours.
 * 6. Colours are divided by their weights and laid over the opaque layer.
 *
 * Steps 1 and 2, and step 5, have exact counterparts by vtkFragmentLists.
 */

#ifndef vtkFourierOpacityPainter_h
#define vtkFourierOpacityPainter_h

#include "vtkFourierOpacityFrame.h"
#include "vtkFourierOpacitySteps.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <list>
#include <memory>
#include <string>
#include <vector>

struct vtkFourierOpacityGroup;
class vtkOpacityOptimization;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

class vtkFourierOpacityPainter
{
public:
  vtkFourierOpacityPainter();
  ~vtkFourierOpacityPainter();

  using Item = vtkFourierOpacityItem;

  /// Where the picture goes.
  enum DestinationType
  {
    Picture,    ///< textures, GetColor() and GetDepth()
    Framebuffer ///< the one that is bound for drawing, over what it holds
  };

  /**
   * Make the picture of some actors, before and behind what the framebuffer bound for reading
   * holds. Returns an empty string, or else why nothing was drawn; a warning tells what is not
   * right with what was drawn. Bindings and state are restored.
   */
  std::string Draw(vtkRenderer* renderer, const std::vector<Item>& items,
    vtkOpacityOptimization* optimization, const vtkFourierOpacityDrawFunction& drawItem,
    DestinationType destination, std::string& warning);

  /// The picture: colour, not multiplied by opacity, and depth from 0 to 1.
  vtkTextureObject* GetColor() const { return this->Steps.Targets.Color; }
  vtkTextureObject* GetDepth() { return this->Steps.GetPictureDepth(); }

  /**
   * Describe how a selection draws an item, and make its opacities readable until EndSelection().
   * Returns false where the renderer's last picture had no such item with these elements.
   */
  bool BeginSelection(vtkRenderer* renderer, const Item& item,
    const vtkFourierOpacityGroup& elements, vtkFourierOpacityStage& stage);
  void EndSelection();

  /// Forget what elements were like in earlier pictures.
  void ForgetOpacities();

  /// Bytes on the graphics device: of all, and of the sums alone.
  vtkIdType GetNumberOfBytes() const;
  vtkIdType GetNumberOfSumBytes() const { return this->Steps.Targets.GetNumberOfSumBytes(); }

  /// Fragments of the last picture that was made with lists: all of them, those that were dropped
  /// for want of memory, and the mean over the pixels that have any.
  vtkIdType GetNumberOfFragments() const { return this->Steps.GetLists().GetNumberOfFragments(); }
  vtkIdType GetNumberOfDroppedFragments() const
  {
    return this->Steps.GetNumberOfDroppedFragments();
  }
  /// Number of pictures whose mean was drawn last.
  int GetNumberOfAccumulatedPictures() const { return this->NumberOfAccumulatedPictures; }
  double GetMeanDepthComplexity() const { return this->Steps.GetLists().GetMeanNumberPerPixel(); }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkFourierOpacityPainter(const vtkFourierOpacityPainter&) = delete;
  void operator=(const vtkFourierOpacityPainter&) = delete;

  struct View;

  std::string Check(vtkOpenGLRenderWindow* window);
  View& GetView(vtkRenderer* renderer, vtkActor* actor);
  void PrepareView(View& view, vtkFourierOpacityFrame& frame);
  std::string Accumulate(View& view, vtkFourierOpacityFrame& frame);
  std::string Show(View& view, vtkFourierOpacityFrame& frame);

  vtkFourierOpacitySteps Steps;
  std::list<std::unique_ptr<View>> Views;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  int NumberOfAccumulatedPictures = 0;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityPainter.h
