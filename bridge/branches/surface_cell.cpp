// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/surface_cell.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::bridge {

namespace {

Array4d cross(const Array4d& a, const Array4d& b) {
  return Array4d(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0);
}

double norm(const Array4d& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

Array4d normal_of(const Side<2>& side) {
  const Array4d normal = cross(secant(side, 0), secant(side, 1));
  const double length = norm(normal);
  return length > 0 ? Array4d(normal / length) : Array4d(Array4d::Zero());
}

/// A box as its middle and half widths.
struct Middle {
  Array4d middle;
  Array4d radius;
};

Middle middle_of(const Bounds& bounds) {
  Middle result{0.5 * (bounds.lower + bounds.upper), 0.5 * (bounds.upper - bounds.lower)};
  result.radius += 4 * unit_roundoff * bounds.magnitude() + 0x1p-1000;
  return result;
}

/// The derivatives along an axis, weights divided out up to a positive factor, in the lanes of the points. `error`
/// bounds that of every lane of a point, `weight_error` that of its weight.
Middle derivative_bounds(const Side<2>& side, const std::vector<Array4d>& points, std::size_t axis,
                         const Array4d& error, double weight_error) {
  const double degree = static_cast<double>(side.shape.degree[axis]);
  const std::size_t stride = side.shape.stride(axis);
  Bounds differences;
  double least = infinity;
  double largest = -infinity;
  side.shape.for_each_line(axis, [&](std::size_t base) {
    for (std::size_t i = 0; i < side.shape.degree[axis]; ++i) {
      const std::size_t at = base + i * stride;
      differences.take(points[at + stride] - points[at]);
      if (!side.polynomial) {
        const double change = side.points[at + stride][3] - side.points[at][3];
        least = std::min(least, change);
        largest = std::max(largest, change);
      }
    }
  });
  Middle slope = middle_of(differences);
  slope.middle *= degree;
  slope.radius = degree * (slope.radius + 2 * error);
  if (side.polynomial) return slope;
  // Q' w - Q w' with Q the points, moved to near the origin, all over the middle weight.
  const double inverse = 1 / side.weight;
  const double weight_slope =
      degree * std::max(std::fabs(least), std::fabs(largest)) * inverse + 2 * degree * weight_error;
  Bounds values;
  for (const Array4d& point : points) values.take(point);
  const Array4d size = values.magnitude() + error;
  slope.radius += (slope.middle.abs() + slope.radius) * side.weight_spread + size * weight_slope;
  slope.radius *= 1 + 1e-12;
  return slope;
}

}  // namespace

bool SurfaceCell::frame_of_normals(Frame& frame) const {
  const Array4d a = normal_of(first);
  Array4d b = normal_of(second);
  if (norm(a) == 0 || norm(b) == 0) return false;
  if ((a * b).sum() < 0) b = -b;
  Array4d direction = cross(a, b);
  const double sine = norm(direction);
  // Directions of nearly parallel normals are noise.
  constexpr double least_sine = 1e-7;
  frame.has_direction = sine > least_sine;
  if (!frame.has_direction) {
    const Array4d tangent = secant(first, 0);
    direction = tangent - (tangent * a).sum() * a;
    if (norm(direction) == 0) return false;
  }
  direction /= norm(direction);
  Array4d height = a + b;
  height /= norm(height);
  const Array4d across = cross(height, direction);
  for (long k = 0; k < 3; ++k)
    frame.lanes[static_cast<std::size_t>(k)] = Array4d(direction[k], across[k], height[k], a[k]);
  frame.second_normal = b;
  return true;
}

bool SurfaceCell::separated(const Frame& frame) {
  // Points are moved to near the origin, and divided by a weight near theirs.
  Array4d shift = Array4d::Zero();
  if (!first.polynomial || !second.polynomial) {
    shift = 0.5 * (first.box.lower.max(second.box.lower) + first.box.upper.min(second.box.upper));
    shift[3] = 0;
  }
  struct Extent {
    Bounds lanes;
    double least = infinity;
    double largest = -infinity;
  };
  const auto look = [&](const Side<2>& side, std::vector<Array4d>& points) {
    points.resize(side.shape.size());
    Extent extent;
    const double inverse = 1 / side.weight;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Array4d moved = side.polynomial ? Array4d(side.points[i] - shift)
                                            : Array4d((side.points[i] - shift * side.points[i][3]) * inverse);
      points[i] = times(frame.lanes, moved);
      const Array4d affine = side.polynomial ? moved : Array4d(moved * (side.weight / side.points[i][3]));
      const double along =
          affine[0] * frame.second_normal[0] + affine[1] * frame.second_normal[1] + affine[2] * frame.second_normal[2];
      extent.least = std::min(extent.least, along);
      extent.largest = std::max(extent.largest, along);
      extent.lanes.take(side.polynomial ? points[i] : Array4d(points[i] * (side.weight / side.points[i][3])));
    }
    // Lanes are combinations with coefficients of at most 1 of three coordinates.
    const Array4d size = moved_size(side, shift) / (1 - side.weight_spread);
    const Array4d wrong = moved_error(side, shift) / (1 - side.weight_spread);
    const double slack =
        (wrong[0] + wrong[1] + wrong[2]) * 1.001 + 32 * unit_roundoff * (size[0] + size[1] + size[2]) + 0x1p-1000;
    extent.lanes.lower -= slack;
    extent.lanes.upper += slack;
    extent.least -= slack;
    extent.largest += slack;
    return extent;
  };
  const Extent a = look(first, first_points_);
  const Extent b = look(second, second_points_);
  if (a.largest < b.least || b.largest < a.least) return true;
  return (a.lanes.upper < b.lanes.lower).any() || (b.lanes.upper < a.lanes.lower).any();
}

