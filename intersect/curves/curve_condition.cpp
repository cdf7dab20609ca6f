// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/curve_condition.hpp>

#include <algorithm>
#include <functional>
#include <numeric>

#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CurvePiece;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// The last report of something that ran, with the methods of all.
void add_engine(const EngineReport& part, EngineReport& whole) {
  if (part.method == "none" && !whole.method.empty()) return;
  std::string methods = whole.method == "none" ? "" : whole.method;
  for (std::size_t begin = 0; begin <= part.method.size();) {
    const std::size_t end = std::min(part.method.find('+', begin), part.method.size());
    const std::string method = part.method.substr(begin, end - begin);
    if (("+" + methods + "+").find("+" + method + "+") == std::string::npos)
      methods += (methods.empty() ? "" : "+") + method;
    begin = end + 1;
  }
  whole = part;
  whole.method = methods;
}

void add_infinity(const CurvePiece& piece, unsigned long multiplicity, const Options& options, const FillSolution& fill,
                  CurveResult& result) {
  CurveSolution solution;
  solution.t = Parameter();
  solution.multiplicity = multiplicity;
  solution.inside = !piece.domain;
  solution.reality = Reality::real;
  solution.certified = options.certify;
  solution.radius_exponent = -options.digits;
  std::vector<Rational> exact;
  PointOnCurve point;
  for (const symbolic::Integer& coordinate : piece.map.at_infinity()) {
    exact.emplace_back(coordinate);
    acb_set_fmpz(point.coordinates.emplace_back().get(), coordinate.get());
  }
  solution.point = print_exact_point(exact, options.digits, solution.radius_exponent);
  point.real = true;
  for (point.precision_bits = bits_for_digits(options.digits) + 64;; point.precision_bits *= 2) {
    const Filling filling = fill(solution, point);
    if (filling == Filling::left_out) return;
    if (filling == Filling::done) break;
  }
  result.solutions.push_back(std::move(solution));
}

void add_root(const CurvePiece& piece, ParameterRoots& roots, std::size_t i, unsigned long multiplicity, bool inside,
              const Options& options, const Context& context, const FillSolution& fill, CurveResult& result) {
  CurveSolution first;
  first.multiplicity = multiplicity;
  first.reality = roots.is_real(i) ? Reality::real : Reality::non_real;
  first.inside = inside;
  first.certified = options.certify;
  first.radius_exponent = -options.digits;
  for (long bits = bits_for_digits(options.digits) + 32;; bits *= 2) {
    context.checkpoint("refining");
    roots.refine(i, bits);
    CurveSolution solution = first;
    const Parameter t = print_value(roots.ball(i), options.digits, solution.radius_exponent);
    PointOnCurve point{{}, &roots, i, std::nullopt, roots.is_real(i), 2 * bits};
    for (const UnivariatePolynomial& f : piece.map.coordinates())
      point.coordinates.push_back(evaluate(f, roots.ball(i), point.precision_bits));
    auto printed = print_point(point.coordinates, options.digits, point.precision_bits, solution.radius_exponent,
                               [&](std::size_t k) { return roots.is_zero_of(i, piece.map.coordinates()[k]); });
    if (!t || !printed) continue;
    solution.t = t;
    solution.t_polynomial = roots.factor(i);
    solution.point = *std::move(printed);
    const Filling filling = fill(solution, point);
    if (filling == Filling::more_precision) continue;
    if (filling == Filling::done) result.solutions.push_back(std::move(solution));
    return;
  }
}

}  // namespace

Parameter exactly(const Rational& value, const Options& options) {
  long radius_exponent = 0;
  for (long precision_bits = 4 * bits_for_digits(options.digits);; precision_bits *= 2) {
    ComplexBall ball;
    arb_set_fmpq(ball.real(), value.get(), precision_bits);
    if (Parameter parameter = print_value(ball, options.digits, radius_exponent)) {
      parameter->exact = value;
      return parameter;
    }
  }
}

symbolic::Polynomial homogenized(const symbolic::Polynomial& equation) {
  const auto degree = static_cast<unsigned long>(equation.total_degree());
  std::vector<symbolic::Polynomial::Term> terms = equation.primitive_part().terms();
  for (symbolic::Polynomial::Term& term : terms)
    term.exponents.push_back(std::accumulate(term.exponents.begin(), term.exponents.end(), degree, std::minus<>()));
  return symbolic::Polynomial::from_terms(equation.variable_count() + 1, terms);
}

