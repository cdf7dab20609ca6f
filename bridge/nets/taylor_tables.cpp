// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/taylor_tables.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/nets/bezier_part.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

constexpr std::size_t weight = 3;

double binomial(std::size_t n, std::size_t k) {
  double result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * static_cast<double>(n - i) / static_cast<double>(i + 1);
  return result;
}

/// The control points between two values of each parameter, and the error of each coordinate.
struct RestrictedNet {
  std::vector<Array4d> points;
  Array4d error;
};

template <std::size_t P>
RestrictedNet restricted(const ControlNet& net, const NetShape<P>& shape, const std::array<double, P>& lower,
                         const std::array<double, P>& upper) {
  RestrictedNet result{net.points, net.error};
  for (std::size_t axis = 0; axis < P; ++axis) {
    Array4d size = Array4d::Zero();
    for (const Array4d& point : result.points) size = size.max(point.abs());
    const double beyond = std::max({0.0, -lower[axis], upper[axis] - 1});
    const auto degree = static_cast<double>(shape.degree[axis]);
    const double growth = std::exp(2 * degree * (2 * beyond));
    result.error = growth * (result.error + 20 * degree * unit_roundoff * size);
    restrict_to(shape, axis, lower[axis], upper[axis], result.points.data());
  }
  return result;
}

template <std::size_t P>
NetShape<P> shape_of(const ControlNet& net) {
  NetShape<P> shape;
  std::copy(net.degrees.begin(), net.degrees.end(), shape.degree.begin());
  return shape;
}

/// The control points in this frame, weights as they were, and their error with that of rounding here.
void to_frame(const ContactFrame& frame, RestrictedNet& net) {
  Array4d size = Array4d::Zero();
  for (Array4d& point : net.points) {
    size = size.max(point.abs());
    const Array4d moved = point - frame.origin * point[3];
    const double w = point[3];
    point = frame.columns[0] * moved[0] + frame.columns[1] * moved[1] + frame.columns[2] * moved[2];
    point[3] = w;
  }
  const Array4d moved_error =
      net.error + frame.origin.abs() * net.error[3] + 16 * unit_roundoff * (size + frame.origin.abs() * size[3]);
  const double weight_error = net.error[3];
  net.error = frame.columns[0].abs() * moved_error[0] + frame.columns[1].abs() * moved_error[1] +
              frame.columns[2].abs() * moved_error[2];
  net.error[3] = weight_error;
}

/// The Taylor coefficients at all points of a box of parameters, enclosed by differences of control points.
template <std::size_t P>
TaylorTable<DoubleInterval> taylor_on(const ControlNet& net, const ContactFrame& frame,
                                      const std::array<double, P>& lower, const std::array<double, P>& upper,
                                      std::size_t order) {
  const NetShape<P> shape = shape_of<P>(net);
  RestrictedNet part = restricted(net, shape, lower, upper);
  to_frame(frame, part);
  Array4d size = Array4d::Zero();
  for (const Array4d& point : part.points) size = size.max(point.abs());
  TaylorTable<DoubleInterval> table(P, order);
  const std::size_t rows = shape.degree[0] + 1;
  const std::size_t columns = P == 2 ? shape.degree[P - 1] + 1 : 1;
  std::vector<Array4d> by_first = part.points;
  for (std::size_t i = 0; i <= order; ++i) {
    if (i > 0) {
      for (std::size_t r = 0; r + i < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c)
          by_first[r * columns + c] = by_first[(r + 1) * columns + c] - by_first[r * columns + c];
    }
    std::vector<Array4d> points = by_first;
    for (std::size_t j = 0; i + j <= order && (P == 2 || j == 0); ++j) {
      std::array<DoubleInterval, 4>& entry = table.at(i, j);
      if (i >= rows || j >= columns) {
        entry.fill(DoubleInterval(0));
        continue;
      }
      if (j > 0) {
        for (std::size_t r = 0; r + i < rows; ++r)
          for (std::size_t c = 0; c + j < columns; ++c)
            points[r * columns + c] = points[r * columns + c + 1] - points[r * columns + c];
      }
      Array4d lowest = points[0];
      Array4d highest = points[0];
      for (std::size_t r = 0; r + i < rows; ++r)
        for (std::size_t c = 0; c + j < columns; ++c) {
          lowest = lowest.min(points[r * columns + c]);
          highest = highest.max(points[r * columns + c]);
        }
      const double doubling = std::ldexp(1.0, static_cast<int>(i + j));
      const Array4d error = doubling * (part.error + static_cast<double>(i + j) * 2 * unit_roundoff * size);
      DoubleInterval factor(binomial(shape.degree[0], i));
      for (std::size_t n = 0; n < i; ++n) factor = factor / (DoubleInterval(upper[0]) - DoubleInterval(lower[0]));
      if constexpr (P == 2) {
        factor = factor * DoubleInterval(binomial(shape.degree[1], j));
        for (std::size_t n = 0; n < j; ++n) factor = factor / (DoubleInterval(upper[1]) - DoubleInterval(lower[1]));
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const auto lane = static_cast<long>(k);
        entry[k] = factor * DoubleInterval::widened(lowest[lane] - error[lane], highest[lane] + error[lane]);
      }
      if (net.polynomial) entry[weight] = DoubleInterval(i + j == 0 ? 1 : 0);
    }
  }
  return table;
}

