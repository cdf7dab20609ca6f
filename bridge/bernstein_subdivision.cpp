// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/bernstein_subdivision.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace eliminant::bridge {

namespace {

constexpr double unit = 0x1p-52;

/// A closed interval; every operation rounds outwards by more than the hardware rounds.
struct Range {
  double lower = 0;
  double upper = 0;

  static Range widened(double lower, double upper) {
    const double slack = 2 * unit * std::max(std::fabs(lower), std::fabs(upper)) + 0x1p-1000;
    return {lower - slack, upper + slack};
  }
  double magnitude() const { return std::max(std::fabs(lower), std::fabs(upper)); }
  friend Range operator+(Range a, Range b) { return widened(a.lower + b.lower, a.upper + b.upper); }
  friend Range operator-(Range a, Range b) { return widened(a.lower - b.upper, a.upper - b.lower); }
  friend Range operator*(Range a, Range b) {
    const double p = a.lower * b.lower;
    const double q = a.lower * b.upper;
    const double r = a.upper * b.lower;
    const double s = a.upper * b.upper;
    return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
  }
  friend Range operator*(double a, Range b) { return Range{a, a} * b; }
};

/// A part of a curve or patch: its control points, and the interval of each parameter.
struct Part {
  ControlNet net;
  std::array<double, 2> lower{0, 0};
  std::array<double, 2> width{1, 1};
  /// The box around the points of the part, weights divided out.
  std::array<Range, 3> box;

  std::size_t parameters() const { return net.degrees.size(); }
  std::size_t stride(std::size_t axis) const { return axis + 1 == parameters() ? 1 : net.degrees[1] + 1; }
};

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::fabs(value));
  return result;
}

/// False when a weight may not be positive.
bool bound(Part& part) {
  const std::vector<double>& weights = part.net.coordinates[3];
  for (std::size_t k = 0; k < 3; ++k) {
    double lower = INFINITY;
    double upper = -INFINITY;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] <= 2 * part.net.error) return false;
      const double quotient = part.net.coordinates[k][i] / weights[i];
      // The error of the quotient, with room for the rounding.
      const double error = 1.001 * part.net.error * (1 + std::fabs(quotient)) / (weights[i] - part.net.error) +
                           2 * unit * std::fabs(quotient);
      lower = std::min(lower, quotient - error);
      upper = std::max(upper, quotient + error);
    }
    part.box[k] = Range::widened(lower, upper);
  }
  return true;
}

/// Both halves along one parameter.
std::array<Part, 2> halves(const Part& whole, std::size_t axis) {
  std::array<Part, 2> result{whole, whole};
  const std::size_t degree = whole.net.degrees[axis];
  const std::size_t stride = whole.stride(axis);
  const std::size_t lines = whole.net.coordinates[0].size() / (degree + 1);
  const std::size_t line_step = axis == 0 && whole.parameters() == 2 ? 1 : degree + 1;
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t line = 0; line < lines; ++line) {
      double* const left = result[0].net.coordinates[k].data() + line * line_step;
      double* const right = result[1].net.coordinates[k].data() + line * line_step;
      for (std::size_t level = 0; level <= degree; ++level) {
        left[level * stride] = right[0];
        for (std::size_t i = 0; i + level < degree; ++i)
          right[i * stride] = 0.5 * (right[i * stride] + right[(i + 1) * stride]);
      }
    }
  double size = 0;
  for (const std::vector<double>& values : whole.net.coordinates) size = std::max(size, largest(values));
  for (std::size_t half = 0; half < 2; ++half) {
    Part& part = result[half];
    part.net.error = (whole.net.error + static_cast<double>(degree) * unit * size) * (1 + 4 * unit);
    part.width[axis] = whole.width[axis] / 2;
    part.lower[axis] = whole.lower[axis] + (half == 0 ? 0 : part.width[axis]);
  }
  return result;
}

