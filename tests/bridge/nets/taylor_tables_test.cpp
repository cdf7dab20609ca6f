// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// The coordinates of points themselves.
ContactFrame as_they_are() {
  ContactFrame frame;
  for (long k = 0; k < 3; ++k) frame.columns[static_cast<std::size_t>(k)][k] = 1;
  return frame;
}

Array4d value_of(const LocalPowers& powers, double x, double y) {
  Array4d sum = Array4d::Zero();
  for (std::size_t i = 0; i <= powers.degree[0]; ++i)
    for (std::size_t j = 0; j <= powers.degree[1]; ++j)
      sum += powers.coefficients[i * (powers.degree[1] + 1) + j] *
             (std::pow(x, static_cast<double>(i)) * std::pow(y, static_cast<double>(j)));
  return sum;
}

}  // namespace

TEST_CASE("Local powers: exact coefficients around the middle of a box") {
  // With u = 1/2 + x/4 and v = 3/4 + y/4.
  const ExactNet exact = patch_net({"u", "v", "u^2*v - 1"});
  const ControlNet net = in_doubles(exact);
  const LocalPowers powers = local_powers(net, as_they_are(), {{0.25, 0.5, 0}, {0.75, 1, 0}}, 0);
  REQUIRE(powers.degree == std::array<std::size_t, 2>{2, 1});
  const auto z = [&](std::size_t i, std::size_t j) { return powers.coefficients[i * 2 + j][2]; };
  CHECK(z(0, 0) == doctest::Approx(0.25 * 0.75 - 1).epsilon(1e-14));
  CHECK(z(1, 0) == doctest::Approx(0.25 * 0.75).epsilon(1e-14));
  CHECK(z(2, 0) == doctest::Approx(0.75 / 16).epsilon(1e-14));
  CHECK(z(0, 1) == doctest::Approx(0.25 / 4).epsilon(1e-14));
  CHECK(z(2, 1) == doctest::Approx(1.0 / 64).epsilon(1e-14));
  CHECK(powers.coefficients[0][3] == 1);
  CHECK(powers.error[2] < 1e-13);
}

TEST_CASE("Local powers: rational patches, also a little beyond the domain") {
  const ControlNet net = in_doubles(patch_net({"2*u", "2*v + u^3", "1 - u^2 - v^2", "1 + u^2 + v^2"}));
  PatchJets jets(net);
  for (const auto& [lower, upper] : {std::pair(0.0, 1.0), std::pair(0.375, 0.4375), std::pair(-0.015625, 0.25)}) {
    const LocalPowers powers = local_powers(net, as_they_are(), {{lower, lower, 0}, {upper, upper, 0}}, 0);
    for (const double x : {-1.0, -0.3, 0.0, 0.7, 1.0})
      for (const double y : {-1.0, 0.1, 1.0}) {
        const auto parameter = [lower = lower, upper = upper](double local) {
          return 0.5 * (lower + upper) + 0.5 * (upper - lower) * local;
        };
        const Array4d value = value_of(powers, x, y);
        const Array4d expected = jets.at(parameter(x), parameter(y)).point;
        for (long k = 0; k < 3; ++k) CHECK(value[k] / value[3] == doctest::Approx(expected[k]).epsilon(1e-13));
      }
  }
}
