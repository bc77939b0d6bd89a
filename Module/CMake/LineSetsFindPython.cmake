# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# Point Python3_EXECUTABLE at an interpreter that can import VTK: where several are installed, the
# first on the path is often not the one that VTK was wrapped for. An interpreter that the user has
# named is left as it is.
function (linesets_find_python)
  if (Python3_EXECUTABLE)
    return ()
  endif ()
  find_program(linesets_path_python NAMES python3 python)
  mark_as_advanced(linesets_path_python)
  foreach (candidate IN ITEMS "${linesets_path_python}" /usr/bin/python3)
    if (NOT EXISTS "${candidate}")
      continue ()
    endif ()
    # sys.executable sees through launchers that stand in for an interpreter.
    execute_process(
      COMMAND "${candidate}" -c "import sys, vtkmodules.vtkCommonCore; print(sys.executable)"
      OUTPUT_VARIABLE executable
      RESULT_VARIABLE status
      OUTPUT_STRIP_TRAILING_WHITESPACE
      ERROR_QUIET)
    if (status EQUAL 0)
      set(Python3_EXECUTABLE "${executable}" CACHE FILEPATH "Python interpreter that imports VTK")
      return ()
    endif ()
  endforeach ()
  message(STATUS
    "LineSets: found no Python that imports vtkmodules; set Python3_EXECUTABLE to one")
endfunction ()
