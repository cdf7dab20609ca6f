#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh [PRESET] [CTEST OPTION...]
# Installs what is missing, builds everything of PRESET (default: release) and runs all its tests.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

preset=release
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  preset=$1
  shift
fi
"$here/setup.sh"
"$here/build.sh" "$preset"
cd "$here/.."
exec ctest --preset "$preset" --parallel "$(nproc)" "$@"
