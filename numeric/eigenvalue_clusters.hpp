// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/numeric/multiplication_matrix.hpp>

namespace eliminant::numeric {

/// A cluster of eigenvalues that the arithmetic cannot tell apart: one point, whose multiplicity is the dimension of
/// the invariant subspace.
struct ClusteredPoint {
  /// Mean of the coordinates over the cluster: traces of X and Y on the subspace, divided by its dimension.
  PlanePoint<double> point;
  long multiplicity = 1;
};

/// All points of a pair of multiplication matrices with their multiplicities, from a reordered Schur form of a generic
/// combination of both ([CorlessGianniTrager1997]). Eigenvalues are gathered until the gap around each cluster is large
/// beside the error of its mean, which is that of the matrix over the reciprocal condition number of the spectral
/// projector [BaiDemmelMcKenney1993]: a split multiple eigenvalue has ill-conditioned parts and a well-conditioned
/// mean. nullopt when a second combination shows other multiplicities, or the QR algorithm does not converge.
/// Guarantee: none (floating point).
std::optional<std::vector<ClusteredPoint>> points_by_clusters(const MultiplicationMatrices<double>& matrices);

}  // namespace eliminant::numeric
