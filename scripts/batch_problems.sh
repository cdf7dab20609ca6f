#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# batch_problems.sh COUNT [DEGREE [SEED]]
# Prints COUNT problems for eliminant batch, one a line: pairs of dense plane curves of degree DEGREE (default 2) with
# integer coefficients from -9 to 9. The same arguments give the same problems.
set -euo pipefail
exec perl - "$1" "${2:-2}" "${3:-1}" <<'PERL'
use strict;
use warnings;
my ($count, $degree, $state) = @ARGV;

# The generator of Park and Miller, which is the same everywhere.
sub coefficient { $state = $state * 48271 % 2147483647; return $state % 19 - 9; }
sub polynomial {
  my @terms;
  for my $i (0 .. $degree) {
    push @terms, coefficient() . "*x^$i*y^$_" for 0 .. $degree - $i;
  }
  return join(' + ', @terms) =~ s/\+ -/- /gr;
}
for my $id (1 .. $count) {
  my ($p, $q) = (polynomial(), polynomial());
  print qq({"problem": "plane_curves", "id": $id, "p": "$p", "q": "$q"}\n);
}
PERL
