// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/bezier_common_points.hpp>
#include <eliminant/bridge/certificates/krawczyk_system.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// What the box engine proved of a common point, in parameters of [0, 1], and how it becomes a solution in the
/// parameters of the maps.
struct BoxSolution {
  const bridge::BezierCommonPoint& point;
  /// Of the first, then of the second.
  const std::vector<symbolic::Interval>& domains;

  /// The exact parameters; only where they are known.
  std::vector<symbolic::Rational> exact_parameters() const;

  /// The solution there, without its parameters on the second.
  CurveSolution exact_on(const symbolic::RationalCurve& first, const Options& options) const;

  using Print = std::function<std::optional<CurveSolution>(const std::vector<bridge::ComplexBall>& zero, long bits)>;
  /// Encloses the zero of the system, a function of the parameters in the same order, until `print` has the digits it
  /// needs. nullopt where the system's zero cannot be shown to be the one of the box engine, or a printed number may be
  /// zero.
  std::optional<CurveSolution> refined(const bridge::System& system, const Options& options, const Print& print) const;
};

}  // namespace eliminant::intersect