/// The Taylor coefficients near one point, approximately: the middles of those on a box that hardly has a width.
template <std::size_t P>
TaylorTable<double> taylor_close_to(const ControlNet& net, const std::array<double, P>& at, std::size_t order) {
  // From the nearer end of the domain, where dividing by the remaining length is harmless.
  const NetShape<P> shape = shape_of<P>(net);
  std::vector<Array4d> points = net.points;
  std::array<double, P> lower;
  std::array<double, P> upper;
  for (std::size_t axis = 0; axis < P; ++axis) {
    lower[axis] = at[axis] < 0.5 ? at[axis] : at[axis] - 0.5;
    upper[axis] = lower[axis] + 0.5;
    restrict_to(shape, axis, lower[axis], upper[axis], points.data());
  }
  TaylorTable<double> table(P, order);
  const std::size_t rows = shape.degree[0] + 1;
  const std::size_t columns = P == 2 ? shape.degree[P - 1] + 1 : 1;
  const bool from_end_a = at[0] >= 0.5;
  const bool from_end_b = P == 2 && at[P - 1] >= 0.5;
  for (std::size_t i = 0; i <= order; ++i) {
    if (i > 0) {
      for (std::size_t r = 0; r + i < rows; ++r)
        for (std::size_t c = 0; c < columns; ++c)
          points[r * columns + c] = points[(r + 1) * columns + c] - points[r * columns + c];
    }
    if (i >= rows) break;
    std::vector<Array4d> row(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(columns));
    if (from_end_a)
      std::copy_n(points.begin() + static_cast<std::ptrdiff_t>((rows - 1 - i) * columns), columns, row.begin());
    for (std::size_t j = 0; i + j <= order && j < columns; ++j) {
      if (j > 0)
        for (std::size_t c = 0; c + j < columns; ++c) row[c] = row[c + 1] - row[c];
      const Array4d value = binomial(shape.degree[0], i) * binomial(shape.degree[P - 1], P == 2 ? j : 0) *
                            std::ldexp(1.0, static_cast<int>(i + j)) * row[from_end_b ? columns - 1 - j : 0];
      for (std::size_t k = 0; k < 4; ++k) table.at(i, j)[k] = value[static_cast<long>(k)];
    }
  }
  return table;
}

/// The Bernstein polynomials of a degree on [-1, 1] in powers: entry [k][i] is the coefficient of x^k in the i-th one.
/// Exact for degrees that are not huge.
std::vector<std::vector<double>> bernstein_in_powers(std::size_t degree) {
  std::vector<std::vector<double>> result(degree + 1, std::vector<double>(degree + 1));
  for (std::size_t i = 0; i <= degree; ++i) {
    std::vector<double> product{std::ldexp(binomial(degree, i), -static_cast<int>(degree))};
    for (std::size_t factor = 0; factor < degree; ++factor) {
      const double sign = factor < i ? 1 : -1;
      product.push_back(0);
      for (std::size_t k = product.size() - 1; k > 0; --k) product[k] += sign * product[k - 1];
    }
    for (std::size_t k = 0; k <= degree; ++k) result[k][i] = product[k];
  }
  return result;
}

}  // namespace

DoubleInterval enclosed(const Rational& value) {
  constexpr long bits = 64;
  const RealBall ball(value, bits);
  RealBall end;
  arb_get_lbound_arf(arb_midref(end.get()), ball.get(), bits);
  const double lower = arf_get_d(arb_midref(end.get()), ARF_RND_FLOOR);
  arb_get_ubound_arf(arb_midref(end.get()), ball.get(), bits);
  return {lower, arf_get_d(arb_midref(end.get()), ARF_RND_CEIL)};
}

TaylorTable<DoubleInterval> taylor_on_box(const ControlNet& net, const ContactFrame& frame, const OpenBox& box,
                                          std::size_t first, std::size_t order) {
  if (net.parameters() == 1) return taylor_on<1>(net, frame, {box.lower[first]}, {box.upper[first]}, order);
  return taylor_on<2>(net, frame, {box.lower[first], box.lower[first + 1]}, {box.upper[first], box.upper[first + 1]},
                      order);
}

