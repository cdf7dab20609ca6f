// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/cylinders/cylinder_axis.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/bridge/enclosures/decimal.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::Decimal;
using symbolic::Rational;
using symbolic::SpacePoint;
using Points = std::array<SpacePoint, 5>;

BallVector ball_of(const SpacePoint& point, long precision_bits) {
  BallVector ball;
  for (std::size_t i = 0; i < 3; ++i) acb_set_fmpq(ball[i].get(), point[i].get(), precision_bits);
  return ball;
}

ComplexBall product(const ComplexBall& a, const ComplexBall& b, long precision_bits) {
  ComplexBall result;
  acb_mul(result.get(), a.get(), b.get(), precision_bits);
  return result;
}

/// log2 of an upper bound of the modulus, which is within one in a hundred million of the one of the midpoint; of 0
/// minus infinity.
double size_log2(const ComplexBall& z) {
  bridge::Magnitude bound;
  const ComplexBall middle = bridge::midpoint(z);
  acb_get_mag(bound.get(), middle.get());
  return mag_get_d_log2_approx(bound.get());
}

/// The first of the coordinates that are largest, to within one in a million.
std::size_t leading_coordinate(const BallVector& t) {
  const std::array<double, 3> sizes{size_log2(t[0]), size_log2(t[1]), size_log2(t[2])};
  constexpr double one_in_a_million = 1.4427e-6;  // log2(1 + 1e-6)
  const double threshold = *std::max_element(sizes.begin(), sizes.end()) - one_in_a_million;
  return static_cast<std::size_t>(
      std::find_if(sizes.begin(), sizes.end(), [&](double size) { return size >= threshold; }) - sizes.begin());
}

/// t over its leading coordinate, or its length with the sign of that one.
bool normalize(BallVector& t, bool real, long precision_bits) {
  ComplexBall scale = t[leading_coordinate(t)];
  if (acb_contains_zero(scale.get()) != 0) return false;
  if (real) {
    const bool negative = arb_is_negative(scale.real()) != 0;
    scale = dot_product(t, t, precision_bits);
    acb_sqrt(scale.get(), scale.get(), precision_bits);
    if (negative) acb_neg(scale.get(), scale.get());
  }
  for (ComplexBall& coordinate : t) acb_div(coordinate.get(), coordinate.get(), scale.get(), precision_bits);
  return true;
}

/// c of numeric::axis_offset: the foot of the perpendicular from the first point.
std::optional<BallVector> axis_offset(const std::vector<BallVector>& offsets, const BallVector& t,
                                      const ComplexBall& t_squared, long precision_bits) {
  std::vector<BallVector> turned;  // d_k x t
  for (const BallVector& d : offsets) turned.push_back(cross_product(d, t, precision_bits));
  ComplexBall best;
  std::pair<std::size_t, std::size_t> pair{0, 0};
  for (std::size_t i = 0; i < offsets.size(); ++i)
    for (std::size_t j = i + 1; j < offsets.size(); ++j) {
      ComplexBall determinant = dot_product(offsets[i], turned[j], precision_bits);
      if (acb_contains_zero(determinant.get()) != 0 || !(size_log2(determinant) > size_log2(best))) continue;
      best = std::move(determinant);
      pair = {i, j};
    }
  const auto [i, j] = pair;
  if (i == j) return std::nullopt;
  const ComplexBall n_i = dot_product(turned[i], turned[i], precision_bits);
  const ComplexBall n_j = dot_product(turned[j], turned[j], precision_bits);
  ComplexBall denominator = product(t_squared, best, precision_bits);
  acb_mul_2exp_si(denominator.get(), denominator.get(), 1);
  BallVector c;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = product(n_i, turned[j][k], precision_bits);
    acb_submul(c[k].get(), n_j.get(), turned[i][k].get(), precision_bits);
    acb_div(c[k].get(), c[k].get(), denominator.get(), precision_bits);
  }
  return c;
}

void drop_imaginary_part(ComplexBall& z) { arb_zero(z.imaginary()); }

/// The magnitude of the largest of these numbers that surely is none; of all zero: 0.
long largest_magnitude(const std::vector<const ComplexBall*>& balls, long digits) {
  std::optional<long> largest;
  for (const ComplexBall* ball : balls) {
    if (acb_contains_zero(ball->get()) != 0) continue;
    const long magnitude = bridge::decimal_magnitude(*ball, digits);
    largest = std::max(largest.value_or(magnitude), magnitude);
  }
  return largest.value_or(0);
}

