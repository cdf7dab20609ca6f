// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <eliminant/bridge/contacts/contact_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/bernstein_subdivision.hpp>
#include <eliminant/bridge/nets/columns.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// Affine coordinates in which a contact is at the origin, the tangents of the second side are along the first ones and
/// the normal is the last: enclosures are tight in them.
struct ContactFrame {
  Array4d origin = Array4d::Zero();
  /// A matrix by columns; the last lane is 0.
  Columns columns{Array4d::Zero(), Array4d::Zero(), Array4d::Zero()};
};

/// A coordinate of a direction in a frame.
inline double coordinate(const ContactFrame& frame, const Array4d& direction, long row) {
  return direction[0] * frame.columns[0][row] + direction[1] * frame.columns[1][row] +
         direction[2] * frame.columns[2][row];
}

/// The Taylor coefficients of one side at all points of a box of parameters, in a frame, enclosed by differences of
/// control points. The parameters of the side are those of the box from index `first` on.
TaylorTable<DoubleInterval> taylor_on_box(const ControlNet& net, const ContactFrame& frame, const OpenBox& box,
                                          std::size_t first, std::size_t order);

/// A patch on a box of parameters, in powers of local parameters that run from -1 to 1.
struct LocalPowers {
  std::array<std::size_t, 2> degree{};
  /// Of x^i y^j at i * (degree[1] + 1) + j, homogeneous.
  std::vector<Array4d> coefficients;
  /// Bounds how far the polynomials are from the patch anywhere on the box.
  Array4d error;
};

/// In a frame, the parameters of the patch being those of the box from index `first` on.
LocalPowers local_powers(const ControlNet& net, const ContactFrame& frame, const OpenBox& box, std::size_t first);

/// The Taylor coefficients at a point, approximately; the second parameter counts for a patch.
TaylorTable<double> taylor_near(const ControlNet& net, double a, double b, std::size_t order);

/// Exact Taylor coefficients at a rational point; the second parameter counts for a patch.
TaylorTable<symbolic::Rational> taylor_at(const ExactNet& net, const std::array<symbolic::Rational, 2>& at,
                                          std::size_t order);

/// The doubles around a rational number.
DoubleInterval enclosed(const symbolic::Rational& value);

/// Exact coefficients at a common point, moved there and in a frame, with the weights of the net in doubles.
TaylorTable<DoubleInterval> enclosed(const TaylorTable<symbolic::Rational>& exact, const ControlNet& net,
                                     const ContactFrame& frame);

}  // namespace eliminant::bridge
