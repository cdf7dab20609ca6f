// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace eliminant::intersect {

/// box: subdivision of bounded curves and patches, and the matrix engines for what it cannot decide.
enum class Engine { automatic, pencil, exact, box };
/// Which matrix the pencil is built from: those of the paper, or the hybrid Bezout matrix of the graded pencil, which
/// needs curves that do not meet at infinity and double precision; automatic takes it where it can.
enum class ResultantMatrix { automatic, sylvester, bezout, hybrid };
/// Which solutions are listed; the counts are always those of the whole complex plane.
enum class Field { automatic, real, complex };

/// What a caller may choose; every field has the default that the command line has.
struct Options {
  /// Significant decimal digits of each coordinate; 1 to 100000.
  long digits = 15;
  Engine engine = Engine::automatic;
  ResultantMatrix matrix = ResultantMatrix::automatic;
  /// Bits of the numeric stage: 53, 128, 256, 512 or 1024; 0 lets the solver start at 53 and climb.
  int precision_bits = 0;
  /// The paper's epsilon ([BuseKhalilMourrain2005], Algorithm 2): it decides how the numeric stage gathers eigenvalues
  /// and chooses ranks, never what is reported. Unset: the number of clusters is the exact number of distinct roots.
  std::optional<double> epsilon;
  Field field = Field::automatic;
  /// Prove each solution and the completeness of the list where that is possible.
  bool certify = true;
  /// Write a certificate of the result (Result::certificate).
  bool certificate = false;
  /// Compute the implicit equation, too (implicitize).
  bool equation = false;
  /// Of traced curves: largest distance of a polyline from the curve, relative to the size of the patches.
  double tolerance = 1e-9;
  /// Fit B-splines to traced curves, too.
  bool splines = false;
  /// Seeds the choice of primes. The answer does not depend on it.
  std::uint64_t seed = 0;
  /// Worker threads; the answer does not depend on it.
  unsigned threads = 1;
};

}  // namespace eliminant::intersect
