// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <map>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/matrices/bezout_matrix.hpp>
#include <eliminant/symbolic/matrices/bezoutian_matrix.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

const std::vector<std::string> self_names{"u", "v", "k", "l"};
const std::vector<std::string> pair_names{"u", "v", "s", "t"};

Polynomial parsed(const std::string& text, const std::vector<std::string>& names) {
  return parse_polynomial(text, names);
}

std::map<std::pair<BezoutianMatrix::Monomial, BezoutianMatrix::Monomial>, Polynomial> by_monomials(
    const BezoutianMatrix& matrix) {
  std::map<std::pair<BezoutianMatrix::Monomial, BezoutianMatrix::Monomial>, Polynomial> result;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      if (!matrix.entry(i, j).is_zero())
        result.emplace(std::pair(matrix.row_monomials()[i], matrix.column_monomials()[j]), matrix.entry(i, j));
  return result;
}

/// The polynomial in four variables with variable i of p in place of `places[i]`.
Polynomial in_four(const Polynomial& p, const std::vector<std::size_t>& places) {
  std::vector<Polynomial::Term> terms;
  for (const Polynomial::Term& term : p.terms()) {
    std::vector<unsigned long> exponents(4, 0);
    for (std::size_t i = 0; i < places.size(); ++i) exponents[places[i]] = term.exponents[i];
    terms.push_back({term.coefficient, exponents});
  }
  return Polynomial::from_terms(4, terms);
}

/// Minus the matrix of Definition 1, in the notation of the surfaces' own matrices: monomials (i, j) for s^i v^j,
/// entries in the two kept variables.
template <class Map>
void check_is_minus(const BezoutianMatrix& definition, const std::vector<std::size_t>& kept, const Map& expected) {
  std::size_t met = 0;
  for (std::size_t i = 0; i < definition.rows(); ++i)
    for (std::size_t j = 0; j < definition.columns(); ++j) {
      if (definition.entry(i, j).is_zero()) continue;
      const auto reversed = [](BezoutianMatrix::Monomial monomial) {
        std::reverse(monomial.begin(), monomial.end());
        return monomial;
      };
      const auto place =
          expected.find({reversed(definition.row_monomials()[i]), reversed(definition.column_monomials()[j])});
      REQUIRE(place != expected.end());
      CHECK(in_four(place->second, kept) == Rational(-1) * definition.entry(i, j));
      ++met;
    }
  CHECK(met == expected.size());
}

Rational value_at(const Polynomial& p, const Rational& x, const Rational& y) {
  const std::vector<Polynomial> images{Polynomial::constant(1, x), Polynomial::constant(1, y)};
  return p.compose(images).constant_term();
}

Rational decimal(const json& text) { return parse_number(text.get<std::string>()); }

/// |sum of row entries times the vector| relative to the sum of absolute values, largest over the rows.
Rational relative_residual(const BezoutianMatrix& matrix, const Rational& x, const Rational& y,
                           const std::vector<Rational>& vector) {
  Rational worst;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    Rational sum;
    Rational size;
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      const Rational product = value_at(matrix.entry(i, j), x, y) * vector[j];
      sum = sum + product;
      size = size + (product.sign() < 0 ? -product : product);
    }
    if (size.is_zero()) continue;
    const Rational ratio = (sum.sign() < 0 ? -sum : sum) / size;
    if (worst < ratio) worst = ratio;
  }
  return worst;
}

std::vector<Rational> monomial_values(const BezoutianMatrix& matrix, const Rational& first, const Rational& second) {
  std::vector<Rational> result;
  for (const BezoutianMatrix::Monomial& monomial : matrix.row_monomials()) {
    Rational value(1);
    for (unsigned long k = 0; k < monomial[0]; ++k) value = value * first;
    for (unsigned long k = 0; k < monomial[1]; ++k) value = value * second;
    result.push_back(value);
  }
  return result;
}

}  // namespace

TEST_CASE("Bezoutian matrix: of two polynomials in one variable it is the Bezout matrix") {
  const std::vector<Polynomial> pair{curve("3x*y^3 - y^2 + x^2 - 4"), curve("y^3 + (x - 1)*y + 7x")};
  const std::vector<std::size_t> eliminated{1};
  const BezoutianMatrix bezoutian = bezoutian_matrix(pair, eliminated);
  const PolynomialMatrix bezout = bezout_matrix(hide_variable(pair[0], 0), hide_variable(pair[1], 0));
  REQUIRE(bezoutian.rows() == 3);
  REQUIRE(bezoutian.columns() == 3);
  CHECK(bezoutian.is_symmetric());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // (f(x) (g(x) - g(y)) - g(x) (f(x) - f(y))) / (x - y) is minus Bezout's quotient.
      Polynomial expected(2);
      const UnivariatePolynomial entry = bezout.entry(static_cast<long>(i), static_cast<long>(j));
      for (long k = 0; k <= entry.degree(); ++k)
        expected = expected - Rational(entry.coefficient(k)) * power(curve("x"), static_cast<unsigned long>(k));
      CHECK(bezoutian.entry(i, j) == expected);
    }
}

