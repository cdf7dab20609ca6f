// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/contacts/contact_curve.hpp>

namespace eliminant::bridge {

/// The branch that crosses a curve of contact, from a crossing point on the border of its box to the crossing. Its
/// points are those of the base of the curve. `proven` is false where the branch was lost.
TracedArc trace_to_crossing(const ContactCurve& curve, const CrossingPoint& from, const CurveCrossing& crossing,
                            double tolerance, const Context& context);

}  // namespace eliminant::bridge
