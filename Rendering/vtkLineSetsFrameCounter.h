// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLineSetsFrameCounter
 * @brief   tells a new frame of a renderer from another pass of the same one
 *
 * Depth peeling asks a mapper to draw once per peel. The mapper ray casts the first time and
 * replays its picture then, so it must know when the renderer starts anew: it announces that by
 * vtkCommand::StartEvent, which this class counts.
 */

#ifndef vtkLineSetsFrameCounter_h
#define vtkLineSetsFrameCounter_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <vector>

class vtkRenderer;

class vtkLineSetsFrameCounter
{
public:
  vtkLineSetsFrameCounter();
  ~vtkLineSetsFrameCounter();

  /**
   * A number that is different in every frame of the renderer and, in the first call for a
   * renderer, different from all before.
   */
  vtkIdType GetFrame(vtkRenderer* renderer);

  /// Whether the renderer is drawing a frame; true before its first one ends.
  bool IsInFrame(vtkRenderer* renderer);

private:
  vtkLineSetsFrameCounter(const vtkLineSetsFrameCounter&) = delete;
  void operator=(const vtkLineSetsFrameCounter&) = delete;

  struct Entry
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    unsigned long StartTag = 0;
    unsigned long EndTag = 0;
    bool InFrame = true;
    vtkIdType Frame = 0;
    vtkIdType* Next = nullptr;
  };
  Entry& GetEntry(vtkRenderer* renderer);

  std::vector<std::unique_ptr<Entry>> Entries;
  vtkIdType Next = 0;
};

#endif

// VTK-HeaderTest-Exclude: vtkLineSetsFrameCounter.h
