# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Configures the project as a remote module of a VTK tree (Testing/InTree stands in for it) and
# looks whether its three modules and their tests are found there.
#   cmake -DBUILD_DIR= -DSOURCE_DIR= -DGENERATOR= -DVTK_DIR= -DPYTHON= -P test_in_tree.cmake
set(scratch "${BUILD_DIR}/Testing/InTree")
file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}/source/Remote/LineSets")
configure_file("${SOURCE_DIR}/Testing/InTree/CMakeLists.txt" "${scratch}/source/CMakeLists.txt"
  COPYONLY)
# Copies part by part: the build folder may lie in the project, and the search follows no links.
foreach (part IN ITEMS CMakeLists.txt vtk.module Filters Rendering Module Testing)
  file(COPY "${SOURCE_DIR}/${part}" DESTINATION "${scratch}/source/Remote/LineSets")
endforeach ()

set(python)
if (PYTHON)
  set(python "-DPython3_EXECUTABLE=${PYTHON}")
endif ()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${scratch}/source" -B "${scratch}/build" -G "${GENERATOR}"
    "-DVTK_DIR=${VTK_DIR}" ${python}
  RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT status EQUAL 0)
  message(FATAL_ERROR "Configuration in a VTK tree failed (${status}):\n${output}")
endif ()
execute_process(
  COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${scratch}/build" -N
  RESULT_VARIABLE status OUTPUT_VARIABLE tests)
foreach (module IN ITEMS FiltersLineSetsCxx RenderingLineSetsCxx)
  if (NOT tests MATCHES "VTK::${module}-")
    message(FATAL_ERROR "No tests of ${module} are registered in a VTK tree:\n${tests}")
  endif ()
endforeach ()
