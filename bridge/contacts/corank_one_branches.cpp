// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/corank_one_branches.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include <eliminant/bridge/contacts/local_tables.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

namespace {

using namespace local;
using Pair = std::array<DoubleInterval, 2>;

constexpr std::size_t weight = 3;
/// More than the roundings in a formula of doubles.
constexpr double slack = 1 + 1e-12;
/// Bounds the length of a vector by its largest coordinate.
constexpr double root_of_three = 1.7321;

DoubleInterval hull(const DoubleInterval& a, const DoubleInterval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

}  // namespace

std::array<double, 2> CorankOneBranches::coordinates_of(double u, double v) const {
  const double x = contact.exchanged ? v : u;
  double bottom = 0;
  for (std::size_t k = ridge.size(); k-- > 1;) bottom = (bottom + ridge[k]) * x;
  return {x, (contact.exchanged ? u : v) - bottom};
}

std::optional<std::size_t> CorankOneBranches::half_branch(double u, double v, double radius) const {
  const auto [x, z] = coordinates_of(u, v);
  const double unsure = 2 * radius * (1 + ridge_slope);
  if (!(std::fabs(x) > unsure) || !(std::fabs(z) > unsure)) return std::nullopt;
  if (!sides[x > 0 ? 0 : 1]) return std::nullopt;
  return (x > 0 ? 0U : 2U) + (z > 0 ? 0U : 1U);
}

double CorankOneBranches::chord_error(double x, double other) const {
  const double exponent = 0.5 * static_cast<double>(contact.order) - 2;
  const double turning = most_turning * std::max(std::pow(x, exponent), std::pow(other, exponent)) + ridge_bend;
  const double step = other - x;
  return slack * root_of_three * 0.125 * step * step * (speed * turning + curvature);
}

double CorankOneBranches::last_chord_error(double x) const {
  const double height = most_ratio * std::pow(x, 0.5 * static_cast<double>(contact.order));
  return slack * root_of_three * (speed * (height + 0.125 * ridge_bend * x * x) + 0.125 * curvature * x * x);
}

std::optional<CorankOnePatches> CorankOnePatches::around(const ControlNet& first, const ControlNet& second,
                                                         const ExactNet& exact_first, const ExactNet& exact_second,
                                                         const std::array<symbolic::Rational, 4>& parameters,
                                                         CorankOneContact contact) {
  std::array<double, 4> at{};
  for (std::size_t k = 0; k < 4; ++k) at[k] = nearest(parameters[k]);
  const auto frame = tangent_frame(PatchJets(first).at(at[0], at[1]));
  if (!frame) return std::nullopt;
  const auto series = [&](const ExactNet& exact, std::size_t of) {
    return taylor_at(exact, {parameters[of], parameters[of + 1]}, exact.degrees[0] + exact.degrees[1]);
  };
  const TaylorTable<symbolic::Rational> a = series(exact_first, 0);
  const auto rows = exact_frame(a, *frame);
  if (!rows) return std::nullopt;
  CorankOnePatches result(enclosed_in(*rows, a, first.polynomial),
                          enclosed_in(*rows, series(exact_second, 2), second.polynomial));
  if (contact.exchanged) result.first_ = exchanged_parameters(result.first_);
  result.polynomial_ = first.polynomial && second.polynomial;
  result.at_ = at;
  for (const symbolic::Rational& c : contact.ridge) result.ridge_.push_back(enclosed(c));
  result.contact_ = std::move(contact);
  const Jet jet = jet_at(result.second_, 0, 0);
  Eigen::Matrix2d derivative;
  for (long k = 0; k < 2; ++k) derivative.col(k) = jet.slope[static_cast<std::size_t>(k)].head<2>();
  const Eigen::Matrix2d inverse = derivative.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  for (std::size_t r = 0; r < 2; ++r)
    for (std::size_t c = 0; c < 2; ++c) result.inverse_[r][c] = inverse(static_cast<long>(r), static_cast<long>(c));
  return result;
}

DoubleInterval CorankOnePatches::ridge_at(const DoubleInterval& x, std::size_t derivative) const {
  // The Taylor coefficient of that index.
  DoubleInterval sum(0);
  const auto power = powers(x, ridge_.size());
  for (std::size_t k = std::max<std::size_t>(derivative, 1); k < ridge_.size(); ++k)
    sum = sum + DoubleInterval(binomial(k, derivative)) * ridge_[k] * power[k - derivative];
  return sum;
}

CorankOnePatches::Heights CorankOnePatches::heights(const DoubleInterval& x, const DoubleInterval& z,
                                                    const Pair& second, std::size_t order) const {
  std::vector<DoubleInterval> bottom{DoubleInterval(0)};
  for (std::size_t k = 1; k < ridge_.size(); ++k) bottom.push_back(ridge_at(x, k));
  const Table first = sheared(moved(first_, {x, ridge_at(x, 0) + z}, order), bottom);
  return height_series<Heights::highest>(first, moved(second_, second, order), order, polynomial_).height;
}

std::optional<std::array<double, 2>> CorankOnePatches::second_reach(const Pair& of_first,
                                                                    std::array<double, 2> least) const {
  const EnclosedPatch a(moved(first_, of_first, 2));
  std::array<double, 2> along{};
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t c = 0; c < 2; ++c) along[k] += std::fabs(inverse_[k][c]) * a.value[c].magnitude();
    least[k] = std::max(least[k], 1.2 * along[k]);
  }
  constexpr int most_attempts = 5;
  constexpr double most = 0.5;
  for (int i = 0; i < most_attempts && least[0] < most && least[1] < most; ++i) {
    const EnclosedPatch b(
        moved(second_, {DoubleInterval(-least[0], least[0]), DoubleInterval(-least[1], least[1])}, 2));
    std::array<double, 2> image = along;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t j = 0; j < 2; ++j) {
        const DoubleInterval entry = DoubleInterval(k == j ? 1 : 0) - DoubleInterval(inverse_[k][0]) * b.first[j][0] -
                                     DoubleInterval(inverse_[k][1]) * b.first[j][1];
        image[k] += entry.magnitude() * least[j];
      }
    // A contraction that maps the box to itself: for every (x, y) there is exactly one (s, t) in it.
    if (slack * image[0] < least[0] && slack * image[1] < least[1]) return least;
    for (std::size_t k = 0; k < 2; ++k) least[k] = std::max(least[k], 1.1 * image[k]);
  }
  return std::nullopt;
}

