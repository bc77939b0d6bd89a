#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing of the packages that building and testing take, on Debian and its
# relatives. Does nothing, and needs no rights, where everything is there.
set -euo pipefail

packages=(
  cmake g++ ninja-build           # the build
  libvtk9-dev python3-vtk9        # VTK and its Python wrapping
  libglm-dev                      # shader code compiled as C++
  libgl1-mesa-dri xauth xvfb      # OpenGL and a display without a screen
)

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh knows Debian's packages only; assuming that the likes of these are" \
    "installed: ${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  if [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)" != installed ]; then
    missing+=("$package")
  fi
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Please install as root: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update
"${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}"
