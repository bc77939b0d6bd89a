# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# In a VTK tree the wrapped modules lie in vtkmodules; the package "linesets" forwards to them, so
# that scripts work with both kinds of build.
if (VTK_WRAP_PYTHON AND VTK_PYTHON_SITE_PACKAGES_SUFFIX)
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/Module/Python/linesets/__init__.py"
    "${CMAKE_BINARY_DIR}/${VTK_PYTHON_SITE_PACKAGES_SUFFIX}/linesets/__init__.py" COPYONLY)
  install(
    FILES       "${CMAKE_CURRENT_SOURCE_DIR}/Module/Python/linesets/__init__.py"
    DESTINATION "${VTK_PYTHON_SITE_PACKAGES_SUFFIX}/linesets"
    COMPONENT   python)
endif ()
