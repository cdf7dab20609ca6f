// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/patches/one_sign_parts.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// (u, v, height) with this weight.
symbolic::SurfacePiece weighted(const std::string& weight, const std::string& height = "u*v",
                                const Sides& sides = unit_square()) {
  const std::string w = "(" + weight + ")";
  return patch({"u*" + w, "v*" + w, "(" + height + ")*" + w + " + u^2/9", w}, sides);
}

SurfaceResult with_plane(const symbolic::SurfacePiece& piece, const std::string& z) {
  Options options;
  options.tolerance = 1e-5;
  const symbolic::Interval side{-2, 2};
  return intersect_surface_surface(
      {symbolic::ParametricSurface{{piece}}, symbolic::ParametricSurface{{patch({"u", "v", z}, {side, side})}}},
      options, Context());
}

}  // namespace

TEST_CASE("Parts with weights of one sign: a patch that has them is left alone") {
  for (const std::string weight : {"1", "1 + u + v", "-2 - u*v"}) {
    const OneSignParts cut = one_sign_parts(weighted(weight), 0);
    CHECK(cut.signs == WeightSigns::one);
    REQUIRE(cut.parts.size() == 1);
    CHECK(cut.parts[0].region->sides == unit_square());
  }
}

TEST_CASE("Parts with weights of one sign: of a weight without a zero they make up the patch") {
  // Bernstein coefficients 1, -1/2, 1, and the like in both parameters.
  for (const std::string weight : {"1 - 3*u + 3*u^2", "3*u - 1 - 3*u^2", "1 - 3*u + 3*u^2 - v/2 + v^2/2",
                                   "(1 - 3*u + 3*u^2)*(1 - 3*v + 3*v^2)", "(2*u - 1)^2 + (3*v - 1)^2 + 1/1000"})
    for (std::size_t which = 0; which < 3; ++which) {
      CAPTURE(weight);
      const OneSignParts cut = one_sign_parts(weighted(weight), which);
      CHECK(cut.signs == WeightSigns::one);
      CHECK(cut.parts.size() > 1);
      symbolic::Rational area;
      for (const symbolic::SurfacePiece& part : cut.parts) {
        const Sides& sides = part.region->sides;
        area = area + (sides[0].upper - sides[0].lower) * (sides[1].upper - sides[1].lower);
        CHECK(has_positive_weights(prepared_patch(part, "")));
      }
      CHECK(area == symbolic::Rational(1));
    }
}

TEST_CASE("Parts with weights of one sign: a zero of the weight is found, or not excluded") {
  for (const std::string weight : {"1 - 5*u + 5*u^2", "u*v", "u - v", "1 - 4*u*v"}) {
    CAPTURE(weight);
    const OneSignParts cut = one_sign_parts(weighted(weight), 0);
    CHECK(cut.signs == WeightSigns::both);
    CHECK(cut.parts.size() == 1);
  }
  // An isolated zero that is no corner of parts, and a weight that is nearly zero in many places.
  CHECK(one_sign_parts(weighted("(2*u - 1)^2 + (3*v - 1)^2"), 0).signs == WeightSigns::undecided);
  CHECK(one_sign_parts(weighted("(2*u - 1)^2 + 1/10000000000"), 0).signs == WeightSigns::undecided);
}

TEST_CASE("Weights of both signs without a zero: the curve with a plane over all parts") {
  // u v + u^2 / (9 w) = 1/4 is a curve from u = 1 to v = 1.
  for (const std::string weight : {"1 - 3*u + 3*u^2", "3*u - 1 - 3*u^2", "(1 - 3*u + 3*u^2)*(1 - 3*v + 3*v^2)"}) {
    CAPTURE(weight);
    const SurfaceResult result = with_plane(weighted(weight), "1/4");
    CHECK(result.status == Status::certified);
    for (const SurfaceComponent& component : result.components) {
      CHECK(component.kind == SurfaceComponentKind::curve);
      for (const BranchEnd* end : {&component.start, &component.end}) {
        CHECK(end->kind == BranchEndKind::border);
        CHECK(end->side != std::array<int, 4>{});
      }
      for (const SurfacePoint& at : component.points) {
        CHECK(std::fabs(at.point[2] - 0.25) < 1e-12);
        CHECK(std::fabs(at.point[0] - at.parameters[0]) < 1e-12);
      }
    }
    // As many ends as there are zeros on the borders, and no curve inside alone: u = 1 and v = 1 are met.
    CHECK(result.counts.curves >= 1);
    CHECK(result.counts.loops == 0);
  }
  const SurfaceResult exact =
      with_plane(patch({"u*(1 - 3*u + 3*u^2)", "v*(1 - 3*u + 3*u^2)", "v", "1 - 3*u + 3*u^2"}), "2");
  // v = 2 (1 - 3 u + 3 u^2) within v <= 1: between u = (3 - sqrt 3) / 6 and (3 + sqrt 3) / 6.
  CHECK(summary(exact) == "1 0 0 0 0 certified");
  REQUIRE(exact.components.size() == 1);
  const auto& points = exact.components[0].points;
  CHECK(std::fabs(points.front().parameters[0] - (3 - std::sqrt(3)) / 6) < 1e-12);
  CHECK(std::fabs(points.back().parameters[0] - (3 + std::sqrt(3)) / 6) < 1e-12);
  for (const SurfacePoint& at : points) {
    const double u = at.parameters[0];
    CHECK(std::fabs(at.parameters[1] - 2 * (1 - 3 * u + 3 * u * u)) < 1e-12);
  }
}

TEST_CASE("A weight with a zero in the domain: nothing is certified, and the reason is given") {
  const SurfaceResult result = with_plane(weighted("1 - 5*u + 5*u^2"), "1/4");
  CHECK(result.status == Status::numeric);
  CHECK(result.components.empty());
  CHECK(result.warnings.at(0) ==
        "the weight of the first surface is zero within its domain, where it goes to infinity");
}
