#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds, traces streamlines of the blood flow in a carotid artery, and
# draws them opaque and at 25 % opacity.
#   bash Examples/demo.sh [--window]
# --window opens an interactive window instead of writing pictures, where there is a display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

window=no
for argument in "$@"; do
  case "$argument" in
    --window) window=yes ;;
    *)
      echo "usage: bash Examples/demo.sh [--window]" >&2
      exit 2
      ;;
  esac
done
if [ "$window" = yes ] && [ -z "${DISPLAY:-}" ]; then
  echo "There is no display for a window; writing pictures instead." >&2
  window=no
fi

build=${BUILD_DIR:-build/release}
bash Testing/install-dependencies.sh
cmake --preset release -B "$build"
cmake --build "$build" --parallel "$(nproc)" --target RenderLines

pictures=$build/demo
lines=$pictures/carotid.vtp
mkdir -p "$pictures"
# The interpreter that the build found to import VTK.
python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$build/CMakeCache.txt")
# Below this speed the measurement is noise.
"${python:-python3}" Examples/Python/trace_streamlines.py Testing/Data/carotid.vti "$lines" \
  --vectors velocity --weights speed --terminal-speed 1.2 --count 2400

render=("$build/bin/RenderLines" "$lines" --color-by speed --radius 0.12 --size 1024x768)
if [ "$window" = yes ]; then
  exec "${render[@]}" --opacity 0.25
fi
display=()
if [ -z "${DISPLAY:-}" ]; then
  display=(xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset")
fi
"${display[@]}" "${render[@]}" --opacity 1 --output "$pictures/carotid-opaque.png"
"${display[@]}" "${render[@]}" --opacity 0.25 --output "$pictures/carotid-transparent.png"
echo "The pictures are in $PWD/$pictures:"
echo "  carotid-opaque.png       the streamlines, coloured by speed"
echo "  carotid-transparent.png  the same at 25 % opacity"
