// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The definition behind resultant_solver.hpp; included only by the translation units that instantiate it.

#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/numeric/kernel_lifting.hpp>
#include <eliminant/numeric/kronecker_reduction.hpp>
#include <eliminant/numeric/resultant_solver.hpp>

namespace eliminant::numeric {

/// The vector v of (v, x v, ..., x^(m-1) v), of norm 1: read off the block with the largest norm.
template <class Scalar>
Vector<std::complex<Scalar>> kernel_vector(const Vector<std::complex<Scalar>>& companion_vector, long n) {
  const long last = companion_vector.size() - n;
  const bool first_block = companion_vector.head(n).squaredNorm() >= companion_vector.segment(last, n).squaredNorm();
  Vector<std::complex<Scalar>> v = companion_vector.segment(first_block ? 0 : last, n);
  const Scalar norm = v.norm();
  if (norm > 0) v /= std::complex<Scalar>(norm);
  return v;
}

/// Roots of a polynomial with ascending complex coefficients, by its companion matrix; leading coefficients that are
/// negligible stand for roots at infinity.
template <class Scalar>
std::vector<std::complex<Scalar>> polynomial_roots(const Vector<std::complex<Scalar>>& coefficients) {
  using Complex = std::complex<Scalar>;
  Scalar largest(0);
  for (long k = 0; k < coefficients.size(); ++k) largest = std::max(largest, modulus<Scalar>(coefficients(k)));
  long degree = coefficients.size() - 1;
  while (degree > 0 && !(modulus<Scalar>(coefficients(degree)) > Scalar(64) * machine_epsilon<Scalar>() * largest))
    --degree;
  std::vector<Complex> roots;
  if (degree <= 0) return roots;
  Matrix<Complex> companion = Matrix<Complex>::Zero(degree, degree);
  for (long k = 0; k + 1 < degree; ++k) companion(k + 1, k) = Complex(Scalar(1));
  for (long k = 0; k < degree; ++k) companion(k, degree - 1) = -coefficients(k) / coefficients(degree);
  const Eigen::ComplexEigenSolver<Matrix<Complex>> solver(companion, false);
  if (solver.info() != Eigen::Success) return roots;
  for (long k = 0; k < degree; ++k) roots.push_back(solver.eigenvalues()(k));
  return roots;
}

/// The vectors v with |T(x)^t v| <= tolerance * sum |T_k| |x|^k: measured against the size of the terms, because T(x)
/// may vanish altogether.
template <class Scalar>
Matrix<std::complex<Scalar>> kernel_at(const MatrixPolynomial<Scalar>& t, const std::complex<Scalar>& x,
                                       const Scalar& tolerance) {
  Scalar size(0);
  Scalar power(1);
  for (const Matrix<Scalar>& coefficient : t.coefficients) {
    size += Scalar(coefficient.norm()) * power;
    power *= modulus<Scalar>(x);
  }
  const Matrix<std::complex<Scalar>> value = t.evaluate(x).transpose();
  const Eigen::JacobiSVD<Matrix<std::complex<Scalar>>> svd(value, Eigen::ComputeFullV);
  long rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > tolerance * size) ++rank;
  return svd.matrixV().rightCols(value.cols() - rank);
}

/// Below this relative size a singular value counts as zero. With the paper's epsilon it is epsilon. Otherwise: the
/// eigenvectors of a defective cluster of spread d differ by O(d), those of a semisimple one are independent, and the
/// square root separates the two; eps^(1/2) stands for the spread that rounding alone may cause.
template <class Scalar>
Scalar rank_tolerance(const ResultantProblem<Scalar>& problem, const Scalar& spread) {
  using std::sqrt;
  if (problem.epsilon) return Scalar(*problem.epsilon);
  const Scalar smallest = sqrt(machine_epsilon<Scalar>());
  const Scalar root = sqrt(spread);
  return std::min(Scalar(0.2), std::max(smallest, root));
}

template <class Scalar>
ResultantSolution<Scalar> solve_by_resultant(const ResultantProblem<Scalar>& problem) {
  using Complex = std::complex<Scalar>;
  ResultantSolution<Scalar> solution;
  const long n = problem.matrix.size();
  solution.pencil_size = n * problem.matrix.degree();
  if (problem.matrix.degree() < 1) return solution;
  // Steps 1 and 2.
  const RegularPart<Scalar> regular = regular_part_staircase(problem.matrix, problem.infinite_step_sizes);
  solution.regular_size = regular.pencil.size();
  const std::optional<Eigenpairs<Scalar>> pairs = generalized_eigen(regular.pencil);
  if (!pairs) {
    solution.converged = false;
    return solution;
  }
  // Step 3.
  ClusteringRule<Scalar> rule;
  rule.count = problem.distinct_eigenvalues;
  if (problem.epsilon) rule.distance = Scalar(*problem.epsilon);
  const Matrix<Complex> companion_vectors = regular.right_basis.template cast<Complex>() * pairs->vectors;
  for (const Cluster& cluster : cluster_values<Scalar>(pairs->values, rule)) {
    Fibre<Scalar> fibre;
    fibre.multiplicity = static_cast<long>(cluster.size());
    Complex sum(Scalar(0));
    for (const long k : cluster) {
      sum += pairs->values(k);
      fibre.eigenvalues.push_back(pairs->values(k));
    }
    fibre.x = sum / Complex(Scalar(static_cast<double>(cluster.size())));
    Scalar spread(0);
    for (const long k : cluster) {
      const Scalar scale = std::max(Scalar(1), modulus<Scalar>(fibre.x));
      spread = std::max(spread, Scalar(modulus<Scalar>(Complex(pairs->values(k) - fibre.x)) / scale));
    }
    // Steps 4 to 8.
    Matrix<Complex> vectors(n, fibre.multiplicity);
    for (long k = 0; k < fibre.multiplicity; ++k)
      vectors.col(k) = kernel_vector<Scalar>(companion_vectors.col(cluster[static_cast<std::size_t>(k)]), n);
    const Scalar tolerance = rank_tolerance(problem, spread);
    Matrix<Complex> basis = independent_vectors<Scalar>(vectors, tolerance);
    if (fibre.multiplicity > 1) {
      // Departs from the paper: the eigenvectors computed for an eigenvalue that is multiple and semisimple may come
      // out dependent, and the kernel at the mean of the cluster, which is far more accurate than its members, then is
      // larger.
      const Matrix<Complex> direct = kernel_at<Scalar>(problem.matrix, fibre.x, tolerance);
      if (direct.cols() > basis.cols() && direct.cols() <= fibre.multiplicity) basis = direct;
    }
    if (basis.cols() >= n) basis = kernel<Scalar>(problem.sylvester.evaluate(fibre.x).transpose(), tolerance);
    fibre.ys = fibre_coordinates<Scalar>(basis);
    if (basis.cols() >= basis.rows()) {
      for (const auto* curve : {&problem.p, &problem.q}) {
        const std::vector<Complex> roots = polynomial_roots<Scalar>(curve->restrict_to(fibre.x));
        fibre.ys.insert(fibre.ys.end(), roots.begin(), roots.end());
      }
    }
    solution.fibres.push_back(std::move(fibre));
  }
  return solution;
}

}  // namespace eliminant::numeric
