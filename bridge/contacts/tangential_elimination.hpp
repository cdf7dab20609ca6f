// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/enclosed_patch.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

/// A symmetric matrix of order 2.
struct Hessian {
  DoubleInterval uu;
  DoubleInterval uv;
  DoubleInterval vv;

  DoubleInterval form(const std::array<double, 2>& a, const std::array<double, 2>& b) const;
  DoubleInterval determinant() const { return uu * vv - uv * uv; }
};

/// Parts of two patches that are nearly parallel, with two of their four parameters eliminated: (s, t) is the function
/// of (u, v) that keeps the coordinates along the tangent plane equal, and the rest of the difference, along the
/// normal, is one function h of (u, v).
///
/// The function is proven to be unique, and to be there for all (u, v) in the box, by a contraction in parameters in
/// which the derivative of the second patch along the plane is near the identity.
struct TangentialElimination {
  /// The tangent plane of the first patch.
  ContactFrame frame;
  /// On the box, and on a box around all values of the function.
  EnclosedPatch first;
  EnclosedPatch second;
  /// The derivative of the function at its centre, along the plane; for steps in its coordinates.
  std::array<std::array<double, 2>, 2> inverse;
  /// Bounds the contraction.
  double contraction = 0;
  /// Of h, for all (u, v) in the box.
  std::array<DoubleInterval, 2> gradient;
  Hessian hessian;

  /// Around `centre` (u, v, s, t), at which both patches have nearly the same coordinates along the plane; it lies in
  /// the box. nullopt where the parts turn too much.
  static std::optional<TangentialElimination> on(const ControlNet& first, const ControlNet& second,
                                                 const std::array<double, 4>& centre, const CellBox& box);
};

}  // namespace eliminant::bridge
