// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include <eliminant/numeric/fixed_degree_roots.hpp>

namespace {

using Complex = std::complex<double>;
using eliminant::numeric::fixed_degree_roots;

/// The coefficients of the product of x - r, ascending.
template <std::size_t Degree>
std::array<double, Degree + 1> polynomial_with(const std::array<Complex, Degree>& roots) {
  std::array<Complex, Degree + 1> product{};
  product[0] = 1;
  for (std::size_t k = 0; k < Degree; ++k)
    for (std::size_t i = k + 2; i-- > 0;) product[i] = (i > 0 ? product[i - 1] : 0) - roots[k] * product[i];
  std::array<double, Degree + 1> real{};
  for (std::size_t i = 0; i <= Degree; ++i) real[i] = product[i].real();
  return real;
}

/// The largest relative distance of a root from the nearest value.
template <std::size_t Degree>
double error_of(const std::array<Complex, Degree>& values, const std::array<Complex, Degree>& roots) {
  double worst = 0;
  for (const Complex& root : roots) {
    double nearest = INFINITY;
    for (const Complex& value : values) nearest = std::min(nearest, std::abs(value - root));
    worst = std::max(worst, nearest / std::max(std::abs(root), 1e-300));
  }
  return worst;
}

}  // namespace

TEST_CASE("Fixed degree roots: real and complex ones of a sextic") {
  const std::array<Complex, 6> roots{Complex(1),       Complex(-2),   Complex(0.5, 3),
                                     Complex(0.5, -3), Complex(4, 1), {4, -1}};
  CHECK(error_of(fixed_degree_roots<6>(polynomial_with(roots), 60), roots) < 1e-12);
}

TEST_CASE("Fixed degree roots: moduli over twelve orders of magnitude") {
  const std::array<Complex, 6> roots{Complex(1e-6), Complex(-3e-3), Complex(1), Complex(0, 70), Complex(0, -70), {2e6}};
  CHECK(error_of(fixed_degree_roots<6>(polynomial_with(roots), 60), roots) < 1e-10);
}

TEST_CASE("Fixed degree roots: zero is a root where the first coefficients are") {
  const std::array<double, 4> coefficients{0, 0, -2, 1};  // x^2 (x - 2)
  const std::array<Complex, 3> values = fixed_degree_roots<3>(coefficients, 60);
  CHECK(std::count(values.begin(), values.end(), Complex(0)) == 2);
  CHECK(std::any_of(values.begin(), values.end(), [](const Complex& z) { return std::abs(z - 2.0) < 1e-14; }));
}

TEST_CASE("Fixed degree roots: double roots to half the digits") {
  const std::array<Complex, 4> roots{Complex(1), Complex(1), Complex(-1), Complex(3)};
  CHECK(error_of(fixed_degree_roots<4>(polynomial_with(roots), 60), roots) < 1e-6);
}
