// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/result.hpp>

namespace eliminant::intersect {

/// What the pencil engine found: approximate solutions without any guarantee, possibly too few or too many.
struct PencilCandidates {
  /// Exact midpoints. `approximate` is the pencil's own answer, `refined` the same after Newton steps in the precision
  /// of the stage (only at 53 bits; otherwise they are equal).
  struct Candidate {
    bridge::PlaneBall approximate;
    bridge::PlaneBall refined;
  };
  std::vector<Candidate> candidates;
  EngineReport report;
};

/// Runs the paper's numeric algorithm for p = q = 0 with the resultant matrix asked for, at one precision (53, 128,
/// 256, 512 or 1024 bits). `hidden` is the index of the variable kept in the entries of the matrix (0 or 1). p and q
/// are primitive over Z, coprime, and at least one of them has positive degree in the eliminated variable.
PencilCandidates pencil_candidates(const symbolic::Polynomial& p, const symbolic::Polynomial& q, std::size_t hidden,
                                   int precision_bits, const Options& options, const Context& context);

/// Runs the graded pencil of the hybrid Bezout matrix in double precision (numeric/multiplication_matrix): as many
/// candidates as Bezout's number, one of each conjugate pair. The points come from the eigenvectors or, faster, from
/// the eigenvalues alone. p and q are as above and their leading forms are coprime.
PencilCandidates graded_pencil_candidates(const symbolic::Polynomial& p, const symbolic::Polynomial& q,
                                          bool eigenvectors, const Context& context);

/// The multiplicities of all solutions, those at infinity too, as the clusters of the graded pencil show them in double
/// precision (numeric/eigenvalue_clusters). Where the curves meet at infinity the pencil is that of a projective image
/// in which they do not, and
/// so is the second opinion where combinations disagree. p and q as above; nullopt: in doubt.
std::optional<PencilMultiplicities> pencil_multiplicities(const symbolic::Polynomial& p, const symbolic::Polynomial& q,
                                                          std::uint64_t seed, const Context& context);

/// Upper bound of the columns of the companion pencil of that matrix with the variable `hidden` hidden.
long companion_pencil_size(const symbolic::Polynomial& p, const symbolic::Polynomial& q, std::size_t hidden,
                           ResultantMatrix matrix);

/// Index of the variable to hide for the smaller companion pencil of that matrix.
std::size_t smaller_pencil_variable(const symbolic::Polynomial& p, const symbolic::Polynomial& q,
                                    ResultantMatrix matrix);

}  // namespace eliminant::intersect
