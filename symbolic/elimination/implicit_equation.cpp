// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/implicit_equation.hpp>

#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>
#include <eliminant/symbolic/elimination/simplex_interpolation.hpp>
#include <eliminant/symbolic/elimination/vanishing.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>

namespace eliminant::symbolic {

namespace {

using Residues = std::vector<mp_limb_t>;

void require_moderate_degree(unsigned long variables, unsigned long degree) {
  // binomial(degree + variables - 1, variables - 1)
  Integer count;
  fmpz_bin_uiui(count.get(), degree + variables - 1, variables - 1);
  if (fmpz_cmp_ui(count.get(), most_equation_coefficients) > 0)
    throw LimitReached("an implicit equation of degree " + std::to_string(degree) + " has " + count.to_string() +
                       " coefficients, more than the " + std::to_string(most_equation_coefficients) +
                       " that are computed; the matrix represents the same without them");
}

std::vector<ModularMatrix> reduce(const MatrixRepresentation& m, const PrimeField& field) {
  std::vector<ModularMatrix> result;
  for (const IntegerMatrix& coefficients : m.coefficients)
    fmpz_mat_get_nmod_mat(result.emplace_back(m.rows(), m.columns(), field).get(), coefficients.get());
  return result;
}

void set_value(ModularMatrix& value, const std::vector<ModularMatrix>& coefficients, const Residues& point) {
  nmod_mat_zero(value.get());
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    nmod_mat_scalar_addmul_ui(value.get(), value.get(), coefficients[k].get(), point[k]);
}

/// The affine point origin + offset with last coordinate 1.
Residues lattice_point(const PrimeField& field, const Residues& origin, const std::vector<unsigned long>& offset) {
  Residues point;
  for (std::size_t k = 0; k < origin.size(); ++k) point.push_back(field.add(origin[k], offset[k]));
  point.push_back(1);
  return point;
}

Residues random_residues(const PrimeField& field, std::size_t count, std::uint64_t seed) {
  Residues result;
  for (std::size_t k = 0; k < count; ++k) result.push_back((mix(seed, k) >> 2U) % field.prime());
  return result;
}

/// The combination of the columns with random factors, as many as there are rows.
std::vector<ModularMatrix> random_square(const std::vector<ModularMatrix>& coefficients, const PrimeField& field,
                                         std::uint64_t seed) {
  const long rows = nmod_mat_nrows(coefficients.front().get());
  const long columns = nmod_mat_ncols(coefficients.front().get());
  ModularMatrix factors(columns, rows, field);
  for (long i = 0; i < columns; ++i)
    for (long j = 0; j < rows; ++j)
      factors(i, j) = (mix(seed, static_cast<std::uint64_t>(i * rows + j)) >> 2U) % field.prime();
  std::vector<ModularMatrix> result;
  for (const ModularMatrix& matrix : coefficients)
    nmod_mat_mul(result.emplace_back(rows, rows, field).get(), matrix.get(), factors.get());
  return result;
}

/// det(M(P) + e M(v)) / det M(v) as a polynomial in e, for any number of points P and one v.
class LineMinor {
 public:
  /// nullopt when det M(v) is 0.
  static std::optional<LineMinor> in_direction(std::vector<ModularMatrix> square, const Residues& v,
                                               const PrimeField& field) {
    const long size = nmod_mat_nrows(square.front().get());
    ModularMatrix at_v(size, size, field);
    set_value(at_v, square, v);
    if (nmod_mat_inv(at_v.get(), at_v.get()) == 0) return std::nullopt;
    // det(M(P) + e M(v)) = det M(v) det(e + M(v)^-1 M(P))
    nmod_mat_neg(at_v.get(), at_v.get());
    for (ModularMatrix& matrix : square) nmod_mat_mul(matrix.get(), at_v.get(), matrix.get());
    return LineMinor(std::move(square), field);
  }

  ModularPolynomial at(const Residues& point) {
    set_value(value_, pencil_, point);
    ModularPolynomial result(field_);
    nmod_mat_charpoly(result.get(), value_.get());
    return result;
  }

 private:
  LineMinor(std::vector<ModularMatrix> pencil, const PrimeField& field)
      : field_(field),
        pencil_(std::move(pencil)),
        value_(nmod_mat_nrows(pencil_.front().get()), nmod_mat_nrows(pencil_.front().get()), field) {}

