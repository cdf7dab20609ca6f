// SPDX-License-Identifier: BSD-3-Clause
//
// Where a branch crosses a curve of contact.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/contacts/contact_curve_internal.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

using namespace contact;

std::optional<ContactCurve::Tables> ContactCurve::tables_near(const Place& at, std::size_t order) const {
  const auto frame = tangent_frame(PatchJets(base_).at(at[0], at[1]));
  if (!frame) return std::nullopt;
  const Place there{numerator_[0].near(at[0], at[1]) / denominator_[0].near(at[0], at[1]),
                    numerator_[1].near(at[0], at[1]) / denominator_[1].near(at[0], at[1])};
  Tables tables{taylor_near(base_, at[0], at[1], order), taylor_near(other_, there[0], there[1], order),
                base_.polynomial && other_.polynomial};
  to_frame(*frame, tables.base);
  to_frame(*frame, tables.other);
  return tables;
}

std::optional<PlaneSeries<double>> ContactCurve::heights_near(const Place& at, std::size_t order) const {
  const auto tables = tables_near(at, order);
  if (!tables) return std::nullopt;
  return tables->heights({1, 0}, {0, 1}, order);
}

std::optional<Place> ContactCurve::crossing_near(const Place& start, double reach) const {
  // The secant method along the curve.
  const auto bend_at = [&](const Place& at) {
    const auto heights = heights_near(at, 2);
    return heights ? derivative_in(*heights, unit(gradient(at)), 2) : std::nan("");
  };
  const auto moved = [&](const Place& at, double by) {
    const Place across = unit(gradient(at));
    return nearest({at[0] - by * across[1], at[1] + by * across[0]});
  };
  Place here = start;
  double bend = bend_at(here);
  double step = 0.125 * reach;
  constexpr int most_steps = 25;
  for (int i = 0; i < most_steps; ++i) {
    const Place next = moved(here, step);
    const double next_bend = bend_at(next);
    const double slope = (next_bend - bend) / step;
    if (!std::isfinite(slope) || slope == 0) return std::nullopt;
    if (!(std::hypot(next[0] - start[0], next[1] - start[1]) < reach)) return std::nullopt;
    here = next;
    bend = next_bend;
    step = -bend / slope;
    if (!(std::fabs(step) < reach)) return std::nullopt;
    if (std::fabs(step) < 1e-13) return here;
  }
  return std::fabs(step) < 1e-9 ? std::optional(here) : std::nullopt;
}

DoubleInterval ContactCurve::bend_at_origin(const Region& region) const {
  // How far the curve is from the origin, and its point of the other patch from the one taken.
  const IntervalPolynomial curve = curve_.in_frame(region.origin, region.across, region.along);
  const double far =
      1.3 * curve.on(DoubleInterval(0), DoubleInterval(0)).magnitude() / std::fabs(curve.derivative(0).near(0, 0));
  Eigen::Vector2d moved;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto value = [&](const IntervalPolynomial& p) {
      return p.in_frame(region.origin, region.across, region.along).on(symmetric(far), DoubleInterval(0));
    };
    const DoubleInterval there = value(numerator_[k]) / value(denominator_[k]);
    moved[static_cast<long>(k)] = (there - DoubleInterval(region.middle_of_other[k])).magnitude();
  }
  const double far_of_other = (region.by_plane.inverse().cwiseAbs() * moved).maxCoeff() * (1 + 1e-9);
  const auto at = [](const ExactNet& exact, const ControlNet& net, const ContactFrame& frame, const Place& place) {
    return enclosed(taylor_at(exact, {exactly(place[0]), exactly(place[1])}, 2), net, frame);
  };
  const auto base = in_parameters(at(exact_base_, base_, region.frame, region.origin),
                                  columns_of(region.across, region.along), region.polynomial);
  const auto other =
      in_parameters(at(exact_other_, other_, region.frame, region.middle_of_other), region.by_plane, region.polynomial);
  const HeightSeries<DoubleInterval> heights =
      height_series(widened(base, far, region.base), widened(other, far_of_other, region.other), 2, region.polynomial);
  return DoubleInterval(2) * heights.height.at(2, 0);
}

