// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>

namespace eliminant::intersect {

/// Where an arc of a curve of contact ends.
struct ContactArcEnd {
  /// Of u, v, s, t: -1 where the parameter is 0, 1 where it is 1, else 0.
  std::array<int, 4> side{};
  /// At a point where a branch crosses: index into those given.
  std::optional<std::size_t> crossing;
};

/// A piece of a curve of contact in both domains.
struct ContactArc {
  bool closed = false;
  /// From start to end; of a closed one the last point is the first.
  std::vector<bridge::TracedPoint> points;
  ContactArcEnd start;
  ContactArcEnd end;
  /// Bounds the distance in space of the polyline from the arc and the other way round; only if `proven`.
  double error = 0;
  bool proven = true;
};

struct ContactArcs {
  std::vector<ContactArc> arcs;
  /// These are all, each is smooth between its ends, and none is cut where it does not end.
  bool complete = true;
};

/// All of a curve of contact of two patches on [0, 1]^2, by the certified topology of its equation in the parameters of
/// `base`, cut where it leaves either domain and at the crossings given (u, v, s, t). Points are those of the base.
ContactArcs contact_arcs(const bridge::ContactCurve& curve, const PatchNets& base,
                         const std::vector<bridge::CurveCrossing>& crossings, double tolerance, double size,
                         const Context& context);

}  // namespace eliminant::intersect
