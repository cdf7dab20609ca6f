// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/rounding/round_matrix.hpp>
#include <eliminant/intersect/plane_curves/pencil_candidates.hpp>
#include <eliminant/numeric/eigenvalue_clusters.hpp>
#include <eliminant/numeric/multiplication_matrix.hpp>
#include <eliminant/numeric/newton_refinement.hpp>
#include <eliminant/numeric/resultant_solver.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/exact_ranks.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/elimination/solution_profile.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/hybrid_bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/sylvester_matrix.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::HiddenVariablePolynomial;
using symbolic::Polynomial;
using symbolic::PolynomialMatrix;

constexpr int newton_steps = 12;

/// The number of distinct zeros of the determinant of the matrix, modulo a prime: the number of clusters.
long distinct_eigenvalues(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g, bool bezout,
                          std::uint64_t seed) {
  symbolic::PrimeSequence primes(symbolic::mix(seed, 5));
  for (;;) {
    const symbolic::PrimeField field(primes.next());
    std::optional<symbolic::ModularPolynomial> determinant = symbolic::resultant_modulo(f, g, field);
    if (!determinant || determinant->is_zero()) continue;
    if (bezout && f.degree() != g.degree()) {
      // The spurious factor of Proposition 3.
      const HiddenVariablePolynomial& larger = f.degree() > g.degree() ? f : g;
      symbolic::ModularPolynomial factor(field);
      fmpz_poly_get_nmod_poly(factor.get(), larger.leading_coefficient().get());
      nmod_poly_pow(factor.get(), factor.get(), static_cast<mp_limb_t>(std::labs(f.degree() - g.degree())));
      nmod_poly_mul(determinant->get(), determinant->get(), factor.get());
    }
    long distinct = 0;
    for (const unsigned long count : symbolic::multiplicity_profile(*determinant)) distinct += static_cast<long>(count);
    return distinct;
  }
}

bridge::ComplexBall exact_ball(const std::complex<double>& z) { return {z.real(), z.imag()}; }

template <class Scalar>
bridge::ComplexBall exact_ball(const std::complex<Scalar>& z) {
  bridge::ComplexBall ball;
  arf_set_mpfr(arb_midref(ball.real()), z.real().backend().data());
  arf_set_mpfr(arb_midref(ball.imaginary()), z.imag().backend().data());
  return ball;
}

template <class Scalar>
PencilCandidates solve_rounded(const HiddenVariablePolynomial& f, const HiddenVariablePolynomial& g,
                               const Polynomial& p, const Polynomial& q, bool bezout, const Options& options,
                               const Context& context) {
  context.checkpoint("building the resultant matrix");
  const PolynomialMatrix sylvester = symbolic::sylvester_matrix(f, g);
  const PolynomialMatrix matrix = bezout ? symbolic::bezout_matrix(f, g) : sylvester;
  numeric::ResultantProblem<Scalar> problem;
  problem.matrix = bridge::round_matrix<Scalar>(matrix).value;
  problem.sylvester = bridge::round_matrix<Scalar>(sylvester).value;
  problem.p = bridge::round_polynomial<Scalar>(p).value;
  problem.q = bridge::round_polynomial<Scalar>(q).value;
  problem.epsilon = options.epsilon;
  if (matrix.degree() >= 1) {
    problem.infinite_step_sizes = symbolic::infinite_structure_modulo(matrix, options.seed);
    problem.distinct_eigenvalues = distinct_eigenvalues(f, g, bezout, options.seed);
  }
  context.checkpoint("eigenvalues");
  const numeric::ResultantSolution<Scalar> solution = numeric::solve_by_resultant(problem);

  PencilCandidates result;
  result.report.matrix_size = matrix.rows();
  result.report.matrix_degree = matrix.degree();
  result.report.pencil_size = solution.pencil_size;
  result.report.regular_size = solution.regular_size;
  for (const numeric::Fibre<Scalar>& fibre : solution.fibres) {
    for (const std::complex<Scalar>& y : fibre.ys) {
      PencilCandidates::Candidate candidate{{exact_ball(fibre.x), exact_ball(y)}, {}};
      candidate.refined = candidate.approximate;
      if constexpr (std::is_same_v<Scalar, double>) {
        const numeric::PlanePoint<double> point =
            numeric::newton_refinement<double>(problem.p, problem.q, {fibre.x, y}, newton_steps);
        candidate.refined = {exact_ball(point.x), exact_ball(point.y)};
      }
      result.candidates.push_back(std::move(candidate));
    }
  }
  return result;
}

