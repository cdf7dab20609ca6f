// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/numeric/cylinder_through_points.hpp>

namespace eliminant::intersect {

/// A real cylinder in doubles, with proven bounds of the distance of the true numbers, in each coordinate.
struct EnclosedCylinder {
  numeric::Cylinder cylinder;
  double direction_error = 0;  ///< at most 1e-6
  double axis_point_error = 0;
  double radius_error = 0;  ///< at most 1e-6 of the radius
  unsigned long multiplicity = 1;
};

struct EnclosedCylinders {
  /// certified: all real cylinders are listed, each once, each within its errors. infinite: there are infinitely many,
  /// or the points are special enough for it to be unknown; nothing is listed.
  Status status = Status::infinite;
  numeric::AtMostSix<EnclosedCylinder> cylinders;
  /// Hardware doubles did not decide, and exact arithmetic did.
  bool exact = false;
};

/// The real circular cylinders through five points given in doubles, which are taken as exact: the fast entry, for
/// points of clouds and for coordinates that are integers below 2^53. First the interval test in hardware doubles
/// (bridge/certificates/cylinder_direction_certificate), then, where it does not decide, cylinders_through.
/// Throws InvalidInput when a coordinate is not finite, and LimitReached.
EnclosedCylinders enclosed_real_cylinders(const std::array<std::array<double, 3>, 5>& points,
                                          const Context& context = {});

}  // namespace eliminant::intersect
