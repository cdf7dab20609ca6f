// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/surface_preimages.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <eliminant/bridge/enclosures/ball_matrix.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using Exponents = std::vector<unsigned long>;

double magnitude_log2(const ComplexBall& z) {
  bridge::Magnitude magnitude;
  acb_get_mag(magnitude.get(), z.get());
  return mag_get_d_log2_approx(magnitude.get());
}

std::complex<double> rounded(const ComplexBall& z) {
  return {arf_get_d(arb_midref(z.real()), ARF_RND_NEAR), arf_get_d(arb_midref(z.imaginary()), ARF_RND_NEAR)};
}

/// (i, j) -> (i, m - i, j, n - j)
Exponents homogeneous(const Exponents& exponents, std::array<unsigned long, 2> degrees) {
  return {exponents[0], degrees[0] - exponents[0], exponents[1], degrees[1] - exponents[1]};
}

/// Elimination with complete pivoting, as far as pivots are surely not zero.
class KernelElimination {
 public:
  KernelElimination(std::vector<std::vector<ComplexBall>> rows, long precision_bits)
      : rows_(std::move(rows)), precision_bits_(precision_bits) {
    const std::size_t columns = rows_.front().size();
    for (std::size_t j = 0; j < columns; ++j) order_.push_back(j);
    while (rank_ < std::min(rows_.size(), columns) && pivot()) eliminate();
  }

  std::size_t rank() const { return rank_; }

  /// A basis of the kernel, if the rank is what was found: one vector for each column without a pivot.
  std::vector<std::vector<ComplexBall>> kernel() const {
    std::vector<std::vector<ComplexBall>> basis;
    for (std::size_t free = rank_; free < order_.size(); ++free) {
      std::vector<ComplexBall> vector(order_.size());
      acb_one(vector[order_[free]].get());
      for (std::size_t i = rank_; i-- > 0;) {
        ComplexBall sum = rows_[i][order_[free]];
        for (std::size_t j = i + 1; j < rank_; ++j)
          acb_addmul(sum.get(), rows_[i][order_[j]].get(), vector[order_[j]].get(), precision_bits_);
        acb_div(sum.get(), sum.get(), rows_[i][order_[i]].get(), precision_bits_);
        acb_neg(vector[order_[i]].get(), sum.get());
      }
      basis.push_back(std::move(vector));
    }
    return basis;
  }

 private:
  /// Brings the largest entry left to the next place of the diagonal; false when all may be zero.
  bool pivot() {
    double largest = -INFINITY;
    std::size_t row = 0;
    std::size_t column = 0;
    for (std::size_t i = rank_; i < rows_.size(); ++i)
      for (std::size_t j = rank_; j < order_.size(); ++j) {
        const ComplexBall& entry = rows_[i][order_[j]];
        if (acb_contains_zero(entry.get()) != 0) continue;
        const double size = magnitude_log2(entry);
        if (size <= largest) continue;
        largest = size;
        row = i;
        column = j;
      }
    if (largest == -INFINITY) return false;
    std::swap(rows_[rank_], rows_[row]);
    std::swap(order_[rank_], order_[column]);
    return true;
  }

  void eliminate() {
    const std::size_t k = rank_++;
    ComplexBall factor;
    for (std::size_t i = k + 1; i < rows_.size(); ++i) {
      if (acb_is_zero(rows_[i][order_[k]].get()) != 0) continue;
      acb_div(factor.get(), rows_[i][order_[k]].get(), rows_[k][order_[k]].get(), precision_bits_);
      for (std::size_t j = k + 1; j < order_.size(); ++j)
        acb_submul(rows_[i][order_[j]].get(), factor.get(), rows_[k][order_[j]].get(), precision_bits_);
      acb_zero(rows_[i][order_[k]].get());
    }
  }

  std::vector<std::vector<ComplexBall>> rows_;
  std::vector<std::size_t> order_;
  std::size_t rank_ = 0;
  long precision_bits_;
};

}  // namespace

SurfaceInversion::SurfaceInversion(const symbolic::RationalSurface& surface, const symbolic::MatrixRepresentation& m)
    : surface_(surface), m_(m), rows_(m.row_monomials) {
  if (!surface_.is_tensor_product()) return;
  std::array<unsigned long, 2> degrees{0, 0};
  for (const Exponents& row : rows_)
    for (std::size_t k = 0; k < 2; ++k) degrees[k] = std::max(degrees[k], row[k]);
  for (Exponents& row : rows_) row = homogeneous(row, degrees);
}

