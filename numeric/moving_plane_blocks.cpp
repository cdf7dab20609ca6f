// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/moving_plane_blocks.hpp>

#include <algorithm>

#include <Eigen/QR>

#include <eliminant/base/error.hpp>
#include <eliminant/numeric/lapack.hpp>

namespace eliminant::numeric {

namespace {

void require_valid(const SurfaceForms& surface) {
  if (surface.coefficients.cols() != monomial_count(surface.triangular, surface.degrees))
    throw InvalidInput("the number of coefficients of the surface does not match its degrees", "one for each monomial");
  if (std::max(surface.degrees[0], surface.degrees[1]) > largest_numeric_degree || surface.degrees[0] < 0 ||
      surface.degrees[1] < 0)
    throw InvalidInput("a degree of the surface is out of range", "degrees up to 31");
  if (!all_finite(surface.coefficients)) throw InvalidInput("a coefficient of the surface is not finite", "numbers");
}

/// The transposed system: row k rows + i holds the coefficients of the product of row monomial i and coordinate k.
Matrix<double> transposed_system(const SurfaceForms& surface, std::array<long, 2> row_degrees) {
  const bool triangular = surface.triangular;
  const std::array<long, 2> products{row_degrees[0] + surface.degrees[0], row_degrees[1] + surface.degrees[1]};
  const long rows = monomial_count(triangular, row_degrees);
  Matrix<double> system = Matrix<double>::Zero(4 * rows, monomial_count(triangular, products));
  const auto last = [triangular](std::array<long, 2> degrees, long i) {
    return triangular ? degrees[0] - i : degrees[1];
  };
  for (long a = 0; a <= surface.degrees[0]; ++a)
    for (long b = 0; b <= last(surface.degrees, a); ++b) {
      const auto coefficient = surface.coefficients.col(monomial_index(triangular, surface.degrees, a, b));
      for (long i = 0; i <= row_degrees[0]; ++i)
        for (long j = 0; j <= last(row_degrees, i); ++j) {
          const long row = monomial_index(triangular, row_degrees, i, j);
          const long product = monomial_index(triangular, products, a + i, b + j);
          for (long k = 0; k < 4; ++k) system(k * rows + row, product) = coefficient(k);
        }
    }
  return system;
}

/// Orthonormal basis of the vectors orthogonal to all columns, when these are surely independent; else no columns.
Matrix<double> complement_of_independent(Matrix<double> matrix, double& smallest_pivot) {
  const int rows = static_cast<int>(matrix.rows());
  const int columns = static_cast<int>(matrix.cols());
  if (rows < columns || columns == 0) return {};
  Vector<double> reflectors(columns);
  constexpr int block = 64;
  const int work_size = std::max(1, rows * block);
  Vector<double> work(work_size);
  int info = 0;
  dgeqrf_(&rows, &columns, matrix.data(), &rows, reflectors.data(), work.data(), &work_size, &info);
  const Vector<double> pivots = matrix.diagonal().cwiseAbs();
  // Without pivoting the diagonal may hide a small singular value, but not one of rounding size.
  constexpr double surely_independent = 1e-9;
  smallest_pivot = pivots.minCoeff() / pivots.maxCoeff();
  if (info != 0 || !(smallest_pivot > surely_independent)) return {};
  const int free = rows - columns;
  Matrix<double> basis = Matrix<double>::Zero(rows, free);
  basis.bottomRows(free).setIdentity();
  const char left = 'L';
  const char no = 'N';
  dormqr_(&left, &no, &rows, &free, &columns, matrix.data(), &rows, reflectors.data(), basis.data(), &rows, work.data(),
          &work_size, &info);
  return basis;
}

/// The same where the rank has to be found.
Matrix<double> complement_by_pivoting(const Matrix<double>& matrix, double& smallest_pivot, double& largest_dropped) {
  const Eigen::ColPivHouseholderQR<Matrix<double>> qr(matrix);
  const long most = std::min(matrix.rows(), matrix.cols());
  const Vector<double> pivots = qr.matrixQR().diagonal().head(most).cwiseAbs();
  // The rank is where the pivots drop most, among those that may be rounding errors.
  constexpr double may_be_zero = 1e-8;
  long rank = most;
  double largest_drop = 1;
  for (long k = 1; k < most; ++k) {
    if (pivots(k) > may_be_zero * pivots(0)) continue;
    const double drop = pivots(k - 1) / std::max(pivots(k), machine_epsilon<double>() * pivots(0));
    if (drop <= largest_drop) continue;
    largest_drop = drop;
    rank = k;
  }
  smallest_pivot = pivots(rank - 1) / pivots(0);
  largest_dropped = rank < most ? pivots(rank) / pivots(0) : 0;
  Matrix<double> seed = Matrix<double>::Zero(matrix.rows(), matrix.rows() - rank);
  seed.bottomRows(seed.cols()).setIdentity();
  return qr.householderQ() * seed;
}

}  // namespace

std::array<long, 2> moving_plane_degrees(const SurfaceForms& surface) {
  const auto [m, n] = surface.degrees;
  if (surface.triangular) return {std::max(1L, 2 * (m - 1)), 0};
  const std::array<long, 2> first{std::max(1L, 2 * m - 1), std::max(1L, n - 1)};
  const std::array<long, 2> second{std::max(1L, m - 1), std::max(1L, 2 * n - 1)};
  const long first_count = monomial_count(false, first);
  const long second_count = monomial_count(false, second);
  if (first_count != second_count) return first_count < second_count ? first : second;
  return std::min(first[0], first[1]) >= std::min(second[0], second[1]) ? first : second;
}

MovingPlaneBlocks moving_plane_blocks(const SurfaceForms& surface, std::array<long, 2> row_degrees) {
  require_valid(surface);
  const long rows = monomial_count(surface.triangular, row_degrees);
  Matrix<double> system = transposed_system(surface, row_degrees);
  const double largest = system.cwiseAbs().maxCoeff();
  if (!(largest > 0)) throw InvalidInput("all coefficients of the surface are zero", "a surface");
  system /= largest;
  MovingPlaneBlocks result;
  result.triangular = surface.triangular;
  result.row_degrees = row_degrees;
  Matrix<double> planes = complement_of_independent(system, result.smallest_pivot);
  if (planes.size() == 0) planes = complement_by_pivoting(system, result.smallest_pivot, result.largest_dropped_pivot);
  if (planes.cols() < rows)
    throw InvalidInput("the surface has fewer moving planes than rows of the matrix", "moving planes of other degrees");
  for (long k = 0; k < 4; ++k) result.blocks[static_cast<std::size_t>(k)] = planes.middleRows(k * rows, rows);
  return result;
}

}  // namespace eliminant::numeric
