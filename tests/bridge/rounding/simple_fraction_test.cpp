// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <eliminant/bridge/rounding/simple_fraction.hpp>

using eliminant::bridge::simple_fraction;
using eliminant::symbolic::Rational;

namespace {

constexpr double accuracy = 1e-10;

Rational ratio(long p, long q) { return Rational(p) / Rational(q); }

}  // namespace

TEST_CASE("Simple fraction: every fraction of a small denominator is found from its double and from nearby") {
  for (long q = 1; q <= 4096; q = q < 40 ? q + 1 : q * 2 - 7)
    for (const long p : {0L, 1L, q / 2, q / 3 + 1, q - 1, q, 3 * q + 1, -1L, -q - 1}) {
      CAPTURE(p);
      CAPTURE(q);
      const double value = static_cast<double>(p) / static_cast<double>(q);
      for (const double error : {0.0, 0.9e-10, -0.9e-10}) {
        const auto found = simple_fraction(value + error, accuracy);
        REQUIRE(found);
        CHECK(*found == ratio(p, q));
      }
    }
}

TEST_CASE("Simple fraction: powers of two up to 2^20 in the denominator") {
  for (const long p : {1L, 349525L, 524289L, 1048575L})
    CHECK(simple_fraction(static_cast<double>(p) * 0x1p-20, accuracy) == ratio(p, 1L << 20));
}

TEST_CASE("Simple fraction: numbers that are none have none") {
  CHECK_FALSE(simple_fraction(std::sqrt(0.5), accuracy));
  CHECK_FALSE(simple_fraction(std::acos(-1.0) - 3, accuracy));
  CHECK_FALSE(simple_fraction(1.0 / 3 + 1e-8, accuracy));
  CHECK_FALSE(simple_fraction(0x1p-22 + 0x1p-23, accuracy));
  // 4099 is prime.
  CHECK_FALSE(simple_fraction(1000.0 / 4099, accuracy));
}