PlaneSeries<DoubleInterval, 5> ContactCurve::heights_by_tiles(const Region& region, std::size_t tiles) const {
  constexpr std::size_t order = 5;
  using Series = PlaneSeries<DoubleInterval, order>;
  if (tiles == 1) return height_series<order>(region.base, region.other, order, region.polynomial).height;
  // Along the plane both patches have equal coordinates; the other's parameters differ from these by little.
  const EnclosedPatch whole(region.base.truncated(2));
  const EnclosedPatch whole_other(region.other.truncated(2));
  double turn = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) sum += (whole_other.first[k][c] - DoubleInterval(c == k ? 1 : 0)).magnitude();
    turn = std::max(turn, sum);
  }
  const double room =
      1.01 * turn / (1 - turn) * std::max(whole.value[0].magnitude(), whole.value[1].magnitude()) + 1e-12;
  const auto middle_of_tile = [&](double half, std::size_t i) {
    return half * ((2 * static_cast<double>(i) + 1) / static_cast<double>(tiles) - 1);
  };
  Series nothing_known;
  for (std::size_t a = 0; a <= order; ++a)
    for (std::size_t b = 0; a + b <= order; ++b) nothing_known.at(a, b) = symmetric(INFINITY);
  Series result;
  for (std::size_t i = 0; i < tiles; ++i)
    for (std::size_t j = 0; j < tiles; ++j) {
      const double x = middle_of_tile(region.reach, i);
      const double y = middle_of_tile(region.length, j);
      OpenBox of_base{};
      for (std::size_t k = 0; k < 2; ++k) {
        const double middle = region.origin[k] + x * region.across[k] + y * region.along[k];
        const double half = 1.000001 *
                            (region.reach * std::fabs(region.across[k]) + region.length * std::fabs(region.along[k])) /
                            static_cast<double>(tiles);
        of_base.lower[k] = middle - half;
        of_base.upper[k] = middle + half;
      }
      const TaylorTable<DoubleInterval> in_base = taylor_on_box(base_, region.frame, of_base, 0, order);
      const EnclosedPatch tile(in_base.truncated(2));
      OpenBox of_other{};
      bool is_known = true;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto row = static_cast<long>(k);
        DoubleInterval at(region.middle_of_other[k]);
        for (std::size_t c = 0; c < 2; ++c)
          at = at + DoubleInterval(region.by_plane(row, static_cast<long>(c))) * (tile.value[c] + symmetric(room));
        of_other.lower[k] = std::max(at.lower, region.lower_of_other[k]);
        of_other.upper[k] = std::min(at.upper, region.upper_of_other[k]);
        is_known = is_known && of_other.lower[k] < of_other.upper[k];
      }
      if (!is_known) return nothing_known;
      const Series heights =
          height_series<order>(in_parameters(in_base, columns_of(region.across, region.along), region.polynomial),
                               in_parameters(taylor_on_box(other_, region.frame, of_other, 0, order), region.by_plane,
                                             region.polynomial),
                               order, region.polynomial)
              .height;
      for (std::size_t a = 0; a <= order; ++a)
        for (std::size_t b = 0; a + b <= order; ++b) {
          DoubleInterval& entry = result.at(a, b);
          const DoubleInterval& here = heights.at(a, b);
          if (!here.is_finite())
            entry = symmetric(INFINITY);
          else if (i + j == 0)
            entry = here;
          else
            entry = {std::min(entry.lower, here.lower), std::max(entry.upper, here.upper)};
        }
    }
  return result;
}

