// SPDX-License-Identifier: BSD-3-Clause
//
// Two plane curves intersected, from the polynomials to the finished result, in process and with one thread:
//   scripts/bench.sh plane_curves [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>

#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/io/input/input_text.hpp>
#include <eliminant/io/input/problem_file.hpp>

#include "setup.hpp"

namespace {

using eliminant::intersect::Options;
using eliminant::intersect::PlaneCurvesProblem;
using eliminant::intersect::Result;

void solve(benchmark::State& state, const PlaneCurvesProblem& problem, const Options& options) {
  const eliminant::Context context;
  Result result;
  for (auto _ : state) {
    result = eliminant::intersect::intersect_plane_curves(problem, options, context);
    benchmark::DoNotOptimize(result);
  }
  state.counters["distinct"] = static_cast<double>(result.counts.distinct);
  state.counters["listed"] = static_cast<double>(result.counts.listed);
  state.counters["pencil"] = static_cast<double>(result.engine.pencil_size);
  state.counters["regular"] = static_cast<double>(result.engine.regular_size);
  state.counters["certified"] = result.status == eliminant::intersect::Status::certified ? 1 : 0;
  state.counters["peak_megabytes"] = eliminant::bench::peak_megabytes();
  state.SetLabel(result.engine.method);
}

/// A file of the folder examples with the options it asks for; `precision_bits` replaces its precision.
void example(benchmark::State& state, const std::string& name, int precision_bits) {
  namespace io = eliminant::io;
  const std::string path = std::string(ELIMINANT_EXAMPLES) + "/" + name + ".json";
  const io::ProblemFile file = io::read_problem(io::read_text(path), io::ProblemSyntax::json);
  io::RunOptions options;
  io::apply_options(options, file.options);
  options.solve.precision_bits = precision_bits;
  solve(state, std::get<PlaneCurvesProblem>(file.problem), options.solve);
}

void dense(benchmark::State& state) {
  const auto [p, q] = eliminant::bench::dense_pair(state.range(0));
  PlaneCurvesProblem problem;
  problem.p = p;
  problem.q = q;
  solve(state, problem, {});
}

constexpr int automatic = 0;

BENCHMARK_CAPTURE(example, paper_1, "paper_example_1", automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_2, "paper_example_2", automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_3, "paper_example_3", automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_4, "paper_example_4", automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_5, "paper_example_5", automatic)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_1_128_bits, "paper_example_1", 128)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(example, paper_4_128_bits, "paper_example_4", 128)->Unit(benchmark::kMillisecond);
BENCHMARK(dense)->DenseRange(5, 20, 5)->ArgName("degree")->Unit(benchmark::kMillisecond);

}  // namespace