/// The number rounded to a multiple of 10^exponent; nullopt where its ball is too wide for a hundredth of that.
std::optional<Coordinate> rounded(const ComplexBall& value, long exponent) {
  const bridge::RealBall unit(Decimal{symbolic::Integer(1), exponent - 2}.to_rational(), 64);
  bridge::Magnitude smallest;
  arb_get_mag_lower(smallest.get(), unit.get());
  if (mag_cmp(arb_radref(value.real()), smallest.get()) > 0 ||
      mag_cmp(arb_radref(value.imaginary()), smallest.get()) > 0)
    return std::nullopt;
  return Coordinate{value, bridge::round_to_decimal(value.real(), exponent).to_string(),
                    bridge::round_to_decimal(value.imaginary(), exponent).to_string(), std::nullopt};
}

bool rounded(const BallVector& values, long exponent, std::array<Coordinate, 3>& result) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::optional<Coordinate> coordinate = rounded(values[i], exponent);
    if (!coordinate) return false;
    result[i] = *std::move(coordinate);
  }
  return true;
}

/// A number of Q(i).
struct ComplexRational {
  Rational real;
  Rational imaginary;

  friend ComplexRational operator+(const ComplexRational& a, const ComplexRational& b) {
    return {a.real + b.real, a.imaginary + b.imaginary};
  }
  friend ComplexRational operator-(const ComplexRational& a, const ComplexRational& b) {
    return {a.real - b.real, a.imaginary - b.imaginary};
  }
  friend ComplexRational operator*(const ComplexRational& a, const ComplexRational& b) {
    return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
  }
  bool is_zero() const { return real.is_zero() && imaginary.is_zero(); }
  ComplexBall ball(long precision_bits) const {
    ComplexBall z;
    arb_set_fmpq(z.real(), real.get(), precision_bits);
    arb_set_fmpq(z.imaginary(), imaginary.get(), precision_bits);
    return z;
  }
};

ComplexRational as_printed(const Coordinate& coordinate, long exponent) {
  return {bridge::round_to_decimal(coordinate.ball.real(), exponent).to_rational(),
          bridge::round_to_decimal(coordinate.ball.imaginary(), exponent).to_rational()};
}

using ComplexVector = std::array<ComplexRational, 3>;

BallVector ball_of(const ComplexVector& v, long precision_bits) {
  return {v[0].ball(precision_bits), v[1].ball(precision_bits), v[2].ball(precision_bits)};
}

ComplexRational squared_length(const ComplexVector& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// Whether |t x d|^2 = r^2 (t.t), exactly.
bool fits_exactly(const ComplexVector& t, const ComplexVector& d, const ComplexRational& r_squared) {
  ComplexVector turned;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    turned[i] = t[j] * d[k] - t[k] * d[j];
  }
  return (squared_length(turned) - r_squared * squared_length(t)).is_zero();
}

/// CylinderSolution::residual_exponent.
std::optional<long> residual_exponent(const Points& points, const CylinderSolution& solution, long precision_bits) {
  ComplexVector t;
  ComplexVector a;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = as_printed(solution.direction[i], solution.direction_error_exponent);
    a[i] = as_printed(solution.axis_point[i], solution.axis_point_error_exponent);
  }
  const ComplexRational r_squared = as_printed(solution.radius_squared, solution.radius_squared_error_exponent);
  const BallVector t_ball = ball_of(t, precision_bits);
  const ComplexBall t_squared = dot_product(t_ball, t_ball, precision_bits);
  if (acb_contains_zero(t_squared.get()) != 0) return unbounded_residual;
  bridge::Magnitude largest;
  for (const SpacePoint& point : points) {
    ComplexVector d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = {point[i] - a[i].real, -a[i].imaginary};
    const BallVector turned = cross_product(t_ball, ball_of(d, precision_bits), precision_bits);
    ComplexBall value = dot_product(turned, turned, precision_bits);
    acb_div(value.get(), value.get(), t_squared.get(), precision_bits);
    acb_sub(value.get(), value.get(), r_squared.ball(precision_bits).get(), precision_bits);
    if (acb_contains_zero(value.get()) != 0 && fits_exactly(t, d, r_squared)) continue;
    bridge::Magnitude bound;
    acb_get_mag(bound.get(), value.get());
    mag_max(largest.get(), largest.get(), bound.get());
  }
  if (mag_is_zero(largest.get()) != 0) return std::nullopt;
  constexpr double log10_of_2 = 0.30102999566398120;
  return static_cast<long>(std::ceil(mag_get_d_log2_approx(largest.get()) * log10_of_2 + 1e-6));
}

}  // namespace

