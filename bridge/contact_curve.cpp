// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contact_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include <eliminant/bridge/enclosed_patch.hpp>
#include <eliminant/bridge/patch_jets.hpp>
#include <eliminant/bridge/taylor_tables.hpp>

namespace eliminant::bridge {

namespace {

using Place = std::array<double, 2>;

constexpr std::size_t weight = 3;
/// Index of the coordinate along the normal in a frame.
constexpr std::size_t normal = 2;

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
Place unit(const Place& a) {
  const double length = std::hypot(a[0], a[1]);
  return {a[0] / length, a[1] / length};
}

DoubleInterval symmetric(double reach) { return {-reach, reach}; }

/// The table of a patch along a line of its parameters.
template <class Scalar>
TaylorTable<Scalar> along_line(const TaylorTable<Scalar>& patch, const Place& direction) {
  TaylorTable<Scalar> line(1, patch.order());
  for (std::size_t n = 0; n <= patch.order(); ++n)
    for (std::size_t k = 0; k < 4; ++k) {
      Scalar sum(0);
      for (std::size_t i = 0; i <= n; ++i) {
        Scalar term = patch.at(i, n - i)[k];
        for (std::size_t p = 0; p < n; ++p) term = term * Scalar(direction[p < i ? 0 : 1]);
        sum = sum + term;
      }
      line.at(n)[k] = sum;
    }
  return line;
}

/// The table of a patch in parameters (p, q) with s = m00 p + m01 q, t = m10 p + m11 q.
template <class Scalar>
TaylorTable<Scalar> in_parameters(const TaylorTable<Scalar>& patch, const Eigen::Matrix2d& m) {
  TaylorTable<Scalar> result(2, patch.order());
  for (std::size_t i = 0; i <= patch.order(); ++i)
    for (std::size_t j = 0; i + j <= patch.order(); ++j) result.at(i, j).fill(Scalar(0));
  for (std::size_t i = 0; i <= patch.order(); ++i)
    for (std::size_t j = 0; i + j <= patch.order(); ++j) {
      // The form s^i t^j by powers of p.
      std::vector<Scalar> form{Scalar(1)};
      for (std::size_t factor = 0; factor < i + j; ++factor) {
        const long row = factor < i ? 0 : 1;
        std::vector<Scalar> next(form.size() + 1, Scalar(0));
        for (std::size_t a = 0; a < form.size(); ++a) {
          next[a + 1] = next[a + 1] + form[a] * Scalar(m(row, 0));
          next[a] = next[a] + form[a] * Scalar(m(row, 1));
        }
        form = std::move(next);
      }
      for (std::size_t a = 0; a < form.size(); ++a)
        for (std::size_t k = 0; k < 4; ++k)
          result.at(a, i + j - a)[k] = result.at(a, i + j - a)[k] + form[a] * patch.at(i, j)[k];
    }
  return result;
}

void to_frame(const ContactFrame& frame, TaylorTable<double>& table) {
  for (std::size_t i = 0; i <= table.order(); ++i)
    for (std::size_t j = 0; i + j <= table.order(); ++j) {
      std::array<double, 4>& p = table.at(i, j);
      Array4d sum = Array4d::Zero();
      for (std::size_t k = 0; k < 3; ++k) sum += frame.columns[k] * (p[k] - frame.origin[static_cast<long>(k)] * p[3]);
      for (std::size_t k = 0; k < 3; ++k) p[k] = sum[static_cast<long>(k)];
    }
}

/// The parameters of the second patch by the coordinates in the tangent plane, to first order.
std::optional<Eigen::Matrix2d> parameters_by_plane(const ContactFrame& frame, const PatchJets::Value& second) {
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) {
      const Array4d& d = second.first[static_cast<std::size_t>(k)];
      derivative(row, k) = d[0] * frame.columns[0][row] + d[1] * frame.columns[1][row] + d[2] * frame.columns[2][row];
    }
  const Eigen::Matrix2d inverse = derivative.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  return inverse;
}

double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

}  // namespace

