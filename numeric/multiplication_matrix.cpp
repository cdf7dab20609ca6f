// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <complex>

#include <eliminant/numeric/lapack.hpp>
#include <eliminant/numeric/line_lifting.hpp>
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

namespace {

// Irrational-looking weights: no two solutions with small rational coordinates share a value. Nearly vertical lines:
// the restrictions of p and q to one grow like (1 + |slope|)^degree.
constexpr LinePencil generic_lines{0.99125372573727319, 0.13196430466719678};

Matrix<double> generic_combination(const MultiplicationMatrices<double>& matrices) {
  return generic_lines.x_weight * matrices.x + generic_lines.y_weight * matrices.y;
}

using Complex = std::complex<double>;

/// The point of a common eigenvector: X v = x v holds in every row, and the largest entry of v is divided by with the
/// least harm.
PlanePoint<double> point_of(const MultiplicationMatrices<double>& matrices, const Eigen::VectorXcd& vector) {
  long largest = 0;
  vector.cwiseAbs2().maxCoeff(&largest);
  const auto coordinate = [&](const Matrix<double>& matrix) {
    return Complex((matrix.row(largest) * vector.real())(0), (matrix.row(largest) * vector.imag())(0)) /
           vector(largest);
  };
  return {coordinate(matrices.x), coordinate(matrices.y)};
}

/// A real matrix in balanced Hessenberg form, with its eigenvalues, and eigenvectors for some of them.
class HessenbergEigenproblem {
 public:
  explicit HessenbergEigenproblem(Matrix<double> matrix)
      : n_(static_cast<int>(matrix.rows())),
        reduced_(std::move(matrix)),
        scale_(n_),
        reflectors_(n_),
        real_(n_),
        imaginary_(n_) {
    int info = 0;
    dgebal_(&both, &n_, reduced_.data(), &n_, &lowest_, &highest_, scale_.data(), &info);
    if (info != 0) return;
    const int work_size = 64 * n_;
    Vector<double> work(work_size);
    dgehrd_(&n_, &lowest_, &highest_, reduced_.data(), &n_, reflectors_.data(), work.data(), &work_size, &info);
    if (info != 0) return;
    Matrix<double> iterated = reduced_;
    double unused = 0;
    const int zero = 0;
    const int one = 1;
    // The plain QR algorithm is the faster one up to about this size.
    constexpr int largest_plain = 200;
    if (n_ <= largest_plain) {
      dlahqr_(&zero, &zero, &n_, &lowest_, &highest_, iterated.data(), &n_, real_.data(), imaginary_.data(), &one, &n_,
              &unused, &one, &info);
      // Outside the balanced block the eigenvalues stand on the diagonal.
      for (int k = 0; k < n_; ++k) {
        if (k + 1 >= lowest_ && k + 1 <= highest_) continue;
        real_(k) = iterated(k, k);
        imaginary_(k) = 0;
      }
    } else {
      const char eigenvalues_only = 'E';
      const char no = 'N';
      dhseqr_(&eigenvalues_only, &no, &n_, &lowest_, &highest_, iterated.data(), &n_, real_.data(), imaginary_.data(),
              &unused, &one, work.data(), &work_size, &info);
    }
    converged_ = info == 0;
  }

  bool converged() const { return converged_; }
  int size() const { return n_; }
  /// The second ones of conjugate pairs have negative imaginary part.
  Complex eigenvalue(int k) const { return {real_(k), imaginary_(k)}; }

