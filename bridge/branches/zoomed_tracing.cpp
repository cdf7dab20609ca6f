// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/branches/zoomed_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/contacts/surface_contact.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

namespace eliminant::bridge {

namespace {

constexpr CellBox whole{{0, 0, 0, 0}, {1, 1, 1, 1}};

/// Where the last chord may begin: within `near` of the singular point in every parameter.
struct LastChord {
  double near = 0;
  /// Bounds the distance in space of arc and chord.
  double error = 0;
};

CellBox box_around(const std::array<double, 4>& centre, double half) {
  CellBox box;
  for (std::size_t k = 0; k < 4; ++k) {
    box.lower[k] = centre[k] - half;
    box.upper[k] = centre[k] + half;
  }
  return box;
}

/// The largest of the values `near`, `near` / 2, ... for which `error` of it is below the tolerance.
template <class Error>
std::optional<LastChord> last_chord(double near, double tolerance, Error error) {
  constexpr int most_halvings = 40;
  for (int i = 0; i < most_halvings; ++i, near *= 0.5) {
    const std::optional<double> bound = error(near);
    if (bound && *bound < tolerance) return LastChord{near, *bound};
  }
  return std::nullopt;
}

/// How far to zoom in: the length of the last chord follows from any chord whose error is known, and is small in the
/// zoom.
template <class Error>
std::optional<double> zoom_for(double near, double tolerance, Error error) {
  const auto known = last_chord(near, INFINITY, error);
  if (!known) return std::nullopt;
  constexpr double largest = 0.125;
  constexpr double chords = 32;
  const double expected = known->near * std::min(1.0, std::sqrt(tolerance / known->error));
  return std::min(largest, std::exp2(std::round(std::log2(chords * expected))));
}

/// From the original nets through zooms in between to the last one, and to the last chord.
TracedArc trace_zoomed(const PatchPairNets& nets, const ZoomedPatches& zoomed, const std::array<double, 4>& from,
                       const std::array<double, 4>& goal, const CellBox& box, const LastChord& chord, double tolerance,
                       const Context& context) {
  // A zoom is left where a hundredth of it would be needed.
  constexpr double step = 0x1p-6;
  std::vector<double> halves;
  for (double half = step; half > zoomed.half(); half *= step) halves.push_back(half);
  halves.push_back(zoomed.half());
  TracedArc arc =
      ArcTracer(nets.first, nets.second).trace_near(from, goal, box, 0.5 * halves.front(), tolerance, context);
  for (std::size_t i = 0; i < halves.size() && arc.proven; ++i) {
    const bool last = i + 1 == halves.size();
    const auto here = last ? std::optional(zoomed) : ZoomedPatches::around(nets, zoomed.centre(), halves[i]);
    if (!here) return {};
    const PatchPairNets local = here->nets();
    const double near = last ? chord.near : 0.25 * halves[i + 1] / halves[i];
    const TracedArc rest = ArcTracer(local.first, local.second)
                               .trace_near(here->zoomed(arc.points.back().parameters), here->zoomed(goal), whole, near,
                                           tolerance, context);
    for (const TracedPoint& point : rest.points) arc.points.push_back(here->original(point));
    arc.error = std::max(arc.error, rest.error);
    arc.proven = rest.proven;
  }
  arc.error = std::max(arc.error, chord.error);
  return arc;
}

/// Doubles may not tell both patches apart well enough for the tolerance: then the error is larger.
template <class Trace>
TracedArc to_best_tolerance(double tolerance, Trace trace) {
  TracedArc arc;
  constexpr int most_attempts = 4;
  constexpr double factor = 16;
  for (int i = 0; i < most_attempts && !arc.proven; ++i, tolerance *= factor) arc = trace(tolerance);
  return arc;
}

TracedPoint point_at(const ControlNet& net, const std::array<double, 4>& parameters) {
  TracedPoint result;
  result.parameters = parameters;
  const PatchJets::Value value = PatchJets(net).at(parameters[0], parameters[1]);
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = value.point[static_cast<long>(k)];
  return result;
}

TracedArc contact_arc(const PatchPairNets& nets, const CrossingPoint& from, const CellContact& contact,
                      double tolerance, const Context& context) {
  const auto chord_error = [](const PatchPairNets& of, const SurfaceContact& at) {
    return [&of, &at](double near) -> std::optional<double> {
      const SurfaceContactProver prover(of.first, of.second, of.exact_first, of.exact_second);
      const auto around = prover.neighbourhood(at, box_around(at.rounded, near));
      if (!around) return std::nullopt;
      return around->chord_error;
    };
  };
  double least = 1;
  for (std::size_t k = 0; k < 4; ++k) least = std::min(least, contact.box.upper[k] - contact.box.lower[k]);
  const auto half = zoom_for(0.25 * least, tolerance, chord_error(nets, contact.contact));
  if (!half) return {};
  const auto zoomed = ZoomedPatches::around(nets, contact.contact.parameters, *half);
  if (!zoomed) return {};
  const symbolic::Rational exact_middle = exactly(0.5);
  SurfaceContact centre;
  centre.parameters.fill(exact_middle);
  centre.rounded.fill(0.5);
  const PatchPairNets local = zoomed->nets();
  const auto chord = last_chord(0.0625, tolerance, chord_error(local, centre));
  if (!chord) return {};
  TracedArc arc =
      trace_zoomed(nets, *zoomed, from.parameters, contact.contact.rounded, contact.box, *chord, tolerance, context);
  arc.points.push_back(point_at(nets.first, contact.contact.rounded));
  return arc;
}

std::optional<ZoomedPatches> zoom_to(const PatchPairNets& nets, const PinchPoint& pinch, double half) {
  const symbolic::Rational u = exactly(pinch.parameters[0]);
  const symbolic::Rational v = exactly(pinch.parameters[1]);
  return ZoomedPatches::around(nets, {u, v, u, v}, half);
}

TracedArc pinch_arc(const PatchPairNets& nets, const std::array<double, 4>& from, const PinchPoint& pinch,
                    const ParameterRectangle& rectangle, double tolerance, const Context& context) {
  const auto chord_error = [](const ControlNet& net, const PinchPoint& at) {
    return [&net, &at](double near) { return reach_of_pinch_point(net, at, near); };
  };
  const auto half = zoom_for(0x1p-6, tolerance, chord_error(nets.first, pinch));
  if (!half) return {};
  std::optional<ZoomedPatches> zoomed;
  // There its place is known better.
  std::optional<PinchPoint> close;
  constexpr double least = 0x1p-40;
  for (double size = *half; !close && size > least; size *= 0.5) {
    zoomed = zoom_to(nets, pinch, size);
    if (!zoomed) return {};
    close = pinch_point_in(zoomed->nets().first, {{0.25, 0.25}, {0.75, 0.75}});
  }
  if (!close) return {};
  const PatchPairNets local = zoomed->nets();
  const auto chord = last_chord(0.0625, tolerance, chord_error(local.first, *close));
  if (!chord) return {};
  TracedPoint end;
  end.parameters = {close->parameters[0], close->parameters[1], close->parameters[0], close->parameters[1]};
  end = point_at(nets.first, zoomed->original(end).parameters);
  const CellBox box{{rectangle.lower[0], rectangle.lower[1], rectangle.lower[0], rectangle.lower[1]},
                    {rectangle.upper[0], rectangle.upper[1], rectangle.upper[0], rectangle.upper[1]}};
  TracedArc arc = trace_zoomed(nets, *zoomed, from, end.parameters, box, *chord, tolerance, context);
  arc.points.push_back(end);
  return arc;
}

}  // namespace

TracedArc trace_in_zoom(const PatchPairNets& nets, const CrossingPoint& from, const CrossingPoint& to,
                        const CellBox& box, double tolerance, const Context& context) {
  std::array<symbolic::Rational, 4> centre;
  double half = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    centre[k] = exactly(0.5 * (box.lower[k] + box.upper[k]));
    half = std::max(half, 0.5 * (box.upper[k] - box.lower[k]));
  }
  // Steps near the ends of the arc reach a little beyond the box.
  constexpr double room = 1.5;
  const auto zoomed = ZoomedPatches::around(nets, centre, room * half);
  if (!zoomed) return {};
  const auto placed = [&](const CrossingPoint& point) {
    CrossingPoint result = point;
    result.parameters = zoomed->zoomed(point.parameters);
    result.radius = point.radius / (2 * zoomed->half());
    return result;
  };
  CellBox cell;
  cell.lower = zoomed->zoomed(box.lower);
  cell.upper = zoomed->zoomed(box.upper);
  const PatchPairNets local = zoomed->nets();
  TracedArc arc = ArcTracer(local.first, local.second).trace(placed(from), placed(to), cell, tolerance, context);
  for (TracedPoint& point : arc.points) point = zoomed->original(point);
  return arc;
}

TracedArc trace_to_contact(const PatchPairNets& nets, const CrossingPoint& from, const CellContact& contact,
                           double tolerance, const Context& context) {
  return to_best_tolerance(tolerance, [&](double t) { return contact_arc(nets, from, contact, t, context); });
}

TracedArc trace_to_pinch_point(const PatchPairNets& nets, const std::array<double, 4>& from, const PinchPoint& pinch,
                               const ParameterRectangle& rectangle, double tolerance, const Context& context) {
  return to_best_tolerance(tolerance, [&](double t) { return pinch_arc(nets, from, pinch, rectangle, t, context); });
}

}  // namespace eliminant::bridge
