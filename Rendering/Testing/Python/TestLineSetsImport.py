# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Guards: the package imports, and carries OpenGL rendering with it."""

import linesets
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkRenderWindow

# Without RenderingOpenGL2 loaded the factory gives the abstract base class.
assert vtkPolyDataMapper().GetClassName() != "vtkPolyDataMapper"
assert vtkRenderWindow().GetClassName() != "vtkRenderWindow"
