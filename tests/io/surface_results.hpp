// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

#include <io/geometry_text.hpp>

#include <eliminant/intersect/patches/surface_result.hpp>

/// Results of surfaces, written down by hand.
namespace eliminant::test {

/// A curve from a corner to a crossing, with a parameter at infinity, an unknown one and a point at infinity; a loop of
/// contact that is not proven; a point.
inline intersect::SurfaceResult two_surfaces() {
  using namespace intersect;
  SurfaceResult result;
  result.status = Status::numeric;
  result.counts = {.curves = 1, .loops = 1, .points = 1, .overlaps = 0, .singular = 1, .excluded = 2};
  SurfaceComponent curve;
  curve.points = {{{-0.0, 0.1, INFINITY, std::numeric_limits<double>::quiet_NaN()}, {-2.5, 0, 1}},
                  {{0.5, 0.5, -INFINITY, 0.25}, {0, 1e-20, -INFINITY}}};
  curve.start.side = {-1, 0, 0, 1};
  curve.start.transition = Transition::out;
  curve.end.kind = BranchEndKind::singular;
  curve.end.singular_point = 0;
  curve.error = 1e-9;
  curve.certified = true;
  curve.spline = BranchSpline{
      3,
      {0, 0, 0, 0, 1, 1, 1, 1},
      std::vector<std::array<double, 7>>(4, {0.25, 0, 0, std::numeric_limits<double>::quiet_NaN(), 1, 2, 3}),
      2e-9};
  SurfaceComponent loop;
  loop.kind = SurfaceComponentKind::loop;
  loop.points = {
      {{0.2, 0.2, 0.2, 0.2}, {1, 2, 3}}, {{0.3, 0.2, 0.2, 0.2}, {1, 2, 4}}, {{0.2, 0.2, 0.2, 0.2}, {1, 2, 3}}};
  loop.tangential = true;
  loop.reason = "a contact along a curve is not proven";
  SurfaceComponent point;
  point.kind = SurfaceComponentKind::point;
  point.points = {{{0.75, 0.25, 0.5, 0.5}, {0.125, 0, 0}}};
  point.certified = true;
  result.components = {curve, loop, point};
  SurfaceSingularPoint crossing;
  crossing.kind = SurfaceSingularity::crossing;
  crossing.at = {{0.5, 0.5, 0.5, 0.5}, {0, 0, 0.25}};
  crossing.radius = 1e-12;
  crossing.half_branches = 4;
  crossing.certified = true;
  result.singular_points = {crossing};
  result.engine.method = "subdivision";
  result.seconds = {{"total", 0.5}};
  result.warnings = {"a warning"};
  return result;
}

/// A curve of double points between two pinch points, with the eliminant u^2 (u v - 1).
inline intersect::SurfaceResult with_itself() {
  using namespace intersect;
  SurfaceResult result;
  result.problem = "self_intersection";
  result.status = Status::certified;
  result.counts = {.curves = 1, .loops = 0, .points = 0, .overlaps = 0, .singular = 2, .excluded = 0};
  SurfaceComponent curve;
  for (int i = 0; i <= 8; ++i) {
    const double a = i / 8.0;
    curve.points.push_back({{a, 0.5 + a * (1 - a), 1 - a, 0.5 - a * (1 - a)}, {a * (1 - a), 0, a}});
  }
  for (BranchEnd* end : {&curve.start, &curve.end}) end->kind = BranchEndKind::singular;
  curve.start.singular_point = 0;
  curve.end.singular_point = 1;
  curve.mirrored = true;
  curve.certified = true;
  result.components = {curve};
  for (const SurfacePoint& at : {curve.points.front(), curve.points.back()}) {
    SurfaceSingularPoint pinch;
    pinch.kind = SurfaceSingularity::pinch_point;
    pinch.at = at;
    pinch.half_branches = 2;
    pinch.certified = true;
    result.singular_points.push_back(pinch);
  }
  SurfaceProjection projection;
  projection.variables = {"u", "v"};
  symbolic::BezoutianEliminant& eliminant = projection.eliminant;
  const std::vector<symbolic::Polynomial> texts = polynomials({"u^3*v - u^2", "u*v - 1", "u"}, {"u", "v"});
  eliminant.size = eliminant.rank = 3;
  eliminant.determinant = eliminant.divisor = texts[0];
  eliminant.curve = texts[1];
  eliminant.components = {{.factor = texts[2], .multiplicity = 2, .kind = symbolic::ComponentKind::base_point},
                          {.factor = texts[1], .kind = symbolic::ComponentKind::curve, .proven = true, .meetings = 1}};
  eliminant.stationary.u = {symbolic::UnivariatePolynomial(std::vector<symbolic::Integer>{-2, 0, 1})};
  result.projection = std::move(projection);
  return result;
}

}  // namespace eliminant::test
