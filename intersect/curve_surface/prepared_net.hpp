// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/contacts/exact_contact.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// The Bernstein coefficients of a map on its domain, exactly, and the domain.
struct PreparedNet {
  bridge::ExactNet exact;
  /// Of each parameter.
  std::vector<symbolic::Interval> domain;

  /// A point that is near the control points, with few digits.
  std::array<symbolic::Rational, 3> origin() const;
  /// Rounded, with its origin there; nullopt when a number is out of the range of doubles.
  std::optional<bridge::ControlNet> rounded(const std::array<symbolic::Rational, 3>& origin) const;
};

/// Of a curve, with z = 0 for one in the plane; nullopt without a domain of positive length.
std::optional<PreparedNet> prepared_net(const symbolic::CurvePiece& curve);

/// Of a tensor-product patch; nullopt for other surfaces, without a domain of positive area, and for a map that does
/// not depend on one of its parameters.
std::optional<PreparedNet> prepared_net(const symbolic::SurfacePiece& patch);

}  // namespace eliminant::intersect
