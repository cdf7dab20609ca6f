// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/control_net.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

namespace {

constexpr double unit = 0x1p-53;

/// Beyond these a product of a few coordinates may overflow or lose digits to underflow.
bool is_safe(const Eigen::Array4d& point) {
  constexpr double safe = 1e60;
  return std::all_of(point.data(), point.data() + 4, [](double value) {
    return std::fabs(value) < safe && (value == 0 || std::fabs(value) > 1 / safe);
  });
}

/// The high half of the digits of each number, so that products of halves are exact (Veltkamp).
Eigen::Array4d high_half(const Eigen::Array4d& x) {
  const Eigen::Array4d spread = (0x1p27 + 1) * x;
  return spread - (spread - x);
}

/// What rounding took off the product with a number, exactly (Dekker).
Eigen::Array4d lost_by_product(const Eigen::Array4d& x, double y, const Eigen::Array4d& product) {
  const Eigen::Array4d x_high = high_half(x);
  const Eigen::Array4d x_low = x - x_high;
  const double y_high = high_half(Eigen::Array4d::Constant(y))[0];
  const double y_low = y - y_high;
  return ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low;
}

}  // namespace

std::optional<ControlNet> ControlNet::round(std::vector<std::size_t> degrees, const std::vector<ExactPoint>& points,
                                            const std::array<symbolic::Rational, 3>& origin) {
  ControlNet net;
  net.degrees = std::move(degrees);
  const symbolic::Rational& weight = points.front()[3];
  net.polynomial = !weight.is_zero() &&
                   std::all_of(points.begin(), points.end(), [&](const ExactPoint& p) { return p[3] == weight; });
  net.points.reserve(points.size());
  RealBall ball;
  for (const ExactPoint& point : points) {
    Eigen::Array4d rounded;
    for (std::size_t k = 0; k < 4; ++k) {
      symbolic::Rational value = k < 3 ? point[k] - origin[k] * point[3] : point[3];
      if (net.polynomial) value = value / weight;
      arb_set_fmpq(ball.get(), value.get(), 64);
      rounded[static_cast<long>(k)] = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
      // Below the range of doubles.
      if (rounded[static_cast<long>(k)] == 0 && !value.is_zero()) return std::nullopt;
    }
    if (!is_safe(rounded)) return std::nullopt;
    net.error = net.error.max(2 * unit * rounded.abs());
    net.points.push_back(rounded);
  }
  if (net.polynomial) net.error[3] = 0;
  return net;
}

std::optional<ControlNet> ControlNet::of(std::vector<std::size_t> degrees, const std::vector<HomogeneousPoint>& points,
                                         const std::array<double, 3>& origin) {
  ControlNet net;
  net.degrees = std::move(degrees);
  const Eigen::Array4d shift(origin[0], origin[1], origin[2], 0);
  net.polynomial = std::all_of(points.begin(), points.end(), [](const HomogeneousPoint& p) { return p[3] == 1; });
  net.points.reserve(points.size());
  for (const HomogeneousPoint& point : points) {
    const Eigen::Array4d exact(point[0], point[1], point[2], point[3]);
    const Eigen::Array4d step = shift * exact[3];
    const Eigen::Array4d moved = exact - step;
    if (!is_safe(exact) || !is_safe(moved)) return std::nullopt;
    // Knuth's two-sum: what the subtraction lost, exactly; of coordinates with few digits it is 0.
    const Eigen::Array4d back = exact - moved;
    Eigen::Array4d lost = ((exact - (moved + back)) + (back - step)).abs();
    if (exact[3] != 1) lost += lost_by_product(shift, exact[3], step).abs();
    net.error = net.error.max(lost);
    net.points.push_back(moved);
  }
  return net;
}

}  // namespace eliminant::bridge
