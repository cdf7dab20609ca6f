// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/numeric/bivariate_polynomial.hpp>
#include <eliminant/numeric/clustering.hpp>
#include <eliminant/numeric/matrix_polynomial.hpp>
#include <eliminant/numeric/newton_refinement.hpp>

namespace eliminant::numeric {

/// Everything the numeric stage needs, rounded, and what the exact side knows about it.
template <class Scalar>
struct ResultantProblem {
  MatrixPolynomial<Scalar> matrix;     ///< Bezout or Sylvester matrix in the hidden variable x
  MatrixPolynomial<Scalar> sylvester;  ///< Sylvester matrix, for fibres that the kernel of `matrix` cannot resolve
  BivariatePolynomial<Scalar> p, q;
  /// Jordan block counts of the companion pencil of `matrix` at infinity (see regular_part_staircase).
  std::vector<long> infinite_step_sizes;
  /// Number of distinct finite eigenvalues.
  long distinct_eigenvalues = 0;
  /// The paper's epsilon; replaces the exact number when set.
  std::optional<double> epsilon;
};

/// One gathered eigenvalue and the solutions above it.
template <class Scalar>
struct Fibre {
  std::complex<Scalar> x;                ///< mean of the eigenvalues of the cluster
  long multiplicity = 0;                 ///< number of eigenvalues: the sum of the intersection multiplicities above x
  std::vector<std::complex<Scalar>> ys;  ///< with the multiplicities of the fibre's gcd
  /// The single eigenvalues of the cluster: the best guesses for x where solutions are close, not equal.
  std::vector<std::complex<Scalar>> eigenvalues;
};

template <class Scalar>
struct ResultantSolution {
  std::vector<Fibre<Scalar>> fibres;
  long pencil_size = 0;
  long regular_size = 0;
  bool converged = true;
};

/// Algorithm 2 of [BuseKhalilMourrain2005]: companion pencil, regular part, eigenvalues and vectors, clusters, singular
/// value decomposition of each cluster's vectors, Delta_0 and Delta_1, y. Where the kernel is as large as the Bezout
/// matrix it falls back on the Sylvester matrix, and where that is too small as well (one polynomial vanishes on the
/// whole fibre) on the roots of the other polynomial. Approximate throughout; nothing is discarded for being small.
/// Defined for double, Real128, Real256, Real512 and Real1024, each in a translation unit of its own.
template <class Scalar>
ResultantSolution<Scalar> solve_by_resultant(const ResultantProblem<Scalar>& problem);

extern template ResultantSolution<double> solve_by_resultant(const ResultantProblem<double>&);
extern template ResultantSolution<Real128> solve_by_resultant(const ResultantProblem<Real128>&);
extern template ResultantSolution<Real256> solve_by_resultant(const ResultantProblem<Real256>&);
extern template ResultantSolution<Real512> solve_by_resultant(const ResultantProblem<Real512>&);
extern template ResultantSolution<Real1024> solve_by_resultant(const ResultantProblem<Real1024>&);

}  // namespace eliminant::numeric
