// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include <doctest/doctest.h>

#include <support/curves.hpp>
#include <support/representation_data.hpp>

#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/intersect/curve_surface/surface_pencil.hpp>
#include <eliminant/symbolic/elimination/pencil_structure.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using numeric::NumericIntersection;
using numeric::NumericIntersections;
using numeric::NumericOutcome;
using numeric::NumericState;
using symbolic::MatrixRepresentation;
using symbolic::RationalCurve;
using symbolic::RationalSurface;
using Kind = RationalSurface::Kind;
using Complex = std::complex<double>;

namespace {

double chord(const std::array<Complex, 2>& a, const std::array<Complex, 2>& b) {
  const auto norm = [](const std::array<Complex, 2>& v) { return std::sqrt(std::norm(v[0]) + std::norm(v[1])); };
  return std::abs(a[0] * b[1] - a[1] * b[0]) / (norm(a) * norm(b));
}

/// How far rounding may move an eigenvalue of that multiplicity, generously: a root of the machine epsilon.
double reach(unsigned long multiplicity) {
  return std::min(0.05, 300 * std::pow(1e-16, 1.0 / static_cast<double>(multiplicity)) + 1e-9);
}

bool is_finite(const NumericIntersection& s) {
  const auto finite = [](const Complex& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); };
  return std::all_of(s.t.begin(), s.t.end(), finite) && std::all_of(s.parameters.begin(), s.parameters.end(), finite) &&
         std::isfinite(s.step) && std::isfinite(s.distance) && std::abs(s.t[0]) + std::abs(s.t[1]) > 0.5;
}

/// The roots of the gcd of the maximal minors, which are the eigenvalues of the regular part, with multiplicities.
struct Root {
  std::array<Complex, 2> t;
  unsigned long multiplicity;
};

std::vector<Root> roots_of(const symbolic::ParameterForm& minors) {
  std::vector<Root> roots;
  const Context context;
  for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(minors.finite)) {
    if (part.factor.degree() < 1) continue;
    for (const bridge::ComplexBall& ball : bridge::enclose_roots(part.factor, 60, context))
      roots.push_back({{Complex(arf_get_d(arb_midref(ball.real()), ARF_RND_NEAR),
                                arf_get_d(arb_midref(ball.imaginary()), ARF_RND_NEAR)),
                        Complex(1)},
                       part.multiplicity});
  }
  return roots;
}

struct Agreement {
  std::size_t roots = 0;
  std::size_t simple = 0;
  /// Roots around which a method has another number of eigenvalues than the multiplicity.
  std::size_t staircase_differs = 0;
  std::size_t projection_differs = 0;
  /// Eigenvalues that converged although they are none.
  std::size_t invented = 0;
  bool all_finite = true;
};

/// Around every root of the minors both methods have as many eigenvalues as its multiplicity.
Agreement compare(const RationalSurface& surface, const MatrixRepresentation& m, const RationalCurve& curve) {
  const Context context;
  const symbolic::ParameterForm minors = symbolic::minors_on_curve(m, curve, 0, context);
  const symbolic::PencilStructure structure = symbolic::pencil_structure_modulo(m, curve, 0);
  const SurfaceInversion inversion(surface, m);
  const SurfacePencil pencil(surface, m, inversion);
  const NumericIntersections staircase = pencil.candidates(curve, SingularPencilMethod::staircase, 0);
  const NumericIntersections projection = pencil.candidates(curve, SingularPencilMethod::projection, 0);
  CHECK(structure.full_rank == !minors.finite.is_zero());
  Agreement result;
  if (minors.finite.is_zero()) {
    CHECK(staircase.outcome == NumericOutcome::rank_deficient);
    CHECK(projection.outcome == NumericOutcome::rank_deficient);
    return result;
  }
  CHECK(structure.regular_size == minors.finite.degree());
  REQUIRE(staircase.outcome == NumericOutcome::solved);
  REQUIRE(projection.outcome == NumericOutcome::solved);
  CHECK(static_cast<long>(staircase.solutions.size()) == structure.regular_size);
  const std::vector<Root> roots = roots_of(minors);
  result.roots = roots.size();
  for (const NumericIntersections* found : {&staircase, &projection}) {
    for (const NumericIntersection& s : found->solutions) result.all_finite = result.all_finite && is_finite(s);
    for (const Root& root : roots) {
      unsigned long near = 0;
      for (const NumericIntersection& s : found->solutions)
        if (chord(s.t, root.t) < reach(root.multiplicity)) ++near;
      if (near == root.multiplicity) continue;
      ++(found == &staircase ? result.staircase_differs : result.projection_differs);
    }
    for (const NumericIntersection& s : found->solutions) {
      if (s.state != NumericState::converged) continue;
      const bool known = std::any_of(roots.begin(), roots.end(),
                                     [&](const Root& root) { return chord(s.t, root.t) < reach(root.multiplicity); });
      const bool infinite = minors.order_at_infinity > 0 && std::abs(s.t[1]) < reach(2);
      if (!known && !infinite) ++result.invented;
    }
  }
  for (const Root& root : roots)
    if (root.multiplicity == 1) ++result.simple;
  return result;
}