TEST_CASE("Bezoutian matrix: of three linear forms it is their determinant, of dependent ones empty") {
  const std::vector<std::string> names{"a", "x", "y"};
  const std::vector<Polynomial> lines{parsed("x + 2y + a", names), parsed("3x - y", names),
                                      parsed("a*x + y + 1", names)};
  const std::vector<std::size_t> eliminated{1, 2};
  const BezoutianMatrix matrix = bezoutian_matrix(lines, eliminated);
  REQUIRE(matrix.rows() == 1);
  // det of (a 1 2; 0 3 -1; 1 a 1), columns constant, x, y.
  CHECK(to_string(matrix.entry(0, 0), names) == "a^2 + 3*a - 7");
  const std::vector<Polynomial> dependent{lines[0], lines[1], lines[0] + lines[1]};
  CHECK(bezoutian_matrix(dependent, eliminated).rows() == 0);
}

TEST_CASE("Bezoutian matrix: without symmetry of the variables it need not be symmetric, and has no zero row") {
  const std::vector<Polynomial> f{curve("x^2*y + x - 3"), curve("x*y^2 - 2y + 1"), curve("x^2 + y + 5x*y")};
  const std::vector<std::size_t> eliminated{0, 1};
  const BezoutianMatrix matrix = bezoutian_matrix(f, eliminated);
  CHECK_FALSE(matrix.is_symmetric());
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    bool zero = true;
    for (std::size_t j = 0; j < matrix.columns(); ++j) zero = zero && matrix.entry(i, j).is_zero();
    CHECK_FALSE(zero);
  }
}

TEST_CASE("Bezoutian matrix: wrong numbers of polynomials and variables are refused") {
  const std::vector<Polynomial> two{curve("x"), curve("y")};
  CHECK_THROWS_AS(bezoutian_matrix(two, std::vector<std::size_t>{0, 1}), InvalidInput);
  CHECK_THROWS_AS(bezoutian_matrix(two, std::vector<std::size_t>{2}), InvalidInput);
}

TEST_CASE("Bezoutian matrix: the example of the paper") {
  const json& example = bezoutian_data().at("example");
  const RationalSurface surface = weight_first(example.at("coordinates"), second_parameters());
  const BezoutianMatrix matrix = self_intersection_bezoutian_matrix(surface);
  REQUIRE(matrix.rows() == 3);
  CHECK(matrix.is_symmetric());
  // Rows here: k, l, lk; in the file: l, k, lk, and minus the matrix.
  const std::array<std::size_t, 3> places{1, 0, 2};
  std::size_t index = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      CHECK(Rational(-1) * matrix.entry(places[i], places[j]) ==
            parsed(example.at("upper_triangle_l_k_lk").at(index++).get<std::string>(), first_parameters()));
  CHECK(Rational(-1) * determinant(matrix) == parsed(example.at("determinant"), first_parameters()));
  for (const json& lift : example.at("lifts")) {
    const std::vector<Rational> vector = monomial_values(matrix, decimal(lift.at("l")), decimal(lift.at("k")));
    CHECK(relative_residual(matrix, decimal(lift.at("u")), decimal(lift.at("v")), vector) < parse_number("1e-25"));
  }
}

TEST_CASE("Bezoutian matrix: minus Definition 1 for polynomial surfaces, intersection and self-intersection") {
  Random random(5);
  for (const auto& [m, n, other_m, other_n] :
       std::vector<std::array<unsigned long, 4>>{{1, 1, 1, 1}, {2, 2, 2, 2}, {1, 2, 3, 1}, {2, 3, 1, 2}}) {
    const RationalSurface phi = random_surface(random, m, n, true, 9);
    const RationalSurface psi = random_surface(random, other_m, other_n, true, 9);
    std::vector<Polynomial> differences;
    for (std::size_t k = 0; k < 3; ++k)
      differences.push_back(in_four(phi.coordinates()[k], {0, 1}) - in_four(psi.coordinates()[k], {2, 3}));
    const BezoutianMatrix matrix = intersection_bezoutian_matrix(phi, psi);
    CHECK(matrix.rows() == n * other_m);
    CHECK(matrix.is_symmetric());
    check_is_minus(bezoutian_matrix(differences, std::vector<std::size_t>{1, 2}), {0, 3}, by_monomials(matrix));

    differences.clear();
    const Polynomial u = parsed("u", self_names), v = parsed("v", self_names);
    const std::vector<Polynomial> along_v{u, parsed("v + k", self_names)};
    const std::vector<Polynomial> along_u{parsed("u + l", self_names), v};
    for (std::size_t k = 0; k < 3; ++k)
      differences.push_back(phi.coordinates()[k].compose(along_v) - phi.coordinates()[k].compose(along_u));
    if (m * n == 1) continue;
    const BezoutianMatrix self = self_intersection_bezoutian_matrix(phi);
    CHECK(self.rows() == m * n - 1);
    CHECK(self.is_symmetric());
    check_is_minus(bezoutian_matrix(differences, std::vector<std::size_t>{2, 3}), {0, 1}, by_monomials(self));
  }
}

