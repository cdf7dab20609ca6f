// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::Decimal;
using symbolic::Rational;

/// The four printed numbers of a solution, in sorting order: Re x, Im x, Re y, Im y.
struct Printed {
  std::array<Decimal, 4> parts;
  long radius_exponent = 0;
};

bool is_exactly_zero(const ComplexBall& ball) { return acb_is_zero(ball.get()) != 0; }

/// Encloses the point until each coordinate that is not exactly zero has `digits` digits and a few more.
void enclose_for_digits(SolutionSet& set, std::size_t index, long digits) {
  for (long target_log2 = -bits_for_digits(digits);; target_log2 *= 2) {
    set.enclose(index, target_log2);
    const bridge::PlaneBall& box = set.points()[index].box;
    bool enough = true;
    for (const ComplexBall* coordinate : {&box.x, &box.y})
      enough = enough && (is_exactly_zero(*coordinate) ||
                          (!acb_contains_zero(coordinate->get()) &&
                           acb_rel_accuracy_bits(coordinate->get()) >= bits_for_digits(digits) - 10));
    if (enough) return;
  }
}

Printed print(const bridge::PlaneBall& box, long digits) {
  Printed result;
  long largest = std::numeric_limits<long>::min();
  const std::array<const ComplexBall*, 2> coordinates{&box.x, &box.y};
  for (std::size_t k = 0; k < 2; ++k) {
    if (is_exactly_zero(*coordinates[k])) continue;
    const long magnitude = bridge::decimal_magnitude(*coordinates[k], digits);
    largest = std::max(largest, magnitude);
    result.parts[2 * k] = bridge::round_to_decimal(coordinates[k]->real(), magnitude - digits);
    result.parts[2 * k + 1] = bridge::round_to_decimal(coordinates[k]->imaginary(), magnitude - digits);
  }
  if (largest == std::numeric_limits<long>::min()) largest = 0;
  result.radius_exponent = largest - digits;
  return result;
}

/// True when |a - b| > 10^e + 10^f for some part: the printed boxes have no point in common.
bool printed_boxes_disjoint(const Printed& a, const Printed& b) {
  const auto radius = [](long exponent) { return Decimal{symbolic::Integer(1), exponent}.to_rational(); };
  const Rational reach = radius(a.radius_exponent) + radius(b.radius_exponent);
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational difference = a.parts[k].to_rational() - b.parts[k].to_rational();
    if (reach < (difference.sign() < 0 ? -difference : difference)) return true;
  }
  return false;
}

/// Which printed boxes meet another one. Only pairs whose real parts of x are close are looked at exactly.
std::vector<bool> crowded_points(const SolutionSet& set, const std::vector<std::size_t>& indices,
                                 const std::vector<Printed>& printed) {
  const std::size_t count = indices.size();
  std::vector<double> position(count);
  double reach = 0;
  for (std::size_t i = 0; i < count; ++i) {
    position[i] = arf_get_d(arb_midref(set.points()[indices[i]].box.x.real()), ARF_RND_NEAR);
    const double radius = std::pow(10.0, static_cast<double>(printed[i].radius_exponent));
    reach = std::max(reach, 8 * radius + 1e-12 * std::fabs(position[i]));
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return position[a] < position[b]; });
  std::vector<bool> crowded(count, false);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count && !(position[order[j]] - position[order[i]] > reach); ++j)
      if (!printed_boxes_disjoint(printed[order[i]], printed[order[j]])) crowded[order[i]] = crowded[order[j]] = true;
  return crowded;
}

/// True when the real point surely lies outside the printed box.
bool surely_outside(const bridge::PlaneBall& point, const Printed& box, long digits) {
  const long precision_bits = 2 * bits_for_digits(digits) + 64;
  const bridge::RealBall radius(Decimal{symbolic::Integer(1), box.radius_exponent}.to_rational(), precision_bits);
  for (std::size_t k = 0; k < 2; ++k) {
    bridge::RealBall distance(box.parts[2 * k].to_rational(), precision_bits);
    arb_sub(distance.get(), (k == 0 ? point.x : point.y).real(), distance.get(), precision_bits);
    arb_abs(distance.get(), distance.get());
    if (arb_gt(distance.get(), radius.get()) != 0) return true;
  }
  return false;
}

/// Whether a real solution that is not listed, because it lies outside the region asked for, is in the printed box.
bool holds_unlisted(SolutionSet& set, const std::vector<std::size_t>& unlisted, const Printed& box, long digits) {
  return std::any_of(unlisted.begin(), unlisted.end(), [&](std::size_t index) {
    if (surely_outside(set.points()[index].box, box, digits)) return false;
    set.enclose(index, -2 * bits_for_digits(digits));
    return !surely_outside(set.points()[index].box, box, digits);
  });
}

/// The real points of the set that are not among these.
std::vector<std::size_t> unlisted_real_points(const SolutionSet& set, const std::vector<std::size_t>& indices) {
  std::vector<bool> listed(set.points().size(), false);
  for (const std::size_t index : indices) listed[index] = true;
  std::vector<std::size_t> unlisted;
  for (std::size_t i = 0; i < listed.size(); ++i)
    if (!listed[i] && set.points()[i].reality == Reality::real) unlisted.push_back(i);
  return unlisted;
}

