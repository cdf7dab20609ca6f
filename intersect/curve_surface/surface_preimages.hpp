// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball_surface.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::intersect {

using bridge::HomogeneousParameters;

/// Beyond this many bits, what cannot be told from a larger kernel or a base point is taken for one.
inline constexpr long largest_preimage_precision = 1500;

/// What the kernel of M(P) says of the parameters of a point P of the surface.
struct Preimages {
  /// At least the number of parameters, with multiplicity, of the point on the surface or in its limits.
  long kernel_dimension = 0;
  /// Enclosures, where the kernel has dimension 1; else approximations without any proof.
  std::vector<HomogeneousParameters> parameters;
  bool proven = false;
};

/// Points of a surface back to their parameters, by the left kernel of the matrix representation, which contains the
/// values of the row monomials at every parameter of the point: the inversion of [LuuBuseMourrain2009].
class SurfaceInversion {
 public:
  /// The row monomials of `m` must tell both parameters apart.
  SurfaceInversion(const symbolic::RationalSurface& surface, const symbolic::MatrixRepresentation& m);

  /// The parameters of the point P, of which it is known that it lies on the surface; nullopt when its balls are too
  /// wide to say that the kernel has no larger dimension than `largest_dimension`. Every point of the surface has at
  /// least `map_degree` parameters, counted with multiplicity.
  std::optional<Preimages> preimages(const std::vector<bridge::ComplexBall>& point, long largest_dimension,
                                     long map_degree, long precision_bits) const;

  const bridge::BallSurface& surface() const { return surface_; }

  /// The parameters whose monomials have these values, up to a common factor; nullopt when the balls are too wide.
  std::optional<HomogeneousParameters> read(const std::vector<bridge::ComplexBall>& kernel, long precision_bits) const;

 private:
  struct Multiplication;

  Multiplication multiplication(std::size_t count) const;
  std::vector<HomogeneousParameters> separate(const std::vector<std::vector<bridge::ComplexBall>>& kernel) const;
  std::optional<std::vector<HomogeneousParameters>> enclose_all(
      const std::vector<std::vector<bridge::ComplexBall>>& kernel, long precision_bits) const;
  bridge::BallSurface surface_;
  const symbolic::MatrixRepresentation& m_;
  std::vector<std::vector<unsigned long>> rows_;  // exponents of the homogeneous parameters
};

}  // namespace eliminant::intersect
