# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Guards linesets-bench from outside: exit status, what it says about wrong command lines, and the
# keys of its JSON. Run as: cmake -DBENCH=program -DDATA=folder -P TestBenchmark.cmake
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

run(0 "--methods" --help)
run(2 "no scene" --frames 1)
run(2 "unknown option --sceen" --sceen tornado)
run(2 "nowhere is none of" nowhere)
run(2 "--methods: embree is none of" tornado --methods embree)
run(2 "--methods: voxel is named twice" tornado --methods voxel,voxel)
run(2 "--engine: fast is none of" tornado --engine fast)
run(2 "--size: 100 is not" tornado --size 100)
run(2 "--size: 0 is not" tornado --size 0x100)
run(2 "--opacity: 25% is not" tornado --opacity 25%)
run(2 "--frames: 0 is not" tornado --frames 0)
run(2 "--radius: -1 is not" tornado --radius -1)
run(2 "--face-bins: 33 is neither" tornado --face-bins 33)
run(2 "--json needs a value" tornado --json)
run(2 "do not apply to files" lines.vtp --lines 10)
run(1 "no file nothing.vtp" nothing.vtp)
run(1 "cannot write" tornado --json /nowhere/at/all.json)

set(small tornado --lines 40 --vertices 60 --size 160x120 --frames 2 --radius 0.02)

# All methods, with the pictures judged: a line of JSON each, and the keys that apply.
run(0 "" ${small} --opacity 0.5 --methods voxel,tubes,peeling,oit,line-tubes --engine native
  --reference --reference-decoded --threads 2 --data "${DATA}")
string(STRIP "${output}" output)
string(REPLACE "\n" ";" objects "${output}")
list(LENGTH objects count)
if (NOT count EQUAL 5)
  fail("${count} objects instead of 5")
endif ()
set(common scene lines vertices method width height opacity radius frames median_ms min_ms max_ms cpu_ms
  build_ms first_frame_ms segments rmse ssim ratio_tubes ratio_peeling renderer vtk threads)
set(keys_voxel ${common} engine model_bytes gpu_bytes rmse_decoded)
set(keys_tubes ${common} gpu_bytes)
set(keys_peeling ${common} gpu_bytes)
set(keys_oit ${common} gpu_bytes)
set(keys_line-tubes ${common})
foreach (object IN LISTS objects)
  string(REGEX MATCH "\"method\": \"([a-z-]*)\"" match "${object}")
  set(method "${CMAKE_MATCH_1}")
  string(REGEX MATCHALL "\"[a-z_]*\":" found "${object}")
  string(REGEX REPLACE "[\":]" "" found "${found}")
  list(SORT found)
  list(SORT keys_${method})
  if (NOT found STREQUAL "${keys_${method}}")
    fail("keys of ${method}: ${found} instead of ${keys_${method}}")
  endif ()
  if (NOT object MATCHES "^{\"scene\": \"tornado\", \"lines\": 40, \"vertices\": 2400, .*\"threads\": 2}$")
    fail("object of ${method}: ${object}")
  endif ()
  # Pictures of the same thing: a wrong camera or wrong light gives an rmse above 0.2.
  string(REGEX MATCH "\"rmse\": ([0-9.]*)" match "${object}")
  if (NOT CMAKE_MATCH_1 OR CMAKE_MATCH_1 GREATER 0.1)
    fail("rmse of ${method}: ${CMAKE_MATCH_1}")
  endif ()
endforeach ()
if (NOT output MATCHES "\"method\": \"tubes\"[^\n]*\"ratio_tubes\": 1,")
  fail("ratio of tubes to themselves")
endif ()
string(REGEX MATCH "\"rmse_decoded\": ([0-9.e-]*)" match "${output}")
if (NOT CMAKE_MATCH_1 OR CMAKE_MATCH_1 GREATER 0.0078)
  fail("rmse_decoded: ${CMAKE_MATCH_1}, more than 2/255")
endif ()

# Lines, plain and lit: each has a ratio to plain ones, and light makes a difference.
run(0 "" ${small} --methods lines,illuminated,illuminated-max,illuminated-blinn,illuminated-direct
  --light right --line-width 2 --samples 4 --stretch --reference)
string(STRIP "${output}" output)
string(REPLACE "\n" ";" objects "${output}")
list(LENGTH objects count)
if (NOT count EQUAL 5)
  fail("${count} objects of lines instead of 5")
endif ()
set(differences "")
foreach (object IN LISTS objects)
  if (NOT object MATCHES "\"ratio_lines\": [0-9.]+")
    fail("no ratio to lines: ${object}")
  endif ()
  string(REGEX MATCH "\"rmse\": ([0-9.]*)" match "${object}")
  list(APPEND differences "${CMAKE_MATCH_1}")
endforeach ()
list(GET differences 0 plain)
list(GET differences 1 averaged)
list(GET differences 2 brightest)
if (plain STREQUAL averaged OR averaged STREQUAL brightest)
  fail("light without effect: ${differences}")
endif ()
run(2 "--light: left is none of" tornado --light left)

# A method that fails says so, and the others go on.
run(1 "\"method\": \"peeling\"[^\n]*\"error\": \"preparing: needs an opacity below 1\""
  ${small} --methods peeling,line-tubes)
if (NOT output MATCHES "\"method\": \"line-tubes\"[^\n]*\"median_ms\"")
  fail("line-tubes after a failure: ${output}")
endif ()

if (failures GREATER 0)
  message(FATAL_ERROR "${failures} checks failed")
endif ()
