#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# compare.sh [plane_curves|bezier|patches|cylinders] [OPTION...]
# Installs what is missing, the other solvers included, builds a comparison with them and prints its tables: times of
# each solver on the same input and the ratios, from one run with one thread. plane_curves (the default) compares with
# CGAL and PARI, bezier and patches with OCCT and SISL, cylinders with PCL. Options are those of the program:
#   --markdown        tables for docs/benchmarks.md (cylinders: always)
#   --only TEXT       only the systems or families whose name contains TEXT
#   --limit SECONDS   wall-clock time that one run may take (plane_curves 60, patches 10)
#   --all             bezier, patches: every family that the tests generate
#   --cases N         patches: only the first N pairs of each family
#   --first N, --last N, --threads N   cylinders: which scenes, and the threads of eliminant
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."

program=compare_plane_curves
case "${1:-}" in
  plane_curves | bezier | patches | cylinders)
    program=compare_$1
    shift
    ;;
esac

# PCL is large, and nothing else needs it.
pcl=()
if [ "$program" = compare_cylinders ]; then pcl=(libpcl-dev); fi
"$here/setup.sh" "${pcl[@]}" libcgal-dev libmpfi-dev libpari-dev libsisl-dev \
  libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
cache=build/release/CMakeCache.txt
if ! grep -qs '^ELIMINANT_BUILD_COMPARISONS:BOOL=ON$' "$cache" || [ ${#pcl[@]} -gt 0 ]; then
  cmake --preset release -DELIMINANT_BUILD_COMPARISONS=ON >&2
fi
"$here/build.sh" release "$program"

# Threads of the LAPACK that is linked, whichever it is.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 BLIS_NUM_THREADS=1
exec "build/release/bench/comparisons/$program" "$@"
