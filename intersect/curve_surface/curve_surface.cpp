// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/curve_surface.hpp>

#include <chrono>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_surface/piece_pair.hpp>
#include <eliminant/intersect/curve_surface/prepared_surface.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/merge_pieces.hpp>
#include <eliminant/intersect/curves/seams.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CurvePiece;
using symbolic::ParameterForm;
using symbolic::Polynomial;
using symbolic::SurfacePiece;

/// True when the curve crosses the piece away from its borders, and transversally: one for each of its parameters.
bool crosses_inside(const CurveSolution& solution, const SurfacePiece& surface) {
  if (!surface.region || surface.region->triangle) return false;
  if (solution.multiplicity != solution.surface_parameters.size()) return false;
  constexpr long precision_bits = 256;
  for (const std::vector<Parameter>& parameters : solution.surface_parameters)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!parameters[axis]) return false;
      const bridge::RealBall lower(surface.region->sides[axis].lower, precision_bits);
      const bridge::RealBall upper(surface.region->sides[axis].upper, precision_bits);
      const ComplexBall& value = parameters[axis]->ball;
      if (arb_gt(value.real(), lower.get()) == 0 || arb_lt(value.real(), upper.get()) == 0) return false;
    }
  return true;
}

/// Whether solutions of different pieces may have one t and lack the polynomial that would tell.
bool have_common_parameters(const CurveResult& result) {
  for (std::size_t i = 0; i < result.solutions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const CurveSolution& a = result.solutions[i];
      const CurveSolution& b = result.solutions[j];
      if ((a.t_polynomial && b.t_polynomial) || !*a.t || !*b.t) continue;
      if (acb_overlaps((*a.t)->ball.get(), (*b.t)->ball.get()) != 0) return true;
    }
  return false;
}

CurveResult solve_once(const CurveSurfaceProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  const auto start = std::chrono::steady_clock::now();
  CurveResult result;
  result.problem = "curve_surface";
  result.status = Status::certified;
  std::vector<bool> sheets_inside;
  for (const CurvePiece& piece : problem.curve.pieces) {
    if (piece.map.dimension() != 3) throw InvalidInput("the curve lies in a plane", "a curve in space");
    if (piece.map.degree() < 1) throw InvalidInput("the curve is a single point", "a map that is not constant");
  }
  if (const auto* implicit = std::get_if<ImplicitSurface>(&problem.surface)) {
    const Polynomial& equation = implicit->equation;
    if (equation.is_constant()) throw InvalidInput("the equation of the surface is constant", "a surface");
    for (const CurvePiece& piece : problem.curve.pieces) {
      const ParameterForm condition = along_curve(piece.map, homogenized(equation));
      result.engine.method = "exact";
      if (condition.finite.is_zero())
        result.overlap.push_back(whole_curve(piece, options));
      else
        add_condition_roots(
            piece, condition, 1, real_only(options, piece.domain.has_value()), options, context,
            [](CurveSolution&, const PointOnCurve&) { return Filling::done; }, result);
    }
    sheets_inside.assign(result.solutions.size(), false);
  } else {
    const Seams seams(problem.curve);
    const std::vector<SurfacePiece>& pieces = std::get<symbolic::ParametricSurface>(problem.surface).pieces;
    for (const SurfacePiece& surface : pieces) {
      PreparedSurface prepared(surface, options.seed, context);
      for (std::size_t i = 0; i < problem.curve.pieces.size(); ++i) {
        const CurvePiece& curve = problem.curve.pieces[i];
        const std::size_t before = result.solutions.size();
        intersect_pieces(curve, prepared, options, context, result);
        for (std::size_t k = result.solutions.size(); k-- > before;)
          if (seams.is_left_to_another(i, result.solutions[k].t))
            result.solutions.erase(result.solutions.begin() + static_cast<std::ptrdiff_t>(k));
        for (std::size_t k = before; k < result.solutions.size(); ++k)
          sheets_inside.push_back(crosses_inside(result.solutions[k], surface));
      }
    }
  }
  if (options.engine != Engine::exact && have_common_parameters(result)) {
    // Only with its equation is a parameter known to be another one's, or not.
    Options exactly_known = options;
    exactly_known.engine = Engine::exact;
    return solve_once(problem, exactly_known, context);
  }
  merge_pieces(result, sheets_inside, context);
  finish(options, result);
  result.seconds.emplace_back("total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

}  // namespace

CurveResult intersect_curve_surface(const CurveSurfaceProblem& problem, const Options& options,
                                    const Context& context) {
  return with_enough_digits(options, [&](const Options& more) { return solve_once(problem, more, context); });
}

}  // namespace eliminant::intersect
