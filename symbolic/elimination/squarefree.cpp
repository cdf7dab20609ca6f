// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::symbolic {

std::vector<SquarefreeFactor> squarefree_decomposition(const UnivariatePolynomial& p) {
  if (p.is_zero()) throw InvalidInput("the squarefree decomposition of zero was asked for", "a non-zero polynomial");
  std::vector<SquarefreeFactor> result;
  if (p.degree() == 0) return result;
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor_squarefree(factors, p.get());
  for (slong i = 0; i < factors->num; ++i)
    result.push_back(
        {UnivariatePolynomial(factors->p + i).primitive_part(), static_cast<unsigned long>(factors->exp[i])});
  fmpz_poly_factor_clear(factors);
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.multiplicity < b.multiplicity; });
  return result;
}

}  // namespace eliminant::symbolic
