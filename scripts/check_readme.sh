#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_readme.sh PROGRAM [--update]
# Runs every command of README.md that stands in a block "sh" and begins with "eliminant", and compares what it prints,
# except for the wall-clock seconds, with the block "text" that follows. With --update that block is written instead.
set -euo pipefail
program=$1 update=${2:-}
cd "$(dirname "$0")/.."

ELIMINANT=$program UPDATE=$update exec perl - <<'PERL'
use strict;
use warnings;
open my $handle, '<', 'README.md' or die "README.md: $!";
my $text = do { local $/; <$handle> };
close $handle;
my ($checked, $different) = (0, 0);
$text =~ s{(```sh\neliminant (.*?)\n```\n\n```text\n)(.*?)(```\n)}{
  my ($before, $arguments, $expected, $after) = ($1, $2, $3, $4);
  my $printed = `"\$ELIMINANT" $arguments`;
  my ($seen, $wanted) = map { s/^\s*seconds\b.*\n//mgr } $printed, $expected;
  $checked++;
  if ($seen ne $wanted) {
    $different++;
    print "eliminant $arguments\nnow prints\n$printed\nand README.md has\n$expected\n" if !$ENV{UPDATE};
  }
  $before . ($ENV{UPDATE} ? $printed : $expected) . $after
}gse;
if ($ENV{UPDATE}) {
  open $handle, '>', 'README.md' or die "README.md: $!";
  print $handle $text;
  close $handle;
  exit 0;
}
print "README.md: $checked outputs, $different different\n";
exit($checked == 0 || $different ? 1 : 0);
PERL
