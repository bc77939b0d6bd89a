// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFourierOpacityElements
 * @brief   opacities of the elements of all mappers that are drawn together, over the frames
 *
 * Of each element it keeps the smallest opacity of its fragments in the last frame in which it was
 * seen. One that was never seen, as those between the points of a coarse line, has that of the
 * nearest ones that were, or is opaque where there is none. These are smoothed over neighbours, and
 * the result may follow them in time. One object serves one view.
 */

#ifndef vtkFourierOpacityElements_h
#define vtkFourierOpacityElements_h

#include "vtkOpacitySmoothingPrivate.h"
#include "vtkRenderingLineSetsModule.h" // For export macro
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkIntArray;

/// Elements of one mapper.
struct vtkFourierOpacityGroup
{
  /// Whose elements, as the painter tells: compared, never followed; and when they were made.
  const void* Owner = nullptr;
  vtkMTimeType BuildTime = 0;
  vtkIdType Count = 0;
  /// Pairs of neighbours, or null.
  vtkIntArray* Neighbors = nullptr;
};

class VTKRENDERINGLINESETS_EXPORT vtkFourierOpacityElements
{
public:
  /// What fragments of an element that was not seen leave in its place.
  static constexpr float NotSeen = 2.0f;

  vtkFourierOpacityElements();
  ~vtkFourierOpacityElements();

  /// Take the elements that are drawn now, group by group. What is known of groups that were there
  /// before is kept.
  void SetGroups(const std::vector<vtkFourierOpacityGroup>& groups);

  vtkIdType GetNumberOfElements() const { return this->Total; }
  std::size_t GetNumberOfGroups() const { return this->States.size(); }
  vtkIdType GetFirstElement(std::size_t group) const { return this->States[group]->First; }

  /// Whether each element has an opacity from a picture before.
  bool AreKnown() const;

  /// Whether these are the elements of a group.
  bool IsGroup(std::size_t group, const vtkFourierOpacityGroup& elements) const;

  /**
   * Take the smallest opacities of a frame. 2^shift elements share a place of the array. blend is
   * the part of the change that is made, 1 for all of it.
   */
  void Update(const std::vector<float>& smallest, int shift, int iterations, double blend);

  /// Opacity of each element, smoothed.
  const std::vector<float>& GetOpacities() const { return this->Shown; }

private:
  vtkFourierOpacityElements(const vtkFourierOpacityElements&) = delete;
  void operator=(const vtkFourierOpacityElements&) = delete;

  struct State
  {
    vtkFourierOpacityGroup Source;
    vtkIdType First = 0;
    std::unique_ptr<vtkOpacitySmoothing> Smoothing;
    std::vector<float> Seen;
    std::vector<unsigned char> WasSeen;
    std::vector<float> Shown;
    bool IsNew = true;
  };

  std::vector<std::unique_ptr<State>> States;
  vtkIdType Total = 0;
  std::vector<float> Shown;
};

#endif

// VTK-HeaderTest-Exclude: vtkFourierOpacityElements.h
