// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/box_solutions.hpp>

#include <algorithm>

#include <eliminant/intersect/curves/common_points.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>

namespace eliminant::intersect {

using bridge::ComplexBall;
using symbolic::Interval;
using symbolic::Rational;

namespace {

/// True when the zero lies where the one of the box engine is the only one.
bool is_the_zero(const std::vector<ComplexBall>& zero, const bridge::IsolatedZero& known,
                 const std::vector<Interval>& domains, long bits) {
  for (std::size_t k = 0; k < zero.size(); ++k) {
    bridge::RealBall unit;
    const bridge::RealBall lower(domains[k].lower, bits);
    const bridge::RealBall width(domains[k].upper - domains[k].lower, bits);
    arb_sub(unit.get(), zero[k].real(), lower.get(), bits);
    arb_div(unit.get(), unit.get(), width.get(), bits);
    bridge::RealBall middle;
    arb_set_d(middle.get(), known.parameters[k]);
    arb_sub(unit.get(), unit.get(), middle.get(), bits);
    bridge::RealBall isolation;
    arb_set_d(isolation.get(), known.isolation);
    arb_abs(unit.get(), unit.get());
    if (arb_le(unit.get(), isolation.get()) == 0) return false;
  }
  return true;
}

}  // namespace

std::vector<Rational> BoxSolution::exact_parameters() const {
  std::vector<Rational> result;
  for (std::size_t k = 0; k < domains.size(); ++k)
    result.push_back(domains[k].lower + (domains[k].upper - domains[k].lower) * (*point.exact)[k]);
  return result;
}

CurveSolution BoxSolution::exact_on(const symbolic::RationalCurve& first, const Options& options) const {
  const Rational t = exact_parameters().front();
  CurveSolution solution;
  solution.radius_exponent = -options.digits;
  solution.certified = options.certify;
  solution.t = exactly(t, options);
  solution.t_polynomial = symbolic::UnivariatePolynomial::with_root(t);
  solution.point = print_exact_point(first.at(t), options.digits, solution.radius_exponent);
  solution.multiplicity = point.multiplicity;
  solution.reality = Reality::real;
  solution.inside = true;
  return solution;
}

std::optional<CurveSolution> BoxSolution::refined(const bridge::System& system, const Options& options,
                                                  const Print& print) const {
  const long first_precision = bits_for_digits(options.digits) + 40;
  constexpr long largest_precision = 1L << 18;
  for (long bits = first_precision; bits <= largest_precision + 8 * options.digits; bits *= 2) {
    std::vector<ComplexBall> start;
    for (std::size_t k = 0; k < domains.size(); ++k) {
      const bridge::RealBall lower(domains[k].lower, 2 * bits);
      const bridge::RealBall width(domains[k].upper - domains[k].lower, 2 * bits);
      ComplexBall& value = start.emplace_back();
      arb_set_d(value.real(), point.zero.parameters[k]);
      acb_mul_arb(value.get(), value.get(), width.get(), 2 * bits);
      acb_add_arb(value.get(), value.get(), lower.get(), 2 * bits);
    }
    std::optional<std::vector<ComplexBall>> zero = bridge::enclose_system_zero(system, start, bits, newton_steps(bits));
    if (!zero || !is_the_zero(*zero, point.zero, domains, bits)) return std::nullopt;
    // Everything real: a box around a real start is its own mirror image, and so is its one zero.
    for (ComplexBall& value : *zero) arb_zero(value.imaginary());
    if (bits > 4 * first_precision && std::any_of(zero->begin(), zero->end(), [](const ComplexBall& value) {
          return acb_contains_zero(value.get()) != 0;
        }))
      return std::nullopt;
    std::optional<CurveSolution> solution = print(*zero, bits);
    if (!solution) continue;
    solution->reality = Reality::real;
    solution->inside = true;
    solution->multiplicity = point.multiplicity;
    return solution;
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
