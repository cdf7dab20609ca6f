// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include <eliminant/numeric/multiplication_matrix.hpp>

namespace eliminant::bench {

/// The multiplication matrices of two curves of degrees m and n without common point at infinity from the null space
/// of their Macaulay matrix, for comparison with the hybrid Bezout matrix. Source: [TelenMourrainVanBarel2018], with
/// all multiples of p and q up to degree m + n - 1, and the basis chosen by column-pivoted QR.
inline numeric::MultiplicationMatrices<double> macaulay_multiplication(const numeric::BivariatePolynomial<double>& p,
                                                                       const numeric::BivariatePolynomial<double>& q,
                                                                       long m, long n) {
  using Matrix = numeric::Matrix<double>;
  const long e = m + n - 1;
  // Monomials by total degree: x^i y^j at (i + j)(i + j + 1) / 2 + j.
  const auto index = [](long i, long j) { return (i + j) * (i + j + 1) / 2 + j; };
  const auto count = [](long degree) { return (degree + 1) * (degree + 2) / 2; };
  const long columns = count(e);
  const long lower = count(e - 1);
  Matrix transposed = Matrix::Zero(columns, count(e - m) + count(e - n));
  long relation = 0;
  for (const auto& [curve, degree] : {std::pair{&p, m}, {&q, n}})
    for (long b = 0; b <= e - degree; ++b)
      for (long a = 0; a + b <= e - degree; ++a, ++relation)
        for (long i = 0; i < curve->coefficients.rows(); ++i)
          for (long j = 0; i + j <= degree && j < curve->coefficients.cols(); ++j)
            transposed(index(a + i, b + j), relation) = curve->coefficients(i, j);
  // The last columns of Q span the null space.
  const long dimension = m * n;
  const Eigen::ColPivHouseholderQR<Matrix> orthogonal(transposed);
  Matrix null_space = Matrix::Identity(columns, columns).rightCols(dimension);
  null_space.applyOnTheLeft(orthogonal.householderQ());
  const Eigen::ColPivHouseholderQR<Matrix> basis_choice(null_space.topRows(lower).transpose());
  std::vector<std::pair<long, long>> basis;
  Matrix values(dimension, dimension);
  for (long k = 0; k < dimension; ++k) {
    const long chosen = basis_choice.colsPermutation().indices()(k);
    long degree = 0;
    while (count(degree) <= chosen) ++degree;
    const long j = chosen - index(degree, 0);
    basis.emplace_back(degree - j, j);
    values.row(k) = null_space.row(chosen);
  }
  const Eigen::PartialPivLU<Matrix> solver(values.transpose());
  const auto multiplied = [&](long dx, long dy) {
    Matrix image(dimension, dimension);
    for (long k = 0; k < dimension; ++k)
      image.row(k) = null_space.row(
          index(basis[static_cast<std::size_t>(k)].first + dx, basis[static_cast<std::size_t>(k)].second + dy));
    return Matrix(solver.solve(image.transpose()).transpose());
  };
  return {multiplied(1, 0), multiplied(0, 1)};
}

}  // namespace eliminant::bench
