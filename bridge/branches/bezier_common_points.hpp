// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/contacts/exact_contact.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>

namespace eliminant::bridge {

/// A common point of a Bezier curve and a patch, or of two plane curves, within the closed domains.
struct BezierCommonPoint {
  /// An enclosure of its parameters.
  IsolatedZero zero;
  /// The parameters themselves where they were recognised as rational numbers.
  std::optional<std::array<symbolic::Rational, 3>> exact;
  /// Intersection multiplicity of the curve with the patch or the other curve there.
  unsigned long multiplicity = 1;
};

/// All common points, proven, none missing; nullopt where hardware doubles leave something undecided: a contact at
/// irrational parameters or of high order, a singular point of the patch, a common part, an irrational point on a
/// border, weights of mixed sign. The exact nets are asked for only where one of these comes up.
std::optional<std::vector<BezierCommonPoint>> bezier_common_points(const ControlNet& first, const ControlNet& second,
                                                                   const ContactProver::Exact& exact_first,
                                                                   const ContactProver::Exact& exact_second,
                                                                   const Context& context);

}  // namespace eliminant::bridge