bool SurfaceCell::slope_bounds(const Side<2>& side, const std::vector<Array4d>& points, const Frame& /*frame*/,
                               DoubleInterval& slope) const {
  Array4d shift = Array4d::Zero();
  if (!first.polynomial || !second.polynomial) {
    shift = 0.5 * (first.box.lower.max(second.box.lower) + first.box.upper.min(second.box.upper));
    shift[3] = 0;
  }
  const Array4d size = moved_size(side, shift);
  const Array4d wrong = moved_error(side, shift);
  const Array4d error =
      Array4d::Constant((wrong[0] + wrong[1] + wrong[2]) + 16 * unit_roundoff * (size[0] + size[1] + size[2]));
  const double weight_error = side.polynomial ? 0 : 2 * side.error[3] / side.weight;
  const Middle by_u = derivative_bounds(side, points, 0, error, weight_error);
  const Middle by_v = derivative_bounds(side, points, 1, error, weight_error);
  // Tangent vectors near (1, 0, .) and (0, 1, .) in the lanes T and m.
  const double determinant = by_u.middle[0] * by_v.middle[1] - by_u.middle[1] * by_v.middle[0];
  if (!(std::fabs(determinant) > 0)) return false;
  const auto combination = [&](double p, double q) {
    Middle result{p * by_u.middle + q * by_v.middle, std::fabs(p) * by_u.radius + std::fabs(q) * by_v.radius};
    result.radius = result.radius * (1 + 1e-12) +
                    4 * unit_roundoff * (std::fabs(p) * by_u.middle.abs() + std::fabs(q) * by_v.middle.abs());
    return result;
  };
  const Middle c = combination(by_v.middle[1] / determinant, -by_u.middle[1] / determinant);
  const Middle d = combination(-by_v.middle[0] / determinant, by_u.middle[0] / determinant);
  const auto lane = [](const Middle& x, long k) { return DoubleInterval::around(x.middle[k], x.radius[k]); };
  const DoubleInterval up = lane(c, 0) * lane(d, 1) - lane(c, 1) * lane(d, 0);
  if (!(up.lower > 0)) return false;
  slope = (lane(c, 2) * lane(d, 0) - lane(c, 0) * lane(d, 2)) / up;
  return slope.is_finite();
}

CellVerdict SurfaceCell::examine() {
  CellVerdict verdict;
  Frame frame;
  if (!frame_of_normals(frame)) return verdict;
  verdict.excluded = separated(frame);
  if (verdict.excluded) return verdict;
  verdict.nearly_parallel = !frame.has_direction;
  if (!frame.has_direction) return verdict;
  DoubleInterval a;
  DoubleInterval b;
  verdict.regular = slope_bounds(first, first_points_, frame, a) && slope_bounds(second, second_points_, frame, b) &&
                    (a.upper < b.lower || b.upper < a.lower);
  return verdict;
}

std::array<double, 4> SurfaceCell::spreads() const {
  std::array<double, 4> result{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Side<2>& side = k < 2 ? first : second;
    const std::size_t axis = k % 2;
    const std::size_t stride = side.shape.stride(axis);
    Array4d largest = Array4d::Zero();
    side.shape.for_each_line(axis, [&](std::size_t base) {
      Array4d length = Array4d::Zero();
      for (std::size_t i = 0; i < side.shape.degree[axis]; ++i)
        length += (side.points[base + (i + 1) * stride] - side.points[base + i * stride]).abs();
      largest = largest.max(length);
    });
    result[k] = largest.head<3>().maxCoeff() / side.weight;
  }
  return result;
}

}  // namespace eliminant::bridge
