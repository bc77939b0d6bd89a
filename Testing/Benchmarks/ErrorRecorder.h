// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Notes the errors that VTK reports while it lives; they are shown all the same.
 */

#ifndef ErrorRecorder_h
#define ErrorRecorder_h

#include "vtkSmartPointer.h" // For the output windows

#include <string> // For the error

class vtkOutputWindow;

namespace linesets
{
class ErrorRecorder
{
public:
  ErrorRecorder();
  ~ErrorRecorder();
  ErrorRecorder(const ErrorRecorder&) = delete;
  void operator=(const ErrorRecorder&) = delete;

  /// First error since construction on one line, or empty.
  std::string GetFirstError() const;

private:
  class RecordingWindow;
  vtkSmartPointer<RecordingWindow> Recording;
  vtkSmartPointer<vtkOutputWindow> Previous;
};
}

#endif