/// A parallelogram of the base's parameters around a piece of the curve that meets all its lines across, and both
/// patches over it.
struct ContactCurve::Region {
  Place origin{};
  Place across{};
  Place along{};
  /// Of coordinates across and along.
  double reach = 0;
  double length = 0;
  /// How much the curve moves across where it moves by one along, and how much that changes.
  DoubleInterval slope;
  DoubleInterval bend;
  TaylorTable<DoubleInterval> base{2, 0};
  TaylorTable<DoubleInterval> other{2, 0};
  /// The parameters of the other patch.
  Place lower_of_other{};
  Place upper_of_other{};
  /// Bounds |ds| + |dt| where both parameters of the base move by at most one.
  double following = 0;

  /// The derivative of h of an order in a direction, on the whole parallelogram.
  DoubleInterval derivative(const Place& direction, std::size_t order) const {
    const ContactSeries<DoubleInterval> series =
        contact_series(along_line(base.truncated(order), direction), other.truncated(order), normal);
    return DoubleInterval(factorial(order)) * series.difference[order];
  }
};

/// Both patches at a point of the curve, approximately, in the frame of the base.
struct ContactCurve::Tables {
  TaylorTable<double> base;
  TaylorTable<double> other;

  double derivative(const Place& direction, std::size_t order) const {
    const TaylorTable<double> line = along_line(base.truncated(order), direction);
    return factorial(order) * contact_series(line, other.truncated(order), normal).difference[order];
  }
};

/// The derivatives of h of orders two to four on a parallelogram as forms in x across and y along the curve.
struct ContactCurve::Forms {
  DoubleInterval xx;
  DoubleInterval xxx;
  DoubleInterval xxy;
  DoubleInterval xxxx;
  DoubleInterval xxxy;
  DoubleInterval xxyy;
};

ContactCurve::ContactCurve(const ControlNet& base, const ControlNet& other, symbolic::ContactRelation relation,
                           bool swapped)
    : base_(base), other_(other), relation_(std::move(relation)), swapped_(swapped), curve_(relation_.curve) {
  for (std::size_t k = 0; k < 2; ++k) {
    by_[k] = curve_.derivative(k);
    numerator_[k] = IntervalPolynomial(relation_.numerator[k]);
    denominator_[k] = IntervalPolynomial(relation_.denominator[k]);
  }
}

std::array<double, 4> ContactCurve::parameters_at(const Place& base) const {
  std::array<double, 4> result{base[0], base[1], 0, 0};
  for (std::size_t k = 0; k < 2; ++k)
    result[2 + k] = numerator_[k].near(base[0], base[1]) / denominator_[k].near(base[0], base[1]);
  if (swapped_) result = {result[2], result[3], result[0], result[1]};
  return result;
}

double ContactCurve::distance_from(const Place& base) const {
  const Place slope = gradient(base);
  return curve_.near(base[0], base[1]) / std::hypot(slope[0], slope[1]);
}

std::array<double, 3> ContactCurve::point_at(const Place& base) const {
  const Array4d point = PatchJets(base_).at(base[0], base[1]).point;
  return {point[0], point[1], point[2]};
}

std::optional<std::array<double, 4>> ContactCurve::point_on_cut(std::size_t axis,
                                                                const std::array<double, 4>& near) const {
  const std::size_t first = swapped_ ? 2 : 0;
  Place at{near[first], near[first + 1]};
  constexpr int most_steps = 15;
  for (int step = 0; step < most_steps; ++step) {
    // The equation of the curve, and that of the cut.
    const Place slope = gradient(at);
    const double value = curve_.near(at[0], at[1]);
    Place cut_slope{};
    const double cut = parameters_at(at)[axis] - near[axis];
    for (std::size_t k = 0; k < 2; ++k) {
      constexpr double small = 0x1p-20;
      Place beside = at;
      beside[k] += small;
      cut_slope[k] = (parameters_at(beside)[axis] - near[axis] - cut) / small;
    }
    const double area = cross(slope, cut_slope);
    const Place change{(value * cut_slope[1] - cut * slope[1]) / area, (slope[0] * cut - cut_slope[0] * value) / area};
    at = {at[0] - change[0], at[1] - change[1]};
    const double size = std::max(std::fabs(change[0]), std::fabs(change[1]));
    if (!(size < 1)) return std::nullopt;
    if (size < 1e-12) return parameters_at(at);
  }
  return std::nullopt;
}

