#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# bench.sh [SUBJECT [OPTION...]]
# Installs what is missing, builds the benchmarks and runs those of SUBJECT (plane_curves, curve_surface, surface_pencil,
# stages; default: all) with one thread. The results are printed and written to build/release/bench_SUBJECT.json. Options
# are those of Google Benchmark, and what the first lines of bench/SUBJECT_bench.cpp name.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."

subjects=(plane_curves curve_surface surface_pencil stages)
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  subjects=("$1")
  shift
fi
"$here/setup.sh"
"$here/build.sh" release "${subjects[@]/#/bench_}"

# Threads of the LAPACK that is linked, whichever it is.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 BLIS_NUM_THREADS=1
for subject in "${subjects[@]}"; do
  result=build/release/bench_$subject.json
  "build/release/bench/bench_$subject" --benchmark_out="$result" --benchmark_out_format=json "$@"
  if [ -e "$result" ]; then echo "written: $result" >&2; fi
done
