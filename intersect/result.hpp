// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/intersect/plane_curves/certificate.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

enum class Status {
  certified,   ///< every solution proven, multiplicities exact, nothing missing
  numeric,     ///< computed, not proven complete
  infinite,    ///< infinitely many solutions; the rest is listed
  incomplete,  ///< a limit was reached
};

/// Never a guess: `undecided` is neither proven real nor proven non-real.
enum class Reality { real, non_real, undecided };

/// One coordinate: an enclosure, and the decimal digits that are printed of it.
struct Coordinate {
  bridge::ComplexBall ball;
  std::string real;
  std::string imaginary;
  /// Where it is known to be this rational number.
  std::optional<symbolic::Rational> exact;
};

struct Solution {
  Coordinate x;
  Coordinate y;
  /// Power of ten that bounds the distance of the true solution in each coordinate: 10^radius_exponent.
  long radius_exponent = 0;
  Reality reality = Reality::undecided;
  unsigned long multiplicity = 1;
  /// Exactly one solution, of exactly this multiplicity, lies within the radius.
  bool certified = false;
  /// Why not, where `certified` is false.
  std::string reason;
};

/// The count audit over the whole complex plane, also when only a part of the solutions is listed:
/// bezout_number = with_multiplicity + at_infinity.
struct Counts {
  unsigned long distinct = 0;
  unsigned long real = 0;
  unsigned long undecided = 0;
  unsigned long with_multiplicity = 0;
  unsigned long at_infinity = 0;
  unsigned long bezout_number = 0;
  /// Number of solutions listed (differs from `distinct` when only real ones, or only those of a box, are listed).
  unsigned long listed = 0;
};

/// How many distinct points of which multiplicity the numeric clusters of a pencil show, without any exact help.
struct PencilMultiplicities {
  /// Affine points of multiplicity k at index k - 1.
  std::vector<unsigned long> distinct_by_multiplicity;
  unsigned long at_infinity = 0;

  friend bool operator==(const PencilMultiplicities&, const PencilMultiplicities&) = default;
};

/// What ran. Fields that do not apply stay at their defaults and are not printed.
struct EngineReport {
  std::string method;           ///< "pencil", "exact" or "none" (nothing had to be solved)
  std::string matrix;           ///< "bezout" or "sylvester"
  std::string hidden_variable;  ///< the variable kept in the entries of the matrix
  long matrix_size = 0;
  long matrix_degree = 0;
  long pencil_size = 0;
  /// Columns of the regular part: the number of finite eigenvalues.
  long regular_size = 0;
  int precision_bits = 0;
  /// Of a curve and a surface whose matrix is not square: "projection" or "staircase".
  std::string singular_pencil;
  /// s of the verified generic shear x + s y, where multiplicities needed one.
  std::optional<long> shear;
  /// Largest change of a coordinate (relative to max(1, |coordinate|)) by the refinement of the pencil's solutions.
  std::optional<double> largest_error_before_refinement;
  /// Of the pencil engine alone, for up to 100 solutions: for comparison, nothing rests on it.
  std::optional<PencilMultiplicities> pencil_multiplicities;
  std::uint64_t seed = 0;
};

struct Result {
  std::string problem = "plane_curves";
  Status status = Status::numeric;
  /// Only for `incomplete`: what ended the computation. The solutions are those found so far, and the counts are
  /// theirs.
  std::optional<std::string> limit;
  /// Only for `infinite`: what is proven of the rest.
  std::optional<Status> rest_status;
  std::vector<std::string> variables{"x", "y"};
  Counts counts;
  /// Sorted by (Re x, Im x, Re y, Im y).
  std::vector<Solution> solutions;
  /// Only for `infinite`: the greatest common divisor of the two polynomials, primitive over Z; 0 if both vanish.
  std::optional<symbolic::Polynomial> common_component;
  EngineReport engine;
  /// Where it was asked for and everything is proven: of all solutions, also when only some are listed.
  std::optional<Certificate> certificate;
  /// Stage name and wall-clock seconds, in the order of the stages; "total" comes first.
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

}  // namespace eliminant::intersect
