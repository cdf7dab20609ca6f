// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/patch_jets.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::bridge {

namespace {

/// Value, first and second derivative of a Bezier curve, whose points are overwritten.
std::array<Array4d, 3> jet_of_line(Array4d* b, std::size_t degree, double t) {
  const double n = static_cast<double>(degree);
  for (std::size_t level = degree; level > 2; --level)
    for (std::size_t i = 0; i < level; ++i) b[i] += t * (b[i + 1] - b[i]);
  if (degree == 1) return {Array4d(b[0] + t * (b[1] - b[0])), Array4d(b[1] - b[0]), Array4d(Array4d::Zero())};
  const Array4d first = b[1] - b[0];
  const Array4d second = b[2] - b[1];
  const Array4d bend = second - first;
  const Array4d slope = first + t * bend;
  return {Array4d(b[0] + t * first + t * slope), Array4d(n * slope), Array4d(n * (n - 1) * bend)};
}

/// The derivatives of the quotient by Leibniz' rule, all terms in absolute values.
void divide_bounds_by_weight(DerivativeBounds& bounds, const Array4d& size, double least) {
  const Array4d value = size / least;
  const std::array<double, 2> w{bounds.first[0][3], bounds.first[1][3]};
  const std::array<double, 3> ww{bounds.second[0][3], bounds.second[1][3], bounds.second[2][3]};
  for (std::size_t k = 0; k < 2; ++k) bounds.first[k] = (bounds.first[k] + value * w[k]) / least;
  const auto& d = bounds.first;
  bounds.second[0] = (bounds.second[0] + 2 * d[0] * w[0] + value * ww[0]) / least;
  bounds.second[1] = (bounds.second[1] + d[0] * w[1] + d[1] * w[0] + value * ww[1]) / least;
  bounds.second[2] = (bounds.second[2] + 2 * d[1] * w[1] + value * ww[2]) / least;
  const auto& dd = bounds.second;
  auto& ddd = bounds.third;
  ddd[0] = (ddd[0] + 3 * dd[0] * w[0] + 3 * d[0] * ww[0] + value * ddd[0][3]) / least;
  ddd[1] = (ddd[1] + dd[0] * w[1] + 2 * dd[1] * w[0] + d[1] * ww[0] + 2 * d[0] * ww[1] + value * ddd[1][3]) / least;
  ddd[2] = (ddd[2] + dd[2] * w[0] + 2 * dd[1] * w[1] + d[0] * ww[2] + 2 * d[1] * ww[1] + value * ddd[2][3]) / least;
  ddd[3] = (ddd[3] + 3 * dd[2] * w[1] + 3 * d[1] * ww[2] + value * ddd[3][3]) / least;
}

}  // namespace

PatchJets::PatchJets(const ControlNet& net) : net_(net), scratch_(net.points.size()) {
  std::copy(net.degrees.begin(), net.degrees.end(), shape_.degree.begin());
  Array4d size = Array4d::Zero();
  for (const Array4d& point : net.points) size = size.max(point.abs());
  const double degrees = static_cast<double>(shape_.degree[0] + shape_.degree[1]);
  // Within a fiftieth of the domain.
  error_ = std::exp(0.04 * degrees) * (net.error + 4 * degrees * unit_roundoff * size);
}

template <std::size_t Order>
PatchJets::Value PatchJets::jet(double a, double b) {
  std::copy(net_.points.begin(), net_.points.end(), scratch_.begin());
  const std::size_t row = shape_.degree[1] + 1;
  const std::size_t column = shape_.degree[0] + 1;
  rows_.resize(3 * column);
  for (std::size_t i = 0; i < column; ++i) {
    const std::array<Array4d, 3> jet = jet_of_line(scratch_.data() + i * row, shape_.degree[1], b);
    for (std::size_t k = 0; k <= Order; ++k) rows_[k * column + i] = jet[k];
  }
  const auto line = [&](std::size_t k) { return jet_of_line(rows_.data() + k * column, shape_.degree[0], a); };
  const std::array<Array4d, 3> plain = line(0);
  const std::array<Array4d, 3> slope = line(1);
  Value value;
  value.point = plain[0];
  value.first = {plain[1], slope[0]};
  if constexpr (Order == 2)
    value.second = {plain[2], slope[1], line(2)[0]};
  else
    value.second.fill(Array4d::Zero());
  Array4d error = error_;
  if (!net_.polynomial) error = divide_by_weight(value);
  if constexpr (Order < 2) value.second.fill(Array4d::Zero());
  value.error = error.head<3>().maxCoeff();
  return value;
}

PatchJets::Value PatchJets::at(double a, double b) { return jet<2>(a, b); }

PatchJets::Value PatchJets::slopes_at(double a, double b) { return jet<1>(a, b); }

