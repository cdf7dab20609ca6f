// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A simple common point of a curve and a patch (parameters u; s, t) or of two plane curves (u; v).
struct IsolatedZero {
  /// Of the first, then of the second; the third is 0 for two curves.
  std::array<double, 3> parameters{};
  /// Each parameter is wrong by at most that: about the rounding of the control points times the condition of the zero,
  /// and below SubdivisionLimits::largest_radius.
  double radius = 0;
  /// There is no other zero whose parameters all differ by at most that.
  double isolation = 0;
};

/// A box of parameters, in the same order.
struct OpenBox {
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
};

/// What subdivision found of the common points within the closed domains.
struct SubdivisionResult {
  /// Each is proven to exist, and simple. Its enclosure may touch the border of the domain.
  std::vector<IsolatedZero> zeros;
  /// Parts of the domain that may hold common points besides: contacts, singular points. Not all of them, when
  /// `complete` is false.
  std::vector<OpenBox> open;
  /// Every part of the domain was excluded, is accounted for in `zeros`, or is in `open`.
  bool complete = true;
  /// Pairs of parts that were looked at.
  unsigned long pairs = 0;
};

/// How long to go on.
struct SubdivisionLimits {
  /// Boxes narrower than this in every parameter are left open.
  double smallest_width = 0x1p-24;
  /// As soon as so many are open, the rest is not looked at.
  std::size_t most_open = 1;
  unsigned long most_pairs = 20000;
  /// A zero that cannot be enclosed within that is left open.
  double largest_radius = 0x1p-26;
  /// How much of larger nets the two are, in their parameters: that much flatter they are.
  double part = 1;
};

/// Asked where parts are small and nearly parallel, with parameters in them: a box around a point of contact within
/// `reach` of these, in which there is no other common point; or nothing.
using FindContact = std::function<std::optional<OpenBox>(const std::array<double, 3>& near, double reach)>;

/// All common points of a Bezier curve and a patch, or of two plane curves (coordinates x, y and the weight), in
/// hardware doubles with a bound on every rounding. The two nets have one origin.
///
/// Subdivision by de Casteljau's algorithm. A pair of parts is multiplied by an approximate inverse of its Jacobian
/// matrix; the control points of the result, minus those of the identity, bound where zeros can be, which excludes the
/// pair or narrows the domain (quadratically in the end). A zero is proven where that bound maps the box into itself
/// (Brouwer) and the derivative is near the identity on it (uniqueness). Weights of mixed sign leave the result
/// incomplete. The box of a contact found counts as done. Sources: [MourrainPavone2009], [Krawczyk1969].
SubdivisionResult bernstein_subdivision(const ControlNet& first, const ControlNet& second,
                                        const FindContact& find_contact, const SubdivisionLimits& limits,
                                        const Context& context);

}  // namespace eliminant::bridge