  PrimeField field_;
  std::vector<ModularMatrix> pencil_;
  ModularMatrix value_;
};

/// The coefficients of det M(x, ..., 1) modulo a prime, M square.
Residues determinant_modulo(const MatrixRepresentation& m, const PrimeField& field, std::uint64_t seed) {
  const std::vector<ModularMatrix> coefficients = reduce(m, field);
  const auto degree = static_cast<unsigned long>(m.rows());
  const Residues origin = random_residues(field, coefficients.size() - 1, seed);
  ModularMatrix value(m.rows(), m.rows(), field);
  Residues values;
  for (const auto& offset : simplex_lattice(origin.size(), degree)) {
    set_value(value, coefficients, lattice_point(field, origin, offset));
    values.push_back(nmod_mat_det(value.get()));
  }
  return interpolate_on_simplex(field, origin, degree, values);
}

/// The same, up to a factor, of the gcd of two combinations of maximal minors, which has this degree; nullopt when some
/// line is special.
std::optional<Residues> minors_gcd_modulo(const MatrixRepresentation& m, unsigned long degree, const PrimeField& field,
                                          std::uint64_t seed) {
  const std::vector<ModularMatrix> coefficients = reduce(m, field);
  const Residues origin = random_residues(field, coefficients.size() - 1, mix(seed, 0));
  const Residues direction = random_residues(field, coefficients.size(), mix(seed, 1));
  auto first = LineMinor::in_direction(random_square(coefficients, field, mix(seed, 2)), direction, field);
  auto second = LineMinor::in_direction(random_square(coefficients, field, mix(seed, 3)), direction, field);
  if (!first || !second) return std::nullopt;
  Residues values;
  ModularPolynomial common(field);
  for (const auto& offset : simplex_lattice(origin.size(), degree)) {
    const Residues point = lattice_point(field, origin, offset);
    nmod_poly_gcd(common.get(), first->at(point).get(), second->at(point).get());
    if (common.degree() != static_cast<long>(degree)) return std::nullopt;
    values.push_back(nmod_poly_get_coeff_ui(common.get(), 0));
  }
  return interpolate_on_simplex(field, origin, degree, values);
}

/// The form of this degree with coefficients in the order of simplex_lattice of its affine variables.
Polynomial form_of(const std::vector<Rational>& coefficients, std::size_t variables, unsigned long degree) {
  const auto lattice = simplex_lattice(variables - 1, degree);
  std::vector<Polynomial::Term> terms;
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (coefficients[i].is_zero()) continue;
    std::vector<unsigned long> exponents = lattice[i];
    exponents.push_back(degree - std::accumulate(exponents.begin(), exponents.end(), 0UL));
    terms.push_back({coefficients[i], exponents});
  }
  return Polynomial::from_terms(variables, terms).primitive_part();
}

/// Coefficients known modulo more and more primes, up to one factor for all of them.
class Reconstruction {
 public:
  void add(Residues image, const PrimeField& field) {
    if (pivot_ == none) {
      while (++pivot_ < image.size() && image[pivot_] == 0) {
      }
      if (pivot_ == image.size()) {
        pivot_ = none;
        return;
      }
      residues_.assign(image.size(), Integer(0));
    }
    // The factor that makes one coefficient 1.
    if (image[pivot_] == 0) return;
    const mp_limb_t factor = field.inverse(image[pivot_]);
    for (std::size_t i = 0; i < image.size(); ++i) {
      image[i] = field.multiply(image[i], factor);
      fmpz_CRT_ui(residues_[i].get(), residues_[i].get(), modulus_.get(), image[i], field.prime(), 0);
    }
    fmpz_mul_ui(modulus_.get(), modulus_.get(), field.prime());
  }

