// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

std::uint64_t mix(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

// The start lies in the lower half of the interval, so that the sequence never leaves it.
PrimeSequence::PrimeSequence(std::uint64_t seed) : last_((1UL << 61U) + (mix(seed, 0) >> 4U)) {}

mp_limb_t PrimeSequence::next() {
  last_ = n_nextprime(last_, 0);
  return last_;
}

ModularPolynomial interpolate(const PrimeField& field, std::vector<mp_limb_t> points, std::vector<mp_limb_t> values) {
  ModularPolynomial result(field);
  nmod_poly_interpolate_nmod_vec(result.get(), points.data(), values.data(), static_cast<slong>(points.size()));
  return result;
}

std::vector<unsigned long> multiplicity_profile(const ModularPolynomial& p) {
  std::vector<unsigned long> profile;
  if (p.degree() < 1) return profile;
  nmod_poly_factor_t factors;
  nmod_poly_factor_init(factors);
  nmod_poly_factor_squarefree(factors, p.get());
  for (slong i = 0; i < factors->num; ++i) {
    const auto multiplicity = static_cast<std::size_t>(factors->exp[i]);
    profile.resize(std::max(profile.size(), multiplicity), 0);
    profile[multiplicity - 1] += static_cast<unsigned long>(nmod_poly_degree(factors->p + i));
  }
  nmod_poly_factor_clear(factors);
  return profile;
}

}  // namespace eliminant::symbolic
