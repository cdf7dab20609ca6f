// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/contact_relation_fit.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using symbolic::Polynomial;

namespace {

Polynomial parsed(const std::string& text) {
  static const std::vector<std::string> names{"u", "v"};
  return symbolic::parse_polynomial(text, names);
}

/// Points (u, v, s, t) at 40 values of a parameter from 0 to 1.
std::vector<std::array<double, 4>> points(const std::function<std::array<double, 4>(double)>& at) {
  std::vector<std::array<double, 4>> result;
  constexpr int count = 40;
  for (int i = 0; i < count; ++i) result.push_back(at(i / (count - 1.0)));
  return result;
}

}  // namespace

TEST_CASE("Contact relation fit: a line with parameters that are affine, and quotients") {
  const auto affine = contact_relation_fit(points([](double x) {
    return std::array<double, 4>{x, 0.5 * x + 0.25, 1 - x, 0.75 * x};
  }));
  REQUIRE(affine);
  CHECK(affine->curve == parsed("2*u - 4*v + 1"));
  CHECK((affine->numerator[0] - parsed("1 - u") * affine->denominator[0]).is_zero());

  const auto quotient = contact_relation_fit(points([](double x) {
    return std::array<double, 4>{x, 1.0 / 3, x / (2 - x), 0.5};
  }));
  REQUIRE(quotient);
  CHECK(quotient->curve == parsed("3*v - 1"));
  CHECK(quotient->numerator[0] * parsed("2 - u") == parsed("u") * quotient->denominator[0]);
}

TEST_CASE("Contact relation fit: an ellipse, with the parameters of the other patch exchanged") {
  const double pi = std::acos(-1.0);
  const auto ellipse = contact_relation_fit(points([&](double x) {
    const double u = 0.5 + 0.25 * std::cos(2 * pi * x);
    const double v = 0.5 + 0.125 * std::sin(2 * pi * x);
    return std::array<double, 4>{u, v, v, u};
  }));
  REQUIRE(ellipse);
  const Polynomial expected = parsed("16*(u - 1/2)^2 + 64*(v - 1/2)^2 - 1").primitive_part();
  CHECK((ellipse->curve == expected || (ellipse->curve + expected).is_zero()));
  CHECK(ellipse->numerator[0] == parsed("v"));
}

TEST_CASE("Contact relation fit: neither irrational coefficients nor transcendental curves are recognised") {
  CHECK_FALSE(contact_relation_fit(points([](double x) {
    return std::array<double, 4>{x, std::sqrt(2.0) * x / 2, x, x};
  })));
  CHECK_FALSE(contact_relation_fit(points([](double x) { return std::array<double, 4>{x, std::exp(x) / 4, x, x}; })));
}

TEST_CASE("Contact relation fit: along the line u = 1 quotients are those of the other parameter") {
  const auto quotient = contact_relation_fit(points([](double x) {
    return std::array<double, 4>{1, x, 0, x / (2 - x)};
  }));
  REQUIRE(quotient);
  CHECK(quotient->curve == parsed("u - 1"));
  CHECK(quotient->numerator[1] * parsed("2 - v") == parsed("v") * quotient->denominator[1]);

  const auto cubic = contact_relation_fit(points([](double x) {
    return std::array<double, 4>{1, x, 0, x * (1 + x) * (1 + x) / 4};
  }));
  REQUIRE(cubic);
  CHECK(cubic->numerator[1] == parsed("v*(1 + v)^2/4") * cubic->denominator[1]);
}