symbolic::ParameterForm along_curve(const symbolic::RationalCurve& curve, const symbolic::Polynomial& form) {
  UnivariatePolynomial value;
  for (const symbolic::Polynomial::Term& term : form.terms()) {
    UnivariatePolynomial product({term.coefficient.numerator()});
    for (std::size_t k = 0; k < term.exponents.size(); ++k)
      product = product * symbolic::power(curve.coordinates()[k], term.exponents[k]);
    value = value + product;
  }
  return {value, form.total_degree() * curve.degree() - value.degree()};
}

bool real_only(const Options& options, bool has_domain) {
  return options.field == Field::automatic ? has_domain : options.field == Field::real;
}

void add_condition_roots(const CurvePiece& piece, const symbolic::ParameterForm& condition, long map_degree,
                         bool real_solutions, const Options& options, const Context& context, const FillSolution& fill,
                         CurveResult& result) {
  const auto divisor = static_cast<unsigned long>(map_degree);
  CurveCounts counts;
  counts.expected = counts.with_multiplicity = static_cast<unsigned long>(condition.degree()) / divisor;
  if (condition.finite.degree() >= 1) {
    ParameterRoots roots(condition.finite, real_solutions ? Wanted::real : Wanted::all, context);
    counts.distinct = roots.distinct();
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (roots.is_real(i)) ++counts.real;
      const bool inside =
          roots.is_real(i) &&
          (!piece.domain || (roots.compare(i, piece.domain->lower) >= 0 && roots.compare(i, piece.domain->upper) <= 0));
      if (real_solutions && !inside) continue;
      add_root(piece, roots, i, roots.multiplicity(i) / divisor, inside, options, context, fill, result);
    }
  }
  if (condition.order_at_infinity > 0) {
    ++counts.distinct;
    ++counts.real;
    if (!real_solutions || !piece.domain)
      add_infinity(piece, static_cast<unsigned long>(condition.order_at_infinity) / divisor, options, fill, result);
  }
  add_part(Status::certified, counts, result.engine, {}, result);
}

Overlap whole_curve(const CurvePiece& piece, const Options& options) {
  Overlap overlap;
  overlap.certified = options.certify;
  if (piece.domain)
    overlap.t = ParameterInterval{exactly(piece.domain->lower, options), exactly(piece.domain->upper, options)};
  return overlap;
}

bool joined(const CurvePiece& before, const CurvePiece& after) {
  if (!before.domain || !after.domain || !(before.domain->upper == after.domain->lower)) return false;
  const std::vector<Rational> a = before.map.at(before.domain->upper);
  const std::vector<Rational> b = after.map.at(after.domain->lower);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(a[i] * b[j] == a[j] * b[i])) return false;
  return true;
}

bool is_at(const std::optional<Parameter>& parameter, const Rational& value) {
  if (!parameter || !*parameter) return false;
  if ((*parameter)->exact) return *(*parameter)->exact == value;
  return acb_contains_fmpq((*parameter)->ball.get(), value.get()) != 0;
}

void add_part(Status status, const CurveCounts& counts, const EngineReport& engine,
              const std::vector<std::string>& warnings, CurveResult& result) {
  if (status != Status::certified) result.status = Status::numeric;
  result.counts.distinct += counts.distinct;
  result.counts.real += counts.real;
  result.counts.undecided += counts.undecided;
  result.counts.with_multiplicity += counts.with_multiplicity;
  result.counts.expected += counts.expected;
  result.counts.within_domains_only = result.counts.within_domains_only || counts.within_domains_only;
  add_engine(engine, result.engine);
  for (const std::string& warning : warnings)
    if (std::find(result.warnings.begin(), result.warnings.end(), warning) == result.warnings.end())
      result.warnings.push_back(warning);
}

void finish(const Options& options, CurveResult& result) {
  sort_solutions(result.solutions);
  for (const CurveSolution& solution : result.solutions) {
    if (solution.inside) ++result.counts.inside;
    if (!solution.certified && result.status == Status::certified) result.status = Status::numeric;
  }
  result.counts.listed = static_cast<unsigned long>(result.solutions.size());
  if (result.status == Status::infinite || result.status == Status::incomplete) return;
  if (!options.certify) {
    result.status = Status::numeric;
    for (CurveSolution& solution : result.solutions) {
      solution.certified = false;
      solution.reason = "certification was not asked for";
    }
  }
  if (result.overlap.empty()) return;
  result.rest_status = result.status;
  result.status = Status::infinite;
}

}  // namespace eliminant::intersect
