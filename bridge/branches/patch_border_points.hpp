// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A point of the intersection on the border of a domain.
struct BorderPoint : CrossingPoint {
  /// Arcs inside both domains that end there: 0 for a point of its own (the patches touch in a corner or from outside),
  /// 1, or 2 for an arc that touches the border from inside.
  unsigned arcs = 1;
  /// The intersection is tangent to the border.
  bool touching = false;
};

/// A border curve of which not everything could be decided in doubles.
struct OpenBorder {
  /// The parameter that is kept (u, v, s, t), and -1 or 1 for its lower or upper bound.
  std::size_t axis = 0;
  int side = -1;
  std::string reason;
};

/// A border curve that touches the other patch in a point in which more than that had to be known to tell what begins
/// or ends there; of the rest of the border curve everything is known.
struct TouchedBorder {
  std::array<symbolic::Rational, 4> parameters;
  OpenBorder border;
};

struct BorderPoints {
  /// Those on several borders at once are listed once.
  std::vector<BorderPoint> points;
  /// Not among the points: decided where these parameters are those of a contact that is known (CellContact).
  std::vector<TouchedBorder> touched;
  /// Border curves that belong to the intersection; points on them are not listed.
  std::vector<ContainedBorder> contained;
  std::vector<OpenBorder> open;
};

/// Where a border curve of the first patch meets one of the second, proven: the parameters on both curves, in [0, 1],
/// to within 1e-11. Asked for only where doubles cannot tell.
using BorderMeetings = std::function<std::vector<std::array<double, 2>>(std::size_t first_axis, int first_side,
                                                                        std::size_t second_axis, int second_side)>;

/// What is proven of a border curve that may lie in the other patch.
struct ContainedParts {
  /// Closed intervals that lie in the other patch.
  std::vector<std::array<double, 2>> intervals;
  /// It has no other point in common with the other patch.
  bool nothing_else = false;
  /// It is one point.
  bool one_point = false;
};

/// Asked for only where doubles leave it open.
using FindContainedParts = std::function<ContainedParts(std::size_t axis, int side)>;

/// All points of two tensor-product patches on [0, 1]^2 that lie on the border of one of them: each of the eight border
/// curves against the other patch. Which of them lie on a border of the other patch, too, is decided exactly: by
/// rational parameters, where two border curves lie in one plane that the patch crosses, or by `meetings`. Points of
/// curves of contact, which `curves` (if given) looks for, are left out.
BorderPoints patch_border_points(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
                                 const ExactNet& exact_second, const BorderMeetings& meetings,
                                 const FindContainedParts& contained_parts, const Context& context,
                                 ContactCurves* curves = nullptr);

}  // namespace eliminant::bridge
