// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

/// What many tests need: polynomials from text and reproducible random ones.
namespace eliminant::test {

using symbolic::Polynomial;
using symbolic::Rational;

inline Polynomial curve(std::string_view text) {
  static const std::vector<std::string> names{"x", "y"};
  return symbolic::parse_polynomial(text, names);
}

inline std::string text(const Polynomial& p) {
  static const std::vector<std::string> names{"x", "y"};
  return symbolic::to_string(p, names);
}

/// splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }
  /// Uniform in [low, high].
  long between(long low, long high) {
    return low + static_cast<long>(next() % static_cast<std::uint64_t>(high - low + 1));
  }
  long nonzero(long size) {
    const long value = between(1, size);
    return next() % 2 == 0 ? value : -value;
  }

 private:
  std::uint64_t state_;
};

/// All coefficients of total degree <= degree, uniform in [-size, size].
inline Polynomial random_dense(Random& random, unsigned long degree, long size) {
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j) terms.push_back({Rational(random.between(-size, size)), {i, j}});
  return Polynomial::from_terms(2, terms);
}

/// p(a x + b y + c, d x + e y + f).
inline Polynomial substitute(const Polynomial& p, const Polynomial& x, const Polynomial& y) {
  const std::vector<Polynomial> images{x, y};
  return p.compose(images);
}

}  // namespace eliminant::test
