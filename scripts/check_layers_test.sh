#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Plants violations in a copy of the source tree and expects check_layers.sh to find each of them, and nothing else.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
for layer in base symbolic numeric bridge intersect io cli; do
  if [ -d "$here/../$layer" ]; then cp -r "$here/../$layer" "$copy/"; fi
  mkdir -p "$copy/$layer"
done

failures=0
# expect found|clean FILE LINE: whether a file of this one line (after a harmless one) is a violation.
expect() {
  local verdict=$1 file=$2 line=$3 output
  printf 'namespace eliminant {}\n%s\n' "$line" >"$copy/$file"
  if output=$("$here/check_layers.sh" "$copy"); then
    if [ "$verdict" = found ]; then
      echo "not found in $file: $line"
      failures=$((failures + 1))
    fi
  elif [ "$verdict" = clean ] || ! grep -q "^$file:2: " <<<"$output" || [ "$(wc -l <<<"$output")" -ne 2 ]; then
    echo "expected $verdict for $file: $line; got"
    echo "$output"
    failures=$((failures + 1))
  fi
  rm "$copy/$file"
}

if ! "$here/check_layers.sh" "$copy"; then
  echo "the tree itself has violations; the rest of this test needs it clean"
  exit 1
fi

expect found symbolic/planted.cpp 'inline double half(long n);'
expect found symbolic/planted.cpp 'using T = float;'
expect found symbolic/planted.cpp 'long double x;'
expect found symbolic/planted.cpp 'auto x = fmpz_get_d(value);'
expect found symbolic/planted.cpp 'auto x = std::sqrt(n);'
expect found symbolic/planted.cpp 'auto x = n * 1.5;'
expect found symbolic/planted.cpp 'auto x = 1e9;'
expect found symbolic/planted.cpp 'auto x = 0x1p-53;'
expect found symbolic/planted.hpp '#include <Eigen/Dense>'
expect found symbolic/planted.hpp '#include <boost/multiprecision/mpfr.hpp>'
expect found symbolic/planted.hpp '#include <mpfr.h>'
expect found symbolic/planted.hpp '#include <cmath>'
expect found symbolic/planted.hpp '#include <eliminant/numeric/matrix_polynomial.hpp>'
expect found symbolic/planted.hpp '#  include "eliminant/bridge/enclosures/ball.hpp" // comment'
expect clean symbolic/planted.cpp '// a double of 1.5, as in Eigen'
expect clean symbolic/planted.cpp '/* float */ inline int doubled = 1; /* double */'
expect clean symbolic/planted.cpp 'const char* text = "double 0.5";'
expect clean symbolic/planted.cpp 'long n = 1'"'"'000'"'"'000; char c = '"'"'"'"'"'; int double_root = 0x1e5;'
expect found symbolic/planted.cpp 'long n = 1'"'"'000; double x; long m = 1'"'"'000;'
expect clean symbolic/planted.cpp 'int floating_part = row_3.size();'

expect found numeric/planted.hpp '#include <flint/fmpz.h>'
expect found numeric/planted.hpp '#include <arb.h>'
expect found numeric/planted.hpp '#include <eliminant/symbolic/arithmetic/rational.hpp>'
expect found numeric/planted.cpp 'fmpz_t x;'
expect found numeric/planted.cpp 'acb_mat_t x;'
expect found numeric/planted.cpp 'void f(const symbolic::Rational& r);'
expect clean numeric/planted.cpp 'double magnitude = 0.5; // as fmpz_get_d'

expect found bridge/planted.hpp '#include <eliminant/intersect/options.hpp>'
expect found intersect/planted.hpp '#include <eliminant/io/problem.hpp>'
expect found io/planted.hpp '#include <eliminant/cli/main.hpp>'
expect found base/planted.hpp '#include <eliminant/symbolic/arithmetic/rational.hpp>'
expect found cli/planted.cpp '#include <eliminant/symbolic/arithmetic/rational.hpp>'
expect found cli/planted.cpp '#include <eliminant/bridge/enclosures/ball.hpp>'
expect found cli/planted.cpp '#include <flint/fmpz.h>'
expect clean cli/planted.cpp '#include <eliminant/intersect/plane_curves/plane_curves.hpp>'
expect clean cli/planted.cpp '#include <eliminant/version.hpp>'

echo "layers self test: $failures failures"
[ "$failures" -eq 0 ]
