// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/branch_spline.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <eliminant/bridge/enclosures/double_interval.hpp>

namespace eliminant::intersect {

namespace {

constexpr std::size_t coordinate_count = 7;
constexpr std::size_t first_in_space = 4;
constexpr std::size_t degree = 3;
using Values = std::array<double, coordinate_count>;

// The polyline over its own parameter.
struct Polyline {
  std::vector<Values> points;
  // Strictly increasing, from 0.
  std::vector<double> at;
  std::array<bool, coordinate_count> known{};
  // What one unit of a relative distance is: the size in space, and that in the parameters.
  double space_size = 1;
  double parameter_size = 1;
  // Largest distance in space of a point that was left out from the one before it.
  double left_out = 0;
  bool closed = false;
};

Values values_of(const SurfacePoint& point) {
  Values values{};
  std::copy(point.parameters.begin(), point.parameters.end(), values.begin());
  std::copy(point.point.begin(), point.point.end(), values.begin() + first_in_space);
  return values;
}

double largest_range(const std::vector<Values>& points, std::size_t begin, std::size_t end,
                     const std::array<bool, coordinate_count>& known) {
  double largest = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (!known[i]) continue;
    const auto [lower, upper] = std::minmax_element(points.begin(), points.end(),
                                                    [&](const Values& a, const Values& b) { return a[i] < b[i]; });
    largest = std::max(largest, (*upper)[i] - (*lower)[i]);
  }
  return largest > 0 ? largest : 1;
}

double relative_distance(const Polyline& line, const Values& a, const Values& b) {
  double sum = 0;
  for (std::size_t i = 0; i < coordinate_count; ++i) {
    const double step = (a[i] - b[i]) / (i < first_in_space ? line.parameter_size : line.space_size);
    sum += step * step;
  }
  return std::sqrt(sum);
}

// Keeps the points between which the parameter grows, the first and the last one among them.
void measure(Polyline& line, const std::vector<Values>& points) {
  const auto leave_out = [&](double distance) {
    line.left_out = std::max(line.left_out, 2 * distance * line.space_size);
  };
  line.points = {points.front()};
  line.at = {0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = relative_distance(line, line.points.back(), points[i]);
    const double at = line.at.back() + step;
    const bool grows = at > line.at.back();
    if (!grows) leave_out(step);
    if (grows) {
      line.points.push_back(points[i]);
      line.at.push_back(at);
    } else if (i + 1 == points.size() && line.points.size() > 1) {
      line.points.back() = points[i];
    }
  }
}

std::optional<Polyline> polyline_of(const SurfaceComponent& component) {
  std::vector<Values> points;
  for (const SurfacePoint& point : component.points) points.push_back(values_of(point));
  Polyline line;
  for (std::size_t i = 0; i < coordinate_count; ++i) {
    line.known[i] = std::all_of(points.begin(), points.end(), [&](const Values& p) { return std::isfinite(p[i]); });
    if (i >= first_in_space && !line.known[i]) return std::nullopt;
    if (!line.known[i])
      for (Values& point : points) point[i] = 0;
  }
  if (points.size() < 2) return std::nullopt;
  line.parameter_size = largest_range(points, 0, first_in_space, line.known);
  line.space_size = largest_range(points, first_in_space, coordinate_count, line.known);
  line.closed = component.kind == SurfaceComponentKind::loop && points.front() == points.back();
  measure(line, points);
  // A closed one goes somewhere and comes back.
  if (line.points.size() < (line.closed ? 3U : 2U)) return std::nullopt;
  return line;
}

// A system of equations, row i with `lower` before the diagonal and `upper` behind it.
struct Tridiagonal {
  std::vector<double> lower;
  std::vector<double> diagonal;
  std::vector<double> upper;
  std::vector<Values> right;

  explicit Tridiagonal(std::size_t size) : lower(size), diagonal(size, 1), upper(size), right(size) {}

