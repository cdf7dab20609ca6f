// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/representation_rank.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/modular_matrix.hpp>

namespace eliminant::symbolic {

namespace {

/// Of 60 bits, so that a polynomial that is not zero hardly ever vanishes.
Rational random_integer(std::uint64_t seed, std::uint64_t index) {
  return Rational(static_cast<long>(mix(seed, index) >> 4U));
}

long rank_modulo(const MatrixRepresentation& m, const std::vector<Rational>& point, std::uint64_t seed) {
  const PrimeField field(PrimeSequence(seed).next());
  ModularMatrix value(m.rows(), m.columns(), field);
  fmpz_mat_get_nmod_mat(value.get(), value_at(m, point).get());
  return nmod_mat_rank(value.get());
}

}  // namespace

IntegerMatrix value_at(const MatrixRepresentation& m, const std::vector<Rational>& point) {
  if (point.size() != m.coefficients.size())
    throw InvalidInput("a point has " + std::to_string(point.size()) + " homogeneous coordinates",
                       std::to_string(m.coefficients.size()) + " of them");
  Integer denominator(1);
  for (const Rational& coordinate : point)
    fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(coordinate.get()));
  IntegerMatrix value(m.rows(), m.columns());
  for (std::size_t k = 0; k < point.size(); ++k)
    fmpz_mat_scalar_addmul_fmpz(value.get(), m.coefficients[k].get(),
                                (point[k] * Rational(denominator)).numerator().get());
  return value;
}

long generic_rank_modulo(const MatrixRepresentation& m, std::uint64_t seed) {
  std::vector<Rational> point;
  for (std::size_t k = 0; k < m.coefficients.size(); ++k) point.push_back(random_integer(mix(seed, 50), k));
  return rank_modulo(m, point, seed);
}

long rank_on_modulo(const MatrixRepresentation& m, const RationalSurface& surface, std::uint64_t seed) {
  std::vector<Rational> parameters;
  for (std::size_t k = 0; k < surface.coordinates().front().variable_count(); ++k)
    parameters.push_back(random_integer(mix(seed, 51), k));
  return rank_modulo(m, surface.at(parameters), seed);
}

long rank_on_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed) {
  return rank_modulo(m, curve.at(random_integer(mix(seed, 52), 0)), seed);
}

}  // namespace eliminant::symbolic