/// The range of a coordinate minus `shift` times the weight, or of its derivative along one parameter of the part.
Range range_of(const Part& part, std::size_t k, double shift, std::optional<std::size_t> axis = std::nullopt) {
  const std::vector<double>& values = part.net.coordinates[k];
  const std::vector<double>& weights = part.net.coordinates[3];
  const double error = part.net.error * (1 + std::fabs(shift));
  double lower = INFINITY;
  double upper = -INFINITY;
  double size = 0;
  const auto take = [&](double value) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  };
  const auto shifted = [&](std::size_t i) {
    size = std::max(size, std::fabs(values[i]) + std::fabs(shift * weights[i]));
    return values[i] - shift * weights[i];
  };
  double factor = 1;
  if (!axis) {
    for (std::size_t i = 0; i < values.size(); ++i) take(shifted(i));
  } else {
    const std::size_t stride = part.stride(*axis);
    const std::size_t degree = part.net.degrees[*axis];
    if (degree == 0) return {0, 0};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t position = part.parameters() == 1 ? i : (*axis == 0 ? i / stride : i % (degree + 1));
      if (position < degree) take(shifted(i + stride) - shifted(i));
    }
    factor = static_cast<double>(degree);
  }
  const double slack = (axis ? 2 : 1) * (error + 4 * unit * size);
  return Range::widened(factor * (lower - slack), factor * (upper + slack));
}

/// The value in the middle of the part, by de Casteljau's algorithm.
std::array<Range, 4> middle_of(const Part& part) {
  std::array<Range, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> values = part.net.coordinates[k];
    const double size = largest(values);
    double levels = 0;
    for (std::size_t axis = part.parameters(); axis-- > 0;) {
      // The last parameter runs fastest: its lines shrink to one value each.
      const std::size_t degree = part.net.degrees[axis];
      const std::size_t lines = values.size() / (degree + 1);
      std::vector<double> next(lines);
      for (std::size_t line = 0; line < lines; ++line) {
        double* const v = values.data() + line * (degree + 1);
        for (std::size_t level = degree; level > 0; --level)
          for (std::size_t i = 0; i < level; ++i) v[i] = 0.5 * (v[i] + v[i + 1]);
        next[line] = v[0];
      }
      values = std::move(next);
      levels += static_cast<double>(degree);
    }
    const double error = part.net.error + levels * unit * size;
    result[k] = Range::widened(values[0] - error, values[0] + error);
  }
  return result;
}

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The inverse of a matrix, approximately; nullopt when it is not finite.
std::optional<Matrix3> inverse(const Matrix3& m) {
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    const std::size_t c = (j + 1) % 3;
    const std::size_t d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
  Matrix3 result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      result[j][i] = cofactor(i, j) / determinant;
      if (!std::isfinite(result[j][i])) return std::nullopt;
    }
  return result;
}

/// What the Krawczyk operator says of a pair of parts.
struct LinearTest {
  bool at_most_one = false;
  bool none = false;
  /// Where a zero would be, in the parameters (u, s, t) of the whole.
  std::array<double, 3> near{};
};

