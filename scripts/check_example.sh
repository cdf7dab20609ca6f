#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_example.sh PROGRAM PROBLEM EXPECTED [--update]
# Solves PROBLEM and compares what is printed with the file EXPECTED, except for the wall-clock seconds. With --update
# EXPECTED is written instead.
set -euo pipefail

program=$1 problem=$2 expected=$3 update=${4:-}

# Times differ from run to run: the text output has them in lines that begin with "seconds".
without_seconds() { sed -E '/^[[:space:]]*seconds\b/d'; }

printed=$(mktemp)
trap 'rm -f "$printed"' EXIT
"$program" solve --quiet "$problem" | without_seconds >"$printed"
if [ "$update" = --update ]; then
  cp "$printed" "$expected"
  exit 0
fi
if ! without_seconds <"$expected" | diff -u --label "$expected" --label printed - "$printed"; then
  echo "the output for $problem changed; if it is right: $0 $program $problem $expected --update" >&2
  exit 1
fi
