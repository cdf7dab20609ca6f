// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/corank_one_contact.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/contacts/contact_curve_internal.hpp>
#include <eliminant/bridge/contacts/height_ridge.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

constexpr std::size_t weight = 3;
constexpr std::size_t highest = CorankOneContact::highest_order;
/// Of HeightNear::relative_determinant: near a contact of corank one it is small.
constexpr double far_from_rank_one = 0.25;

template <class Scalar, std::size_t Highest>
PlaneSeries<Scalar, Highest> exchanged_parameters(const PlaneSeries<Scalar, Highest>& h) {
  PlaneSeries<Scalar, Highest> result;
  for (std::size_t i = 0; i <= Highest; ++i)
    for (std::size_t j = 0; i + j <= Highest; ++j) result.at(i, j) = h.at(j, i);
  return result;
}

/// The coordinate in which the normal is largest.
std::size_t normal_coordinate(const TaylorTable<Rational>& patch) {
  const auto tangent = [&](const std::array<Rational, 4>& slope) {
    const std::array<Rational, 4>& value = patch.at(0, 0);
    std::array<Rational, 3> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = slope[k] * value[weight] - value[k] * slope[weight];
    return result;
  };
  const auto p = tangent(patch.at(1, 0));
  const auto q = tangent(patch.at(0, 1));
  std::array<double, 3> normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    normal[k] = std::fabs(nearest(p[i] * q[j] - p[j] * q[i]));
  }
  return static_cast<std::size_t>(std::max_element(normal.begin(), normal.end()) - normal.begin());
}

void make_last(TaylorTable<Rational>& table, std::size_t coordinate) {
  for (std::size_t i = 0; i <= table.order(); ++i)
    for (std::size_t j = 0; i + j <= table.order(); ++j) std::swap(table.at(i, j)[coordinate], table.at(i, j)[2]);
}

/// The height at a pair of parameters that are not quite those of a common point, in doubles.
template <std::size_t Highest>
struct HeightNear {
  HeightSeries<double, Highest> series;
  /// With its parameters exchanged where y is u.
  PlaneSeries<double, Highest> height;
  bool exchanged = false;
  /// The changes of s and t that make the coordinates along the plane equal, and what remains.
  std::array<double, 2> follow{};
  double gap = 0;

  /// 4 h_20 h_02 - h_11^2 in units of the square of the larger second derivative.
  double relative_determinant() const {
    const double largest = 2 * height.at(0, 2);
    return (4 * height.at(2, 0) * height.at(0, 2) - height.at(1, 1) * height.at(1, 1)) / (largest * largest);
  }
};

template <std::size_t Highest>
std::optional<HeightNear<Highest>> height_near(const ControlNet& first, const ControlNet& second,
                                               const std::array<double, 4>& at, std::size_t order) {
  const auto frame = tangent_frame(PatchJets(first).at(at[0], at[1]));
  if (!frame) return std::nullopt;
  TaylorTable<double> a = taylor_near(first, at[0], at[1], order);
  TaylorTable<double> b = taylor_near(second, at[2], at[3], order);
  contact::to_frame(*frame, a);
  contact::to_frame(*frame, b);
  HeightNear<Highest> result;
  result.series = height_series<Highest>(a, b, order, first.polynomial && second.polynomial);
  const PlaneSeries<double, Highest>& h = result.series.height;
  result.exchanged = std::fabs(h.at(2, 0)) > std::fabs(h.at(0, 2));
  result.height = result.exchanged ? exchanged_parameters(h) : h;
  std::array<double, 2> apart{};
  for (std::size_t r = 0; r < 2; ++r)
    apart[r] = a.at(0, 0)[r] * b.at(0, 0)[weight] - b.at(0, 0)[r] * a.at(0, 0)[weight];
  result.follow = KeptCoordinates<double>(a, b, 2).correction(apart);
  result.gap = a.at(0, 0)[2] - b.at(0, 0)[2];
  return result;
}