/// The graded pencil of two curves that do not meet at infinity.
struct GradedPencil {
  long m = 0;  ///< the larger degree
  long n = 0;
  long matrix_degree = 0;
  numeric::BivariatePolynomial<double> f, g;  ///< of degrees m and n
  std::optional<numeric::MultiplicationMatrices<double>> matrices;
};

GradedPencil graded_pencil(const Polynomial& p, const Polynomial& q, const Context& context) {
  context.checkpoint("building the resultant matrix");
  const bool exchanged = p.total_degree() < q.total_degree();
  const Polynomial& f = exchanged ? q : p;
  const Polynomial& g = exchanged ? p : q;
  GradedPencil pencil;
  pencil.m = f.total_degree();
  pencil.n = g.total_degree();
  const PolynomialMatrix matrix =
      symbolic::hybrid_bezout_matrix(symbolic::hide_variable(f, 0), symbolic::hide_variable(g, 0), pencil.m, pencil.n);
  pencil.matrix_degree = matrix.degree();
  pencil.f = bridge::round_polynomial<double>(f).value;
  pencil.g = bridge::round_polynomial<double>(g).value;
  context.checkpoint("eigenvalues");
  pencil.matrices = numeric::multiplication_matrices<double>(bridge::round_matrix<double>(matrix).value, pencil.f,
                                                             pencil.g, pencil.m, pencil.n);
  return pencil;
}

}  // namespace

PencilCandidates pencil_candidates(const Polynomial& p, const Polynomial& q, std::size_t hidden, int precision_bits,
                                   const Options& options, const Context& context) {
  // The numeric stage hides the first variable.
  const Polynomial f = hidden == 0 ? p : symbolic::exchange_variables(p);
  const Polynomial g = hidden == 0 ? q : symbolic::exchange_variables(q);
  const HiddenVariablePolynomial f_hidden = symbolic::hide_variable(f, 0);
  const HiddenVariablePolynomial g_hidden = symbolic::hide_variable(g, 0);
  const bool bezout = options.matrix != ResultantMatrix::sylvester;
  const auto solve = [&]<class Scalar>(Scalar) {
    return solve_rounded<Scalar>(f_hidden, g_hidden, f, g, bezout, options, context);
  };
  PencilCandidates result;
  switch (precision_bits) {
    case 53:
      result = solve(double());
      break;
    case 128:
      result = solve(numeric::Real128());
      break;
    case 256:
      result = solve(numeric::Real256());
      break;
    case 512:
      result = solve(numeric::Real512());
      break;
    case 1024:
      result = solve(numeric::Real1024());
      break;
    default:
      throw InvalidInput("the precision " + std::to_string(precision_bits) + " is not available",
                         "53, 128, 256, 512 or 1024 bits");
  }
  if (hidden == 1)
    for (auto& candidate : result.candidates) {
      std::swap(candidate.approximate.x, candidate.approximate.y);
      std::swap(candidate.refined.x, candidate.refined.y);
    }
  result.report.matrix = bezout ? "bezout" : "sylvester";
  result.report.precision_bits = precision_bits;
  result.report.seed = options.seed;
  return result;
}

PencilCandidates graded_pencil_candidates(const Polynomial& p, const Polynomial& q, bool eigenvectors,
                                          const Context& context) {
  const GradedPencil pencil = graded_pencil(p, q, context);
  PencilCandidates result;
  result.report.matrix = "hybrid";
  result.report.matrix_size = pencil.m;
  result.report.matrix_degree = pencil.matrix_degree;
  result.report.pencil_size = pencil.m * pencil.n;
  result.report.regular_size = pencil.m * pencil.n;
  result.report.precision_bits = 53;
  if (!pencil.matrices) return result;
  const std::vector<numeric::PlanePoint<double>> points =
      eigenvectors ? numeric::points_by_eigenvectors(*pencil.matrices)
                   : numeric::points_by_eigenvalues(*pencil.matrices, pencil.f, pencil.g, pencil.m, pencil.n);
  for (const numeric::PlanePoint<double>& found : points) {
    if (!numeric::is_finite(found.x) || !numeric::is_finite(found.y)) continue;
    const numeric::PlanePoint<double> refined =
        numeric::newton_refinement<double>(pencil.f, pencil.g, found, newton_steps);
    result.candidates.push_back(
        {{exact_ball(found.x), exact_ball(found.y)}, {exact_ball(refined.x), exact_ball(refined.y)}});
  }
  return result;
}

