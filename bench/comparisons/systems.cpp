// SPDX-License-Identifier: BSD-3-Clause
#include "systems.hpp"

#include <cstdint>
#include <utility>

#include <eliminant/io/input/input_text.hpp>
#include <eliminant/io/input/problem_file.hpp>

#include "../setup.hpp"  // which also gives LAPACK one thread

namespace eliminant::comparisons {

namespace {

using symbolic::Integer;
using symbolic::Polynomial;
using symbolic::Rational;

std::vector<Term> plain(const Polynomial& p) {
  std::vector<Term> terms;
  for (const auto& term : p.primitive_part().terms())
    terms.push_back({term.coefficient.numerator().to_string(), term.exponents[0], term.exponents[1]});
  return terms;
}

System system(std::string name, const Polynomial& p, const Polynomial& q) {
  return {std::move(name), {plain(p), plain(q)}};
}

System dense(long degree) {
  const bench::CurvePair pair = bench::dense_pair(degree);
  System dense = system("dense, degree " + std::to_string(degree), pair.p, pair.q);
  dense.dense_degree = degree;
  return dense;
}

/// A dense polynomial of coefficients uniform in (-2^100, 2^100).
Polynomial dense_of_100_bits(test::Random& random, unsigned long degree) {
  constexpr long half = 1L << 50U;
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j) {
      const Integer size = Integer(random.between(0, half - 1)) * Integer(half) + Integer(random.between(0, half - 1));
      terms.push_back({random.next() % 2 == 0 ? size : -size, {i, j}});
    }
  return Polynomial::from_terms(2, terms);
}

System dense_of_100_bits(long degree) {
  test::Random random(static_cast<std::uint64_t>(degree));
  const Polynomial p = dense_of_100_bits(random, static_cast<unsigned long>(degree));
  const Polynomial q = dense_of_100_bits(random, static_cast<unsigned long>(degree));
  return system("dense, degree " + std::to_string(degree) + ", 100 bits", p, q);
}

System example(int number) {
  const std::string path = std::string(ELIMINANT_EXAMPLES) + "/paper_example_" + std::to_string(number) + ".json";
  const io::ProblemFile file = io::read_problem(io::read_text(path), io::ProblemSyntax::json);
  const auto& problem = std::get<intersect::PlaneCurvesProblem>(file.problem);
  return system("paper, example " + std::to_string(number), problem.p, problem.q);
}

/// T_degree(t).
Polynomial chebyshev(int degree, const Polynomial& t) {
  Polynomial previous = Polynomial::constant(2, 1);
  Polynomial current = t;
  for (int k = 1; k < degree; ++k) {
    Polynomial next = Rational(2) * (t * current) - previous;
    previous = std::exchange(current, std::move(next));
  }
  return current;
}

/// (t - 1) ... (t - degree).
Polynomial wilkinson(int degree, const Polynomial& t) {
  Polynomial product = Polynomial::constant(2, 1);
  for (int root = 1; root <= degree; ++root) product = product * (t - Polynomial::constant(2, root));
  return product;
}

}  // namespace

std::vector<System> systems() {
  std::vector<System> all;
  for (const long degree : {5, 10, 20, 30}) all.push_back(dense(degree));
  all.push_back(dense_of_100_bits(10));
  for (const int number : {1, 2, 3, 4, 5}) all.push_back(example(number));

  constexpr int chebyshev_degree = 12;
  constexpr int wilkinson_degree = 10;
  const Polynomial x = Polynomial::variable(2, 0);
  const Polynomial y = Polynomial::variable(2, 1);
  const Polynomial u = x + y;
  const Polynomial v = x - Rational(2) * y;
  all.push_back(system("T_12(x), T_12(y)", chebyshev(chebyshev_degree, x), chebyshev(chebyshev_degree, y)));
  all.push_back(system("Wilkinson 10 x 10", wilkinson(wilkinson_degree, x), wilkinson(wilkinson_degree, y)));
  all.push_back(system("T_12 grid, sheared", chebyshev(chebyshev_degree, u), chebyshev(chebyshev_degree, v)));
  all.push_back(system("Wilkinson grid, sheared", wilkinson(wilkinson_degree, u), wilkinson(wilkinson_degree, v)));
  return all;
}

}  // namespace eliminant::comparisons
