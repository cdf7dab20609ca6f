// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/curve_curve.hpp>

#include <algorithm>
#include <chrono>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/map_pair.hpp>
#include <eliminant/intersect/curves/piece_boxes.hpp>
#include <eliminant/intersect/curves/seams.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CurvePiece;
using symbolic::ParametricCurve;
using symbolic::Polynomial;
using symbolic::Rational;

/// True when the two ends that touch have been found as a solution.
bool is_among(const CurveSolution& touch, const std::vector<CurveSolution>& solutions) {
  const auto at = [](const std::optional<Parameter>& a, const std::optional<Parameter>& exact) {
    return a && a->has_value() == exact->has_value() && (!*a || is_at(a, *(*exact)->exact));
  };
  return std::any_of(solutions.begin(), solutions.end(),
                     [&](const CurveSolution& other) { return at(other.t, touch.t) && at(other.u, touch.u); });
}

class CurveCurve {
 public:
  CurveCurve(const Options& options, const Context& context) : options_(options), context_(context) {
    result_.problem = "curve_curve";
    result_.status = Status::certified;
  }

  CurveResult run(const CurveCurveProblem& problem) {
    const auto start = std::chrono::steady_clock::now();
    const auto* first = std::get_if<ParametricCurve>(&problem.first);
    const auto* second = std::get_if<ParametricCurve>(&problem.second);
    result_.in_plane = true;
    result_.first_implicit = first == nullptr;
    result_.second_implicit = second == nullptr;
    if (first != nullptr && second != nullptr) {
      intersect_maps(*first, *second);
    } else if (first != nullptr) {
      intersect_map_with_equation(*first, std::get<ImplicitCurve>(problem.second).equation, false);
    } else if (second != nullptr) {
      intersect_map_with_equation(*second, std::get<ImplicitCurve>(problem.first).equation, true);
    } else {
      intersect_equations(std::get<ImplicitCurve>(problem.first).equation,
                          std::get<ImplicitCurve>(problem.second).equation);
    }
    finish(options_, result_);
    result_.seconds.emplace_back("total",
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return std::move(result_);
  }

 private:
  void intersect_maps(const ParametricCurve& first, const ParametricCurve& second) {
    const std::size_t dimension = first.pieces.front().map.dimension();
    for (const ParametricCurve* curve : {&first, &second})
      for (const CurvePiece& piece : curve->pieces)
        if (piece.map.dimension() != dimension)
          throw InvalidInput("a curve in space meets a plane curve", "two curves in the plane or two in space");
    result_.in_plane = dimension == 2;
    const Seams t_seams(first);
    const Seams u_seams(second);
    // The audit of a single pair is worth its time.
    const bool several = first.pieces.size() * second.pieces.size() > 1;
    const auto t_boxes = boxes_of_pieces(several ? first : ParametricCurve());
    const auto u_boxes = boxes_of_pieces(several ? second : ParametricCurve());
    for (std::size_t i = 0; i < first.pieces.size(); ++i)
      for (std::size_t j = 0; j < second.pieces.size(); ++j) {
        if (several && excluded_by_boxes(t_boxes[i], u_boxes[j], options_, result_)) continue;
        MapPairResult part = intersect_map_pair(first.pieces[i], second.pieces[j], options_, context_);
        add_part(part.status, part.counts, part.engine, part.warnings, result_);
        std::erase_if(part.touches, [&](const CurveSolution& touch) { return is_among(touch, part.solutions); });
        for (const std::vector<CurveSolution>* solutions : {&part.solutions, &part.touches})
          for (const CurveSolution& solution : *solutions)
            if (!t_seams.is_left_to_another(i, solution.t) && !u_seams.is_left_to_another(j, solution.u))
              result_.solutions.push_back(solution);
        result_.overlap.insert(result_.overlap.end(), part.overlap.begin(), part.overlap.end());
      }
    std::erase_if(result_.solutions, [&](const CurveSolution& solution) {
      return ends_overlap(solution, result_.overlap, t_seams, u_seams);
    });
    join_overlaps(result_.overlap);
  }

  /// f(x / w, y / w) w^deg f along the map: the intersections are the roots of one polynomial.
  void intersect_map_with_equation(const ParametricCurve& curve, const Polynomial& equation, bool equation_first) {
    if (equation.is_zero()) throw InvalidInput("the equation of a curve is 0", "a polynomial that is not constant");
    if (equation.is_constant()) throw InvalidInput("the equation of a curve is constant", "a curve");
    const Seams seams(curve);
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
      const CurvePiece& piece = curve.pieces[i];
      if (piece.map.dimension() != 2) throw InvalidInput("a curve in space meets a plane curve", "a plane curve");
      if (piece.map.degree() < 1) throw InvalidInput("a curve is a single point", "a map that is not constant");
      const std::size_t before = result_.solutions.size();
      const symbolic::ParameterForm condition = along_curve(piece.map, homogenized(equation));
      result_.engine.method = "exact";
      if (condition.finite.is_zero())
        result_.overlap.push_back(whole_curve(piece, options_));
      else
        add_condition_roots(
            piece, condition, 1, real_only(options_, piece.domain.has_value()), options_, context_,
            [](CurveSolution&, const PointOnCurve&) { return Filling::done; }, result_);
      std::erase_if(result_.solutions, [&, index = std::size_t{0}](const CurveSolution& solution) mutable {
        return index++ >= before && seams.is_left_to_another(i, solution.t);
      });
    }
    if (equation_first) {
      for (CurveSolution& solution : result_.solutions) std::swap(solution.t, solution.u);
      for (Overlap& overlap : result_.overlap) std::swap(overlap.t, overlap.u);
    }
  }

  void intersect_equations(const Polynomial& first, const Polynomial& second) {
    PlaneCurvesProblem problem;
    problem.p = first;
    problem.q = second;
    const Result plane = intersect_plane_curves(problem, options_, context_);
    result_.status = plane.status;
    result_.rest_status = plane.rest_status;
    result_.limit = plane.limit;
    result_.engine = plane.engine;
    result_.warnings = plane.warnings;
    const Counts& counts = plane.counts;
    result_.counts = {counts.distinct,
                      counts.real,
                      counts.undecided,
                      0,
                      counts.with_multiplicity + counts.at_infinity,
                      counts.bezout_number,
                      0};
    if (counts.at_infinity > 0)
      result_.warnings.push_back(std::to_string(counts.at_infinity) +
                                 " intersections, with multiplicity, lie at infinity and are not listed");
    for (const Solution& s : plane.solutions) {
      CurveSolution solution;
      const Coordinate one{ComplexBall(1, 0), "1", "0", Rational(1)};
      solution.point = {s.x, s.y, one};
      solution.multiplicity = s.multiplicity;
      solution.inside = s.reality == Reality::real;
      solution.radius_exponent = s.radius_exponent;
      solution.reality = s.reality;
      solution.certified = s.certified;
      solution.reason = s.reason;
      result_.solutions.push_back(std::move(solution));
    }
    if (plane.status == Status::infinite) result_.overlap.push_back({{}, {}, true});
  }

  const Options& options_;
  const Context& context_;
  CurveResult result_;
};

CurveResult solve_once(const CurveCurveProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  return CurveCurve(options, context).run(problem);
}

}  // namespace

CurveResult intersect_curve_curve(const CurveCurveProblem& problem, const Options& options, const Context& context) {
  return with_enough_digits(options, [&](const Options& more) { return solve_once(problem, more, context); });
}

}  // namespace eliminant::intersect
