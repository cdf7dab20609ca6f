#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_references.sh
# Every source key in a comment or a page, like [BuseKhalilMourrain2005], must have its entry in docs/references.md.
set -euo pipefail
cd "$(dirname "$0")/.."

folders=()
for folder in base symbolic numeric bridge intersect io cli tests bench examples docs; do
  if [ -d "$folder" ]; then folders+=("$folder"); fi
done
unresolved=0
while read -r key; do
  if ! grep -qF -- "- **$key**" docs/references.md; then
    echo "no entry in docs/references.md for $key, used in"
    grep -rlF "$key" "${folders[@]}" README.md | sed 's/^/  /'
    unresolved=1
  fi
done < <(grep -rhoE '\[[A-Z][A-Za-z]+[12][0-9]{3}[a-z]?\]' "${folders[@]}" README.md | sort -u)
exit $unresolved
