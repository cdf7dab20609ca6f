// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <support/curves.hpp>
#include <support/patch_nets.hpp>

/// Random binary numbers, polynomials and nets for the generators of patches.
namespace eliminant::test {

inline Rational fraction(long numerator, long denominator) {
  return Rational(symbolic::Integer(numerator), symbolic::Integer(denominator));
}
inline Polynomial number(const Rational& value) { return Polynomial::constant(2, value); }
inline Polynomial u() { return Polynomial::variable(2, 0); }
inline Polynomial v() { return Polynomial::variable(2, 1); }

/// The multiple of 2^-bits nearest to a number.
inline Rational binary(double value, unsigned bits) {
  return Rational(symbolic::Integer(std::lround(std::ldexp(value, static_cast<int>(bits)))),
                  symbolic::power(symbolic::Integer(2), bits));
}

/// Random numbers in units of 1 / resolution.
struct PatchDrawing {
  Random& random;
  long resolution = 256;

  Rational between(double low, double high) {
    const auto units = [&](double value) { return std::lround(value * static_cast<double>(resolution)); };
    return fraction(random.between(units(low), units(high)), resolution);
  }
  Rational sign() { return random.between(0, 1) == 0 ? Rational(-1) : Rational(1); }
  /// An inner parameter, in eighths.
  Rational inner() { return fraction(random.between(2, 6), 8); }
  /// All terms up to a bidegree.
  Polynomial terms(unsigned long m, unsigned long n, double size) {
    std::vector<Polynomial::Term> list;
    for (unsigned long i = 0; i <= m; ++i)
      for (unsigned long j = 0; j <= n; ++j) list.push_back({between(-size, size), {i, j}});
    return Polynomial::from_terms(2, list);
  }
  /// Wavy over a square in the unit square: the ordinate moves by up to `height`.
  RationalNet wavy(std::size_t m, std::size_t n, const Rational& low, const Rational& width, double height) {
    RationalNet net(m + 1);
    const auto place = [&](std::size_t i, std::size_t count) {
      const long step = resolution * static_cast<long>(i) / static_cast<long>(count);
      return low + width * fraction(step, resolution) + between(-0.1, 0.1);
    };
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j <= n; ++j) {
        const Rational x = place(i, m);
        const Rational y = place(j, n);
        net[i].push_back({x, y, between(-height, height), Rational(1)});
      }
    return net;
  }
};

/// The identity with eighths beside the diagonal: dominated by it, so regular.
inline Projectivity mixing(Random& random) {
  Projectivity matrix;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      if (i < 3 && k < 3) matrix[i][k] = i == k ? Rational(1) : fraction(random.between(-3, 3), 8);
      if (i < 3 && k == 3) matrix[i][k] = fraction(random.between(-8, 8), 8);
    }
  matrix[3][3] = 1;
  return matrix;
}

/// To weights between 1 and 2 where x and y are not far from [0, 1].
inline Projectivity weighting(Random& random) {
  Projectivity matrix;
  for (std::size_t i = 0; i < 3; ++i) matrix[i][i] = 1;
  matrix[3] = {fraction(random.between(-1, 3), 8), fraction(random.between(0, 2), 8), 0, fraction(5, 4)};
  return matrix;
}

/// Seeds a family by its name, so that its numbers do not depend on other families.
inline Random family_random(const std::string& family) {
  std::uint64_t seed = 2026;
  for (const char letter : family) seed = 31 * seed + static_cast<unsigned char>(letter);
  return Random(seed);
}

}  // namespace eliminant::test
