// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>

namespace eliminant::symbolic {

namespace {

long small_random(std::uint64_t seed, std::uint64_t index, long bound) {
  return static_cast<long>(mix(seed, index) % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
}

/// M with its columns combined to as many as there are rows; M itself when it is square.
MatrixRepresentation square_combination(const MatrixRepresentation& m, std::uint64_t seed) {
  if (m.rows() == m.columns()) return m;
  constexpr long largest_factor = 3;
  IntegerMatrix combination(m.columns(), m.rows());
  for (long i = 0; i < m.columns(); ++i)
    for (long j = 0; j < m.rows(); ++j)
      fmpz_set_si(combination.entry(i, j),
                  small_random(seed, static_cast<std::uint64_t>(i * m.rows() + j), largest_factor));
  MatrixRepresentation result;
  result.row_monomials = m.row_monomials;
  for (const IntegerMatrix& coefficients : m.coefficients) {
    IntegerMatrix& product = result.coefficients.emplace_back(m.rows(), m.rows());
    fmpz_mat_mul(product.get(), coefficients.get(), combination.get());
  }
  return result;
}

/// det M(Psi(t)) modulo one prime, by its values at rows * degree + 1 points.
ModularPolynomial determinant_modulo(const MatrixRepresentation& m, const RationalCurve& curve,
                                     const PrimeField& field) {
  const long size = m.rows();
  std::vector<ModularMatrix> coefficients;
  std::vector<ModularPolynomial> coordinates;
  for (std::size_t k = 0; k < m.coefficients.size(); ++k) {
    fmpz_mat_get_nmod_mat(coefficients.emplace_back(size, size, field).get(), m.coefficients[k].get());
    fmpz_poly_get_nmod_poly(coordinates.emplace_back(field).get(), curve.coordinates()[k].get());
  }
  ModularMatrix value(size, size, field);
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  for (mp_limb_t t = 0; static_cast<long>(points.size()) <= size * curve.degree(); ++t) {
    nmod_mat_zero(value.get());
    for (std::size_t k = 0; k < coefficients.size(); ++k)
      nmod_mat_scalar_addmul_ui(value.get(), value.get(), coefficients[k].get(),
                                nmod_poly_evaluate_nmod(coordinates[k].get(), t));
    points.push_back(t);
    values.push_back(nmod_mat_det(value.get()));
  }
  return interpolate(field, std::move(points), std::move(values));
}

/// log2 of a bound of the coefficients of det M(Psi(t)): Hadamard's on |t| = 1, rows by their 1-norms.
unsigned long determinant_bits(const MatrixRepresentation& m, const RationalCurve& curve) {
  std::vector<Integer> norms;
  Integer magnitude;
  for (const UnivariatePolynomial& f : curve.coordinates()) {
    Integer norm;
    for (long i = 0; i <= f.degree(); ++i) {
      fmpz_abs(magnitude.get(), f.coefficient(i).get());
      norm = norm + magnitude;
    }
    norms.push_back(norm);
  }
  Integer bound(1);
  for (long i = 0; i < m.rows(); ++i) {
    Integer row;
    for (std::size_t k = 0; k < m.coefficients.size(); ++k)
      for (long j = 0; j < m.columns(); ++j) {
        fmpz_abs(magnitude.get(), m.coefficients[k].entry(i, j));
        fmpz_addmul(row.get(), magnitude.get(), norms[k].get());
      }
    bound = bound * row;
  }
  return bound.bit_length();
}

ParameterForm determinant_on_curve(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed,
                                   const Context& context) {
  const unsigned long bits_needed = determinant_bits(m, curve) + 2;
  PrimeSequence primes(seed);
  ParameterForm result;
  Integer modulus(1);
  for (unsigned long bits = 0; bits < bits_needed; bits += 61) {
    context.checkpoint("elimination");
    const PrimeField field(primes.next());
    const ModularPolynomial image = determinant_modulo(m, curve, field);
    if (bits == 0)
      fmpz_poly_set_nmod_poly(result.finite.get(), image.get());
    else
      fmpz_poly_CRT_ui(result.finite.get(), result.finite.get(), modulus.get(), image.get(), 1);
    fmpz_mul_ui(modulus.get(), modulus.get(), field.prime());
  }
  if (result.finite.is_zero()) return result;
  result.finite = result.finite.primitive_part();
  result.order_at_infinity = m.rows() * curve.degree() - result.finite.degree();
  return result;
}

/// A line through two points with small random integer coordinates.
RationalCurve random_line(std::uint64_t seed) {
  constexpr long largest_coordinate = 1000;
  std::vector<UnivariatePolynomial> coordinates;
  for (std::uint64_t k = 0; k < 4; ++k)
    coordinates.push_back(UnivariatePolynomial({Integer(small_random(seed, 2 * k, largest_coordinate)),
                                                Integer(small_random(seed, 2 * k + 1, largest_coordinate))}));
  return RationalCurve(coordinates);
}

/// A random combination of the coordinates of the surface, in two affine parameters after a random change of
/// coordinates that leaves nothing special at infinity.
Polynomial random_member(const RationalSurface& surface, std::uint64_t seed, std::uint64_t change) {
  constexpr long largest = 100;
  Polynomial member(surface.coordinates().front().variable_count());
  for (std::size_t k = 0; k < 4; ++k)
    member = member + Rational(small_random(seed, k, largest)) * surface.coordinates()[k];
  const auto linear = [&](std::uint64_t index, bool in_x, bool in_y) {
    Polynomial form = Polynomial::constant(2, Rational(small_random(change, 3 * index, largest)));
    if (in_x) form = form + Rational(small_random(change, 3 * index + 1, largest)) * Polynomial::variable(2, 0);
    if (in_y) form = form + Rational(small_random(change, 3 * index + 2, largest)) * Polynomial::variable(2, 1);
    return form;
  };
  if (surface.kind() == RationalSurface::Kind::triangular) {
    const std::vector<Polynomial> images{linear(0, true, true), linear(1, true, true), linear(2, true, true)};
    return member.compose(images);
  }
  const auto [m, n] = surface.bidegree();
  const std::vector<Polynomial> images{linear(0, true, false), linear(1, true, false), linear(2, false, true),
                                       linear(3, false, true)};
  Polynomial result(2);
  for (const Polynomial::Term& term : member.terms()) {
    Polynomial product = Polynomial::constant(2, term.coefficient);
    product = product * power(images[0], term.exponents[0]) *
              power(images[1], static_cast<unsigned long>(m) - term.exponents[0]) *
              power(images[2], term.exponents[1]) * power(images[3], static_cast<unsigned long>(n) - term.exponents[1]);
    result = result + product;
  }
  return result;
}

ModularPolynomial greatest_common_divisor(const ModularPolynomial& a, const ModularPolynomial& b,
                                          const PrimeField& field) {
  ModularPolynomial result(field);
  nmod_poly_gcd(result.get(), a.get(), b.get());
  return result;
}

ModularPolynomial minors_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed,
                                const PrimeField& field) {
  const ModularPolynomial first = determinant_modulo(square_combination(m, mix(seed, 1)), curve, field);
  if (m.rows() == m.columns()) return first;
  return greatest_common_divisor(first, determinant_modulo(square_combination(m, mix(seed, 2)), curve, field), field);
}

/// The matrices of a representation modulo a prime.
std::vector<ModularMatrix> reduce(const MatrixRepresentation& m, const PrimeField& field) {
  std::vector<ModularMatrix> result;
  for (const IntegerMatrix& coefficients : m.coefficients)
    fmpz_mat_get_nmod_mat(result.emplace_back(m.rows(), m.columns(), field).get(), coefficients.get());
  return result;
}

/// S^k(Psi(t)) / S^k(v) modulo a prime: at each t the constant term of the monic gcd of the minors on the line
/// Psi(t) + e v, which has degree `product` in e. nullopt when some line is special.
std::optional<ModularPolynomial> surface_on_curve_modulo(const MatrixRepresentation& m, long product,
                                                         const RationalCurve& curve, std::uint64_t seed,
                                                         const PrimeField& field) {
  const long size = m.rows();
  const std::array<std::vector<ModularMatrix>, 2> combinations{reduce(square_combination(m, mix(seed, 1)), field),
                                                               reduce(square_combination(m, mix(seed, 2)), field)};
  const std::size_t used = m.rows() == m.columns() ? 1 : 2;
  std::vector<ModularPolynomial> coordinates;
  for (const UnivariatePolynomial& f : curve.coordinates())
    fmpz_poly_get_nmod_poly(coordinates.emplace_back(field).get(), f.get());
  std::vector<mp_limb_t> direction;
  for (std::uint64_t k = 0; k < 4; ++k) direction.push_back(field.reduce(small_random(seed, 30 + k, 1000000)));
  std::vector<mp_limb_t> points;
  std::vector<mp_limb_t> values;
  ModularMatrix value(size, size, field);
  const mp_limb_t first_t = mix(seed, 40) >> 8U;
  for (mp_limb_t step = 0; static_cast<long>(points.size()) <= product * curve.degree(); ++step) {
    const mp_limb_t t = (first_t + step) % field.prime();
    std::vector<ModularPolynomial> on_line;
    for (std::size_t c = 0; c < used; ++c) {
      std::vector<mp_limb_t> line_points;
      std::vector<mp_limb_t> determinants;
      for (mp_limb_t e = 0; static_cast<long>(e) <= size; ++e) {
        nmod_mat_zero(value.get());
        for (std::size_t k = 0; k < 4; ++k)
          nmod_mat_scalar_addmul_ui(
              value.get(), value.get(), combinations[c][k].get(),
              field.add(nmod_poly_evaluate_nmod(coordinates[k].get(), t), field.multiply(e, direction[k])));
        line_points.push_back(e);
        determinants.push_back(nmod_mat_det(value.get()));
      }
      on_line.push_back(interpolate(field, std::move(line_points), std::move(determinants)));
    }
    ModularPolynomial common = on_line[0];
    if (used == 2) common = greatest_common_divisor(on_line[0], on_line[1], field);
    if (common.degree() != product) return std::nullopt;
    const mp_limb_t leading = nmod_poly_get_coeff_ui(common.get(), product);
    points.push_back(t);
    values.push_back(field.multiply(nmod_poly_get_coeff_ui(common.get(), 0), field.inverse(leading)));
  }
  return interpolate(field, std::move(points), std::move(values));
}

}  // namespace

ParameterForm minors_on_curve(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed,
                              const Context& context) {
  if (m.columns() < m.rows()) return {};
  ParameterForm first = determinant_on_curve(square_combination(m, mix(seed, 1)), curve, seed, context);
  if (m.rows() == m.columns()) return first;
  const ParameterForm second = determinant_on_curve(square_combination(m, mix(seed, 2)), curve, seed, context);
  if (first.finite.is_zero() || second.finite.is_zero()) return first.finite.is_zero() ? second : first;
  return {gcd(first.finite, second.finite), std::min(first.order_at_infinity, second.order_at_infinity)};
}

long minors_degree_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed) {
  if (m.columns() < m.rows()) return -1;
  return minors_modulo(m, curve, seed, PrimeField(PrimeSequence(seed).next())).degree();
}

