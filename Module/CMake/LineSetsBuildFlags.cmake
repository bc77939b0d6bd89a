# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause

# LINESETS_COMPILE_OPTIONS: the warnings for the project's own sources. They are not applied to the
# generated Python wrappers. In a VTK tree the variable is empty and VTK's own settings hold.
option(LINESETS_WARNINGS_AS_ERRORS "Stop at a compiler warning in the project's own sources" OFF)

set(LINESETS_COMPILE_OPTIONS)
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(LINESETS_COMPILE_OPTIONS -Wall -Wextra -Wshadow)
  if (LINESETS_WARNINGS_AS_ERRORS)
    list(APPEND LINESETS_COMPILE_OPTIONS -Werror)
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # Found after inlining, in templates of the standard library that VTK's headers use (GCC 14 in
      # vtkSMPThreadLocal's vector<bool>): still told, but no reason to stop.
      list(APPEND LINESETS_COMPILE_OPTIONS -Wno-error=array-bounds -Wno-error=stringop-overflow)
    endif ()
  endif ()
elseif (MSVC)
  set(LINESETS_COMPILE_OPTIONS /W4)
  if (LINESETS_WARNINGS_AS_ERRORS)
    list(APPEND LINESETS_COMPILE_OPTIONS /WX)
  endif ()
endif ()

# Sanitizers, for example -DLINESETS_SANITIZE=address,undefined
set(LINESETS_SANITIZE "" CACHE STRING "Comma-separated sanitizers for the whole build")
if (LINESETS_SANITIZE)
  add_compile_options("-fsanitize=${LINESETS_SANITIZE}" -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${LINESETS_SANITIZE}")
endif ()
