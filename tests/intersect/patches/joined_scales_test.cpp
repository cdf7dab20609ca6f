// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include <eliminant/intersect/patches/branch_joining.hpp>

using namespace eliminant::intersect;

namespace {

using Parameters = std::array<double, 4>;

/// A curve between two points, their sides as given.
SurfaceComponent piece(const Parameters& from, const std::array<int, 4>& from_side, const Parameters& to,
                       const std::array<int, 4>& to_side) {
  SurfaceComponent component;
  component.kind = SurfaceComponentKind::curve;
  component.certified = true;
  component.points = {{from, {}}, {to, {}}};
  component.start.side = from_side;
  component.end.side = to_side;
  return component;
}

/// Both surfaces cut at the middle of u in [lower, lower + width], at v = a before and b behind it.
SurfaceResult joined(double lower, double width, double a, double b) {
  const DomainBounds bounds{
      {{{lower, lower + width}}, {{lower, lower + width}}, {{lower, lower + width}}, {{lower, lower + width}}}};
  const auto at = [&](double u, double v) {
    const double x = lower + u * width;
    const double y = lower + v * width;
    return Parameters{x, y, x, y};
  };
  SurfaceResult result;
  result.components = {piece(at(0, a), {-1, 0, -1, 0}, at(0.5, a), {1, 0, 1, 0}),
                       piece(at(0.5, b), {-1, 0, -1, 0}, at(1, b), {1, 0, 1, 0})};
  join_branches(result, bounds);
  return result;
}

}  // namespace

TEST_CASE("pieces are joined where they meet, and nowhere else, in domains of any size and place") {
  for (const std::array<double, 2>& domain :
       {std::array{0.0, 1.0}, std::array{1e9, 2.0}, std::array{1e6, 1.0}, std::array{-2e8, 1e8}, std::array{0.0, 1e-10},
        std::array{0.0, 1e-14}, std::array{0.0, 1e10}, std::array{1e4, 1.0}}) {
    CAPTURE(domain[0]);
    CAPTURE(domain[1]);
    const SurfaceResult whole = joined(domain[0], domain[1], 0.25, 0.25);
    REQUIRE(whole.components.size() == 1);
    CHECK(whole.components.front().certified);
    CHECK(whole.components.front().points.size() == 3);
    const SurfaceResult apart = joined(domain[0], domain[1], 0.25, 0.75);
    CHECK(apart.components.size() == 2);
    for (const SurfaceComponent& component : apart.components) {
      CHECK(component.points.size() == 2);
      CHECK(!component.certified);
    }
  }
}

TEST_CASE("a curve with open ends is no loop in a far domain") {
  const DomainBounds bounds{{{{1e9, 1e9 + 2}}, {{1e9, 1e9 + 2}}, {{1e9, 1e9 + 2}}, {{1e9, 1e9 + 2}}}};
  SurfaceResult result;
  const Parameters from{1e9 + 1, 1e9 + 0.5, 1e9 + 1, 1e9 + 0.5};
  const Parameters to{1e9 + 0.5, 1e9 + 1.5, 1e9 + 0.5, 1e9 + 1.5};
  result.components = {piece(from, {1, 0, 1, 0}, to, {-1, 0, -1, 0})};
  join_branches(result, bounds);
  REQUIRE(result.components.size() == 1);
  CHECK(result.components.front().kind == SurfaceComponentKind::curve);
  CHECK(!result.components.front().certified);
}

TEST_CASE("the image of a curve under the exchange of preimages is found in domains of any size") {
  for (const double width : {1.0, 1e-6, 1e6}) {
    CAPTURE(width);
    const DomainBounds bounds{{{{0, width}}, {{0, width}}, {{0, width}}, {{0, width}}}};
    const auto curve = [&](double u, double s) {
      return piece({u * width, 0, s * width, 0}, {0, -1, 0, -1}, {u * width, width, s * width, width}, {0, 1, 0, 1});
    };
    SurfaceResult result;
    result.components = {curve(0.125, 0.75), curve(0.25, 0.625), curve(0.75, 0.125), curve(0.625, 0.25)};
    remove_mirror_images(result, bounds);
    REQUIRE(result.components.size() == 2);
    for (const SurfaceComponent& component : result.components) {
      CHECK(component.certified);
      CHECK(!component.mirrored);
    }
    // Without its image.
    result.components = {curve(0.125, 0.75), curve(0.25, 0.625)};
    remove_mirror_images(result, bounds);
    REQUIRE(result.components.size() == 2);
    for (const SurfaceComponent& component : result.components) CHECK(!component.certified);
  }
}
