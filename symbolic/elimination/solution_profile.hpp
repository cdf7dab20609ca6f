// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/elimination/chow_form.hpp>

namespace eliminant::symbolic {

/// How many affine solutions two coprime curves have, as seen modulo one prime.
struct SolutionProfile {
  /// Degree of the Chow form: affine solutions with multiplicity. Over Q it is at least this; it is exactly this when
  /// `bezout_holds` (nothing lies at infinity) or once the Chow form is known over Z.
  unsigned long with_multiplicity = 0;
  /// Number of distinct solutions of multiplicity k at index k - 1. Over Q there are at least as many distinct ones in
  /// total, so a profile with simple solutions only is exact as soon as `with_multiplicity` is.
  std::vector<unsigned long> distinct_by_multiplicity;
  /// The leading forms are coprime (proven): no solution lies at infinity.
  bool bezout_holds = false;
  /// The smallest shear in the order 0, 1, -1, 2, ... that separates the solutions modulo the prime.
  long shear = 0;

  unsigned long distinct() const;
  bool all_simple() const { return distinct() == with_multiplicity; }
};

/// True when the leading forms are proven coprime (their resultant is not zero modulo one prime): the curves do not
/// meet at infinity, and Bezout's number counts the affine solutions.
bool do_not_meet_at_infinity(const Polynomial& p, const Polynomial& q, std::uint64_t seed);

/// p and q primitive over Z, coprime, not both constant.
SolutionProfile solution_profile(const Polynomial& p, const Polynomial& q, std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
