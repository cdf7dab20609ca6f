// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::bridge {

/// A polynomial in two variables with intervals that hold its coefficients; made for low degrees.
class IntervalPolynomial {
 public:
  IntervalPolynomial() = default;
  explicit IntervalPolynomial(const symbolic::Polynomial& p);

  /// As a polynomial in (x, y), the argument being origin + x across + y along.
  IntervalPolynomial in_frame(const std::array<double, 2>& origin, const std::array<double, 2>& across,
                              const std::array<double, 2>& along) const;
  IntervalPolynomial derivative(std::size_t axis) const;
  /// Encloses all values on a rectangle.
  DoubleInterval on(const DoubleInterval& x, const DoubleInterval& y) const;
  /// Approximately.
  double near(double x, double y) const;

 private:
  IntervalPolynomial(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), coefficients_(rows * columns, DoubleInterval(0)) {}
  DoubleInterval& at(std::size_t i, std::size_t j) { return coefficients_[i * columns_ + j]; }
  const DoubleInterval& at(std::size_t i, std::size_t j) const { return coefficients_[i * columns_ + j]; }

  /// Numbers of powers of each variable.
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t total_degree_ = 0;
  std::vector<DoubleInterval> coefficients_;
};

}  // namespace eliminant::bridge
