// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace eliminant::bridge {

/// Taylor coefficients of homogeneous coordinates (x, y, z, w) in the parameters of a curve (one) or a patch (two), up
/// to a total order; rational numbers at a point, or intervals that hold them for every point of a box.
template <class Scalar>
class TaylorTable {
 public:
  TaylorTable(std::size_t parameters, std::size_t order)
      : parameters_(parameters), order_(order), coefficients_((order + 1) * (parameters == 2 ? order + 1 : 1)) {}

  std::size_t parameters() const { return parameters_; }
  std::size_t order() const { return order_; }
  /// Of a^i b^j, i + j <= order.
  std::array<Scalar, 4>& at(std::size_t i, std::size_t j = 0) {
    return coefficients_[parameters_ == 2 ? i * (order_ + 1) + j : i];
  }
  const std::array<Scalar, 4>& at(std::size_t i, std::size_t j = 0) const {
    return const_cast<TaylorTable*>(this)->at(i, j);
  }
  /// The coefficients up to a lower total order.
  TaylorTable truncated(std::size_t order) const {
    TaylorTable result(parameters_, order);
    for (std::size_t i = 0; i <= order; ++i)
      for (std::size_t j = 0; i + j <= order && (parameters_ == 2 || j == 0); ++j) result.at(i, j) = at(i, j);
    return result;
  }

 private:
  std::size_t parameters_;
  std::size_t order_;
  std::vector<std::array<Scalar, 4>> coefficients_;
};

/// How a curve moves relative to a patch (or to another plane curve) that is followed beside it: the parameters of the
/// second side as series in the increment of the curve's parameter that keep all coordinates but `normal` equal, and
/// the difference of that one. Its first coefficient that is not 0 has the intersection multiplicity as index.
template <class Scalar>
struct ContactSeries {
  /// One series for each parameter of the second side; the constant terms are 0.
  std::array<std::vector<Scalar>, 2> second;
  std::vector<Scalar> difference;
};

/// The coordinates that are kept equal, and the derivatives of their differences by the parameters of the second side.
template <class Scalar>
struct KeptCoordinates {
  std::size_t count = 0;
  std::array<std::size_t, 2> index{};
  std::array<std::array<Scalar, 2>, 2> jacobian;

  KeptCoordinates(const TaylorTable<Scalar>& curve, const TaylorTable<Scalar>& second, std::size_t normal)
      : count(second.parameters()) {
    constexpr std::size_t weight = 3;
    for (std::size_t k = 0, r = 0; k <= count; ++k) {
      if (k == normal) continue;
      for (std::size_t p = 0; p < count; ++p) {
        const std::array<Scalar, 4>& slope = p == 0 ? second.at(1, 0) : second.at(0, 1);
        jacobian[r][p] = curve.at(0)[k] * slope[weight] - curve.at(0)[weight] * slope[k];
      }
      index[r++] = k;
    }
  }
  Scalar determinant() const {
    return count == 1 ? jacobian[0][0] : jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
  }
  /// The changes of the parameters that take away these differences, to first order.
  std::array<Scalar, 2> correction(const std::array<Scalar, 2>& differences) const {
    const Scalar d = determinant();
    if (count == 1) return {Scalar(0) - differences[0] / d, Scalar(0)};
    return {(jacobian[0][1] * differences[1] - jacobian[1][1] * differences[0]) / d,
            (jacobian[1][0] * differences[0] - jacobian[0][0] * differences[1]) / d};
  }
};

/// Coordinates are compared with weights multiplied crosswise. `coordinates` are those that count, `normal` among them
/// the one not kept equal; the others, as functions of the second side's parameters, must have an invertible derivative
/// (else divisions by zero follow). At order 0 they are taken as equal.
template <class Scalar>
ContactSeries<Scalar> contact_series(const TaylorTable<Scalar>& curve, const TaylorTable<Scalar>& second,
                                     std::size_t normal) {
  using Series = std::vector<Scalar>;
  const std::size_t order = curve.order();
  const std::size_t unknowns = second.parameters();
  constexpr std::size_t weight = 3;
  const Scalar zero(0);

  ContactSeries<Scalar> result;
  for (std::size_t p = 0; p < unknowns; ++p) result.second[p].assign(order + 1, zero);
  const KeptCoordinates<Scalar> kept(curve, second, normal);

  // The coefficient of index m of the product.
  const auto product_coefficient = [&](const Series& a, const Series& b, std::size_t m) {
    Scalar sum = zero;
    for (std::size_t i = 0; i <= m; ++i) sum = sum + a[i] * b[m - i];
    return sum;
  };
  const auto curve_series = [&](std::size_t k) {
    Series series;
    for (std::size_t i = 0; i <= order; ++i) series.push_back(curve.at(i)[k]);
    return series;
  };
  std::array<Series, 4> of_curve;
  for (std::size_t k = 0; k < 4; ++k) of_curve[k] = curve_series(k);

  // powers[i][j]: the product of the i-th power of the first series and the j-th of the second.
  std::vector<std::vector<Series>> powers;
  const auto compose = [&](std::size_t m) {
    powers.assign(order + 1, std::vector<Series>(unknowns == 2 ? order + 1 : 1, Series(order + 1, zero)));
    powers[0][0][0] = Scalar(1);
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j < powers[i].size() && i + j <= m; ++j) {
        if (i + j == 0) continue;
        const Series& factor = result.second[i > 0 ? 0 : 1];
        const Series& rest = i > 0 ? powers[i - 1][j] : powers[i][j - 1];
        for (std::size_t n = i + j; n <= m; ++n) powers[i][j][n] = product_coefficient(factor, rest, n);
      }
  };
  const auto second_series = [&](std::size_t k, std::size_t m) {
    Series series(order + 1, zero);
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j < powers[i].size() && i + j <= m; ++j)
        for (std::size_t n = i + j; n <= m; ++n) series[n] = series[n] + second.at(i, j)[k] * powers[i][j][n];
    return series;
  };
  const auto difference = [&](std::size_t k, std::size_t m, const Series& weights) {
    return product_coefficient(of_curve[k], weights, m) - product_coefficient(of_curve[weight], second_series(k, m), m);
  };

  for (std::size_t m = 1; m <= order; ++m) {
    compose(m);
    const Series weights = second_series(weight, m);
    std::array<Scalar, 2> rest{zero, zero};
    for (std::size_t r = 0; r < unknowns; ++r) rest[r] = difference(kept.index[r], m, weights);
    const std::array<Scalar, 2> terms = kept.correction(rest);
    for (std::size_t p = 0; p < unknowns; ++p) result.second[p][m] = terms[p];
  }
  compose(order);
  const Series weights = second_series(weight, order);
  const Series values = second_series(normal, order);
  for (std::size_t m = 0; m <= order; ++m)
    result.difference.push_back(product_coefficient(of_curve[normal], weights, m) -
                                product_coefficient(of_curve[weight], values, m));
  return result;
}

}  // namespace eliminant::bridge
