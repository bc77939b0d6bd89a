# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Large 3D line sets in VTK: the voxel line model and the mapper that ray casts it.

    from linesets import vtkVoxelLineMapper

Importing the package loads VTK's OpenGL renderer as well. Where the modules were built as part of
VTK they lie in vtkmodules, and this package forwards to them.
"""

try:
    from .vtkFiltersLineSets import *
    from .vtkRenderingLineSets import *
except ModuleNotFoundError as error:
    # Only a missing module of our own means that they lie in vtkmodules.
    if not (error.name or "").startswith("linesets."):
        raise
    from vtkmodules.vtkFiltersLineSets import *
    from vtkmodules.vtkRenderingLineSets import *
