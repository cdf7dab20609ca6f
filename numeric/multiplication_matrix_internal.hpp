// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The definition behind multiplication_matrix.hpp; included only by the translation units that instantiate it.

#include <algorithm>
#include <numeric>

#include <Eigen/LU>

#include <eliminant/numeric/multiplication_matrix.hpp>

namespace eliminant::numeric {

/// LU factorisation with partial pivoting of a tall matrix, in place; order[k] is the original index of row k.
/// False when a pivot is zero.
template <class Scalar>
bool tall_lu(Matrix<Scalar>& matrix, std::vector<long>& order) {
  using std::abs;
  for (long k = 0; k < matrix.cols(); ++k) {
    long pivot = k;
    for (long i = k + 1; i < matrix.rows(); ++i)
      if (abs(matrix(i, k)) > abs(matrix(pivot, k))) pivot = i;
    if (matrix(pivot, k) == 0) return false;
    if (pivot != k) {
      matrix.row(k).swap(matrix.row(pivot));
      std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(pivot)]);
    }
    const long below = matrix.rows() - k - 1;
    const long right = matrix.cols() - k - 1;
    matrix.col(k).tail(below) /= matrix(k, k);
    matrix.bottomRightCorner(below, right).noalias() -= matrix.col(k).tail(below) * matrix.row(k).tail(right);
  }
  return true;
}

template <>
bool tall_lu(Matrix<double>& matrix, std::vector<long>& order);

template <class Scalar>
std::optional<MultiplicationMatrices<Scalar>> multiplication_matrices(const MatrixPolynomial<Scalar>& hybrid_bezout,
                                                                      const BivariatePolynomial<Scalar>& p,
                                                                      const BivariatePolynomial<Scalar>& q, long m,
                                                                      long n) {
  using std::abs;
  const long e = m + n - 1;
  const long dimension = m * n;
  // Monomials x^i y^j of W_(e-1), by j and then i, have index offset(j) + i; those of degree e are numbered by j.
  std::vector<long> offset(static_cast<std::size_t>(m) + 1, 0);
  for (long j = 0; j < m; ++j) offset[static_cast<std::size_t>(j) + 1] = offset[static_cast<std::size_t>(j)] + e - j;
  const auto index = [&](long i, long j) { return offset[static_cast<std::size_t>(j)] + i; };
  const long lower_count = offset.back();
  const auto row_degree = [&](long r) { return r < n ? m + r : r; };
  const auto entry = [&](long r, long j, long k) -> const Scalar& {
    return hybrid_bezout.coefficients[static_cast<std::size_t>(k)](r, j);
  };
  const long x_degree = hybrid_bezout.degree();
  std::vector<Scalar> scale(static_cast<std::size_t>(m), Scalar(0));
  for (long r = 0; r < m; ++r) {
    for (long j = 0; j < m; ++j)
      for (long k = 0; k <= x_degree; ++k)
        scale[static_cast<std::size_t>(r)] = std::max(scale[static_cast<std::size_t>(r)], Scalar(abs(entry(r, j, k))));
    if (scale[static_cast<std::size_t>(r)] == 0) return std::nullopt;
  }

  // Step 1, transposed: one column for each relation.
  Matrix<Scalar> relations = Matrix<Scalar>::Zero(lower_count, lower_count - dimension);
  long column = 0;
  for (long r = 0; r < m; ++r)
    for (long l = 0; l <= e - 1 - row_degree(r); ++l, ++column)
      for (long j = 0; j < m; ++j)
        for (long k = 0; k <= std::min(x_degree, row_degree(r) - j); ++k)
          relations(index(k + l, j), column) = entry(r, j, k) / scale[static_cast<std::size_t>(r)];

  // Step 2. position[monomial] < rank: a pivot, its row in Z; otherwise rank + its place among the normal monomials.
  const long rank = relations.cols();
  if (!all_finite(relations)) return std::nullopt;
  std::vector<long> order(static_cast<std::size_t>(lower_count));
  std::iota(order.begin(), order.end(), 0L);
  if (!tall_lu(relations, order)) return std::nullopt;
  std::vector<long> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[static_cast<std::size_t>(order[k])] = static_cast<long>(k);
  Matrix<Scalar> z = -relations.bottomRows(dimension).transpose();
  relations.topRows(rank).template triangularView<Eigen::UnitLower>().transpose().solveInPlace(z);
  const auto add_lower = [&](auto&& target, long monomial, const Scalar& factor) {
    const long place = position[static_cast<std::size_t>(monomial)];
    if (place < rank)
      target += factor * z.row(place);
    else
      target(place - rank) += factor;
  };

  // Step 3.
  Matrix<Scalar> top_coefficients = Matrix<Scalar>::Zero(m, m);
  Matrix<Scalar> pivot_part = Matrix<Scalar>::Zero(m, rank);
  Matrix<Scalar> right_hand_side = Matrix<Scalar>::Zero(m, dimension);
  for (long r = 0; r < m; ++r) {
    const long l = e - row_degree(r);
    for (long j = 0; j < m; ++j)
      for (long k = 0; k <= std::min(x_degree, row_degree(r) - j); ++k) {
        const Scalar value = entry(r, j, k) / scale[static_cast<std::size_t>(r)];
        if (k + l + j == e) {
          top_coefficients(r, j) = value;
          continue;
        }
        const long place = position[static_cast<std::size_t>(index(k + l, j))];
        if (place < rank)
          pivot_part(r, place) -= value;
        else
          right_hand_side(r, place - rank) -= value;
      }
  }
  right_hand_side.noalias() += pivot_part * z;
  const Matrix<Scalar> top = top_coefficients.partialPivLu().solve(right_hand_side);

  // Step 4.
  const Scalar a = m < p.coefficients.cols() ? p.coefficients(0, m) : Scalar(0);
  const Scalar b = n < q.coefficients.cols() ? q.coefficients(0, n) : Scalar(0);
  const Scalar norm = a * a + b * b;
  MultiplicationMatrices<Scalar> result{Matrix<Scalar>::Zero(dimension, dimension),
                                        Matrix<Scalar>::Zero(dimension, dimension)};
  const auto add = [&](auto&& target, long i, long j, const Scalar& factor) {
    if (i + j == e)
      target += factor * top.row(j);
    else
      add_lower(target, index(i, j), factor);
  };
  for (long j = 0; j < m; ++j)
    for (long i = 0; i + j < e; ++i) {
      const long row = position[static_cast<std::size_t>(index(i, j))] - rank;
      if (row < 0) continue;
      add(result.x.row(row), i + 1, j, Scalar(1));
      if (j + 1 < m) {
        add(result.y.row(row), i, j + 1, Scalar(1));
        continue;
      }
      if (norm == 0) return std::nullopt;
      for (const auto& [curve, lift, weight] : {std::tuple{&p, 0L, Scalar(a / norm)}, {&q, m - n, Scalar(b / norm)}}) {
        if (weight == 0) continue;
        for (long k = 0; k < curve->coefficients.rows(); ++k)
          for (long l = 0; l < curve->coefficients.cols() && l + lift < m; ++l)
            if (curve->coefficients(k, l) != 0)
              add(result.y.row(row), i + k, l + lift, Scalar(-weight * curve->coefficients(k, l)));
      }
    }
  if (!all_finite(result.x) || !all_finite(result.y)) return std::nullopt;
  return result;
}

}  // namespace eliminant::numeric
