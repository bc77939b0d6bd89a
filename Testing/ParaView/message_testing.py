# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Catches the errors and warnings that a test expects, so that they do not fail it."""
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow


class Messages:
    """With this as context, what VTK and ParaView have to say is kept in text."""

    def __enter__(self):
        self.window = vtkStringOutputWindow()
        self.before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(self.window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, *error):
        vtkOutputWindow.SetInstance(self.before)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)
        return False

    @property
    def text(self):
        return self.window.GetOutput()
