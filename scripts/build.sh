#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build.sh PRESET [TARGET...]
# Configures PRESET where that has not been done, then builds. Everything is said on standard error, and nothing when
# nothing was to be done.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
folder=build/$preset

if [ ! -f "$folder/build.ninja" ]; then cmake --preset "$preset" >&2; fi

# The multiprecision sources take up to 2 GB of memory each to compile.
jobs=$(nproc)
if [ -r /proc/meminfo ]; then
  by_memory=$(awk '/^MemAvailable:/ {print int($2 / 2000000)}' /proc/meminfo)
  if [ "$by_memory" -lt 1 ]; then by_memory=1; fi
  if [ "$by_memory" -lt "$jobs" ]; then jobs=$by_memory; fi
fi

targets=()
if [ $# -gt 0 ]; then targets=(--target "$@"); fi
cmake --build "$folder" --parallel "$jobs" "${targets[@]}" |
  sed -u '/no work to do/d; /Re-checking globbed directories/d; /Change Dir:/d; /GLOB mismatch/d' >&2
