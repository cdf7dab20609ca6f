// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/linear_relations.hpp>

#include <array>
#include <map>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

std::vector<std::vector<Integer>> linear_relations(const std::vector<Polynomial>& p) {
  std::map<std::vector<unsigned long>, long> rows;
  for (const Polynomial& one : p)
    for (const auto& term : one.terms()) rows.emplace(term.exponents, static_cast<long>(rows.size()));
  IntegerMatrix system(static_cast<long>(rows.size()), static_cast<long>(p.size()));
  for (std::size_t j = 0; j < p.size(); ++j)
    for (const auto& term : p[j].terms())
      fmpz_set(system.entry(rows.at(term.exponents), static_cast<long>(j)), term.coefficient.numerator().get());
  const IntegerMatrix kernel = nullspace(system);
  std::vector<std::vector<Integer>> result;
  for (long k = 0; k < kernel.columns(); ++k) {
    std::vector<Integer> vector;
    for (long i = 0; i < kernel.rows(); ++i) vector.emplace_back(kernel.entry(i, k));
    result.push_back(std::move(vector));
  }
  return result;
}

Polynomial linear_combination(const std::vector<Integer>& c, const std::vector<Polynomial>& p) {
  Polynomial sum(p.front().variable_count());
  for (std::size_t i = 0; i < p.size(); ++i) sum = sum + Rational(c[i]) * p[i];
  return sum;
}

std::vector<Polynomial> monomials_in_space(unsigned long degree) {
  std::vector<Polynomial> result;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j)
      for (unsigned long k = 0; i + j + k <= degree; ++k) {
        const std::array<Polynomial::Term, 1> term{{{Rational(1), {i, j, k, degree - i - j - k}}}};
        result.push_back(Polynomial::from_terms(4, term));
      }
  return result;
}

}  // namespace eliminant::symbolic
