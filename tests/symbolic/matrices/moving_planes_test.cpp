// SPDX-License-Identifier: BSD-3-Clause
//
// Against tests/data/matrix_representations.json: sizes, ranks and minors of 17 surfaces, the examples of
// [LuuBuseMourrain2009].
#include <doctest/doctest.h>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>
#include <support/curves.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

MatrixRepresentation matrix_of(const RationalSurface& surface, const json& nu) {
  if (nu.is_array()) return moving_plane_matrix(surface, nu.get<std::array<long, 2>>());
  return moving_plane_matrix(surface, nu.get<long>());
}

/// The column of the coefficients of linear forms in x, y, z, w, one form for each row, in the order of `m`.
IntegerMatrix with_column(const MatrixRepresentation& m, const std::vector<std::string>& forms,
                          const std::vector<std::string>& monomials) {
  IntegerMatrix columns(4 * m.rows(), m.columns() + (forms.empty() ? 0 : 1));
  for (long k = 0; k < 4; ++k)
    for (long i = 0; i < m.rows(); ++i)
      for (long j = 0; j < m.columns(); ++j)
        fmpz_set(columns.entry(k * m.rows() + i, j), m.coefficients[static_cast<std::size_t>(k)].entry(i, j));
  for (std::size_t row = 0; row < forms.size(); ++row) {
    const Polynomial monomial = parse_polynomial(monomials[row], std::vector<std::string>{"s", "t", "u"});
    long i = 0;
    while (m.row_monomials[static_cast<std::size_t>(i)] != monomial.terms().front().exponents) ++i;
    for (const Polynomial::Term& term : form(forms[row]).terms())
      for (std::size_t k = 0; k < 4; ++k)
        if (term.exponents[k] == 1) {
          // form() has divided a sign out: parse again.
          const Polynomial exact = parse_polynomial(forms[row], std::vector<std::string>{"x", "y", "z", "w"});
          for (const Polynomial::Term& own : exact.terms())
            if (own.exponents[k] == 1)
              fmpz_set(columns.entry(static_cast<long>(k) * m.rows() + i, m.columns()),
                       own.coefficient.numerator().get());
        }
  }
  return columns;
}

std::vector<Rational> random_point(Random& random, std::size_t count) {
  std::vector<Rational> point;
  for (std::size_t k = 0; k < count; ++k)
    point.emplace_back(Integer(random.nonzero(30)), Integer(random.between(1, 9)));
  return point;
}

/// S(curve) = 0 in (1 : t), primitive.
UnivariatePolynomial substituted(const std::string& equation, const RationalCurve& curve) {
  std::vector<Polynomial> images;
  for (const UnivariatePolynomial& f : curve.coordinates())
    images.push_back(parse_polynomial(text(f), std::vector<std::string>{"t"}));
  const Polynomial value = form(equation).compose(images);
  if (value.is_zero()) return {};
  return univariate(to_string(value, std::vector<std::string>{"t"}));
}

}  // namespace

TEST_CASE("moving planes: sizes and ranks of 17 surfaces in every degree listed") {
  Random random(17);
  for (const json& entry : representation_data().at("surfaces")) {
    const RationalSurface phi = surface_of(entry);
    for (const json& expected : entry.at("matrices")) {
      CAPTURE(entry.at("name").get<std::string>());
      CAPTURE(expected.at("nu").dump());
      const MatrixRepresentation m = matrix_of(phi, expected.at("nu"));
      CHECK(m.rows() == expected.at("rows"));
      CHECK(m.columns() == expected.at("columns"));
      CHECK(m.row_monomials.size() == expected.at("rows"));
      if (!expected.contains("rank_on")) continue;
      for (int sample = 0; sample < 3; ++sample) {
        const auto parameters = random_point(random, entry.at("parameters").size());
        CHECK(value_at(m, phi.at(parameters)).rank() == expected.at("rank_on"));
        CHECK(value_at(m, random_point(random, 4)).rank() == expected.at("rank_off"));
      }
      CHECK(generic_rank_modulo(m, 1) == expected.at("rank_off"));
      CHECK(rank_on_modulo(m, phi, 1) == expected.at("rank_on"));
    }
  }
}

