// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patch_boxes.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <eliminant/intersect/common_points.hpp>
#include <eliminant/intersect/presentation.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::ControlNet;
using symbolic::Interval;
using symbolic::Rational;

constexpr std::size_t weight = 3;

std::optional<ControlNet> control_net(const symbolic::CurvePiece& curve) {
  if (!curve.domain || !(curve.domain->lower < curve.domain->upper)) return std::nullopt;
  const auto degree = static_cast<std::size_t>(curve.map.degree());
  std::array<std::vector<Rational>, 4> coordinates;
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Rational> power;
    for (std::size_t i = 0; i <= degree; ++i)
      power.emplace_back(curve.map.coordinates()[k].coefficient(static_cast<long>(i)));
    coordinates[k] = symbolic::bernstein_coefficients(power, *curve.domain);
  }
  return ControlNet::round({degree}, coordinates);
}

std::optional<ControlNet> control_net(const symbolic::SurfacePiece& patch) {
  if (patch.map.kind() != symbolic::RationalSurface::Kind::tensor_product || !patch.region || patch.region->triangle)
    return std::nullopt;
  for (const Interval& side : patch.region->sides)
    if (!(side.lower < side.upper)) return std::nullopt;
  const auto m = static_cast<std::size_t>(patch.map.bidegree()[0]);
  const auto n = static_cast<std::size_t>(patch.map.bidegree()[1]);
  if (m == 0 || n == 0) return std::nullopt;
  std::array<std::vector<Rational>, 4> coordinates;
  for (std::size_t k = 0; k < 4; ++k) {
    // One parameter after the other: power[i][j] of s^i t^j.
    std::vector<std::vector<Rational>> table(m + 1, std::vector<Rational>(n + 1));
    for (const symbolic::Polynomial::Term& term : patch.map.coordinates()[k].terms())
      table[term.exponents[0]][term.exponents[1]] = term.coefficient;
    for (std::vector<Rational>& row : table) row = symbolic::bernstein_coefficients(row, patch.region->sides[1]);
    for (std::size_t j = 0; j <= n; ++j) {
      std::vector<Rational> column;
      for (std::size_t i = 0; i <= m; ++i) column.push_back(table[i][j]);
      column = symbolic::bernstein_coefficients(column, patch.region->sides[0]);
      for (std::size_t i = 0; i <= m; ++i) table[i][j] = column[i];
    }
    for (const std::vector<Rational>& row : table) coordinates[k].insert(coordinates[k].end(), row.begin(), row.end());
  }
  return ControlNet::round({m, n}, coordinates);
}

/// (value - lower) / (upper - lower).
ComplexBall to_unit(const ComplexBall& value, const Interval& interval, long precision_bits) {
  ComplexBall result = value;
  const bridge::RealBall lower(interval.lower, precision_bits);
  const bridge::RealBall width(interval.upper - interval.lower, precision_bits);
  acb_sub_arb(result.get(), result.get(), lower.get(), precision_bits);
  acb_div_arb(result.get(), result.get(), width.get(), precision_bits);
  return result;
}

enum class Place { inside, outside, unknown };

Place place_in_unit(const ComplexBall& value) {
  bridge::RealBall rest;
  arb_sub_ui(rest.get(), value.real(), 1, 128);
  if (arb_is_negative(value.real()) != 0 || arb_is_positive(rest.get()) != 0) return Place::outside;
  return arb_is_positive(value.real()) != 0 && arb_is_negative(rest.get()) != 0 ? Place::inside : Place::unknown;
}

}  // namespace

PatchBoxes::PatchBoxes(const symbolic::SurfacePiece& piece)
    : piece_(piece), surface_(piece.map), net_(control_net(piece)) {}

bool PatchBoxes::excludes(const std::vector<ComplexBall>& point, const Context& context) const {
  if (!net_) return false;
  double size = 0;
  for (const ComplexBall& coordinate : point)
    size = std::max(size, std::fabs(arf_get_d(arb_midref(coordinate.real()), ARF_RND_NEAR)));
  constexpr double safe = 1e60;
  if (!(size < safe) || !(size > 1 / safe)) return false;
  bridge::PointBox box{};
  for (std::size_t k = 0; k < 4; ++k) {
    bridge::RealBall end;
    arb_get_lbound_arf(arb_midref(end.get()), point[k].real(), 64);
    box[k][0] = arf_get_d(arb_midref(end.get()), ARF_RND_FLOOR);
    arb_get_ubound_arf(arb_midref(end.get()), point[k].real(), 64);
    box[k][1] = arf_get_d(arb_midref(end.get()), ARF_RND_CEIL);
  }
  return bridge::excludes_point(*net_, box, context);
}

