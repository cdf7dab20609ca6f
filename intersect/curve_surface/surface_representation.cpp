// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/surface_representation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/rational_preimages.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>
#include <eliminant/symbolic/matrices/row_monomials.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ImplicitDegree;
using symbolic::IntegerMatrix;
using symbolic::MatrixRepresentation;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalSurface;
using symbolic::RowMonomials;
using Complex = std::complex<double>;
using Exponents = std::vector<unsigned long>;

/// The representation of the smallest admissible degree that is at least `least` in each group of parameters.
MatrixRepresentation representation(const RationalSurface& surface, long least, std::uint64_t seed) {
  if (surface.kind() == RationalSurface::Kind::triangular)
    return symbolic::moving_plane_matrix(surface, std::max(least, symbolic::representation_degree(surface, seed)));
  std::array<long, 2> nu = symbolic::representation_bidegree(surface);
  for (long& degree : nu) degree = std::max(degree, least);
  return symbolic::moving_plane_matrix(surface, nu);
}

/// All monomials of the degrees of the largest one, each once.
bool are_all_monomials(const RationalSurface& surface, const std::vector<Exponents>& rows) {
  const std::size_t parameters = surface.coordinates().front().variable_count();
  if (rows.empty()) return false;
  Exponents highest(parameters, 0);
  unsigned long expected = 1;
  for (const Exponents& row : rows) {
    if (row.size() != parameters) return false;
    for (std::size_t k = 0; k < parameters; ++k) highest[k] = std::max(highest[k], row[k]);
  }
  if (surface.kind() == RationalSurface::Kind::triangular) {
    const unsigned long degree = highest[0];
    const bool homogeneous =
        std::all_of(rows.begin(), rows.end(), [&](const Exponents& row) { return row[0] + row[1] + row[2] == degree; });
    if (!homogeneous) return false;
    expected = (degree + 1) * (degree + 2) / 2;
  } else {
    expected = (highest[0] + 1) * (highest[1] + 1);
  }
  std::vector<Exponents> sorted = rows;
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() && sorted.size() == expected;
}

/// Whether the sum over rows and coordinates of entry * monomial * f_k is zero.
bool is_moving_plane(const RationalSurface& surface, const MatrixRepresentation& m, long column) {
  Polynomial sum(surface.coordinates().front().variable_count());
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Polynomial::Term> terms;
    for (long i = 0; i < m.rows(); ++i)
      terms.push_back({Rational(symbolic::Integer(m.coefficients[k].entry(i, column))),
                       m.row_monomials[static_cast<std::size_t>(i)]});
    sum = sum + Polynomial::from_terms(sum.variable_count(), terms) * surface.coordinates()[k];
  }
  return sum.is_zero();
}

void require_moving_planes(const RationalSurface& surface, const MatrixRepresentation& m) {
  const auto refuse = [](const std::string& what) {
    throw InvalidInput("the matrix is no representation of the surface: " + what, "a matrix of its moving planes");
  };
  if (m.coefficients.size() != 4) refuse("it has not four variables");
  for (const IntegerMatrix& coefficients : m.coefficients)
    if (coefficients.rows() != m.rows() || coefficients.columns() != m.columns())
      refuse("its coefficients differ in size");
  if (static_cast<long>(m.row_monomials.size()) != m.rows() || !are_all_monomials(surface, m.row_monomials))
    refuse("its rows do not belong to all monomials of one degree");
  for (long j = 0; j < m.columns(); ++j)
    if (!is_moving_plane(surface, m, j)) refuse("column " + std::to_string(j + 1) + " is no moving plane");
  IntegerMatrix columns(4 * m.rows(), m.columns());
  for (long k = 0; k < 4; ++k)
    for (long i = 0; i < m.rows(); ++i)
      for (long j = 0; j < m.columns(); ++j)
        fmpz_set(columns.entry(k * m.rows() + i, j), m.coefficients[static_cast<std::size_t>(k)].entry(i, j));
  if (columns.rank() < m.columns()) refuse("its columns are dependent");
}

