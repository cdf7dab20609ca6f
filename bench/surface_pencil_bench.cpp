// SPDX-License-Identifier: BSD-3-Clause
//
// The pencil of a curve against a matrix representation, in doubles, in process:
//   scripts/bench.sh surface_pencil [--lines N] [--threads N] [--compare] [--benchmark_filter=REGEX ...]
// --lines     throughput instead: one patch against so many lines, shared by the threads
// --compare   a table of staircase and projection instead
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "setup.hpp"

#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/bridge/rounding/round_representation.hpp>
#include <eliminant/intersect/curve_surface/surface_pencil.hpp>
#include <eliminant/numeric/representation_pencil.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/elimination/pencil_structure.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

namespace {

using eliminant::numeric::CoordinateRows;
using eliminant::numeric::CurveForms;
using eliminant::numeric::NumericIntersection;
using eliminant::numeric::NumericIntersections;
using eliminant::numeric::NumericState;
using eliminant::numeric::RepresentationPencil;
using eliminant::numeric::SurfaceForms;
using eliminant::test::Random;

/// Homogeneous control points of a wavy patch over the unit square, 20 binary digits.
CoordinateRows patch_points(Random& random, long degree, bool rational) {
  CoordinateRows points(4, (degree + 1) * (degree + 1));
  constexpr double unit = 0x1p-20;
  const auto number = [&](double low, double high) {
    return std::round((low + (high - low) * static_cast<double>(random.between(0, 1L << 20U)) * unit) / unit) * unit;
  };
  for (long i = 0; i <= degree; ++i)
    for (long j = 0; j <= degree; ++j) {
      const double weight = rational ? static_cast<double>(random.between(8, 32)) / 16 : 1;
      const double x = static_cast<double>(i) / static_cast<double>(degree);
      const double y = static_cast<double>(j) / static_cast<double>(degree);
      const Eigen::Vector4d point(number(x - 0.1, x + 0.1), number(y - 0.1, y + 0.1), number(-0.6, 0.6), 1);
      points.col(i * (degree + 1) + j) = weight * point;
    }
  return points;
}

CurveForms random_curve(Random& random, long degree) {
  CoordinateRows points(4, degree + 1);
  const auto number = [&] { return static_cast<double>(random.between(0, 1L << 20U)) * 0x1p-20; };
  for (long i = 0; i <= degree; ++i) {
    const double x = number();
    const double y = number();
    points.col(i) << x, y, 1.8 * number() - 0.9, 1;
  }
  return eliminant::numeric::bezier_curve_forms(points);
}

void solve(benchmark::State& state, long degree, bool rational, bool real_only) {
  Random random(2026);
  constexpr std::size_t patches = 20;
  constexpr std::size_t curves = 200;
  std::vector<RepresentationPencil> pencils;
  for (std::size_t i = 0; i < patches; ++i)
    pencils.emplace_back(eliminant::numeric::bezier_patch_forms(patch_points(random, 3, rational), {3, 3}));
  std::vector<CurveForms> lines;
  for (std::size_t i = 0; i < curves; ++i) lines.push_back(random_curve(random, degree));
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  std::size_t next = 0;
  std::size_t solutions = 0;
  std::size_t converged = 0;
  for (auto _ : state) {
    pencils[next % patches].intersect(lines[next % curves], real_only, workspace, found);
    ++next;
    solutions += found.solutions.size();
    converged += static_cast<std::size_t>(
        std::count_if(found.solutions.begin(), found.solutions.end(),
                      [](const NumericIntersection& s) { return s.state == NumericState::converged; }));
  }
  state.counters["solutions"] = static_cast<double>(solutions) / static_cast<double>(next);
  state.counters["undetermined"] = static_cast<double>(solutions - converged) / static_cast<double>(next);
}

BENCHMARK_CAPTURE(solve, line_bicubic, 1, false, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, line_rational_bicubic, 1, true, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, line_bicubic_real, 1, false, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, cubic_bicubic, 3, false, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, cubic_rational_bicubic, 3, true, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solve, cubic_bicubic_real, 3, false, true)->Unit(benchmark::kMicrosecond);

void numeric_representation(benchmark::State& state) {
  Random random(2026);
  std::vector<SurfaceForms> surfaces;
  for (int i = 0; i < 20; ++i)
    surfaces.push_back(eliminant::numeric::bezier_patch_forms(patch_points(random, 3, i % 2 == 1), {3, 3}));
  std::size_t next = 0;
  for (auto _ : state) {
    const RepresentationPencil pencil(surfaces[next++ % surfaces.size()]);
    benchmark::DoNotOptimize(pencil.rows());
  }
}
BENCHMARK(numeric_representation)->Unit(benchmark::kMicrosecond);

/// Coefficients of 20 bits and a sign in the power basis.
eliminant::symbolic::RationalSurface exact_bicubic(Random& random, bool rational) {
  using eliminant::symbolic::Polynomial;
  std::vector<Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) {
    std::vector<Polynomial::Term> terms;
    for (unsigned long i = 0; i <= 3; ++i)
      for (unsigned long j = 0; j <= 3; ++j)
        if (rational || k < 3 || i + j == 0)
          terms.push_back({eliminant::symbolic::Rational(random.nonzero((1L << 20U) - 1)), {i, j}});
    coordinates.push_back(Polynomial::from_terms(2, terms));
  }
  return {eliminant::symbolic::RationalSurface::Kind::tensor_product, coordinates};
}

