// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/local_tables.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/contacts/height_ridge.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge::local {

namespace {

using symbolic::Rational;

constexpr std::size_t weight = 3;

bool is_zero(const std::array<DoubleInterval, 4>& entry) {
  return std::all_of(entry.begin(), entry.end(), [](const DoubleInterval& x) { return x.magnitude() == 0; });
}

}  // namespace

double binomial(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return result;
}

std::vector<DoubleInterval> powers(const DoubleInterval& x, std::size_t highest) {
  std::vector<DoubleInterval> result{DoubleInterval(1)};
  for (std::size_t k = 1; k <= highest; ++k) {
    DoubleInterval next = result.back() * x;
    if (k % 2 == 0) next.lower = std::max(next.lower, 0.0);
    result.push_back(next);
  }
  return result;
}

std::optional<Frame> exact_frame(const TaylorTable<Rational>& patch, const ContactFrame& near) {
  const std::array<Rational, 4>& value = patch.at(0, 0);
  std::array<std::array<Rational, 3>, 2> tangent;
  for (std::size_t k = 0; k < 3; ++k) {
    tangent[0][k] = patch.at(1, 0)[k] * value[weight] - value[k] * patch.at(1, 0)[weight];
    tangent[1][k] = patch.at(0, 1)[k] * value[weight] - value[k] * patch.at(0, 1)[weight];
  }
  Frame rows;
  std::size_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    rows[2][k] = tangent[0][i] * tangent[1][j] - tangent[0][j] * tangent[1][i];
    for (std::size_t r = 0; r < 2; ++r) rows[r][k] = exactly(near.columns[k][static_cast<long>(r)]);
    if (std::fabs(near.columns[k][2]) > std::fabs(near.columns[largest][2])) largest = k;
  }
  if (rows[2][largest].is_zero()) return std::nullopt;
  const Rational unit = exactly(near.columns[largest][2]) / rows[2][largest];
  for (Rational& entry : rows[2]) entry = entry * unit;
  return rows;
}

Table enclosed_in(const Frame& frame, const TaylorTable<Rational>& exact, bool polynomial) {
  const std::array<Rational, 4> point = exact.at(0, 0);
  const Rational unit = polynomial ? point[weight] : Rational(1);
  Table result(2, exact.order());
  for (std::size_t i = 0; i <= exact.order(); ++i)
    for (std::size_t j = 0; i + j <= exact.order(); ++j) {
      const std::array<Rational, 4>& from = exact.at(i, j);
      std::array<Rational, 3> moved;
      for (std::size_t k = 0; k < 3; ++k) moved[k] = (from[k] - point[k] / point[weight] * from[weight]) / unit;
      for (std::size_t r = 0; r < 3; ++r)
        result.at(i, j)[r] = enclosed(frame[r][0] * moved[0] + frame[r][1] * moved[1] + frame[r][2] * moved[2]);
      result.at(i, j)[weight] = enclosed(from[weight] / unit);
    }
  return result;
}

Table moved(const Table& table, const std::array<DoubleInterval, 2>& by, std::size_t order) {
  const std::size_t degree = table.order();
  const std::array<std::vector<DoubleInterval>, 2> power{powers(by[0], degree), powers(by[1], degree)};
  Table result(2, order);
  for (std::size_t i = 0; i <= order; ++i)
    for (std::size_t j = 0; i + j <= order; ++j)
      for (std::size_t p = i; p <= degree; ++p)
        for (std::size_t q = j; p + q <= degree; ++q) {
          if (is_zero(table.at(p, q))) continue;
          const DoubleInterval factor =
              DoubleInterval(binomial(p, i) * binomial(q, j)) * power[0][p - i] * power[1][q - j];
          for (std::size_t k = 0; k < 4; ++k) result.at(i, j)[k] = result.at(i, j)[k] + factor * table.at(p, q)[k];
        }
  return result;
}

Table sheared(const Table& table, const std::vector<DoubleInterval>& series) {
  const std::size_t order = table.order();
  const auto power = powers_of(series, order, order);
  Table result(2, order);
  for (std::size_t p = 0; p <= order; ++p)
    for (std::size_t q = 0; p + q <= order; ++q)
      for (std::size_t j = 0; j <= q; ++j)
        for (std::size_t n = 0; p + n + j <= order; ++n) {
          const DoubleInterval factor = DoubleInterval(binomial(q, j)) * power[q - j][n];
          for (std::size_t k = 0; k < 4; ++k)
            result.at(p + n, j)[k] = result.at(p + n, j)[k] + factor * table.at(p, q)[k];
        }
  return result;
}

Table exchanged_parameters(const Table& table) {
  Table result = table;
  for (std::size_t i = 0; i <= table.order(); ++i)
    for (std::size_t j = 0; i + j <= table.order(); ++j) result.at(i, j) = table.at(j, i);
  return result;
}

EnclosedSlopes::EnclosedSlopes(const Table& table) {
  const DoubleInterval& w = table.at(0, 0)[weight];
  for (std::size_t k = 0; k < 3; ++k) {
    value[k] = table.at(0, 0)[k] / w;
    slope[0][k] = (table.at(1, 0)[k] - value[k] * table.at(1, 0)[weight]) / w;
    slope[1][k] = (table.at(0, 1)[k] - value[k] * table.at(0, 1)[weight]) / w;
  }
}

std::array<std::array<DoubleInterval, 2>, 2> EnclosedSlopes::inverse() const {
  const DoubleInterval determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
  return {{{slope[1][1] / determinant, -slope[1][0] / determinant},
           {-slope[0][1] / determinant, slope[0][0] / determinant}}};
}

Jet jet_at(const Table& table, double a, double b) {
  std::array<Eigen::Vector4d, 3> sum;
  sum.fill(Eigen::Vector4d::Zero());
  const std::size_t order = table.order();
  std::vector<double> power_a(order + 1, 1);
  std::vector<double> power_b(order + 1, 1);
  for (std::size_t k = 1; k <= order; ++k) {
    power_a[k] = power_a[k - 1] * a;
    power_b[k] = power_b[k - 1] * b;
  }
  for (std::size_t i = 0; i <= order; ++i)
    for (std::size_t j = 0; i + j <= order; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const double c = middle(table.at(i, j)[k]);
        const auto row = static_cast<long>(k);
        sum[0][row] += c * power_a[i] * power_b[j];
        if (i > 0) sum[1][row] += static_cast<double>(i) * c * power_a[i - 1] * power_b[j];
        if (j > 0) sum[2][row] += static_cast<double>(j) * c * power_a[i] * power_b[j - 1];
      }
  Jet jet;
  jet.value = sum[0].head<3>() / sum[0][3];
  for (std::size_t k = 0; k < 2; ++k) jet.slope[k] = (sum[k + 1].head<3>() - jet.value * sum[k + 1][3]) / sum[0][3];
  return jet;
}

}  // namespace eliminant::bridge::local