/// One of that order.
std::optional<std::array<double, 4>> contact_of_order(const ControlNet& first, const ControlNet& second,
                                                      const CellBox& search, std::array<double, 4> at,
                                                      std::size_t order) {
  constexpr int most_steps = 10;
  for (int step = 0; step < most_steps; ++step) {
    for (std::size_t k = 0; k < 4; ++k)
      if (!(at[k] > search.lower[k]) || !(at[k] < search.upper[k])) return std::nullopt;
    const auto here = height_near<highest>(first, second, at, order);
    if (!here || !(std::fabs(here->relative_determinant()) < far_from_rank_one)) return std::nullopt;
    const auto& h = here->height;
    const std::vector<double> ridge = height_ridge(h, order / 2);
    const std::vector<double> along = height_along(h, ridge, order);
    // To the ridge, and along it.
    const double x = -along[order - 1] / (static_cast<double>(order) * along[order]);
    const double y = -h.at(0, 1) / (2 * h.at(0, 2)) + ridge[1] * x;
    const std::array<double, 2> move = here->exchanged ? std::array{y, x} : std::array{x, y};
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& second_by = here->series.second[k];
      const double other = here->follow[k] + second_by.at(1, 0) * move[0] + second_by.at(0, 1) * move[1];
      at[k] += move[k];
      at[2 + k] += other;
      largest = std::max({largest, std::fabs(move[k]), std::fabs(other)});
    }
    if (!std::isfinite(largest)) return std::nullopt;
    constexpr double at_rest = 1e-12;
    if (!(largest < at_rest)) continue;
    // All that must vanish does, as far as doubles can tell.
    constexpr double tiny = 1e-6;
    const double size = tiny * std::fabs(along[order]);
    if (!(std::fabs(here->gap) < size)) return std::nullopt;
    for (std::size_t k = 1; k + 1 < order; ++k)
      if (!(std::fabs(along[k]) < size)) return std::nullopt;
    return at;
  }
  return std::nullopt;
}

}  // namespace

std::optional<CorankOneContact> corank_one_contact(const ExactNet& first, const ExactNet& second,
                                                   const std::array<Rational, 4>& parameters) {
  // Cusps are of order 3; few contacts are of a high one.
  for (const std::size_t order : {std::size_t{3}, std::size_t{4}, std::size_t{6}, highest}) {
    TaylorTable<Rational> a = taylor_at(first, {parameters[0], parameters[1]}, order);
    TaylorTable<Rational> b = taylor_at(second, {parameters[2], parameters[3]}, order);
    const std::size_t normal = normal_coordinate(b);
    make_last(a, normal);
    make_last(b, normal);
    PlaneSeries<Rational, highest> h = height_series<highest>(a, b, order, false).height;
    const Rational determinant = Rational(4) * h.at(2, 0) * h.at(0, 2) - h.at(1, 1) * h.at(1, 1);
    if (!determinant.is_zero() || (h.at(2, 0).is_zero() && h.at(0, 2).is_zero())) return std::nullopt;
    CorankOneContact result;
    result.exchanged = std::fabs(nearest(h.at(2, 0))) > std::fabs(nearest(h.at(0, 2)));
    if (result.exchanged) h = exchanged_parameters(h);
    result.ridge = height_ridge(h, order / 2);
    const std::vector<Rational> along = height_along(h, result.ridge, order);
    const auto leading = std::find_if(along.begin(), along.end(), [](const Rational& c) { return !c.is_zero(); });
    if (leading == along.end()) continue;
    result.order = static_cast<std::size_t>(leading - along.begin());
    result.ridge = height_ridge(h, result.order / 2 + 1);
    return result;
  }
  return std::nullopt;
}

std::vector<std::array<double, 4>> corank_one_contacts_near(const ControlNet& first, const ControlNet& second,
                                                            const CellBox& box) {
  std::array<double, 4> middle{};
  double reach = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    middle[k] = 0.5 * (box.lower[k] + box.upper[k]);
    reach = std::max(reach, box.upper[k] - box.lower[k]);
  }
  const auto here = height_near<2>(first, second, middle, 2);
  if (!here || !(std::fabs(here->relative_determinant()) < far_from_rank_one)) return {};
  // Contacts of high order keep parts far from them from being excluded.
  constexpr double far = 0.3;
  reach = std::max(reach, far);
  CellBox search;
  for (std::size_t k = 0; k < 4; ++k) {
    search.lower[k] = std::max(0.0, box.lower[k] - reach);
    search.upper[k] = std::min(1.0, box.upper[k] + reach);
  }
  std::vector<std::array<double, 4>> result;
  for (std::size_t order = 3; order <= highest; ++order)
    if (const auto at = contact_of_order(first, second, search, middle, order)) result.push_back(*at);
  return result;
}

}  // namespace eliminant::bridge
