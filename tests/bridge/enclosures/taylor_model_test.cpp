// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <eliminant/bridge/enclosures/taylor_model.hpp>

using eliminant::bridge::TaylorModel;

namespace {

template <std::size_t Order>
double polynomial_at(const TaylorModel<Order>& model, double x, double y) {
  double sum = 0;
  for (std::size_t i = 0; i <= Order; ++i)
    for (std::size_t j = 0; i + j <= Order; ++j)
      sum += model.coefficient(i, j) * std::pow(x, static_cast<double>(i)) * std::pow(y, static_cast<double>(j));
  return sum;
}

}  // namespace

TEST_CASE("Taylor models: a product of low degree is exact but for roundings") {
  TaylorModel<4> a(1);
  a.add_term(2, 1, 0);
  a.add_term(-3, 0, 1);
  const TaylorModel<4> square = a * a;
  CHECK(square.constant() == 1);
  CHECK(square.coefficient(1, 0) == 4);
  CHECK(square.coefficient(0, 1) == -6);
  CHECK(square.coefficient(2, 0) == 4);
  CHECK(square.coefficient(1, 1) == -12);
  CHECK(square.coefficient(0, 2) == 9);
  CHECK(square.remainder() < 1e-12);
  CHECK(square.variation() == doctest::Approx(4 + 6 + 4 + 12 + 9));
  CHECK(square.magnitude() >= 36);
}

TEST_CASE("Taylor models: what is of a higher degree is bounded") {
  TaylorModel<2> x;
  x.add_term(1, 1, 0);
  const TaylorModel<2> fourth = (x * x) * (x * x);
  CHECK(fourth.coefficient(2, 0) == 0);
  CHECK(fourth.remainder() >= 1);
  CHECK(fourth.remainder() < 1 + 1e-9);
  TaylorModel<2> direct;
  direct.add_term(-0.5, 3, 1);
  CHECK(direct.remainder() >= 0.5);
}

TEST_CASE("Taylor models: functions stay within the bound") {
  // (1/3 + x/7 - y/9 + x y / 5)^5 - 2 (x - y / 3)^3, at points all over the square.
  const auto factor = [](double x, double y) { return 1.0 / 3 + x / 7 - y / 9 + x * y / 5; };
  TaylorModel<4> a(1.0 / 3);
  a.add_term(1.0 / 7, 1, 0);
  a.add_term(-1.0 / 9, 0, 1);
  a.add_term(1.0 / 5, 1, 1);
  TaylorModel<4> b;
  b.add_term(1, 1, 0);
  b.add_term(-1.0 / 3, 0, 1);
  TaylorModel<4> sum = a * a * a * a * a;
  sum.add_product(-2, b * b * b);
  double largest = 0;
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j) {
      const double x = i / 8.0;
      const double y = j / 8.0;
      const double value = std::pow(factor(x, y), 5) - 2 * std::pow(x - y / 3, 3);
      const double off = std::fabs(value - polynomial_at(sum, x, y));
      largest = std::max(largest, off);
      CHECK(off <= sum.remainder() + 1e-14);
      CHECK(std::fabs(value) <= sum.magnitude());
    }
  // The bound is no wild guess.
  CHECK(sum.remainder() < 10 * largest);
}
