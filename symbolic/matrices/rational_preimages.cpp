// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/rational_preimages.hpp>

#include <algorithm>
#include <optional>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/polynomial_matrix.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>
#include <eliminant/symbolic/matrices/row_monomials.hpp>

namespace eliminant::symbolic {

namespace {

IntegerMatrix transposed(const IntegerMatrix& a) {
  IntegerMatrix result(a.columns(), a.rows());
  fmpz_mat_transpose(result.get(), a.get());
  return result;
}

IntegerMatrix product(const IntegerMatrix& a, const IntegerMatrix& b) {
  IntegerMatrix result(a.rows(), b.columns());
  fmpz_mat_mul(result.get(), a.get(), b.get());
  return result;
}

bool same_point(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  if (std::all_of(a.begin(), a.end(), [](const Rational& x) { return x.is_zero(); })) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(a[i] * b[j] == a[j] * b[i])) return false;
  return true;
}

class Inversion {
 public:
  Inversion(const RationalSurface& surface, const MatrixRepresentation& m, const std::vector<Rational>& point)
      : surface_(surface), rows_(surface.kind(), m), point_(point) {}

  /// Adds the parameters at which the row monomials are proportional to the vector, if the point is their image.
  void read(const IntegerMatrix& row) {
    std::vector<Rational> values;
    for (long i = 0; i < row.columns(); ++i) values.emplace_back(Integer(row.entry(0, i)));
    const auto nonzero =
        std::find_if(values.begin(), values.end(), [](const Rational& value) { return !value.is_zero(); });
    if (nonzero == values.end()) return;
    auto parameters = rows_.parameters(values, static_cast<std::size_t>(nonzero - values.begin()));
    if (!parameters || !same_point(image_of(surface_, *parameters), point_)) return;
    for (const std::vector<std::size_t>& group : rows_.groups()) {
      const auto last =
          std::find_if(group.rbegin(), group.rend(), [&](std::size_t k) { return !(*parameters)[k].is_zero(); });
      const Rational scale = (*parameters)[*last];
      for (const std::size_t k : group) (*parameters)[k] = (*parameters)[k] / scale;
    }
    found_.push_back(*std::move(parameters));
  }

  /// Several parameters: the values of one form of degree 1 in each group, divided by those of another, are the
  /// eigenvalues of the pencil of both multiplications on the kernel. Rows of `kernel` are a basis of it.
  void separate(const IntegerMatrix& kernel) {
    const std::vector<std::vector<std::size_t>> multiples = rows_.multiples();
    if (multiples.empty()) return;
    const IntegerMatrix above = multiplication(kernel, multiples, 1);
    const IntegerMatrix below = multiplication(kernel, multiples, 2);
    // Combinations of the columns make the pencil square; its determinant holds the eigenvalues.
    const long count = kernel.rows();
    IntegerMatrix combination(above.columns(), count);
    for (long i = 0; i < combination.rows(); ++i)
      for (long j = 0; j < count; ++j)
        fmpz_set_si(combination.entry(i, j), random(3, static_cast<std::uint64_t>(i * count + j)));
    const IntegerMatrix constant = product(above, combination);
    const IntegerMatrix linear = product(below, combination);
    PolynomialMatrix pencil(count, count);
    for (long i = 0; i < count; ++i)
      for (long j = 0; j < count; ++j)
        pencil.set_entry(i, j, UnivariatePolynomial({Integer(constant.entry(i, j)), -Integer(linear.entry(i, j))}));
    const UnivariatePolynomial eigenvalues = determinant(pencil);
    // A curve of parameters, or multiple ones.
    if (eigenvalues.is_zero()) return;
    for (const UnivariatePolynomial& factor : irreducible_factors(eigenvalues)) {
      if (factor.degree() != 1) continue;
      // The eigenvalue -c0 / c1: the left kernel of c1 above + c0 below.
      IntegerMatrix difference(above.rows(), above.columns());
      fmpz_mat_scalar_mul_fmpz(difference.get(), above.get(), factor.coefficient(1).get());
      fmpz_mat_scalar_addmul_fmpz(difference.get(), below.get(), factor.coefficient(0).get());
      const IntegerMatrix eigenvectors = nullspace(transposed(difference));
      if (eigenvectors.columns() == 1) read(product(transposed(eigenvectors), kernel));
    }
  }

  std::vector<std::vector<Rational>> parameters() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  static long random(std::uint64_t seed, std::uint64_t index) {
    return static_cast<long>(mix(seed, index) % 201) - 100;
  }

  /// kernel times the columns of the multiples of each lower monomial by a random form.
  static IntegerMatrix multiplication(const IntegerMatrix& kernel,
                                      const std::vector<std::vector<std::size_t>>& multiples, std::uint64_t seed) {
    IntegerMatrix result(kernel.rows(), static_cast<long>(multiples.size()));
    for (std::size_t j = 0; j < multiples.size(); ++j)
      for (std::size_t f = 0; f < multiples[j].size(); ++f)
        for (long i = 0; i < kernel.rows(); ++i)
          fmpz_addmul_si(result.entry(i, static_cast<long>(j)), kernel.entry(i, static_cast<long>(multiples[j][f])),
                         random(seed, f));
    return result;
  }

  const RationalSurface& surface_;
  RowMonomials rows_;
  const std::vector<Rational>& point_;
  std::vector<std::vector<Rational>> found_;
};

Rational power_of(const Rational& base, unsigned long exponent) {
  Rational result;
  fmpq_pow_si(result.get(), base.get(), static_cast<slong>(exponent));
  return result;
}

}  // namespace

RationalPreimages rational_preimages(const RationalSurface& surface, const MatrixRepresentation& m,
                                     const std::vector<Rational>& point) {
  if (point.size() != 4 || std::all_of(point.begin(), point.end(), [](const Rational& x) { return x.is_zero(); }))
    throw InvalidInput("the parameters of no point of space were asked for",
                       "four homogeneous coordinates, not all zero");
  const IntegerMatrix kernel = transposed(nullspace(transposed(value_at(m, point))));
  RationalPreimages result;
  result.kernel_dimension = kernel.rows();
  if (result.kernel_dimension == 0) return result;
  Inversion inversion(surface, m, point);
  if (result.kernel_dimension == 1)
    inversion.read(kernel);
  else
    inversion.separate(kernel);
  result.parameters = inversion.parameters();
  return result;
}

std::vector<Rational> image_of(const RationalSurface& surface, const std::vector<Rational>& parameters) {
  if (surface.kind() == RationalSurface::Kind::triangular) return surface.at(parameters);
  if (parameters.size() != 4)
    throw InvalidInput("a point of a tensor-product surface was asked for at " + std::to_string(parameters.size()) +
                           " homogeneous parameters",
                       "two pairs");
  std::vector<Rational> point;
  for (const Polynomial& f : surface.coordinates()) {
    Rational sum;
    for (const Polynomial::Term& term : f.terms()) {
      Rational value = term.coefficient;
      for (std::size_t k = 0; k < 2; ++k) {
        const auto degree = static_cast<unsigned long>(surface.bidegree()[k]);
        value = value * power_of(parameters[2 * k], term.exponents[k]) *
                power_of(parameters[2 * k + 1], degree - term.exponents[k]);
      }
      sum = sum + value;
    }
    point.push_back(sum);
  }
  return point;
}

}  // namespace eliminant::symbolic
