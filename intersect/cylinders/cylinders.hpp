// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/geometry/cylinder_conditions.hpp>

namespace eliminant::intersect {

/// Five points of space, any of them, also equal ones.
struct CylindersProblem {
  std::array<symbolic::SpacePoint, 5> points;
};

/// A circular cylinder over the complex numbers: the points p with |t x (p - a)|^2 = r^2 (t.t), where t.t is not 0.
struct CylinderSolution {
  /// t. Of a real cylinder of unit length; its largest coordinate is positive. Of another one the largest coordinate is
  /// 1. Of coordinates that are equally large, to within one in a million, the first counts.
  std::array<Coordinate, 3> direction;
  /// a, the point of the axis with (a - g).t = 0, g the centroid of the five points: of a real cylinder the one nearest
  /// to it.
  std::array<Coordinate, 3> axis_point;
  Coordinate radius_squared;
  /// Of a real cylinder.
  std::optional<Coordinate> radius;
  /// Powers of ten that bound the distance of the true numbers in each coordinate: 10^exponent.
  long direction_error_exponent = 0;
  long axis_point_error_exponent = 0;
  long radius_error_exponent = 0;
  long radius_squared_error_exponent = 0;
  /// 10^exponent bounds ||t x (p - a)|^2 / (t.t) - r^2| at the five points for the numbers as they are printed; unset
  /// for exactly 0.
  std::optional<long> residual_exponent;
  Reality reality = Reality::undecided;
  unsigned long multiplicity = 1;
  /// Exactly one cylinder has a direction within the error, it has this multiplicity, and all errors are proven.
  bool certified = false;
  std::string reason;  ///< why not, where `certified` is false
};

/// bezout_number = with_multiplicity + isotropic.
struct CylinderCounts {
  unsigned long distinct = 0;
  unsigned long real = 0;
  unsigned long with_multiplicity = 0;
  /// Common zeros with t.t = 0, with multiplicity: no cylinders.
  unsigned long isotropic = 0;
  /// 6; 4 for coplanar points on an ellipse, a hyperbola or two crossing lines; 0 on a parabola.
  unsigned long bezout_number = 0;
  unsigned long listed = 0;
};

struct CylindersResult {
  std::string problem = "cylinders";
  Status status = Status::numeric;
  std::optional<std::string> limit;       ///< only for `incomplete`: what ended the computation
  std::optional<Status> rest_status;      ///< only for `infinite` with solutions
  std::optional<std::string> degeneracy;  ///< where the points are special: in which way, as a sentence
  /// Only for `infinite`: a form in x, y, z whose general zero is the direction of a cylinder, where there is one.
  std::optional<symbolic::Polynomial> directions;
  CylinderCounts counts;
  /// Sorted by the printed direction: (Re x, Im x, Re y, Im y, Re z, Im z).
  std::vector<CylinderSolution> solutions;
  EngineReport engine;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

/// The circular cylinders through five points: six complex ones with multiplicity, unless the points are special. The
/// directions are solved as two plane curves in a chart that nothing escapes from; axis and radius follow in ball
/// arithmetic. The answer does not depend on the order of the points.
/// Throws InvalidInput when an option is out of range, and LimitReached.
/// Source: [BuseKhalilMourrain2005], section 5.3; docs/cylinders.md.
CylindersResult cylinders_through(const CylindersProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
