#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes a Debian root that holds ParaView and what building a plugin for it takes, since ParaView's
# packages and VTK's own cannot be installed beside each other. A root that is complete is left alone.
#   bash Module/ParaView/make_root.sh 5.13|6.1 DIRECTORY
# Needs root's rights, about 5 minutes and 5 GB.
set -euo pipefail

version=${1:?"which ParaView: 5.13 or 6.1"}
root=${2:?"the folder to make the root in"}

# What ParaView's CMake package asks for when it is found, beside the compiler and ParaView itself.
packages=(
  paraview paraview-dev python3-paraview
  ccache cmake g++ libglm-dev ninja-build
  imagemagick libgl1-mesa-dri openmpi-bin xauth xdotool xvfb
  libavcodec-dev libavformat-dev libdouble-conversion-dev libeigen3-dev libexpat1-dev libfmt-dev
  libfreetype-dev libgl-dev libgl2ps-dev libglew-dev libhdf5-openmpi-dev libjpeg-dev libjsoncpp-dev
  liblz4-dev liblzma-dev libnetcdf-dev libogg-dev libopenmpi-dev libpng-dev libproj-dev
  libprotobuf-dev libpugixml-dev libpython3-dev libsqlite3-dev libswscale-dev libtheora-dev
  libtiff-dev libutfcpp-dev libx11-dev libxcursor-dev libxml2-dev libxt-dev nlohmann-json3-dev
  protobuf-compiler qt6-5compat-dev qt6-base-dev qt6-svg-dev qt6-svg-plugins qt6-tools-dev zlib1g-dev
)
case "$version" in
  5.13) suite=trixie ;;
  6.1)
    suite=forky
    packages+=(libfast-float-dev libvtk9-dev python3-vtk9 xsltproc)
    ;;
  *)
    echo "make_root.sh knows ParaView 5.13 and 6.1, not $version" >&2
    exit 1
    ;;
esac

# Changes with what the root holds, so that an older root is made anew.
recipe="$suite ${packages[*]}"
if [ "$(cat "$root/etc/linesets-root" 2>/dev/null || true)" = "$recipe" ]; then
  exit 0
fi

if [ "$(id -u)" -ne 0 ]; then
  echo "make_root.sh needs root's rights to make $root" >&2
  exit 1
fi
if ! command -v debootstrap >/dev/null; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update && apt-get install -y --no-install-recommends debootstrap || {
    echo "make_root.sh: debootstrap could not be downloaded" >&2
    exit 1
  }
fi
# The newest suite can be younger than debootstrap; all suites are bootstrapped alike.
scripts=/usr/share/debootstrap/scripts
if [ ! -e "$scripts/$suite" ]; then
  ln -s sid "$scripts/$suite"
fi
# The mirror that this machine uses itself.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)

echo "Making a root for ParaView $version ($suite) in $root"
rm -rf --one-file-system "$root"
mkdir -p "$(dirname "$root")"
debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$root.log" 2>&1 || {
  tail -n 20 "$root.log"
  echo "make_root.sh: the base system of $suite could not be downloaded, see $root.log" >&2
  exit 1
}
# A mount namespace of its own: nothing stays mounted, however this ends.
unshare --mount bash -euo pipefail -c '
  mount --bind /dev "$0/dev"
  mount -t proc proc "$0/proc"
  export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
  # Lists of a suite that is still in testing expire within days; they stay signed.
  chroot "$0" apt-get -o Acquire::Check-Valid-Until=false update
  chroot "$0" apt-get install -y --no-install-recommends "$@"
' "$root" "${packages[@]}" >>"$root.log" 2>&1 || {
  tail -n 20 "$root.log"
  echo "make_root.sh: packages for ParaView $version could not be installed, see $root.log" >&2
  exit 1
}
rm -rf "$root"/var/cache/apt/archives/*.deb

# The CMake files of both packages name Python modules without the suffix of Python's ABI.
for module in "$root"/usr/lib/python3/dist-packages/{vtkmodules,paraview,paraview/*}/*.cpython-*.so; do
  if [ -e "$module" ]; then
    ln -sf "$(basename "$module")" "${module%%.cpython-*}.so"
  fi
done
echo "$recipe" >"$root/etc/linesets-root"
