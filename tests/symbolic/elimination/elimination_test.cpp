// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/chow_form.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/exact_ranks.hpp>
#include <eliminant/symbolic/elimination/fibre_gcd.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/elimination/solution_profile.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/sylvester_matrix.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

namespace {

const Context context;

UnivariatePolynomial univariate(std::vector<long> coefficients) {
  std::vector<Integer> integers;
  for (const long c : coefficients) integers.emplace_back(c);
  return UnivariatePolynomial(integers);
}

}  // namespace

TEST_CASE("Common component: split off exactly, cofactors coprime") {
  const CommonComponent split = split_common_component(curve("(x-y)*(x^2+y^2-1)"), curve("(x-y)*(x-2)/3"));
  CHECK(split.component == curve("x - y"));
  CHECK(split.first == curve("x^2+y^2-1"));
  CHECK(split.second == curve("x-2"));
  CHECK(split_common_component(curve("x"), curve("y")).component == curve("1"));
  CHECK(split_common_component(curve("0"), curve("2*y-4")).component == curve("y-2"));
  CHECK(split_common_component(curve("0"), curve("0")).component.is_zero());
}

TEST_CASE("Squarefree decomposition: multiplicities, and the product gives the polynomial back") {
  const UnivariatePolynomial p =
      power(univariate({-1, 2}), 3) * power(univariate({1, 0, 1}), 2) * univariate({5, 1}) * univariate({6});
  const auto parts = squarefree_decomposition(p);
  REQUIRE(parts.size() == 3);
  CHECK(parts[0].multiplicity == 1);
  CHECK(parts[0].factor == univariate({5, 1}));
  CHECK(parts[1].factor == univariate({1, 0, 1}));
  CHECK(parts[2].multiplicity == 3);
  CHECK(parts[2].factor == univariate({-1, 2}));
  CHECK(squarefree_decomposition(univariate({7})).empty());
  CHECK_THROWS_AS(squarefree_decomposition(UnivariatePolynomial()), InvalidInput);
}

TEST_CASE("Chow form: is the resultant of the sheared curves, for every admissible shear") {
  Random random(21);
  for (int trial = 0; trial < 25; ++trial) {
    const Polynomial p = random_dense(random, static_cast<unsigned long>(random.between(1, 4)), 9).primitive_part();
    const Polynomial q = random_dense(random, static_cast<unsigned long>(random.between(1, 4)), 9).primitive_part();
    const long s = random.between(-3, 3);
    if (p.total_degree() < 1 || q.total_degree() < 1 || !is_admissible_shear(p, q, s)) continue;
    CAPTURE(text(p));
    CAPTURE(text(q));
    CAPTURE(s);
    const ChowForm chow = chow_form(p, q, s, false, 0, context);
    const HiddenVariablePolynomial f = hide_variable(shear(p, Rational(s)), 0);
    const HiddenVariablePolynomial g = hide_variable(shear(q, Rational(s)), 0);
    // Formal degrees are total degrees: where one restriction loses some, powers of the other's constant leading
    // coefficient come in.
    UnivariatePolynomial expected = resultant(f, g);
    for (long k = g.degree(); k < q.total_degree(); ++k) expected = expected * f.leading_coefficient();
    for (long k = f.degree(); k < p.total_degree(); ++k) expected = expected * g.leading_coefficient();
    CHECK((chow.form == expected || chow.form == UnivariatePolynomial() - expected));
  }
}

TEST_CASE("Chow form: its shear derivative is the limit of difference quotients") {
  // C(t; s) is a polynomial in s of degree at most d e, so differences at many s determine its derivative exactly.
  const Polynomial p = curve("x^2 + 3*x*y - y^2 + x - 2");
  const Polynomial q = curve("2*x*y + y^2 - x + 5");
  const ChowForm at_zero = chow_form(p, q, 0, true, 0, context);
  const auto value = [&](long s) { return chow_form(p, q, s, false, 0, context).form; };
  // Five-point formula, exact for degree <= 4: 12 C'(0) = C(-2) - 8 C(-1) + 8 C(1) - C(2). Signs may differ by shear.
  const auto aligned = [&](long s) {
    UnivariatePolynomial c = value(s);
    // The coefficient of t^4 is the resultant of the leading forms for every s up to the sign chosen for that shear.
    if (c.coefficient(4).sign() != at_zero.form.coefficient(4).sign()) c = UnivariatePolynomial() - c;
    return c;
  };
  const UnivariatePolynomial eight = univariate({8});
  const UnivariatePolynomial difference = aligned(-2) - eight * aligned(-1) + eight * aligned(1) - aligned(2);
  CHECK(difference == univariate({12}) * at_zero.shear_derivative);
}

