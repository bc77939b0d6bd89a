# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs the build into a scratch prefix, then configures, builds and runs Testing/Consumer
# against it, and imports the installed Python package.
#   cmake -DBUILD_DIR= -DSOURCE_DIR= -DCONFIG= -DGENERATOR= -DCXX= -DCC= -DFLAGS= -DVTK_DIR=
#         -DPYTHON= -DPYTHON_DESTINATION= -P test_package.cmake
set(scratch "${BUILD_DIR}/Testing/Consumer")
set(prefix "${scratch}/prefix")
file(REMOVE_RECURSE "${scratch}")

function (run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${output}")
  endif ()
endfunction ()

run("Installation" "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}" --config "${CONFIG}")
run("Configuration of the consumer" "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${scratch}/build"
  -G "${GENERATOR}" "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DCMAKE_CXX_COMPILER=${CXX}"
  "-DCMAKE_C_COMPILER=${CC}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DVTK_DIR=${VTK_DIR}"
  "-DCMAKE_PREFIX_PATH=${prefix}")
run("Build of the consumer" "${CMAKE_COMMAND}" --build "${scratch}/build" --config "${CONFIG}")
run("The consumer" "${scratch}/build/consumer")
# What is private stays at home.
file(GLOB_RECURSE private_headers "${prefix}/*Private.h")
if (private_headers)
  message(FATAL_ERROR "Private headers were installed: ${private_headers}")
endif ()
if (PYTHON)
  run("The installed Python package" "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${prefix}/${PYTHON_DESTINATION}" "LD_LIBRARY_PATH="
    "${PYTHON}" -c "import linesets; linesets.vtkLineVoxelizer(); assert linesets.__file__.startswith('${prefix}')")
endif ()
