// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/contact_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/bridge/contacts/contact_curve_internal.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>

namespace eliminant::bridge {

using namespace contact;

ContactCurve::ContactCurve(const ControlNet& base, const ControlNet& other, const ExactNet& exact_base,
                           const ExactNet& exact_other, symbolic::ContactRelation relation, bool swapped)
    : base_(base),
      other_(other),
      exact_base_(exact_base),
      exact_other_(exact_other),
      relation_(std::move(relation)),
      swapped_(swapped),
      curve_(relation_.curve) {
  for (std::size_t k = 0; k < 2; ++k) {
    by_[k] = curve_.derivative(k);
    numerator_[k] = IntervalPolynomial(relation_.numerator[k]);
    denominator_[k] = IntervalPolynomial(relation_.denominator[k]);
    for (const int side : {-1, 1}) {
      const symbolic::Polynomial bound = symbolic::Polynomial::constant(2, side < 0 ? 0 : 1);
      if (symbolic::vanishes_along(symbolic::Polynomial::variable(2, k) - bound, relation_.curve))
        sides_along_[swapped ? 2 + k : k] = side;
      if (symbolic::vanishes_along(relation_.numerator[k] - bound * relation_.denominator[k], relation_.curve))
        sides_along_[swapped ? k : 2 + k] = side;
    }
  }
}

std::array<double, 4> ContactCurve::parameters_at(const Place& base) const {
  std::array<double, 4> result{base[0], base[1], 0, 0};
  for (std::size_t k = 0; k < 2; ++k)
    result[2 + k] = numerator_[k].near(base[0], base[1]) / denominator_[k].near(base[0], base[1]);
  if (swapped_) result = {result[2], result[3], result[0], result[1]};
  return result;
}

double ContactCurve::distance_from(const Place& base) const {
  const Place slope = gradient(base);
  return curve_.near(base[0], base[1]) / std::hypot(slope[0], slope[1]);
}

std::array<double, 3> ContactCurve::point_at(const Place& base) const {
  const Array4d point = PatchJets(base_).at(base[0], base[1]).point;
  return {point[0], point[1], point[2]};
}

std::optional<std::array<double, 4>> ContactCurve::point_on_cut(std::size_t axis,
                                                                const std::array<double, 4>& near) const {
  const std::size_t first = swapped_ ? 2 : 0;
  Place at{near[first], near[first + 1]};
  constexpr int most_steps = 15;
  for (int step = 0; step < most_steps; ++step) {
    // The equation of the curve, and that of the cut.
    const Place slope = gradient(at);
    const double value = curve_.near(at[0], at[1]);
    Place cut_slope{};
    const double cut = parameters_at(at)[axis] - near[axis];
    for (std::size_t k = 0; k < 2; ++k) {
      constexpr double small = 0x1p-20;
      Place beside = at;
      beside[k] += small;
      cut_slope[k] = (parameters_at(beside)[axis] - near[axis] - cut) / small;
    }
    const double area = cross(slope, cut_slope);
    const Place change{(value * cut_slope[1] - cut * slope[1]) / area, (slope[0] * cut - cut_slope[0] * value) / area};
    at = {at[0] - change[0], at[1] - change[1]};
    const double size = std::max(std::fabs(change[0]), std::fabs(change[1]));
    if (!(size < 1)) return std::nullopt;
    if (size < 1e-12) return parameters_at(at);
  }
  return std::nullopt;
}

CellBox ContactCurve::in_base_order(const CellBox& box) const {
  if (!swapped_) return box;
  return {{box.lower[2], box.lower[3], box.lower[0], box.lower[1]},
          {box.upper[2], box.upper[3], box.upper[0], box.upper[1]}};
}

Place ContactCurve::gradient(const Place& at) const { return {by_[0].near(at[0], at[1]), by_[1].near(at[0], at[1])}; }

Place ContactCurve::nearest(Place at) const {
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const Place slope = gradient(at);
    const double by = curve_.near(at[0], at[1]) / dot(slope, slope);
    if (!std::isfinite(by)) break;
    at = {at[0] - by * slope[0], at[1] - by * slope[1]};
    if (std::fabs(by) * std::hypot(slope[0], slope[1]) < 1e-15) break;
  }
  return at;
}

