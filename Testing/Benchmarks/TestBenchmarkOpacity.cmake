# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Guards the methods of opacity optimization in linesets-bench from outside: what it says about wrong
# options, that options arrive, the keys, and the exact pictures. Run as: cmake -DBENCH=program
# -P TestBenchmarkOpacity.cmake
include("${CMAKE_CURRENT_LIST_DIR}/TestBenchmarkMacros.cmake")

foreach (bands IN ITEMS 0 17 2.5)
  run(2 "--bands: ${bands} is not a whole number from 1 to 16" tornado --bands ${bands})
endforeach ()
run(2 "--subset: 0 is not" tornado --subset 0)
run(2 "--subset: 10001 is not" tornado --subset 10001)
run(2 "--importance-reduction: 9 is not" tornado --importance-reduction 9)
run(2 "--depth-reduction: 9 is not" tornado --depth-reduction 9)
run(2 "--half-floats: yes is none of on off" tornado --half-floats yes)
run(2 "--depth-scale: cubic is none of linear logarithmic" tornado --depth-scale cubic)
run(2 "--tight-depth: yes is none of on off" tornado --tight-depth yes)
run(2 "--opaque-threshold: 0.4 is not" tornado --opaque-threshold 0.4)
run(2 "--list-memory: 0 is not" tornado --list-memory 0)
run(2 "--color: red is none of scalars importance" tornado --color red)
run(2 "--line-segments: -1 is not" tornado --line-segments -1)
run(2 "--patches: 16777216 is not" tornado --patches 16777216)
run(2 "--zoom: 0 is not" tornado --zoom 0)
run(2 "--smoothing: -1 is not" tornado --smoothing -1)
run(2 "--smoothing: 1001 is not" tornado --smoothing 1001)
run(2 "--weights: 1,2,3 is not of the form P,Q,R,LAMBDA" tornado --weights 1,2,3)
run(2 "--weights: 1,2,3,4,5 is not of the form" tornado --weights 1,2,3,4,5)
run(2 "--weights, p: 0 is not" tornado --weights 0,2,3,4)
run(2 "--weights, q: -2 is not" tornado --weights 1,-2,3,4)
run(2 "--weights, r: x is not" tornado --weights 1,2,x,4)
run(2 "--weights, lambda: 0.009 is not" tornado --weights 1,2,3,0.009)
run(2 "--weights, lambda:  is not" tornado --weights 1,2,3,)
run(2 "--importance-sums: sorted is none of fourier exact" tornado --importance-sums sorted)

# What opacity optimization takes is taken, at both ends of the ranges, and told as the mapper has it.
foreach (weights IN ITEMS 1e-06,0,0,0.01 1e+06,1e+06,1e+06,100)
  string(REPLACE "+" "[+]" told "${weights}")
  run(0 "\"importance\": \"exact\", \"importance_reduction\": 3, \"bands\": 16, \"subset\": 7, \"depth_reduction\": 2, \"half_floats\": 1, \"weights\": \"${told}\", \"smoothing\": 0,"
    tornado --lines 5 --vertices 10 --size 16x12 --frames 1 --methods fourier --bands 16 --subset 7
    --smoothing 0 --weights ${weights} --importance-sums exact --importance speed
    --importance-reduction 3 --depth-reduction 2 --half-floats on --depth-scale logarithmic --tight-depth off --opaque-threshold 1
    --list-memory 1)
endforeach ()

# Opacity optimization: all methods, with the keys that apply; against the exact picture the sorted
# fragments have no error at all, though they have drawn other views before, and mean colours, which
# know no order, have the largest. (A lost option or another camera gives fragment-list an error.)
set(blendings fourier fourier-paper bins weighted-average weighted-blended fragment-list)
string(REPLACE ";" "," methods "${blendings}")
set(optimized tornado --lines 100 --vertices 60 --size 160x120 --frames 2 --line-width 3)
run(0 "" ${optimized} --methods ${methods} --reference --importance-reduction 3 --weights 1,20,30,1.5
  --smoothing 4)
set(common scene lines vertices method width height opacity radius light frames median_ms min_ms
  max_ms cpu_ms build_ms first_frame_ms importance importance_reduction weights smoothing gpu_bytes
  sum_bytes depth_complexity rmse ssim rmse_full ssim_full ratio_fragment_list renderer vtk threads)
