// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

using namespace eliminant;
using intersect::Status;
using intersect::SurfaceResult;
using symbolic::Rational;

TEST_CASE("a surface that covers itself is given up, with a warning") {
  // (x^2, y, x^4 + x^2 y) over [-1, 1] x [0, 1]: every point twice.
  const auto point = [](const Rational& x, const Rational& y, const Rational& z) {
    return symbolic::ControlPoint{x, y, z, Rational(1)};
  };
  // Bernstein coefficients of x^2 and x^4 by x = 2 t - 1, degree 4.
  const std::vector<Rational> square{Rational(1), Rational(0), Rational(-1, 3), Rational(0), Rational(1)};
  const std::vector<Rational> fourth{Rational(1), Rational(-1), Rational(1), Rational(-1), Rational(1)};
  std::vector<std::vector<symbolic::ControlPoint>> net(5);
  for (std::size_t i = 0; i < 5; ++i) {
    net[i].push_back(point(square[i], Rational(0), fourth[i]));
    net[i].push_back(point(square[i], Rational(1), fourth[i] + square[i]));
  }
  intersect::Options options;
  options.tolerance = 1e-4;
  const SurfaceResult result = intersect::intersect_patch_with_itself(symbolic::bezier_patch(net), options, Context());
  CHECK(result.status == Status::numeric);
  CHECK(!result.warnings.empty());
}
