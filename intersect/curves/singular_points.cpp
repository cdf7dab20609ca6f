// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/singular_points.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/intersect/plane_curves/third_equation.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// The zeros of the derivatives of f at which f vanishes.
struct AffineSingularities {
  std::vector<Solution> solutions;
  Status status = Status::certified;
  EngineReport engine;
  std::vector<std::string> warnings;
};

AffineSingularities affine_singularities(const Polynomial& f, const Options& options, const Context& context) {
  AffineSingularities found;
  // Where the derivatives have a common component, f squarefree is constant along it and not zero.
  const auto split = symbolic::split_common_component(f.derivative(0), f.derivative(1));
  PlaneCurvesProblem problem;
  problem.p = split.first;
  problem.q = split.second;
  if (problem.p.is_constant() || problem.q.is_constant()) return found;
  Options more = options;
  more.field = Field::complex;
  more.certificate = false;
  constexpr int most_doublings = 8;
  for (int doubling = 0;; ++doubling) {
    const Result result = intersect_plane_curves(problem, more, context);
    if (result.status == Status::incomplete) throw LimitReached(*result.limit);
    KeptSolutions kept = solutions_of_third(problem, f, result.solutions, options.seed, context);
    const bool decided = kept.decided;
    found = {std::move(kept.solutions), result.status, result.engine, result.warnings};
    if (decided) return found;
    if (doubling == most_doublings) {
      found.status = Status::numeric;
      found.warnings.emplace_back("whether the curve passes every common zero of its derivatives is not proven");
      return found;
    }
    more.digits *= 2;
  }
}

/// The chart where x = 1 (0) or y = 1 (1) of a form in (x, y, w), in the other two variables.
Polynomial chart(const Polynomial& form, std::size_t one) {
  const std::vector<Polynomial> images =
      one == 0 ? std::vector{Polynomial::constant(2, 1), Polynomial::variable(2, 0), Polynomial::variable(2, 1)}
               : std::vector{Polynomial::variable(2, 0), Polynomial::constant(2, 1), Polynomial::variable(2, 1)};
  return form.compose(images);
}

/// Whether a point with w = 0 of the chart may be singular: of the second chart the origin alone.
bool may_be_singular_at_infinity(const Polynomial& f, std::size_t one) {
  const std::array<Polynomial, 3> equations{f, f.derivative(0), f.derivative(1)};
  if (one == 1)
    return std::all_of(equations.begin(), equations.end(),
                       [](const Polynomial& equation) { return equation.constant_term().is_zero(); });
  UnivariatePolynomial common;
  for (const Polynomial& equation : equations) {
    const auto rows = symbolic::hide_variable(equation, 0);
    if (!rows.coefficients.empty()) common = symbolic::gcd(common, rows.coefficients.front());
  }
  return common.is_zero() || common.degree() > 0;
}

/// By the type of the singularity that the Milnor number leaves.
std::optional<PairKind> kind_of(const Polynomial& f, const Solution& s) {
  if (s.multiplicity == 2) return PairKind::cusp;
  if (s.reality == Reality::non_real) return PairKind::complex;
  if (s.multiplicity != 1 || s.reality != Reality::real) return std::nullopt;
  const Polynomial mixed = f.derivative(0).derivative(1);
  const Polynomial hessian = f.derivative(0).derivative(0) * f.derivative(1).derivative(1) - mixed * mixed;
  const ComplexBall value = evaluate(hessian, s.x.ball, s.y.ball, 2 * bits_for_digits(30));
  if (arb_is_positive(value.real()) != 0) return PairKind::isolated;
  if (arb_is_negative(value.real()) != 0) return PairKind::crossing;
  return std::nullopt;
}

bool is_exactly_zero(const Coordinate& coordinate) { return coordinate.exact && coordinate.exact->is_zero(); }

}  // namespace

void add_singular_points(const Polynomial& f, const Options& options, const Context& context, CurveResult& result) {
  if (f.is_constant())
    throw InvalidInput(f.is_zero() ? "the equation of a curve is 0" : "the equation of a curve is constant",
                       "a polynomial that is not constant");
  Polynomial reduced = Polynomial::constant(2, 1);
  for (const Polynomial& factor : symbolic::irreducible_factors(f)) reduced = reduced * factor;
  if (reduced.total_degree() < f.total_degree()) {
    Overlap overlap;
    overlap.certified = options.certify;
    result.overlap.push_back(overlap);
  }
  const auto add = [&](const Polynomial& in_chart, const auto& wanted, const auto& point_of) {
    const AffineSingularities found = affine_singularities(in_chart, options, context);
    CurveCounts counts;
    for (const Solution& s : found.solutions) {
      if (!wanted(s)) continue;
      CurveSolution solution;
      solution.radius_exponent = s.radius_exponent;
      solution.point = point_of(s, solution.radius_exponent);
      solution.multiplicity = s.multiplicity;
      solution.kind = kind_of(in_chart, s);
      solution.reality = s.reality;
      solution.inside = s.reality == Reality::real;
      solution.certified = s.certified;
      solution.reason = s.reason;
      ++counts.distinct;
      if (s.reality == Reality::real) ++counts.real;
      if (s.reality == Reality::undecided) ++counts.undecided;
      counts.with_multiplicity += s.multiplicity;
      if (options.field != Field::real || s.reality == Reality::real) result.solutions.push_back(std::move(solution));
    }
    add_part(found.status, counts, found.engine, found.warnings, result);
  };
  const Coordinate one{ComplexBall(1, 0), "1", "0", Rational(1)};
  const Coordinate zero{ComplexBall(), "0", "0", Rational(0)};
  add(
      reduced, [](const Solution&) { return true; },
      [&](const Solution& s, long&) {
        return std::vector<Coordinate>{s.x, s.y, one};
      });
  const Polynomial form = homogenized(reduced);
  if (const Polynomial in_chart = chart(form, 0); may_be_singular_at_infinity(in_chart, 0))
    add(
        in_chart, [](const Solution& s) { return is_exactly_zero(s.y); },
        [&](const Solution& s, long& radius_exponent) {
          if (is_exactly_zero(s.x)) return std::vector<Coordinate>{one, zero, zero};
          const long precision_bits = 4 * bits_for_digits(options.digits);
          ComplexBall inverse;
          acb_inv(inverse.get(), s.x.ball.get(), precision_bits);
          const auto printed = print_value(inverse, options.digits, radius_exponent);
          if (!printed) throw LimitReached("a singular point at infinity needs more digits");
          return std::vector<Coordinate>{*printed, one, zero};
        });
  if (const Polynomial in_chart = chart(form, 1); may_be_singular_at_infinity(in_chart, 1))
    add(
        in_chart, [](const Solution& s) { return is_exactly_zero(s.x) && is_exactly_zero(s.y); },
        [&](const Solution&, long&) {
          return std::vector<Coordinate>{zero, one, zero};
        });
}

}  // namespace eliminant::intersect
