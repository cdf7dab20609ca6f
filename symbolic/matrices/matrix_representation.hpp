// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

/// A matrix of linear forms whose rank drops on a curve or surface: M(x) = sum over k of x_k coefficients[k], x the
/// homogeneous coordinates, weight last. It is computed once and used for any number of curves.
/// Source: [LuuBuseMourrain2009], Definition 1.
struct MatrixRepresentation {
  std::vector<IntegerMatrix> coefficients;
  /// The monomial in the parameters that belongs to each row: its exponents. At a point of the curve or surface the
  /// left kernel contains the values of these monomials at the parameters of the point.
  std::vector<std::vector<unsigned long>> row_monomials;

  long rows() const { return coefficients.front().rows(); }
  long columns() const { return coefficients.front().columns(); }
};

}  // namespace eliminant::symbolic