DoubleInterval CorankOnePatches::coefficient_along(const Heights& here, const Heights& around, const DoubleInterval& x,
                                                   std::size_t i, std::size_t j) const {
  const auto power = powers(x, spare_terms);
  DoubleInterval sum =
      DoubleInterval(binomial(i + spare_terms, i)) * around.at(i + spare_terms, j) * power[spare_terms];
  for (std::size_t k = 0; k < spare_terms; ++k)
    sum = sum + DoubleInterval(binomial(i + k, i)) * here.at(i + k, j) * power[k];
  return sum;
}

std::optional<CorankOneBranches> CorankOnePatches::in_box(const ControlNet& first, const CellBox& box) const {
  const std::size_t of_x = contact_.exchanged ? 1 : 0;
  const std::size_t of_y = 1 - of_x;
  // Boxes are rounded, and so is the place of the contact.
  constexpr double rounding = 0x1p-48;
  const auto range = [&](std::size_t k) {
    return DoubleInterval(std::min(box.lower[k] - at_[k], 0.0) - rounding,
                          std::max(box.upper[k] - at_[k], 0.0) + rounding);
  };
  const DoubleInterval x = range(of_x);
  const DoubleInterval bottom = ridge_at(x, 0);
  const DoubleInterval y = hull(range(of_y), bottom);
  const DoubleInterval z = y - bottom;
  const auto reach = second_reach({x, y}, {range(2).magnitude(), range(3).magnitude()});
  if (!reach) return std::nullopt;
  const Pair second{DoubleInterval(-(*reach)[0], (*reach)[0]), DoubleInterval(-(*reach)[1], (*reach)[1])};

  const std::size_t m = contact_.order;
  const std::size_t n = ridge_.size() - 1;
  const Heights in_all = heights(x, z, second, 4);
  DoubleInterval bend = DoubleInterval(2) * in_all.at(0, 2);
  if (!bend.excludes_zero() || !bend.is_finite()) return std::nullopt;
  const Heights here = heights(DoubleInterval(0), DoubleInterval(0), {}, std::max(m, n + 2) + spare_terms - 1);
  const Heights around = heights(x, DoubleInterval(0), second, std::max(m, n + 2) + spare_terms);
  DoubleInterval height = coefficient_along(here, around, x, m, 0);
  if (!height.excludes_zero() || !height.is_finite()) return std::nullopt;
  const double slope = coefficient_along(here, around, x, n + 1, 1).magnitude();
  if (bend.upper < 0) {
    bend = -bend;
    height = -height;
  }

  CorankOneBranches result;
  result.contact = contact_;
  result.at = at_;
  for (const DoubleInterval& c : ridge_) result.ridge.push_back(middle(c));
  result.reach = x.magnitude();
  result.range_of_y = {y.lower, y.upper};
  result.second_reach = *reach;
  result.sides = {height.upper < 0, m % 2 == 0 ? height.upper < 0 : height.lower > 0};
  const double most_height = height.magnitude();
  const double least_height = std::min(std::fabs(height.lower), std::fabs(height.upper));
  const double half = 0.5 * static_cast<double>(m);
  const double lean = slack * slope * std::pow(result.reach, static_cast<double>(n + 1) - half);
  // No zeros where the minimum of h for one x is positive.
  if (!(least_height > slack * lean * lean / (2 * bend.lower))) return std::nullopt;
  if (result.half_branches() == 0) return result;

  const auto& b = bend;
  result.least_bend = b.lower;
  result.most_slope = slope;
  result.most_ratio = slack * (lean + std::sqrt(lean * lean + 2 * b.lower * most_height)) / b.lower;
  result.least_ratio = (std::sqrt(lean * lean + 2 * b.upper * least_height) - lean) / b.upper / slack;
  const double steep = std::max(least_height / result.most_ratio, b.lower * result.least_ratio - lean) / slack;
  // The second is what errors of points are divided by.
  if (!(result.least_ratio > 0) || !(b.lower * result.least_ratio > 1.1 * lean)) return std::nullopt;
  const double order = static_cast<double>(m);
  const double of_slope = static_cast<double>(n + 1);
  const double ratio = result.most_ratio;
  const double by_x = 2 * in_all.at(1, 2).magnitude() * result.reach;
  const double by_xx = 4 * in_all.at(2, 2).magnitude() * result.reach * result.reach;
  const double h_x = order * most_height + of_slope * lean * ratio + 0.5 * by_x * ratio * ratio;
  const double h_xx =
      order * (order - 1) * most_height + of_slope * (of_slope - 1) * lean * ratio + 0.5 * by_xx * ratio * ratio;
  const double h_xz = of_slope * lean + by_x * ratio;
  result.most_steepness = slack * h_x / steep;
  result.most_turning =
      slack * (h_xx + 2 * h_xz * result.most_steepness + b.upper * result.most_steepness * result.most_steepness) /
      steep;
  result.ridge_slope = ridge_at(x, 1).magnitude();
  result.ridge_bend = 2 * ridge_at(x, 2).magnitude();

  const auto by_plane = EnclosedSlopes(moved(second_, second, 1)).inverse();
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < 2; ++c) result.second_by_plane[k][c] = by_plane[k][c].magnitude();
  CellBox region;
  for (const auto& [k, interval] : {std::pair(of_x, x), std::pair(of_y, y)}) {
    region.lower[k] = at_[k] + interval.lower;
    region.upper[k] = at_[k] + interval.upper;
  }
  const auto bounds = PatchJets(first).bounds_on(region.lower[0], region.upper[0], region.lower[1], region.upper[1]);
  if (!bounds) return std::nullopt;
  const double most_slope = result.ridge_slope + result.most_steepness * std::pow(result.reach, half - 1);
  for (long c = 0; c < 3; ++c) {
    result.speed = std::max(result.speed, bounds->first[of_y][c]);
    result.curvature = std::max(result.curvature, bounds->second[2 * of_x][c] + 2 * most_slope * bounds->second[1][c] +
                                                      most_slope * most_slope * bounds->second[2 * of_y][c]);
  }
  return result;
}

