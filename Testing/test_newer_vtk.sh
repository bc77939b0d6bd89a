#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the project against a newer VTK than this machine's, Debian's 9.6 in the root of
# Module/ParaView/test.sh 6.1, and runs its tests.
#   bash Testing/test_newer_vtk.sh [CTEST ARGUMENT]...
# LINESETS_ROOTS names the folder of the roots (default ~/.cache/linesets), BUILD another build folder
# inside the root than "vtk96".
set -euo pipefail
roots=$(cd "$(dirname "${BASH_SOURCE[0]}")/../Module/ParaView" && pwd)
root=${LINESETS_ROOTS:-${XDG_CACHE_HOME:-$HOME/.cache}/linesets}/paraview-6.1
build=/build/${BUILD:-vtk96}

bash "$roots/make_root.sh" 6.1 "$root"
bash "$roots/run_in_root.sh" "$root" bash -euo pipefail -c '
  build=$1
  shift
  cmake -Wno-dev -G Ninja -S /linesets -B "$build" -DCMAKE_BUILD_TYPE=Release \
    -DLINESETS_WARNINGS_AS_ERRORS=ON
  cmake --build "$build" --parallel "$(nproc)"
  xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset" \
    ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
' bash "$build" "$@"