std::optional<std::vector<CurveSolution>> PatchBoxes::solve(const symbolic::CurvePiece& curve, const Options& options,
                                                            const Context& context) const {
  if (!net_) return std::nullopt;
  const std::optional<ControlNet> curve_net = control_net(curve);
  if (!curve_net) return std::nullopt;
  const std::array<Interval, 3> domains{*curve.domain, piece_.region->sides[0], piece_.region->sides[1]};

  // Everything real: a box around a real start is its own mirror image, and so is its one zero.
  bridge::HomogeneousParameters chart(4);
  for (ComplexBall& parameter : chart) acb_one(parameter.get());
  const bridge::System system = common_point_system(surface_, curve.map, chart, {0, 2}, weight);
  const long first_precision = bits_for_digits(options.digits) + 40;
  const auto certify = [&](const std::array<double, 3>& near) -> std::optional<bridge::ParameterBox> {
    std::array<ComplexBall, 3> start;
    for (std::size_t k = 0; k < 3; ++k) {
      const bridge::RealBall lower(domains[k].lower, first_precision);
      const bridge::RealBall width(domains[k].upper - domains[k].lower, first_precision);
      arb_set_d(start[k].real(), near[k]);
      acb_mul_arb(start[k].get(), start[k].get(), width.get(), first_precision);
      acb_add_arb(start[k].get(), start[k].get(), lower.get(), first_precision);
    }
    // The doubles are right to about 45 bits.
    auto zero = bridge::enclose_system_zero(system, {start[1], start[2], start[0]}, first_precision,
                                            newton_steps(first_precision));
    if (!zero) return std::nullopt;
    for (ComplexBall& value : *zero) arb_zero(value.imaginary());
    return bridge::ParameterBox{to_unit((*zero)[2], domains[0], first_precision),
                                to_unit((*zero)[0], domains[1], first_precision),
                                to_unit((*zero)[1], domains[2], first_precision)};
  };
  const auto boxes = bridge::bernstein_subdivision(*curve_net, *net_, certify, context);
  if (!boxes) return std::nullopt;

  std::vector<CurveSolution> solutions;
  for (const bridge::ParameterBox& box : *boxes) {
    Place place = Place::inside;
    for (const ComplexBall& value : box) {
      const Place here = place_in_unit(value);
      if (here == Place::outside) place = Place::outside;
      if (here == Place::unknown && place != Place::outside) place = Place::unknown;
    }
    if (place == Place::unknown) return std::nullopt;
    if (place == Place::outside) continue;
    std::vector<ComplexBall> start;
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}, std::size_t{0}}) {
      const bridge::RealBall lower(domains[k].lower, 2 * first_precision);
      const bridge::RealBall width(domains[k].upper - domains[k].lower, 2 * first_precision);
      ComplexBall& value = start.emplace_back(box[k]);
      acb_mul_arb(value.get(), value.get(), width.get(), 2 * first_precision);
      acb_add_arb(value.get(), value.get(), lower.get(), 2 * first_precision);
    }
    bool printed = false;
    for (long bits = bits_for_digits(options.digits) + 40; !printed; bits *= 2) {
      constexpr long largest_precision = 1L << 18;
      if (bits > largest_precision + 8 * options.digits) return std::nullopt;
      std::optional<std::vector<ComplexBall>> zero = start;
      if (bits > first_precision) zero = bridge::enclose_system_zero(system, start, bits, newton_steps(bits));
      if (!zero) return std::nullopt;
      for (ComplexBall& value : *zero) arb_zero(value.imaginary());
      if (bits > 4 * first_precision && std::any_of(zero->begin(), zero->end(), [](const ComplexBall& value) {
            return acb_contains_zero(value.get()) != 0;
          }))
        return std::nullopt;
      chart[0] = (*zero)[0];
      chart[2] = (*zero)[1];
      std::optional<CurveSolution> solution = print_common_point(surface_, curve.map, chart, (*zero)[2], options, bits);
      if (!solution) continue;
      solution->reality = Reality::real;
      solution->inside = true;
      solutions.push_back(*std::move(solution));
      printed = true;
    }
  }
  return solutions;
}

}  // namespace eliminant::intersect
