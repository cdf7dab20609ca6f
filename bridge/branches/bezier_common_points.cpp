// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/bezier_common_points.hpp>

#include <algorithm>

namespace eliminant::bridge {

namespace {

using symbolic::Rational;

bool is_inside(const std::array<Rational, 3>& parameters, std::size_t count) {
  return std::all_of(parameters.begin(), parameters.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const Rational& value) { return value.sign() >= 0 && !(Rational(1) < value); });
}

}  // namespace

std::optional<std::vector<BezierCommonPoint>> bezier_common_points(const ControlNet& first, const ControlNet& second,
                                                                   const ContactProver::Exact& exact_first,
                                                                   const ContactProver::Exact& exact_second,
                                                                   const Context& context) {
  ContactProver prover(first, second, exact_first, exact_second);
  const SubdivisionResult found = bernstein_subdivision(
      first, second, [&](const std::array<double, 3>& near, double reach) { return prover.find(near, reach); },
      SubdivisionLimits(), context);
  if (!found.complete || !found.open.empty()) return std::nullopt;
  const std::size_t count = 1 + second.parameters();

  std::vector<BezierCommonPoint> result;
  for (const IsolatedZero& zero : found.zeros) {
    BezierCommonPoint point{zero, {}, 1};
    const bool within =
        std::all_of(zero.parameters.begin(), zero.parameters.begin() + static_cast<std::ptrdiff_t>(count),
                    [&](double parameter) { return parameter - zero.radius > 0 && parameter + zero.radius < 1; });
    if (!within) {
      // On a border, or too near to it for doubles: only the exact parameters tell.
      point.exact = prover.exact_zero(zero);
      if (!point.exact) return std::nullopt;
      if (!is_inside(*point.exact, count)) continue;
      point.zero = rounded_parameters(*point.exact);
    }
    result.push_back(std::move(point));
  }
  for (const RationalZero& contact : prover.contacts()) {
    if (!is_inside(contact.parameters, count)) continue;
    result.push_back({rounded_parameters(contact.parameters), contact.parameters, contact.multiplicity});
  }
  return result;
}

}  // namespace eliminant::bridge
