// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/exact_contact.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/simple_fraction.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

constexpr std::size_t weight = 3;

/// What contact orders are looked for.
constexpr std::size_t highest_order = 5;

/// The contact series at all points of a box where the coordinates kept equal are equal.
struct BoxSeries {
  TaylorTable<DoubleInterval> curve;
  TaylorTable<DoubleInterval> other;
  ContactSeries<DoubleInterval> series;

  BoxSeries(const ControlNet& first, const ControlNet& second, const ContactFrame& frame, const OpenBox& box,
            std::size_t order)
      : curve(taylor_on_box(first, frame, box, 0, order)),
        other(taylor_on_box(second, frame, box, 1, order)),
        series(contact_series(curve, other, second.parameters())) {}

  bool weights_positive() const { return curve.at(0)[weight].lower > 0 && other.at(0)[weight].lower > 0; }

  /// For each parameter of the curve at most one point of the second is equal in the coordinates kept: the derivative
  /// by its parameters stays near one matrix, minus the identity in the frame of the contact.
  bool second_injective() const {
    const KeptCoordinates<DoubleInterval> kept(curve, other, other.parameters());
    const auto& jacobian = kept.jacobian;
    const std::size_t n = kept.count;
    const auto middle = [](const DoubleInterval& x) { return 0.5 * (x.lower + x.upper); };
    for (std::size_t r = 0; r < n; ++r) {
      const double diagonal = middle(jacobian[r][r]);
      double sum = 0;
      for (std::size_t p = 0; p < n; ++p)
        sum += (jacobian[r][p] - DoubleInterval(r == p ? diagonal : 0)).magnitude() / std::fabs(diagonal);
      if (!(sum < 0.99)) return false;
    }
    return true;
  }
};

/// Wide enough in the second's parameters for a branch along it.
OpenBox box_around(const std::array<double, 3>& parameters, const std::array<double, 2>& slopes, double reach) {
  OpenBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double half = k == 0 ? reach : reach * (0.25 + 1.25 * std::fabs(slopes[k - 1]));
    box.lower[k] = parameters[k] - half;
    box.upper[k] = parameters[k] + half;
  }
  return box;
}

bool is_near_domain(const OpenBox& box, std::size_t parameters) {
  constexpr double beyond = 0.3;
  for (std::size_t k = 0; k < parameters; ++k)
    if (!(box.lower[k] > -beyond && box.upper[k] < 1 + beyond && box.upper[k] - box.lower[k] < 1)) return false;
  return true;
}

/// The tangents of the second side, up to a factor, and a normal to them.
struct Tangents {
  std::array<std::array<double, 3>, 2> along{};
  std::array<double, 3> normal{};
};

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Tangents tangents(const TaylorTable<double>& second) {
  Tangents result;
  for (std::size_t p = 0; p < second.parameters(); ++p) {
    const std::array<double, 4>& slope = p == 0 ? second.at(1, 0) : second.at(0, 1);
    for (std::size_t k = 0; k < 3; ++k)
      result.along[p][k] = (slope[k] * second.at(0)[weight] - second.at(0)[k] * slope[weight]) /
                           (second.at(0)[weight] * second.at(0)[weight]);
  }
  if (second.parameters() == 1) result.along[1] = {0, 0, 1};
  result.normal = cross(result.along[0], result.along[1]);
  return result;
}

/// The coordinate in which the normal is largest; nullopt at a singular point.
std::optional<std::size_t> normal_coordinate(const TaylorTable<double>& second) {
  const std::array<double, 3> normal = tangents(second).normal;
  std::size_t result = 0;
  for (std::size_t k = 1; k <= second.parameters(); ++k)
    if (std::fabs(normal[k]) > std::fabs(normal[result])) result = k;
  if (!(std::fabs(normal[result]) > 0)) return std::nullopt;
  return result;
}

