#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the plugin against a Debian release of ParaView and runs its tests, in a root of its own that
# is made where it is missing.
#   bash Module/ParaView/test.sh 5.13|6.1 [CTEST ARGUMENT]...
# LINESETS_ROOTS names the folder of the roots (default ~/.cache/linesets, 5 GB each), BUILD another
# build folder inside the root than "plugin".
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

version=${1:?"which ParaView: 5.13 or 6.1"}
shift
root=${LINESETS_ROOTS:-${XDG_CACHE_HOME:-$HOME/.cache}/linesets}/paraview-$version
build=/build/${BUILD:-plugin}

bash "$here/make_root.sh" "$version" "$root"
bash "$here/run_in_root.sh" "$root" bash -euo pipefail -c '
  build=$1
  shift
  cmake -Wno-dev -G Ninja -S /linesets/Module/ParaView -B "$build" -DLINESETS_WARNINGS_AS_ERRORS=ON
  cmake --build "$build" --parallel "$(nproc)"
  xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset" \
    ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
' bash "$build" "$@"
echo "The plugin is in $root$build/lib/paraview-$version/plugins/LineSets"