std::optional<ContactCurve::Region> ContactCurve::region(const CellBox& box, const Place& origin, const Place& across,
                                                         const Place& along, std::size_t order) const {
  Region result;
  result.origin = origin;
  result.across = across;
  result.along = along;
  // Around the cell.
  const double area = cross(across, along);
  for (const double a : {box.lower[0], box.upper[0]})
    for (const double b : {box.lower[1], box.upper[1]}) {
      const Place corner{a - origin[0], b - origin[1]};
      result.reach = std::max(result.reach, std::fabs(cross(corner, along) / area));
      result.length = std::max(result.length, std::fabs(cross(across, corner) / area));
    }
  constexpr double rounding = 1 + 1e-9;
  result.length = result.length * rounding + 1e-12;
  const IntervalPolynomial curve = curve_.in_frame(origin, across, along);
  const DoubleInterval lines = symmetric(result.length);
  // The curve leaves through both ends, and not through the sides.
  const double steepness = std::fabs(curve.derivative(0).near(0, 0));
  const double far = 1.3 * curve.on(DoubleInterval(0), lines).magnitude() / steepness;
  result.reach = std::max(result.reach * rounding, far) + 1e-12;
  if (!(result.reach < 1) || !(result.length < 1)) return std::nullopt;
  const DoubleInterval right = curve.on(DoubleInterval(result.reach), lines);
  const DoubleInterval left = curve.on(DoubleInterval(-result.reach), lines);
  if (!right.excludes_zero() || !left.excludes_zero() || (right.lower > 0) == (left.lower > 0)) return std::nullopt;
  const DoubleInterval all = symmetric(result.reach);
  const IntervalPolynomial by_x = curve.derivative(0);
  const IntervalPolynomial by_y = curve.derivative(1);
  const DoubleInterval steep = by_x.on(all, lines);
  result.slope = -by_y.on(all, lines) / steep;
  result.bend =
      -(by_y.derivative(1).on(all, lines) + DoubleInterval(2) * result.slope * by_x.derivative(1).on(all, lines) +
        result.slope * result.slope * by_x.derivative(0).on(all, lines)) /
      steep;
  if (!result.slope.is_finite() || !result.bend.is_finite()) return std::nullopt;

  OpenBox of_base{};
  constexpr double beyond = 0.25;
  for (std::size_t k = 0; k < 2; ++k) {
    const double half = (result.reach * std::fabs(across[k]) + result.length * std::fabs(along[k])) * rounding;
    of_base.lower[k] = origin[k] - half;
    of_base.upper[k] = origin[k] + half;
    if (of_base.lower[k] < -beyond || of_base.upper[k] > 1 + beyond) return std::nullopt;
  }
  // The other patch: where the curve is, the cell is, and all points are that are equal along the tangent plane.
  OpenBox of_other{};
  Place middle{};
  for (std::size_t k = 0; k < 2; ++k) {
    const DoubleInterval on_curve = numerator_[k].in_frame(origin, across, along).on(all, lines) /
                                    denominator_[k].in_frame(origin, across, along).on(all, lines);
    if (!on_curve.is_finite()) return std::nullopt;
    of_other.lower[k] = std::min(on_curve.lower, box.lower[2 + k]);
    of_other.upper[k] = std::max(on_curve.upper, box.upper[2 + k]);
    middle[k] = numerator_[k].near(origin[0], origin[1]) / denominator_[k].near(origin[0], origin[1]);
  }
  const auto frame = tangent_frame(PatchJets(base_).at(origin[0], origin[1]));
  if (!frame) return std::nullopt;
  const auto by_plane = parameters_by_plane(*frame, PatchJets(other_).at(middle[0], middle[1]));
  if (!by_plane) return std::nullopt;
  result.frame = *frame;
  result.by_plane = *by_plane;
  result.middle_of_other = middle;
  result.base = taylor_on_box(base_, *frame, of_base, 0, order);
  const EnclosedPatch enclosed_base(result.base.truncated(2));
  for (std::size_t k = 0; k < 2; ++k) {
    const auto row = static_cast<long>(k);
    const double half = 1.6 * (std::fabs((*by_plane)(row, 0)) * enclosed_base.value[0].magnitude() +
                               std::fabs((*by_plane)(row, 1)) * enclosed_base.value[1].magnitude());
    of_other.lower[k] = std::min(of_other.lower[k], middle[k] - half);
    of_other.upper[k] = std::max(of_other.upper[k], middle[k] + half);
    result.lower_of_other[k] = of_other.lower[k];
    result.upper_of_other[k] = of_other.upper[k];
    if (!(of_other.lower[k] > -beyond) || !(of_other.upper[k] < 1 + beyond)) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i)
      result.following += 1.6 * (std::fabs((*by_plane)(row, 0)) * enclosed_base.first[i][0].magnitude() +
                                 std::fabs((*by_plane)(row, 1)) * enclosed_base.first[i][1].magnitude());
  }
  result.polynomial = base_.polynomial && other_.polynomial;
  result.base = in_parameters(result.base, columns_of(across, along), result.polynomial);
  result.other = in_parameters(taylor_on_box(other_, *frame, of_other, 0, order), *by_plane, result.polynomial);
  if (!(result.base.at(0, 0)[weight].lower > 0) || !(result.other.at(0, 0)[weight].lower > 0)) return std::nullopt;
  // In these parameters the derivative along the tangent plane is near the identity: the function exists, and is one.
  const EnclosedPatch enclosed_other(result.other.truncated(2));
  constexpr double at_most = 0.3;
  for (std::size_t c = 0; c < 2; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k)
      sum += (enclosed_other.first[k][c] - DoubleInterval(c == k ? 1 : 0)).magnitude();
    if (!(sum < at_most)) return std::nullopt;
  }
  return result;
}