MatrixRepresentation representation(const RationalSurface& surface) {
  if (surface.kind() == Kind::triangular)
    return symbolic::moving_plane_matrix(surface, std::max(1L, symbolic::representation_degree(surface)));
  std::array<long, 2> nu = symbolic::representation_bidegree(surface);
  for (long& degree : nu) degree = std::max(degree, 1L);
  return symbolic::moving_plane_matrix(surface, nu);
}

Polynomial random_biform(Random& random, unsigned long m, unsigned long n, long size) {
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= m; ++i)
    for (unsigned long j = 0; j <= n; ++j) terms.push_back({Rational(random.between(-size, size)), {i, j}});
  return Polynomial::from_terms(2, terms);
}

Polynomial random_form(Random& random, unsigned long d, long size) {
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= d; ++i)
    for (unsigned long j = 0; i + j <= d; ++j)
      terms.push_back({Rational(random.between(-size, size)), {i, j, d - i - j}});
  return Polynomial::from_terms(3, terms);
}

/// Coordinates a p_k + b q_k: the common zeros of a and b are base points.
template <class Draw>
std::vector<Polynomial> through_zeros(const Polynomial& a, const Polynomial& b, const Draw& draw) {
  std::vector<Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) coordinates.push_back(a * draw() + b * draw());
  return coordinates;
}

RationalCurve random_curve(Random& random, long degree, long size) {
  std::vector<symbolic::UnivariatePolynomial> coordinates;
  for (int k = 0; k < 4; ++k) {
    std::vector<symbolic::Integer> coefficients;
    for (long i = 0; i <= degree; ++i) coefficients.emplace_back(random.between(-size, size));
    coordinates.emplace_back(coefficients);
  }
  return RationalCurve(coordinates);
}

/// Surfaces whose matrices are not square, of five families in turn.
RationalSurface random_surface(Random& random, int family) {
  constexpr long size = 9;
  switch (family) {
    case 0: {  // a biquadratic patch with two base points
      const auto draw = [&] { return random_biform(random, 1, 1, size); };
      const Polynomial a = draw();
      return {Kind::tensor_product, through_zeros(a, draw(), draw)};
    }
    case 1: {  // a bicubic patch with two base points
      const Polynomial a = random_biform(random, 1, 1, size);
      const Polynomial b = random_biform(random, 1, 1, size);
      return {Kind::tensor_product, through_zeros(a, b, [&] { return random_biform(random, 2, 2, size); })};
    }
    case 2: {  // a Steiner surface
      std::vector<Polynomial> forms;
      for (int k = 0; k < 4; ++k) forms.push_back(random_form(random, 2, size));
      return {Kind::triangular, forms};
    }
    case 3: {  // a cubic with four base points
      const Polynomial a = random_form(random, 2, size);
      const Polynomial b = random_form(random, 2, size);
      return {Kind::triangular, through_zeros(a, b, [&] { return random_form(random, 1, size); })};
    }
    default: {  // a quadric by quadratic forms through two points of a line
      const Polynomial a = random_form(random, 1, size);
      const Polynomial b = random_form(random, 2, size);
      std::vector<Polynomial> forms;
      for (int k = 0; k < 4; ++k)
        forms.push_back(a * random_form(random, 1, size) + Rational(random.between(-size, size)) * b);
      return {Kind::triangular, forms};
    }
  }
}

}  // namespace

