#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) LineSets contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs what is missing, builds with warnings as errors, and runs all tests.
#   bash Testing/test.sh [CTEST ARGUMENT]...
# BUILD_DIR names another build folder than build/PRESET, PRESET another preset than release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${PRESET:-release}
build=${BUILD_DIR:-build/$preset}
bash Testing/install-dependencies.sh
cmake --preset "$preset" -B "$build"
cmake --build "$build" --parallel "$(nproc)"

# One display for the whole run, the same one everywhere.
xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset" \
  ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
