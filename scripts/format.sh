#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# format.sh [--apply]
# Checks that every source is formatted as .clang-format says, or formats it. Versions of clang-format differ in what
# they make of one style; 14 is the one that counts.
set -euo pipefail
cd "$(dirname "$0")/.."

formatter=
for name in clang-format-14 clang-format; do
  if command -v "$name" >/dev/null && "$name" --version | grep -q 'version 14\.'; then
    formatter=$name
    break
  fi
done
if [ -z "$formatter" ]; then
  echo "format: clang-format 14 is not installed" >&2
  exit 1
fi

mapfile -t files < <(git ls-files --cached --others --exclude-standard -- '*.cpp' '*.hpp')
existing=()
for file in "${files[@]}"; do
  if [ -f "$file" ]; then existing+=("$file"); fi
done
if [ "${1:-}" = --apply ]; then
  "$formatter" -i "${existing[@]}"
elif ! "$formatter" --dry-run -Werror "${existing[@]}"; then
  echo "format: run scripts/format.sh --apply" >&2
  exit 1
else
  echo "format: ${#existing[@]} files are formatted"
fi
