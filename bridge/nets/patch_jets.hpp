// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/net_side.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

/// Partial derivatives of a patch: of order k by (k, 0), (k - 1, 1), ..., (0, k).
struct Partials {
  std::array<Array4d, 2> first;
  std::array<Array4d, 3> second;
};

/// Bounds of their absolute values on a box of parameters, affine coordinates.
struct DerivativeBounds : Partials {
  std::array<Array4d, 4> third;
};

/// The second derivative in the direction (p, q).
inline Array4d along(const std::array<Array4d, 3>& second, double p, double q) {
  return second[0] * (p * p) + second[1] * (2 * p * q) + second[2] * (q * q);
}

/// Affine values and derivatives of a tensor-product patch with positive weights.
class PatchJets {
 public:
  /// The net must outlive the object.
  explicit PatchJets(const ControlNet& net);

  std::size_t degree(std::size_t axis) const { return shape_.degree[axis]; }

  struct Value : Partials {
    Array4d point;
    /// Bounds that of each coordinate of the point.
    double error = 0;
  };
  /// At parameters within a fiftieth of the domain; the derivatives are rounded as the value is.
  Value at(double a, double b);
  /// The second derivatives are left 0.
  Value slopes_at(double a, double b);

  /// On a box of parameters, which may reach a little beyond the domain; nullopt where a weight may not be positive.
  std::optional<DerivativeBounds> bounds_on(double a0, double a1, double b0, double b1) const;

 private:
  template <std::size_t Order>
  Value jet(double a, double b);
  Array4d divide_by_weight(Value& value) const;
  std::array<std::array<Array4d, 4>, 4> largest_derivatives(std::vector<Array4d> points, double width_a,
                                                            double width_b) const;

  const ControlNet& net_;
  NetShape<2> shape_;
  Array4d error_;
  std::vector<Array4d> scratch_;
  std::vector<Array4d> rows_;
};

/// The tangent plane at a point becomes the first two coordinates, dual to the partial derivatives, the unit normal the
/// third; nullopt at a singular point.
std::optional<ContactFrame> tangent_frame(const PatchJets::Value& at);

}  // namespace eliminant::bridge