ContactCurve::Forms ContactCurve::close_forms_on(const Region& region, std::size_t tiles) const {
  Forms forms;
  const auto tables = tables_near(region.origin, 4);
  if (!tables) return forms;
  const PlaneSeries<double> near = tables->heights(region.across, region.along, 4);
  const PlaneSeries<DoubleInterval, 5> heights = heights_by_tiles(region, tiles);
  // The derivative of this order by x^i y^j, at the origin and all over the parallelogram.
  const auto here = [&](std::size_t i, std::size_t j) {
    const double product = factorial(i) * factorial(j);
    return DoubleInterval::around(product * near.at(i, j), product * rounding_of_derivative(i + j));
  };
  const auto fifth = [&](std::size_t i, std::size_t j) {
    return DoubleInterval(factorial(i) * factorial(j)) * heights.at(i, j);
  };
  const DoubleInterval x = symmetric(region.reach);
  const DoubleInterval y = symmetric(region.length);
  const auto half_square = [](double half) { return DoubleInterval(0, 0.5 * half * half * (1 + 1e-12)); };
  const DoubleInterval xx = half_square(region.reach);
  const DoubleInterval yy = half_square(region.length);
  const auto fourth = [&](std::size_t i, std::size_t j) {
    return here(i, j) + x * fifth(i + 1, j) + y * fifth(i, j + 1);
  };
  const auto third = [&](std::size_t i, std::size_t j) {
    return here(i, j) + x * here(i + 1, j) + y * here(i, j + 1) + xx * fifth(i + 2, j) + x * y * fifth(i + 1, j + 1) +
           yy * fifth(i, j + 2);
  };
  forms.xxxx = fourth(4, 0);
  forms.xxxy = fourth(3, 1);
  forms.xxyy = fourth(2, 2);
  forms.xxx = third(3, 0);
  forms.xxy = third(2, 1);
  forms.xx = here(2, 0) + x * here(3, 0) + y * here(2, 1) + xx * forms.xxxx + x * y * forms.xxxy + yy * forms.xxyy;
  return forms;
}

bool ContactCurve::is_near(const CellBox& asked) const {
  const CellBox box = in_base_order(asked);
  const Place middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
  const double size = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  const Place start = nearest(middle);
  return std::hypot(start[0] - middle[0], start[1] - middle[1]) < 2 * size;
}

std::optional<CurveCrossing> ContactCurve::crossing(const CellBox& asked) const {
  if (!is_near(asked)) return std::nullopt;
  const CellBox box = in_base_order(asked);
  const double size = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  const Place start = nearest({0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])});
  const auto found = crossing_near(start, 4 * size);
  if (!found) return std::nullopt;
  const Place origin = *found;
  const Place steepest = unit(gradient(origin));
  const Place along{-steepest[1], steepest[0]};
  // Across the curve and the branch alike.
  const auto heights_here = heights_near(origin, 3);
  if (!heights_here) return std::nullopt;
  Place across = steepest;
  double largest = 0;
  for (const double turn : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const Place direction{std::cos(turn) * steepest[0] + std::sin(turn) * along[0],
                          std::cos(turn) * steepest[1] + std::sin(turn) * along[1]};
    const double third = std::fabs(derivative_in(*heights_here, direction, 3));
    if (third > largest * 1.25) {
      largest = third;
      across = direction;
    }
  }
  const auto around = region(box, origin, across, along, 5);
  if (!around) return std::nullopt;
  Forms forms;
  DoubleInterval turning;
  // Both are known up to that part of their size.
  const auto are_within = [&](double part) {
    for (const DoubleInterval& x : {forms.xxx, turning})
      if (!x.is_finite() || !(x.upper - x.lower < part * std::fabs(x.lower + x.upper))) return false;
    return true;
  };
  // The fifth derivatives are overestimated by a high power of the size of tiles: more of them help where little is
  // missing.
  for (const auto& [tiles, hopeless] : {std::pair(1, 20.0), std::pair(4, 3.0), std::pair(8, 0.0)}) {
    forms = close_forms_on(*around, static_cast<std::size_t>(tiles));
    turning = forms.xxy + forms.xxx * around->slope;
    if (are_within(1)) break;
    if (!are_within(hopeless)) return std::nullopt;
  }
  if (!forms.xxx.excludes_zero() || !turning.excludes_zero()) return std::nullopt;

  // Newton's step from the origin.
  const double bend = bend_at_origin(*around).magnitude();
  const double least = std::min(std::fabs(turning.lower), std::fabs(turning.upper));
  const double shift = bend / least + 1e-14;
  if (!(shift < 0.5 * around->length)) return std::nullopt;
  CurveCrossing result;
  result.parameters = parameters_at(origin);
  const double moved = shift * (1 + around->slope.magnitude());
  result.radius = moved * (1 + around->following);
  bool outside = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const double at = result.parameters[k];
    result.inside = result.inside && at - result.radius > asked.lower[k] && at + result.radius < asked.upper[k];
    outside = outside || at + result.radius < asked.lower[k] || at - result.radius > asked.upper[k];
  }
  if (!result.inside && !outside) return std::nullopt;
  const double area = cross(across, along);
  const std::size_t first = swapped_ ? 2 : 0;
  result.growing[first] = -across[1] / area;
  result.growing[first + 1] = across[0] / area;

  result.origin = origin;
  result.across = across;
  result.along = along;
  result.reach = around->reach;
  result.length = around->length;
  result.least_third = std::min(std::fabs(forms.xxx.lower), std::fabs(forms.xxx.upper));
  // The offset of the branch from the curve is where the divided difference vanishes, an average of second derivatives.
  const DoubleInterval offset_slope = -(DoubleInterval(3) * turning) / forms.xxx;
  const DoubleInterval moving_third = forms.xxxy + around->slope * forms.xxxx;
  const DoubleInterval turning_twice = forms.xxyy + DoubleInterval(2) * around->slope * forms.xxxy +
                                       around->slope * around->slope * forms.xxxx + around->bend * forms.xxx;
  const DoubleInterval offset_bend =
      -(DoubleInterval(3) * turning_twice + DoubleInterval(2) * moving_third * offset_slope +
        DoubleInterval(0.5) * forms.xxxx * offset_slope * offset_slope) /
      forms.xxx;
  result.branch_slope = (around->slope + offset_slope).magnitude();
  result.branch_bend = (around->bend + offset_bend).magnitude();
  const double half = result.length + result.reach;
  const auto bounds =
      PatchJets(base_).bounds_on(origin[0] - half, origin[0] + half, origin[1] - half, origin[1] + half);
  if (!bounds) return std::nullopt;
  double extent = 0;
  for (const Array4d& point : base_.points) extent = std::max(extent, point.abs().head<3>().maxCoeff());
  for (std::size_t k = 0; k < 3; ++k) {
    const auto c = static_cast<long>(k);
    result.speed[k] = bounds->first[0][c] + bounds->first[1][c];
    result.bending[k] = bounds->second[0][c] + 2 * bounds->second[1][c] + bounds->second[2][c];
  }
  // In a smaller box more is known of the branch.
  constexpr double accuracy = 1e-6;
  constexpr double pieces = 512;
  const double step = result.length / pieces;
  if (!(unit_chord_error(result, origin) * step * step < accuracy * extent)) return std::nullopt;
  return result;
}

