// SPDX-FileCopyrightText: Copyright (c) LineSets contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorRecorder.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>

namespace linesets
{
class ErrorRecorder::RecordingWindow : public vtkOutputWindow
{
public:
  static RecordingWindow* New();
  vtkTypeMacro(RecordingWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    if (this->FirstError.empty())
    {
      this->FirstError = text;
    }
    this->Superclass::DisplayErrorText(text);
  }

  std::string FirstError;
};

vtkStandardNewMacro(ErrorRecorder::RecordingWindow);

//------------------------------------------------------------------------------
ErrorRecorder::ErrorRecorder()
  : Recording(vtkSmartPointer<RecordingWindow>::New())
  , Previous(vtkOutputWindow::GetInstance())
{
  vtkOutputWindow::SetInstance(this->Recording);
}

//------------------------------------------------------------------------------
ErrorRecorder::~ErrorRecorder()
{
  vtkOutputWindow::SetInstance(this->Previous);
}

//------------------------------------------------------------------------------
std::string ErrorRecorder::GetFirstError() const
{
  std::string text = this->Recording->FirstError;
  std::replace(text.begin(), text.end(), '\n', ' ');
  const std::size_t last = text.find_last_not_of(' ');
  return last == std::string::npos ? std::string() : text.substr(0, last + 1);
}
}