TEST_CASE("Solution profile: affine count, multiplicities and the smallest separating shear") {
  const auto profile = [](const char* p, const char* q) {
    return solution_profile(curve(p).primitive_part(), curve(q).primitive_part(), 0, context);
  };
  const SolutionProfile one = profile("y^2-x^2+x^3", "y^2-x^3+2x^2-x");
  CHECK(one.with_multiplicity == 6);
  CHECK(one.distinct_by_multiplicity == std::vector<unsigned long>{2, 2});
  CHECK_FALSE(one.bezout_holds);
  CHECK(one.shear == 1);
  const SolutionProfile five = profile("x^9+y^9-1", "x^10+y^10-1");
  CHECK(five.with_multiplicity == 90);
  CHECK(five.distinct() == 74);
  CHECK(five.distinct_by_multiplicity[8] == 2);
  CHECK(five.bezout_holds);
  // More at infinity than the degree of the common leading factor.
  CHECK(profile("(x-y)*(x+2y)-1", "(x-y)*(x+3y)-1").with_multiplicity == 2);
  CHECK(profile("x-1", "x-2").with_multiplicity == 0);
  CHECK(profile("x^2-1", "y^2-1").all_simple());
}

TEST_CASE("Univariate representation: a shear that does not separate is refused") {
  const Polynomial p = curve("x^2-1");
  const Polynomial q = curve("y^2-4");
  // x alone takes each value twice, x + y separates.
  CHECK_FALSE(univariate_representation(p, q, 0, 0, context).has_value());
  const auto representation = univariate_representation(p, q, 1, 0, context);
  REQUIRE(representation.has_value());
  CHECK(representation->distinct() == 4);
  CHECK(representation->with_multiplicity() == 4);
}

TEST_CASE("Univariate representation: separation is proven where both curves are singular") {
  // Two nodes, two cusps, a node on a tacnode: the gcd of a fibre is a power of one linear factor.
  const std::array<std::array<const char*, 2>, 3> systems{
      {{"x*y", "(x-y)*(x+y)"}, {"y^2-x^3", "x^2-y^3"}, {"(x^2+y^2-2)^2", "(x*y-1)^2"}}};
  for (const auto& system : systems) {
    CAPTURE(system[0]);
    const Polynomial p = curve(system[0]);
    const Polynomial q = curve(system[1]);
    const SolutionProfile profile = solution_profile(p, q, 0, context);
    const auto representation = univariate_representation(p, q, profile.shear, 0, context);
    REQUIRE(representation.has_value());
    CHECK(representation->distinct() == profile.distinct());
  }
}

TEST_CASE("Fibre gcd: its degree sum over the roots of a factor") {
  const PrimeField field(PrimeSequence(0).next());
  const HiddenVariablePolynomial f = hide_variable(curve("(y-1)*(y-2)*(y-x)"), 0);
  const HiddenVariablePolynomial g = hide_variable(curve("(y-1)*(y-3+x)*(y+5)"), 0);
  // Above x = 1: gcd (y-1)(y-2) and y = x meets y = 1 once more in f only; above x = 5: y-1; above x = 7: y-1.
  CHECK(fibre_gcd_degree_modulo(f, g, univariate({-1, 1}), field) == 2);
  CHECK(fibre_gcd_degree_modulo(f, g, univariate({-5, 1}), field) == 1);
  CHECK(fibre_gcd_degree_modulo(f, g, univariate({-1, 1}) * univariate({-5, 1}) * univariate({-7, 1}), field) == 4);
  CHECK_FALSE(fibre_gcd_degree_modulo(f, g, power(univariate({-1, 1}), 2), field).has_value());
}

TEST_CASE("Infinite structure: the sizes add up to the missing degree of the determinant") {
  Random random(22);
  for (unsigned long degree = 2; degree <= 5; ++degree) {
    const HiddenVariablePolynomial f = hide_variable(random_dense(random, degree, 30), 0);
    const HiddenVariablePolynomial g = hide_variable(random_dense(random, degree, 30), 0);
    for (const PolynomialMatrix& matrix : {bezout_matrix(f, g), sylvester_matrix(f, g)}) {
      long infinite = 0;
      long previous = matrix.rows();
      for (const long count : infinite_structure_modulo(matrix, 0)) {
        CHECK(count <= previous);
        previous = count;
        infinite += count;
      }
      CHECK(infinite == matrix.rows() * matrix.degree() - determinant(matrix).degree());
    }
  }
  // A dense Bezout matrix of degree d has Jordan blocks of sizes 0, 2, ..., 2 (d - 1) at infinity.
  const PolynomialMatrix dense =
      bezout_matrix(hide_variable(random_dense(random, 4, 30), 0), hide_variable(random_dense(random, 4, 30), 0));
  CHECK(infinite_structure_modulo(dense, 0) == std::vector<long>{3, 3, 2, 2, 1, 1});
}

TEST_CASE("Primes: different, within their interval, and the same for the same seed") {
  PrimeSequence a(5);
  PrimeSequence b(5);
  mp_limb_t previous = 0;
  for (int i = 0; i < 20; ++i) {
    const mp_limb_t prime = a.next();
    CHECK(prime == b.next());
    CHECK(prime > previous);
    CHECK(prime > (1UL << 61U));
    CHECK(prime < (1UL << 62U));
    CHECK(n_is_prime(prime) == 1);
    previous = prime;
  }
}