  // Without pivoting: the matrices here need none.
  std::vector<Values> solution() const {
    const std::size_t size = diagonal.size();
    std::vector<double> pivots = diagonal;
    std::vector<Values> values = right;
    for (std::size_t i = 1; i < size; ++i) {
      const double factor = lower[i] / pivots[i - 1];
      pivots[i] -= factor * upper[i - 1];
      for (std::size_t k = 0; k < coordinate_count; ++k) values[i][k] -= factor * values[i - 1][k];
    }
    for (std::size_t i = size; i-- > 0;)
      for (std::size_t k = 0; k < coordinate_count; ++k) {
        if (i + 1 < size) values[i][k] -= upper[i] * values[i + 1][k];
        values[i][k] /= pivots[i];
      }
    return values;
  }
};

// The cubic spline that interpolates the polyline at some of its points.
class Interpolation {
 public:
  // `breaks` are indices of points, the first and the last one among them.
  Interpolation(const Polyline& line, const std::vector<std::size_t>& breaks) : line_(line), breaks_(breaks) {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      steps_.push_back(at(i + 1) - at(i));
      chords_.emplace_back();
      for (std::size_t k = 0; k < coordinate_count; ++k)
        chords_.back()[k] = (value(i + 1)[k] - value(i)[k]) / steps_.back();
    }
    if (line.closed)
      find_periodic_slopes();
    else if (steps_.size() >= 3)
      find_slopes();
    else
      find_slopes_of_few();
  }

  BranchSpline spline() const {
    BranchSpline result;
    // Open ones have no knot at the second and at the last break but one.
    const std::size_t skipped = line_.closed ? 1 : 2;
    result.knots.assign(degree + 1, at(0));
    for (std::size_t i = skipped; i + skipped < breaks_.size(); ++i) result.knots.push_back(at(i));
    result.knots.insert(result.knots.end(), degree + 1, at(breaks_.size() - 1));
    for (std::size_t j = 0; j + degree + 1 < result.knots.size(); ++j)
      result.control_points.push_back(blossom(result.knots[j + 1], result.knots[j + 2], result.knots[j + 3]));
    result.control_points.front() = value(0);
    result.control_points.back() = value(breaks_.size() - 1);
    return result;
  }

 private:
  double at(std::size_t i) const { return line_.at[breaks_[i]]; }
  const Values& value(std::size_t i) const { return line_.points[breaks_[i]]; }

  // The second derivatives agree at the breaks inside; the first and the last row are left to the caller.
  Tridiagonal smoothness() const {
    Tridiagonal system(breaks_.size());
    for (std::size_t i = 1; i + 1 < breaks_.size(); ++i) {
      system.lower[i] = steps_[i];
      system.diagonal[i] = 2 * (steps_[i - 1] + steps_[i]);
      system.upper[i] = steps_[i - 1];
      for (std::size_t k = 0; k < coordinate_count; ++k)
        system.right[i][k] = 3 * (steps_[i] * chords_[i - 1][k] + steps_[i - 1] * chords_[i][k]);
    }
    return system;
  }

  // The third derivatives agree at the second and the last break but one: these are no knots.
  void find_slopes() {
    Tridiagonal system = smoothness();
    const std::size_t last = steps_.size() - 1;
    const auto row = [&](std::size_t i, std::size_t outer, std::size_t inner, double& beside) {
      const double both = steps_[outer] + steps_[inner];
      system.diagonal[i] = steps_[inner];
      beside = both;
      for (std::size_t k = 0; k < coordinate_count; ++k)
        system.right[i][k] = ((steps_[outer] + 2 * both) * steps_[inner] * chords_[outer][k] +
                              steps_[outer] * steps_[outer] * chords_[inner][k]) /
                             both;
    };
    row(0, 0, 1, system.upper.front());
    row(last + 1, last, last - 1, system.lower.back());
    slopes_ = system.solution();
  }

