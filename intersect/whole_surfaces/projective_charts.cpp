// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::RationalSurface;
using symbolic::SurfacePiece;

/// x^degree p(1 / x) in one of two variables.
Polynomial reversed(const Polynomial& p, std::size_t variable, long degree) {
  std::vector<Polynomial::Term> terms = p.terms();
  for (Polynomial::Term& term : terms)
    term.exponents[variable] = static_cast<unsigned long>(degree) - term.exponents[variable];
  return Polynomial::from_terms(2, terms);
}

/// A part of a projective line, or the inverses of its parameters.
struct Side {
  symbolic::Interval interval;
  bool inverted = false;
};

/// Four parts of the projective line, cut at different places for each of u, v, s, t, and where no symmetry of the
/// input is: so curves do not pass through corners. On a part across 0 the Bernstein coefficients of 1 + x^2 would not
/// be positive, so both are cut once more.
std::vector<Side> sides_of(std::size_t parameter) {
  using bridge::nearest;
  using symbolic::Rational;
  constexpr std::size_t pair_parameters = 4;
  if (parameter >= pair_parameters) return {{{Rational(-1), Rational(1)}, false}, {{Rational(-1), Rational(1)}, true}};
  // In 64ths: lower and upper end, and a place between, for the parameter and for its inverse.
  constexpr std::array<std::array<long, 4>, 4> places{
      {{-55, 71, 5, -7}, {-67, 59, -9, 4}, {-61, 73, 7, 3}, {-69, 57, -4, -6}}};
  const auto& [lower, upper, between, between_inverse] = places[parameter];
  const auto part = [](long n) { return Rational(n) / Rational(64); };
  const auto inverse = [](long n) { return Rational(64) / Rational(n); };
  return {{{part(lower), part(between)}, false},
          {{part(between), part(upper)}, false},
          {{inverse(lower), part(between_inverse)}, true},
          {{part(between_inverse), inverse(upper)}, true}};
}

}  // namespace

std::vector<ProjectiveChart> projective_charts(const symbolic::ParametricSurface& surface, std::size_t which) {
  std::vector<ProjectiveChart> charts;
  for (const SurfacePiece& piece : surface.pieces) {
    if (piece.region && piece.region->triangle) {
      for (TriangleChart& part : triangle_charts(piece, which))
        charts.push_back({std::move(part.piece), {}, part.corner});
      continue;
    }
    if (piece.region) {
      charts.push_back({piece, {}, {}});
      continue;
    }
    const std::vector<Side> sides_u = sides_of(2 * which);
    const std::vector<Side> sides_v = sides_of(2 * which + 1);
    for (const Side& u : sides_u)
      for (const Side& v : sides_v) {
        std::vector<Polynomial> coordinates = piece.map.coordinates();
        for (Polynomial& p : coordinates) {
          if (u.inverted) p = reversed(p, 0, piece.map.bidegree()[0]);
          if (v.inverted) p = reversed(p, 1, piece.map.bidegree()[1]);
        }
        charts.push_back({{RationalSurface(RationalSurface::Kind::tensor_product, std::move(coordinates)),
                           symbolic::ParameterRegion{{u.interval, v.interval}, false}},
                          {u.inverted, v.inverted},
                          {}});
      }
  }
  return charts;
}

void to_surface_parameters(SurfaceResult& result, const ProjectiveChart& first, const ProjectiveChart& second) {
  for (std::size_t index = 0; index < 2; ++index)
    if (const auto& corner = (index == 0 ? first : second).corner) to_triangle_parameters(result, *corner, index);
  const auto map_back = [&](SurfacePoint& point) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (!(k < 2 ? first : second).inverted[k % 2]) continue;
      double& value = point.parameters[k];
      value = value == 0 ? std::numeric_limits<double>::infinity() : 1 / value;
    }
  };
  for (SurfaceComponent& component : result.components)
    for (SurfacePoint& point : component.points) map_back(point);
  for (SurfaceSingularPoint& point : result.singular_points) map_back(point.at);
}

DomainBounds domain_bounds(const symbolic::ParametricSurface& first, const symbolic::ParametricSurface& second) {
  DomainBounds bounds;
  for (std::size_t k = 0; k < 4; ++k)
    for (const SurfacePiece& piece : (k < 2 ? first : second).pieces) {
      if (!piece.region) continue;
      const symbolic::Interval& side = piece.region->sides[k % 2];
      const double lower = bridge::nearest(side.lower);
      const double upper = bridge::nearest(side.upper);
      if (!bounds[k]) bounds[k] = {lower, upper};
      (*bounds[k])[0] = std::min((*bounds[k])[0], lower);
      (*bounds[k])[1] = std::max((*bounds[k])[1], upper);
    }
  return bounds;
}

}  // namespace eliminant::intersect
