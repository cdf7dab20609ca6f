// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <eliminant/bridge/contacts/height_series.hpp>

namespace eliminant::bridge {

/// The splitting lemma for h(x, y) with h_y = 0 and h_yy != 0 at the origin: y = r(x) where h_y = 0, and h along it,
/// which alone decides what the zeros of h look like.

/// r up to the degree `order`: coefficients of 1 (which is 0), x, ..., x^order. Terms of h up to the degree order + 1
/// count; that of y is taken as 0.
template <class Scalar, std::size_t Highest>
std::vector<Scalar> height_ridge(const PlaneSeries<Scalar, Highest>& h, std::size_t order);

/// Coefficients of 1, x, ..., x^order of h(x, r(x)).
template <class Scalar, std::size_t Highest>
std::vector<Scalar> height_along(const PlaneSeries<Scalar, Highest>& h, const std::vector<Scalar>& ridge,
                                 std::size_t order);

/// Powers 0 to `highest` of a series without constant term, up to the degree `order`.
template <class Scalar>
std::vector<std::vector<Scalar>> powers_of(const std::vector<Scalar>& series, std::size_t highest, std::size_t order) {
  std::vector<std::vector<Scalar>> powers(highest + 1, std::vector<Scalar>(order + 1, Scalar(0)));
  powers[0][0] = Scalar(1);
  for (std::size_t j = 1; j <= highest; ++j)
    for (std::size_t a = 1; a < series.size() && a <= order; ++a)
      for (std::size_t b = 0; a + b <= order; ++b) powers[j][a + b] = powers[j][a + b] + series[a] * powers[j - 1][b];
  return powers;
}

template <class Scalar, std::size_t Highest>
std::vector<Scalar> height_ridge(const PlaneSeries<Scalar, Highest>& h, std::size_t order) {
  std::vector<Scalar> ridge(order + 1, Scalar(0));
  for (std::size_t n = 1; n <= order; ++n) {
    // The coefficient of x^n in h_y along what is known of the ridge.
    const auto powers = powers_of(ridge, n, n);
    Scalar rest(0);
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; i + j <= n; ++j)
        if (i + j > 0) rest = rest + Scalar(static_cast<long>(j + 1)) * h.at(i, j + 1) * powers[j][n - i];
    ridge[n] = Scalar(0) - rest / (Scalar(2) * h.at(0, 2));
  }
  return ridge;
}

template <class Scalar, std::size_t Highest>
std::vector<Scalar> height_along(const PlaneSeries<Scalar, Highest>& h, const std::vector<Scalar>& ridge,
                                 std::size_t order) {
  const auto powers = powers_of(ridge, order, order);
  std::vector<Scalar> result(order + 1, Scalar(0));
  for (std::size_t n = 0; n <= order; ++n)
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t j = 0; i + j <= n; ++j) result[n] = result[n] + h.at(i, j) * powers[j][n - i];
  return result;
}

}  // namespace eliminant::bridge
