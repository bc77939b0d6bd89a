#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Guards that the plugin works in the window of ParaView's client: starts it on a display of its own,
# draws with every representation, takes a picture of the whole screen (window.png in the test's
# output), and looks for messages and for lines in it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if [ -z "${LINESETS_OWN_DISPLAY:-}" ]; then
  export LINESETS_OWN_DISPLAY=1
  exec xvfb-run -a -s "-screen 0 1400x900x24 +extension GLX -noreset" bash "$0"
fi

mkdir -p "$LINESETS_TEST_OUTPUT"
cd "$LINESETS_TEST_OUTPUT"
rm -f window.ready window.png window.log
# A home of its own: no settings of the user's, no dialog that welcomes.
export HOME=$PWD/window.home XDG_RUNTIME_DIR=$PWD/window.home QT_QPA_PLATFORM=xcb
rm -rf "$HOME"
mkdir -p "$HOME/.config/ParaView"
chmod 700 "$HOME"
# ParaView 5 has a file per version.
version=$(paraview --version | grep -oE '[0-9]+\.[0-9]+\.[0-9]+' | head -n 1)
for settings in ParaView "ParaView$version"; do
  printf '[General]\nGeneralSettings.ShowWelcomeDialog=0\n' >"$HOME/.config/ParaView/$settings.ini"
done

PYTHONPATH=$here paraview --script="$here/client_window.py" >window.log 2>&1 &
client=$!
trap 'kill $client 2>/dev/null || true' EXIT
for _ in $(seq 300); do
  if [ -e window.ready ] || ! kill -0 $client 2>/dev/null; then
    break
  fi
  sleep 0.5
done
if [ ! -e window.ready ]; then
  echo "FAILED: the client did not draw within minutes; see window.png"
  import -window root window.png
  cat window.log
  exit 1
fi
window=$(xdotool search --onlyvisible --name '^ParaView' | head -n 1)
xdotool windowmove "$window" 0 0 windowsize "$window" 1400 900
sleep 4
import -window root window.png

if grep -E 'ERR\||WARN\||Error|Traceback' window.log; then
  echo "FAILED: the client wrote messages"
  exit 1
fi
# Blue and orange as the test's colour map has them, on black: lines, and not the client's own grey.
colored=$(convert window.png -crop 1000x800+400+100 -fx '(b>r+0.2)||(r>b+0.2)' -format '%[fx:int(mean*w*h)]' info:)
echo "$colored coloured pixels in the views"
if [ "$colored" -lt 20000 ]; then
  echo "FAILED: too few to be lines"
  exit 1
fi
