// SPDX-License-Identifier: BSD-3-Clause
// Cylinders in point clouds:
//   bench_cylinder_extraction --benchmark_min_time=1
// "points" is the number of points a second of CPU time, "samples" that of five-point samples drawn for the scene.
#include <benchmark/benchmark.h>

#include <eliminant/intersect/cylinders/cylinder_extraction.hpp>
#include <support/pipe_scenes.hpp>
#include <support/surface_scenes.hpp>

namespace {

using namespace eliminant;

void extract(benchmark::State& state, const test::PipeScene& scene) {
  intersect::CylinderExtractionProblem problem;
  problem.points = scene.points;
  problem.distance = scene.distance;
  intersect::CylinderExtractionResult result;
  for (auto _ : state) {
    result = intersect::extract_cylinders(problem, {}, Context());
    benchmark::DoNotOptimize(result.cylinders.data());
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(scene.points.size()), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["samples"] = static_cast<double>(result.counts.samples);
  state.counters["cylinders"] = static_cast<double>(result.counts.cylinders);
}

// Five pipes among 30 % of outliers.
void pipes(benchmark::State& state) {
  test::SceneRecipe recipe;
  recipe.points = 20000;
  extract(state, test::pipe_scene(recipe));
}

// Pipes alone need few samples; planes keep the search going until it is sure.
void box(benchmark::State& state) { extract(state, test::decoy_scenes().front()); }

void junction(benchmark::State& state) { extract(state, test::touching_scenes().front()); }

BENCHMARK(pipes)->Unit(benchmark::kMillisecond);
BENCHMARK(junction)->Unit(benchmark::kMillisecond);
BENCHMARK(box)->Unit(benchmark::kMillisecond);

}  // namespace
