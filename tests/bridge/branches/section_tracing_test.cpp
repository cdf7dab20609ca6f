// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/section_tracing.hpp>
#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

using namespace eliminant;
using bridge::SectionArc;
using bridge::SectionEnd;
using symbolic::Polynomial;
using symbolic::Rational;

namespace {

Polynomial in_uv(const std::string& text) {
  const std::vector<std::string> names{"u", "v"};
  return symbolic::parse_polynomial(text, names);
}

const std::array<symbolic::Interval, 2> unit{symbolic::Interval{0, 1}, symbolic::Interval{0, 1}};

/// (u, v, 0).
bridge::ControlNet flat() {
  return *bridge::ControlNet::of({1, 1}, {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}, {1, 1, 0, 1}}, {0, 0, 0});
}

SectionArc trace(const std::string& text, const std::array<double, 2>& seed, const std::array<double, 2>& side,
                 const std::array<double, 2>& goal, SectionEnd kind, double tolerance = 1e-8) {
  const bridge::ControlNet patch = flat();
  const bridge::ControlNet function = bridge::function_net(in_uv(text), unit);
  bridge::SectionGoal end;
  end.kind = kind;
  end.at = goal;
  end.radius = 0x1p-52;
  return bridge::SectionTracer(patch, function).trace({seed, 1e-14, side}, end, tolerance, 1, Context());
}

}  // namespace

TEST_CASE("function net: Bernstein coefficients, the largest of them 1") {
  const bridge::ControlNet net = bridge::function_net(in_uv("4*u*v - 2*v"), unit);
  CHECK(net.degrees == std::vector<std::size_t>{1, 1});
  REQUIRE(net.points.size() == 4);
  CHECK(net.points[0][0] == 0);
  CHECK(net.points[1][0] == -1);
  CHECK(net.points[2][0] == 0);
  CHECK(net.points[3][0] == 1);
  // Degree 1 at least, whatever the polynomial.
  CHECK(bridge::function_net(in_uv("v^2 - 3"), unit).degrees == std::vector<std::size_t>{1, 2});
  CHECK_THROWS_AS(bridge::function_net(Polynomial(2), unit), InvalidInput);
}

TEST_CASE("function net: zeros are excluded only where there are none") {
  const bridge::ControlNet circle = bridge::function_net(in_uv("(2*u-1)^2 + (2*v-1)^2 - 1/4"), unit);
  CHECK(bridge::excludes_zero(circle, {0, 0}, {0.2, 1}));
  CHECK(bridge::excludes_zero(circle, {0.4, 0.4}, {0.6, 0.6}));
  CHECK(bridge::excludes_zero(circle, {0, 0.2}, {1, 0.2}));
  CHECK_FALSE(bridge::excludes_zero(circle, {0, 0.25}, {1, 0.25}));
  CHECK_FALSE(bridge::excludes_zero(circle, {0, 0}, {1, 1}));
}

TEST_CASE("section tracing: a circle within the tolerance, by steps that follow it") {
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    const SectionArc arc = trace("u^2 + v^2 - 16/25", {0.48, 0.64}, {1, 0}, {0.8, 0}, SectionEnd::regular, tolerance);
    CHECK(arc.proven);
    CHECK(arc.error < tolerance);
    double largest = 0;
    for (std::size_t i = 1; i < arc.points.size(); ++i) {
      const auto& p = arc.points[i - 1].parameters;
      const auto& q = arc.points[i].parameters;
      largest = std::max(largest, 0.8 - std::hypot(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])));
    }
    CHECK(largest <= arc.error);
    CHECK(largest > 0.1 * tolerance);
    CHECK(arc.points.back().parameters[0] == 0.8);
  }
}

TEST_CASE("section tracing: to a node, to a cusp") {
  // Half branches of v'^2 = u'^2 (1 + u'), with the node in the middle.
  const SectionArc node = trace("(v-1/2)^2 - (u-1/2)^2*(1/2+u)", {0.75, 0.5 + 0.25 * std::sqrt(1.25)}, {-1, 0},
                                {0.5, 0.5}, SectionEnd::node);
  CHECK(node.proven);
  CHECK(node.error < 1e-8);
  CHECK(node.points.back().parameters == std::array<double, 2>{0.5, 0.5});
  // Where doubles end near a cusp the error says so.
  const SectionArc cusp =
      trace("(v-1/2)^2 - (u-1/2)^3", {0.75, 0.625}, {-1, 0}, {0.5, 0.5}, SectionEnd::singular, 1e-12);
  CHECK(cusp.points.back().parameters == std::array<double, 2>{0.5, 0.5});
  if (cusp.proven) CHECK(cusp.error >= 1e-12);
}

TEST_CASE("section tracing: what is not near an arc is not proven") {
  CHECK_FALSE(trace("u - v", {0.5, 0.25}, {1, 0}, {1, 1}, SectionEnd::regular).proven);
  // A goal on the other branch.
  CHECK_FALSE(trace("(u - v)*(u - v - 1/8)", {0.5, 0.5}, {1, 0}, {1, 0.875}, SectionEnd::regular).proven);
}