namespace {

/// Projective coordinates (x : y : z) = A (u : v : 1).
using Chart = std::array<std::array<long, 3>, 3>;

/// The clusters of the graded pencil in one chart; nullopt when it is in doubt which are at infinity, too.
std::optional<PencilMultiplicities> multiplicities_in_chart(const Polynomial& f, const Polynomial& g,
                                                            const Chart& chart, const Context& context) {
  const GradedPencil pencil = graded_pencil(f, g, context);
  if (!pencil.matrices) return std::nullopt;
  const auto points = numeric::points_by_clusters(*pencil.matrices);
  if (!points) return std::nullopt;
  // The mean of a part of a cluster is no zero.
  const auto is_zero = [](const numeric::BivariatePolynomial<double>& curve, const numeric::PlanePoint<double>& point) {
    const numeric::BivariatePolynomial<double> majorant{curve.coefficients.cwiseAbs()};
    const double largest = std::abs(numeric::jet<double>(majorant, std::abs(point.x), std::abs(point.y)).value);
    constexpr double tolerance = 1e-9;
    return std::abs(numeric::jet(curve, point.x, point.y).value) <= tolerance * largest;
  };
  PencilMultiplicities result;
  for (const numeric::ClusteredPoint& each : *points) {
    if (!is_zero(pencil.f, each.point) || !is_zero(pencil.g, each.point)) return std::nullopt;
    std::array<double, 3> moduli{};
    for (std::size_t row = 0; row < 3; ++row) {
      const auto weight = [&](std::size_t column) { return static_cast<double>(chart[row][column]); };
      moduli[row] = std::abs(weight(0) * each.point.x + weight(1) * each.point.y + weight(2));
    }
    const double relative_z = moduli[2] / *std::max_element(moduli.begin(), moduli.end());
    constexpr double surely_nothing = 1e-8;
    constexpr double surely_something = 1e-4;
    if (!(relative_z <= surely_nothing) && !(relative_z >= surely_something)) return std::nullopt;
    const auto multiplicity = static_cast<unsigned long>(each.multiplicity);
    if (relative_z <= surely_nothing) {
      result.at_infinity += multiplicity;
      continue;
    }
    auto& distinct = result.distinct_by_multiplicity;
    distinct.resize(std::max<std::size_t>(distinct.size(), multiplicity), 0);
    ++distinct[multiplicity - 1];
  }
  return result;
}

}  // namespace

std::optional<PencilMultiplicities> pencil_multiplicities(const Polynomial& p, const Polynomial& q, std::uint64_t seed,
                                                          const Context& context) {
  // The first chart is the affine plane itself; in each of the others another line is at infinity.
  static constexpr std::array<Chart, 5> charts{{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                                {{{2, 1, 1}, {-1, 2, 1}, {1, -1, 2}}},
                                                {{{1, -2, 2}, {2, 2, -1}, {-2, 1, 3}}},
                                                {{{3, 1, -1}, {1, -2, 2}, {1, 3, 2}}},
                                                {{{2, -3, 1}, {3, 1, 2}, {3, 2, -2}}}}};
  for (const Chart& chart : charts) {
    const Polynomial f = symbolic::projective_image(p, chart);
    const Polynomial g = symbolic::projective_image(q, chart);
    if (f.total_degree() != p.total_degree() || g.total_degree() != q.total_degree() ||
        !symbolic::do_not_meet_at_infinity(f, g, seed))
      continue;
    if (auto found = multiplicities_in_chart(f, g, chart, context)) return found;
  }
  return std::nullopt;
}

long companion_pencil_size(const Polynomial& p, const Polynomial& q, std::size_t hidden, ResultantMatrix matrix) {
  const std::size_t eliminated = 1 - hidden;
  const bool bezout = matrix != ResultantMatrix::sylvester;
  const long size =
      bezout ? std::max(p.degree(eliminated), q.degree(eliminated)) : p.degree(eliminated) + q.degree(eliminated);
  const long degree = bezout ? p.degree(hidden) + q.degree(hidden) : std::max(p.degree(hidden), q.degree(hidden));
  return size * degree;
}

std::size_t smaller_pencil_variable(const Polynomial& p, const Polynomial& q, ResultantMatrix matrix) {
  // Without the eliminated variable, or without the hidden one, there is no matrix polynomial to solve.
  const auto usable_size = [&](std::size_t hidden) {
    const long size = companion_pencil_size(p, q, hidden, matrix);
    return size == 0 ? std::numeric_limits<long>::max() : size;
  };
  return usable_size(0) <= usable_size(1) ? 0 : 1;
}

}  // namespace eliminant::intersect