/// In coordinates of [-1, 1]^3 for the two parts: F = X_patch w_curve - X_curve w_patch, X shifted so that both are
/// near 0, which changes no zero and makes the derivatives of the weights harmless.
LinearTest linear_test(const Part& curve, const Part& patch) {
  LinearTest result;
  const std::array<Range, 4> on_curve = middle_of(curve);
  const std::array<Range, 4> on_patch = middle_of(patch);
  const Range curve_weight = range_of(curve, 3, 0);
  const Range patch_weight = range_of(patch, 3, 0);
  std::array<std::array<Range, 3>, 3> jacobian;
  std::array<Range, 3> value;
  for (std::size_t k = 0; k < 3; ++k) {
    const double shift = 0.5 * (on_curve[k].lower / on_curve[3].lower + on_patch[k].lower / on_patch[3].lower);
    if (!std::isfinite(shift)) return result;
    const Range x_curve = range_of(curve, k, shift);
    const Range x_patch = range_of(patch, k, shift);
    const Range by_u = x_patch * range_of(curve, 3, 0, 0) - range_of(curve, k, shift, 0) * patch_weight;
    jacobian[k][0] = 0.5 * by_u;
    for (std::size_t axis = 0; axis < 2; ++axis)
      jacobian[k][1 + axis] =
          0.5 * (range_of(patch, k, shift, axis) * curve_weight - x_curve * range_of(patch, 3, 0, axis));
    value[k] = (on_patch[k] - shift * on_patch[3]) * on_curve[3] - (on_curve[k] - shift * on_curve[3]) * on_patch[3];
  }
  Matrix3 middle;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) middle[i][j] = 0.5 * (jacobian[i][j].lower + jacobian[i][j].upper);
  const std::optional<Matrix3> c = inverse(middle);
  if (!c) return result;
  std::array<double, 3> row_sums{};
  std::array<Range, 3> step;
  for (std::size_t i = 0; i < 3; ++i) {
    step[i] = {0, 0};
    for (std::size_t j = 0; j < 3; ++j) {
      Range entry{0, 0};
      for (std::size_t k = 0; k < 3; ++k) entry = entry + (*c)[i][k] * jacobian[k][j];
      if (i == j) entry = entry - Range{1, 1};
      row_sums[i] += entry.magnitude() * (1 + 8 * unit);
      step[i] = step[i] + (*c)[i][j] * value[j];
    }
  }
  // Injective also a little beyond the parts, so that a zero on a border between parts counts for both of them.
  constexpr double at_most = 0.9;
  result.at_most_one = std::max({row_sums[0], row_sums[1], row_sums[2]}) < at_most;
  for (std::size_t i = 0; i < 3; ++i) {
    // A zero x in the box has |x + C F(0)| <= row sum.
    const double distance = std::min(std::fabs(step[i].lower), std::fabs(step[i].upper));
    const bool zero_between = step[i].lower <= 0 && step[i].upper >= 0;
    if (std::isfinite(row_sums[i]) && !zero_between && distance > (1 + row_sums[i]) * (1 + 1e-9)) result.none = true;
    const double local = std::clamp(-0.5 * (step[i].lower + step[i].upper), -1.5, 1.5);
    const double lower = i == 0 ? curve.lower[0] : patch.lower[i - 1];
    const double width = i == 0 ? curve.width[0] : patch.width[i - 1];
    result.near[i] = lower + width * (0.5 + 0.5 * local);
  }
  return result;
}

/// The coordinates of a curve or patch at parameters of the whole, and their partial derivatives, without a bound of
/// the error.
struct Jet {
  std::array<double, 4> value{};
  std::array<std::array<double, 4>, 2> partials{};
};

Jet jet(const ControlNet& net, const std::array<double, 2>& at) {
  Jet result;
  for (std::size_t k = 0; k < 4; ++k) {
    // The values along the last parameter, and the derivative by it.
    const std::size_t degree = net.degrees.back();
    const std::size_t lines = net.coordinates[k].size() / (degree + 1);
    const double last = at[net.degrees.size() - 1];
    std::vector<double> values(lines);
    std::vector<double> slopes(lines);
    const auto along = [](std::vector<double> b, double t) {
      const std::size_t n = b.size() - 1;
      double slope = 0;
      for (std::size_t level = n; level > 0; --level) {
        if (level == 1) slope = static_cast<double>(n) * (b[1] - b[0]);
        for (std::size_t i = 0; i < level; ++i) b[i] = (1 - t) * b[i] + t * b[i + 1];
      }
      return std::pair(b[0], slope);
    };
    for (std::size_t line = 0; line < lines; ++line) {
      const auto begin = net.coordinates[k].begin() + static_cast<std::ptrdiff_t>(line * (degree + 1));
      std::tie(values[line], slopes[line]) = along({begin, begin + static_cast<std::ptrdiff_t>(degree + 1)}, last);
    }
    if (net.degrees.size() == 1) {
      result.value[k] = values[0];
      result.partials[0][k] = slopes[0];
    } else {
      std::tie(result.value[k], result.partials[0][k]) = along(values, at[0]);
      result.partials[1][k] = along(slopes, at[0]).first;
    }
  }
  return result;
}

