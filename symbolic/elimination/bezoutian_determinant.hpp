// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>

namespace eliminant::symbolic {

/// The minor of B(u, t) of the rows and columns with these indices, in Z[u, t] (u is variable 0). Exact and proven: by
/// evaluation and interpolation in both variables modulo primes, as many as Hadamard's inequality asks for, applied to
/// the 1-norms of the entries (which bound them on |u| = |t| = 1, hence by Cauchy the coefficients of the minor).
/// Throws InvalidInput for an index that is too large or unequal numbers of rows and columns, and LimitReached where
/// the coefficients would not fit in memory.
Polynomial minor(const SeparatedBezoutian& matrix, const std::vector<std::size_t>& rows,
                 const std::vector<std::size_t>& columns, std::uint64_t seed, const Context& context);

/// The same with equal rows and columns, quicker.
Polynomial principal_minor(const SeparatedBezoutian& matrix, const std::vector<std::size_t>& rows, std::uint64_t seed,
                           const Context& context);

/// D(u, t) = det B(u, t) of the intersection, with the sign of intersection_bezoutian_matrix. For general surfaces of
/// bidegree (m, n) its bidegree is (2 m^2 n, 2 m n^2), its total degree the sum, for polynomial surfaces less by
/// mn min(m, n). Zero where the whole plane of (u, t) lies under common points.
/// Source: [BuseElkadiGalligo2008], Theorems 2 and 3.
Polynomial bezoutian_determinant(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context);

/// D(u, v) of the self-intersection of a surface, whose intersection with itself `matrix` is: equal to the determinant
/// of self_intersection_bezoutian_matrix, computed as the minor without the first row and column. For general surfaces
/// the bidegree is (2 m^2 n - 4 m + 2, 2 m n^2 - 4 n + 2), the total degree the sum, for polynomial surfaces less by
/// (mn - 1) min(m, n). 1 for a bilinear surface.
/// Source: [BuseElkadiGalligo2008], Theorems 4 and 5.
Polynomial self_intersection_determinant(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context);

/// The rank of B modulo a prime at a random point: that over Q(u, t), or less in rare cases; with one regular minor of
/// this size, by its indices.
struct GenericRank {
  std::size_t rank = 0;
  std::vector<std::size_t> rows;
};
GenericRank generic_rank_modulo(const SeparatedBezoutian& matrix, std::uint64_t seed);

}  // namespace eliminant::symbolic
