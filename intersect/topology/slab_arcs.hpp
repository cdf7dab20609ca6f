// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/topology/event_fibres.hpp>

namespace eliminant::intersect {

/// The arcs of a curve above the abscissae between two events: graphs of functions, ascending, none meets another.
struct SlabArcs {
  std::size_t count = 0;
  /// Relative to the box, the same all along; 0 without one.
  std::vector<Place> places;
  /// Points of each arc, by increasing x.
  std::vector<std::vector<std::array<double, 2>>> polylines;
};

/// Encloses arcs at rational abscissae and keeps account of the error.
class SlabSampler {
 public:
  SlabSampler(const symbolic::ReducedCurve& curve, const std::optional<Box>& box, const Context& context);
  /// The arcs between two events, of which a missing one is infinitely far away. Abscissae gather towards events, where
  /// tangents may be vertical; of unbounded arcs the part as wide as all events together, or 1 if there are none, is
  /// drawn.
  SlabArcs between(const EventFibre* before, const EventFibre* after, double width);
  /// The nearest doubles to a point.
  std::array<double, 2> nearest(const bridge::RealBall& x, const bridge::RealBall& y);
  /// The largest distance of a point from the doubles given for it, in one coordinate.
  double error() const { return error_; }

 private:
  double nearest(const bridge::RealBall& value);
  SlabArcs arcs_at(const std::vector<symbolic::Rational>& abscissae, const symbolic::Rational& safe);

  symbolic::HiddenVariablePolynomial g_;
  const std::optional<Box>& box_;
  const Context& context_;
  double error_ = 0;
};

}  // namespace eliminant::intersect
