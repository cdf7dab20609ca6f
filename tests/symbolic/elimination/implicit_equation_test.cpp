// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/simplex_interpolation.hpp>
#include <eliminant/symbolic/elimination/vanishing.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <support/curves.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

const std::vector<std::string> plane_names{"x", "y", "w"};
const std::vector<std::string> space_names{"x", "y", "z", "w"};

std::string plane_equation(const std::vector<std::string>& coordinates, std::uint64_t seed = 0) {
  return to_string(implicit_equation(curve_map(coordinates), seed, Context()), plane_names);
}

Polynomial equation_of(const RationalSurface& phi, std::uint64_t seed = 0) {
  const MatrixRepresentation m = matrix_representation(phi);
  return implicit_equation(phi, m, implicit_degree(phi, m, seed), seed, Context());
}

/// F(f) written out.
bool vanishes_when_expanded(const Polynomial& f, const RationalSurface& phi) {
  return f.compose(phi.coordinates()).is_zero();
}

}  // namespace

TEST_CASE("simplex interpolation: coefficients from values, in one to three variables") {
  const PrimeField field(PrimeSequence(3).next());
  for (std::size_t dimension = 1; dimension <= 3; ++dimension)
    for (unsigned long degree = 0; degree <= 6; ++degree) {
      const auto lattice = simplex_lattice(dimension, degree);
      CHECK(std::is_sorted(lattice.begin(), lattice.end()));
      std::vector<mp_limb_t> coefficients;
      std::vector<mp_limb_t> origin;
      for (std::size_t i = 0; i < lattice.size(); ++i) coefficients.push_back(mix(degree, i) >> 3U);
      for (std::size_t k = 0; k < dimension; ++k) origin.push_back(mix(99, k) >> 3U);
      std::vector<mp_limb_t> values;
      for (const auto& offset : lattice) {
        mp_limb_t sum = 0;
        for (std::size_t i = 0; i < lattice.size(); ++i) {
          mp_limb_t product = coefficients[i];
          for (std::size_t k = 0; k < dimension; ++k)
            product = field.multiply(product, field.power(field.add(origin[k], offset[k]), lattice[i][k]));
          sum = field.add(sum, product);
        }
        values.push_back(sum);
      }
      CHECK(interpolate_on_simplex(field, origin, degree, values) == coefficients);
    }
}

TEST_CASE("implicit equation: plane curves, also those that the map draws more than once") {
  CHECK(plane_equation({"1+2*t", "3-t", "1"}) == "x + 2*y - 7*w");
  CHECK(plane_equation({"1-t^2", "2*t", "1+t^2"}) == "x^2 + y^2 - w^2");
  CHECK(plane_equation({"t^2", "t^3", "1"}) == "x^3 - y^2*w");
  CHECK(plane_equation({"t^2-1", "t^3-t", "1"}) == "x^3 + x^2*w - y^2*w");
  CHECK(plane_equation({"3*t", "3*t^2", "1+t^3"}) == "x^3 - 3*x*y*w + y^3");
  CHECK(plane_equation({"t^2", "t^4", "1"}) == "x^2 - y*w");
  CHECK(plane_equation({"1-(t^3-t)^2", "2*(t^3-t)", "1+(t^3-t)^2"}) == "x^2 + y^2 - w^2");
  CHECK(plane_equation({"t/2", "t/3", "1"}) == "2*x - 3*y");
  CHECK(plane_equation({"0", "t", "1"}) == "x");
  // The line at infinity.
  CHECK(plane_equation({"t", "1", "0"}) == "w");
}

TEST_CASE("implicit equation: it does not depend on the seed, and vanishes on the curve when written out") {
  Random random(23);
  for (int sample = 0; sample < 6; ++sample) {
    std::vector<std::vector<Rational>> coefficients(3);
    for (auto& coordinate : coefficients)
      for (int i = 0; i <= 3 + sample; ++i)
        coordinate.emplace_back(Integer(random.nonzero(1000)), Integer(random.between(1, 50)));
    const RationalCurve curve = symbolic::rational_curve(coefficients);
    const Polynomial f = implicit_equation(curve, 0, Context());
    CHECK(f.total_degree() == curve.degree());
    CHECK(f == implicit_equation(curve, 77, Context()));
    std::vector<Polynomial> images;
    for (const UnivariatePolynomial& coordinate : curve.coordinates())
      images.push_back(parse_polynomial(text(coordinate), std::vector<std::string>{"t"}));
    CHECK(f.compose(images).is_zero());
  }
}

