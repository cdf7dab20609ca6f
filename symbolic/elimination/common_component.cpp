// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>

namespace eliminant::symbolic {

CommonComponent split_common_component(const Polynomial& p, const Polynomial& q) {
  if (p.variable_count() != q.variable_count())
    throw InvalidInput("the common component of polynomials in different rings was asked for", "the same variables");
  const Polynomial f = p.primitive_part();
  const Polynomial g = q.primitive_part();
  Polynomial common(p.variable_count());
  if (fmpq_mpoly_gcd(common.get(), f.get(), g.get(), common.ring()) == 0)
    throw LimitReached("the greatest common divisor of the two polynomials is too large to compute");
  common = common.primitive_part();
  if (common.is_zero()) return {common, f, g};
  return {common, exact_quotient(f, common), exact_quotient(g, common)};
}

}  // namespace eliminant::symbolic