CellBox ContactCurve::in_base_order(const CellBox& box) const {
  if (!swapped_) return box;
  return {{box.lower[2], box.lower[3], box.lower[0], box.lower[1]},
          {box.upper[2], box.upper[3], box.upper[0], box.upper[1]}};
}

Place ContactCurve::gradient(const Place& at) const { return {by_[0].near(at[0], at[1]), by_[1].near(at[0], at[1])}; }

Place ContactCurve::nearest(Place at) const {
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const Place slope = gradient(at);
    const double by = curve_.near(at[0], at[1]) / dot(slope, slope);
    if (!std::isfinite(by)) break;
    at = {at[0] - by * slope[0], at[1] - by * slope[1]};
    if (std::fabs(by) * std::hypot(slope[0], slope[1]) < 1e-15) break;
  }
  return at;
}

std::optional<ContactCurve::Region> ContactCurve::region(const CellBox& box, const Place& origin, const Place& across,
                                                         const Place& along, std::size_t order) const {
  Region result;
  result.origin = origin;
  result.across = across;
  result.along = along;
  // Around the cell.
  const double area = cross(across, along);
  for (const double a : {box.lower[0], box.upper[0]})
    for (const double b : {box.lower[1], box.upper[1]}) {
      const Place corner{a - origin[0], b - origin[1]};
      result.reach = std::max(result.reach, std::fabs(cross(corner, along) / area));
      result.length = std::max(result.length, std::fabs(cross(across, corner) / area));
    }
  constexpr double rounding = 1 + 1e-9;
  result.length = result.length * rounding + 1e-12;
  const IntervalPolynomial curve = curve_.in_frame(origin, across, along);
  const DoubleInterval lines = symmetric(result.length);
  // The curve leaves through both ends, and not through the sides.
  const double steepness = std::fabs(curve.derivative(0).near(0, 0));
  const double far = 1.3 * curve.on(DoubleInterval(0), lines).magnitude() / steepness;
  result.reach = std::max(result.reach * rounding, far) + 1e-12;
  if (!(result.reach < 1) || !(result.length < 1)) return std::nullopt;
  const DoubleInterval right = curve.on(DoubleInterval(result.reach), lines);
  const DoubleInterval left = curve.on(DoubleInterval(-result.reach), lines);
  if (!right.excludes_zero() || !left.excludes_zero() || (right.lower > 0) == (left.lower > 0)) return std::nullopt;
  const DoubleInterval all = symmetric(result.reach);
  const IntervalPolynomial by_x = curve.derivative(0);
  const IntervalPolynomial by_y = curve.derivative(1);
  const DoubleInterval steep = by_x.on(all, lines);
  result.slope = -by_y.on(all, lines) / steep;
  result.bend =
      -(by_y.derivative(1).on(all, lines) + DoubleInterval(2) * result.slope * by_x.derivative(1).on(all, lines) +
        result.slope * result.slope * by_x.derivative(0).on(all, lines)) /
      steep;
  if (!result.slope.is_finite() || !result.bend.is_finite()) return std::nullopt;

  OpenBox of_base{};
  constexpr double beyond = 0.25;
  for (std::size_t k = 0; k < 2; ++k) {
    const double half = (result.reach * std::fabs(across[k]) + result.length * std::fabs(along[k])) * rounding;
    of_base.lower[k] = origin[k] - half;
    of_base.upper[k] = origin[k] + half;
    if (of_base.lower[k] < -beyond || of_base.upper[k] > 1 + beyond) return std::nullopt;
  }
  // The other patch: where the curve is, the cell is, and all points are that are equal along the tangent plane.
  OpenBox of_other{};
  Place middle{};
  for (std::size_t k = 0; k < 2; ++k) {
    const DoubleInterval on_curve = numerator_[k].in_frame(origin, across, along).on(all, lines) /
                                    denominator_[k].in_frame(origin, across, along).on(all, lines);
    if (!on_curve.is_finite()) return std::nullopt;
    of_other.lower[k] = std::min(on_curve.lower, box.lower[2 + k]);
    of_other.upper[k] = std::max(on_curve.upper, box.upper[2 + k]);
    middle[k] = numerator_[k].near(origin[0], origin[1]) / denominator_[k].near(origin[0], origin[1]);
  }
  const auto frame = tangent_frame(PatchJets(base_).at(origin[0], origin[1]));
  if (!frame) return std::nullopt;
  const auto by_plane = parameters_by_plane(*frame, PatchJets(other_).at(middle[0], middle[1]));
  if (!by_plane) return std::nullopt;
  result.base = taylor_on_box(base_, *frame, of_base, 0, order);
  const EnclosedPatch enclosed_base(result.base.truncated(2));
  for (std::size_t k = 0; k < 2; ++k) {
    const auto row = static_cast<long>(k);
    const double half = 1.6 * (std::fabs((*by_plane)(row, 0)) * enclosed_base.value[0].magnitude() +
                               std::fabs((*by_plane)(row, 1)) * enclosed_base.value[1].magnitude());
    of_other.lower[k] = std::min(of_other.lower[k], middle[k] - half);
    of_other.upper[k] = std::max(of_other.upper[k], middle[k] + half);
    result.lower_of_other[k] = of_other.lower[k];
    result.upper_of_other[k] = of_other.upper[k];
    if (!(of_other.lower[k] > -beyond) || !(of_other.upper[k] < 1 + beyond)) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i)
      result.following += 1.6 * (std::fabs((*by_plane)(row, 0)) * enclosed_base.first[i][0].magnitude() +
                                 std::fabs((*by_plane)(row, 1)) * enclosed_base.first[i][1].magnitude());
  }
  result.other = in_parameters(taylor_on_box(other_, *frame, of_other, 0, order), *by_plane);
  if (!(result.base.at(0, 0)[weight].lower > 0) || !(result.other.at(0, 0)[weight].lower > 0)) return std::nullopt;
  // In these parameters the derivative along the tangent plane is near the identity: the function exists, and is one.
  const EnclosedPatch enclosed_other(result.other.truncated(2));
  constexpr double at_most = 0.3;
  for (std::size_t c = 0; c < 2; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k)
      sum += (enclosed_other.first[k][c] - DoubleInterval(c == k ? 1 : 0)).magnitude();
    if (!(sum < at_most)) return std::nullopt;
  }
  return result;
}