TEST_CASE("implicit equation: 17 surfaces, those with base points, extraneous planes or covered twice among them") {
  for (const json& entry : representation_data().at("surfaces")) {
    const std::string name = entry.at("name");
    if (name == "bicubic_polynomial") continue;  // below
    CAPTURE(name);
    const RationalSurface phi = surface_of(entry);
    const Polynomial f = equation_of(phi);
    CHECK(f.total_degree() * entry.at("map_degree").get<long>() == entry.at("product_of_degrees"));
    CHECK(vanishes_when_expanded(f, phi));
    CHECK(f == equation_of(phi, 5));
    if (entry.contains("equation")) CHECK(f == form(entry.at("equation").get<std::string>()));
  }
}

TEST_CASE("implicit equation: a bicubic surface of degree 18") {
  const RationalSurface phi = reference_surface("bicubic_polynomial");
  const Polynomial f = equation_of(phi);
  CHECK(f.total_degree() == 18);
  CHECK(f.term_count() > 1000);
  for (long i = 0; i < 20; ++i) {
    const std::vector<Rational> point = phi.at({Rational(7 * i - 30) / Rational(4), Rational(5 - 3 * i) / Rational(7)});
    std::vector<Polynomial> images;
    for (const Rational& coordinate : point) images.push_back(Polynomial::constant(1, coordinate));
    CHECK(f.compose(images).is_zero());
  }
}

TEST_CASE("implicit equation: planes, those at infinity among them") {
  const auto plane = [](const std::vector<std::string>& coordinates) {
    return to_string(equation_of(surface_map({"s", "t"}, coordinates)), space_names);
  };
  CHECK(plane({"s", "t", "0", "1"}) == "z");
  CHECK(plane({"s", "t", "s*t", "0"}) == "w");
  CHECK(plane({"s+t", "s-t", "2*s", "1"}) == "x + y - z");
  CHECK(to_string(equation_of(surface_map({"s", "t", "u"}, {"s", "t", "u", "s+2*t+3*u"})), space_names) ==
        "x + 2*y + 3*z - w");
}

TEST_CASE("vanishing: a proof either way, in the map's own degrees") {
  const RationalSurface sphere = reference_surface("sphere_quadratic");
  CHECK(vanishes_on(form("x^2-y^2-z^2-w^2"), sphere, Context()));
  CHECK(vanishes_on(form("(x^2-y^2-z^2-w^2)*(x+y)"), sphere, Context()));
  CHECK_FALSE(vanishes_on(form("x^2-y^2-z^2+w^2"), sphere, Context()));
  CHECK_FALSE(vanishes_on(form("x"), sphere, Context()));
  CHECK(vanishes_on(form("x^2+y^2+z^2-w^2"), reference_surface("sphere_lonlat_biquadratic"), Context()));
  // Zero at 0, 1, 2, ..., modulo small primes or for huge coefficients, and yet not zero.
  const RationalCurve line = curve_map({"t", "1", "1"});
  const Polynomial product = parse_polynomial("x*(x-y)*(x-2*y)*(x-3*y)", plane_names);
  CHECK_FALSE(vanishes_on(product, line, Context()));
  CHECK_FALSE(vanishes_on(parse_polynomial("10^300*y - 10^300*w + x*10^-300", plane_names), line, Context()));
  CHECK(vanishes_on(parse_polynomial("10^300*y - 10^300*w", plane_names), line, Context()));
  CHECK_THROWS_AS(vanishes_on(parse_polynomial("x + 1", plane_names), line, Context()), InvalidInput);
  CHECK_THROWS_AS(vanishes_on(form("x"), line, Context()), InvalidInput);
}

TEST_CASE("implicit equation: what has none, and what would be too large") {
  CHECK_THROWS_AS(implicit_equation(curve_map({"t", "t^2", "t^3", "1"}), 0, Context()), InvalidInput);
  CHECK_THROWS_AS(implicit_equation(curve_map({"1", "2", "3"}), 0, Context()), InvalidInput);
  CHECK_THROWS_AS(implicit_equation(curve_map({"t^104+1", "t", "1"}), 0, Context()), LimitReached);
  const RationalSurface sphere = reference_surface("sphere_quadratic");
  ImplicitDegree degree;
  degree.minors = 31;
  const MatrixRepresentation m = matrix_representation(sphere);
  CHECK_THROWS_AS(implicit_equation(sphere, m, degree, 0, Context()), LimitReached);
  // A degree that is not that of the minors.
  degree.minors = 4;
  CHECK_THROWS_AS(implicit_equation(sphere, m, degree, 0, Context()), InvalidInput);
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(implicit_equation(curve_map({"t^2", "t", "1"}), 0, cancelled), LimitReached);
}