ContactCurve::Forms ContactCurve::forms_on(const Region& region, const PlaneSeries<DoubleInterval>& heights) const {
  Forms forms;
  forms.xxxx = DoubleInterval(24) * heights.at(4, 0);
  forms.xxxy = DoubleInterval(6) * heights.at(3, 1);
  forms.xxyy = DoubleInterval(4) * heights.at(2, 2);
  // What is known at the origin, and by how much it changes: both patches alike bend more than their difference.
  const auto tables = tables_near(region.origin, 3);
  if (!tables) return forms;
  const PlaneSeries<double> near = tables->heights(region.across, region.along, 3);
  const DoubleInterval across(-region.reach, region.reach);
  const DoubleInterval along(-region.length, region.length);
  const DoubleInterval third_here = DoubleInterval::around(6 * near.at(3, 0), rounding_of_derivative(3));
  const DoubleInterval mixed_here = DoubleInterval::around(2 * near.at(2, 1), 4 * rounding_of_derivative(3));
  forms.xxx = third_here + across * forms.xxxx + along * forms.xxxy;
  forms.xxy = mixed_here + across * forms.xxxy + along * forms.xxyy;
  const auto square = [](double half) { return DoubleInterval(0, half * half * (1 + 1e-12)); };
  forms.xx = DoubleInterval::around(2 * near.at(2, 0), rounding_of_derivative(2)) + across * third_here +
             along * mixed_here + DoubleInterval(0.5) * square(region.reach) * forms.xxxx +
             across * along * forms.xxxy + DoubleInterval(0.5) * square(region.length) * forms.xxyy;
  return forms;
}

double ContactCurve::rounding_of_derivative(std::size_t order) const {
  double sum = 0;
  double heaviest = 1;
  for (const ControlNet* net : {&base_, &other_}) {
    double extent = 0;
    for (const Array4d& point : net->points) {
      extent = std::max(extent, point.abs().head<3>().maxCoeff());
      heaviest = std::max(heaviest, point[3]);
    }
    const auto degree = static_cast<double>(net->degrees[0] + net->degrees[1]);
    sum += extent * std::pow(degree, 2 * static_cast<double>(order));
  }
  return 0x1p-46 * heaviest * sum;
}

bool ContactCurve::Explained::covers(const CellBox& box) const {
  for (std::size_t k = 0; k < 2; ++k)
    if (box.lower[2 + k] < lower[k] || box.upper[2 + k] > upper[k]) return false;
  const double area = cross(across, along);
  for (const double a : {box.lower[0], box.upper[0]})
    for (const double b : {box.lower[1], box.upper[1]}) {
      const Place corner{a - origin[0], b - origin[1]};
      if (!(std::fabs(cross(corner, along) / area) < reach) || !(std::fabs(cross(across, corner) / area) < length))
        return false;
    }
  return true;
}

bool ContactCurve::is_explained(const CellBox& asked) const {
  const CellBox box = in_base_order(asked);
  return std::any_of(explained_.rbegin(), explained_.rend(), [&](const Explained& e) { return e.covers(box); });
}