std::optional<Preimages> SurfaceInversion::preimages(const std::vector<ComplexBall>& point, long largest_dimension,
                                                     long map_degree, long precision_bits) const {
  std::vector<std::vector<ComplexBall>> transposed(static_cast<std::size_t>(m_.columns()),
                                                   std::vector<ComplexBall>(static_cast<std::size_t>(m_.rows())));
  for (long i = 0; i < m_.rows(); ++i)
    for (long j = 0; j < m_.columns(); ++j)
      for (std::size_t k = 0; k < 4; ++k)
        acb_addmul_fmpz(transposed[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].get(), point[k].get(),
                        m_.coefficients[k].entry(i, j), precision_bits);
  const KernelElimination elimination(std::move(transposed), precision_bits);
  Preimages result;
  result.kernel_dimension = m_.rows() - static_cast<long>(elimination.rank());
  if (result.kernel_dimension > largest_dimension) return std::nullopt;
  // A point of the surface has a kernel.
  if (result.kernel_dimension < 1) return result;
  const std::vector<std::vector<ComplexBall>> kernel = elimination.kernel();
  if (result.kernel_dimension > 1) {
    // Of a surface that has so many parameters everywhere the dimension cannot be smaller.
    if (result.kernel_dimension == map_degree) {
      if (auto all = enclose_all(kernel, precision_bits)) {
        result.parameters = *std::move(all);
        result.proven = true;
        return result;
      }
    }
    result.parameters = separate(kernel);
    return result;
  }
  std::optional<HomogeneousParameters> parameters = read(kernel.front(), precision_bits);
  if (!parameters) return std::nullopt;
  result.parameters.push_back(*std::move(parameters));
  result.proven = true;
  return result;
}

/// Ratios of the value of the largest monomial to those that differ from it in one group by one step.
std::optional<HomogeneousParameters> SurfaceInversion::read(const std::vector<ComplexBall>& kernel,
                                                            long precision_bits) const {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < kernel.size(); ++i)
    if (magnitude_log2(kernel[i]) > magnitude_log2(kernel[largest])) largest = i;
  if (acb_contains_zero(kernel[largest].get()) != 0) return std::nullopt;
  std::map<Exponents, std::size_t> position;
  for (std::size_t i = 0; i < rows_.size(); ++i) position[rows_[i]] = i;
  HomogeneousParameters parameters(rows_.front().size());
  for (const std::vector<std::size_t>& group : surface_.groups()) {
    // The largest parameter of the group is one that the largest monomial contains, or stands beside.
    std::size_t base = group.front();
    for (const std::size_t k : group)
      if (rows_[largest][k] > rows_[largest][base]) base = k;
    if (rows_[largest][base] == 0) return std::nullopt;
    acb_one(parameters[base].get());
    for (const std::size_t k : group) {
      if (k == base) continue;
      Exponents neighbour = rows_[largest];
      --neighbour[base];
      ++neighbour[k];
      acb_div(parameters[k].get(), kernel[position.at(neighbour)].get(), kernel[largest].get(), precision_bits);
    }
  }
  return parameters;
}

/// The sums over the row monomials that stand for the multiplication by two forms of degree one in each group of
/// parameters: for each of `count` combinations of lower monomials the weights of the rows, above and below the
/// fraction.
struct SurfaceInversion::Multiplication {
  std::vector<std::vector<double>> above;
  std::vector<std::vector<double>> below;
};

SurfaceInversion::Multiplication SurfaceInversion::multiplication(std::size_t count) const {
  std::uint64_t drawn = 0;
  // Small dyadic numbers: exact in balls too.
  const auto random = [&drawn] { return static_cast<double>(symbolic::mix(7, drawn++) % 2049) / 1024.0 - 1.0; };
  std::vector<Exponents> factors{Exponents(rows_.front().size(), 0)};
  for (const std::vector<std::size_t>& group : surface_.groups()) {
    unsigned long degree = 0;
    for (const std::size_t p : group) degree += rows_.front()[p];
    if (degree == 0) continue;
    std::vector<Exponents> extended;
    for (const Exponents& factor : factors)
      for (const std::size_t p : group) {
        extended.push_back(factor);
        ++extended.back()[p];
      }
    factors = std::move(extended);
  }
  struct Multiple {
    std::size_t factor;  // an index of the monomial that was divided out
    std::size_t row;
  };
  std::map<Exponents, std::vector<Multiple>> lower;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t f = 0; f < factors.size(); ++f) {
      Exponents divided = rows_[i];
      bool divisible = true;
      for (std::size_t p = 0; p < divided.size(); ++p) {
        divisible = divisible && divided[p] >= factors[f][p];
        divided[p] -= factors[f][p];
      }
      if (divisible) lower[divided].push_back({f, i});
    }
  std::vector<double> numerator;
  std::vector<double> denominator;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    numerator.push_back(random());
    denominator.push_back(random());
  }
  Multiplication result;
  result.above.assign(count, std::vector<double>(rows_.size(), 0.0));
  result.below = result.above;
  for (const auto& [exponents, multiples] : lower)
    for (std::size_t j = 0; j < count; ++j) {
      const double weight = random();
      for (const Multiple& multiple : multiples) {
        result.above[j][multiple.row] += weight * numerator[multiple.factor];
        result.below[j][multiple.row] += weight * denominator[multiple.factor];
      }
    }
  return result;
}

