// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/contact_curves.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/contacts/contact_curve_points.hpp>
#include <eliminant/bridge/contacts/contact_relation_fit.hpp>
#include <eliminant/bridge/nets/exact_map.hpp>
#include <eliminant/bridge/nets/function_net.hpp>

namespace eliminant::bridge {

namespace {

/// Around singular points of a curve nothing is ever proven.
constexpr unsigned long most_failures = 20000;

}  // namespace

const std::vector<symbolic::Polynomial>& ContactCurves::coordinates(bool of_second) {
  std::vector<symbolic::Polynomial>& result = coordinates_[of_second ? 1 : 0];
  if (result.empty()) result = coordinates_of(of_second ? exact_second_ : exact_first_);
  return result;
}

bool ContactCurves::is_known(const std::array<double, 4>& point) const {
  return std::any_of(curves_.begin(), curves_.end(), [&](const ContactCurve& curve) {
    const std::size_t base = curve.swapped() ? 2 : 0;
    const std::array<double, 4> there = curve.parameters_at({point[base], point[base + 1]});
    constexpr double near = 1e-7;
    for (std::size_t k = 0; k < 4; ++k)
      if (!(std::fabs(there[k] - point[k]) < near)) return false;
    return std::fabs(curve.distance_from({point[base], point[base + 1]})) < near;
  });
}

bool ContactCurves::find(const std::array<double, 4>& near, double reach) {
  if (attempts_ == 0 || equations_ == 0) return false;
  --attempts_;
  const auto start = contact_curve_point(first_, second_, near, reach);
  if (!start || is_known(*start)) return false;
  const auto points = contact_curve_points(first_, second_, *start);
  if (points.empty()) return false;
  if (recognise(points, false) || recognise(points, true)) return true;
  --equations_;
  return false;
}

bool ContactCurves::is_along(std::size_t axis, int side) const {
  return std::any_of(curves_.begin(), curves_.end(),
                     [&](const ContactCurve& curve) { return curve.sides_along()[axis] == side; });
}

bool ContactCurves::find_along(std::size_t axis, int side, double lower, double upper) {
  if (is_along(axis, side)) return true;
  const auto is_known_border = [&](const ContactCurve& border) { return border.sides_along()[axis] == side; };
  if (equations_ == 0 || std::any_of(borders_.begin(), borders_.end(), is_known_border)) return false;
  const auto points = points_along_border(first_, second_, {axis, side, lower, upper});
  if (points.empty()) return false;
  const bool of_second = axis >= 2;
  if (recognise_border(points, of_second, axis, side) || recognise_border(points, !of_second, axis, side))
    return is_along(axis, side);
  --equations_;
  return false;
}

std::optional<ContactCurve> ContactCurves::curve_through(const std::vector<std::array<double, 4>>& points,
                                                         bool swapped) const {
  std::vector<std::array<double, 4>> ordered = points;
  if (swapped)
    for (std::array<double, 4>& p : ordered) p = {p[2], p[3], p[0], p[1]};
  const auto relation = contact_relation_fit(ordered);
  const auto has_zero = [](const symbolic::Polynomial& p) {
    return !excludes_zero(function_net(p, {symbolic::Interval{0, 1}, symbolic::Interval{0, 1}}), {0, 0}, {1, 1});
  };
  if (!relation || has_zero(relation->denominator[0]) || has_zero(relation->denominator[1])) return std::nullopt;
  if (swapped) return ContactCurve(second_, first_, exact_second_, exact_first_, *relation, true);
  return ContactCurve(first_, second_, exact_first_, exact_second_, *relation, false);
}

bool ContactCurves::add_if_touching(const ContactCurve& curve) {
  if (!symbolic::touch_along(coordinates(curve.swapped()), coordinates(!curve.swapped()), curve.relation()))
    return false;
  curves_.push_back(curve);
  explained_size_.push_back(1);
  return true;
}

bool ContactCurves::recognise(const std::vector<std::array<double, 4>>& points, bool swapped) {
  const auto curve = curve_through(points, swapped);
  return curve && add_if_touching(*curve);
}

bool ContactCurves::recognise_border(const std::vector<std::array<double, 4>>& points, bool swapped, std::size_t axis,
                                     int side) {
  const auto curve = curve_through(points, swapped);
  if (!curve || curve->sides_along()[axis] != side) return false;
  if (add_if_touching(*curve)) return true;
  const std::size_t other = axis < 2 ? 2 : 0;
  if (curve->sides_along()[other] == 0 && curve->sides_along()[other + 1] == 0) return false;
  if (!symbolic::meet_along(coordinates(swapped), coordinates(!swapped), curve->relation())) return false;
  borders_.push_back(*curve);
  return true;
}

bool ContactCurves::explains(const CellBox& box) {
  double size = 0;
  for (std::size_t k = 0; k < 4; ++k) size = std::max(size, box.upper[k] - box.lower[k]);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    if (curves_[i].is_explained(box)) return true;
    if (failures_ > most_failures) continue;
    // Boxes much larger than the last one that was explained, or nearly as large as one that was not, hardly ever are;
    // but the size that is tried grows again while there are only such.
    constexpr double growth = 1.5;
    constexpr double patience = 1.05;
    constexpr double shrinking = 0.7;
    if (size > growth * explained_size_[i]) {
      explained_size_[i] *= patience;
      continue;
    }
    if (!curves_[i].explains(box)) {
      ++failures_;
      explained_size_[i] = std::min(explained_size_[i], shrinking / growth * size);
      continue;
    }
    explained_size_[i] = size;
    return true;
  }
  return std::any_of(borders_.begin(), borders_.end(), [&](ContactCurve& border) {
    if (border.is_explained(box)) return true;
    if (border_attempts_ == 0) return false;
    if (border.keeps_apart(box)) return true;
    --border_attempts_;
    return false;
  });
}

