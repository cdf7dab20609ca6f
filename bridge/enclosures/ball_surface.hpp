// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::bridge {

/// Parameters of a point of a surface in homogeneous coordinates: (s1 : s0) and (t1 : t0) with s = s1 / s0, t = t1 / t0
/// of a tensor-product surface, (s : t : u) of a triangular one. In each group one coordinate is exactly 1, one of the
/// largest.
using HomogeneousParameters = std::vector<ComplexBall>;

/// A rational surface to be evaluated in balls.
class BallSurface {
 public:
  explicit BallSurface(const symbolic::RationalSurface& surface);

  bool is_tensor_product() const { return tensor_product_; }
  /// Which homogeneous parameters belong together: two pairs, or one triple.
  std::vector<std::vector<std::size_t>> groups() const;
  /// The homogeneous coordinates of the surface at these parameters.
  std::vector<ComplexBall> point_at(const HomogeneousParameters& parameters, long precision_bits) const;
  /// The coordinates and their derivatives by some of the homogeneous parameters, in one pass over the monomials.
  struct Jet {
    std::vector<ComplexBall> point;
    std::vector<std::vector<ComplexBall>> derivatives;  ///< one for each parameter that was asked for
  };
  Jet jet_at(const HomogeneousParameters& parameters, const std::vector<std::size_t>& by, long precision_bits) const;

 private:
  struct Monomial {
    std::vector<unsigned long> exponents;         // of the homogeneous parameters
    std::vector<symbolic::Integer> coefficients;  // in each coordinate
  };

  bool tensor_product_;
  std::vector<Monomial> monomials_;
  std::vector<unsigned long> highest_;  // exponent of each homogeneous parameter
};

}  // namespace eliminant::bridge
