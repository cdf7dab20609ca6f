// SPDX-License-Identifier: BSD-3-Clause
// Cylinders through five points:
//   bench_cylinders --benchmark_min_time=1
// "sets" is the number of sets of five points a second of CPU time, "exact" the share that needed exact arithmetic.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/cylinders/enclosed_cylinders.hpp>

namespace {

using namespace eliminant;
using Points = std::array<std::array<double, 3>, 5>;

/// Integers from -100 to 100: the sets of tests/data/cylinders/random_points.txt, by splitmix64.
std::vector<Points> integer_sets() {
  std::uint64_t state = 20050905;
  const auto next = [&state] {
    state += 0x9E3779B97F4A7C15;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  };
  std::vector<Points> sets(1000);
  for (Points& points : sets)
    for (auto& point : points)
      for (double& coordinate : point) coordinate = static_cast<double>(next() % 201) - 100;
  return sets;
}

std::vector<Points> gaussian_sets() {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> gaussian;
  std::vector<Points> sets(1000);
  for (Points& points : sets)
    for (auto& point : points)
      for (double& coordinate : point) coordinate = gaussian(generator);
  return sets;
}

/// Neighbouring points of a cylinder of radius 1 with 1 % of noise, in coordinates about 10: on a patch that is 1 long
/// and covers an angle of 1.
std::vector<Points> cloud_sets() {
  std::mt19937_64 generator(2);
  std::normal_distribution<double> gaussian;
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::vector<Points> sets(1000);
  for (Points& points : sets) {
    numeric::SpaceVector<double> t{gaussian(generator), gaussian(generator), gaussian(generator)};
    numeric::SpaceVector<double> across = numeric::cross_product(t, {gaussian(generator), gaussian(generator), 0.5});
    for (auto* v : {&t, &across}) {
      const double length = std::sqrt(numeric::dot_product(*v, *v));
      for (double& coordinate : *v) coordinate /= length;
    }
    const numeric::SpaceVector<double> other = numeric::cross_product(t, across);
    for (auto& point : points) {
      const double angle = uniform(generator);
      const double height = uniform(generator);
      const double radius = 1 + 0.01 * gaussian(generator);
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = 10 + radius * (std::cos(angle) * across[i] + std::sin(angle) * other[i]) + height * t[i];
    }
  }
  return sets;
}

void uncertified(benchmark::State& state, const std::vector<Points>& sets) {
  for (auto _ : state)
    for (const Points& points : sets) benchmark::DoNotOptimize(numeric::real_cylinders_through(points));
  state.counters["sets"] =
      benchmark::Counter(static_cast<double>(sets.size()), benchmark::Counter::kIsIterationInvariantRate);
}

void certified(benchmark::State& state, const std::vector<Points>& sets) {
  std::size_t exact = 0;
  for (auto _ : state) {
    exact = 0;
    for (const Points& points : sets) {
      const intersect::EnclosedCylinders result = intersect::enclosed_real_cylinders(points);
      if (result.status != intersect::Status::certified) state.SkipWithError("not certified");
      exact += result.exact ? 1 : 0;
      benchmark::DoNotOptimize(result);
    }
  }
  state.counters["sets"] =
      benchmark::Counter(static_cast<double>(sets.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["exact"] = static_cast<double>(exact) / static_cast<double>(sets.size());
}

/// All six complex ones of rational points, to 15 digits.
void complete(benchmark::State& state, const std::vector<Points>& sets) {
  std::vector<intersect::CylindersProblem> problems;
  for (const Points& points : sets) {
    intersect::CylindersProblem& problem = problems.emplace_back();
    for (std::size_t k = 0; k < 5; ++k)
      for (std::size_t i = 0; i < 3; ++i) problem.points[k][i] = symbolic::Rational(static_cast<long>(points[k][i]));
  }
  for (auto _ : state)
    for (const intersect::CylindersProblem& problem : problems)
      if (intersect::cylinders_through(problem, {}, Context()).status != intersect::Status::certified)
        state.SkipWithError("not certified");
  state.counters["sets"] =
      benchmark::Counter(static_cast<double>(sets.size()), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(uncertified, gaussian, gaussian_sets())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(certified, gaussian, gaussian_sets())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(certified, cloud, cloud_sets())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(certified, integers, integer_sets())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(complete, integers, integer_sets())->Unit(benchmark::kMillisecond);

}  // namespace
