# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package "linesets": the wrapped modules beside Module/Python/linesets/__init__.py.
vtk_module_python_default_destination(LINESETS_PYTHON_DESTINATION)
vtk_module_wrap_python(
  MODULES             ${linesets_modules}
  PYTHON_PACKAGE      "linesets"
  INSTALL_EXPORT      LineSetsPython
  MODULE_DESTINATION  "${LINESETS_PYTHON_DESTINATION}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION   "${linesets_cmake_destination}"
  BUILD_STATIC        OFF)

set(LINESETS_PYTHONPATH "${CMAKE_BINARY_DIR}/${LINESETS_PYTHON_DESTINATION}")
configure_file("${PROJECT_SOURCE_DIR}/Module/Python/linesets/__init__.py"
  "${LINESETS_PYTHONPATH}/linesets/__init__.py" COPYONLY)
install(
  FILES       "${PROJECT_SOURCE_DIR}/Module/Python/linesets/__init__.py"
  DESTINATION "${LINESETS_PYTHON_DESTINATION}/linesets"
  COMPONENT   python)
