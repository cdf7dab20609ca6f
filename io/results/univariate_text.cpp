// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/univariate_text.hpp>

#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::io {

std::string univariate_text(const symbolic::UnivariatePolynomial& p, const std::string& variable) {
  std::vector<symbolic::Polynomial::Term> terms;
  for (long k = 0; k <= p.degree(); ++k)
    if (const symbolic::Integer coefficient = p.coefficient(k); !coefficient.is_zero())
      terms.push_back({coefficient, {static_cast<unsigned long>(k)}});
  return symbolic::to_string(symbolic::Polynomial::from_terms(1, terms), std::vector<std::string>{variable});
}

}  // namespace eliminant::io
