// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace eliminant::numeric {

/// The product without the check for infinities that std::complex makes.
inline std::complex<double> plain_product(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// a / b, infinite or NaN for b = 0.
inline std::complex<double> plain_quotient(const std::complex<double>& a, const std::complex<double>& b) {
  const double size = b.real() * b.real() + b.imag() * b.imag();
  return {(a.real() * b.real() + a.imag() * b.imag()) / size, (a.imag() * b.real() - a.real() * b.imag()) / size};
}

/// Starting values for the roots of a polynomial on the circles of its Newton polygon, as points_on_circles, for a
/// degree known at compile time and coefficients whose powers stay in the range of double.
template <std::size_t Degree>
std::array<std::complex<double>, Degree> newton_polygon_points(const std::array<double, Degree + 1>& coefficients) {
  std::array<std::size_t, Degree + 1> hull{};
  std::array<double, Degree + 1> height{};
  std::size_t size = 0;
  for (std::size_t i = 0; i <= Degree; ++i) {
    if (coefficients[i] == 0) continue;
    height[i] = static_cast<double>(std::ilogb(coefficients[i]));
    const auto slope = [&height](std::size_t from, std::size_t to) {
      return (height[to] - height[from]) / static_cast<double>(to - from);
    };
    while (size >= 2 && slope(hull[size - 2], hull[size - 1]) <= slope(hull[size - 1], i)) --size;
    hull[size++] = i;
  }
  std::array<std::complex<double>, Degree> points{};
  std::size_t next = hull[0];  // so many roots are 0
  for (std::size_t k = 0; k + 1 < size; ++k) {
    const std::size_t count = hull[k + 1] - hull[k];
    const double radius = std::exp2((height[hull[k]] - height[hull[k + 1]]) / static_cast<double>(count));
    // A step of 2 pi / count, from an angle that no symmetry of the polynomial shares.
    const std::complex<double> step = std::polar(1.0, 6.283185307179586 / static_cast<double>(count));
    std::complex<double> point = std::polar(radius, 0.7 + 0.37 * static_cast<double>(hull[k]));
    for (std::size_t i = 0; i < count; ++i, point = plain_product(point, step)) points[next++] = point;
  }
  return points;
}

/// All roots of a real polynomial, coefficients ascending, the last not zero, by Ehrlich and Aberth's simultaneous
/// iteration. No guarantee: a root is left where its value is below the rounding error of its evaluation, or after
/// `max_sweeps` sweeps. ehrlich_aberth is the same for any degree and any size of the coefficients. Source: [Bini1996].
template <std::size_t Degree>
std::array<std::complex<double>, Degree> fixed_degree_roots(const std::array<double, Degree + 1>& coefficients,
                                                            int max_sweeps) {
  using Complex = std::complex<double>;
  std::array<Complex, Degree> roots = newton_polygon_points<Degree>(coefficients);
  std::array<bool, Degree> settled{};
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    bool moved = false;
    for (std::size_t i = 0; i < Degree; ++i) {
      if (settled[i]) continue;
      const Complex z = roots[i];
      const double size = std::sqrt(z.real() * z.real() + z.imag() * z.imag());
      Complex value = coefficients[Degree];
      Complex derivative = 0;
      double absolute = std::fabs(coefficients[Degree]);
      for (std::size_t k = Degree; k-- > 0;) {
        derivative = plain_product(derivative, z) + value;
        value = plain_product(value, z) + coefficients[k];
        absolute = absolute * size + std::fabs(coefficients[k]);
      }
      // 2^-53 for each of the 4 operations of a step of Horner's rule.
      if (std::fabs(value.real()) + std::fabs(value.imag()) <= 0x1p-51 * static_cast<double>(Degree) * absolute) {
        settled[i] = true;
        continue;
      }
      Complex repulsion = 0;
      for (std::size_t j = 0; j < Degree; ++j) {
        const Complex difference = z - roots[j];
        const double square = difference.real() * difference.real() + difference.imag() * difference.imag();
        if (square != 0) repulsion += Complex(difference.real() / square, -difference.imag() / square);
      }
      const Complex step = plain_quotient(value, derivative - plain_product(value, repulsion));
      if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) continue;
      roots[i] = z - step;
      moved = true;
      if (std::fabs(step.real()) + std::fabs(step.imag()) < 0x1p-50 * size) settled[i] = true;
    }
    if (!moved) break;
  }
  return roots;
}

}  // namespace eliminant::numeric
