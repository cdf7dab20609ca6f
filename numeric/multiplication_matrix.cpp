// SPDX-License-Identifier: BSD-3-Clause
#include <complex>

#include <eliminant/numeric/lapack.hpp>
#include <eliminant/numeric/multiplication_matrix_internal.hpp>

namespace eliminant::numeric {

template <>
bool tall_lu(Matrix<double>& matrix, std::vector<long>& order) {
  const int rows = static_cast<int>(matrix.rows());
  const int columns = static_cast<int>(matrix.cols());
  if (columns == 0) return true;
  std::vector<int> pivots(static_cast<std::size_t>(columns));
  int info = 0;
  dgetrf_(&rows, &columns, matrix.data(), &rows, pivots.data(), &info);
  if (info != 0) return false;
  for (std::size_t k = 0; k < pivots.size(); ++k) std::swap(order[k], order[static_cast<std::size_t>(pivots[k] - 1)]);
  return true;
}

template std::optional<MultiplicationMatrices<double>> multiplication_matrices(const MatrixPolynomial<double>&,
                                                                               const BivariatePolynomial<double>&,
                                                                               const BivariatePolynomial<double>&, long,
                                                                               long);

template <>
std::vector<PlanePoint<double>> points_of(const MultiplicationMatrices<double>& matrices) {
  using Complex = std::complex<double>;
  const int n = static_cast<int>(matrices.x.rows());
  std::vector<PlanePoint<double>> points;
  if (n == 0) return points;
  // Irrational-looking weights: no two solutions with small rational coordinates share a value.
  constexpr double x_weight = 0.80178372573727319;
  constexpr double y_weight = 0.59761430466719678;
  Matrix<double> generic = x_weight * matrices.x + y_weight * matrices.y;
  Vector<double> real(n);
  Vector<double> imaginary(n);
  Matrix<double> vectors(n, n);
  const char no = 'N';
  const char yes = 'V';
  const int one = 1;
  double unused = 0;
  double optimal = 0;
  int info = 0;
  int work_size = -1;
  dgeev_(&no, &yes, &n, generic.data(), &n, real.data(), imaginary.data(), &unused, &one, vectors.data(), &n, &optimal,
         &work_size, &info);
  work_size = static_cast<int>(optimal);
  Vector<double> work(work_size);
  dgeev_(&no, &yes, &n, generic.data(), &n, real.data(), imaginary.data(), &unused, &one, vectors.data(), &n,
         work.data(), &work_size, &info);
  if (info != 0) return points;
  const auto coordinate = [&](const Matrix<double>& matrix, const Eigen::VectorXcd& vector, long largest) {
    return Complex((matrix.row(largest) * vector.real())(0), (matrix.row(largest) * vector.imag())(0)) /
           vector(largest);
  };
  for (int k = 0; k < n; ++k) {
    const bool pair = imaginary(k) != 0;
    Eigen::VectorXcd vector = vectors.col(k).cast<Complex>();
    if (pair) vector += Complex(0, 1) * vectors.col(k + 1);
    // X v = x v in every row; the largest entry of v is divided by with the least harm.
    long largest = 0;
    vector.cwiseAbs2().maxCoeff(&largest);
    const PlanePoint<double> point{coordinate(matrices.x, vector, largest), coordinate(matrices.y, vector, largest)};
    points.push_back(point);
    if (pair) ++k;
  }
  return points;
}

}  // namespace eliminant::numeric
