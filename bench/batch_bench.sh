#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# batch_bench.sh BUILD [COUNT [DEGREE]]
# Solves COUNT pairs of plane curves (default 100000, of degree 2) with eliminant batch of the build tree BUILD: with one
# and two workers, and, where eliminant-mpi was built, with one and two ranks. Prints for each the seconds of wall-clock
# and of processor time, problems per second of both, the largest memory of one process, and whether the results are
# the same. The processor time of mpirun counts no workers, so it is not shown.
set -euo pipefail
build=$(cd "$1" && pwd) count=${2:-100000} degree=${3:-2}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$(dirname "$0")/../scripts/batch_problems.sh" "$count" "$degree" >"$folder/problems"
nproc=$(nproc)
echo "$count problems of degree $degree, $nproc processors, load $(cut -d' ' -f1 /proc/loadavg)"

# measure NAME COMMAND...
measure() {
  local name=$1
  shift
  rm -f "$folder/results" "$folder/results.state"
  /usr/bin/time -o "$folder/time" -f '%e %U %S %M' "$@" "$folder/problems" -o "$folder/results"
  [ -e "$folder/first" ] || cp "$folder/results" "$folder/first"
  local same=same
  cmp -s "$folder/results" "$folder/first" || same=DIFFERENT
  awk -v name="$name" -v n="$count" -v same="$same" '{
    cpu = $2 + $3
    shown = name ~ /rank/ ? "" : sprintf("%8.2f s processor %7.0f/s", cpu, n / cpu)
    printf "%-10s %8.2f s wall %7.0f/s %s %7.1f MB %s\n", name, $1, n / $1, shown, $4 / 1024, same }' "$folder/time"
}

measure "1 worker" "$build/eliminant" batch
measure "2 workers" "$build/eliminant" batch --threads 2
if [ -x "$build/eliminant-mpi" ]; then
  run=(mpirun --oversubscribe)
  [ "$(id -u)" -ne 0 ] || run+=(--allow-run-as-root)
  measure "1 rank" "${run[@]}" -n 1 "$build/eliminant-mpi"
  measure "2 ranks" "${run[@]}" -n 2 "$build/eliminant-mpi"
fi
