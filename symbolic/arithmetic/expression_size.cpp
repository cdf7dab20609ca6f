// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/expression_size.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <string>

namespace eliminant::symbolic {

namespace {

constexpr std::uint64_t saturated = std::numeric_limits<std::uint64_t>::max();

// C(n, k), or the largest value where that would overflow.
std::uint64_t saturating_binomial(std::uint64_t n, std::uint64_t k) {
  std::uint64_t result = 1;
  for (std::uint64_t i = 1; i <= k; ++i) {
    const std::uint64_t numerator = saturating_product(result, n - k + i);
    if (numerator == saturated) return saturated;
    result = numerator / i;
  }
  return result;
}

std::uint64_t bits(const Integer& value) { return value.bit_length(); }

}  // namespace

std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) { return a > saturated - b ? saturated : a + b; }

std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > saturated / a ? saturated : a * b;
}

ExpressionSize SizeBounds::of_constant(const Rational& value) {
  ExpressionSize size;
  size.denominator = value.denominator();
  const std::uint64_t length = bits(value.numerator());
  size.coefficient_bits = length == 1 ? 0 : length;
  size.total_bits = std::max<std::uint64_t>(1, length);
  return size;
}

ExpressionSize SizeBounds::of_variable() {
  ExpressionSize size;
  size.degree = 1;
  return size;
}

ExpressionSize SizeBounds::of_sum(std::span<const ExpressionSize* const> addends) const {
  ExpressionSize size;
  std::uint64_t terms = 0;
  const Integer one(1);
  for (const ExpressionSize* addend : addends) {
    size.degree = std::max(size.degree, addend->degree);
    terms = saturating_sum(terms, addend->terms);
    if (addend->denominator == one || addend->denominator == size.denominator) continue;
    fmpz_lcm(size.denominator.get(), size.denominator.get(), addend->denominator.get());
    check_coefficient_bits(bits(size.denominator));
    // All numerators are scaled by the common denominator: stop before that alone is too large.
    if (saturating_product(terms, bits(size.denominator)) > limits_.total_bits()) break;
  }
  size.terms = std::min(std::max<std::uint64_t>(1, terms), monomials_up_to(size.degree));
  size.coefficient_bits = 0;
  size.total_bits = 0;
  for (const ExpressionSize* addend : addends) {
    const std::uint64_t scaling =
        addend->denominator == size.denominator ? 0 : bits(size.denominator) - bits(addend->denominator) + 1;
    size.coefficient_bits = std::max(size.coefficient_bits, saturating_sum(addend->coefficient_bits, scaling));
    size.total_bits =
        saturating_sum(size.total_bits, saturating_sum(addend->total_bits, saturating_product(addend->terms, scaling)));
  }
  size.coefficient_bits = saturating_sum(size.coefficient_bits, std::bit_width(addends.size() - 1));
  check(size);
  return size;
}

ExpressionSize SizeBounds::of_product(std::span<const ExpressionSize* const> factors) const {
  ExpressionSize size;
  for (const ExpressionSize* factor : factors) {
    size.degree = saturating_sum(size.degree, factor->degree);
    const std::uint64_t terms = std::min(saturating_product(size.terms, factor->terms), monomials_up_to(size.degree));
    size.coefficient_bits = saturating_sum(size.coefficient_bits, factor->coefficient_bits);
    // Each product of two terms adds their lengths; after like terms are added none is longer than the bound.
    size.total_bits = std::min(saturating_sum(saturating_product(size.terms, factor->total_bits),
                                              saturating_product(factor->terms, size.total_bits)),
                               saturating_product(terms, std::max<std::uint64_t>(1, size.coefficient_bits)));
    size.terms = terms;
    check_coefficient_bits(bits(size.denominator) + bits(factor->denominator));
    check(size);
    size.denominator = size.denominator * factor->denominator;
  }
  return size;
}

ExpressionSize SizeBounds::of_power(const ExpressionSize& base, std::uint64_t exponent) const {
  ExpressionSize size;
  if (exponent == 0) return size;
  size.degree = saturating_product(base.degree, exponent);
  size.coefficient_bits = saturating_product(base.coefficient_bits, exponent);
  const Integer one(1);
  if (!(base.denominator == one)) check_coefficient_bits(saturating_product(bits(base.denominator), exponent));
  // A sum of t terms to the k-th power has at most C(k + t - 1, t - 1) of them.
  const std::uint64_t smaller = std::min(exponent, base.terms - 1);
  const std::uint64_t multinomials = saturating_binomial(saturating_sum(exponent, base.terms - 1), smaller);
  // The degree is checked first: only then the number of monomials is cheap to bound.
  size.terms = 1;
  check(size);
  size.terms = std::min(multinomials, monomials_up_to(size.degree));
  size.total_bits = saturating_product(size.terms, std::max<std::uint64_t>(1, size.coefficient_bits));
  check(size);
  if (!(base.denominator == one)) size.denominator = power(base.denominator, exponent);
  return size;
}

std::uint64_t SizeBounds::monomials_up_to(std::uint64_t degree) const {
  return saturating_binomial(saturating_sum(degree, variable_count_), variable_count_);
}

void SizeBounds::check(const ExpressionSize& size) const {
  const auto refuse = [&](const std::string& what, std::uint64_t limit) {
    throw LimitReached("after expansion the polynomial would have " + what + ", the limit is " + std::to_string(limit));
  };
  const auto count = [](std::uint64_t value) {
    return value == saturated ? std::string("too large a") : std::to_string(value);
  };
  if (size.degree > limits_.degree)
    refuse(size.degree == saturated ? "too large a degree" : "degree " + std::to_string(size.degree), limits_.degree);
  if (size.terms > limits_.terms) refuse("up to " + count(size.terms) + " terms", limits_.terms);
  check_coefficient_bits(size.coefficient_bits);
  if (size.total_bits > limits_.total_bits())
    refuse("coefficients of more than " + std::to_string(limits_.total_digits) + " digits together",
           limits_.total_digits);
}

void SizeBounds::check_coefficient_bits(std::uint64_t bits) const {
  if (bits > limits_.coefficient_bits())
    throw LimitReached("after expansion a number would have more than " +
                       std::to_string(limits_.digits + limits_.decimal_exponent) + " digits, which is the limit");
}

}  // namespace eliminant::symbolic
