// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// The field of integers modulo a prime below 2^62.
class PrimeField {
 public:
  explicit PrimeField(mp_limb_t prime) { nmod_init(&modulus_, prime); }
  mp_limb_t prime() const { return modulus_.n; }
  nmod_t modulus() const { return modulus_; }
  mp_limb_t add(mp_limb_t a, mp_limb_t b) const { return nmod_add(a, b, modulus_); }
  mp_limb_t subtract(mp_limb_t a, mp_limb_t b) const { return nmod_sub(a, b, modulus_); }
  mp_limb_t multiply(mp_limb_t a, mp_limb_t b) const { return nmod_mul(a, b, modulus_); }
  mp_limb_t negate(mp_limb_t a) const { return nmod_neg(a, modulus_); }
  mp_limb_t inverse(mp_limb_t a) const { return nmod_inv(a, modulus_); }
  mp_limb_t power(mp_limb_t a, unsigned long exponent) const { return nmod_pow_ui(a, exponent, modulus_); }
  mp_limb_t reduce(const Integer& a) const { return fmpz_fdiv_ui(a.get(), modulus_.n); }
  mp_limb_t reduce(long a) const {
    return a >= 0 ? static_cast<mp_limb_t>(a) % modulus_.n
                  : nmod_neg(static_cast<mp_limb_t>(-a) % modulus_.n, modulus_);
  }

 private:
  nmod_t modulus_;
};

/// An endless increasing sequence of different primes between 2^61 and 2^62, fixed by the seed.
class PrimeSequence {
 public:
  explicit PrimeSequence(std::uint64_t seed);
  mp_limb_t next();

 private:
  mp_limb_t last_;
};

/// A number that looks random, fixed by its arguments (splitmix64).
std::uint64_t mix(std::uint64_t seed, std::uint64_t index);

/// A polynomial over a prime field: RAII around FLINT's type.
class ModularPolynomial {
 public:
  explicit ModularPolynomial(const PrimeField& field) { nmod_poly_init(value_, field.prime()); }
  ModularPolynomial(const ModularPolynomial& other) {
    nmod_poly_init(value_, other.value_->mod.n);
    nmod_poly_set(value_, other.value_);
  }
  ModularPolynomial(ModularPolynomial&& other) noexcept {
    nmod_poly_init(value_, other.value_->mod.n);
    nmod_poly_swap(value_, other.value_);
  }
  ModularPolynomial& operator=(ModularPolynomial other) noexcept {
    nmod_poly_swap(value_, other.value_);
    return *this;
  }
  ~ModularPolynomial() { nmod_poly_clear(value_); }
  nmod_poly_struct* get() { return value_; }
  const nmod_poly_struct* get() const { return value_; }
  long degree() const { return nmod_poly_degree(value_); }
  bool is_zero() const { return nmod_poly_is_zero(value_) != 0; }

 private:
  nmod_poly_t value_;
};

/// Interpolates the polynomial of degree < points.size() with the given values.
ModularPolynomial interpolate(const PrimeField& field, std::vector<mp_limb_t> points, std::vector<mp_limb_t> values);

/// The number of distinct roots of each multiplicity k of a non-zero polynomial, in an algebraic closure: entry k - 1.
/// The characteristic must exceed the degree.
std::vector<unsigned long> multiplicity_profile(const ModularPolynomial& p);

}  // namespace eliminant::symbolic
