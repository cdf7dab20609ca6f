#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# compare.sh [OPTION...]
# Installs what is missing, CGAL and PARI included, builds the comparison with them and prints its tables: milliseconds of
# each solver on the same curves and the ratios, from one run with one thread. Options are those of the program:
#   --markdown        tables for docs/benchmarks.md
#   --limit SECONDS   wall-clock time that one run may take (60)
#   --only TEXT       only the systems whose name contains TEXT
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."

"$here/setup.sh" libcgal-dev libmpfi-dev libpari-dev
cache=build/release/CMakeCache.txt
if ! grep -qs '^ELIMINANT_BUILD_COMPARISONS:BOOL=ON$' "$cache"; then
  cmake --preset release -DELIMINANT_BUILD_COMPARISONS=ON >&2
fi
"$here/build.sh" release compare_plane_curves

# Threads of the LAPACK that is linked, whichever it is.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 BLIS_NUM_THREADS=1
exec build/release/bench/comparisons/compare_plane_curves "$@"
