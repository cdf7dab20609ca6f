// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/point_exclusion.hpp>

#include <utility>
#include <vector>

#include <eliminant/bridge/nets/bezier_part.hpp>

namespace eliminant::bridge {

namespace {

struct Part {
  std::vector<Array4d> points;
  Array4d error;
  std::array<double, 2> width{1, 1};
};

/// True when one minor of the point and the control points has one sign for all of them.
bool is_apart(const Part& part, const PointBox& point) {
  const auto control = [&](std::size_t p, std::size_t k) {
    const auto lane = static_cast<long>(k);
    return DoubleInterval::around(part.points[p][lane], part.error[lane]);
  };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      bool positive = true;
      bool negative = true;
      for (std::size_t p = 0; p < part.points.size() && (positive || negative); ++p) {
        const DoubleInterval minor = control(p, i) * point[j] - control(p, j) * point[i];
        positive = positive && minor.lower > 0;
        negative = negative && minor.upper < 0;
      }
      if (positive || negative) return true;
    }
  return false;
}

}  // namespace

bool excludes_point(const ControlNet& patch, const PointBox& point, const Context& context) {
  const NetShape<2> shape{{patch.degrees[0], patch.degrees[1]}};
  std::vector<Part> open{{patch.points, patch.error, {1, 1}}};
  constexpr int most_parts = 4000;
  for (int count = 0; !open.empty(); ++count) {
    if (count > most_parts) return false;
    constexpr int checked_every = 64;
    if (count % checked_every == checked_every - 1) context.checkpoint("subdividing");
    Part part = std::move(open.back());
    open.pop_back();
    if (is_apart(part, point)) continue;
    constexpr double smallest_width = 1e-6;
    if (std::max(part.width[0], part.width[1]) < smallest_width) return false;
    const std::size_t axis = part.width[0] >= part.width[1] ? 0 : 1;
    Array4d size = Array4d::Zero();
    for (const Array4d& control : part.points) size = size.max(control.abs());
    part.error += 2 * static_cast<double>(shape.degree[axis]) * unit_roundoff * size;
    part.width[axis] *= 0.5;
    Part right = part;
    halve(shape, axis, part.points.data(), right.points.data());
    open.push_back(std::move(right));
    open.push_back(std::move(part));
  }
  return true;
}

}  // namespace eliminant::bridge
