#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# compare.sh [plane_curves|bezier|patches] [OPTION...]
# Installs what is missing, the other solvers included, builds a comparison with them and prints its tables: times of
# each solver on the same input and the ratios, from one run with one thread. plane_curves (the default) compares with
# CGAL and PARI, bezier and patches with OCCT and SISL. Options are those of the program:
#   --markdown        tables for docs/benchmarks.md
#   --only TEXT       only the systems or families whose name contains TEXT
#   --limit SECONDS   wall-clock time that one run may take (plane_curves 60, patches 10)
#   --all             bezier, patches: every family that the tests generate
#   --cases N         patches: only the first N pairs of each family
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."

program=compare_plane_curves
case "${1:-}" in
  plane_curves | bezier | patches)
    program=compare_$1
    shift
    ;;
esac

"$here/setup.sh" libcgal-dev libmpfi-dev libpari-dev libsisl-dev \
  libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
cache=build/release/CMakeCache.txt
if ! grep -qs '^ELIMINANT_BUILD_COMPARISONS:BOOL=ON$' "$cache"; then
  cmake --preset release -DELIMINANT_BUILD_COMPARISONS=ON >&2
fi
"$here/build.sh" release "$program"

# Threads of the LAPACK that is linked, whichever it is.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 BLIS_NUM_THREADS=1
exec "build/release/bench/comparisons/$program" "$@"