void exact_representation(benchmark::State& state, bool rational) {
  Random random(2026);
  std::vector<eliminant::symbolic::RationalSurface> surfaces;
  for (int i = 0; i < 10; ++i) surfaces.push_back(exact_bicubic(random, rational));
  std::size_t next = 0;
  for (auto _ : state) {
    const auto m = eliminant::symbolic::matrix_representation(surfaces[next++ % surfaces.size()]);
    benchmark::DoNotOptimize(m.columns());
  }
}
BENCHMARK_CAPTURE(exact_representation, polynomial_20_bits, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exact_representation, rational_20_bits, true)->Unit(benchmark::kMillisecond);

/// With proofs, 15 digits, on the exact representation, which is given.
void certified(benchmark::State& state, long degree) {
  using namespace eliminant;
  Random random(2026);
  const Context context;
  const symbolic::RationalSurface surface = exact_bicubic(random, false);
  const symbolic::MatrixRepresentation m = symbolic::matrix_representation(surface);
  const intersect::SurfaceInversion inversion(surface, m);
  const intersect::SurfacePencil pencil(surface, m, inversion);
  std::vector<symbolic::RationalCurve> curves;
  for (int i = 0; i < 20; ++i) {
    std::vector<symbolic::UnivariatePolynomial> coordinates;
    for (int k = 0; k < 4; ++k) {
      std::vector<symbolic::Integer> coefficients;
      for (long j = 0; j <= degree; ++j) coefficients.emplace_back(random.nonzero((1L << 20U) - 1));
      coordinates.emplace_back(coefficients);
    }
    curves.emplace_back(coordinates);
  }
  std::size_t next = 0;
  std::size_t proven = 0;
  for (auto _ : state) {
    intersect::EngineReport report;
    const auto solutions =
        pencil.solve(curves[next++ % curves.size()], static_cast<unsigned long>(18 * degree), {}, context, report);
    if (solutions) ++proven;
  }
  state.counters["certified"] = static_cast<double>(proven) / static_cast<double>(next);
}
BENCHMARK_CAPTURE(certified, line_bicubic, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(certified, cubic_bicubic, 3)->Unit(benchmark::kMicrosecond);

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One prepared patch, shared by all threads, against lines that each thread draws for itself.
void throughput(long lines, unsigned threads) {
  Random random(2026);
  const RepresentationPencil pencil(eliminant::numeric::bezier_patch_forms(patch_points(random, 3, false), {3, 3}));
  for (const bool real_only : {false, true}) {
    std::vector<std::size_t> solutions(threads);
    std::vector<std::size_t> undetermined(threads);
    const auto work = [&](unsigned thread) {
      RepresentationPencil::Workspace workspace;
      NumericIntersections found;
      std::size_t all = 0;
      std::size_t open = 0;
      for (long i = static_cast<long>(thread); i < lines; i += static_cast<long>(threads)) {
        Random own(static_cast<std::uint64_t>(i));
        pencil.intersect(random_curve(own, 1), real_only, workspace, found);
        all += found.solutions.size();
        for (const NumericIntersection& s : found.solutions)
          if (s.state != NumericState::converged) ++open;
      }
      solutions[thread] = all;
      undetermined[thread] = open;
    };
    const double processor = processor_seconds();
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::thread> pool;
    for (unsigned thread = 0; thread < threads; ++thread) pool.emplace_back(work, thread);
    for (std::thread& thread : pool) thread.join();
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::size_t all = 0;
    std::size_t open = 0;
    for (unsigned thread = 0; thread < threads; ++thread) {
      all += solutions[thread];
      open += undetermined[thread];
    }
    std::printf(
        "%ld lines, %u threads, %s: %.2f s, %.2f s of processor time, %.0f lines/s; %zu solutions, %zu undetermined\n",
        lines, threads, real_only ? "real" : "all complex", wall, processor_seconds() - processor,
        static_cast<double>(lines) / wall, all, open);
  }
}

void throughput_case(benchmark::State& state) {
  Random random(2026);
  const RepresentationPencil pencil(eliminant::numeric::bezier_patch_forms(patch_points(random, 3, false), {3, 3}));
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  constexpr long lines = 10000;
  for (auto _ : state)
    for (long i = 0; i < lines; ++i) {
      Random own(static_cast<std::uint64_t>(i));
      pencil.intersect(random_curve(own, 1), false, workspace, found);
    }
  state.SetItemsProcessed(state.iterations() * lines);
}
BENCHMARK(throughput_case)->Unit(benchmark::kMillisecond);

/// Surfaces with base points, whose matrices are wider than high.
eliminant::symbolic::RationalSurface with_base_points(Random& random, unsigned long degree) {
  using eliminant::symbolic::Polynomial;
  const auto draw = [&](unsigned long d) {
    std::vector<Polynomial::Term> terms;
    for (unsigned long i = 0; i <= d; ++i)
      for (unsigned long j = 0; j <= d; ++j)
        terms.push_back({eliminant::symbolic::Rational(random.between(-9, 9)), {i, j}});
    return Polynomial::from_terms(2, terms);
  };
  const Polynomial a = draw(1);
  const Polynomial b = draw(1);
  std::vector<Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) coordinates.push_back(a * draw(degree - 1) + b * draw(degree - 1));
  return {eliminant::symbolic::RationalSurface::Kind::tensor_product, coordinates};
}

