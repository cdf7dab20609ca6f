// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <eliminant/numeric/cylinder_sample.hpp>

namespace eliminant::numeric {

/// Hypotheses of about the same cylinder.
struct CylinderVotes {
  /// The one with the largest share.
  CylinderHypothesis best;
  std::size_t votes = 0;
};

/// Whether two cylinders agree: directions within 5 degrees, radii within 15 per cent, and the axis of `b` within a
/// quarter of its radius of that of `a`, seen from `near`.
bool same_cylinder(const Cylinder& a, const Cylinder& b, const Point& near);

/// Gathers hypotheses by direction on the sphere, where e and -e are one, then by axis and radius; most votes first.
/// The result follows from the order of the hypotheses.
std::vector<CylinderVotes> gather_votes(std::span<const CylinderHypothesis> hypotheses, std::span<const Point> points);

}  // namespace eliminant::numeric
