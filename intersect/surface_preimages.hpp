// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/ball.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::intersect {

/// Parameters of a point of a surface in homogeneous coordinates: (s1 : s0) and (t1 : t0) with s = s1 / s0, t = t1 / t0
/// of a tensor-product surface, (s : t : u) of a triangular one. In each group one coordinate is exactly 1, one of the
/// largest.
using HomogeneousParameters = std::vector<bridge::ComplexBall>;

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
  /// wide to say that the kernel has no larger dimension than `largest_dimension`.
  std::optional<Preimages> preimages(const std::vector<bridge::ComplexBall>& point, long largest_dimension,
                                     long precision_bits) const;

  /// The homogeneous coordinates of the surface at these parameters.
  std::vector<bridge::ComplexBall> point_at(const HomogeneousParameters& parameters, long precision_bits) const;
  /// Its derivatives by one of the homogeneous parameters.
  std::vector<bridge::ComplexBall> derivative_at(const HomogeneousParameters& parameters, std::size_t by,
                                                 long precision_bits) const;
  /// Which homogeneous parameters belong together: two pairs, or one triple.
  std::vector<std::vector<std::size_t>> groups() const;

 private:
  struct Term {
    symbolic::Integer coefficient;
    std::vector<unsigned long> exponents;  // of the homogeneous parameters
  };

  std::optional<HomogeneousParameters> read(const std::vector<bridge::ComplexBall>& kernel, long precision_bits) const;
  std::vector<HomogeneousParameters> separate(const std::vector<std::vector<bridge::ComplexBall>>& kernel) const;
  bridge::ComplexBall value(const std::vector<Term>& terms, const HomogeneousParameters& parameters,
                            std::optional<std::size_t> by, long precision_bits) const;

  bool tensor_;
  const symbolic::MatrixRepresentation& m_;
  std::vector<std::vector<Term>> coordinates_;
  std::vector<std::vector<unsigned long>> rows_;  // exponents of the homogeneous parameters
};

}  // namespace eliminant::intersect
