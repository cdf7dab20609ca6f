// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/pictures/picture_scale.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace eliminant::io {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Around a middle; never empty.
PictureRange around(double lower, double upper, double margin) {
  const double least = 1e-9 * std::max({1.0, std::fabs(lower), std::fabs(upper)});
  const double half = std::max((upper - lower) / 2, least) * (1 + margin);
  const double middle = lower + (upper - lower) / 2;
  return {middle - half, middle + half};
}

PictureRange all_of(const std::vector<double>& values) {
  if (values.empty()) return {-1, 1};
  const auto [lower, upper] = std::minmax_element(values.begin(), values.end());
  return around(*lower, *upper, 0.06);
}

// The range of numbers without those that are far away from the middle half of them.
PictureRange most_of(std::vector<double> values) {
  if (values.empty()) return {-1, 1};
  std::sort(values.begin(), values.end());
  const double low = values[values.size() / 4];
  const double high = values[(3 * values.size() - 1) / 4];
  constexpr double far = 2;
  const double spread = high - low;
  return around(std::max(values.front(), low - far * spread), std::min(values.back(), high + far * spread), 0.06);
}

std::vector<double> coordinates(const PicturePanel& panel, std::size_t axis) {
  std::vector<double> values;
  const auto add = [&](double value) {
    if (std::isfinite(value)) values.push_back(value);
  };
  for (const PictureCurve& curve : panel.curves)
    for (const auto& point : curve.points) add(point[axis]);
  // A panel of marks alone shows all of them.
  for (const PictureMark& mark : panel.marks) add(mark.at[axis]);
  return values;
}

}  // namespace

std::array<PictureRange, 2> view_of(const PicturePanel& panel) {
  std::array<PictureRange, 2> view;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (panel.projective)
      view[axis] = around(-1, 1, 0.08);
    else if (panel.border)
      view[axis] = around((*panel.border)[axis][0], (*panel.border)[axis][1], 0.08);
    else
      view[axis] = panel.unbounded ? most_of(coordinates(panel, axis)) : all_of(coordinates(panel, axis));
  }
  const auto length = [&](std::size_t axis) { return view[axis].upper - view[axis].lower; };
  const double longer = std::max(length(0), length(1));
  // Very flat panels would show nothing with equal scales, unless they are a view of space.
  if (panel.equal_scales && (panel.space || std::min(length(0), length(1)) > longer / 8))
    for (PictureRange& range : view) {
      const double middle = range.lower + (range.upper - range.lower) / 2;
      range = {middle - longer / 2, middle + longer / 2};
    }
  return view;
}

double drawn(const PicturePanel& panel, double coordinate) {
  return panel.projective ? 2 / std::numbers::pi * std::atan(coordinate) : coordinate;
}

std::vector<std::array<double, 2>> drawn(const PicturePanel& panel, const PictureCurve& curve) {
  if (!panel.projective) return curve.points;
  std::vector<std::array<double, 2>> points;
  for (const auto& [x, y] : curve.points) {
    const std::array<double, 2> point{drawn(panel, x), drawn(panel, y)};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      // More than half of the line is farther than the other way round.
      if (points.empty() || !(std::fabs(points.back()[axis] - point[axis]) > 1)) continue;
      std::array<double, 2> leaving = points.back();
      leaving[axis] = std::copysign(1, leaving[axis]);
      std::array<double, 2> entering = leaving;
      entering[axis] = -leaving[axis];
      points.insert(points.end(), {leaving, {nothing, nothing}, entering});
    }
    points.push_back(point);
  }
  return points;
}

std::vector<PictureTick> ticks_in(const PicturePanel& panel, const PictureRange& range) {
  std::vector<PictureTick> ticks;
  if (panel.projective) {
    for (const double value : {-infinity, -3.0, -1.0, -0.4, 0.0, 0.4, 1.0, 3.0, infinity})
      ticks.push_back({drawn(panel, value), std::isinf(value) ? "\u221e" : fmt::format("{:g}", value)});
    return ticks;
  }
  const double raw = (range.upper - range.lower) / 6;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= raw) step = factor * power;
  for (double i = std::ceil(range.lower / step); i * step <= range.upper && ticks.size() < 12; ++i)
    ticks.push_back({i * step, fmt::format("{:.6g}", i == 0 ? 0.0 : i * step)});
  return ticks;
}

}  // namespace eliminant::io
