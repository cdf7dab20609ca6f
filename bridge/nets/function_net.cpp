// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/function_net.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/nets/bezier_part.hpp>
#include <eliminant/bridge/nets/net_side.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Polynomial;
using symbolic::Rational;

std::vector<Rational> coefficients_of(const Polynomial& p, const std::array<symbolic::Interval, 2>& domain,
                                      const std::array<std::size_t, 2>& degrees) {
  std::vector<std::vector<Rational>> table(degrees[0] + 1, std::vector<Rational>(degrees[1] + 1));
  for (const Polynomial::Term& term : p.terms()) table[term.exponents[0]][term.exponents[1]] = term.coefficient;
  for (std::vector<Rational>& row : table) row = symbolic::bernstein_coefficients(row, domain[1]);
  std::vector<Rational> coefficients((degrees[0] + 1) * (degrees[1] + 1));
  for (std::size_t j = 0; j <= degrees[1]; ++j) {
    std::vector<Rational> column;
    for (const std::vector<Rational>& row : table) column.push_back(row[j]);
    column = symbolic::bernstein_coefficients(column, domain[0]);
    for (std::size_t i = 0; i <= degrees[0]; ++i) coefficients[i * (degrees[1] + 1) + j] = std::move(column[i]);
  }
  return coefficients;
}

}  // namespace

ControlNet function_net(const Polynomial& p, const std::array<symbolic::Interval, 2>& domain) {
  if (p.is_zero()) throw InvalidInput("a function that is 0 everywhere has no curve of zeros", "another function");
  std::array<std::size_t, 2> degrees;
  for (std::size_t k = 0; k < 2; ++k) degrees[k] = static_cast<std::size_t>(std::max(1L, p.degree(k)));
  const std::vector<Rational> coefficients = coefficients_of(p, domain, degrees);
  Rational largest;
  for (const Rational& c : coefficients) largest = std::max(largest, c.sign() < 0 ? -c : c);
  ControlNet net;
  net.degrees = {degrees[0], degrees[1]};
  net.polynomial = true;
  for (const Rational& c : coefficients) {
    double value = nearest(c / largest);
    if (std::fabs(value) < 0x1p-200) value = 0;
    net.points.emplace_back(value, 0, 0, 1);
  }
  net.error = Array4d(0x1p-52, 0, 0, 0);
  return net;
}

bool excludes_zero(const ControlNet& function, const std::array<double, 2>& lower, const std::array<double, 2>& upper,
                   int halvings) {
  const NetShape<2> shape{{function.degrees[0], function.degrees[1]}};
  std::vector<Array4d> points = function.points;
  for (std::size_t axis = 0; axis < 2; ++axis) restrict_to(shape, axis, lower[axis], upper[axis], points.data());
  double least = infinity;
  double greatest = -infinity;
  for (const Array4d& point : points) {
    least = std::min(least, point[0]);
    greatest = std::max(greatest, point[0]);
  }
  // The coefficients are at most 1.
  const double error = function.error[0] + 20 * static_cast<double>(shape.degree[0] + shape.degree[1]) * unit_roundoff;
  if (least > error || greatest < -error) return true;
  // Values at the corners are values of the function.
  const std::size_t row = shape.degree[1] + 1;
  const std::array<double, 4> corners{points.front()[0], points[row - 1][0], points[points.size() - row][0],
                                      points.back()[0]};
  if (halvings == 0 || std::any_of(corners.begin(), corners.end(),
                                   [&](double c) { return std::fabs(c) <= error || (c > 0) != (corners[0] > 0); }))
    return false;
  const std::size_t axis = upper[0] - lower[0] >= upper[1] - lower[1] ? 0 : 1;
  const double middle = 0.5 * (lower[axis] + upper[axis]);
  std::array<double, 2> left = upper;
  std::array<double, 2> right = lower;
  left[axis] = middle;
  right[axis] = middle;
  return excludes_zero(function, lower, left, halvings - 1) && excludes_zero(function, right, upper, halvings - 1);
}

}  // namespace eliminant::bridge