Rational value_of(const Polynomial& form, const std::vector<Rational>& point) {
  std::vector<Polynomial> images;
  for (const Rational& coordinate : point) images.push_back(Polynomial::constant(1, coordinate));
  return form.compose(images).constant_term();
}

/// Two parameters of a tensor product instead of two pairs.
std::vector<RationalParameter> affine(const RationalSurface& surface, const std::vector<Rational>& homogeneous) {
  if (surface.kind() == RationalSurface::Kind::triangular) return {homogeneous.begin(), homogeneous.end()};
  std::vector<RationalParameter> result;
  for (std::size_t k = 0; k < 4; k += 2)
    result.push_back(homogeneous[k + 1].is_zero() ? std::nullopt : RationalParameter(homogeneous[k]));
  return result;
}

std::vector<Complex> values_of(const Eigen::RowVectorXcd& row) { return {row.data(), row.data() + row.size()}; }

std::size_t largest_of(const std::vector<Complex>& values) {
  return static_cast<std::size_t>(
      std::max_element(values.begin(), values.end(), [](Complex a, Complex b) { return std::abs(a) < std::abs(b); }) -
      values.begin());
}

/// The parameters whose row monomials span the kernel, whose basis stands in rows: eigenvectors of the quotient of the
/// multiplications by two forms ([ManochaDemmel1995]).
std::vector<std::vector<Complex>> separate(const RowMonomials& rows, const Eigen::MatrixXd& kernel) {
  const std::vector<std::vector<std::size_t>> multiples = rows.multiples();
  const Eigen::Index count = kernel.rows();
  if (static_cast<Eigen::Index>(multiples.size()) < count) return {};
  const auto multiplication = [&](std::uint64_t seed) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(multiples.size()));
    for (std::size_t j = 0; j < multiples.size(); ++j)
      for (std::size_t f = 0; f < multiples[j].size(); ++f)
        result.col(static_cast<Eigen::Index>(j)) +=
            (static_cast<double>(symbolic::mix(seed, f) % 2001) / 1000.0 - 1.0) *
            kernel.col(static_cast<Eigen::Index>(multiples[j][f]));
    return result;
  };
  const Eigen::MatrixXd above = multiplication(1);
  const Eigen::MatrixXd below = multiplication(2);
  // y above = lambda y below, in least squares.
  const Eigen::MatrixXd quotient = below.transpose().colPivHouseholderQr().solve(above.transpose());
  if (!quotient.allFinite()) return {};
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(quotient);
  if (eigen.info() != Eigen::Success) return {};
  std::vector<std::vector<Complex>> result;
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::vector<Complex> values = values_of(eigen.eigenvectors().col(i).transpose() * kernel.cast<Complex>());
    if (auto parameters = rows.parameters(values, largest_of(values))) result.push_back(*std::move(parameters));
  }
  return result;
}

}  // namespace

SurfaceRepresentation::SurfaceRepresentation(RationalSurface surface, std::uint64_t seed, const Context& context)
    : surface_(std::move(surface)), matrix_(representation(surface_, 1, seed)) {
  symbolic::install_flint_error_handler();
  if (symbolic::generic_rank_modulo(matrix_, seed) < matrix_.rows())
    throw LimitReached("the base points of the surface leave no matrix representation by moving planes");
  degree_ = symbolic::implicit_degree(surface_, matrix_, seed);
  prepare(context);
}

SurfaceRepresentation::SurfaceRepresentation(RationalSurface surface, MatrixRepresentation matrix,
                                             ImplicitDegree degree, const Context& context)
    : surface_(std::move(surface)), matrix_(std::move(matrix)), degree_(degree) {
  symbolic::install_flint_error_handler();
  require_moving_planes(surface_, matrix_);
  if (symbolic::generic_rank_modulo(matrix_, 0) < matrix_.rows())
    throw InvalidInput("the rank of the matrix drops everywhere", "a matrix representation");
  prepare(context);
}