/// Several parameters of one point: the kernel is spanned by the values of the monomials at each of them, so that the
/// multiplication by a fraction of two forms becomes a matrix with these values as eigenvectors ([ManochaDemmel1995]).
std::vector<HomogeneousParameters> SurfaceInversion::separate(
    const std::vector<std::vector<bridge::ComplexBall>>& kernel) const {
  using Matrix = Eigen::MatrixXcd;
  const auto count = static_cast<Eigen::Index>(kernel.size());
  Matrix k(count, static_cast<Eigen::Index>(rows_.size()));
  for (Eigen::Index i = 0; i < count; ++i)
    for (std::size_t j = 0; j < rows_.size(); ++j)
      k(i, static_cast<Eigen::Index>(j)) = rounded(kernel[static_cast<std::size_t>(i)][j]);
  const Eigen::HouseholderQR<Matrix> qr(k.adjoint());
  const Matrix orthonormal = (qr.householderQ() * Matrix::Identity(k.cols(), count)).adjoint();
  const Multiplication by = multiplication(kernel.size());
  Matrix above = Matrix::Zero(count, count);
  Matrix below = Matrix::Zero(count, count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      above.col(j) += by.above[static_cast<std::size_t>(j)][row] * orthonormal.col(static_cast<Eigen::Index>(row));
      below.col(j) += by.below[static_cast<std::size_t>(j)][row] * orthonormal.col(static_cast<Eigen::Index>(row));
    }
  // Left eigenvectors: y^T above = lambda y^T below.
  const Matrix quotient = below.transpose().fullPivLu().solve(above.transpose());
  if (!quotient.allFinite()) return {};
  const Eigen::ComplexEigenSolver<Matrix> eigen(quotient);
  if (eigen.info() != Eigen::Success) return {};
  std::vector<HomogeneousParameters> result;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::RowVectorXcd values = eigen.eigenvectors().col(i).transpose() * orthonormal;
    std::vector<ComplexBall> balls;
    for (Eigen::Index j = 0; j < values.size(); ++j) balls.emplace_back(values(j).real(), values(j).imag());
    if (std::optional<HomogeneousParameters> parameters = read(balls, 64)) result.push_back(*std::move(parameters));
  }
  return result;
}

/// The same in balls, for a kernel of which the dimension is known: all parameters, when they are different.
std::optional<std::vector<HomogeneousParameters>> SurfaceInversion::enclose_all(
    const std::vector<std::vector<bridge::ComplexBall>>& kernel, long precision_bits) const {
  const std::size_t count = kernel.size();
  const Multiplication by = multiplication(count);
  bridge::BallMatrix above(count, count);
  bridge::BallMatrix below(count, count);
  // Transposed: row j, column i.
  const auto add = [&](bridge::BallMatrix& matrix, const std::vector<std::vector<double>>& weights) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j)
        for (std::size_t row = 0; row < rows_.size(); ++row) {
          const ComplexBall weight(weights[j][row], 0);
          acb_addmul(matrix.entry(j, i), weight.get(), kernel[i][row].get(), precision_bits);
        }
  };
  add(above, by.above);
  add(below, by.below);
  bridge::BallMatrix quotient(count, count);
  if (acb_mat_solve(quotient.get(), below.get(), above.get(), precision_bits) == 0) return std::nullopt;
  const std::optional<bridge::BallMatrix> vectors = bridge::simple_eigenvectors(quotient, precision_bits);
  if (!vectors) return std::nullopt;
  std::vector<HomogeneousParameters> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<ComplexBall> values(rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t k = 0; k < count; ++k)
        acb_addmul(values[row].get(), vectors->entry(k, i), kernel[k][row].get(), precision_bits);
    std::optional<HomogeneousParameters> parameters = read(values, precision_bits);
    if (!parameters) return std::nullopt;
    result.push_back(*std::move(parameters));
  }
  return result;
}

}  // namespace eliminant::intersect
