// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/picture_scale.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace eliminant::io {

namespace {

// Around a middle; never empty.
PictureRange around(double lower, double upper, double margin) {
  const double least = 1e-9 * std::max({1.0, std::fabs(lower), std::fabs(upper)});
  const double half = std::max((upper - lower) / 2, least) * (1 + margin);
  const double middle = lower + (upper - lower) / 2;
  return {middle - half, middle + half};
}

// The range of numbers without the few that are far away from the others.
PictureRange most_of(std::vector<double> values) {
  if (values.empty()) return {-1, 1};
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  const double low = quantile(0.1);
  const double high = quantile(0.9);
  constexpr double far = 3;
  const double spread = high - low;
  // Points that agree have no scale of their own.
  if (spread <= 0) return around(values.front(), values.back(), 0.1);
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
  for (std::size_t axis = 0; axis < 2; ++axis)
    view[axis] = panel.border ? around((*panel.border)[axis][0], (*panel.border)[axis][1], 0.08)
                              : most_of(coordinates(panel, axis));
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

std::vector<double> ticks_in(const PictureRange& range) {
  const double raw = (range.upper - range.lower) / 6;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= raw) step = factor * power;
  std::vector<double> ticks;
  for (double i = std::ceil(range.lower / step); i * step <= range.upper && ticks.size() < 12; ++i)
    ticks.push_back(i * step);
  return ticks;
}

std::string tick_text(double tick) { return fmt::format("{:.6g}", tick == 0 ? 0.0 : tick); }

}  // namespace eliminant::io