void SurfaceRepresentation::prepare(const Context& context) {
  if (degree_.minors != degree_.product)
    equation_ = symbolic::implicit_equation(surface_, matrix_, degree_, 0, context);
  std::vector<long> exponents(static_cast<std::size_t>(matrix_.columns()), 0);
  for (const IntegerMatrix& coefficients : matrix_.coefficients)
    for (long i = 0; i < matrix_.rows(); ++i)
      for (long j = 0; j < matrix_.columns(); ++j)
        exponents[static_cast<std::size_t>(j)] =
            std::max(exponents[static_cast<std::size_t>(j)], static_cast<long>(fmpz_bits(coefficients.entry(i, j))));
  for (std::size_t k = 0; k < 4; ++k) {
    rounded_[k].clear();
    for (long i = 0; i < matrix_.rows(); ++i)
      for (long j = 0; j < matrix_.columns(); ++j) {
        slong exponent = 0;
        const double mantissa = fmpz_get_d_2exp(&exponent, matrix_.coefficients[k].entry(i, j));
        const long shift = std::max(exponent - exponents[static_cast<std::size_t>(j)], -2000L);
        rounded_[k].push_back(std::ldexp(mantissa, static_cast<int>(shift)));
      }
  }
}

Membership SurfaceRepresentation::membership(const std::vector<Rational>& point) const {
  symbolic::RationalPreimages found = symbolic::rational_preimages(surface_, matrix_, point);
  Membership result;
  result.kernel_dimension = found.kernel_dimension;
  if (found.kernel_dimension == 0) return result;
  result.on_surface = !equation_ || value_of(*equation_, point).is_zero();
  if (!result.on_surface) return result;
  if (found.kernel_dimension > 1 &&
      !RowMonomials(surface_.kind(), matrix_).has_degree(static_cast<unsigned long>(found.kernel_dimension)))
    found = symbolic::rational_preimages(surface_, representation(surface_, found.kernel_dimension, 0), point);
  for (const std::vector<Rational>& parameters : found.parameters)
    result.preimages.push_back(affine(surface_, parameters));
  return result;
}

ApproximateMembership SurfaceRepresentation::approx_membership(const std::array<double, 4>& point,
                                                               double tolerance) const {
  if (!(tolerance > 0 && tolerance < 1))
    throw InvalidInput("the tolerance of a point of a surface is not between 0 and 1", "such as 1e-10");
  double largest = 0;
  for (const double coordinate : point) {
    if (!std::isfinite(coordinate)) throw InvalidInput("a coordinate of a point is not finite", "finite coordinates");
    largest = std::max(largest, std::fabs(coordinate));
  }
  if (largest == 0)
    throw InvalidInput("the homogeneous coordinates of a point are all zero", "a coordinate that is not zero");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::MatrixXd value = Eigen::MatrixXd::Zero(matrix_.rows(), matrix_.columns());
  for (std::size_t k = 0; k < 4; ++k)
    value += (point[k] / largest) * Eigen::Map<const RowMajor>(rounded_[k].data(), matrix_.rows(), matrix_.columns());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(value, Eigen::ComputeFullU);
  const Eigen::VectorXd& singular = svd.singularValues();
  ApproximateMembership result;
  const double reference = singular(0) > 0 ? singular(0) : 1;
  result.relative_singular_value = singular(singular.size() - 1) / reference;
  for (Eigen::Index i = 0; i < singular.size(); ++i)
    if (singular(i) <= tolerance * reference) ++result.kernel_dimension;
  if (result.kernel_dimension == 0) return result;
  const RowMonomials rows(surface_.kind(), matrix_);
  const Eigen::MatrixXd kernel = svd.matrixU().rightCols(result.kernel_dimension).transpose();
  if (result.kernel_dimension > 1) {
    result.preimages = separate(rows, kernel);
    return result;
  }
  const std::vector<Complex> values = values_of(kernel.cast<Complex>().row(0));
  if (auto parameters = rows.parameters(values, largest_of(values))) result.preimages.push_back(*std::move(parameters));
  return result;
}

}  // namespace eliminant::intersect
