// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/roots/fibre_isolation.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/elimination/curve_events.hpp>

namespace eliminant::intersect {

/// Where a number lies relative to [lower, upper]: -2 below, -1 at the lower end, 0 inside, 1 at the upper end, 2
/// above. Where both ends are one number, that is -1.
using Place = int;

inline bool is_inside(Place place) { return place >= -1 && place <= 1; }

/// A real point of a curve on the fibre of an event.
struct EventPoint {
  bridge::RealBall y;
  /// Where y is an end of the box.
  std::optional<symbolic::Rational> exact_y;
  /// A point with a vertical tangent, or singular: as a solution of g = g_y = 0.
  std::optional<Solution> critical;
  /// Multiplicity of y as a root of g(alpha, y).
  unsigned long fibre_multiplicity = 1;
  /// Arcs that end here.
  std::size_t left = 1;
  std::size_t right = 1;
  /// Relative to the box; 0 without one.
  Place place = 0;

  /// Of the curve g = 0, by Teissier's formula.
  unsigned long milnor_number() const { return critical ? critical->multiplicity - fibre_multiplicity + 1 : 0; }
};

/// An abscissa alpha at which the real points of the curve above x may change, or an end of the box.
struct EventFibre {
  bridge::RealBall x;
  /// Where it is an end of the box.
  std::optional<symbolic::Rational> exact_x;
  /// [before, after] holds alpha and no other event.
  symbolic::Rational before;
  symbolic::Rational after;
  /// x = alpha is a component of the curve.
  bool vertical_line = false;
  /// Ascending: the real points of the rest of the curve above alpha.
  std::vector<EventPoint> points;
  /// Arcs that tend to -inf (0) and inf (1) as x tends to alpha.
  std::array<std::size_t, 2> left_to_infinity{};
  std::array<std::size_t, 2> right_to_infinity{};
};

struct EventFibres {
  /// Ascending; with a box from its left to its right border.
  std::vector<EventFibre> fibres;
  EngineReport engine;
  Status status = Status::certified;
  std::vector<std::string> warnings;
};

/// All events of a curve, with what happens at each. Throws PrecisionExhausted when no number of digits within reason
/// tells critical points apart.
EventFibres event_fibres(const symbolic::ReducedCurve& curve, const std::optional<Box>& box, const Options& options,
                         const Context& context);

/// Where a root of a rational fibre lies relative to the heights of the box; 0 without one.
Place place_of(bridge::RationalFibre& fibre, std::size_t root, const std::optional<Box>& box);

}  // namespace eliminant::intersect
