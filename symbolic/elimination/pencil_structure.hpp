// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// The ranks that the extraction of the regular part of a pencil A - t B meets, [LuuBuseMourrain2009], section 3.3.
struct PencilStructure {
  /// Ranks of B and of the part of A that the kernel of B reaches, step by step: on the pencil until B has full column
  /// rank, then on its transpose until B is square.
  std::vector<std::array<long, 2>> column_steps;
  std::vector<std::array<long, 2>> row_steps;
  /// Order of the regular part without infinite eigenvalues: the degree of the gcd of the maximal minors.
  long regular_size = 0;
  /// The pencil has full column rank for almost all t; else the curve lies in what the matrix represents.
  bool full_rank = true;
};

/// Of the companion pencil of M(Psi(t)) transposed, [LuuBuseMourrain2009], Definition 2, of the size
/// ((e - 1) rows + columns) x (e rows), e the degree of the curve.
///
/// Modulo a 62-bit prime of the seed: the ranks are those over Q except with a probability of about the size squared
/// over 2^61, and only steer the numeric stage, whose results are checked by other means.
PencilStructure pencil_structure_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed);

}  // namespace eliminant::symbolic
