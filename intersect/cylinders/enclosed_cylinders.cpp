// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/cylinders/enclosed_cylinders.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/certificates/cylinder_direction_certificate.hpp>
#include <eliminant/intersect/cylinders/cylinder_axis.hpp>
#include <eliminant/intersect/cylinders/cylinders.hpp>

namespace eliminant::intersect {

namespace {

using bridge::DoubleInterval;
using Points = std::array<std::array<double, 3>, 5>;

double middle(const DoubleInterval& x) { return x.lower + (x.upper - x.lower) / 2; }

/// Bounds the distance of every number of the interval from its middle.
double error_of(const DoubleInterval& x) { return (x.upper - x.lower) * (0.5 + 0x1p-50) + 0x1p-51 * x.magnitude(); }

/// Wider enclosures of the direction, or relative to it of the radius, are left to exact arithmetic.
constexpr double widest_enclosure = 1e-6;

/// nullopt where an enclosure is wide, or not finite.
std::optional<EnclosedCylinder> enclose(const bridge::ScaledOffsets& offsets, const std::array<double, 3>& first,
                                        const bridge::CertifiedDirection& direction) {
  const bridge::EnclosedAxis axis = bridge::enclose_axis(offsets, direction);
  if (!(axis.radius_squared.lower > 0) || !axis.radius_squared.is_finite()) return std::nullopt;
  EnclosedCylinder result;
  numeric::SpaceVector<double> t{};
  for (std::size_t i = 0; i < 3; ++i) t[i] = direction.center[i].real();
  const double length = std::sqrt(numeric::dot_product(t, t));
  for (std::size_t i = 0; i < 3; ++i) result.cylinder.direction[i] = t[i] / length;
  // Unit vectors of t and t' are at most 2 |t - t'| / |t| apart, and |t| >= 1; 2 sqrt(2) < 3.
  result.direction_error = 3 * direction.radius + 0x1p-48;
  const double scale = std::ldexp(1.0, offsets.scale_log2);
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleInterval coordinate = DoubleInterval(first[i]) + DoubleInterval(scale) * axis.offset[i];
    if (!coordinate.is_finite()) return std::nullopt;
    result.cylinder.axis_point[i] = middle(coordinate);
    result.axis_point_error = std::max(result.axis_point_error, error_of(coordinate));
  }
  const DoubleInterval root =
      DoubleInterval::widened(std::sqrt(axis.radius_squared.lower), std::sqrt(axis.radius_squared.upper));
  const DoubleInterval radius = DoubleInterval(scale) * root;
  result.cylinder.radius = middle(radius);
  result.radius_error = error_of(radius);
  if (!(result.radius_error <= widest_enclosure * result.cylinder.radius) || result.direction_error > widest_enclosure)
    return std::nullopt;
  return result;
}

std::optional<EnclosedCylinders> in_doubles(const Points& points) {
  const bridge::ScaledOffsets offsets = bridge::scaled_offsets(points);
  const std::optional<bridge::CertifiedDirections> directions = bridge::certify_cylinder_directions(offsets);
  if (!directions) return std::nullopt;
  EnclosedCylinders result;
  result.status = Status::certified;
  for (const bridge::CertifiedDirection& direction : *directions) {
    if (!direction.real) continue;
    const std::optional<EnclosedCylinder> cylinder = enclose(offsets, points[0], direction);
    if (!cylinder) return std::nullopt;
    result.cylinders.push_back(*cylinder);
  }
  return result;
}

symbolic::Rational exact_value(double value) {
  symbolic::Rational result;
  arf_t exact;
  arf_init(exact);
  arf_set_d(exact, value);
  arf_get_fmpq(result.get(), exact);
  arf_clear(exact);
  return result;
}

/// The nearest double, nearly, and in `error` what the number may be away from it, if that is more.
double rounded(const bridge::ComplexBall& ball, double& error) {
  const double value = arf_get_d(arb_midref(ball.real()), ARF_RND_NEAR);
  bridge::Magnitude bound;
  mag_set_d(bound.get(), std::ldexp(std::fabs(value), -52) + 0x1p-1000);
  mag_add(bound.get(), bound.get(), arb_radref(ball.real()));
  error = std::max(error, mag_get_d(bound.get()) * (1 + 0x1p-50));
  return value;
}

EnclosedCylinder enclose(const CylinderSolution& solution, const symbolic::SpacePoint& first) {
  constexpr long precision_bits = 160;
  EnclosedCylinder result;
  result.multiplicity = solution.multiplicity;
  BallVector t;
  BallVector to_first;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = solution.direction[i].ball;
    acb_set_fmpq(to_first[i].get(), first[i].get(), precision_bits);
    acb_sub(to_first[i].get(), to_first[i].get(), solution.axis_point[i].ball.get(), precision_bits);
  }
  const bridge::ComplexBall along = dot_product(to_first, t, precision_bits);
  for (std::size_t i = 0; i < 3; ++i) {
    bridge::ComplexBall foot = solution.axis_point[i].ball;
    acb_addmul(foot.get(), along.get(), t[i].get(), precision_bits);
    result.cylinder.direction[i] = rounded(t[i], result.direction_error);
    result.cylinder.axis_point[i] = rounded(foot, result.axis_point_error);
  }
  result.cylinder.radius = rounded(solution.radius->ball, result.radius_error);
  return result;
}

}  // namespace

EnclosedCylinders enclosed_real_cylinders(const Points& points, const Context& context) {
  for (std::size_t k = 0; k < 5; ++k)
    for (const double coordinate : points[k])
      if (!std::isfinite(coordinate))
        throw InvalidInput("a coordinate of point " + std::to_string(k + 1) + " is not finite", "a finite number");
  if (std::optional<EnclosedCylinders> result = in_doubles(points)) return *std::move(result);
  CylindersProblem problem;
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < 3; ++i) problem.points[k][i] = exact_value(points[k][i]);
  Options options;
  options.digits = 20;
  options.field = Field::real;
  const CylindersResult exact = cylinders_through(problem, options, context);
  EnclosedCylinders result;
  result.exact = true;
  result.status = exact.status;
  if (exact.status != Status::certified) return result;
  for (const CylinderSolution& solution : exact.solutions)
    result.cylinders.push_back(enclose(solution, problem.points[0]));
  return result;
}

}  // namespace eliminant::intersect
