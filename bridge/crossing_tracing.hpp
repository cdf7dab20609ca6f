// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/bridge/branch_tracing.hpp>
#include <eliminant/bridge/contact_curve.hpp>

namespace eliminant::bridge {

/// The branch that crosses a curve of contact, from a point of it to the crossing, in the box of the crossing. The
/// patches are nearly tangent all along it: points are zeros of a divided difference, known as far as doubles tell both
/// patches apart, and the distance of chords follows from the second derivative of the branch. `error` may exceed the
/// tolerance, a distance in space.
TracedArc trace_to_crossing(const ContactCurve& curve, const CrossingPoint& from, const CurveCrossing& crossing,
                            double tolerance);

}  // namespace eliminant::bridge