eliminant::symbolic::RationalSurface triangular(Random& random, unsigned long degree) {
  using eliminant::symbolic::Polynomial;
  std::vector<Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) {
    std::vector<Polynomial::Term> terms;
    for (unsigned long i = 0; i <= degree; ++i)
      for (unsigned long j = 0; i + j <= degree; ++j)
        terms.push_back({eliminant::symbolic::Rational(random.between(-9, 9)), {i, j, degree - i - j}});
    coordinates.push_back(Polynomial::from_terms(3, terms));
  }
  return {eliminant::symbolic::RationalSurface::Kind::triangular, coordinates};
}

struct MethodResult {
  std::vector<double> microseconds;
  std::vector<double> errors;  ///< of the eigenvalues before Newton's iteration, chordal
  std::size_t found = 0;       ///< converged
  std::size_t others = 0;      ///< listed, not converged
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Of one family: 20 surfaces with a line or a cubic each.
void compare_family(const char* name, unsigned long degree, bool base_points, long curve_degree) {
  using namespace eliminant;
  Random random(20090804);
  const Context context;
  std::array<MethodResult, 2> results;
  std::vector<double> structure_microseconds;
  long rows = 0;
  long columns = 0;
  std::size_t expected = 0;
  for (int i = 0; i < 20; ++i) {
    const symbolic::RationalSurface surface =
        base_points ? with_base_points(random, degree) : triangular(random, degree);
    const symbolic::MatrixRepresentation m = symbolic::matrix_representation(surface);
    rows = m.rows();
    columns = m.columns();
    std::vector<symbolic::UnivariatePolynomial> coordinates;
    for (int k = 0; k < 4; ++k) {
      std::vector<symbolic::Integer> coefficients;
      for (long j = 0; j <= curve_degree; ++j) coefficients.emplace_back(random.between(-9, 9));
      coordinates.emplace_back(coefficients);
    }
    const symbolic::RationalCurve curve(coordinates);
    const symbolic::ParameterForm minors = symbolic::minors_on_curve(m, curve, 0, context);
    std::vector<std::complex<double>> roots;
    for (const bridge::ComplexBall& ball : bridge::enclose_roots(minors.finite.primitive_part(), 60, context))
      roots.emplace_back(arf_get_d(arb_midref(ball.real()), ARF_RND_NEAR),
                         arf_get_d(arb_midref(ball.imaginary()), ARF_RND_NEAR));
    expected += roots.size();
    const RepresentationPencil pencil(bridge::round_surface(surface), bridge::round_representation(m, surface.kind()));
    const CurveForms rounded = bridge::round_curve(curve);
    RepresentationPencil::Workspace workspace;
    NumericIntersections found;
    double start = processor_seconds();
    const symbolic::PencilStructure structure = symbolic::pencil_structure_modulo(m, curve, 0);
    structure_microseconds.push_back(1e6 * (processor_seconds() - start));
    for (std::size_t method = 0; method < 2; ++method) {
      const auto run = [&] {
        if (method == 0)
          pencil.intersect_by_staircase(rounded, structure.column_steps, structure.row_steps, workspace, found);
        else
          pencil.intersect(rounded, false, workspace, found);
      };
      run();
      constexpr int repetitions = 5;
      start = processor_seconds();
      for (int r = 0; r < repetitions; ++r) run();
      results[method].microseconds.push_back(1e6 * (processor_seconds() - start) / repetitions);
      for (const NumericIntersection& s : found.solutions) {
        if (s.state != NumericState::converged) {
          ++results[method].others;
          continue;
        }
        ++results[method].found;
        // The first step of Newton's iteration is the error of what the pencil said.
        results[method].errors.push_back(s.first_step);
      }
    }
  }
  for (std::size_t method = 0; method < 2; ++method)
    std::printf("| %s | %ld x %ld | %s | %zu of %zu | %zu | %.1e | %.1e | %.0f%s |\n", name, rows, columns,
                method == 0 ? "staircase" : "projection", results[method].found, expected, results[method].others,
                median(results[method].errors),
                *std::max_element(results[method].errors.begin(), results[method].errors.end()),
                median(results[method].microseconds),
                method == 0 ? (" + " + std::to_string(std::lround(median(structure_microseconds)))).c_str() : "");
}

/// The largest chordal distance from an exact root to as many nearest eigenvalues as its multiplicity says.
void compare_multiple(const char* name, const std::vector<const char*>& surface_texts,
                      const std::vector<const char*>& curve_texts) {
  using namespace eliminant;
  const bool plane = std::strchr(surface_texts[0], 'u') != nullptr;
  const std::vector<std::string> three{"s", "t", "u"};
  const std::vector<std::string> two{"s", "t"};
  std::vector<symbolic::Polynomial> coordinates;
  for (const char* text : surface_texts) coordinates.push_back(symbolic::parse_polynomial(text, plane ? three : two));
  const symbolic::RationalSurface surface(
      plane ? symbolic::RationalSurface::Kind::triangular : symbolic::RationalSurface::Kind::tensor_product,
      coordinates);
  std::vector<symbolic::Polynomial> curve_coordinates;
  for (const char* text : curve_texts)
    curve_coordinates.push_back(symbolic::parse_polynomial(text, std::vector<std::string>{"t"}));
  const symbolic::RationalCurve curve = symbolic::rational_curve(curve_coordinates);
  const symbolic::MatrixRepresentation m = symbolic::matrix_representation(surface);
  const Context context;
  const symbolic::ParameterForm minors = symbolic::minors_on_curve(m, curve, 0, context);
  const RepresentationPencil pencil(bridge::round_surface(surface), bridge::round_representation(m, surface.kind()));
  const symbolic::PencilStructure structure = symbolic::pencil_structure_modulo(m, curve, 0);
  RepresentationPencil::Workspace workspace;
  std::array<NumericIntersections, 2> found;
  pencil.intersect_by_staircase(bridge::round_curve(curve), structure.column_steps, structure.row_steps, workspace,
                                found[0]);
  pencil.intersect(bridge::round_curve(curve), false, workspace, found[1]);
  for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(minors.finite)) {
    if (part.multiplicity < 2 || part.factor.degree() < 1) continue;
    std::array<double, 2> errors{};
    for (const bridge::ComplexBall& ball : bridge::enclose_roots(part.factor, 60, context)) {
      const std::complex<double> root(arf_get_d(arb_midref(ball.real()), ARF_RND_NEAR),
                                      arf_get_d(arb_midref(ball.imaginary()), ARF_RND_NEAR));
      for (std::size_t method = 0; method < 2; ++method) {
        std::vector<double> distances;
        for (const NumericIntersection& s : found[method].solutions)
          distances.push_back(std::abs(s.t[0] - root * s.t[1]) /
                              std::sqrt((std::norm(s.t[0]) + std::norm(s.t[1])) * (1 + std::norm(root))));
        std::sort(distances.begin(), distances.end());
        const bool enough = distances.size() >= part.multiplicity;
        errors[method] = std::max(errors[method], enough ? distances[part.multiplicity - 1] : 1.0);
      }
    }
    std::printf("| %s | %lu | %.1e | %.1e |\n", name, part.multiplicity, errors[0], errors[1]);
  }
}

