// SPDX-License-Identifier: BSD-3-Clause
//
// Curves and patches intersected, from the exact maps to the finished result, in process and with one thread, on 50
// random pairs of each family:
//   scripts/bench.sh curve_surface [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>

#include <eliminant/intersect/curve_surface/bezier_intersection.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/curves.hpp>

namespace {

using eliminant::intersect::CurveResult;
using eliminant::intersect::CurveSurfaceProblem;
using eliminant::intersect::Engine;
using eliminant::intersect::Options;
using eliminant::symbolic::ControlPoint;
using eliminant::symbolic::Rational;
using eliminant::test::Random;

struct Family {
  std::size_t curve_degree;
  std::size_t patch_degree;
  bool rational;
};

/// Control points with ten binary digits: a curve across a wavy patch over the unit square.
CurveSurfaceProblem random_pair(Random& random, const Family& family) {
  const auto number = [&](long low, long high) { return Rational(random.between(low, high)) / Rational(1024); };
  const auto weighted = [&](ControlPoint point) {
    const Rational weight = family.rational ? Rational(random.between(8, 32)) / Rational(16) : Rational(1);
    for (Rational& coordinate : point) coordinate = coordinate * weight;
    point.push_back(weight);
    return point;
  };
  std::vector<ControlPoint> curve;
  for (std::size_t i = 0; i <= family.curve_degree; ++i)
    curve.push_back(weighted({number(0, 1024), number(0, 1024), number(-900, 900)}));
  const auto step = static_cast<long>(1024 / family.patch_degree);
  std::vector<std::vector<ControlPoint>> rows(family.patch_degree + 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j)
      rows[i].push_back(
          weighted({Rational(step * static_cast<long>(i)) / Rational(1024) + number(-100, 100),
                    Rational(step * static_cast<long>(j)) / Rational(1024) + number(-100, 100), number(-600, 600)}));
  CurveSurfaceProblem problem;
  problem.curve.pieces.push_back(eliminant::symbolic::bezier_curve(curve));
  problem.surface = eliminant::symbolic::ParametricSurface{{eliminant::symbolic::bezier_patch(rows)}};
  return problem;
}

void solve(benchmark::State& state, const Family& family, Engine engine, std::size_t pairs) {
  Random random(2026);
  std::vector<CurveSurfaceProblem> problems;
  for (std::size_t i = 0; i < pairs; ++i) problems.push_back(random_pair(random, family));
  Options options;
  options.engine = engine;
  if (engine == Engine::pencil) options.field = eliminant::intersect::Field::complex;
  const eliminant::Context context;
  std::size_t listed = 0;
  std::size_t certified = 0;
  for (auto _ : state) {
    listed = certified = 0;
    for (const CurveSurfaceProblem& problem : problems) {
      const CurveResult result = eliminant::intersect::intersect_curve_surface(problem, options, context);
      listed += result.solutions.size();
      if (result.status == eliminant::intersect::Status::certified) ++certified;
    }
  }
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["solutions"] = static_cast<double>(listed);
  state.counters["certified"] = static_cast<double>(certified);
}

/// The same pairs as control points in doubles, the patch prepared.
void solve_doubles(benchmark::State& state, const Family& family) {
  using eliminant::bridge::HomogeneousPoint;
  using eliminant::intersect::BezierCurve;
  using eliminant::intersect::BezierIntersector;
  using eliminant::intersect::BezierPatch;
  constexpr std::size_t pairs = 200;
  Random random(2026);
  const auto number = [&](long low, long high) { return static_cast<double>(random.between(low, high)) / 1024; };
  const auto weighted = [&](double x, double y, double z) {
    const double w = family.rational ? static_cast<double>(random.between(8, 32)) / 16 : 1;
    return HomogeneousPoint{w * x, w * y, w * z, w};
  };
  std::vector<BezierCurve> curves;
  std::vector<BezierIntersector> patches;
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    BezierCurve& curve = curves.emplace_back();
    for (std::size_t i = 0; i <= family.curve_degree; ++i)
      curve.points.push_back(weighted(number(0, 1024), number(0, 1024), number(-900, 900)));
    BezierPatch patch{{family.patch_degree, family.patch_degree}, {}};
    const double step = 1 / static_cast<double>(family.patch_degree);
    for (std::size_t i = 0; i <= family.patch_degree; ++i)
      for (std::size_t j = 0; j <= family.patch_degree; ++j)
        patch.points.push_back(weighted(step * static_cast<double>(i) + number(-100, 100),
                                        step * static_cast<double>(j) + number(-100, 100), number(-600, 600)));
    patches.emplace_back(std::move(patch));
  }
  std::size_t listed = 0;
  std::size_t certified = 0;
  for (auto _ : state) {
    listed = certified = 0;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      const auto result = patches[pair].intersect(curves[pair]);
      listed += result.points.size();
      if (result.status == eliminant::intersect::Status::certified) ++certified;
    }
  }
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(pairs), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["solutions"] = static_cast<double>(listed);
  state.counters["certified"] = static_cast<double>(certified);
}

BENCHMARK_CAPTURE(solve_doubles, line_bicubic, {1, 3, false})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve_doubles, cubic_bicubic, {3, 3, false})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve_doubles, rational_cubic_bicubic, {3, 3, true})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve_doubles, degree_8_biquintic, {8, 5, false})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, box_line_bicubic, {1, 3, false}, Engine::box, 50)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, box_cubic_bicubic, {3, 3, false}, Engine::box, 50)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, box_rational_cubic_bicubic, {3, 3, true}, Engine::box, 50)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, box_degree_8_biquintic, {8, 5, false}, Engine::box, 50)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, pencil_line_bicubic, {1, 3, false}, Engine::pencil, 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, pencil_cubic_bicubic, {3, 3, false}, Engine::pencil, 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, exact_line_bicubic, {1, 3, false}, Engine::exact, 10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, exact_cubic_bicubic, {3, 3, false}, Engine::exact, 10)->Unit(benchmark::kMillisecond);

}  // namespace
