// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::symbolic {

/// Whether all terms have one total degree.
bool is_form(const Polynomial& p);

/// A rational surface (x : y : z : w) over the projective plane or over the product of two projective lines:
/// polynomials with integer coefficients without a common factor, not all zero.
class RationalSurface {
 public:
  enum class Kind {
    triangular,     ///< three homogeneous parameters (s : t : u), forms of one degree
    tensor_product  ///< two affine parameters (s, t), bidegree (m, n)
  };

  /// Four coordinates, the weight last: forms of one degree in three variables, or polynomials in two variables.
  /// A common factor is divided out; degrees are those that then remain.
  /// Throws InvalidInput when there are not four, all are zero, or forms differ in degree or are not homogeneous.
  RationalSurface(Kind kind, std::vector<Polynomial> coordinates);

  Kind kind() const { return kind_; }
  const std::vector<Polynomial>& coordinates() const { return coordinates_; }
  /// Degree d of the forms; only for triangular.
  long degree() const { return degrees_[0]; }
  /// (m, n); only for tensor_product.
  std::array<long, 2> bidegree() const { return degrees_; }
  /// The homogeneous coordinates where the parameters have these values, three or two of them.
  /// Throws InvalidInput when their number is another.
  std::vector<Rational> at(const std::vector<Rational>& parameters) const;

 private:
  Kind kind_;
  std::vector<Polynomial> coordinates_;
  std::array<long, 2> degrees_{};
};

/// A map and the part of its parameters that counts: without a region all of them, those at infinity too. Of a
/// triangular surface the affine parameters of the region are (s, t) with s + t + u = 1: barycentric coordinates.
struct SurfacePiece {
  RationalSurface map;
  std::optional<ParameterRegion> region;
};

/// A surface as handed in: pieces in the same parameters, whose regions meet along their sides (NURBS), or one piece.
struct ParametricSurface {
  std::vector<SurfacePiece> pieces;
};

}  // namespace eliminant::symbolic