  std::optional<std::vector<Rational>> rational() const {
    std::vector<Rational> result(residues_.size());
    if (residues_.empty()) return std::nullopt;
    for (std::size_t i = 0; i < residues_.size(); ++i)
      if (fmpq_reconstruct_fmpz(result[i].get(), residues_[i].get(), modulus_.get()) == 0) return std::nullopt;
    return result;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t pivot_ = none;
  Integer modulus_{1};
  std::vector<Integer> residues_;
};

using Vanishes = std::function<bool(const Polynomial&)>;

/// Whether the form is irreducible because it is so on a line; else nothing is known.
bool is_irreducible_on_a_line(const Polynomial& form, std::uint64_t seed) {
  constexpr std::uint64_t lines = 4;
  for (std::uint64_t line = 0; line < lines; ++line) {
    std::vector<Polynomial> images;
    for (std::size_t k = 0; k < form.variable_count(); ++k) {
      const auto small = [&](std::uint64_t index) {
        return Rational(static_cast<long>(mix(seed, 8 * line + index) % 21) - 10);
      };
      images.push_back(Polynomial::constant(1, small(2 * k)) + small(2 * k + 1) * Polynomial::variable(1, 0));
    }
    const Polynomial restricted = form.compose(images);
    if (restricted.total_degree() != form.total_degree()) continue;
    std::vector<Integer> coefficients(static_cast<std::size_t>(restricted.total_degree() + 1));
    for (const Polynomial::Term& term : restricted.primitive_part().terms())
      coefficients[term.exponents[0]] = term.coefficient.numerator();
    const std::vector<UnivariatePolynomial> factors = irreducible_factors(UnivariatePolynomial(coefficients));
    if (factors.size() == 1 && factors.front().degree() == form.total_degree()) return true;
  }
  return false;
}

/// The irreducible factor of the form that vanishes on the map, where the form itself does.
Polynomial irreducible_part(const Polynomial& form, std::uint64_t seed, const Vanishes& vanishes) {
  if (is_irreducible_on_a_line(form, seed)) return form;
  std::vector<Polynomial> factors = irreducible_factors(form);
  if (factors.size() == 1) return factors.front();
  for (Polynomial& factor : factors)
    if (vanishes(factor)) return std::move(factor);
  throw InvalidInput("no factor of the minors vanishes on the map", "a matrix representation of it");
}

/// The irreducible form that vanishes, a factor of the form of this degree whose coefficients modulo primes, up to a
/// factor, `image` gives.
Polynomial irreducible_form(std::size_t variables, unsigned long degree, std::uint64_t seed, const Context& context,
                            const std::function<std::optional<Residues>(const PrimeField&, std::uint64_t)>& image,
                            const Vanishes& vanishes) {
  PrimeSequence primes(mix(seed, 60));
  Reconstruction reconstruction;
  long failures = 0;
  for (std::uint64_t step = 0;; ++step) {
    context.checkpoint("implicit equation");
    const PrimeField field(primes.next());
    std::optional<Residues> residues = image(field, mix(seed, 61 + step));
    if (!residues) {
      constexpr long most_failures = 20;
      if (++failures > most_failures)
        throw InvalidInput("the minors of the matrix have no common factor of degree " + std::to_string(degree),
                           "a matrix representation");
      continue;
    }
    reconstruction.add(*std::move(residues), field);
    const std::optional<std::vector<Rational>> coefficients = reconstruction.rational();
    if (!coefficients) continue;
    const Polynomial form = form_of(*coefficients, variables, degree);
    if (vanishes(form)) return irreducible_part(form, seed, vanishes);
  }
}

}  // namespace

Polynomial implicit_equation(const RationalCurve& curve, std::uint64_t seed, const Context& context) {
  if (curve.dimension() != 2)
    throw InvalidInput("the implicit equation of a space curve was asked for, which has no single one",
                       "a plane curve");
  if (curve.degree() < 1) throw InvalidInput("the implicit equation of a point was asked for", "a curve");
  const auto degree = static_cast<unsigned long>(curve.degree());
  require_moderate_degree(3, degree);
  const MatrixRepresentation m = moving_line_matrix(curve, curve.degree() - 1);
  return irreducible_form(
      3, degree, seed, context,
      [&](const PrimeField& field, std::uint64_t own) { return determinant_modulo(m, field, own); },
      [&](const Polynomial& form) { return vanishes_on(form, curve, context); });
}

Polynomial implicit_equation(const RationalSurface& surface, const MatrixRepresentation& m,
                             const ImplicitDegree& degree, std::uint64_t seed, const Context& context) {
  if (degree.minors < 1 || m.columns() < m.rows())
    throw InvalidInput("the rank of the matrix does not drop on a surface", "a matrix representation");
  const auto minors = static_cast<unsigned long>(degree.minors);
  require_moderate_degree(4, minors);
  return irreducible_form(
      4, minors, seed, context,
      [&](const PrimeField& field, std::uint64_t own) -> std::optional<Residues> {
        if (m.rows() == m.columns()) return determinant_modulo(m, field, own);
        return minors_gcd_modulo(m, minors, field, own);
      },
      [&](const Polynomial& form) { return vanishes_on(form, surface, context); });
}

}  // namespace eliminant::symbolic
