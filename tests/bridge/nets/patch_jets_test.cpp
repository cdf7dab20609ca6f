// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/exact_jets.hpp>

#include <eliminant/bridge/nets/patch_jets.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const std::vector<PatchText> patches{
    {"u", "v", "2*u - 3*v + 1"},
    {"u + u*v", "v^2 - u/3", "u^2 - 3*u*v + v/7"},
    {"u^3 - v", "u*v^4 + 1/9", "3*u^5*v - v^3 + u", "1"},
    {"1 - u^2", "2*u", "v*(1 + u^2)", "1 + u^2"},
    {"u^2 + v", "u*v^3 - 5", "2*v^2 - u^3", "3 + u - u*v^2/2"},
};

const std::vector<std::array<Rational, 2>> places{
    {0, 0}, {1, 1}, {ratio(1, 2), ratio(1, 4)}, {ratio(7, 8), ratio(3, 16)}, {ratio(-1, 64), ratio(65, 64)}};

/// Of a value of that size, a few roundings.
bool near(double value, double expected, double size) { return std::fabs(value - expected) <= 1e-12 * size; }

}  // namespace

TEST_CASE("Patch jets: values within the error they state, derivatives as the exact Taylor coefficients") {
  for (const PatchText& text : patches)
    for (const std::array<Rational, 2>& place : places) {
      const Rational& a = place[0];
      const Rational& b = place[1];
      CAPTURE(text.z);
      CAPTURE(a.to_string());
      const ExactNet net = patch_net(text);
      const ControlNet rounded_net = in_doubles(net);
      const ExactJet exact(net, a, b);
      const PatchJets::Value value = PatchJets(rounded_net).at(nearest(a), nearest(b));
      CHECK(value.error < 1e-13);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto lane = static_cast<long>(k);
        CHECK(std::fabs(value.point[lane] - exact.derivative(0, 0, k)) <= value.error);
        CHECK(near(value.first[0][lane], exact.derivative(1, 0, k), 30));
        CHECK(near(value.first[1][lane], exact.derivative(0, 1, k), 30));
        CHECK(near(value.second[0][lane], exact.derivative(2, 0, k), 300));
        CHECK(near(value.second[1][lane], exact.derivative(1, 1, k), 300));
        CHECK(near(value.second[2][lane], exact.derivative(0, 2, k), 300));
      }
    }
}

TEST_CASE("Patch jets: bounds hold on all of a box, and close in on it") {
  for (const PatchText& text : patches) {
    CAPTURE(text.z);
    const ExactNet net = patch_net(text);
    const ControlNet rounded_net = in_doubles(net);
    PatchJets jets(rounded_net);
    for (const auto& [a0, a1, b0, b1] : {std::array{0.0, 1.0, 0.0, 1.0}, std::array{0.25, 0.5, 0.625, 0.75},
                                         std::array{-0.0625, 0.0, 0.9375, 1.03125}}) {
      const auto bounds = jets.bounds_on(a0, a1, b0, b1);
      REQUIRE(bounds);
      for (long i = 0; i <= 8; ++i)
        for (long j = 0; j <= 8; ++j) {
          const Rational a = Rational(std::lround(1024 * std::lerp(a0, a1, static_cast<double>(i) / 8))) / 1024;
          const Rational b = Rational(std::lround(1024 * std::lerp(b0, b1, static_cast<double>(j) / 8))) / 1024;
          const ExactJet exact(net, a, b);
          bool held = true;
          for (std::size_t k = 0; k < 3; ++k) {
            const auto lane = static_cast<long>(k);
            for (std::size_t q = 0; q < 2; ++q)
              held = held && std::fabs(exact.derivative(1 - q, q, k)) <= bounds->first[q][lane];
            for (std::size_t q = 0; q < 3; ++q)
              held = held && std::fabs(exact.derivative(2 - q, q, k)) <= bounds->second[q][lane];
            for (std::size_t q = 0; q < 4; ++q)
              held = held && std::fabs(exact.derivative(3 - q, q, k)) <= bounds->third[q][lane];
          }
          CHECK(held);
        }
    }
    // On a narrow box they are near the values.
    const auto narrow = jets.bounds_on(0.5 - 0x1p-12, 0.5 + 0x1p-12, 0.25 - 0x1p-12, 0.25 + 0x1p-12);
    const ExactJet exact(net, ratio(1, 2), ratio(1, 4));
    REQUIRE(narrow);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t q = 0; q < 2; ++q)
        CHECK(narrow->first[q][static_cast<long>(k)] <= 1.01 * std::fabs(exact.derivative(1 - q, q, k)) + 0.01);
  }
}

TEST_CASE("Patch jets: nothing is claimed where a weight may vanish") {
  const ControlNet net = in_doubles(patch_net({"u", "v", "u*v", "1 - 3*u/4"}));
  PatchJets jets(net);
  CHECK(jets.bounds_on(0, 1, 0, 1));
  CHECK_FALSE(jets.bounds_on(0, 1.375, 0, 1));
  const ControlNet mixed = in_doubles(patch_net({"u", "v", "u*v", "1 - 2*u"}));
  CHECK_FALSE(PatchJets(mixed).bounds_on(0, 1, 0, 1));
  CHECK(PatchJets(mixed).bounds_on(0, 0.25, 0, 1));
}

TEST_CASE("Tangent frame: dual to the derivatives, with the unit normal, and none at a singular point") {
  const ControlNet net = in_doubles(patch_net({"2*u", "3*v + u", "u^2 - v^2"}));
  const PatchJets::Value at = PatchJets(net).at(0.5, 0.25);
  const auto frame = tangent_frame(at);
  REQUIRE(frame);
  for (std::size_t k = 0; k < 2; ++k) {
    const Array4d image = times(frame->columns, at.first[k]);
    CHECK(image[0] == doctest::Approx(k == 0 ? 1 : 0));
    CHECK(image[1] == doctest::Approx(k == 0 ? 0 : 1));
    CHECK(std::fabs(image[2]) < 1e-15);
  }
  // (2, 1, 1) x (0, 3, -1/2) = (-7/2, 1, 6), of length 7.
  const double length = std::sqrt(12.25 + 1 + 36);
  CHECK(frame->columns[0][2] == doctest::Approx(-3.5 / length));
  CHECK(frame->columns[1][2] == doctest::Approx(1 / length));
  CHECK(frame->columns[2][2] == doctest::Approx(6 / length));
  const ControlNet singular = in_doubles(patch_net({"u*v", "u", "v^2"}));
  CHECK_FALSE(tangent_frame(PatchJets(singular).at(0, 0)));
}
