// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A tensor-product patch to be evaluated at real points in ball arithmetic.
class BallPatch {
 public:
  /// On [0, 1]^2, with all numbers rounded to `precision_bits` in enclosures.
  BallPatch(const ExactNet& net, long precision_bits);

  /// Encloses the affine point at these parameters. The weight must not be zero there: else its coordinates are not
  /// finite.
  std::array<RealBall, 3> point_at(const RealBall& u, const RealBall& v) const;

  /// The affine point and its derivatives by both parameters.
  struct Jet {
    std::array<RealBall, 3> point;
    std::array<std::array<RealBall, 3>, 2> by;
  };
  Jet jet_at(const RealBall& u, const RealBall& v) const;

 private:
  RealBall coordinate_at(std::size_t k, const RealBall& u, const RealBall& v) const;
  /// The value, and the derivatives by u and v.
  std::array<RealBall, 3> coordinate_jet_at(std::size_t k, const RealBall& u, const RealBall& v) const;

  long precision_bits_;
  bool polynomial_ = true;
  std::array<std::size_t, 2> degree_{};
  /// Of u^i v^j, row by row, in each homogeneous coordinate.
  std::array<std::vector<RealBall>, 4> coefficients_;
};

}  // namespace eliminant::bridge
