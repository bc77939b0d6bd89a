# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Remote module file: copy it into the Remote/ folder of a VTK source tree and configure VTK with
#   -DLINESETS_GIT_REPOSITORY=<where the project is> -DVTK_MODULE_ENABLE_VTK_LineSets=WANT
# VTK then clones the project into Remote/LineSets. A checkout made there by hand needs no such file.
set(LINESETS_GIT_REPOSITORY "" CACHE STRING "Repository that LineSets is cloned from")
set(LINESETS_GIT_TAG "main" CACHE STRING "Branch, tag or commit of LineSets")
mark_as_advanced(LINESETS_GIT_REPOSITORY LINESETS_GIT_TAG)

vtk_fetch_module(LineSets
  "Large 3D line sets: voxel line model and its rendering"
  GIT_REPOSITORY "${LINESETS_GIT_REPOSITORY}"
  GIT_TAG        "${LINESETS_GIT_TAG}")