ContactCurve::Forms ContactCurve::forms_on(const Region& region) const {
  const Place& x = region.across;
  const Place& y = region.along;
  const auto combination = [&](double p, double q) { return Place{p * x[0] + q * y[0], p * x[1] + q * y[1]}; };
  const auto fourth = [&](double p, double q) { return region.derivative(combination(p, q), 4); };
  // By polarisation.
  const DoubleInterval xxxx = fourth(1, 0);
  const DoubleInterval yyyy = fourth(0, 1);
  const DoubleInterval plus = fourth(1, 1);
  const DoubleInterval minus = fourth(1, -1);
  Forms forms;
  forms.xxxx = xxxx;
  forms.xxyy = (plus + minus - DoubleInterval(2) * (xxxx + yyyy)) / DoubleInterval(12);
  forms.xxxy = (fourth(2, 1) - fourth(2, -1) - DoubleInterval(2) * (plus - minus)) / DoubleInterval(48);
  // What is known at the origin, and by how much it changes: both patches alike bend more than their difference.
  const auto tables = tables_near(region.origin, 3);
  const auto near = [&](double p, double q, std::size_t order) {
    return tables ? tables->derivative(combination(p, q), order) : std::nan("");
  };
  const double third = near(1, 0, 3);
  const double mixed = (near(1, 1, 3) - near(1, -1, 3) - 2 * near(0, 1, 3)) / 6;
  const DoubleInterval across(-region.reach, region.reach);
  const DoubleInterval along(-region.length, region.length);
  const DoubleInterval third_here = DoubleInterval::around(third, rounding_of_derivative(3));
  const DoubleInterval mixed_here = DoubleInterval::around(mixed, 4 * rounding_of_derivative(3));
  forms.xxx = third_here + across * forms.xxxx + along * forms.xxxy;
  forms.xxy = mixed_here + across * forms.xxxy + along * forms.xxyy;
  const auto square = [](double half) { return DoubleInterval(0, half * half * (1 + 1e-12)); };
  forms.xx = DoubleInterval::around(near(1, 0, 2), rounding_of_derivative(2)) + across * third_here +
             along * mixed_here + DoubleInterval(0.5) * square(region.reach) * forms.xxxx +
             across * along * forms.xxxy + DoubleInterval(0.5) * square(region.length) * forms.xxyy;
  return forms;
}