std::optional<CellBox> ContactCurves::explained_around(std::size_t axis, const std::array<double, 4>& near,
                                                       const std::array<double, 4>& half_width) {
  for (const std::deque<ContactCurve>* curves : {&curves_, &borders_})
    for (const ContactCurve& curve : *curves)
      if (const auto box = explained_around(curve, axis, near, half_width)) return box;
  return std::nullopt;
}

std::optional<CellBox> ContactCurves::explained_around(const ContactCurve& curve, std::size_t axis,
                                                       const std::array<double, 4>& near,
                                                       const std::array<double, 4>& half_width) {
  const auto point = curve.point_on_cut(axis, near);
  if (!point) return std::nullopt;
  for (std::size_t k = 0; k < 4; ++k)
    if (k != axis && !(std::fabs((*point)[k] - near[k]) < half_width[k])) return std::nullopt;
  constexpr int most_halvings = 12;
  for (int i = 0; i < most_halvings; ++i) {
    CellBox box;
    for (std::size_t k = 0; k < 4; ++k) {
      // The width across the cut stands for roundings.
      const double half = k == axis ? half_width[k] : std::ldexp(half_width[k], -i);
      const double middle = k == axis ? near[k] : (*point)[k];
      box.lower[k] = middle - half;
      box.upper[k] = middle + half;
    }
    if (explains(box)) return box;
  }
  return std::nullopt;
}

bool ContactCurves::is_exhausted() const { return failures_ > most_failures; }

void ContactCurves::count_failed_cut() {
  // As dear as many boxes.
  constexpr unsigned long boxes = 10;
  if (!curves_.empty()) failures_ += boxes;
}

bool ContactCurves::holds(const std::array<symbolic::Rational, 4>& parameters) const {
  return std::any_of(curves_.begin(), curves_.end(), [&](const ContactCurve& curve) {
    const symbolic::ContactRelation& relation = curve.relation();
    const std::size_t base = curve.swapped() ? 2 : 0;
    const std::array<symbolic::Polynomial, 2> at{symbolic::Polynomial::constant(2, parameters[base]),
                                                 symbolic::Polynomial::constant(2, parameters[base + 1])};
    const auto value = [&](const symbolic::Polynomial& p) { return p.compose(at).constant_term(); };
    for (std::size_t k = 0; k < 2; ++k) {
      const symbolic::Rational& other = parameters[2 - base + k];
      const symbolic::Rational below = value(relation.denominator[k]);
      if (below.is_zero() || !(value(relation.numerator[k]) == other * below)) return false;
    }
    return value(relation.curve).is_zero();
  });
}

std::optional<ContactCurves::Crossing> ContactCurves::crossing(const CellBox& box) {
  for (std::size_t i = 0; i < curves_.size() && failures_ <= most_failures; ++i) {
    if (!curves_[i].is_near(box)) continue;
    const auto found = curves_[i].crossing(box);
    if (!found) {
      ++failures_;
      continue;
    }
    Crossing result;
    static_cast<CurveCrossing&>(result) = *found;
    result.curve = i;
    return result;
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