/// Newton's steps from parameters (u, s, t) in doubles; they may lead anywhere.
std::array<double, 3> newton(const ControlNet& curve, const ControlNet& patch, std::array<double, 3> at) {
  constexpr int most_steps = 8;
  for (int step = 0; step < most_steps; ++step) {
    const Jet c = jet(curve, {at[0], 0});
    const Jet p = jet(patch, {at[1], at[2]});
    Matrix3 jacobian;
    std::array<double, 3> value{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto minor = [&](const std::array<double, 4>& a, const std::array<double, 4>& b) {
        return a[k] * b[3] - a[3] * b[k];
      };
      value[k] = minor(p.value, c.value);
      jacobian[k] = {minor(p.value, c.partials[0]), minor(p.partials[0], c.value), minor(p.partials[1], c.value)};
    }
    const std::optional<Matrix3> inverted = inverse(jacobian);
    if (!inverted) break;
    double largest_change = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double change = (*inverted)[i][0] * value[0] + (*inverted)[i][1] * value[1] + (*inverted)[i][2] * value[2];
      at[i] -= change;
      largest_change = std::max(largest_change, std::fabs(change));
    }
    constexpr double at_rest = 1e-13;
    if (!(largest_change > at_rest)) break;
  }
  return at;
}

class Subdivision {
 public:
  Subdivision(const ControlNet& curve, const ControlNet& patch, const CertifyNear& certify, const Context& context)
      : curve_(curve), patch_(patch), certify_(certify), context_(context) {}

  /// False when something stays undecided.
  bool run() {
    Part curve{curve_, {}, {1, 1}, {}};
    Part patch{patch_, {}, {1, 1}, {}};
    if (!bound(curve) || !bound(patch)) return false;
    std::vector<std::pair<Part, Part>> open;
    open.emplace_back(std::move(curve), std::move(patch));
    constexpr int most_pairs = 20000;
    for (int count = 0; !open.empty(); ++count) {
      if (count > most_pairs) return false;
      if (count % 64 == 63) context_.checkpoint("subdividing");
      const auto [c, p] = std::move(open.back());
      open.pop_back();
      if (apart(c, p)) continue;
      const LinearTest test = linear_test(c, p);
      if (test.none) continue;
      if (test.at_most_one && settle(c, p, test.near)) continue;
      constexpr double smallest_width = 1e-6;
      if (std::max({c.width[0], p.width[0], p.width[1]}) < smallest_width) return false;
      if (!divide(c, p, open)) return false;
    }
    return true;
  }

  std::vector<ParameterBox> zeros() && { return std::move(zeros_); }

 private:
  static bool apart(const Part& a, const Part& b) {
    for (std::size_t k = 0; k < 3; ++k)
      if (a.box[k].upper < b.box[k].lower || b.box[k].upper < a.box[k].lower) return true;
    return false;
  }

  /// True when the one zero that the parts may have is known: it is in them, or next to their border.
  bool settle(const Part& curve, const Part& patch, const std::array<double, 3>& near) {
    const auto within = [&](const ParameterBox& zero) {
      // Nearer to the part than a billionth of its width: there the derivatives are bounded as in the part.
      constexpr double margin = 1e-9;
      for (std::size_t i = 0; i < 3; ++i) {
        const double lower = i == 0 ? curve.lower[0] : patch.lower[i - 1];
        const double width = i == 0 ? curve.width[0] : patch.width[i - 1];
        const double middle = arf_get_d(arb_midref(zero[i].real()), ARF_RND_NEAR);
        const double radius = mag_get_d(arb_radref(zero[i].real())) + 1e-15;
        if (middle - radius < lower - margin * width || middle + radius > lower + (1 + margin) * width) return false;
      }
      return true;
    };
    if (std::any_of(zeros_.begin(), zeros_.end(), within)) return true;
    std::optional<ParameterBox> zero = certify_(newton(curve_, patch_, near));
    if (!zero) return false;
    const bool inside = within(*zero);
    const bool known = std::any_of(zeros_.begin(), zeros_.end(), [&](const ParameterBox& other) {
      return acb_overlaps(other[0].get(), (*zero)[0].get()) != 0 &&
             acb_overlaps(other[1].get(), (*zero)[1].get()) != 0 && acb_overlaps(other[2].get(), (*zero)[2].get()) != 0;
    });
    if (!known && inside) zeros_.push_back(*std::move(zero));
    return inside;
  }

