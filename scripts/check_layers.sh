#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_layers.sh [FOLDER]
# Checks the order of the layers in the source tree FOLDER (default: this one). The build already refuses to include a
# layer that is not linked; this check finds what the include paths of a machine let through:
#   symbolic/   is exact: no floating-point type, literal or function, no Eigen, Boost, MPFR, LAPACK (flint_headers.hpp
#               includes MPFR for bridge/, as FLINT 3 wants it)
#   numeric/    knows no FLINT and nothing of symbolic/
#   cli/, mpi/  only call intersect/, io/ and batch/
#   each layer  includes only itself and those below: base < symbolic, numeric < bridge < intersect < io < batch < cli < mpi
# Comments and string literals do not count. Prints every violation as file:line: text.
set -euo pipefail
root=${1:-$(cd "$(dirname "$0")/.." && pwd)}
cd "$root"

exec perl - <<'PERL'
use strict;
use warnings;
use File::Find;

my $floating_names = join '|',
  qw(float double float_t double_t _Float16 _Float32 _Float64 _Float128 __float128 mpfr_t mpf_t mpf_class),
  # reading an exact number into a double, and back
  qw(\w+_get_d \w+_get_d_2exp \w+_set_d \w+_get_mpfr \w+_set_d_2exp stod strtod stof strtof),
  'std::(?:sqrt|cbrt|pow|exp2?|log|log2|log10|log1p|hypot|sin|cos|tan|atan2?|floor|ceil|round|trunc|ldexp|frexp|fma|'
  . 'lround|nearbyint|isnan|isfinite|complex)';
my $floating_literal = '(?<![\w.])(?:\d[\d\x27]*\.[\d\x27]*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+|'
  . '0[xX][\da-fA-F.]+[pP][+-]?\d+)[fFlL]?(?![\w.])';
my $flint_names = '(?:fmpz|fmpq|nmod|n_mod|ulong_extras|arb|acb|arf|acf|mag|flint|fq|padic)(?:_\w+)?|symbolic::\w*|'
  . 'namespace\s+symbolic';
my $floating_headers = 'Eigen/|unsupported/Eigen|boost/|mpfr\.h|lapacke?\.h|cblas\.h|cmath|math\.h|cfloat|float\.h|complex|'
  . 'numbers|random';
my $flint_headers = 'flint/|arb\w*\.h|acb\w*\.h|arf\.h|mag\.h|fmpz|fmpq';

my %rules = (
  base      => {may => 'base'},
  symbolic  => {may => 'base|symbolic', words => "$floating_names", literal => 1, headers => $floating_headers},
  numeric   => {may => 'base|numeric', words => $flint_names, headers => $flint_headers},
  bridge    => {may => 'base|symbolic|numeric|bridge'},
  intersect => {may => 'base|symbolic|numeric|bridge|intersect'},
  io        => {may => 'base|symbolic|numeric|bridge|intersect|io'},
  batch     => {may => 'base|io|batch'},
  cli       => {may => 'base|intersect|io|batch|cli', headers => "$flint_headers|Eigen/|boost/|mpfr\\.h|lapack"},
  mpi       => {may => 'base|io|batch|cli|mpi', headers => "$flint_headers|Eigen/|boost/|mpfr\\.h|lapack"},
);

my ($files, $violations) = (0, 0);
sub violation {
  my ($file, $line, $what, $text) = @_;
  $text =~ s/^\s+|\s+$//g;
  print "$file:$line: $what: $text\n";
  $violations++;
}

for my $layer (sort keys %rules) {
  next unless -d $layer;
  my $rule = $rules{$layer};
  my @sources;
  find({no_chdir => 1, wanted => sub { push @sources, $_ if /\.[ch]pp$/ || /\.[ch]$/ }}, $layer);
  for my $file (sort @sources) {
    $files++;
    open my $handle, '<', $file or die "$file: $!";
    local $/;
    my $text = <$handle>;
    close $handle;
    # Blank out comments and literals, but keep the lines and the names in include directives.
    $text =~ s{
        (^[ \t]*\#[ \t]*include[^\n]*)
      | ((?<=[\da-fA-F])\x27(?=[\da-fA-F]))
      | R"([^()\s\\]{0,16})\(.*?\)\3"
      | "(?:\\.|[^"\\\n])*" | \x27(?:\\.|[^\x27\\\n])*\x27
      | //[^\n]* | /\*.*?\*/
    }{
      my $whole = $&;
      defined $1 ? $1 =~ s{(//|/\*).*}{}r : defined $2 ? '' : '""' . ("\n" x ($whole =~ tr/\n//))
    }gsemx;
    my @lines = split /\n/, $text, -1;
    for my $index (0 .. $#lines) {
      my ($code, $number) = ($lines[$index], $index + 1);
      if ($code =~ /^\s*#\s*include\s*[<"]([^>"]*)/) {
        my $header = $1;
        violation($file, $number, "$layer/ must not include this layer", $code)
          if $header =~ m{^eliminant/(\w+)/} && $1 !~ /^(?:$rule->{may})$/;
        violation($file, $number, "$layer/ must not include this header", $code)
          if defined $rule->{headers} && !($file =~ m{/flint_headers\.hpp$} && $header eq 'mpfr.h') && $header =~ m{^(?:$rule->{headers})(?:$|(?<=/)|[\w/.]*$)};
        next;
      }
      violation($file, $number, "$layer/ must not use this name", $code)
        if defined $rule->{words} && $code =~ /(?<![\w])(?:$rule->{words})(?!\w)/;
      violation($file, $number, "$layer/ must not use a floating-point literal", $code)
        if $rule->{literal} && $code =~ /$floating_literal/;
    }
  }
}
print "layers: $files files, $violations violations\n";
exit($violations ? 1 : 0);
PERL