std::optional<DerivativeBounds> PatchJets::bounds_on(double a0, double a1, double b0, double b1) const {
  std::vector<Array4d> points = net_.points;
  restrict_to(shape_, 0, a0, a1, points.data());
  restrict_to(shape_, 1, b0, b1, points.data());
  double least = infinity;
  for (const Array4d& point : points) least = std::min(least, point[3]);
  // A thousandth is more than all roundings.
  least *= 0.999;
  if (!net_.polynomial && !(least > 0)) return std::nullopt;
  Array4d shift = Array4d::Zero();
  if (!net_.polynomial) shift = points[points.size() / 2] / points[points.size() / 2][3];
  shift[3] = 0;
  for (Array4d& point : points) point -= net_.polynomial ? shift : Array4d(shift * point[3]);
  const std::array<std::array<Array4d, 4>, 4> largest = largest_derivatives(std::move(points), a1 - a0, b1 - b0);
  DerivativeBounds bounds;
  for (std::size_t k = 0; k < 2; ++k) bounds.first[k] = largest[1 - k][k];
  for (std::size_t k = 0; k < 3; ++k) bounds.second[k] = largest[2 - k][k];
  for (std::size_t k = 0; k < 4; ++k) bounds.third[k] = largest[3 - k][k];
  if (!net_.polynomial) divide_bounds_by_weight(bounds, largest[0][0], least);
  return bounds;
}

Array4d PatchJets::divide_by_weight(Value& value) const {
  const double inverse = 1 / value.point[3];
  value.point *= inverse;
  const std::array<double, 2> w{value.first[0][3], value.first[1][3]};
  for (std::size_t k = 0; k < 2; ++k) value.first[k] = (value.first[k] - value.point * w[k]) * inverse;
  const auto& d = value.first;
  const std::array<double, 3> ww{value.second[0][3], value.second[1][3], value.second[2][3]};
  value.second[0] = (value.second[0] - 2 * d[0] * w[0] - value.point * ww[0]) * inverse;
  value.second[1] = (value.second[1] - d[0] * w[1] - d[1] * w[0] - value.point * ww[1]) * inverse;
  value.second[2] = (value.second[2] - 2 * d[1] * w[1] - value.point * ww[2]) * inverse;
  return (error_ + value.point.abs() * error_[3]) * std::fabs(inverse) * 1.001 + 4 * unit_roundoff * value.point.abs();
}

/// Of all orders (p, q) with p + q at most 3, from the differences of control points.
std::array<std::array<Array4d, 4>, 4> PatchJets::largest_derivatives(std::vector<Array4d> points, double width_a,
                                                                     double width_b) const {
  const std::size_t m = shape_.degree[0];
  const std::size_t n = shape_.degree[1];
  const std::size_t row = n + 1;
  Array4d size = Array4d::Zero();
  for (const Array4d& point : net_.points) size = size.max(point.abs());
  std::array<std::array<Array4d, 4>, 4> result;
  for (auto& of_order : result) of_order.fill(Array4d::Zero());
  std::vector<Array4d> differences;
  double factor_a = 1;
  constexpr std::size_t order = 3;
  for (std::size_t p = 0; p <= std::min(order, m); ++p) {
    if (p > 0) {
      factor_a *= static_cast<double>(m + 1 - p) / width_a;
      for (std::size_t i = 0; i + p <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j) points[i * row + j] = points[(i + 1) * row + j] - points[i * row + j];
    }
    differences = points;
    double factor = factor_a;
    for (std::size_t q = 0; q <= std::min(order - p, n); ++q) {
      Array4d largest = Array4d::Zero();
      if (q > 0) factor *= static_cast<double>(n + 1 - q) / width_b;
      for (std::size_t i = 0; i + p <= m; ++i)
        for (std::size_t j = 0; j + q <= n; ++j) {
          Array4d& point = differences[i * row + j];
          if (q > 0) point = differences[i * row + j + 1] - point;
          largest = largest.max(point.abs());
        }
      // What the restriction has rounded, and that of the differences.
      constexpr double slack = 1.001;
      const double parts = static_cast<double>(1U << (p + q));
      const double roundings = 64 * static_cast<double>(m + n) * unit_roundoff * parts;
      result[p][q] = slack * factor * (largest + roundings * size + net_.error * parts);
    }
  }
  return result;
}

std::optional<ContactFrame> tangent_frame(const PatchJets::Value& at) {
  const auto cross = [](const Array4d& a, const Array4d& b) {
    return Array4d(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0], 0);
  };
  const auto square = [](const Array4d& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
  const Array4d& u = at.first[0];
  const Array4d& v = at.first[1];
  const Array4d normal = cross(u, v);
  const double area = square(normal);
  constexpr double least_sine = 1e-10;
  if (!(area > least_sine * least_sine * square(u) * square(v))) return std::nullopt;
  const Array4d dual_u = cross(v, normal) / area;
  const Array4d dual_v = cross(normal, u) / area;
  const double length = std::sqrt(area);
  ContactFrame frame;
  frame.origin = at.point;
  frame.origin[3] = 0;
  for (long k = 0; k < 3; ++k)
    frame.columns[static_cast<std::size_t>(k)] = Array4d(dual_u[k], dual_v[k], normal[k] / length, 0);
  return frame;
}

}  // namespace eliminant::bridge