/// At a regular point of the second side.
ContactFrame contact_frame(const TaylorTable<double>& second) {
  ContactFrame frame;
  for (std::size_t k = 0; k < 3; ++k) frame.origin[static_cast<long>(k)] = second.at(0)[k] / second.at(0)[weight];
  const Tangents t = tangents(second);
  // Rows of the inverse of the matrix of tangents and normal, the normal in lane 1 in the plane.
  const double square = t.normal[0] * t.normal[0] + t.normal[1] * t.normal[1] + t.normal[2] * t.normal[2];
  const std::array<double, 3> first = cross(t.along[1], t.normal);
  const std::array<double, 3> other = cross(t.normal, t.along[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = first[k] / square;
    const double b = other[k] / square;
    const double n = t.normal[k] / std::sqrt(square);
    frame.columns[k] = second.parameters() == 1 ? Array4d(a, n, 0, 0) : Array4d(a, b, n, 0);
  }
  return frame;
}

std::optional<std::array<Rational, 3>> simple_fractions(const std::array<double, 3>& values, std::size_t count,
                                                        double accuracy) {
  std::array<Rational, 3> result;
  for (std::size_t k = 0; k < count; ++k) {
    const std::optional<Rational> fraction = simple_fraction(values[k], accuracy);
    if (!fraction) return std::nullopt;
    result[k] = *fraction;
  }
  return result;
}

/// Where the difference vanishes to a high order, as doubles see it.
struct Approach {
  std::array<double, 3> parameters;
  std::size_t normal;
  std::array<double, 2> slopes;
};

std::optional<Approach> approach(const ControlNet& first, const ControlNet& second, const std::array<double, 3>& start,
                                 double reach, std::size_t order) {
  Approach result{start, 0, {}};
  std::array<double, 3>& at = result.parameters;
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps; ++step) {
    for (std::size_t k = 0; k < 1 + second.parameters(); ++k)
      if (!(std::fabs(at[k] - start[k]) < 4 * reach)) return std::nullopt;
    const TaylorTable<double> a = taylor_near(first, at[0], 0, order);
    const TaylorTable<double> b = taylor_near(second, at[1], at[2], order);
    const std::optional<std::size_t> normal = normal_coordinate(b);
    if (!normal) return std::nullopt;
    result.normal = *normal;
    const ContactSeries<double> series = contact_series(a, b, *normal);
    // The second side is led to the first in the coordinates kept equal, then both along until the derivative of order
    // k - 1 vanishes.
    const KeptCoordinates<double> kept(a, b, *normal);
    std::array<double, 2> differences{};
    for (std::size_t r = 0; r < kept.count; ++r)
      differences[r] = a.at(0)[kept.index[r]] * b.at(0)[weight] - b.at(0)[kept.index[r]] * a.at(0)[weight];
    const std::array<double, 2> correction = kept.correction(differences);
    const double along = -series.difference[order - 1] / (static_cast<double>(order) * series.difference[order]);
    double largest = std::fabs(along);
    at[0] += along;
    for (std::size_t p = 0; p < second.parameters(); ++p) {
      const double change = correction[p] + along * series.second[p][1];
      at[1 + p] += change;
      largest = std::max(largest, std::fabs(change));
      result.slopes[p] = series.second[p][1];
    }
    if (!std::isfinite(largest)) return std::nullopt;
    constexpr double at_rest = 1e-12;
    if (largest > at_rest) continue;
    // A contact of that order, as far as doubles can tell.
    double size = 0;
    for (std::size_t i = 0; i <= order; ++i)
      for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::fabs(a.at(i)[k]));
    constexpr double tiny = 1e-10;
    for (std::size_t k = 0; k + 1 < order; ++k)
      if (!(std::fabs(series.difference[k]) <= tiny * size * b.at(0)[weight])) return std::nullopt;
    constexpr double small = 1e-7;
    if (!(std::fabs(series.difference[order]) > small * size * b.at(0)[weight])) return std::nullopt;
    return result;
  }
  return std::nullopt;
}

/// Whether the coordinates other than the normal one have an invertible derivative by the second's parameters, exactly:
/// in doubles a singular point at parameters that are not dyadic does not look like one.
bool is_graph_over_kept(const TaylorTable<Rational>& curve, const TaylorTable<Rational>& second, std::size_t normal) {
  return !KeptCoordinates<Rational>(curve, second, normal).determinant().is_zero();
}

}  // namespace

IsolatedZero rounded_parameters(const std::array<Rational, 3>& parameters) {
  IsolatedZero result;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    constexpr long double_bits = 53;
    const RealBall ball(parameters[k], double_bits);
    result.parameters[k] = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
    if (arb_is_exact(ball.get()) == 0) result.radius = 0x1p-52;
  }
  return result;
}

