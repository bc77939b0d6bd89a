#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Guards that the plugin works in the window of ParaView's client: starts it on a display of its own,
# draws with every representation, takes a picture of the whole screen (window.png in the test's
# output), and looks for messages and for lines in it. Then it clicks with the mouse on the line that
# is orange in that picture (client_window.py), and sees that the client has selected that line.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if [ -z "${LINESETS_OWN_DISPLAY:-}" ]; then
  export LINESETS_OWN_DISPLAY=1
  exec xvfb-run -a -s "-screen 0 1400x900x24 +extension GLX -noreset" bash "$0"
fi

mkdir -p "$LINESETS_TEST_OUTPUT"
cd "$LINESETS_TEST_OUTPUT"
rm -f window.ready window.png window.clicked.png window.log window.selection
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

# Blue and orange as the test's colour map has them, on black: lines, and not the client's own grey.
# ImageMagick may print something else of -fx before.
colored=$(convert window.png -crop 1000x800+400+100 -fx 'abs(b-r)>0.2' \
  -format '%[fx:int(mean*w*h)]' info: | tail -n 1)
echo "$colored coloured pixels in the views"
if [ "$colored" -lt 20000 ]; then
  echo "FAILED: too few to be lines"
  exit 1
fi

# select KIND KEY X Y: what a key of the client makes a click select.
select_at() {
  xdotool mousemove "$3" "$4" key "$2"
  sleep 0.5
  xdotool click 1
  for _ in $(seq 150); do
    if grep -q "^$1" window.selection 2>/dev/null; then
      return
    fi
    sleep 0.2
  done
  import -window root window.clicked.png
  echo "FAILED: a click at $3 $4 selects no $1 but $(cat window.selection || echo nothing);" \
    "see window.clicked.png"
  exit 1
}

# Parts of the window, inside one view each and without the scalar bar.
for view in 340x640+375+200 480x280+890+210 480x280+890+570; do
  IFS=x+ read -r _ _ left top <<<"$view"
  # Pixels inside the orange line; the middle one of them.
  convert window.png -crop "$view" +repage -fx 'r>0.3&&r>1.5*b&&r>1.5*g?1:0' \
    -morphology Erode Square:1 txt:- | sed -n 's/^\([0-9]*\),\([0-9]*\):.*#FFFFFF.*/\1 \2/p' >orange.txt
  if [ ! -s orange.txt ]; then
    echo "FAILED: the view at $left $top has no orange line"
    exit 1
  fi
  read -r x y <<<"$(sed -n "$((($(wc -l <orange.txt) + 1) / 2))p" orange.txt)"
  x=$((left + x)) y=$((top + y))

  # The view that is clicked becomes the active one.
  xdotool mousemove "$left" "$top" click 1
  sleep 1
  select_at CELL s "$x" "$y"
  cells=$(cat window.selection)
  select_at POINT d "$x" "$y"
  points=$(cat window.selection)
  select_at NOTHING s "$left" "$top"
  echo "Clicks at $x $y select: $cells; $points"
  # Line 12, of 100 points each.
  if [ "$cells" != "CELL 12" ] || ! [[ "$points" =~ ^POINT\ 12[0-9][0-9]$ ]]; then
    echo "FAILED: this is not the line"
    exit 1
  fi
done
import -window root window.clicked.png

if grep -E 'ERR\||WARN\||Error|Traceback' window.log; then
  echo "FAILED: the client wrote messages"
  exit 1
fi
