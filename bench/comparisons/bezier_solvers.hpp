// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <support/bezier_case.hpp>

/// The solvers that intersect Bezier curves with patches and with each other. Each takes a case and gives a run that
/// may be repeated: both objects are in the solver's own form before it begins.
namespace eliminant::comparisons {

/// Parameters on the (first) curve.
struct FoundParameters {
  std::vector<double> points;
  /// Stretches that the solver takes for common; a contact may be one.
  std::vector<std::array<double, 2>> stretches;
  bool complete = true;  ///< of eliminant: certified
};

using BezierRun = std::function<FoundParameters()>;

/// All intersections within the domains, certified.
BezierRun eliminant_bezier(const test::BezierCase& bezier);
/// GeomAPI_IntCS, and Geom2dAPI_InterCurveCurve at its tolerance of 1e-6.
BezierRun occt_bezier(const test::BezierCase& bezier);
/// s1858 and s1857 at a tolerance of 1e-6.
BezierRun sisl_bezier(const test::BezierCase& bezier);

/// Name and version; SISL does not tell its own.
std::string occt_version();
std::string sisl_version();

}  // namespace eliminant::comparisons