double ContactCurve::rounding_of_derivative(std::size_t order) const {
  double sum = 0;
  double heaviest = 1;
  for (const ControlNet* net : {&base_, &other_}) {
    double extent = 0;
    for (const Array4d& point : net->points) {
      extent = std::max(extent, point.abs().head<3>().maxCoeff());
      heaviest = std::max(heaviest, point[3]);
    }
    const auto degree = static_cast<double>(net->degrees[0] + net->degrees[1]);
    sum += extent * std::pow(degree, 2 * static_cast<double>(order));
  }
  return 0x1p-46 * heaviest * sum;
}

bool ContactCurve::Explained::covers(const CellBox& box) const {
  for (std::size_t k = 0; k < 2; ++k)
    if (box.lower[2 + k] < lower[k] || box.upper[2 + k] > upper[k]) return false;
  const double area = cross(across, along);
  for (const double a : {box.lower[0], box.upper[0]})
    for (const double b : {box.lower[1], box.upper[1]}) {
      const Place corner{a - origin[0], b - origin[1]};
      if (!(std::fabs(cross(corner, along) / area) < reach) || !(std::fabs(cross(across, corner) / area) < length))
        return false;
    }
  return true;
}

bool ContactCurve::is_explained(const CellBox& asked) const {
  const CellBox box = in_base_order(asked);
  return std::any_of(explained_.rbegin(), explained_.rend(), [&](const Explained& e) { return e.covers(box); });
}

bool ContactCurve::explains(const CellBox& asked) {
  const CellBox box = in_base_order(asked);
  const Place middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
  Place origin = nearest(middle);
  // Only around the curve.
  const double size = std::max({box.upper[0] - box.lower[0], box.upper[1] - box.lower[1], 1e-6});
  if (!(std::hypot(origin[0] - middle[0], origin[1] - middle[1]) < 2 * size)) return false;
  const auto has_one_sign = [](const DoubleInterval& x) { return x.is_finite() && x.excludes_zero(); };
  Place across = unit(gradient(origin));
  Place along{-across[1], across[0]};
  // On a cut its own direction will do.
  constexpr double thin = 1e-6;
  const std::array<double, 2> width{box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]};
  const bool is_cut = std::min(width[0], width[1]) < thin * std::max(width[0], width[1]);
  if (is_cut) {
    const std::size_t kept = width[0] < width[1] ? 0 : 1;
    // Where the cut meets the curve.
    Place at{middle[0], middle[1]};
    for (int step = 0; step < 10; ++step) at[1 - kept] -= curve_.near(at[0], at[1]) / gradient(at)[1 - kept];
    if (!(std::fabs(at[1 - kept] - middle[1 - kept]) < 2 * size)) return false;
    origin = at;
    across = {kept == 0 ? 0.0 : 1.0, kept == 0 ? 1.0 : 0.0};
    along = {kept == 0 ? 1.0 : 0.0, kept == 0 ? 0.0 : 1.0};
  }
  const auto around = region(box, origin, across, along, 4);
  if (!around) return false;
  // More often than not, larger cells are not worth a closer look.
  constexpr double small = 0.125;
  const bool is_small = around->reach < small && around->length < small;
  if (!has_one_sign(around->derivative(across, 2)) &&
      !(is_small && has_one_sign(is_cut ? bend_on_cut(*around) : forms_on(*around).xx)))
    return false;
  constexpr double inside = 1 - 1e-9;
  if (!is_cut)
    explained_.push_back({origin, across, along, around->reach * inside, around->length * inside,
                          around->lower_of_other, around->upper_of_other});
  return true;
}

