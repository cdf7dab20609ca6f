// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/numeric/rational_forms.hpp>

namespace eliminant::numeric {

/// A matrix representation in doubles: M(x) = sum over k of x_k blocks[k], rows x columns, columns >= rows. Row
/// monomial_index(triangular, row_degrees, i, j) belongs to that monomial in the parameters.
struct MovingPlaneBlocks {
  std::array<Matrix<double>, 4> blocks;
  bool triangular = false;
  std::array<long, 2> row_degrees{};
  /// The smallest pivot that counts over the largest one, and the largest one that does not: both sides of the rank
  /// decision. The second one is 0 without base points.
  double smallest_pivot = 1;
  double largest_dropped_pivot = 0;

  long rows() const { return blocks[0].rows(); }
  long columns() const { return blocks[0].cols(); }
};

/// (2 m - 1, n - 1) or (m - 1, 2 n - 1), each at least 1, so that the rows tell both parameters apart; (2 (d - 1), 0),
/// at least 1, over the projective plane. The degrees that are enough whatever the base points are, as long as these
/// are locally complete intersections.
std::array<long, 2> moving_plane_degrees(const SurfaceForms& surface);

/// Moving planes straight from coefficients in doubles: an orthonormal basis of the kernel of the linear system of the
/// moving planes of these degrees, by a QR factorisation of its transpose. Without base points the system has full
/// rank; else the rank is where its pivots, with column pivoting, drop most.
/// Source: [LuuBuseMourrain2009], section 2, and [BuseDohm2007]. Guarantee: none (floating point). Throws InvalidInput
/// when a coefficient is not finite, a degree exceeds largest_numeric_degree, or there are fewer planes than rows.
MovingPlaneBlocks moving_plane_blocks(const SurfaceForms& surface, std::array<long, 2> row_degrees);

}  // namespace eliminant::numeric