  /// Halves the larger of the two, along its longer parameter.
  static bool divide(const Part& curve, const Part& patch, std::vector<std::pair<Part, Part>>& open) {
    const auto size = [](const Part& part) {
      double result = 0;
      for (const Range& side : part.box) result = std::max(result, side.upper - side.lower);
      return result;
    };
    if (size(curve) > size(patch)) {
      for (Part& half : halves(curve, 0)) {
        if (!bound(half)) return false;
        open.emplace_back(std::move(half), patch);
      }
      return true;
    }
    const auto length = [&](std::size_t axis) {
      double result = 0;
      for (std::size_t k = 0; k < 3; ++k) result = std::max(result, range_of(patch, k, 0, axis).magnitude());
      return result;
    };
    for (Part& half : halves(patch, length(0) >= length(1) ? 0 : 1)) {
      if (!bound(half)) return false;
      open.emplace_back(curve, std::move(half));
    }
    return true;
  }

  const ControlNet& curve_;
  const ControlNet& patch_;
  const CertifyNear& certify_;
  const Context& context_;
  std::vector<ParameterBox> zeros_;
};

}  // namespace

bool excludes_point(const ControlNet& patch, const PointBox& point, const Context& context) {
  const auto coordinate = [&](std::size_t k) { return Range{point[k][0], point[k][1]}; };
  const auto apart = [&](const Part& part) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        bool positive = true;
        bool negative = true;
        for (std::size_t p = 0; p < part.net.coordinates[0].size() && (positive || negative); ++p) {
          const auto control = [&](std::size_t k) {
            const double value = part.net.coordinates[k][p];
            return Range::widened(value - part.net.error, value + part.net.error);
          };
          const Range minor = control(i) * coordinate(j) - control(j) * coordinate(i);
          positive = positive && minor.lower > 0;
          negative = negative && minor.upper < 0;
        }
        if (positive || negative) return true;
      }
    return false;
  };
  std::vector<Part> open{Part{patch, {}, {1, 1}, {}}};
  constexpr int most_parts = 4000;
  for (int count = 0; !open.empty(); ++count) {
    if (count > most_parts) return false;
    if (count % 64 == 63) context.checkpoint("subdividing");
    const Part part = std::move(open.back());
    open.pop_back();
    if (apart(part)) continue;
    constexpr double smallest_width = 1e-6;
    if (std::max(part.width[0], part.width[1]) < smallest_width) return false;
    for (Part& half : halves(part, part.width[0] >= part.width[1] ? 0 : 1)) open.push_back(std::move(half));
  }
  return true;
}

std::optional<ControlNet> ControlNet::round(std::vector<std::size_t> degrees,
                                            const std::array<std::vector<symbolic::Rational>, 4>& coordinates) {
  ControlNet net;
  net.degrees = std::move(degrees);
  double size = 0;
  for (std::size_t k = 0; k < 4; ++k)
    for (const symbolic::Rational& value : coordinates[k]) {
      const RealBall ball(value, 64);
      const double rounded = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
      constexpr double safe = 1e60;
      if (!(std::fabs(rounded) < safe) || (rounded != 0 && std::fabs(rounded) < 1 / safe)) return std::nullopt;
      net.coordinates[k].push_back(rounded);
      size = std::max(size, std::fabs(rounded));
    }
  net.error = unit * size;
  return net;
}

std::optional<std::vector<ParameterBox>> bernstein_subdivision(const ControlNet& curve, const ControlNet& patch,
                                                               const CertifyNear& certify, const Context& context) {
  Subdivision subdivision(curve, patch, certify, context);
  if (!subdivision.run()) return std::nullopt;
  return std::move(subdivision).zeros();
}

}  // namespace eliminant::bridge
