// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/surface_checks.hpp>

#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ParametricSurface;

namespace {

ParametricSurface unbounded(const PatchText& text) {
  return {{{symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, polynomials_of(text)), {}}}};
}

/// Whether two homogeneous points are one.
bool same_point(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  bool zero_a = true;
  bool zero_b = true;
  for (std::size_t i = 0; i < 4; ++i) {
    zero_a = zero_a && a[i].is_zero();
    zero_b = zero_b && b[i].is_zero();
    for (std::size_t k = 0; k < i; ++k)
      if (!(a[i] * b[k] - a[k] * b[i]).is_zero()) return false;
  }
  return !zero_a && !zero_b;
}

}  // namespace

TEST_CASE("Projective charts: their points are the points of the surface, and they cover all parameters") {
  for (const PatchText& text :
       {PatchText{"u", "v", "u^2 + v^2"}, PatchText{"1 - u^2", "2*u", "v^3*(1 + u^2)", "1 + u^2"},
        PatchText{"u*v - 2", "u + 3*v^2", "5*u - v", "1 + u*v + u^3"}}) {
    CAPTURE(text.z);
    const ParametricSurface surface = unbounded(text);
    for (const std::size_t which : {0U, 1U, 2U}) {
      const auto charts = projective_charts(surface, which);
      // By how often each parameter, or its inverse, is in a chart.
      for (const Rational& u : {ratio(-7, 2), ratio(-1, 3), ratio(1, 5), ratio(4, 1)})
        for (const Rational& v : {ratio(-9, 4), ratio(-1, 7), ratio(2, 3), ratio(11, 10)}) {
          std::size_t times = 0;
          for (const ProjectiveChart& chart : charts) {
            const std::array<Rational, 2> local{chart.inverted[0] ? Rational(1) / u : u,
                                                chart.inverted[1] ? Rational(1) / v : v};
            bool inside = true;
            for (std::size_t k = 0; k < 2; ++k) {
              const symbolic::Interval& side = chart.piece.region->sides[k];
              inside = inside && !(local[k] < side.lower) && !(side.upper < local[k]);
            }
            if (inside) ++times;
            CHECK(same_point(chart.piece.map.at({local[0], local[1]}), surface.pieces[0].map.at({u, v})));
          }
          CHECK(times == 1);
        }
    }
    CHECK(domain_bounds(surface, surface) == DomainBounds{});
  }
}

TEST_CASE("Projective charts: of pairs of surfaces with positive weights all control weights are positive") {
  for (const std::size_t which : {0U, 1U})
    for (const ProjectiveChart& chart :
         projective_charts(unbounded({"u", "v", "u^2*v^2", "(1 + u^2)*(1 + v^2)"}), which)) {
      const auto net = prepared_net(chart.piece);
      REQUIRE(net.has_value());
      for (const bridge::ExactPoint& point : net->exact.points) CHECK(point[3].sign() > 0);
    }
}

TEST_CASE("Projective charts: pieces with domains are their own charts, and bounds are the hull of their domains") {
  const ParametricSurface surface = half_cylinder();
  const auto charts = projective_charts(surface, 0);
  REQUIRE(charts.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(charts[i].inverted == std::array{false, false});
    CHECK(charts[i].piece.region->sides[0] ==
          symbolic::Interval{Rational(static_cast<long>(i)), Rational(static_cast<long>(i) + 1)});
  }
  const DomainBounds bounds = domain_bounds(surface, unbounded({"u", "v", "0"}));
  REQUIRE(bounds[0].has_value());
  REQUIRE(bounds[1].has_value());
  CHECK(*bounds[0] == std::array<double, 2>{0, 2});
  CHECK(*bounds[1] == std::array<double, 2>{0, 1});
  CHECK_FALSE(bounds[2].has_value());
  CHECK_FALSE(bounds[3].has_value());
}

TEST_CASE("Projective charts: parameters of results become those of the surfaces, infinity too") {
  SurfaceResult result;
  SurfaceComponent curve;
  curve.points = {{{0.5, -0.25, 0.125, 1}, {}}, {{0, 0.25, 0, -1}, {}}};
  result.components.push_back(curve);
  SurfaceSingularPoint singular;
  singular.at.parameters = {-0.5, 0.5, -0.5, 0.5};
  result.singular_points.push_back(singular);
  const symbolic::SurfacePiece piece = patch({"u", "v", "0"});
  to_surface_parameters(result, {piece, {true, false}}, {piece, {false, true}});
  CHECK(result.components[0].points[0].parameters == std::array{2.0, -0.25, 0.125, 1.0});
  CHECK(result.components[0].points[1].parameters == std::array<double, 4>{INFINITY, 0.25, 0, -1});
  CHECK(result.singular_points[0].at.parameters == std::array{-2.0, 0.5, -0.5, 2.0});
}