bool ContactProver::is_common_point(const std::array<Rational, 3>& parameters) const {
  const TaylorTable<Rational> a = taylor_at(exact_first_(), {parameters[0], Rational(0)}, 0);
  const TaylorTable<Rational> b = taylor_at(exact_second_(), {parameters[1], parameters[2]}, 0);
  if (a.at(0)[weight].is_zero() || b.at(0)[weight].is_zero()) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(a.at(0)[k] * b.at(0)[weight] == b.at(0)[k] * a.at(0)[weight])) return false;
  return true;
}

std::optional<std::array<Rational, 3>> ContactProver::exact_zero(const IsolatedZero& zero) const {
  constexpr double least_accuracy = 1e-9;
  if (!(zero.radius < least_accuracy)) return std::nullopt;
  std::optional<std::array<Rational, 3>> result =
      simple_fractions(zero.parameters, 1 + second_.parameters(), zero.radius);
  if (!result || !is_common_point(*result)) return std::nullopt;
  return result;
}

bool ContactProver::vanishes_to(const ExactTables& tables, std::size_t normal, std::size_t order) {
  const ContactSeries<Rational> series =
      contact_series(tables.first.truncated(order - 1), tables.second.truncated(order - 1), normal);
  return std::all_of(series.difference.begin(), series.difference.end(),
                     [](const Rational& coefficient) { return coefficient.is_zero(); });
}

std::optional<OpenBox> ContactProver::alone_around(const ExactTables& tables, const std::array<double, 3>& parameters,
                                                   std::size_t order, const std::array<double, 2>& slopes) const {
  const ContactFrame frame = contact_frame(taylor_near(second_, parameters[1], parameters[2], 1));
  const DoubleInterval at_contact = contact_series(enclosed(tables.first, first_, frame),
                                                   enclosed(tables.second, second_, frame), second_.parameters())
                                        .difference[order];
  constexpr double widest = 0x1p-2;
  constexpr double narrowest = 0x1p-12;
  for (double reach = widest; reach >= narrowest; reach *= 0.5) {
    const OpenBox box = box_around(parameters, slopes, reach);
    if (!is_near_domain(box, 1 + second_.parameters())) continue;
    const BoxSeries on_box(first_, second_, frame, box, order + 1);
    if (!on_box.weights_positive() || !on_box.second_injective()) continue;
    // A branch of the second that stays in the box as long as the parameter of the first does.
    bool stays = true;
    for (std::size_t p = 0; p < second_.parameters(); ++p)
      stays = stays && on_box.series.second[p][1].magnitude() * reach < 0.499 * (box.upper[1 + p] - box.lower[1 + p]);
    if (!stays) continue;
    // The k-th derivative, straight or by its mean value form.
    const DoubleInterval step(-reach * (1 + 1e-9), reach * (1 + 1e-9));
    const DoubleInterval mean =
        at_contact + DoubleInterval(static_cast<double>(order + 1)) * on_box.series.difference[order + 1] * step;
    const auto one_sign = [](const DoubleInterval& x) { return x.excludes_zero() && x.is_finite(); };
    if (one_sign(on_box.series.difference[order]) || one_sign(mean)) return box;
  }
  return std::nullopt;
}

std::optional<OpenBox> ContactProver::find(const std::array<double, 3>& near, double reach) {
  for (std::size_t order = 2; order <= highest_order; ++order) {
    const std::optional<Approach> found = approach(first_, second_, near, reach, order);
    if (!found) continue;
    const auto& at = found->parameters;
    const auto is_there = [&](const RationalZero& contact) {
      for (std::size_t k = 0; k < 1 + second_.parameters(); ++k)
        if (at[k] < contact.alone_in.lower[k] || at[k] > contact.alone_in.upper[k]) return false;
      return true;
    };
    if (std::any_of(contacts_.begin(), contacts_.end(), is_there)) return std::nullopt;
    constexpr double accuracy = 1e-11;
    const auto exact = simple_fractions(at, 1 + second_.parameters(), accuracy);
    if (!exact || !is_common_point(*exact)) continue;
    const ExactTables tables{taylor_at(exact_first_(), {(*exact)[0], Rational(0)}, order),
                             taylor_at(exact_second_(), {(*exact)[1], (*exact)[2]}, order)};
    if (!is_graph_over_kept(tables.first, tables.second, found->normal) || !vanishes_to(tables, found->normal, order))
      continue;
    const std::optional<OpenBox> box =
        alone_around(tables, rounded_parameters(*exact).parameters, order, found->slopes);
    if (!box) continue;
    contacts_.push_back({*exact, order, *box});
    return box;
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
