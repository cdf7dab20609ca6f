// SPDX-License-Identifier: BSD-3-Clause
//
// The eliminant of two surfaces, and of one that meets itself, with one thread:
//   scripts/bench.sh bezoutian [--benchmark_filter=REGEX ...]
// Random dense polynomial (weight 1) and rational surfaces of bidegree (m, m), coefficients of so many bits and a sign.
#include <benchmark/benchmark.h>

#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_eliminant.hpp>
#include <eliminant/symbolic/matrices/bezoutian_matrix.hpp>

#include "setup.hpp"

namespace {

using namespace eliminant;

constexpr std::uint64_t seed = 0;

symbolic::RationalSurface dense_surface(test::Random& random, long degree, long bits, bool polynomial) {
  const auto d = static_cast<unsigned long>(degree);
  const long largest = (1L << bits) - 1;
  std::vector<symbolic::Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) {
    std::vector<symbolic::Polynomial::Term> terms;
    for (unsigned long i = 0; i <= d; ++i)
      for (unsigned long j = 0; j <= d; ++j)
        terms.push_back({symbolic::Rational(random.between(-largest, largest)), {i, j}});
    coordinates.push_back(k == 3 && polynomial ? symbolic::Polynomial::constant(2, 1)
                                               : symbolic::Polynomial::from_terms(2, terms));
  }
  return {symbolic::RationalSurface::Kind::tensor_product, std::move(coordinates)};
}

struct Pair {
  explicit Pair(const benchmark::State& state)
      : Pair(test::Random(static_cast<std::uint64_t>(state.range(0))), state) {}
  Pair(test::Random random, const benchmark::State& state)
      : first(dense_surface(random, state.range(0), state.range(1), state.range(2) == 0)),
        second(dense_surface(random, state.range(0), state.range(1), state.range(2) == 0)) {}
  symbolic::RationalSurface first;
  symbolic::RationalSurface second;
};

void count_terms(benchmark::State& state, const symbolic::Polynomial& d) {
  state.counters["degree_u"] = static_cast<double>(d.degree(0));
  state.counters["degree_t"] = static_cast<double>(d.degree(1));
  state.counters["terms"] = static_cast<double>(d.term_count());
  state.counters["peak_MB"] = bench::peak_megabytes();
}

void intersection_matrix(benchmark::State& state) {
  const Pair pair(state);
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::intersection_bezoutian_matrix(pair.first, pair.second));
}

void self_intersection_matrix(benchmark::State& state) {
  const Pair pair(state);
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::self_intersection_bezoutian_matrix(pair.first));
}

void intersection_determinant(benchmark::State& state) {
  const Pair pair(state);
  symbolic::Polynomial d(2);
  for (auto _ : state)
    d = symbolic::bezoutian_determinant(symbolic::SeparatedBezoutian(pair.first, pair.second), seed, Context());
  count_terms(state, d);
}

void self_intersection_determinant(benchmark::State& state) {
  const Pair pair(state);
  symbolic::Polynomial d(2);
  for (auto _ : state)
    d = symbolic::self_intersection_determinant(symbolic::SeparatedBezoutian(pair.first, pair.first), seed, Context());
  count_terms(state, d);
}

/// The determinant, its factors and what lies above them.
void intersection_eliminant(benchmark::State& state) {
  const Pair pair(state);
  symbolic::Polynomial curve(2);
  for (auto _ : state) curve = symbolic::intersection_eliminant(pair.first, pair.second, seed, Context()).curve;
  count_terms(state, curve);
}

void self_intersection_eliminant(benchmark::State& state) {
  const Pair pair(state);
  symbolic::Polynomial curve(2);
  for (auto _ : state) curve = symbolic::self_intersection_eliminant(pair.first, seed, Context()).curve;
  count_terms(state, curve);
}

void degrees_and_bits(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"degree", "bits", "rational"})->Unit(benchmark::kMillisecond);
  for (const long degree : {2, 3})
    for (const long bits : {4, 10, 50})
      for (const long rational : {0, 1}) benchmark->Args({degree, bits, rational});
}

BENCHMARK(intersection_matrix)->Apply(degrees_and_bits);
BENCHMARK(self_intersection_matrix)->Apply(degrees_and_bits);
BENCHMARK(intersection_determinant)->Apply(degrees_and_bits);
BENCHMARK(self_intersection_determinant)->Apply(degrees_and_bits);
BENCHMARK(intersection_eliminant)->Apply(degrees_and_bits);
BENCHMARK(self_intersection_eliminant)->Apply(degrees_and_bits);

}  // namespace
