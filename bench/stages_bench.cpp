// SPDX-License-Identifier: BSD-3-Clause
//
// Every stage of the intersection of two plane curves by itself, on dense pairs of equal degree, with one thread:
//   scripts/bench.sh stages [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>

#include <eliminant/bridge/certificates/disc_certificate.hpp>
#include <eliminant/bridge/certificates/krawczyk_test.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/bridge/rounding/round_matrix.hpp>
#include <eliminant/intersect/plane_curves/pencil_candidates.hpp>
#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/numeric/kronecker_reduction.hpp>
#include <eliminant/numeric/multiplication_matrix.hpp>
#include <eliminant/symbolic/elimination/exact_ranks.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/elimination/solution_profile.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/hybrid_bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/sylvester_matrix.hpp>

#include "macaulay_pencil.hpp"
#include "setup.hpp"

namespace {

using namespace eliminant;
using bench::CurvePair;
using bench::dense_pair;

constexpr std::uint64_t seed = 0;

/// The pair of one benchmark with the first variable hidden.
struct HiddenPair {
  explicit HiddenPair(const CurvePair& pair)
      : f(symbolic::hide_variable(pair.p, 0)), g(symbolic::hide_variable(pair.q, 0)) {}
  symbolic::HiddenVariablePolynomial f;
  symbolic::HiddenVariablePolynomial g;
};

symbolic::PolynomialMatrix dense_bezout_matrix(long degree) {
  const HiddenPair pair(dense_pair(degree));
  return symbolic::bezout_matrix(pair.f, pair.g);
}

void count_matrix(benchmark::State& state, const symbolic::PolynomialMatrix& matrix) {
  state.counters["size"] = static_cast<double>(matrix.rows());
  state.counters["degree_in_x"] = static_cast<double>(matrix.degree());
  state.counters["pencil"] = static_cast<double>(matrix.rows() * matrix.degree());
}

void bezout_matrix(benchmark::State& state) {
  const HiddenPair pair(dense_pair(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::bezout_matrix(pair.f, pair.g));
  count_matrix(state, symbolic::bezout_matrix(pair.f, pair.g));
}

void sylvester_matrix(benchmark::State& state) {
  const HiddenPair pair(dense_pair(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::sylvester_matrix(pair.f, pair.g));
  count_matrix(state, symbolic::sylvester_matrix(pair.f, pair.g));
}

void hybrid_bezout_matrix(benchmark::State& state) {
  const long degree = state.range(0);
  const HiddenPair pair(dense_pair(degree));
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::hybrid_bezout_matrix(pair.f, pair.g, degree, degree));
  count_matrix(state, symbolic::hybrid_bezout_matrix(pair.f, pair.g, degree, degree));
}

void resultant(benchmark::State& state) {
  const HiddenPair pair(dense_pair(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::resultant(pair.f, pair.g, seed));
  state.counters["degree_in_x"] = static_cast<double>(symbolic::resultant(pair.f, pair.g, seed).degree());
}

void infinite_structure(benchmark::State& state) {
  const symbolic::PolynomialMatrix matrix = dense_bezout_matrix(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(symbolic::infinite_structure_modulo(matrix, seed));
  count_matrix(state, matrix);
}

template <class Scalar>
void round_matrix(benchmark::State& state) {
  const symbolic::PolynomialMatrix matrix = dense_bezout_matrix(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(bridge::round_matrix<Scalar>(matrix));
  count_matrix(state, matrix);
}

void staircase(benchmark::State& state) {
  const symbolic::PolynomialMatrix matrix = dense_bezout_matrix(state.range(0));
  const std::vector<long> steps = symbolic::infinite_structure_modulo(matrix, seed);
  const auto rounded = bridge::round_matrix<double>(matrix).value;
  for (auto _ : state) benchmark::DoNotOptimize(numeric::regular_part_staircase(rounded, steps));
  count_matrix(state, matrix);
  state.counters["regular"] = static_cast<double>(numeric::regular_part_staircase(rounded, steps).pencil.size());
  state.counters["steps"] = static_cast<double>(steps.size());
}

void generalized_eigen(benchmark::State& state) {
  const symbolic::PolynomialMatrix matrix = dense_bezout_matrix(state.range(0));
  const std::vector<long> steps = symbolic::infinite_structure_modulo(matrix, seed);
  const auto regular = numeric::regular_part_staircase(bridge::round_matrix<double>(matrix).value, steps);
  for (auto _ : state) benchmark::DoNotOptimize(numeric::generalized_eigen(regular.pencil));
  state.counters["size"] = static_cast<double>(regular.pencil.size());
}

/// What the graded pencil starts from.
struct RoundedPair {
  explicit RoundedPair(long degree)
      : pair(dense_pair(degree)),
        p(bridge::round_polynomial<double>(pair.p).value),
        q(bridge::round_polynomial<double>(pair.q).value),
        matrix(bridge::round_matrix<double>(symbolic::hybrid_bezout_matrix(symbolic::hide_variable(pair.p, 0),
                                                                           symbolic::hide_variable(pair.q, 0), degree,
                                                                           degree))
                   .value),
        degree(degree) {}
  numeric::MultiplicationMatrices<double> multiplication() const {
    return numeric::multiplication_matrices<double>(matrix, p, q, degree, degree).value();
  }
  CurvePair pair;
  numeric::BivariatePolynomial<double> p;
  numeric::BivariatePolynomial<double> q;
  numeric::MatrixPolynomial<double> matrix;
  long degree;
};

void multiplication_matrices(benchmark::State& state) {
  const RoundedPair rounded(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(rounded.multiplication());
  state.counters["size"] = static_cast<double>(rounded.multiplication().x.rows());
}

/// The largest |p| or |q| over the sum of the moduli of its terms, at the points before any refinement.
double largest_residual(const RoundedPair& rounded, const std::vector<numeric::PlanePoint<double>>& points) {
  double largest = 0;
  for (const auto& point : points)
    for (const auto* curve : {&rounded.p, &rounded.q}) {
      const numeric::BivariatePolynomial<double> majorant{curve->coefficients.cwiseAbs()};
      const double scale = std::abs(numeric::jet<double>(majorant, std::abs(point.x), std::abs(point.y)).value);
      largest = std::max(largest, std::abs(numeric::jet(*curve, point.x, point.y).value) / scale);
    }
  return largest;
}

/// The same matrices from the null space of the Macaulay matrix.
void macaulay_multiplication_matrices(benchmark::State& state) {
  const RoundedPair rounded(state.range(0));
  const auto build = [&] {
    return bench::macaulay_multiplication(rounded.p, rounded.q, rounded.degree, rounded.degree);
  };
  for (auto _ : state) benchmark::DoNotOptimize(build());
  state.counters["size"] = static_cast<double>(build().x.rows());
  state.counters["residual"] = largest_residual(rounded, numeric::points_by_eigenvectors(build()));
}

/// The points by eigenvalues alone.
void multiplication_points_by_eigenvalues(benchmark::State& state) {
  const RoundedPair rounded(state.range(0));
  const auto matrices = rounded.multiplication();
  const auto points = [&] {
    return numeric::points_by_eigenvalues(matrices, rounded.p, rounded.q, rounded.degree, rounded.degree);
  };
  for (auto _ : state) benchmark::DoNotOptimize(points());
  state.counters["residual"] = largest_residual(rounded, points());
}

/// Eigenvalues and eigenvectors of a combination of the multiplication matrices, and the points read off them.
void multiplication_points(benchmark::State& state) {
  const RoundedPair rounded(state.range(0));
  const auto matrices = rounded.multiplication();
  for (auto _ : state) benchmark::DoNotOptimize(numeric::points_by_eigenvectors(matrices));
  state.counters["size"] = static_cast<double>(matrices.x.rows());
  state.counters["residual"] = largest_residual(rounded, numeric::points_by_eigenvectors(matrices));
}

/// Everything from the two polynomials to unproven points by the graded pencil.
void graded_pencil_candidates(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  std::size_t count = 0;
  for (auto _ : state) count = intersect::graded_pencil_candidates(pair.p, pair.q, false, context).candidates.size();
  state.counters["candidates"] = static_cast<double>(count);
}

/// The same by the paper's pencil of the Bezout matrix; then clusters and fibres.
void pencil_candidates(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  std::size_t count = 0;
  for (auto _ : state) count = intersect::pencil_candidates(pair.p, pair.q, 0, 53, {}, context).candidates.size();
  state.counters["candidates"] = static_cast<double>(count);
}

void solution_profile(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  unsigned long distinct = 0;
  for (auto _ : state) distinct = symbolic::solution_profile(pair.p, pair.q, seed, context).distinct();
  state.counters["distinct"] = static_cast<double>(distinct);
}

/// Over the integers; with its derivative by the shear when the second argument is 1.
void chow_form(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  symbolic::ChowForm form;
  for (auto _ : state) form = symbolic::chow_form(pair.p, pair.q, 1, state.range(1) == 1, seed, context);
  const long degree = form.form.degree();
  state.counters["degree"] = static_cast<double>(degree);
  state.counters["leading_bits"] = static_cast<double>(form.form.coefficient(degree).bit_length());
}

void univariate_representation(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  unsigned long distinct = 0;
  for (auto _ : state) {
    const auto representation = symbolic::univariate_representation(pair.p, pair.q, 1, seed, context);
    distinct = representation ? representation->distinct() : 0;
  }
  state.counters["distinct"] = static_cast<double>(distinct);
}

/// The roots of the eliminant, each in a ball of its own: all complex ones, or (real_only) the real ones by Descartes'
/// rule of signs.
void isolated_roots(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  const symbolic::UnivariatePolynomial form =
      symbolic::chow_form(pair.p, pair.q, 1, false, seed, context).form.primitive_part();
  std::size_t roots = 0;
  for (auto _ : state) {
    const auto isolated =
        state.range(1) == 1 ? bridge::IsolatedRoots::real(form, context) : bridge::IsolatedRoots(form, context);
    roots = isolated.balls().size();
  }
  state.counters["degree"] = static_cast<double>(form.degree());
  state.counters["roots"] = static_cast<double>(roots);
}

/// All solutions by the Krawczyk test in hardware doubles, from refined points of the graded pencil.
void disc_certificate(benchmark::State& state) {
  const RoundedPair rounded(state.range(0));
  constexpr int newton_steps = 12;
  std::vector<numeric::PlanePoint<double>> points = numeric::points_by_eigenvectors(rounded.multiplication());
  for (auto& point : points) point = numeric::newton_refinement<double>(rounded.p, rounded.q, point, newton_steps);
  const auto p = bridge::RoundedCurve::round(rounded.pair.p);
  const auto q = bridge::RoundedCurve::round(rounded.pair.q);
  std::size_t proven = 0;
  for (auto _ : state) {
    proven = 0;
    for (const auto& point : points)
      if (bridge::disc_krawczyk_test(*p, *q, point)) ++proven;
  }
  state.counters["points"] = static_cast<double>(points.size());
  state.counters["proven"] = static_cast<double>(proven);
}

/// All simple solutions, from the points of the pencil: to a radius of 2^-80 with at most 256 bits.
void krawczyk_enclosing(benchmark::State& state) {
  const CurvePair pair = dense_pair(state.range(0));
  const Context context;
  const auto candidates = intersect::pencil_candidates(pair.p, pair.q, 0, 53, {}, context).candidates;
  const bridge::BallCurve p(pair.p);
  const bridge::BallCurve q(pair.q);
  constexpr long target_log2 = -80;
  constexpr long max_precision_bits = 256;
  std::size_t proven = 0;
  for (auto _ : state) {
    proven = 0;
    for (const auto& candidate : candidates)
      if (bridge::enclose_simple_zero(p, q, candidate.refined, target_log2, max_precision_bits)) ++proven;
  }
  state.counters["candidates"] = static_cast<double>(candidates.size());
  state.counters["proven"] = static_cast<double>(proven);
}

void dense_degrees(benchmark::internal::Benchmark* family) {
  family->DenseRange(5, 20, 5)->ArgName("degree")->Unit(benchmark::kMillisecond);
}

BENCHMARK(bezout_matrix)->Apply(dense_degrees);
BENCHMARK(sylvester_matrix)->Apply(dense_degrees);
BENCHMARK(hybrid_bezout_matrix)->Apply(dense_degrees);
BENCHMARK(resultant)->Apply(dense_degrees);
BENCHMARK(infinite_structure)->Apply(dense_degrees);
BENCHMARK(round_matrix<double>)->Apply(dense_degrees);
BENCHMARK(round_matrix<numeric::Real256>)->Apply(dense_degrees);
BENCHMARK(staircase)->Apply(dense_degrees);
BENCHMARK(generalized_eigen)->Apply(dense_degrees);
BENCHMARK(multiplication_matrices)->Apply(dense_degrees);
BENCHMARK(multiplication_points)->Apply(dense_degrees);
BENCHMARK(multiplication_points_by_eigenvalues)->Apply(dense_degrees);
BENCHMARK(macaulay_multiplication_matrices)->Apply(dense_degrees);
BENCHMARK(graded_pencil_candidates)->Apply(dense_degrees);
BENCHMARK(pencil_candidates)->Apply(dense_degrees);
BENCHMARK(solution_profile)->Apply(dense_degrees);
BENCHMARK(chow_form)
    ->ArgsProduct({{5, 10, 15, 20}, {0, 1}})
    ->ArgNames({"degree", "derivative"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(isolated_roots)
    ->ArgsProduct({{5, 10, 15, 20, 30}, {0, 1}})
    ->ArgNames({"degree", "real_only"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(univariate_representation)->Apply(dense_degrees);
BENCHMARK(disc_certificate)->Apply(dense_degrees);
BENCHMARK(krawczyk_enclosing)->Apply(dense_degrees);

}  // namespace