foreach (method IN LISTS blendings)
  set(expected ${common} bands subset depth_reduction half_floats)
  if (method STREQUAL "fragment-list")
    set(expected ${common} fragments dropped)
  endif ()
  string(REGEX MATCH "[^\n]*\"method\": \"${method}\"[^\n]*" object "${output}")
  string(REGEX MATCHALL "\"[a-z_]*\":" found "${object}")
  string(REGEX REPLACE "[\":]" "" found "${found}")
  list(SORT found)
  list(SORT expected)
  if (NOT found STREQUAL expected)
    fail("keys of ${method}: ${found} instead of ${expected}")
  endif ()
  foreach (key IN ITEMS rmse depth_complexity)
    string(REGEX MATCH "\"${key}\": ([0-9.e-]*)" match "${object}")
    set(${key}_${method} "${CMAKE_MATCH_1}")
  endforeach ()
endforeach ()
if (NOT rmse_fragment-list STREQUAL "0")
  fail("fragment-list is not exact: ${rmse_fragment-list}")
endif ()
foreach (method IN ITEMS fourier fourier-paper bins weighted-blended)
  if (NOT rmse_${method} GREATER 0 OR NOT rmse_${method} LESS rmse_weighted-average)
    fail("rmse of ${method}: ${rmse_${method}}, of weighted-average: ${rmse_weighted-average}")
  endif ()
endforeach ()
if (NOT rmse_fourier LESS rmse_fourier-paper)
  fail("rmse of fourier: ${rmse_fourier}, of fourier-paper: ${rmse_fourier-paper}")
endif ()
if (NOT depth_complexity_fragment-list GREATER 1
    OR NOT depth_complexity_fragment-list EQUAL depth_complexity_fourier)
  fail("depth complexity: ${depth_complexity_fragment-list}, reference ${depth_complexity_fourier}")
endif ()
# Exact sums of importance leave the error of blending, and come from lists.
run(0 "" ${optimized} --methods fourier --reference --importance-reduction 3 --weights 1,20,30,1.5
  --smoothing 4 --importance-sums exact)
string(REGEX MATCH "\"rmse\": ([0-9.e-]*)" match "${output}")
set(rmse "${CMAKE_MATCH_1}")
if (NOT rmse GREATER 0 OR NOT rmse LESS rmse_fourier-paper OR rmse STREQUAL rmse_fourier
    OR NOT output MATCHES "\"fragments\": [1-9][0-9]*, \"dropped\": 0,")
  fail("exact sums: ${output}, rmse of series: ${rmse_fourier}")
endif ()

# Points and surfaces are held against exact pictures, too, beside methods that have none; lines that
# move are followed; each takes the colours that are asked for.
foreach (scene IN ITEMS "points;--lines;500" "surfaces;--lines;5;--vertices;9")
  run(0 "\"method\": \"fragment-list\"[^\n]*\"rmse\": 0," ${scene} --size 64x48 --frames 1
    --reference --methods lines,fragment-list)
  if (output MATCHES "\"method\": \"lines\"[^\n]*\"rmse\"")
    fail("an exact picture of ${scene}: ${output}")
  endif ()
endforeach ()
run(0 "\"animated\": 1,[^\n]*\"rebuild_ms\": [0-9.]+[^\n]*\"rmse\": 0," ${optimized} --animate
  --methods fragment-list --reference)
set(file "${CMAKE_CURRENT_BINARY_DIR}/TestBenchmark-color")
foreach (method IN ITEMS lines fourier)
  set(hashes "")
  foreach (color IN ITEMS default scalars importance)
    set(option --color ${color})
    if (color STREQUAL "default")
      set(option "")
    endif ()
    run(0 "" ${optimized} --frames 1 --methods ${method} --image "${file}" ${option})
    file(SHA256 "${file}-${method}.png" hash_${color})
    file(REMOVE "${file}-${method}.png")
  endforeach ()
  set(same scalars)
  if (method STREQUAL "fourier")
    set(same importance)
  endif ()
  if (hash_scalars STREQUAL hash_importance OR NOT hash_default STREQUAL hash_${same})
    fail("colours of ${method}")
  endif ()
endforeach ()

# Without importance there is nothing to optimize.
set(file "${CMAKE_CURRENT_BINARY_DIR}/TestBenchmark-bare.vtk")
file(WRITE "${file}" "# vtk DataFile Version 3.0\nlines\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
  "0 0 0  1 0 0\nLINES 1 3\n2 0 1\n")
run(1 "\"error\": \"preparing: the points have neither an array importance nor scalars"
  "${file}" --methods fourier,lines --frames 1 --size 16x12)
if (NOT output MATCHES "\"method\": \"lines\"[^\n]*\"median_ms\"")
  fail("lines without importance: ${output}")
endif ()
file(REMOVE "${file}")
run(1 "no array of numbers vorticity at the points, whose arrays are: speed importance" tornado --lines 5
  --importance vorticity)

finish_checks()
