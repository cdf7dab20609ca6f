// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/algebraic_contact.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;
using symbolic::Rational;

namespace {

std::optional<std::array<Rational, 4>> found(const NetPair& nets, const std::array<double, 4>& near) {
  return algebraic_contact(nets.first, nets.second, nets.exact_first, nets.exact_second, near);
}

/// Whether the difference is below 2^-150.
bool is_tiny(const Rational& difference) {
  Rational large = difference;
  fmpq_mul_2exp(large.get(), large.get(), 150);
  return large < Rational(1) && Rational(-1) < large;
}

}  // namespace

TEST_CASE("Algebraic contact: square roots, in exchanged parameters of a rational patch, to 150 binary digits") {
  // u = v = sqrt(1/2); the second patch has its parameters exchanged and weights.
  const NetPair nets({"u", "v", "0"}, {"v*(1 + u)", "u*(1 + u)", "((u - v)^2 + (u*v - 1/2)^2)*(1 + u)", "1 + u"});
  const double root = std::sqrt(0.5);
  const auto contact = found(nets, {root, root, root, root});
  REQUIRE(contact);
  for (const Rational& parameter : *contact) CHECK(is_tiny(parameter * parameter - ratio(1, 2)));
}

TEST_CASE("Algebraic contact: a field of degree four, and rational numbers with large denominators") {
  const NetPair roots({"u", "v", "u*v"}, {"u", "v", "u*v + (u^2 - 1/2)^2 + (v^2 - 1/3)^2"});
  const auto contact = found(roots, {std::sqrt(0.5), std::sqrt(1.0 / 3), std::sqrt(0.5), std::sqrt(1.0 / 3)});
  REQUIRE(contact);
  CHECK(is_tiny((*contact)[0] * (*contact)[0] - ratio(1, 2)));
  CHECK(is_tiny((*contact)[3] * (*contact)[3] - ratio(1, 3)));

  const Rational u = ratio(123456789, 987654321);
  const NetPair large({"u", "v", "0"}, {"u", "v", "(u - 123456789/987654321)^2 + (v - 1/3)^2"});
  const auto fraction = found(large, {123456789.0 / 987654321, 1.0 / 3, 123456789.0 / 987654321, 1.0 / 3});
  REQUIRE(fraction);
  CHECK(is_tiny((*fraction)[0] - u));
}

TEST_CASE("Algebraic contact: neither near misses nor curves of contact are points") {
  const double root = std::sqrt(0.5);
  const NetPair gap({"u", "v", "0"}, {"u", "v", "(u - v)^2 + (u*v - 1/2)^2 + 1/100000000000000000000"});
  CHECK_FALSE(found(gap, {root, root, root, root}));
  const NetPair curve({"u", "v", "0"}, {"u", "v", "(u^2 - 1/2)^2"});
  CHECK_FALSE(found(curve, {root, 0.4, root, 0.4}));
}
