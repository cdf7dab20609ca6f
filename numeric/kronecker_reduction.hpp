// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <eliminant/numeric/companion_pencil.hpp>

namespace eliminant::numeric {

/// The part of a regular pencil A - x B that belongs to its finite eigenvalues: the square pencil Y^t (A - x B) Q,
/// whose second matrix is invertible. Eigenvectors u of it give eigenvectors Q u of A - x B.
template <class Scalar>
struct RegularPart {
  Pencil<Scalar> pencil;
  Matrix<Scalar> right_basis;  ///< Q: orthonormal basis of the finite right deflating subspace
};

/// Deflates the infinite eigenvalues of the companion pencil of T, the staircase of [LuuBuseMourrain2009], section 3.3,
/// on the transposed pencil and in coordinates in which B is never transformed.
///
/// `step_sizes` are the ranks the staircase must find, known exactly: c_k is the number of Jordan blocks at infinity of
/// size at least k (c_1 = corank of B, not increasing). The staircase compresses B, drops the part of A that its kernel
/// reaches, and starts again; the kernels met on the way span the left deflating subspace L at infinity,
///     B^t L_1 = 0,   B^t L_(k+1) = A^t L_k     ([BergerIlchmannTrenn2012], Wong sequences),
/// and L grows by c_k columns in step k. Since B is diag(I, ..., I, -T_m^t), a step costs one c_1 x c_k singular value
/// decomposition and a product with T. The finite right deflating subspace is the orthogonal complement of A^t L, and
/// the rows that remain are the complement Y of L.
///
/// Departs from the paper in that no rank is read off singular values.
/// Guarantee: none (floating point); det T must not vanish identically and the sum of c_k must be below the pencil's
/// size.
template <class Scalar>
RegularPart<Scalar> regular_part_staircase(const MatrixPolynomial<Scalar>& t, const std::vector<long>& step_sizes) {
  const long n = t.size();
  const long m = t.degree();
  const long size = n * m;
  long infinite = 0;
  for (const long c : step_sizes) infinite += c;

  // Left deflating subspace L at infinity; l is cut into m blocks of n. With coefficients transposed as in the
  // companion pencil: (A^t l)_c = l_(c-1) + T_c l_(m-1) and B^t l = (l_0, ..., l_(m-2), -T_m l_(m-1)).
  Matrix<Scalar> left(size, infinite);
  if (infinite > 0) {
    const long c1 = step_sizes.front();
    const Eigen::JacobiSVD<Matrix<Scalar>> leading(t.coefficients.back(), Eigen::ComputeFullU | Eigen::ComputeFullV);
    const long rank = n - c1;
    const Matrix<Scalar> cokernel = leading.matrixU().rightCols(c1);
    left.leftCols(c1).setZero();
    left.block((m - 1) * n, 0, n, c1) = leading.matrixV().rightCols(c1);
    // Vectors E of L whose images are independent modulo the range of B^t, scaled so that the obstructions R, the parts
    // of the images outside that range, are orthonormal.
    Matrix<Scalar> stuck(size, 0);
    Matrix<Scalar> stuck_obstruction(c1, 0);
    long done = c1;
    for (std::size_t k = 1; k < step_sizes.size(); ++k) {
      const long previous = step_sizes[k - 1];
      const long current = step_sizes[k];
      Matrix<Scalar> newest = left.middleCols(done - previous, previous);
      const auto image_of = [&](const Matrix<Scalar>& vectors) {
        Matrix<Scalar> image = t.coefficients[static_cast<std::size_t>(m - 1)] * vectors.bottomRows(n);
        if (m > 1) image += vectors.middleRows((m - 2) * n, n);
        return image;
      };
      // Combinations of the newest and the stuck vectors whose image under A^t lies in the range of B^t.
      Matrix<Scalar> obstruction = cokernel.transpose() * image_of(newest);
      const Matrix<Scalar> coordinates_in_stuck = stuck_obstruction.transpose() * obstruction;
      newest -= stuck * coordinates_in_stuck;
      obstruction -= stuck_obstruction * coordinates_in_stuck;
      const Eigen::JacobiSVD<Matrix<Scalar>> svd(obstruction, Eigen::ComputeFullV | Eigen::ComputeFullU);
      const long newly_stuck = previous - current;
      const Matrix<Scalar> extendable = newest * svd.matrixV().rightCols(current);
      if (newly_stuck > 0) {
        const long before = stuck.cols();
        stuck.conservativeResize(Eigen::NoChange, before + newly_stuck);
        stuck_obstruction.conservativeResize(Eigen::NoChange, before + newly_stuck);
        stuck.rightCols(newly_stuck) = newest * svd.matrixV().leftCols(newly_stuck);
        for (long i = 0; i < newly_stuck; ++i) stuck.col(before + i) /= svd.singularValues()(i);
        stuck_obstruction.rightCols(newly_stuck) = svd.matrixU().leftCols(newly_stuck);
      }
      Matrix<Scalar> next(size, current);
      for (long c = 0; c + 1 < m; ++c) {
        next.middleRows(c * n, n) = t.coefficients[static_cast<std::size_t>(c)] * extendable.bottomRows(n);
        if (c > 0) next.middleRows(c * n, n) += extendable.middleRows((c - 1) * n, n);
      }
      Matrix<Scalar> coordinates = leading.matrixU().leftCols(rank).transpose() * image_of(extendable);
      for (long i = 0; i < rank; ++i) coordinates.row(i) /= -leading.singularValues()(i);
      next.bottomRows(n) = leading.matrixV().leftCols(rank) * coordinates;
      // Orthogonalised twice against all earlier vectors, then among themselves.
      for (int pass = 0; pass < 2; ++pass) {
        const Matrix<Scalar> overlap = left.leftCols(done).transpose() * next;
        next -= left.leftCols(done) * overlap;
        const Eigen::HouseholderQR<Matrix<Scalar>> qr(next);
        next = qr.householderQ() * Matrix<Scalar>::Identity(size, current);
      }
      left.middleCols(done, current) = next;
      done += current;
    }
  }

  // A^t L, and the two orthogonal complements.
  const Pencil<Scalar> companion = companion_pencil(t);
  const long finite = size - infinite;
  RegularPart<Scalar> result;
  if (infinite == 0) {
    result.pencil = companion;
    result.right_basis = Matrix<Scalar>::Identity(size, size);
    return result;
  }
  Matrix<Scalar> complement_seed = Matrix<Scalar>::Zero(size, finite);
  complement_seed.bottomRows(finite).setIdentity();
  const Eigen::HouseholderQR<Matrix<Scalar>> left_qr(left);
  const Matrix<Scalar> rows = left_qr.householderQ() * complement_seed;
  Matrix<Scalar> left_image(size, infinite);
  for (long c = 0; c < m; ++c) {
    left_image.middleRows(c * n, n) = t.coefficients[static_cast<std::size_t>(c)] * left.bottomRows(n);
    if (c > 0) left_image.middleRows(c * n, n) += left.middleRows((c - 1) * n, n);
  }
  const Eigen::HouseholderQR<Matrix<Scalar>> image_qr(left_image);
  result.right_basis = image_qr.householderQ() * complement_seed;
  // A Q and B Q without multiplying by the identity blocks.
  const Matrix<Scalar>& q = result.right_basis;
  Matrix<Scalar> a_q(size, finite);
  Matrix<Scalar> b_q = q;
  a_q.topRows(size - n) = q.bottomRows(size - n);
  a_q.bottomRows(n) = companion.a.bottomRows(n) * q;
  b_q.bottomRows(n) = companion.b.bottomRightCorner(n, n) * q.bottomRows(n);
  result.pencil.a = rows.transpose() * a_q;
  result.pencil.b = rows.transpose() * b_q;
  return result;
}

}  // namespace eliminant::numeric