ImplicitDegree implicit_degree(const RationalSurface& surface, const MatrixRepresentation& m, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(seed).next());
  ImplicitDegree result;
  if (m.columns() < m.rows()) throw InvalidInput("the matrix has fewer columns than rows", "a representation");
  const ModularPolynomial on_line = minors_modulo(m, random_line(mix(seed, 3)), seed, field);
  result.minors = on_line.degree();
  std::array<HiddenVariablePolynomial, 3> members;
  for (std::uint64_t k = 0; k < 3; ++k)
    members[k] = hide_variable(random_member(surface, mix(seed, 10 + k), mix(seed, 20)), 0);
  const auto first = resultant_modulo(members[0], members[1], field);
  const auto second = resultant_modulo(members[0], members[2], field);
  if (first && second && !first->is_zero() && !second->is_zero())
    result.product = first->degree() - greatest_common_divisor(*first, *second, field).degree();
  result.proven = result.product == result.minors;
  // The kernel at a general point is spanned by the row monomials at each of its parameters.
  result.map_degree = m.rows() - rank_on_modulo(m, surface, seed);
  return result;
}

std::optional<ParameterForm> surface_on_curve(const MatrixRepresentation& m, const ImplicitDegree& degree,
                                              const RationalCurve& curve, const ParameterForm& minors,
                                              std::uint64_t seed, const Context& context) {
  if (!degree.proven) return std::nullopt;
  const std::vector<UnivariatePolynomial> factors = irreducible_factors(minors.finite);
  PrimeSequence primes(mix(seed, 5));
  constexpr int attempts = 5;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    context.checkpoint("elimination");
    const PrimeField field(primes.next());
    const auto image = surface_on_curve_modulo(m, degree.product, curve, mix(seed, 6), field);
    if (!image) continue;
    ParameterForm result;
    result.finite = UnivariatePolynomial({Integer(1)});
    ModularPolynomial rest = *image;
    ModularPolynomial reduced(field);
    ModularPolynomial quotient(field);
    ModularPolynomial remainder(field);
    ModularPolynomial all(field);
    nmod_poly_one(all.get());
    for (const UnivariatePolynomial& factor : factors) {
      fmpz_poly_get_nmod_poly(reduced.get(), factor.get());
      nmod_poly_mul(all.get(), all.get(), reduced.get());
      while (true) {
        nmod_poly_divrem(quotient.get(), remainder.get(), rest.get(), reduced.get());
        if (!remainder.is_zero()) break;
        std::swap(rest, quotient);
        result.finite = result.finite * factor;
      }
    }
    // The factors keep their degrees and stay coprime and squarefree, and there are no others: then none can stand for
    // another one.
    const bool faithful = nmod_poly_is_squarefree(all.get()) != 0 && rest.degree() == 0 &&
                          all.degree() == std::accumulate(factors.begin(), factors.end(), 0L,
                                                          [](long sum, const UnivariatePolynomial& factor) {
                                                            return sum + factor.degree();
                                                          });
    if (!faithful) continue;
    result.order_at_infinity = degree.product * curve.degree() - result.finite.degree();
    return result;
  }
  return std::nullopt;
}

}  // namespace eliminant::symbolic