  /// Eigenvectors to the chosen eigenvalues, none of them the second one of a pair, by inverse iteration.
  std::vector<Eigen::VectorXcd> eigenvectors(const std::vector<int>& chosen) const {
    std::vector<Eigen::VectorXcd> vectors;
    if (chosen.empty()) return vectors;
    std::vector<int> select(static_cast<std::size_t>(n_), 0);
    int columns = 0;
    for (const int k : chosen) {
      select[static_cast<std::size_t>(k)] = 1;
      columns += imaginary_(k) == 0 ? 1 : 2;
    }
    Matrix<double> hessenberg = reduced_.triangularView<Eigen::Upper>();
    for (int k = 0; k + 1 < n_; ++k) hessenberg(k + 1, k) = reduced_(k + 1, k);
    Matrix<double> basis(n_, columns);
    Vector<double> real = real_;
    Vector<double> work((n_ + 2L) * n_);
    std::vector<int> left_failures(static_cast<std::size_t>(columns));
    std::vector<int> right_failures(static_cast<std::size_t>(columns));
    const char right = 'R';
    const char left = 'L';
    const char no = 'N';
    const int one = 1;
    double unused = 0;
    int used = 0;
    int info = 0;
    dhsein_(&right, &no, &no, select.data(), &n_, hessenberg.data(), &n_, real.data(), imaginary_.data(), &unused, &one,
            basis.data(), &n_, &columns, &used, work.data(), left_failures.data(), right_failures.data(), &info);
    if (info < 0) return vectors;
    const int work_size = static_cast<int>(work.size());
    dormhr_(&left, &no, &n_, &columns, &lowest_, &highest_, reduced_.data(), &n_, reflectors_.data(), basis.data(), &n_,
            work.data(), &work_size, &info);
    dgebak_(&both, &right, &n_, &lowest_, &highest_, scale_.data(), &columns, basis.data(), &n_, &info);
    int column = 0;
    for (int k = 0; k < n_; ++k) {
      if (select[static_cast<std::size_t>(k)] == 0) continue;
      Eigen::VectorXcd vector = basis.col(column++).cast<Complex>();
      if (imaginary_(k) != 0) vector += Complex(0, 1) * basis.col(column++);
      vectors.push_back(std::move(vector));
    }
    return vectors;
  }

 private:
  static constexpr char both = 'B';
  int n_;
  Matrix<double> reduced_;
  Vector<double> scale_, reflectors_, real_, imaginary_;
  int lowest_ = 1;
  int highest_ = 0;
  bool converged_ = false;
};

}  // namespace

std::vector<PlanePoint<double>> points_by_eigenvalues(const MultiplicationMatrices<double>& matrices,
                                                      const BivariatePolynomial<double>& p,
                                                      const BivariatePolynomial<double>& q, long m, long n) {
  std::vector<PlanePoint<double>> points;
  if (matrices.x.rows() == 0) return points;
  const Matrix<double> generic = generic_combination(matrices);
  if (!all_finite(generic)) return points;
  const HessenbergEigenproblem problem(generic);
  if (!problem.converged()) return points;
  // A point is taken from its line if Newton's method stays on the line; more steps are left to the caller.
  constexpr int newton_steps = 6;
  constexpr double tolerance = 1e-6;
  std::vector<int> left;
  for (int k = 0; k < problem.size(); ++k) {
    const Complex t = problem.eigenvalue(k);
    if (t.imag() < 0) continue;
    const auto found = common_zero_on_line(p, q, m, n, generic_lines, t);
    const auto on_line = [&](const PlanePoint<double>& point) {
      const Complex value = generic_lines.x_weight * point.x + generic_lines.y_weight * point.y;
      const double size = std::max({1.0, std::abs(point.x), std::abs(point.y)});
      return std::abs(value - t) <= tolerance * size;
    };
    if (found && on_line(newton_refinement<double>(p, q, *found, newton_steps)))
      points.push_back(*found);
    else
      left.push_back(k);
  }
  // Where many are left, the solutions are multiple, and no eigenvector is better than another.
  const std::size_t most_vectors = 16 + static_cast<std::size_t>(problem.size()) / 16;
  if (left.size() <= most_vectors)
    for (const Eigen::VectorXcd& vector : problem.eigenvectors(left)) points.push_back(point_of(matrices, vector));
  return points;
}

std::vector<PlanePoint<double>> points_by_eigenvectors(const MultiplicationMatrices<double>& matrices) {
  const int n = static_cast<int>(matrices.x.rows());
  std::vector<PlanePoint<double>> points;
  if (n == 0) return points;
  Matrix<double> generic = generic_combination(matrices);
  if (!all_finite(generic)) return points;
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
  for (int k = 0; k < n; ++k) {
    const bool pair = imaginary(k) != 0 && k + 1 < n;
    Eigen::VectorXcd vector = vectors.col(k).cast<Complex>();
    if (pair) vector += Complex(0, 1) * vectors.col(k + 1);
    points.push_back(point_of(matrices, vector));
    if (pair) ++k;
  }
  return points;
}

}  // namespace eliminant::numeric