TEST_CASE("Staircase and projection: the eigenvalues of the reference curves and of the paper's examples") {
  for (const nlohmann::json& entry : representation_data().at("curves")) {
    const RationalSurface surface = reference_surface(entry.at("surface"));
    const auto nu = entry.at("nu").get<std::array<long, 2>>();
    const MatrixRepresentation m =
        symbolic::moving_plane_matrix(surface, std::array<long, 2>{std::max(nu[0], 1L), std::max(nu[1], 1L)});
    CAPTURE(entry.at("surface").get<std::string>());
    CAPTURE(entry.at("curve").dump());
    const Agreement agreement = compare(surface, m, curve_of(entry.at("curve")));
    CHECK(agreement.staircase_differs == 0);
    CHECK(agreement.projection_differs == 0);
    CHECK(agreement.invented == 0);
    CHECK(agreement.all_finite);
  }
  for (const nlohmann::json& example : representation_data().at("examples")) {
    const RationalSurface surface =
        surface_map({"s", "t", "u"}, example.at("coordinates").get<std::vector<std::string>>());
    const RationalCurve curve = curve_of(example.at("curve"));
    const MatrixRepresentation m = representation(surface);
    CAPTURE(example.at("example").get<int>());
    CHECK(symbolic::pencil_structure_modulo(m, curve, 0).regular_size ==
          univariate(example.at("minors").get<std::string>()).degree());
    const Agreement agreement = compare(surface, m, curve);
    CHECK(agreement.staircase_differs == 0);
    CHECK(agreement.projection_differs == 0);
    CHECK(agreement.invented == 0);
    CHECK(agreement.all_finite);
  }
}

TEST_CASE("Staircase and projection: random pairs with matrices that are not square") {
  Random random(20090804);
  std::size_t roots = 0;
  for (int i = 0; i < 50; ++i) {
    const RationalSurface surface = random_surface(random, i % 5);
    const RationalCurve curve = random_curve(random, i % 10 < 5 ? 1 : 3, 9);
    const MatrixRepresentation m = representation(surface);
    CAPTURE(i);
    REQUIRE(m.columns() > m.rows());
    const Agreement agreement = compare(surface, m, curve);
    CHECK(agreement.roots > 0);
    CHECK(agreement.staircase_differs == 0);
    CHECK(agreement.projection_differs == 0);
    CHECK(agreement.invented == 0);
    CHECK(agreement.all_finite);
    roots += agreement.roots;
  }
  CHECK(roots == 660);
}

TEST_CASE("Staircase and projection: the same solutions are proven") {
  Random random(7);
  const Context context;
  for (int i = 0; i < 10; ++i) {
    const RationalSurface surface = random_surface(random, i % 5);
    const RationalCurve curve = random_curve(random, i < 5 ? 1 : 3, 9);
    const MatrixRepresentation m = representation(surface);
    const symbolic::ImplicitDegree degree = symbolic::implicit_degree(surface, m, 0);
    REQUIRE(degree.proven);
    REQUIRE(degree.map_degree == 1);
    const auto expected = static_cast<unsigned long>(degree.product * curve.degree());
    const SurfaceInversion inversion(surface, m);
    const SurfacePencil pencil(surface, m, inversion);
    CAPTURE(i);
    for (const SingularPencilMethod method : {SingularPencilMethod::staircase, SingularPencilMethod::projection}) {
      EngineReport report;
      const auto solutions = pencil.solve(curve, expected, {}, context, report, method);
      REQUIRE(solutions.has_value());
      CHECK(solutions->size() == expected);
      CHECK(report.singular_pencil == (method == SingularPencilMethod::staircase ? "staircase" : "projection"));
    }
  }
}
