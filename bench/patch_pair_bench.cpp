// SPDX-License-Identifier: BSD-3-Clause
//
// Pairs of Bezier patches intersected, from the exact maps to the finished result, in process and with one thread, on
// the generated pairs of each family of the tests:
//   scripts/bench.sh patch_pair [--benchmark_filter=REGEX ...]
// `per_pair` is the mean; `median_ms` and `largest_ms` are processor times of single pairs in the last iteration.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <support/patch_families.hpp>
#include <support/patch_nets.hpp>
#include <support/self_patch_families.hpp>

#include "setup.hpp"

namespace {

using eliminant::intersect::SurfaceResult;
using eliminant::symbolic::SurfacePiece;

double processor_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Runs `solve` on each input and tells of times and proofs.
template <class Input, class Solve>
void run(benchmark::State& state, const std::vector<Input>& inputs, const Solve& solve) {
  std::vector<double> times;
  std::size_t components = 0;
  std::size_t certified = 0;
  for (auto _ : state) {
    times.clear();
    components = certified = 0;
    for (const Input& input : inputs) {
      const double start = processor_milliseconds();
      const SurfaceResult result = solve(input);
      times.push_back(processor_milliseconds() - start);
      components += result.components.size();
      if (result.status == eliminant::intersect::Status::certified) ++certified;
    }
  }
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(inputs.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["median_ms"] = times[times.size() / 2];
  state.counters["largest_ms"] = times.back();
  state.counters["pairs"] = static_cast<double>(inputs.size());
  state.counters["components"] = static_cast<double>(components);
  state.counters["certified"] = static_cast<double>(certified);
}

/// `tolerance` as in the options.
void pairs_within(benchmark::State& state, const std::vector<std::string>& families, double tolerance) {
  std::vector<std::pair<SurfacePiece, SurfacePiece>> inputs;
  for (const std::string& family : families)
    for (const auto& patches : eliminant::test::patch_cases(family))
      inputs.emplace_back(eliminant::test::surface_piece(patches.first),
                          eliminant::test::surface_piece(patches.second));
  eliminant::intersect::Options options;
  options.tolerance = tolerance;
  run(state, inputs, [&](const auto& input) {
    return eliminant::intersect::intersect_patches(input.first, input.second, options, eliminant::Context());
  });
}

void pairs(benchmark::State& state, const std::vector<std::string>& families) { pairs_within(state, families, 1e-6); }

void pairs_by_default(benchmark::State& state, const std::vector<std::string>& families) {
  pairs_within(state, families, eliminant::intersect::Options().tolerance);
}

void alone(benchmark::State& state, const std::vector<std::string>& families) {
  std::vector<SurfacePiece> inputs;
  for (const std::string& family : families)
    for (const auto& patch : eliminant::test::self_patch_cases(family))
      inputs.push_back(eliminant::test::surface_piece(patch.patches.first));
  run(state, inputs, [](const SurfacePiece& input) {
    eliminant::intersect::Options options;
    options.tolerance = 1e-6;
    return eliminant::intersect::intersect_patch_with_itself(input, options, eliminant::Context());
  });
}

using Families = std::vector<std::string>;

BENCHMARK_CAPTURE(pairs, random_bicubic, Families{"random bicubic"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, random_biquadratic, Families{"random biquadratic"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, random_rational_bicubic, Families{"random rational bicubic"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, branches_and_loops, Families{"branches and loops, degree 3", "branches and loops, degree 5"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, one_loop,
                  Families{"loop of diameter 1e-1", "loop of diameter 1e-2", "loop of diameter 1e-3",
                           "loop of diameter 1e-4"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs_by_default, bicubic, Families{"random bicubic"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, disjoint, Families{"gap of 1e-1", "gap of 1e-2", "gap of 1e-3", "gap of 1e-4", "gap of 1e-5"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, contact_in_a_point, Families{"contact in a point", "crossing contact"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, contact_along_a_curve, Families{"contact along a curve"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pairs, cusp, Families{"cusp"})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(alone, double_curves,
                  Families{"double curve from edge to edge", "double curve with pinch points", "closed double curve",
                           "triple point"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(alone, embedded,
                  Families{"embedded graph", "embedded fold", "embedded fold, cut before it closes",
                           "embedded, with two sheets"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