DoubleInterval ContactCurve::bend_on_cut(const Region& region) const {
  const auto tables = tables_near(region.origin, 3);
  if (!tables) return {};
  const DoubleInterval across(-region.reach, region.reach);
  const DoubleInterval along(-region.length, region.length);
  const auto here = [&](std::size_t order) {
    return DoubleInterval::around(tables->derivative(region.across, order), rounding_of_derivative(order));
  };
  // Along the cut by Taylor's formula; it hardly has a width.
  const Place sum{region.across[0] + region.along[0], region.across[1] + region.along[1]};
  const Place difference{region.across[0] - region.along[0], region.across[1] - region.along[1]};
  const DoubleInterval mixed = (region.derivative(sum, 3) - region.derivative(difference, 3) -
                                DoubleInterval(2) * region.derivative(region.along, 3)) /
                               DoubleInterval(6);
  const double square = region.reach * region.reach * (1 + 1e-12);
  return here(2) + across * here(3) + DoubleInterval(0, 0.5 * square) * region.derivative(region.across, 4) +
         along * mixed;
}

std::optional<ContactCurve::Tables> ContactCurve::tables_near(const Place& at, std::size_t order) const {
  const auto frame = tangent_frame(PatchJets(base_).at(at[0], at[1]));
  if (!frame) return std::nullopt;
  const Place there{numerator_[0].near(at[0], at[1]) / denominator_[0].near(at[0], at[1]),
                    numerator_[1].near(at[0], at[1]) / denominator_[1].near(at[0], at[1])};
  Tables tables{taylor_near(base_, at[0], at[1], order), taylor_near(other_, there[0], there[1], order)};
  to_frame(*frame, tables.base);
  to_frame(*frame, tables.other);
  return tables;
}

double ContactCurve::derivative_near(const Place& at, const Place& direction, std::size_t order) const {
  const auto tables = tables_near(at, order);
  return tables ? tables->derivative(direction, order) : std::nan("");
}

std::optional<Place> ContactCurve::crossing_near(const Place& start, double reach) const {
  // The secant method along the curve.
  const auto bend_at = [&](const Place& at) { return derivative_near(at, unit(gradient(at)), 2); };
  const auto moved = [&](const Place& at, double by) {
    const Place across = unit(gradient(at));
    return nearest({at[0] - by * across[1], at[1] + by * across[0]});
  };
  Place here = start;
  double bend = bend_at(here);
  double step = 0.125 * reach;
  constexpr int most_steps = 25;
  for (int i = 0; i < most_steps; ++i) {
    const Place next = moved(here, step);
    const double next_bend = bend_at(next);
    const double slope = (next_bend - bend) / step;
    if (!std::isfinite(slope) || slope == 0) return std::nullopt;
    if (!(std::hypot(next[0] - start[0], next[1] - start[1]) < reach)) return std::nullopt;
    here = next;
    bend = next_bend;
    step = -bend / slope;
    if (!(std::fabs(step) < reach)) return std::nullopt;
    if (std::fabs(step) < 1e-13) return here;
  }
  return std::fabs(step) < 1e-9 ? std::optional(here) : std::nullopt;
}

