// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <eliminant/bridge/contacts/contact_series.hpp>

namespace eliminant::bridge {

/// A power series in x and y up to the total degree `Highest`.
template <class Scalar, std::size_t Highest = 4>
class PlaneSeries {
 public:
  static constexpr std::size_t highest = Highest;

  PlaneSeries() { coefficients_.fill(Scalar(0)); }
  /// Of x^i y^j.
  Scalar& at(std::size_t i, std::size_t j) { return coefficients_[(i + j) * (i + j + 1) / 2 + j]; }
  const Scalar& at(std::size_t i, std::size_t j) const { return coefficients_[(i + j) * (i + j + 1) / 2 + j]; }

 private:
  std::array<Scalar, (highest + 1) * (highest + 2) / 2> coefficients_;
};

/// Adds to `sum` the terms of total degree n of a b that come from terms of degree i >= least_a of a and n - i >=
/// least_b of b.
template <class Scalar, std::size_t Highest>
void add_product(const PlaneSeries<Scalar, Highest>& a, std::size_t least_a, const PlaneSeries<Scalar, Highest>& b,
                 std::size_t least_b, std::size_t n, PlaneSeries<Scalar, Highest>& sum) {
  for (std::size_t of_a = least_a; of_a + least_b <= n; ++of_a) {
    const std::size_t of_b = n - of_a;
    for (std::size_t i = 0; i <= of_a; ++i)
      for (std::size_t j = 0; j <= of_b; ++j) {
        Scalar& entry = sum.at(n - i - j, i + j);
        entry = entry + a.at(of_a - i, i) * b.at(of_b - j, j);
      }
  }
}

/// How one patch lies above another, as series in the parameters (x, y) of the first.
template <class Scalar, std::size_t Highest = 4>
struct HeightSeries {
  /// The difference h along the normal.
  PlaneSeries<Scalar, Highest> height;
  /// The parameters of the second patch, relative to those at the origin.
  std::array<PlaneSeries<Scalar, Highest>, 2> second;
};

/// The difference of two patches along a normal while the parameters of the second follow so that both other
/// coordinates stay equal: ContactSeries for all directions at once. Coordinates are compared with weights multiplied
/// crosswise; where `polynomial` all weights are taken as 1. The constant terms of both others are taken as equal, and
/// that of h is 0. Terms up to the degree `order` <= Highest.
template <std::size_t Highest = 4, class Scalar>
HeightSeries<Scalar, Highest> height_series(const TaylorTable<Scalar>& first, const TaylorTable<Scalar>& second,
                                            std::size_t order, bool polynomial) {
  constexpr std::size_t normal = 2;
  constexpr std::size_t weight = 3;
  using Series = PlaneSeries<Scalar, Highest>;
  const KeptCoordinates<Scalar> kept(first, second, normal);
  std::array<Series, 4> of_first;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i <= order; ++i)
      for (std::size_t j = 0; i + j <= order; ++j) of_first[k].at(i, j) = first.at(i, j)[k];

  // The second patch's parameters to the powers i and j.
  std::array<std::array<Series, Series::highest + 1>, Series::highest + 1> power;
  std::array<Series, 4> of_second;
  for (std::size_t k = 0; k < 4; ++k) of_second[k].at(0, 0) = second.at(0, 0)[k];
  const auto raise_powers = [&](std::size_t n) {
    for (std::size_t total = 2; total <= n; ++total)
      for (std::size_t i = 0; i <= total; ++i) {
        const std::size_t j = total - i;
        const Series& factor = i > 0 ? power[1][0] : power[0][1];
        const Series& rest = i > 0 ? power[i - 1][j] : power[i][j - 1];
        add_product(factor, 1, rest, total - 1, n, power[i][j]);
      }
  };
  const auto compose = [&](std::size_t k, std::size_t n) {
    for (std::size_t j = 0; j <= n; ++j) {
      Scalar sum(0);
      for (std::size_t total = 1; total <= n; ++total)
        for (std::size_t i = 0; i <= total; ++i)
          sum = sum + second.at(i, total - i)[k] * power[i][total - i].at(n - j, j);
      of_second[k].at(n - j, j) = sum;
    }
  };
  const auto difference = [&](std::size_t k, std::size_t n) {
    Series result;
    if (polynomial) {
      for (std::size_t j = 0; j <= n; ++j) result.at(n - j, j) = of_first[k].at(n - j, j) - of_second[k].at(n - j, j);
      return result;
    }
    Series back;
    add_product(of_first[k], 0, of_second[weight], 0, n, result);
    add_product(of_first[weight], 0, of_second[k], 0, n, back);
    for (std::size_t j = 0; j <= n; ++j) result.at(n - j, j) = result.at(n - j, j) - back.at(n - j, j);
    return result;
  };

  HeightSeries<Scalar, Highest> result;
  for (std::size_t n = 1; n <= order; ++n) {
    raise_powers(n);
    if (!polynomial) compose(weight, n);
    std::array<Series, 2> rest;
    for (std::size_t r = 0; r < 2; ++r) {
      compose(kept.index[r], n);
      rest[r] = difference(kept.index[r], n);
    }
    for (std::size_t j = 0; j <= n; ++j) {
      const std::array<Scalar, 2> terms = kept.correction({rest[0].at(n - j, j), rest[1].at(n - j, j)});
      power[1][0].at(n - j, j) = terms[0];
      power[0][1].at(n - j, j) = terms[1];
    }
    for (std::size_t k = 0; k < 4; ++k)
      if (k != weight || !polynomial) compose(k, n);
    const Series last = difference(normal, n);
    for (std::size_t j = 0; j <= n; ++j) result.height.at(n - j, j) = last.at(n - j, j);
  }
  result.second = {power[1][0], power[0][1]};
  return result;
}

}  // namespace eliminant::bridge
