// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// A polynomial in (u, v) as a form over the product of two projective lines, of this bidegree at least its own.
struct BidegreeForm {
  symbolic::Polynomial polynomial{2};
  std::array<long, 2> degrees{};
};

/// Proof that the forms have no real zero in common on the product of two projective lines, apart from points with both
/// parameters 0 or infinite at which all `ignored` vanish. There the first form may have an isolated zero of order two
/// (its Hessian is definite around). False decides nothing. By subdivision in Bernstein form with bounded roundings.
bool have_no_common_real_zero(const std::vector<BidegreeForm>& forms, const std::vector<BidegreeForm>& ignored,
                              const Context& context);

}  // namespace eliminant::intersect
