#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# setup.sh [PACKAGE...]
# Installs what the build needs and this machine does not have, with apt-get (Debian 12 or later, Ubuntu 24.04 or later),
# and the further packages named. Does nothing, at once, when nothing is missing.
set -euo pipefail

wanted=(
  g++ cmake ninja-build perl
  libflint-dev libgmp-dev libmpfr-dev libopenblas-pthread-dev libeigen3-dev libboost-dev
  nlohmann-json3-dev libfmt-dev libcli11-dev doctest-dev libbenchmark-dev
  "$@"
)

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: no apt-get here; install the equivalents of: ${wanted[*]} (and Arb 2.23 if FLINT is older than 3)" >&2
  exit 0
fi

declare -A version
read_installed() {
  version=()
  local status package number
  while read -r status package number; do
    if [ "$status" = ii ]; then version[${package%%:*}]=$number; fi
  done < <(dpkg-query -W -f '${db:Status-Abbrev} ${Package} ${Version}\n' "${wanted[@]}" libflint-arb-dev 2>/dev/null)
}

# What apt would install of a package; empty when it knows none.
candidate() { LC_ALL=C apt-cache policy "$1" 2>/dev/null | sed -nE '/\(none\)/d; s/^ *Candidate: *//p'; }

# FLINT 3 contains Arb; with FLINT 2 it is a package of its own.
contains_arb() { dpkg --compare-versions "$1" ge 3~; }

read_installed
missing=()
for package in "${wanted[@]}"; do
  if [ -z "${version[$package]:-}" ]; then missing+=("$package"); fi
done
flint=${version[libflint-dev]:-}
if [ ${#missing[@]} -eq 0 ] && { contains_arb "$flint" || [ -n "${version[libflint-arb-dev]:-}" ]; }; then
  exit 0
fi

root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: missing and not installed, for want of root or sudo: ${missing[*]:-libflint-arb-dev}" >&2
    exit 0
  fi
  root=(sudo)
fi

"${root[@]}" apt-get update -qq >&2 || echo "setup: the package lists could not be updated; going on with the old" >&2
flint=${flint:-$(candidate libflint-dev)}
if [ -n "$flint" ] && ! contains_arb "$flint" && [ -z "${version[libflint-arb-dev]:-}" ]; then
  missing+=(libflint-arb-dev)
fi
available=()
for package in "${missing[@]}"; do
  if [ -n "$(candidate "$package")" ]; then
    available+=("$package")
  else
    echo "setup: apt does not know $package" >&2
  fi
done
if [ ${#available[@]} -gt 0 ]; then
  echo "setup: installing ${available[*]}" >&2
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${available[@]}" >&2
fi
