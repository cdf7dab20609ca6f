// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/branches/injectivity.hpp>
#include <eliminant/bridge/branches/pinch_point.hpp>
#include <eliminant/bridge/nets/zoomed_patches.hpp>

namespace eliminant::bridge {

/// Arcs for which doubles are too coarse unless they are zoomed in (ZoomedPatches): nearly tangential ones, and those
/// into singular points, by proven steps next to the point, where one chord is within the tolerance of what is known of
/// the intersection there.

/// An arc in its cell, which is small.
TracedArc trace_in_zoom(const PatchPairNets& nets, const CrossingPoint& from, const CrossingPoint& to,
                        const CellBox& box, double tolerance, const Context& context);

/// From a crossing point to a contact; `proven` is false where none of the chords is short enough.
TracedArc trace_to_contact(const PatchPairNets& nets, const CrossingPoint& from, const CellContact& contact,
                           double tolerance, const Context& context);

/// From double points of one patch, given twice by `nets`, to the pinch point of their arc; `rectangle` is the one in
/// which that is proven.
TracedArc trace_to_pinch_point(const PatchPairNets& nets, const std::array<double, 4>& from, const PinchPoint& pinch,
                               const ParameterRectangle& rectangle, double tolerance, const Context& context);

}  // namespace eliminant::bridge
