// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

using SpacePoint = std::array<Rational, 3>;

// Notation. p_1, ..., p_5 the points, t = (x, y, z) a direction, |t x d|^2 = (t.t)(d.d) - (t.d)^2 = N_d(t).

/// The directions of the circular cylinders through five points, exactly.
struct CylinderConditions {
  enum class Kind {
    /// The points span the space: a conic and a cubic, 6 common zeros. A common zero with t.t = 0 is no cylinder.
    general,
    /// The points span a plane and lie on one conic there, an ellipse, a hyperbola or two crossing lines: two conics,
    /// 4 common zeros, each of them a cylinder.
    coplanar,
    /// The same with a parabola: no cylinder at all, and no conditions.
    parabola,
    /// Infinitely many cylinders.
    infinite,
  };
  Kind kind = Kind::general;
  /// Forms in x, y, z, primitive over Z: 0 unless the kind is general or coplanar.
  Polynomial first{3};
  Polynomial second{3};
  /// Of infinitely many: why, as a sentence without a full stop.
  std::string reason;
  /// Of infinitely many: the form whose general zero is the direction of a cylinder, where there is one.
  std::optional<Polynomial> directions;
};

/// With the offsets d_k = p_(k+1) - p_1 and sum_k w_k d_k = 0, the conic of the general kind is sum_k w_k N_k, the
/// cubic N_a (d_b x d_c).t + N_b (d_c x d_a).t + N_c (d_a x d_b).t, a, b, c the offsets of a tetrahedron: four of the
/// points that span the space. All other such cubics are combinations of these two; the edges of the tetrahedron are
/// zeros of the cubic, and of the conic exactly where they are directions of cylinders. So the spurious zeros of two
/// cubics never come up, and multiplicities are those of the cylinders.
///
/// In a plane spanned by offsets a, b: where A u^2 + B u v + C v^2 + ... = 0 is the conic through the points u a + v b,
/// N_(u a + v b)(t), a quadratic form in (u, v), is proportional to its leading form: minors of the two.
/// Source: the cubics are those of [BuseKhalilMourrain2005], section 5.3, without its choice of coordinates.
CylinderConditions cylinder_conditions(const std::array<SpacePoint, 5>& points);

SpacePoint difference(const SpacePoint& a, const SpacePoint& b);
SpacePoint cross_product(const SpacePoint& a, const SpacePoint& b);
Rational dot_product(const SpacePoint& a, const SpacePoint& b);

}  // namespace eliminant::symbolic