TEST_CASE("moving planes: the gcd of the maximal minors on a test line, and the degrees it proves") {
  const Context context;
  for (const json& entry : representation_data().at("surfaces")) {
    const RationalSurface phi = surface_of(entry);
    const RationalCurve line = curve_of(entry.at("test_line"));
    for (const json& expected : entry.at("matrices")) {
      if (!expected.contains("minors_degree")) continue;
      CAPTURE(entry.at("name").get<std::string>());
      CAPTURE(expected.at("nu").dump());
      const MatrixRepresentation m = matrix_of(phi, expected.at("nu"));
      const ParameterForm minors = minors_on_curve(m, line, 0, context);
      CHECK(minors.degree() == expected.at("minors_degree"));
      CHECK(minors_degree_modulo(m, line, 0) == minors.finite.degree());
      if (expected.contains("minors_on_test_line")) {
        CHECK(text(minors.finite) == text(univariate(expected.at("minors_on_test_line").get<std::string>())));
        CHECK(minors.order_at_infinity == 0);
      }
      const ImplicitDegree degree = implicit_degree(phi, m, 0);
      CHECK(degree.product == entry.at("product_of_degrees"));
      CHECK(degree.minors == expected.at("minors_degree"));
      CHECK(degree.proven == (degree.product == degree.minors));
      CHECK(degree.map_degree == entry.at("map_degree"));
    }
  }
}

TEST_CASE("moving planes: the degree that is chosen is the least one listed that represents the surface") {
  for (const json& entry : representation_data().at("surfaces")) {
    CAPTURE(entry.at("name").get<std::string>());
    const RationalSurface phi = surface_of(entry);
    std::vector<json> admissible;
    for (const json& expected : entry.at("matrices"))
      if (!expected.at("below_bound").get<bool>()) admissible.push_back(expected.at("nu"));
    if (phi.kind() == RationalSurface::Kind::triangular) {
      long least = admissible.front().get<long>();
      for (const json& nu : admissible) least = std::min(least, nu.get<long>());
      // The cubic surface through six points has a smaller matrix than the bound says.
      const long chosen = representation_degree(phi);
      CHECK(chosen >= least);
      CHECK(chosen <= 2 * (phi.degree() - 1));
    } else {
      const json chosen = representation_bidegree(phi);
      CHECK(std::find(admissible.begin(), admissible.end(), chosen) != admissible.end());
    }
    const MatrixRepresentation m = matrix_representation(phi);
    CHECK(generic_rank_modulo(m, 3) == m.rows());
    CHECK(m.rows() - rank_on_modulo(m, phi, 3) == entry.at("map_degree"));
  }
  // The bounds of the paper, base points included.
  CHECK(representation_degree(reference_surface("ex1_cubic")) == 2);
  CHECK(representation_degree(reference_surface("sphere_quadratic")) == 1);
  CHECK(representation_degree(reference_surface("steiner_roman")) == 2);
  CHECK(representation_degree(reference_surface("cubic_generic")) == 4);
}

TEST_CASE("moving planes: the matrices printed in the paper are spanned by the columns") {
  for (const json& example : representation_data().at("examples")) {
    if (!example.contains("matrix")) continue;
    CAPTURE(example.at("example").get<int>());
    const RationalSurface phi = surface_map({"s", "t", "u"}, example.at("coordinates").get<std::vector<std::string>>());
    const MatrixRepresentation m = matrix_representation(phi);
    const json& printed = example.at("matrix");
    REQUIRE(static_cast<long>(printed.size()) == m.rows());
    REQUIRE(static_cast<long>(printed.front().size()) == m.columns());
    CHECK(with_column(m, {}, {}).rank() == m.columns());
    for (std::size_t column = 0; column < printed.front().size(); ++column) {
      std::vector<std::string> forms;
      for (const json& row : printed) forms.push_back(row.at(column).get<std::string>());
      CHECK(with_column(m, forms, example.at("row_monomials").get<std::vector<std::string>>()).rank() == m.columns());
    }
  }
}

TEST_CASE("moving planes: Examples 1 to 3, the surface on the curve with multiplicities") {
  const Context context;
  for (const json& example : representation_data().at("examples")) {
    CAPTURE(example.at("example").get<int>());
    const RationalSurface phi = surface_map({"s", "t", "u"}, example.at("coordinates").get<std::vector<std::string>>());
    const RationalCurve psi = curve_of(example.at("curve"));
    const MatrixRepresentation m = matrix_representation(phi);
    const ParameterForm minors = minors_on_curve(m, psi, 0, context);
    CHECK(text(minors.finite) == text(univariate(example.at("minors").get<std::string>())));
    const ImplicitDegree degree = implicit_degree(phi, m, 0);
    const auto exact = surface_on_curve(m, degree, psi, minors, 0, context);
    REQUIRE(exact);
    CHECK(text(exact->finite) == text(univariate(example.at("surface_on_curve").get<std::string>())));
    CHECK(text(exact->finite) == text(substituted(example.at("equation").get<std::string>(), psi)));
    CHECK(exact->order_at_infinity == example.at("at_infinity"));
    CHECK(exact->degree() == degree.product * psi.degree());
  }
}

