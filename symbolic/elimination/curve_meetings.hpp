// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

/// A rational curve in space over a prime field: the coefficient vectors of the powers of its parameter, the weight
/// first. Its degree is the number of vectors minus 1, even where the last one vanishes (a common zero at infinity).
using ModularSpaceCurve = std::vector<std::array<mp_limb_t, 4>>;

/// What two curves of a pair have in common, each over the whole projective line of its parameter.
struct CurveMeetings {
  bool first_has_base_point = false;  ///< its four coordinates have a common zero
  bool second_has_base_point = false;
  /// They have a curve in common, or both are the same point: the numbers below are zero.
  bool infinite = false;
  /// Different parameters of the first curve at common points, with weight not zero and zero.
  long finite = 0;
  long at_infinity = 0;
  /// Monic, its roots the values at the common points of the ratio of two linear forms, which `projection_seed` fixes.
  std::vector<mp_limb_t> images;
  /// The parameters of the first curve at common points, as the roots of a polynomial, ascending coefficients; the one
  /// at infinity is left out. Empty where there are none.
  std::vector<mp_limb_t> parameters;
  /// There are common points, all at the infinite parameter of the first curve.
  bool infinite_parameters = false;
};

/// A pair of parameters that does not count.
struct TrivialPair {
  mp_limb_t first = 0;
  mp_limb_t second = 0;
};

/// The common points of two curves, those of the trivial pair left out (but not others with one of its parameters):
/// common roots of resultants of random bilinear conditions that hold for equal points. Common zeros of the coordinates
/// are divided out first. A number may be wrong for few choices of `seed`.
CurveMeetings curve_meetings(const ModularSpaceCurve& first, const ModularSpaceCurve& second,
                             const std::optional<TrivialPair>& trivial, const PrimeField& field, std::uint64_t seed,
                             std::uint64_t projection_seed);

}  // namespace eliminant::symbolic