LocalPowers local_powers(const ControlNet& net, const ContactFrame& frame, const OpenBox& box, std::size_t first) {
  const NetShape<2> shape = shape_of<2>(net);
  RestrictedNet part =
      restricted<2>(net, shape, {box.lower[first], box.lower[first + 1]}, {box.upper[first], box.upper[first + 1]});
  to_frame(frame, part);
  Array4d size = Array4d::Zero();
  for (const Array4d& point : part.points) size = size.max(point.abs());
  std::vector<Array4d> line;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t degree = shape.degree[axis];
    const std::size_t stride = shape.stride(axis);
    const auto powers = bernstein_in_powers(degree);
    line.resize(degree + 1);
    shape.for_each_line(axis, [&](std::size_t base) {
      for (std::size_t i = 0; i <= degree; ++i) line[i] = part.points[base + i * stride];
      for (std::size_t k = 0; k <= degree; ++k) {
        Array4d sum = Array4d::Zero();
        for (std::size_t i = 0; i <= degree; ++i) sum += powers[k][i] * line[i];
        part.points[base + k * stride] = sum;
      }
    });
  }
  // The coefficients of all Bernstein polynomials of degree n have absolute values that sum up to 2^n.
  const std::size_t degrees = shape.degree[0] + shape.degree[1];
  const double rounding =
      static_cast<double>(2 * degrees + 8) * unit_roundoff * std::ldexp(1.0, static_cast<int>(degrees));
  return {shape.degree, std::move(part.points), part.error + rounding * size};
}

TaylorTable<double> taylor_near(const ControlNet& net, double a, double b, std::size_t order) {
  return net.parameters() == 1 ? taylor_close_to<1>(net, {a}, order) : taylor_close_to<2>(net, {a, b}, order);
}

/// Exact Taylor coefficients at a rational point.
TaylorTable<Rational> taylor_at(const ExactNet& net, const std::array<Rational, 2>& at, std::size_t order) {
  const bool is_patch = net.degrees.size() == 2;
  const std::size_t rows = net.degrees[0] + 1;
  const std::size_t columns = is_patch ? net.degrees[1] + 1 : 1;
  TaylorTable<Rational> table(net.degrees.size(), order);
  // Coefficients in the powers of (t - at), up to the order, by repeated synthetic division.
  const auto shifted = [&](const std::vector<Rational>& bernstein, const Rational& by) {
    std::vector<Rational> c = symbolic::power_coefficients(bernstein, {0, 1});
    if (!by.is_zero())
      for (std::size_t i = 0; i + 1 < c.size() && i <= order; ++i)
        for (std::size_t k = c.size() - 1; k-- > i;) c[k] = c[k] + by * c[k + 1];
    c.resize(order + 1);
    return c;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<std::vector<Rational>> by_row;
    for (std::size_t r = 0; r < rows; ++r) {
      std::vector<Rational> line;
      for (std::size_t c = 0; c < columns; ++c) line.push_back(net.points[r * columns + c][k]);
      by_row.push_back(is_patch ? shifted(line, at[1]) : line);
    }
    for (std::size_t j = 0; j < by_row.front().size() && j <= order; ++j) {
      std::vector<Rational> line;
      for (std::size_t r = 0; r < rows; ++r) line.push_back(by_row[r][j]);
      const std::vector<Rational> column = shifted(line, at[0]);
      for (std::size_t i = 0; i + j <= order; ++i) table.at(i, j)[k] = column[i];
    }
  }
  return table;
}

TaylorTable<DoubleInterval> enclosed(const TaylorTable<Rational>& exact, const ControlNet& net,
                                     const ContactFrame& frame) {
  const std::array<Rational, 4> point = exact.at(0);
  TaylorTable<DoubleInterval> table(exact.parameters(), exact.order());
  for (std::size_t i = 0; i <= exact.order(); ++i)
    for (std::size_t j = 0; i + j <= exact.order() && (exact.parameters() == 2 || j == 0); ++j) {
      const std::array<Rational, 4>& from = exact.at(i, j);
      std::array<DoubleInterval, 4>& to = table.at(i, j);
      const Rational unit = net.polynomial ? point[weight] : Rational(1);
      to[weight] = enclosed(from[weight] / unit);
      for (std::size_t k = 0; k < 3; ++k) {
        const DoubleInterval moved = enclosed((from[k] - point[k] / point[weight] * from[weight]) / unit);
        for (std::size_t r = 0; r < 3; ++r)
          to[r] = to[r] + DoubleInterval(frame.columns[k][static_cast<long>(r)]) * moved;
      }
    }
  return table;
}

}  // namespace eliminant::bridge
