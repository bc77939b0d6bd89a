#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command inside a root that make_root.sh made. The project is seen there, read-only, at
# /linesets, and its `../shared`, where there is one, at /shared; what is written belongs into /build,
# which stays with the root.
#   bash Module/ParaView/run_in_root.sh DIRECTORY COMMAND [ARGUMENT]...
set -euo pipefail

root=${1:?"the folder of the root"}
shift
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

mkdir -p "$root/linesets" "$root/shared" "$root/build"
# A mount namespace of its own: nothing stays mounted, however this ends.
exec unshare --mount bash -euo pipefail -c '
  root=$1 project=$2
  shift 2
  mount --bind "$project" "$root/linesets"
  mount -o remount,bind,ro "$root/linesets"
  if [ -d "$project/../shared" ]; then
    mount --bind "$project/../shared" "$root/shared"
    mount -o remount,bind,ro "$root/shared"
  fi
  mount --rbind /dev "$root/dev"
  mount --rbind /sys "$root/sys"
  mount -t proc proc "$root/proc"
  mount -t tmpfs tmpfs "$root/tmp"
  exec chroot "$root" /usr/bin/env -i \
    PATH=/usr/lib/ccache:/usr/local/bin:/usr/bin:/bin HOME=/root LC_ALL=C.UTF-8 \
    CCACHE_DIR=/build/.ccache TERM=dumb ${CI:+CI="$CI"} "$@"
' bash "$root" "$project" "$@"
