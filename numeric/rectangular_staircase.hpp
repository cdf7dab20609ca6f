// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/numeric/companion_pencil.hpp>

namespace eliminant::numeric {

/// Ranks of B and of the part of A that the kernel of B reaches, for each step.
using StaircaseSteps = std::vector<std::array<long, 2>>;

/// The companion pencil of T(x) = sum of x^k coefficients[k], rectangular matrices of one size p x q, p >= q, of the
/// size ((m - 1) q + p) x (m q): T(x) v = 0 exactly when (A - x B)(v, x v, ..., x^(m-1) v) = 0.
/// Source: [LuuBuseMourrain2009], Definition 2.
Pencil<double> rectangular_companion_pencil(const std::vector<Matrix<double>>& coefficients);

/// The square pencil with invertible B that has the finite eigenvalues of a rectangular, possibly singular one, with
/// their multiplicities: by orthogonal transformations, first from the right until B has full column rank, then from
/// the left. The ranks come from exact arithmetic; none is read off singular values, which is where this departs from
/// the source.
/// Source: [LuuBuseMourrain2009], section 3.3. Guarantee: none (floating point). Throws InvalidInput when the ranks do
/// not fit the sizes.
Pencil<double> regular_part_staircase(const Pencil<double>& pencil, const StaircaseSteps& column_steps,
                                      const StaircaseSteps& row_steps);

}  // namespace eliminant::numeric