std::optional<CurveCrossing> ContactCurve::crossing(const CellBox& asked) const {
  const CellBox box = in_base_order(asked);
  const Place middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
  const double size = std::max(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
  const Place start = nearest(middle);
  if (!(std::hypot(start[0] - middle[0], start[1] - middle[1]) < 2 * size)) return std::nullopt;
  const auto found = crossing_near(start, 4 * size);
  if (!found) return std::nullopt;
  const Place origin = *found;
  const Place steepest = unit(gradient(origin));
  const Place along{-steepest[1], steepest[0]};
  // Across the curve and the branch alike.
  Place across = steepest;
  double largest = 0;
  for (const double turn : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const Place direction{std::cos(turn) * steepest[0] + std::sin(turn) * along[0],
                          std::cos(turn) * steepest[1] + std::sin(turn) * along[1]};
    const double third = std::fabs(derivative_near(origin, direction, 3));
    if (third > largest * 1.25) {
      largest = third;
      across = direction;
    }
  }
  const auto around = region(box, origin, across, along, 4);
  if (!around) return std::nullopt;
  const Forms forms = forms_on(*around);
  if (!forms.xxx.is_finite() || !forms.xxx.excludes_zero()) return std::nullopt;
  const DoubleInterval turning = forms.xxy + forms.xxx * around->slope;
  if (!turning.is_finite() || !turning.excludes_zero()) return std::nullopt;

  // Newton's step from the origin, where h is known to roundings.
  const double bend = std::fabs(derivative_near(origin, across, 2)) + rounding_of_derivative(2);
  const double least = std::min(std::fabs(turning.lower), std::fabs(turning.upper));
  const double shift = bend / least + 1e-14;
  if (!(shift < 0.5 * around->length)) return std::nullopt;
  CurveCrossing result;
  result.parameters = parameters_at(origin);
  const double moved = shift * (1 + around->slope.magnitude());
  result.radius = moved * (1 + around->following);
  bool outside = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const double at = result.parameters[k];
    result.inside = result.inside && at - result.radius > asked.lower[k] && at + result.radius < asked.upper[k];
    outside = outside || at + result.radius < asked.lower[k] || at - result.radius > asked.upper[k];
  }
  if (!result.inside && !outside) return std::nullopt;
  const double area = cross(across, along);
  const std::size_t first = swapped_ ? 2 : 0;
  result.growing[first] = -across[1] / area;
  result.growing[first + 1] = across[0] / area;

  result.origin = origin;
  result.across = across;
  result.along = along;
  result.reach = around->reach;
  result.length = around->length;
  result.least_third = std::min(std::fabs(forms.xxx.lower), std::fabs(forms.xxx.upper));
  // The offset of the branch from the curve is where the divided difference vanishes, an average of second derivatives.
  const DoubleInterval offset_slope = -(DoubleInterval(3) * turning) / forms.xxx;
  const DoubleInterval moving_third = forms.xxxy + around->slope * forms.xxxx;
  const DoubleInterval turning_twice = forms.xxyy + DoubleInterval(2) * around->slope * forms.xxxy +
                                       around->slope * around->slope * forms.xxxx + around->bend * forms.xxx;
  const DoubleInterval offset_bend =
      -(DoubleInterval(3) * turning_twice + DoubleInterval(2) * moving_third * offset_slope +
        DoubleInterval(0.5) * forms.xxxx * offset_slope * offset_slope) /
      forms.xxx;
  result.branch_slope = (around->slope + offset_slope).magnitude();
  result.branch_bend = (around->bend + offset_bend).magnitude();
  // In a smaller box more is known of the branch.
  double extent = 0;
  for (const Array4d& point : base_.points) extent = std::max(extent, point.abs().head<3>().maxCoeff());
  constexpr double accuracy = 1e-6;
  constexpr double pieces = 512;
  if (!(chord_error(result, result.length / pieces, 0) < accuracy * extent)) return std::nullopt;
  return result;
}

