// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <Eigen/LU>

#include <eliminant/numeric/eigenvalue_clusters.hpp>
#include <eliminant/numeric/line_lifting.hpp>
#include <eliminant/numeric/multiplication_matrix.hpp>

using namespace eliminant::numeric;
using Complex = std::complex<double>;

namespace {

/// The hybrid Bezout matrix of p = x^2 + y^2 - 5 and q = x y - 2 with x hidden, by hand: a_2 = 1, a_1 = 0, b_2 = 0, b_1
/// = x and formal degrees 2, 2. Row 0 is a_2 q - b_2 p = x y - 2, row 1 is (a_2 y + a_1) q - (b_2 y + b_1) p, that is
/// y (x y - 2) - x (x^2 + y^2 - 5) = -2 y - x^3 + 5 x.
MatrixPolynomial<double> circle_and_hyperbola() {
  MatrixPolynomial<double> matrix;
  matrix.coefficients.assign(4, Matrix<double>::Zero(2, 2));
  matrix.coefficients[0](0, 0) = -2;
  matrix.coefficients[1](0, 1) = 1;
  matrix.coefficients[0](1, 1) = -2;
  matrix.coefficients[1](1, 0) = 5;
  matrix.coefficients[3](1, 0) = -1;
  return matrix;
}

}  // namespace

TEST_CASE("Graded pencil: multiplication matrices commute and have the solutions as joint eigenvalues") {
  BivariatePolynomial<double> p{Matrix<double>::Zero(3, 3)};
  p.coefficients(2, 0) = p.coefficients(0, 2) = 1;
  p.coefficients(0, 0) = -5;
  BivariatePolynomial<double> q{Matrix<double>::Zero(2, 2)};
  q.coefficients(1, 1) = 1;
  q.coefficients(0, 0) = -2;
  const auto matrices = multiplication_matrices<double>(circle_and_hyperbola(), p, q, 2, 2);
  REQUIRE(matrices.has_value());
  REQUIRE(matrices->x.rows() == 4);
  CHECK((matrices->x * matrices->y - matrices->y * matrices->x).norm() < 1e-13);
  // x^2 + y^2 = 5 and x y = 2 hold for the matrices.
  CHECK((matrices->x * matrices->x + matrices->y * matrices->y - 5 * Matrix<double>::Identity(4, 4)).norm() < 1e-13);
  CHECK((matrices->x * matrices->y - 2 * Matrix<double>::Identity(4, 4)).norm() < 1e-13);
  for (const auto& points : {points_by_eigenvectors(*matrices), points_by_eigenvalues(*matrices, p, q, 2, 2)}) {
    REQUIRE(points.size() == 4);
    for (const auto& expected : {std::pair{1.0, 2.0}, {2.0, 1.0}, {-1.0, -2.0}, {-2.0, -1.0}})
      CHECK(std::count_if(points.begin(), points.end(), [&](const PlanePoint<double>& point) {
              return std::abs(point.x - expected.first) < 1e-12 && std::abs(point.y - expected.second) < 1e-12;
            }) == 1);
  }
}

TEST_CASE("Line lifting: the common zero on a line, for all pairs of degrees") {
  // Products of lines; only x + y = 3 and y = 2 x meet in (1, 2).
  using Complex = std::complex<double>;
  const auto times_line = [](const Matrix<double>& p, double a, double b, double c) {  // a x + b y + c
    Matrix<double> product = Matrix<double>::Zero(p.rows() + 1, p.cols() + 1);
    product.bottomLeftCorner(p.rows(), p.cols()) += a * p;
    product.topRightCorner(p.rows(), p.cols()) += b * p;
    product.topLeftCorner(p.rows(), p.cols()) += c * p;
    return product;
  };
  const LinePencil lines{0.9, 0.2};
  for (long m = 1; m <= 4; ++m)
    for (long n = 1; n <= m; ++n) {
      CAPTURE(m);
      CAPTURE(n);
      BivariatePolynomial<double> p{Matrix<double>::Ones(1, 1)};
      BivariatePolynomial<double> q{Matrix<double>::Ones(1, 1)};
      for (long k = 0; k < m; ++k) {
        const auto slope = static_cast<double>(k + 1);
        p.coefficients = times_line(p.coefficients, slope, 1, k == 0 ? -3 : 1 - 5 * slope);
      }
      for (long k = 0; k < n; ++k) {
        const auto slope = static_cast<double>(k + 2);
        q.coefficients = times_line(q.coefficients, slope, -1, k == 0 ? 0 : 7 * slope);
      }
      const Complex t = lines.x_weight * 1 + lines.y_weight * 2;
      const auto point = common_zero_on_line(p, q, m, n, lines, t);
      REQUIRE(point.has_value());
      CHECK(std::abs(point->x - 1.0) < 1e-10);
      CHECK(std::abs(point->y - 2.0) < 1e-10);
    }
}

TEST_CASE("Graded pencil: curves with a common point at infinity have no top coefficients to invert") {
  // Without y^2 in both and with the leading form x y twice, nothing replaces y^2.
  BivariatePolynomial<double> p{Matrix<double>::Zero(2, 2)};
  p.coefficients(1, 1) = 1;
  p.coefficients(0, 0) = -2;
  MatrixPolynomial<double> matrix;
  matrix.coefficients.assign(2, Matrix<double>::Zero(2, 2));
  matrix.coefficients[0](0, 0) = 1;
  CHECK_FALSE(multiplication_matrices<double>(matrix, p, p, 2, 2).has_value());
}

TEST_CASE("Eigenvalue clusters: multiplicities as dimensions of invariant subspaces, the mean well-conditioned") {
  // (x - 1)^2 = 0 and y^2 (y - 2) = 0: (1, 0) with multiplicity 4 and (1, 2) with multiplicity 2, in a random basis.
  Matrix<double> x_block(2, 2);
  x_block << 0, 1, -1, 2;
  Matrix<double> y_block(3, 3);
  y_block << 0, 1, 0, 0, 0, 1, 0, 0, 2;
  const auto kronecker = [](const Matrix<double>& a, const Matrix<double>& b) {
    Matrix<double> product(a.rows() * b.rows(), a.cols() * b.cols());
    for (long i = 0; i < a.rows(); ++i)
      for (long j = 0; j < a.cols(); ++j) product.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
    return product;
  };
  Matrix<double> basis(6, 6);
  for (long i = 0; i < 6; ++i)
    for (long j = 0; j < 6; ++j)
      basis(i, j) = (i == j ? 3.0 : 0.0) + std::sin(static_cast<double>(7 * i * i + 3 * j + 1));
  const Matrix<double> inverse = basis.inverse();
  MultiplicationMatrices<double> matrices;
  matrices.x = inverse * kronecker(x_block, Matrix<double>::Identity(3, 3)) * basis;
  matrices.y = inverse * kronecker(Matrix<double>::Identity(2, 2), y_block) * basis;
  const auto points = points_by_clusters(matrices);
  REQUIRE(points.has_value());
  REQUIRE(points->size() == 2);
  for (const ClusteredPoint& each : *points) {
    CHECK(std::abs(each.point.x - 1.0) < 1e-10);
    CHECK(std::abs(each.point.y - (each.multiplicity == 4 ? 0.0 : 2.0)) < 1e-10);
    CHECK((each.multiplicity == 4 || each.multiplicity == 2));
  }
}