void compare() {
  std::printf("| pair | matrix | method | converged | others | error, median | largest | us |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  compare_family("line, biquadratic with 2 base points", 2, true, 1);
  compare_family("cubic, the same", 2, true, 3);
  compare_family("line, bicubic with 2 base points", 3, true, 1);
  compare_family("cubic, the same", 3, true, 3);
  compare_family("line, Steiner", 2, false, 1);
  compare_family("cubic, Steiner", 2, false, 3);
  compare_family("line, triangular of degree 3", 3, false, 1);
  compare_family("cubic, the same", 3, false, 3);
  std::printf("\n| pair | multiplicity | staircase | projection |\n| --- | --- | --- | --- |\n");
  const std::vector<const char*> torus{"-s^2*t^2 - 3*s^2 + t^2 + 3", "2*s*t^2 + 6*s", "2*s^2*t + 2*t",
                                       "s^2*t^2 + s^2 + t^2 + 1"};
  compare_multiple("example 1 of the paper, triple points",
                   {"s^3 + t^2*u", "s^2*t + t^2*u", "s^3 + t^3", "s^2*u + t^2*u"}, {"1", "t", "t^2", "t^3"});
  compare_multiple("example 3, an embedded point", {"s^2 + t^2 + u^2", "2*s*u", "2*s*t", "s^2 - t^2 - u^2"},
                   {"1", "0", "0", "t"});
  compare_multiple("torus, line touching in two points", torus, {"t", "0", "1", "1"});
  compare_multiple("torus, line touching in one", torus, {"1", "t", "0", "1"});
  compare_multiple("cone, line through the apex", {"-s^2*t + t", "2*s*t", "s^2*t + t", "s^2 + 1"},
                   {"t", "0", "0", "1"});
}

}  // namespace

int main(int argc, char** argv) {
  long lines = 0;
  unsigned threads = 1;
  bool comparing = false;
  std::vector<char*> rest{argv[0]};
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--compare") == 0)
      comparing = true;
    else if (std::strcmp(argv[i], "--lines") == 0 && i + 1 < argc)
      lines = std::atol(argv[++i]);
    else if (std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
      threads = static_cast<unsigned>(std::max(1, std::atoi(argv[++i])));
    else
      rest.push_back(argv[i]);
  }
  if (comparing) compare();
  if (lines > 0) throughput(lines, threads);
  if (comparing || lines > 0) return 0;
  int count = static_cast<int>(rest.size());
  benchmark::Initialize(&count, rest.data());
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
