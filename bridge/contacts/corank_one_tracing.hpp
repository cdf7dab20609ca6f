// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>

namespace eliminant::bridge {

/// The half-branch of a contact of corank one from a crossing point on the border of its box to the contact. Next to it
/// both patches differ by less than doubles tell them apart, and arcs that touch are nearer than any tube around them:
/// points are those of CorankOnePatches, each with the error of its own, and how the branch bends between two of them
/// is bounded by CorankOneBranches. `first` and `second` are the patches.
TracedArc trace_to_corank_one(const ControlNet& first, const ControlNet& second, const CrossingPoint& from,
                              const CellContact& contact, double tolerance, const Context& context);

}  // namespace eliminant::bridge