ComplexBall dot_product(const BallVector& a, const BallVector& b, long precision_bits) {
  ComplexBall sum;
  for (std::size_t i = 0; i < 3; ++i) acb_addmul(sum.get(), a[i].get(), b[i].get(), precision_bits);
  return sum;
}

BallVector cross_product(const BallVector& a, const BallVector& b, long precision_bits) {
  BallVector result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    acb_mul(result[k].get(), a[i].get(), b[j].get(), precision_bits);
    acb_submul(result[k].get(), a[j].get(), b[i].get(), precision_bits);
  }
  return result;
}

std::optional<CylinderBalls> cylinder_of_direction(const Points& points, const BallVector& direction, bool real,
                                                   long precision_bits) {
  CylinderBalls result;
  result.direction = direction;
  BallVector& t = result.direction;
  if (real) std::for_each(t.begin(), t.end(), drop_imaginary_part);
  if (!normalize(t, real, precision_bits)) return std::nullopt;
  ComplexBall t_squared = dot_product(t, t, precision_bits);
  if (acb_contains_zero(t_squared.get()) != 0) return std::nullopt;
  std::vector<BallVector> offsets;
  SpacePoint centroid = points[0];
  for (std::size_t k = 1; k < 5; ++k) {
    offsets.push_back(ball_of(symbolic::difference(points[k], points[0]), precision_bits));
    for (std::size_t i = 0; i < 3; ++i) centroid[i] = centroid[i] + points[k][i];
  }
  for (Rational& coordinate : centroid) coordinate = coordinate / Rational(5);
  const std::optional<BallVector> c = axis_offset(offsets, t, t_squared, precision_bits);
  if (!c) return std::nullopt;
  result.radius_squared = dot_product(*c, *c, precision_bits);
  // c is perpendicular to t: from the first point by c to the axis, and along it to the foot from the centroid.
  ComplexBall along =
      dot_product(ball_of(symbolic::difference(centroid, points[0]), precision_bits), t, precision_bits);
  acb_div(along.get(), along.get(), t_squared.get(), precision_bits);
  result.axis_point = ball_of(points[0], precision_bits);
  for (std::size_t i = 0; i < 3; ++i) {
    acb_add(result.axis_point[i].get(), result.axis_point[i].get(), (*c)[i].get(), precision_bits);
    acb_addmul(result.axis_point[i].get(), along.get(), t[i].get(), precision_bits);
  }
  return result;
}

std::optional<CylinderSolution> print_cylinder(const Points& points, const CylinderBalls& cylinder, bool real,
                                               long digits, long precision_bits) {
  CylinderSolution solution;
  solution.reality = real ? Reality::real : Reality::non_real;
  solution.direction_error_exponent = -digits;
  Rational largest;
  SpacePoint extent{0, 0, 0};
  for (const SpacePoint& point : points)
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational size = point[i].sign() < 0 ? -point[i] : point[i];
      if (largest < size) largest = size;
      const Rational d = point[i] - points[0][i];
      extent[i] = extent[i] + d * d;
    }
  ComplexBall largest_given;
  acb_set_fmpq(largest_given.get(), largest.get(), precision_bits);
  const auto& [x, y, z] = cylinder.axis_point;
  solution.axis_point_error_exponent = largest_magnitude({&largest_given, &x, &y, &z}, digits) - digits;
  // A radius that may be 0 is measured by the extent of the points.
  ComplexBall squared_extent;
  acb_set_fmpq(squared_extent.get(), (extent[0] + extent[1] + extent[2]).get(), precision_bits);
  const bool zero = acb_contains_zero(cylinder.radius_squared.get()) != 0;
  solution.radius_squared_error_exponent =
      bridge::decimal_magnitude(zero ? squared_extent : cylinder.radius_squared, digits) - digits;
  std::optional<Coordinate> squared = rounded(cylinder.radius_squared, solution.radius_squared_error_exponent);
  if (!squared || !rounded(cylinder.direction, solution.direction_error_exponent, solution.direction) ||
      !rounded(cylinder.axis_point, solution.axis_point_error_exponent, solution.axis_point))
    return std::nullopt;
  solution.radius_squared = *std::move(squared);
  if (real) {
    if (zero) return std::nullopt;
    ComplexBall radius;
    acb_sqrt(radius.get(), cylinder.radius_squared.get(), precision_bits);
    drop_imaginary_part(radius);
    solution.radius_error_exponent = bridge::decimal_magnitude(radius, digits) - digits;
    solution.radius = rounded(radius, solution.radius_error_exponent);
    if (!solution.radius) return std::nullopt;
  }
  solution.residual_exponent = residual_exponent(points, solution, precision_bits);
  return solution;
}

}  // namespace eliminant::intersect
