// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// The value with `digits` significant digits, and radius_exponent raised to what bounds its error; nullopt where the
/// ball is too wide for that. An exact zero is "0".
std::optional<Coordinate> print_value(const bridge::ComplexBall& value, long digits, long& radius_exponent);

/// Homogeneous coordinates divided by the last one of them that is not zero, with `digits` digits of the largest.
/// `vanishes` tells of a coordinate whether it is exactly zero; it is asked where a ball leaves that open. nullopt
/// where the balls are too wide.
template <class Vanishes>
std::optional<std::vector<Coordinate>> print_point(std::vector<bridge::ComplexBall> coordinates, long digits,
                                                   long precision_bits, long& radius_exponent, Vanishes vanishes);

/// The same of exact coordinates.
std::vector<Coordinate> print_exact_point(const std::vector<symbolic::Rational>& coordinates, long digits,
                                          long& radius_exponent);

/// Coordinates with at most one of them known to be 1, the others to be printed.
std::optional<std::vector<Coordinate>> print_normalized(const std::vector<bridge::ComplexBall>& coordinates,
                                                        long digits, long& radius_exponent);

/// True when the printed boxes of two solutions meet: more digits are needed to tell them apart.
bool crowded(const std::vector<CurveSolution>& solutions);

/// -1, 0 or 1 by the printed real and imaginary parts; what is absent is equal, infinity is last.
int compare_parameters(const std::optional<Parameter>& a, const std::optional<Parameter>& b);

/// By (Re t, Im t), infinity last, then the same of u; of each solution the parameters on the surface likewise.
void sort_solutions(std::vector<CurveSolution>& solutions);

template <class Vanishes>
std::optional<std::vector<Coordinate>> print_point(std::vector<bridge::ComplexBall> coordinates, long digits,
                                                   long precision_bits, long& radius_exponent, Vanishes vanishes) {
  std::size_t last = coordinates.size();
  while (last > 0) {
    --last;
    if (acb_contains_zero(coordinates[last].get()) == 0) break;
    if (!vanishes(last)) return std::nullopt;
    acb_zero(coordinates[last].get());
  }
  const bridge::ComplexBall weight = coordinates[last];
  for (std::size_t k = 0; k < last; ++k)
    acb_div(coordinates[k].get(), coordinates[k].get(), weight.get(), precision_bits);
  acb_one(coordinates[last].get());
  return print_normalized(coordinates, digits, radius_exponent);
}

}  // namespace eliminant::intersect
