// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/projective_charts.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include <eliminant/bridge/ball.hpp>

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

double nearest(const symbolic::Rational& value) {
  bridge::RealBall ball;
  arb_set_fmpq(ball.get(), value.get(), 64);
  return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
}

}  // namespace

std::vector<ProjectiveChart> projective_charts(const symbolic::ParametricSurface& surface) {
  std::vector<ProjectiveChart> charts;
  const symbolic::Interval side{symbolic::Rational(-1), symbolic::Rational(1)};
  for (const SurfacePiece& piece : surface.pieces) {
    if (piece.region) {
      charts.push_back({piece, {}});
      continue;
    }
    for (const bool u : {false, true})
      for (const bool v : {false, true}) {
        std::vector<Polynomial> coordinates = piece.map.coordinates();
        for (Polynomial& p : coordinates) {
          if (u) p = reversed(p, 0, piece.map.bidegree()[0]);
          if (v) p = reversed(p, 1, piece.map.bidegree()[1]);
        }
        charts.push_back({{RationalSurface(RationalSurface::Kind::tensor_product, std::move(coordinates)),
                           symbolic::ParameterRegion{{side, side}, false}},
                          {u, v}});
      }
  }
  return charts;
}

void to_surface_parameters(SurfaceResult& result, const ProjectiveChart& first, const ProjectiveChart& second) {
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
      const double lower = nearest(side.lower);
      const double upper = nearest(side.upper);
      if (!bounds[k]) bounds[k] = {lower, upper};
      (*bounds[k])[0] = std::min((*bounds[k])[0], lower);
      (*bounds[k])[1] = std::max((*bounds[k])[1], upper);
    }
  return bounds;
}

}  // namespace eliminant::intersect
