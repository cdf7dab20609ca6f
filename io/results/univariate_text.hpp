// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::io {

/// The polynomial in its variable, in the grammar of parse_polynomial.
std::string univariate_text(const symbolic::UnivariatePolynomial& p, const std::string& variable);

}  // namespace eliminant::io
