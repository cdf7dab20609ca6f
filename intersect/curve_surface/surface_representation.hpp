// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::intersect {

/// A rational value of a parameter; nullopt is infinity.
using RationalParameter = std::optional<symbolic::Rational>;

/// Whether a rational point lies on a surface, exactly.
struct Membership {
  bool on_surface = false;
  /// Number of rows of the matrix minus its rank at the point: on the surface the number of parameters with
  /// multiplicity, where they are finitely many and no extraneous plane passes through it.
  long kernel_dimension = 0;
  /// The rational ones among the parameters of the point, proven, each a list of two, or of three homogeneous ones
  /// (triangular; the last one that is not zero is 1). None is missing where there are as many as the dimension.
  std::vector<std::vector<RationalParameter>> preimages;
};

/// What double precision says of a point.
struct ApproximateMembership {
  /// The smallest singular value of the matrix at the point, divided by the largest: about 1e-16 on the surface.
  double relative_singular_value = 0;
  /// How many singular values are below the tolerance times the largest one; 0 means: not on the surface.
  long kernel_dimension = 0;
  /// Homogeneous parameters, (s1 : s0), (t1 : t0) of a tensor product, (s : t : u) of a triangular one, in each group
  /// with one coordinate 1. Without any guarantee; kernel vectors of base points and extraneous planes are among them.
  std::vector<std::vector<std::complex<double>>> preimages;
};

/// A rational surface, its matrix representation, and what is known of its degree: computed once, used for any number
/// of points, saved and loaded exactly (io/results/representation_json.hpp). It never changes; many threads may use it.
/// Source: [LuuBuseMourrain2009].
class SurfaceRepresentation {
 public:
  /// The smallest representation whose kernels tell both parameters. Where base points add planes to it, the implicit
  /// equation is computed too, which tells them from the surface.
  /// Throws LimitReached when the base points leave no representation by moving planes, or that equation is too large.
  explicit SurfaceRepresentation(symbolic::RationalSurface surface, std::uint64_t seed = 0,
                                 const Context& context = Context());

  /// From parts that were stored. The degree is believed.
  /// Throws InvalidInput when a column of the matrix is no moving plane of the surface, columns are dependent or rows
  /// are no monomials of one degree; and as above.
  SurfaceRepresentation(symbolic::RationalSurface surface, symbolic::MatrixRepresentation matrix,
                        symbolic::ImplicitDegree degree, const Context& context = Context());

  const symbolic::RationalSurface& surface() const { return surface_; }
  const symbolic::MatrixRepresentation& matrix() const { return matrix_; }
  const symbolic::ImplicitDegree& degree() const { return degree_; }

  /// By the rank of the matrix over Q, and its kernel. Several parameters of one point take a larger matrix, which is
  /// computed for the call. Throws InvalidInput unless there are four homogeneous coordinates, not all zero.
  Membership membership(const std::vector<symbolic::Rational>& point) const;

  /// By a singular value decomposition. Throws InvalidInput for a point whose coordinates are not finite or all zero,
  /// and for a tolerance that is not between 0 and 1.
  ApproximateMembership approx_membership(const std::array<double, 4>& point, double tolerance = 1e-10) const;

 private:
  void prepare(const Context& context);

  symbolic::RationalSurface surface_;
  symbolic::MatrixRepresentation matrix_;
  symbolic::ImplicitDegree degree_;
  /// Only where the minors hold planes besides.
  std::optional<symbolic::Polynomial> equation_;
  /// The four coefficient matrices rounded, row by row, every column divided by a power of two near its largest entry.
  std::array<std::vector<double>, 4> rounded_;
};

}  // namespace eliminant::intersect
