// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMergedLineBuffers
 * @brief   index buffers of merged lines (vtkLineMerging) for the last few lengths
 *
 * Lengths are rounded down to powers of the fourth root of two, so that a camera that comes nearer
 * asks for another buffer now and then only.
 */

#ifndef vtkMergedLineBuffers_h
#define vtkMergedLineBuffers_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <list>

class vtkOpenGLIndexBufferObject;
class vtkOpenGLRenderWindow;
class vtkPolyData;

class vtkMergedLineBuffers
{
public:
  vtkMergedLineBuffers();
  ~vtkMergedLineBuffers();

  /**
   * The lines of the data with pieces of at most this length, or nullptr where merging would leave
   * out less than a tenth of the indices. Made anew where the data changed; four are kept. The
   * window's context is the current one.
   */
  vtkOpenGLIndexBufferObject* Get(
    vtkOpenGLRenderWindow* window, vtkPolyData* data, double length, std::size_t allIndices);

  /// vtkLineMerging::GetLongestSegment(), computed again where the data changed.
  double GetLongestSegment(vtkPolyData* data);

  /// Release all, in the context in which they were made, whichever is the current one.
  void ReleaseGraphicsResources();

private:
  vtkMergedLineBuffers(const vtkMergedLineBuffers&) = delete;
  void operator=(const vtkMergedLineBuffers&) = delete;

  struct Entry
  {
    int Level;
    vtkSmartPointer<vtkOpenGLIndexBufferObject> Buffer; ///< null: not worth it
  };

  void SetData(vtkPolyData* data);

  // Compared, never followed.
  const void* Data = nullptr;
  vtkMTimeType DataTime = 0;
  double LongestSegment = -1.0; ///< negative: not known
  // In whose context the buffers are.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  // The last one used first.
  std::list<Entry> Entries;
};

#endif

// VTK-HeaderTest-Exclude: vtkMergedLineBuffers.h
