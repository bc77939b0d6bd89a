# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# What the tests of linesets-bench have in common. A test ends with finish_checks().
set(failures 0)

macro (fail message)
  message("failed: ${message}")
  math(EXPR failures "${failures} + 1")
endmacro ()

# run(<status> <text> <arguments>...): the exit status, and a regular expression that the output
# matches. Leaves the output in `output`.
macro (run status text)
  execute_process(COMMAND "${BENCH}" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if (NOT result STREQUAL "${status}")
    fail("${ARGN}: status ${result} instead of ${status}\n${output}${errors}")
  endif ()
  if (NOT "${output}${errors}" MATCHES "${text}")
    fail("${ARGN}: '${text}' is not in\n${output}${errors}")
  endif ()
endmacro ()

macro (finish_checks)
  if (failures GREATER 0)
    message(FATAL_ERROR "${failures} checks failed")
  endif ()
endmacro ()
