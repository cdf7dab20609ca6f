// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// A point of a curve at a root of a condition on its parameter.
struct PointOnCurve {
  /// Homogeneous coordinates.
  std::vector<bridge::ComplexBall> coordinates;
  /// The root; nullptr at a rational parameter, or at t = infinity where that is absent too.
  ParameterRoots* roots = nullptr;
  std::size_t index = 0;
  std::optional<symbolic::Rational> exact_t;
  bool real = false;
  long precision_bits = 0;
};

/// What enclosures say to a question.
enum class Answer { yes, no, unknown };

enum class Filling {
  done,
  more_precision,  ///< the balls are too wide
  left_out         ///< the point does not belong to the part that was asked for
};

/// Adds to a solution what lies beyond the curve: parameters on a surface, whether they are inside.
using FillSolution = std::function<Filling(CurveSolution&, const PointOnCurve&)>;

/// Real solutions only: as the options say, else where a part was asked for.
bool real_only(const Options& options, bool has_domain);

/// Adds the roots of a condition that is not zero, of degree condition.degree(), as solutions with the parameter t and
/// the point, and their counts. Multiplicities are divided by `map_degree`.
void add_condition_roots(const symbolic::CurvePiece& piece, const symbolic::ParameterForm& condition, long map_degree,
                         bool real_solutions, const Options& options, const Context& context, const FillSolution& fill,
                         CurveResult& result);

/// A rational parameter as it is printed, known exactly.
Parameter exactly(const symbolic::Rational& value, const Options& options);

/// The form of an equation: homogeneous in one more variable, the weight, primitive.
symbolic::Polynomial homogenized(const symbolic::Polynomial& equation);

/// A form in the homogeneous coordinates along a curve: zero where the curve lies on it.
symbolic::ParameterForm along_curve(const symbolic::RationalCurve& curve, const symbolic::Polynomial& form);

/// The part of the curve that its domain leaves.
Overlap whole_curve(const symbolic::CurvePiece& piece, const Options& options);

/// True when the curve of a piece arrives where the next one begins, so that a solution there is one.
bool joined(const symbolic::CurvePiece& before, const symbolic::CurvePiece& after);

/// Whether the parameter is known to be the number, or, where it is not known exactly, has a ball that contains it.
bool is_at(const std::optional<Parameter>& parameter, const symbolic::Rational& value);

/// Adds up counts, and what else a part of a problem says.
void add_part(Status status, const CurveCounts& counts, const EngineReport& engine,
              const std::vector<std::string>& warnings, CurveResult& result);

/// Solves with twice as many digits until the printed boxes are disjoint.
template <class Solve>
CurveResult with_enough_digits(const Options& options, Solve solve) {
  constexpr int most_doublings = 8;
  Options more = options;
  for (int doubling = 0;; ++doubling) {
    CurveResult result = solve(more);
    if (doubling == most_doublings || !crowded(result.solutions)) return result;
    more.digits *= 2;
  }
}

/// Sorts, counts what is listed, and settles the status.
void finish(const Options& options, CurveResult& result);

}  // namespace eliminant::intersect