  // One span is a segment, two are a parabola.
  void find_slopes_of_few() {
    slopes_.assign(breaks_.size(), chords_.front());
    if (steps_.size() < 2) return;
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      const double bend = (chords_[1][k] - chords_[0][k]) / (steps_[0] + steps_[1]);
      slopes_[0][k] = chords_[0][k] - bend * steps_[0];
      slopes_[1][k] = chords_[0][k] + bend * steps_[0];
      slopes_[2][k] = chords_[1][k] + bend * steps_[1];
    }
  }

  // First and second derivatives agree at both ends: the spline with slopes zero there plus a multiple of the one
  // through zero with slopes one.
  void find_periodic_slopes() {
    Tridiagonal system = smoothness();
    slopes_ = system.solution();
    for (Values& values : system.right) values.fill(0);
    system.right.front().fill(1);
    system.right.back().fill(1);
    const std::vector<Values> unit = system.solution();
    const std::size_t last = steps_.size() - 1;
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      const double bend = (6 * chords_[0][k] - 2 * slopes_[1][k]) / steps_[0] +
                          (6 * chords_[last][k] - 2 * slopes_[last][k]) / steps_[last];
      const double slope = bend / ((4 + 2 * unit[1][k]) / steps_[0] + (4 + 2 * unit[last][k]) / steps_[last]);
      for (std::size_t i = 0; i < slopes_.size(); ++i) slopes_[i][k] += slope * unit[i][k];
    }
  }

  // The blossom of the cubic that stands at the middle argument.
  Values blossom(double a, double b, double c) const {
    const auto above =
        std::upper_bound(breaks_.begin(), breaks_.end(), b, [&](double x, std::size_t i) { return x < line_.at[i]; });
    const auto past = static_cast<std::size_t>(above - breaks_.begin());
    const std::size_t piece = std::clamp<std::size_t>(past, 1, steps_.size()) - 1;
    const double begin = at(piece);
    const double step = steps_[piece];
    Values result{};
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      std::array<double, degree + 1> bezier{value(piece)[k], value(piece)[k] + step / 3 * slopes_[piece][k],
                                            value(piece + 1)[k] - step / 3 * slopes_[piece + 1][k],
                                            value(piece + 1)[k]};
      std::size_t count = degree;
      for (const double argument : {a, b, c}) {
        const double weight = (argument - begin) / step;
        for (std::size_t i = 0; i < count; ++i) bezier[i] = (1 - weight) * bezier[i] + weight * bezier[i + 1];
        --count;
      }
      result[k] = bezier[0];
    }
    return result;
  }

  const Polyline& line_;
  const std::vector<std::size_t>& breaks_;
  std::vector<double> steps_;
  std::vector<Values> chords_;
  std::vector<Values> slopes_;
};

double magnitude(double value) { return std::fabs(value); }
double magnitude(const bridge::DoubleInterval& value) { return value.magnitude(); }

// The blossom of the spline on the knots number `span` and `span` + 1.
template <class Scalar>
Scalar blossom(const BranchSpline& spline, std::size_t span, std::size_t coordinate,
               const std::array<double, degree>& arguments) {
  std::array<Scalar, degree + 1> values{};
  for (std::size_t i = 0; i <= degree; ++i) values[i] = Scalar(spline.control_points[span - degree + i][coordinate]);
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = degree; i >= level; --i) {
      const Scalar lower(spline.knots[span - degree + i]);
      const Scalar upper(spline.knots[span + 1 + i - level]);
      const Scalar weight = (Scalar(arguments[level - 1]) - lower) / (upper - lower);
      values[i] = values[i - 1] + weight * (values[i] - values[i - 1]);
    }
  return values[degree];
}

// Distances of the spline from the polyline on one of its segments, at equal parameters: at its beginning, and a bound
// for all of it, the largest control point of the difference. In space, or the same share of the parameters' size.
struct Deviation {
  double at_point = 0;
  double bound = 0;
};

template <class Scalar>
Deviation deviation(const Polyline& line, const BranchSpline& spline, std::size_t span, std::size_t segment,
                    std::size_t first, std::size_t last) {
  const double a = line.at[segment];
  const double b = line.at[segment + 1];
  std::array<double, degree + 1> squares{};
  for (std::size_t k = first; k < last; ++k) {
    const Scalar begin(line.points[segment][k]);
    const Scalar third = (Scalar(line.points[segment + 1][k]) - begin) / Scalar(3);
    for (std::size_t i = 0; i <= degree; ++i) {
      const std::array<double, degree> arguments{i < 3 ? a : b, i < 2 ? a : b, i < 1 ? a : b};
      const Scalar on_line = begin + Scalar(static_cast<double>(i)) * third;
      const double distance = magnitude(blossom<Scalar>(spline, span, k, arguments) - on_line);
      squares[i] += distance * distance;
    }
  }
  // The sum and the root lose less than this, also where squares are too small for a double.
  const auto root = [](double square) { return std::sqrt(square) * (1 + 0x1p-48) + 0x1p-500; };
  return {root(squares[0]), root(*std::max_element(squares.begin(), squares.end()))};
}