Place CurveCrossing::coordinates_of(const Place& at) const {
  const Place offset{at[0] - origin[0], at[1] - origin[1]};
  const double area = cross(across, along);
  return {cross(offset, along) / area, cross(across, offset) / area};
}

double ContactCurve::across_at(const CurveCrossing& crossing, double y) const {
  double x = 0;
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    const Place at{crossing.origin[0] + x * crossing.across[0] + y * crossing.along[0],
                   crossing.origin[1] + x * crossing.across[1] + y * crossing.along[1]};
    const double change = curve_.near(at[0], at[1]) / dot(gradient(at), crossing.across);
    x -= change;
    if (!(std::fabs(change) > 1e-16)) break;
  }
  return x;
}

double ContactCurve::chord_error(const CurveCrossing& crossing, const Place& from, const Place& to, double error) {
  const double a = crossing.coordinates_of(from)[1];
  const double b = crossing.coordinates_of(to)[1];
  if (!(std::max(std::fabs(a), std::fabs(b)) < crossing.length)) return std::numeric_limits<double>::infinity();
  const double fastest = *std::max_element(crossing.speed.begin(), crossing.speed.end());
  return unit_chord_error(crossing, from) * (a - b) * (a - b) + 1.74 * fastest * error;
}

double ContactCurve::unit_chord_error(const CurveCrossing& crossing, const Place& near) {
  if (!(std::fabs(crossing.coordinates_of(near)[1]) < crossing.length)) return std::numeric_limits<double>::infinity();
  const double length = 1 + crossing.branch_slope;
  double result = 0;
  for (std::size_t k = 0; k < 3; ++k)
    result = std::max(result, crossing.speed[k] * crossing.branch_bend + crossing.bending[k] * length * length);
  return 1.74 * 0.125 * result;
}

}  // namespace eliminant::bridge
