// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/surface_atlas.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/symbolic/geometry/border_curve.hpp>

namespace eliminant::intersect {

namespace {

using bridge::nearest;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalSurface;
using symbolic::SurfacePiece;

/// (u, v) -> the point with barycentric coordinates u, v, 1 - u - v.
SurfacePiece in_the_plane(const SurfacePiece& triangle) {
  const auto u = Polynomial::variable(2, 0);
  const auto v = Polynomial::variable(2, 1);
  const std::array<Polynomial, 3> images{u, v, Polynomial::constant(2, 1) - u - v};
  std::vector<Polynomial> coordinates;
  for (const Polynomial& form : triangle.map.coordinates()) coordinates.push_back(form.compose(images));
  const symbolic::Interval unit{0, 1};
  return {RationalSurface(RationalSurface::Kind::tensor_product, std::move(coordinates)),
          symbolic::ParameterRegion{{unit, unit}, false}};
}

/// Whether two pieces have the same points where parameter `axis` of each is at a bound, as functions of the other one.
bool have_one_border(const SurfacePiece& a, const Rational& at_a, const SurfacePiece& b, const Rational& at_b,
                     std::size_t axis) {
  const auto first = symbolic::border_curve(a.map, axis, at_a);
  const auto second = symbolic::border_curve(b.map, axis, at_b);
  if (!first || !second) return false;
  const auto& p = first->coordinates();
  const auto& q = second->coordinates();
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(p[i] * q[j] - p[j] * q[i]).is_zero()) return false;
  return true;
}

bool overlap(const symbolic::Interval& a, const symbolic::Interval& b) {
  return a.lower < b.upper && b.lower < a.upper;
}

}  // namespace

SurfaceAtlas::SurfaceAtlas(const symbolic::ParametricSurface& surface, const std::vector<ProjectiveChart>& charts) {
  std::vector<SurfacePiece> pieces;
  if (charts.front().corner)
    pieces.push_back(in_the_plane(surface.pieces.front()));
  else
    for (const ProjectiveChart& chart : charts) pieces.push_back(chart.piece);
  add(pieces);
  close(pieces);
}

void SurfaceAtlas::add(const std::vector<SurfacePiece>& pieces) {
  std::array<Rational, 3> origin;
  for (const SurfacePiece& piece : pieces) {
    const PreparedNet net = prepared_patch(piece, "first");
    if (pieces_.empty()) origin = net.origin();
    auto rounded = net.rounded(origin);
    rounded_ = rounded_ && rounded.has_value();
    if (!rounded_) return;
    Piece own{*std::move(rounded), {}, {}};
    for (std::size_t k = 0; k < 2; ++k) {
      own.lower[k] = nearest(net.domain[k].lower);
      own.upper[k] = nearest(net.domain[k].upper);
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const Rational& at : {net.domain[axis].lower, net.domain[axis].upper}) {
        const auto border = symbolic::border_curve(piece.map, axis, at);
        if (!border || border->degree() == 0) poles_.push_back({axis, nearest(at)});
      }
    pieces_.push_back(std::move(own));
  }
}

void SurfaceAtlas::close(const std::vector<SurfacePiece>& pieces) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Rational lower = pieces.front().region->sides[axis].lower;
    Rational upper = pieces.front().region->sides[axis].upper;
    for (const SurfacePiece& piece : pieces) {
      const symbolic::Interval& side = piece.region->sides[axis];
      if (side.lower < lower) lower = side.lower;
      if (upper < side.upper) upper = side.upper;
    }
    bool closed = true;
    for (const SurfacePiece& a : pieces)
      for (const SurfacePiece& b : pieces) {
        const symbolic::Interval& from = a.region->sides[axis];
        const symbolic::Interval& to = b.region->sides[axis];
        if (!overlap(a.region->sides[1 - axis], b.region->sides[1 - axis])) continue;
        if (from.upper == to.lower) continuous_ = continuous_ && have_one_border(a, from.upper, b, to.lower, axis);
        if (from.upper == upper && to.lower == lower) closed = closed && have_one_border(a, upper, b, lower, axis);
      }
    if (closed) periods_[axis] = nearest(upper) - nearest(lower);
  }
}

bool SurfaceAtlas::meet_at_pole(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) const {
  const auto touches = [](const bridge::ParameterRectangle& r, const Pole& pole) {
    return r.lower[pole.axis] <= pole.at && pole.at <= r.upper[pole.axis];
  };
  return std::any_of(poles_.begin(), poles_.end(),
                     [&](const Pole& pole) { return touches(a, pole) && touches(b, pole); });
}

bool SurfaceAtlas::is_injective_on(const bridge::ParameterRectangle& rectangle) const {
  std::vector<bridge::NetOnRectangle> parts;
  const auto shifts = [&](std::size_t axis) { return periods_[axis] ? 1 : 0; };
  for (const Piece& piece : pieces_)
    for (int i = -shifts(0); i <= shifts(0); ++i)
      for (int j = -shifts(1); j <= shifts(1); ++j) {
        bridge::NetOnRectangle part{piece.net, {}, {}};
        bool inside = true;
        for (std::size_t k = 0; k < 2; ++k) {
          const double shift = (k == 0 ? i : j) * periods_[k].value_or(0);
          const double width = piece.upper[k] - piece.lower[k];
          // Roundings of the domain, a little more.
          const double slack =
              1e-15 + 0x1p-50 * (std::fabs(piece.lower[k]) + std::fabs(piece.upper[k]) + std::fabs(shift)) / width;
          const double from = (rectangle.lower[k] - shift - piece.lower[k]) / width - slack;
          const double to = (rectangle.upper[k] - shift - piece.lower[k]) / width + slack;
          inside = inside && from < 1 && to > 0;
          // Derivatives on too narrow a strip would be lost in rounding.
          constexpr double least = 1e-6;
          part.rectangle.lower[k] = std::max(std::min(from, 1 - least), 0.0);
          part.rectangle.upper[k] = std::min(std::max(to, least), 1.0);
          part.scale[k] = 1 / width;
        }
        if (inside) parts.push_back(part);
      }
  if (parts.empty() || (parts.size() > 1 && !continuous_)) return false;
  return bridge::is_injective_on(parts);
}

}  // namespace eliminant::intersect