TEST_CASE("moving planes: eleven curves on a torus, a cylinder, a cone and a sphere covered twice") {
  const Context context;
  for (const json& test : representation_data().at("curves")) {
    const std::string name = test.at("surface");
    CAPTURE(name);
    CAPTURE(test.at("note").get<std::string>());
    const RationalSurface phi = reference_surface(name);
    const RationalCurve psi = curve_of(test.at("curve"));
    const MatrixRepresentation m = matrix_of(phi, test.at("nu"));
    const ParameterForm minors = minors_on_curve(m, psi, 0, context);
    const std::string expected = test.at("minors");
    if (expected == "0") {
      CHECK(minors.finite.is_zero());
      continue;
    }
    CHECK(text(minors.finite) == text(univariate(expected)));
    const ImplicitDegree degree = implicit_degree(phi, m, 0);
    const auto exact = surface_on_curve(m, degree, psi, minors, 0, context);
    REQUIRE(exact);
    UnivariatePolynomial once = univariate(test.at("surface_on_curve").get<std::string>());
    CHECK(text(exact->finite) == text(power(once, static_cast<unsigned long>(degree.map_degree))));
    CHECK(exact->degree() == degree.product * psi.degree());
  }
}

TEST_CASE("moving planes: the numbers of docs/matrix-representations.md") {
  const RationalSurface sphere = reference_surface("sphere_quadratic");
  const MatrixRepresentation m = matrix_representation(sphere);
  CHECK(sphere.at({1, 2, 3}) == std::vector<Rational>{14, 6, 4, -12});
  const IntegerMatrix value = value_at(m, {14, 6, 4, -12});
  CHECK(value.rank() == 2);
  const std::array<std::array<long, 4>, 3> printed{{{0, -26, -4, -6}, {-6, 4, 2, 0}, {4, 6, 0, 2}}};
  for (long i = 0; i < 3; ++i)
    for (long j = 0; j < 4; ++j)
      CHECK(fmpz_equal_si(value.entry(i, j), printed[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) != 0);
  CHECK(value_at(m, {1, 0, 0, -1}).rank() == 1);
  // The maximal minors at a random point: -y Q, -z Q, -(x + w) Q and 0.
  const Rational x = 3, y = -5, z = 7, w = 11;
  const Rational q = x * x - y * y - z * z - w * w;
  const IntegerMatrix general = value_at(m, {x, y, z, w});
  const std::array<Rational, 4> minors{-(x + w) * q, Rational(0), -y * q, -z * q};
  for (long omitted = 0; omitted < 4; ++omitted) {
    IntegerMatrix square(3, 3);
    for (long i = 0; i < 3; ++i)
      for (long j = 0; j < 3; ++j) fmpz_set(square.entry(i, j), general.entry(i, j < omitted ? j : j + 1));
    Integer determinant;
    fmpz_mat_det(determinant.get(), square.get());
    CHECK(Rational(determinant) == minors[static_cast<std::size_t>(omitted)]);
  }
}

TEST_CASE("moving planes: what is no degree of the surface is refused") {
  CHECK_THROWS_AS(moving_plane_matrix(reference_surface("torus_2_1"), 3), InvalidInput);
  CHECK_THROWS_AS(moving_plane_matrix(reference_surface("ex1_cubic"), std::array<long, 2>{1, 1}), InvalidInput);
  CHECK_THROWS_AS(moving_plane_matrix(reference_surface("ex1_cubic"), -1), InvalidInput);
  CHECK_THROWS_AS(moving_plane_matrix(reference_surface("torus_2_1"), std::array<long, 2>{0, -1}), InvalidInput);
  const MatrixRepresentation few = moving_plane_matrix(reference_surface("ex1_cubic"), 1);
  CHECK_THROWS_AS(implicit_degree(reference_surface("ex1_cubic"), few, 0), InvalidInput);
  CHECK_THROWS_AS(value_at(few, {1, 2, 3}), InvalidInput);
}