std::optional<CorankOnePatches::Point> CorankOnePatches::point(const CorankOneBranches& branches,
                                                               const Point& guess) const {
  // The second patch is led to the first along the plane; then Newton's method for z, which a convex function sends to
  // the far side of its zero at once, and from there towards it.
  const auto followed = [&](const Jet& a, std::array<double, 2>& at) {
    Jet b = jet_at(second_, at[0], at[1]);
    constexpr int most = 8;
    for (int i = 0; i < most; ++i) {
      Eigen::Matrix2d along;
      along << b.slope[0].head<2>(), b.slope[1].head<2>();
      const Eigen::Vector2d step = along.partialPivLu().solve(a.value.head<2>() - b.value.head<2>());
      at = {at[0] + step[0], at[1] + step[1]};
      if (!(step.lpNorm<Eigen::Infinity>() > 0x1p-46 * std::fabs(guess.x))) break;
      b = jet_at(second_, at[0], at[1]);
    }
    return b;
  };
  Point result = guess;
  const double side = guess.z > 0 ? 1 : -1;
  const double x = guess.x;
  const double base = middle(ridge_at(DoubleInterval(x), 0));
  constexpr int most_steps = 20;
  double change = INFINITY;
  for (int i = 0; i < most_steps && change > 0x1p-40 * std::fabs(result.z); ++i) {
    const Jet a = jet_at(first_, x, base + result.z);
    const Jet b = followed(a, result.second);
    Eigen::Matrix3d jacobian;
    jacobian << a.slope[1], -b.slope[0], -b.slope[1];
    const Eigen::Vector3d step = jacobian.partialPivLu().solve(a.value - b.value);
    if (!step.allFinite()) return std::nullopt;
    // Not across the ridge.
    const double z = result.z - step[0];
    const double next = side * z > 0 ? z : 0.5 * result.z;
    change = std::fabs(next - result.z);
    result.z = next;
    for (std::size_t k = 0; k < 2; ++k) result.second[k] -= step[static_cast<long>(k) + 1];
  }
  // How far h is from zero there, and how fast it grows between there and the branch.
  const DoubleInterval at_x(x);
  const DoubleInterval y = ridge_at(at_x, 0) + DoubleInterval(result.z);
  if (!(y.lower > branches.range_of_y[0] && y.upper < branches.range_of_y[1])) return std::nullopt;
  const EnclosedSlopes a(moved(first_, {at_x, y}, 1));
  const EnclosedSlopes b(moved(second_, {DoubleInterval(result.second[0]), DoubleInterval(result.second[1])}, 1));
  // The parameters of the second at which it is opposite to the point of the first are that near.
  Pair opposite;
  for (std::size_t k = 0; k < 2; ++k) {
    double far = 0;
    for (std::size_t c = 0; c < 2; ++c)
      far += slack * branches.second_by_plane[k][c] * (a.value[c] - b.value[c]).magnitude();
    opposite[k] = DoubleInterval::around(result.second[k], far);
    if (!(opposite[k].magnitude() < branches.second_reach[k])) return std::nullopt;
  }
  const EnclosedSlopes between(moved(second_, opposite, 1));
  const auto by_plane = between.inverse();
  double height = (a.value[2] - b.value[2]).magnitude();
  for (std::size_t c = 0; c < 2; ++c)
    height += (between.slope[0][2] * by_plane[0][c] + between.slope[1][2] * by_plane[1][c]).magnitude() *
              (a.value[c] - b.value[c]).magnitude();
  if (!polynomial_) {
    // Heights are multiplied by both weights.
    const auto& [s, t] = branches.second_reach;
    height *= moved(first_, {at_x, y}, 0).at(0, 0)[weight].magnitude() *
              moved(second_, {DoubleInterval(-s, s), DoubleInterval(-t, t)}, 0).at(0, 0)[weight].magnitude();
  }
  const double far = std::fabs(x);
  const double m = static_cast<double>(contact_.order);
  const double least = std::min(std::fabs(result.z), branches.least_ratio * std::pow(far, 0.5 * m));
  const double growth =
      branches.least_bend * least - branches.most_slope * std::pow(far, static_cast<double>(ridge_.size()));
  if (!(growth > 0)) return std::nullopt;
  result.error = slack * height / growth;
  return result;
}

std::array<double, 4> CorankOnePatches::parameters(const CorankOneBranches& branches, const Point& point) const {
  double y = point.z;
  double bottom = 0;
  for (std::size_t k = branches.ridge.size(); k-- > 1;) bottom = (bottom + branches.ridge[k]) * point.x;
  y += bottom;
  std::array<double, 4> result = at_;
  result[contact_.exchanged ? 1 : 0] += point.x;
  result[contact_.exchanged ? 0 : 1] += y;
  for (std::size_t k = 0; k < 2; ++k) result[2 + k] += point.second[k];
  return result;
}

}  // namespace eliminant::bridge