std::optional<BranchPoint> ContactCurve::branch_point(const CurveCrossing& crossing, double x, double y) const {
  const auto place = [&](double across) {
    return Place{crossing.origin[0] + across * crossing.across[0] + y * crossing.along[0],
                 crossing.origin[1] + across * crossing.across[1] + y * crossing.along[1]};
  };
  PatchJets base(base_);
  PatchJets other(other_);
  const auto frame = tangent_frame(base.at(crossing.origin[0], crossing.origin[1]));
  if (!frame) return std::nullopt;
  // The curve at y.
  double on_curve = 0;
  for (int step = 0; step < 8; ++step) {
    const Place at = place(on_curve);
    on_curve -= curve_.near(at[0], at[1]) / dot(gradient(at), crossing.across);
  }
  const auto in_frame = [&](const Array4d& d) {
    return Array4d(frame->columns[0] * d[0] + frame->columns[1] * d[1] + frame->columns[2] * d[2]);
  };
  BranchPoint result;
  double residual = 0;
  double slack = 0;
  // The difference of the patches along the normal, once they are equal along the plane.
  const auto difference_at = [&](double across) {
    const Place at = place(across);
    const PatchJets::Value a = base.at(at[0], at[1]);
    std::array<double, 4> both = parameters_at(at);
    if (swapped_) both = {both[2], both[3], both[0], both[1]};
    PatchJets::Value b = other.at(both[2], both[3]);
    Array4d difference = in_frame(a.point - b.point);
    for (int step = 0; step < 5; ++step) {
      const auto by_plane = parameters_by_plane(*frame, b);
      if (!by_plane) break;
      const Eigen::Vector2d change = *by_plane * Eigen::Vector2d(difference[0], difference[1]);
      both[2] += change[0];
      both[3] += change[1];
      b = other.at(both[2], both[3]);
      difference = in_frame(a.point - b.point);
      if (!(change.lpNorm<Eigen::Infinity>() > 1e-14)) break;
    }
    for (std::size_t k = 0; k < 3; ++k) result.point[k] = a.point[static_cast<long>(k)];
    result.parameters = swapped_ ? std::array<double, 4>{both[2], both[3], at[0], at[1]} : both;
    residual = difference[2];
    slack = 4 * (a.error + b.error);
    return residual / ((across - on_curve) * (across - on_curve));
  };
  // The secant method on the divided difference, which is nearly linear.
  double before = x + 0.01 * (x - on_curve);
  double before_value = difference_at(before);
  double here = x;
  double value = difference_at(here);
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && value != before_value; ++step) {
    const double next = here - value * (here - before) / (value - before_value);
    if (!(std::fabs(next) < 2 * crossing.reach) || next == on_curve) return std::nullopt;
    before = std::exchange(here, next);
    before_value = std::exchange(value, difference_at(next));
    if (std::fabs(here - before) < 1e-12) break;
  }
  double heaviest = 1;
  for (const ControlNet* net : {&base_, &other_}) {
    double most = 0;
    for (const Array4d& point : net->points) most = std::max(most, point[3]);
    heaviest *= most;
  }
  const double offset = std::fabs(here - on_curve) * (1 - 1e-6) - 1e-13;
  if (!(offset > 0) || !(std::fabs(here) < crossing.reach)) return std::nullopt;
  result.error = 6.1 * heaviest * (std::fabs(residual) + slack) / (crossing.least_third * offset * offset) + 1e-15;
  return result;
}

double ContactCurve::chord_error(const CurveCrossing& crossing, double step, double error) const {
  const double half = crossing.reach + crossing.length;
  const Place& origin = crossing.origin;
  const auto bounds =
      PatchJets(base_).bounds_on(origin[0] - half, origin[0] + half, origin[1] - half, origin[1] + half);
  if (!bounds) return std::numeric_limits<double>::infinity();
  const double length = step * (1 + crossing.branch_slope);
  const double deviation = 0.125 * crossing.branch_bend * step * step + error;
  double result = 0;
  for (long c = 0; c < 3; ++c) {
    const double speed = bounds->first[0][c] + bounds->first[1][c];
    const double bending = bounds->second[0][c] + 2 * bounds->second[1][c] + bounds->second[2][c];
    result = std::max(result, speed * deviation + 0.125 * bending * length * length);
  }
  return 1.74 * result;
}

}  // namespace eliminant::bridge