std::optional<ContactCurve::Surroundings> ContactCurve::surroundings(const CellBox& box) const {
  const Place middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
  Surroundings result;
  result.origin = nearest(middle);
  // Only around the curve.
  const double size = std::max({box.upper[0] - box.lower[0], box.upper[1] - box.lower[1], 1e-6});
  if (!(std::hypot(result.origin[0] - middle[0], result.origin[1] - middle[1]) < 2 * size)) return std::nullopt;
  result.across = unit(gradient(result.origin));
  result.along = {-result.across[1], result.across[0]};
  // On a cut its own direction will do.
  constexpr double thin = 1e-6;
  const std::array<double, 2> width{box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]};
  result.is_cut = std::min(width[0], width[1]) < thin * std::max(width[0], width[1]);
  if (!result.is_cut) return result;
  const std::size_t kept = width[0] < width[1] ? 0 : 1;
  // Where the cut meets the curve.
  Place at{middle[0], middle[1]};
  for (int step = 0; step < 10; ++step) at[1 - kept] -= curve_.near(at[0], at[1]) / gradient(at)[1 - kept];
  if (!(std::fabs(at[1 - kept] - middle[1 - kept]) < 2 * size)) return std::nullopt;
  result.origin = at;
  result.across = {kept == 0 ? 0.0 : 1.0, kept == 0 ? 1.0 : 0.0};
  result.along = {kept == 0 ? 1.0 : 0.0, kept == 0 ? 0.0 : 1.0};
  return result;
}

bool ContactCurve::keeps_apart(const CellBox& asked) {
  const CellBox box = in_base_order(asked);
  const auto at = surroundings(box);
  if (!at) return false;
  const auto around = region(box, at->origin, at->across, at->along, 2);
  return around && keeps_apart(*around) && record(*around, at->is_cut);
}

bool ContactCurve::explains(const CellBox& asked) {
  const CellBox box = in_base_order(asked);
  const auto at = surroundings(box);
  if (!at) return false;
  const auto has_one_sign = [](const DoubleInterval& x) { return x.is_finite() && x.excludes_zero(); };
  const auto around = region(box, at->origin, at->across, at->along, 4);
  if (!around) return false;
  if (keeps_apart(*around)) return record(*around, at->is_cut);
  // More often than not, larger cells are not worth a closer look.
  constexpr double small = 0.125;
  const bool is_small = around->reach < small && around->length < small;
  const PlaneSeries<DoubleInterval> heights = around->heights(is_small ? 4 : 2);
  if (!has_one_sign(heights.at(2, 0)) &&
      !(is_small && has_one_sign(at->is_cut ? bend_on_cut(*around, heights) : forms_on(*around, heights).xx)))
    return false;
  return record(*around, at->is_cut);
}

bool ContactCurve::record(const Region& region, bool is_cut) {
  constexpr double inside = 1 - 1e-9;
  if (!is_cut)
    explained_.push_back({region.origin, region.across, region.along, region.reach * inside, region.length * inside,
                          region.lower_of_other, region.upper_of_other});
  return true;
}

bool ContactCurve::keeps_apart(const Region& region) const {
  const std::size_t own = swapped_ ? 2 : 0;
  std::optional<std::array<DoubleInterval, 2>> moving;
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) {
      const int side = sides_along_[own + a];
      const int side_of_other = sides_along_[2 - own + b];
      if (side == 0 || side_of_other == 0 || region.across[a] == 0) continue;
      if (!moving) moving = region.other_across();
      // One step across moves both parameters out of their domains, or both in; else one leaves where the other enters.
      const int outwards = region.across[a] > 0 ? side : -side;
      const DoubleInterval& moved = (*moving)[b];
      if (!moved.is_finite() || !moved.excludes_zero()) continue;
      if ((moved.lower > 0 ? side_of_other : -side_of_other) != outwards) return true;
    }
  return false;
}

DoubleInterval ContactCurve::bend_on_cut(const Region& region, const PlaneSeries<DoubleInterval>& heights) const {
  const auto tables = tables_near(region.origin, 3);
  if (!tables) return {-INFINITY, INFINITY};
  const PlaneSeries<double> near = tables->heights(region.across, region.along, 3);
  const DoubleInterval across(-region.reach, region.reach);
  const DoubleInterval along(-region.length, region.length);
  // Along the cut by Taylor's formula; it hardly has a width.
  const double square = region.reach * region.reach * (1 + 1e-12);
  return DoubleInterval::around(2 * near.at(2, 0), rounding_of_derivative(2)) +
         across * DoubleInterval::around(6 * near.at(3, 0), rounding_of_derivative(3)) +
         DoubleInterval(0, 12 * square) * heights.at(4, 0) + along * (DoubleInterval(2) * heights.at(2, 1));
}

}  // namespace eliminant::bridge
