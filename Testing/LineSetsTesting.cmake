# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# Common to the tests of both modules, in a stand-alone build and in a VTK tree. Included from a
# module's Testing/CMakeLists.txt, where VTK has set _vtk_build_test to the module's name.
get_filename_component(LINESETS_SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)

# Data that the tests read, as -D. VTK's own -D names VTK's data folder in a VTK tree and an empty
# one here, so the tests are declared with NO_DATA.
list(APPEND "${_vtk_build_test}_ARGS" -D "${LINESETS_SOURCE_DIR}/Testing/Data")

# Stand-alone, Python tests run under the interpreter of the wrapping through a launcher that knows
# where the package is; in a VTK tree, under vtkpython.
set(LINESETS_TEST_PYTHON ON)
if (CMAKE_SOURCE_DIR STREQUAL LINESETS_SOURCE_DIR)
  set(LINESETS_TEST_PYTHON "${LINESETS_WRAP_PYTHON}")
  set(LINESETS_PYTHON_LAUNCHER "${CMAKE_BINARY_DIR}/Testing/linesets_python.py")
  set(_vtk_testing_python_exe "${Python3_EXECUTABLE}")
  set(_vtk_test_python_args "${LINESETS_PYTHON_LAUNCHER}")
endif ()

# See Testing/CMakeLists.txt.
if (LINESETS_SANITIZE MATCHES "address")
  link_libraries(linesets_keep_libraries_loaded)
endif ()

# linesets_test_sources(<executable>)
# What the tests of the project need beyond VTK's: the project's warnings, its private headers and
# shader files, GLM, and the reference renderer.
function (linesets_test_sources executable)
  if (NOT TARGET "${executable}")
    return ()
  endif ()
  find_package(glm REQUIRED)
  target_compile_features("${executable}" PRIVATE cxx_std_17)
  target_include_directories("${executable}" PRIVATE
    "${LINESETS_SOURCE_DIR}/Filters"
    "${LINESETS_SOURCE_DIR}/Rendering"
    "${LINESETS_SOURCE_DIR}/Testing/Reference")
  target_link_libraries("${executable}" PRIVATE glm::glm linesets_reference)
  if (LINESETS_COMPILE_OPTIONS)
    target_compile_options("${executable}" PRIVATE ${LINESETS_COMPILE_OPTIONS})
  endif ()
endfunction ()