TEST_CASE("Bezoutian matrix: sizes of all bidegrees of the paper, and symmetry") {
  Random random(6);
  for (const json& entry : bezoutian_data().at("degrees")) {
    const long theorem = entry.at("theorem");
    const auto [m, n] = entry.at("bidegree").get<std::array<unsigned long, 2>>();
    if (m * n > 6) continue;  // the determinants of these are tested beside the elimination
    const bool polynomial = theorem % 2 == 0;
    const RationalSurface phi = random_surface(random, m, n, polynomial, 9);
    const BezoutianMatrix matrix = theorem < 4
                                       ? intersection_bezoutian_matrix(phi, random_surface(random, m, n, polynomial, 9))
                                       : self_intersection_bezoutian_matrix(phi);
    CHECK(matrix.rows() == entry.at("size").get<std::size_t>());
    CHECK(matrix.is_symmetric());
  }
}

TEST_CASE("Bezoutian matrix: the eliminated parameters are in the kernel where the surfaces meet") {
  std::size_t checked = 0;
  for (const json& entry : bezoutian_data().at("lifts")) {
    const long theorem = entry.at("theorem");
    CAPTURE(theorem);
    const bool self = theorem > 3;
    const RationalSurface phi = weight_first(entry.at("first"), self ? second_parameters() : first_parameters());
    const BezoutianMatrix matrix =
        self ? self_intersection_bezoutian_matrix(phi)
             : intersection_bezoutian_matrix(phi, weight_first(entry.at("second"), second_parameters()));
    const Rational kept = parse_number(entry.at("second_kept").get<std::string>());
    for (const json& lift : entry.at("lifts")) {
      const auto part = [&](const char* name, std::size_t k) { return decimal(lift.at(name).at(k)); };
      const Rational tiny = parse_number("1e-25");
      if (!(part("u", 1) < tiny) || !(-tiny < part("u", 1))) continue;
      const std::vector<Rational> vector = self ? monomial_values(matrix, part("l", 0), part("k", 0))
                                                : monomial_values(matrix, part("s", 0), part("v", 0));
      CHECK(relative_residual(matrix, part("u", 0), kept, vector) < parse_number("1e-20"));
      ++checked;
    }
  }
  CHECK(checked >= 30);
}

TEST_CASE("separated Bezoutian: the same matrix from lines, also for one value of the first parameter") {
  Random random(7);
  for (const bool polynomial : {true, false}) {
    const RationalSurface phi = random_surface(random, 2, 3, polynomial, 9);
    const RationalSurface psi = random_surface(random, 2, 1, polynomial, 9);
    const BezoutianMatrix matrix = intersection_bezoutian_matrix(phi, psi);
    const SeparatedBezoutian separated(phi, psi);
    REQUIRE(separated.size() == matrix.rows());
    const Rational u = Rational(3) / Rational(7);
    const PolynomialMatrix at_u = separated.at_first_parameter(u);
    const Rational scale(7L * 7 * 7 * 7);  // the lines have degree 4 in u
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.rows(); ++j) {
        Rational value;
        Rational power(1);
        const UnivariatePolynomial entry = at_u.entry(static_cast<long>(i), static_cast<long>(j));
        for (long k = 0; k <= entry.degree(); ++k) {
          value = value + Rational(entry.coefficient(k)) * power;
          power = power * Rational(5);
        }
        CHECK(value == scale * value_at(matrix.entry(i, j), u, Rational(5)));
      }
  }
}

TEST_CASE("Bezoutian matrix: a bilinear surface does not meet itself, triangles and curves are refused") {
  Random random(8);
  const RationalSurface bilinear = random_surface(random, 1, 1, false, 9);
  CHECK(self_intersection_bezoutian_matrix(bilinear).rows() == 0);
  CHECK(determinant(self_intersection_bezoutian_matrix(bilinear)) == Polynomial::constant(2, 1));
  const RationalSurface line = weight_first(std::vector<std::string>{"1", "u", "u^2", "0"}, first_parameters());
  CHECK_THROWS_AS(intersection_bezoutian_matrix(line, bilinear), InvalidInput);
  CHECK_THROWS_AS(self_intersection_bezoutian_matrix(line), InvalidInput);
  CHECK_THROWS_AS(SeparatedBezoutian(line, bilinear), InvalidInput);
}