/// What an enclosure tells as it is; nullopt when that is not one digit of the larger coordinate.
std::optional<Printed> print_as_enclosed(const bridge::PlaneBall& box, long digits) {
  constexpr double log10_of_2 = 0.30102999566398120;
  long exponent = std::numeric_limits<long>::min();
  bool legible = false;
  for (const ComplexBall* coordinate : {&box.x, &box.y}) {
    if (acb_is_finite(coordinate->get()) == 0) return std::nullopt;
    if (is_exactly_zero(*coordinate)) {
      legible = true;
      continue;
    }
    for (arb_srcptr part : {coordinate->real(), coordinate->imaginary()})
      if (mag_is_zero(arb_radref(part)) == 0) {
        const double radius_log10 = mag_get_d_log2_approx(arb_radref(part)) * log10_of_2;
        exponent = std::max(exponent, static_cast<long>(std::ceil(radius_log10 + 0.01)) + 1);
      }
    if (acb_contains_zero(coordinate->get()) != 0) continue;
    legible = legible || acb_rel_accuracy_bits(coordinate->get()) > 4;
    exponent = std::max(exponent, bridge::decimal_magnitude(*coordinate, digits) - digits);
  }
  if (!legible) return std::nullopt;
  Printed result;
  if (exponent == std::numeric_limits<long>::min()) exponent = -digits;
  const std::array<const ComplexBall*, 2> coordinates{&box.x, &box.y};
  for (std::size_t k = 0; k < 2; ++k) {
    result.parts[2 * k] = bridge::round_to_decimal(coordinates[k]->real(), exponent);
    result.parts[2 * k + 1] = bridge::round_to_decimal(coordinates[k]->imaginary(), exponent);
  }
  result.radius_exponent = exponent;
  return result;
}

std::vector<Solution> sorted_solutions(const SolutionSet& set, const std::vector<std::size_t>& indices,
                                       const std::vector<Printed>& printed) {
  // By the printed numbers: what is read is sorted, and parts that are equal to all digits asked for do not decide the
  // order by what else is known of them.
  std::vector<std::array<Rational, 4>> keys;
  for (const Printed& each : printed)
    keys.push_back({each.parts[0].to_rational(), each.parts[1].to_rational(), each.parts[2].to_rational(),
                    each.parts[3].to_rational()});
  std::vector<std::size_t> order(printed.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < 4; ++k)
      if (!(keys[a][k] == keys[b][k])) return keys[a][k] < keys[b][k];
    return false;
  });

  std::vector<Solution> solutions;
  for (const std::size_t i : order) {
    const EnclosedPoint& point = set.points()[indices[i]];
    Solution solution;
    solution.x = {point.box.x, printed[i].parts[0].to_string(), printed[i].parts[1].to_string(), point.exact_x};
    solution.y = {point.box.y, printed[i].parts[2].to_string(), printed[i].parts[3].to_string(), point.exact_y};
    solution.radius_exponent = printed[i].radius_exponent;
    solution.reality = point.reality;
    solution.multiplicity = point.multiplicity;
    solutions.push_back(std::move(solution));
  }
  return solutions;
}

}  // namespace

std::vector<Solution> present(SolutionSet& set, const std::vector<std::size_t>& indices, long digits) {
  const std::size_t count = indices.size();
  std::vector<long> digits_of(count, digits);
  std::vector<Printed> printed(count);
  // A coordinate that is exactly zero never gets a significant digit: find those first, where any is in sight.
  for (std::size_t axis = 0; axis < 2; ++axis) {
    bool suspicious = false;
    for (const std::size_t index : indices) {
      const EnclosedPoint& point = set.points()[index];
      const ComplexBall& coordinate = axis == 0 ? point.box.x : point.box.y;
      const bool known = (axis == 0 ? point.exact_x : point.exact_y).has_value();
      suspicious = suspicious || (acb_contains_zero(coordinate.get()) && !known);
    }
    if (suspicious) set.find_exact_coordinate(axis, Rational(0));
  }
  for (std::size_t i = 0; i < count; ++i) {
    enclose_for_digits(set, indices[i], digits);
    printed[i] = print(set.points()[indices[i]].box, digits);
  }
  const std::vector<std::size_t> unlisted = unlisted_real_points(set, indices);
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<bool> crowded = crowded_points(set, indices, printed);
    for (std::size_t i = 0; i < count; ++i) {
      if (!crowded[i] && !holds_unlisted(set, unlisted, printed[i], digits_of[i])) continue;
      changed = true;
      digits_of[i] = digits_of[i] * 2;
      enclose_for_digits(set, indices[i], digits_of[i]);
      printed[i] = print(set.points()[indices[i]].box, digits_of[i]);
    }
  }

  return sorted_solutions(set, indices, printed);
}

std::vector<Solution> present_as_enclosed(const SolutionSet& set, const std::vector<std::size_t>& indices,
                                          long digits) {
  std::vector<std::size_t> legible;
  std::vector<Printed> printed;
  for (const std::size_t index : indices)
    if (std::optional<Printed> numbers = print_as_enclosed(set.points()[index].box, digits)) {
      legible.push_back(index);
      printed.push_back(*std::move(numbers));
    }
  return sorted_solutions(set, legible, printed);
}

}  // namespace eliminant::intersect
