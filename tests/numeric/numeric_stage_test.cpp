// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/numeric/clustering.hpp>
#include <eliminant/numeric/companion_pencil.hpp>
#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/numeric/kernel_lifting.hpp>
#include <eliminant/numeric/kronecker_reduction.hpp>
#include <eliminant/numeric/newton_refinement.hpp>
#include <eliminant/numeric/resultant_solver.hpp>

using namespace eliminant::numeric;
using Complex = std::complex<double>;

namespace {

MatrixPolynomial<double> random_matrix_polynomial(long size, long degree, unsigned seed) {
  std::srand(seed);
  MatrixPolynomial<double> t;
  for (long k = 0; k <= degree; ++k) t.coefficients.push_back(Matrix<double>::Random(size, size));
  return t;
}

}  // namespace

TEST_CASE("Companion pencil: (v, x v, ...) is in its kernel exactly when v is in that of T(x)^t") {
  const MatrixPolynomial<double> t = random_matrix_polynomial(3, 2, 1);
  const Pencil<double> pencil = companion_pencil(t);
  const Eigen::Vector3d v(1, -2, 0.5);
  const double x = 0.7;
  Eigen::VectorXd stacked(6);
  stacked << v, x * v;
  const Eigen::VectorXd image = (pencil.a - x * pencil.b) * stacked;
  CHECK(image.head(3).norm() < 1e-15);
  const Eigen::VectorXcd direct = t.evaluate(x).transpose() * v.cast<Complex>();
  CHECK((image.tail(3).cast<Complex>() - direct).norm() < 1e-14);
}

TEST_CASE("Staircase: deflates Jordan blocks at infinity of known sizes and keeps the finite eigenvalues") {
  // T = P diag(x - 1, (x + 2)(x - 3), 5 + x^3 * 0) Q in degree 2: det of degree 3, pencil of size 6.
  Eigen::Matrix3d p;
  Eigen::Matrix3d q;
  p << 1, 2, 0, 0, 1, 3, 1, 0, 1;
  q << 2, 0, 1, 1, 1, 0, 0, 1, 1;
  MatrixPolynomial<double> t;
  t.coefficients.push_back(p * Eigen::Vector3d(-1, -6, 5).asDiagonal() * q);
  t.coefficients.push_back(p * Eigen::Vector3d(1, -1, 0).asDiagonal() * q);
  t.coefficients.push_back(p * Eigen::Vector3d(0, 1, 0).asDiagonal() * q);
  // At infinity, with z = 1/x: z^2 (1/z - 1) = z - z^2 has order 1, the second 0, the constant 2: counts 2, 1.
  const RegularPart<double> regular = regular_part_staircase(t, {2, 1});
  REQUIRE(regular.pencil.size() == 3);
  const auto pairs = generalized_eigen(regular.pencil);
  REQUIRE(pairs.has_value());
  REQUIRE(pairs->values.size() == 3);
  std::vector<double> values;
  for (long k = 0; k < 3; ++k) values.push_back(pairs->values(k).real());
  std::sort(values.begin(), values.end());
  CHECK(values[0] == doctest::Approx(-2).epsilon(1e-13));
  CHECK(values[1] == doctest::Approx(1).epsilon(1e-13));
  CHECK(values[2] == doctest::Approx(3).epsilon(1e-13));
  const Pencil<double> companion = companion_pencil(t);
  for (long k = 0; k < 3; ++k) {
    const Eigen::VectorXcd v = regular.right_basis.cast<Complex>() * pairs->vectors.col(k);
    const Eigen::VectorXcd residual =
        companion.a.cast<Complex>() * v - pairs->values(k) * (companion.b.cast<Complex>() * v);
    CHECK(residual.norm() < 1e-12 * v.norm());
  }
}

TEST_CASE("Clustering: a distance joins chains, a count stops at the exact number") {
  Eigen::VectorXcd values(6);
  values << Complex(0), Complex(1e-8), Complex(2e-8), Complex(1), Complex(0, 1e-7), Complex(1 + 1e-9);
  CHECK(cluster_values<double>(values, {0, 1e-6}).size() == 2);
  CHECK(cluster_values<double>(values, {0, 5e-8}).size() == 3);
  const auto four = cluster_values<double>(values, {4, 0});
  REQUIRE(four.size() == 4);
  CHECK(four[2] == Cluster{3, 5});
  CHECK(cluster_values<double>(values, {6, 0}).size() == 6);
  CHECK(cluster_values<double>(Eigen::VectorXcd(0), {0, 0}).empty());
}

TEST_CASE("Proposition 7: Delta_0 and Delta_1 give the roots of the fibre's gcd, in any basis of the kernel") {
  // (1, y, ..., y^4) for y = 2, -3, i, mixed by an invertible matrix.
  const std::vector<Complex> ys{2, -3, Complex(0, 1)};
  Eigen::MatrixXcd basis(5, 3);
  for (long k = 0; k < 3; ++k) {
    Complex power = 1;
    for (long i = 0; i < 5; ++i, power *= ys[static_cast<std::size_t>(k)]) basis(i, k) = power;
  }
  Eigen::Matrix3cd mix;
  mix << 1, 2, Complex(0, 1), 0, 1, 1, 3, 0, 1;
  std::vector<Complex> found = fibre_coordinates<double>(basis * mix);
  REQUIRE(found.size() == 3);
  for (const Complex& y : ys)
    CHECK(std::any_of(found.begin(), found.end(), [&](const Complex& z) { return std::abs(z - y) < 1e-12; }));
}

TEST_CASE("Proposition 7: a functional at y = infinity is left out") {
  // y = 2 and the last unit vector. The second is no vector (1, y, ...), but it is what the kernel contains where both
  // leading coefficients vanish; Delta_0 is then singular.
  Eigen::MatrixXcd basis(3, 2);
  basis << 1, 0, 2, 0, 4, 1;
  const std::vector<Complex> found = fibre_coordinates<double>(basis);
  REQUIRE(found.size() == 1);
  CHECK(std::abs(found.front() - Complex(2)) < 1e-12);
}

TEST_CASE("Numerical rank: counts singular values above the tolerance relative to the largest") {
  CHECK(numerical_rank<double>(Eigen::Vector3d(1, 1e-3, 1e-9), 1e-6) == 2);
  CHECK(numerical_rank<double>(Eigen::Vector3d(1e-9, 1e-16, 0), 1e-6) == 1);
  CHECK(numerical_rank<double>(Eigen::Vector3d(0, 0, 0), 1e-6) == 0);
}

TEST_CASE("Newton refinement: converges quadratically to a simple zero and stays finite elsewhere") {
  BivariatePolynomial<double> p{Matrix<double>::Zero(3, 3)};  // x^2 + y^2 - 5
  p.coefficients(2, 0) = p.coefficients(0, 2) = 1;
  p.coefficients(0, 0) = -5;
  BivariatePolynomial<double> q{Matrix<double>::Zero(2, 2)};  // x y - 2
  q.coefficients(1, 1) = 1;
  q.coefficients(0, 0) = -2;
  const PlanePoint<double> point = newton_refinement<double>(p, q, {Complex(1.1), Complex(1.9)}, 20);
  CHECK(std::abs(point.x - 1.0) < 1e-15);
  CHECK(std::abs(point.y - 2.0) < 1e-15);
  const PlanePoint<double> stuck = newton_refinement<double>(p, q, {Complex(0), Complex(0)}, 20);
  CHECK(is_finite(stuck.x));
}