// Calls `use` with the number of each segment and of the knot span that it lies in.
template <class Use>
void for_each_segment(const Polyline& line, const BranchSpline& spline, Use use) {
  std::size_t span = degree;
  for (std::size_t segment = 0; segment + 1 < line.points.size(); ++segment) {
    while (spline.knots[span + 1] <= line.at[segment]) ++span;
    use(segment, span);
  }
}

// The breaks, and one more in each span that is farther than the tolerance from the polyline, where that helps: where
// chords are as far from the points between them it does not.
std::vector<std::size_t> refined(const Polyline& line, const BranchSpline& spline,
                                 const std::vector<std::size_t>& breaks, double tolerance) {
  std::vector<Deviation> largest(breaks.size() - 1);
  const double share = line.space_size / line.parameter_size;
  std::size_t piece = 0;
  for_each_segment(line, spline, [&](std::size_t segment, std::size_t span) {
    if (segment >= breaks[piece + 1]) ++piece;
    const Deviation space = deviation<double>(line, spline, span, segment, first_in_space, coordinate_count);
    const Deviation parameters = deviation<double>(line, spline, span, segment, 0, first_in_space);
    Deviation& worst = largest[piece];
    worst.at_point = std::max({worst.at_point, space.at_point, share * parameters.at_point});
    worst.bound = std::max({worst.bound, space.bound, share * parameters.bound});
  });
  std::vector<std::size_t> result{breaks.front()};
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const bool helps = largest[i].at_point > largest[i].bound / 16;
    if (largest[i].bound > tolerance && helps && breaks[i + 1] - breaks[i] > 1) {
      const double middle = (line.at[breaks[i]] + line.at[breaks[i + 1]]) / 2;
      const auto position = std::lower_bound(line.at.begin(), line.at.end(), middle) - line.at.begin();
      result.push_back(std::clamp(static_cast<std::size_t>(position), breaks[i] + 1, breaks[i + 1] - 1));
    }
    result.push_back(breaks[i + 1]);
  }
  return result;
}

// About evenly spread over the points.
std::vector<std::size_t> first_breaks(const Polyline& line) {
  const std::size_t last = line.points.size() - 1;
  const std::size_t spans = std::min<std::size_t>(last, line.closed ? 4 : 3);
  std::vector<std::size_t> breaks;
  for (std::size_t i = 0; i <= spans; ++i) breaks.push_back(i * last / spans);
  return breaks;
}

double proven_distance(const Polyline& line, const BranchSpline& spline) {
  double bound = 0;
  for_each_segment(line, spline, [&](std::size_t segment, std::size_t span) {
    bound = std::max(
        bound, deviation<bridge::DoubleInterval>(line, spline, span, segment, first_in_space, coordinate_count).bound);
  });
  return bound;
}

}  // namespace

std::optional<BranchSpline> branch_spline(const SurfaceComponent& component, double tolerance) {
  const bool is_curve = component.kind == SurfaceComponentKind::curve || component.kind == SurfaceComponentKind::loop;
  const std::optional<Polyline> line = is_curve ? polyline_of(component) : std::nullopt;
  if (!line) return std::nullopt;
  std::vector<std::size_t> breaks = first_breaks(*line);
  BranchSpline spline = Interpolation(*line, breaks).spline();
  for (auto more = refined(*line, spline, breaks, tolerance); more.size() > breaks.size();
       more = refined(*line, spline, breaks, tolerance)) {
    breaks = std::move(more);
    spline = Interpolation(*line, breaks).spline();
  }
  spline.error = (component.error + proven_distance(*line, spline) + line->left_out) * (1 + 0x1p-50);
  for (std::size_t i = 0; i < coordinate_count; ++i)
    if (!line->known[i])
      for (Values& point : spline.control_points) point[i] = std::numeric_limits<double>::quiet_NaN();
  return spline;
}

}  // namespace eliminant::intersect
