// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// What the left kernel of M(P) over Q says of the parameters of a rational point P.
struct RationalPreimages {
  /// Number of rows minus the rank: 0 beside the surface; on it the number of parameters with multiplicity, where they
  /// are finitely many.
  long kernel_dimension = 0;
  /// The rational ones, each proven by its image: homogeneous as in RowMonomials, in each group the last coordinate
  /// that is not zero is 1. In lexicographic order.
  std::vector<std::vector<Rational>> parameters;
};

/// The rational parameters of the point P. From a kernel of dimension 1 they are read; one of dimension k > 1 is
/// spanned by the row monomials at k parameters, which are the eigenvectors of a pencil with entries in Z
/// ([ManochaDemmel1995]); `m` must then have degree k in each group of parameters. None is missing where the kernel has
/// dimension 1 or there are as many as its dimension. Source: [LuuBuseMourrain2009], the remark on inversion. Throws
/// InvalidInput when P has not four coordinates or all are zero.
RationalPreimages rational_preimages(const RationalSurface& surface, const MatrixRepresentation& m,
                                     const std::vector<Rational>& point);

/// The homogeneous coordinates of the surface at homogeneous parameters as above.
std::vector<Rational> image_of(const RationalSurface& surface, const std::vector<Rational>& parameters);

}  // namespace eliminant::symbolic
