// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/base_parameters.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_eliminant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_minors.hpp>
#include <eliminant/symbolic/elimination/surface_overlap.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

using Kind = ComponentKind;
using Texts = std::vector<std::string>;

RationalSurface first_surface(const Texts& coordinates) { return weight_first(coordinates, first_parameters()); }
RationalSurface second_surface(const Texts& coordinates) { return weight_first(coordinates, second_parameters()); }

BezoutianEliminant intersection(const RationalSurface& first, const RationalSurface& second, std::uint64_t seed = 0) {
  return intersection_eliminant(first, second, seed, Context());
}

BezoutianEliminant self_intersection(const RationalSurface& surface, std::uint64_t seed = 0) {
  return self_intersection_eliminant(surface, seed, Context());
}

Polynomial parsed(const std::string& text, const Texts& names) { return parse_polynomial(text, names); }

/// The kind of each factor that is no curve.
using Extraneous = std::map<std::string, Kind>;

/// Components against the list [[factor, multiplicity], ...] of the file: the same factors, the extraneous ones proven
/// and of these kinds, `curve` the product of the others.
void check_components(const BezoutianEliminant& eliminant, const json& factors, const Extraneous& extraneous,
                      const Texts& names) {
  REQUIRE(eliminant.components.size() == factors.size());
  Polynomial curve = Polynomial::constant(2, 1);
  std::size_t not_curves = 0;
  for (const json& entry : factors) {
    const std::string text = entry.at(0);
    CAPTURE(text);
    const Polynomial factor = parsed(text, names).primitive_part();
    const auto place = std::find_if(eliminant.components.begin(), eliminant.components.end(),
                                    [&](const EliminantComponent& component) { return component.factor == factor; });
    REQUIRE(place != eliminant.components.end());
    CHECK(place->multiplicity == entry.at(1).get<unsigned long>());
    const auto expected = extraneous.find(text);
    CHECK(place->kind == (expected == extraneous.end() ? Kind::curve : expected->second));
    if (expected == extraneous.end()) {
      curve = curve * factor;
      CHECK(place->meetings >= 1);
    } else {
      ++not_curves;
      CHECK(place->proven);
    }
  }
  CHECK(not_curves == extraneous.size());
  CHECK(eliminant.curve == curve.primitive_part());
}

const Texts sphere_by_angles{"(u^2 + 1)*(v^2 + 1)", "2v*(1 - u^2)", "4u*v", "(1 - v^2)*(u^2 + 1)"};
const Texts sphere_by_projection{"s^2 + t^2 + 1", "2s", "2t", "s^2 + t^2 - 1"};

}  // namespace

TEST_CASE("Bezoutian eliminant: extraneous factors of quadrics, tori and cones are told by their reason") {
  const std::map<std::string, Extraneous> reasons{
      {"sphere_lonlat x sphere_lonlat shifted (1/2,1/3,0)",
       {{"u^2 + 1", Kind::base_point}, {"t", Kind::base_point}, {"t^2 + 1", Kind::at_infinity}}},
      {"sphere_stereo x sphere_stereo shifted", {{"u^2 + (t^2 + 1)", Kind::at_infinity}}},
      {"sphere_lonlat x plane", {{"u^2 + 1", Kind::base_point}}},
      {"cylinder x cylinder (axes z and x, radii 1, 2/3)", {{"u^2 + 1", Kind::base_point}}},
      {"cylinder x plane", {{"u^2 + 1", Kind::base_point}}},
      {"sphere_lonlat x cylinder shifted",
       {{"u^2 + 1", Kind::base_point}, {"t - 1", Kind::contracted_curve}, {"t + 1", Kind::contracted_curve}}},
      {"torus x plane", {{"u^2 + 1", Kind::base_point}}},
      {"torus x sphere_lonlat shifted",
       {{"u^2 + 1", Kind::base_point}, {"t", Kind::base_point}, {"t^2 + 1", Kind::at_infinity}}},
      {"torus x cylinder", {{"u^2 + 1", Kind::base_point}}},
      {"cone x plane", {{"u^2 + 1", Kind::base_point}, {"u", Kind::at_infinity}}}};
  for (const json& entry : bezoutian_data().at("intersections")) {
    const std::string name = entry.at("name");
    CAPTURE(name);
    if (entry.contains("det")) continue;
    const auto expected = reasons.find(name);
    const BezoutianEliminant eliminant = intersection(weight_first(entry.at("F_weight_first"), first_parameters()),
                                                      weight_first(entry.at("G_weight_first"), second_parameters()));
    CHECK(eliminant.vanishing == DeterminantVanishing::no);
    CHECK(eliminant.size == entry.at("size").get<std::size_t>());
    CHECK(eliminant.rank == eliminant.size);
    check_components(eliminant, entry.at("factors"), expected == reasons.end() ? Extraneous{} : expected->second,
                     kept_parameters());
  }
}

TEST_CASE("Bezoutian eliminant: known self-intersections") {
  const std::map<std::string, Extraneous> reasons{
      {"torus", {{"u^2 + 1", Kind::base_point}, {"v^2 + 1", Kind::at_infinity}, {"v^2 + 3", Kind::base_point}}},
      {"cylinder (2,1)", {{"u^2 + 1", Kind::base_point}}},
      {"cone (2,1)", {{"u^2 + 1", Kind::base_point}, {"v", Kind::base_point}}}};
  for (const json& entry : bezoutian_data().at("self_intersections")) {
    const std::string name = entry.at("name");
    CAPTURE(name);
    if (entry.contains("det")) continue;
    const auto expected = reasons.find(name);
    const BezoutianEliminant eliminant =
        self_intersection(weight_first(entry.at("F_weight_first"), second_parameters()));
    CHECK(eliminant.vanishing == DeterminantVanishing::no);
    CHECK(eliminant.size == entry.at("size").get<std::size_t>());
    check_components(eliminant, entry.at("factors"), expected == reasons.end() ? Extraneous{} : expected->second,
                     first_parameters());
  }
}

TEST_CASE(
    "Bezoutian eliminant: the example of the paper is one irreducible curve, also with a degree declared too high") {
  const json& example = bezoutian_data().at("example");
  const BezoutianEliminant eliminant = self_intersection(weight_first(example.at("coordinates"), second_parameters()));
  REQUIRE(eliminant.components.size() == 1);
  CHECK(eliminant.components.front().meetings == 1);
  CHECK(eliminant.curve == parsed(example.at("determinant"), first_parameters()).primitive_part());
}

TEST_CASE("Bezoutian eliminant: two lifts over each point make the factor double") {
  for (const json& entry : bezoutian_data().at("intersections")) {
    if (entry.at("name") != "cylinder x cylinder (axes z and x, radii 1, 2/3)") continue;
    const BezoutianEliminant eliminant = intersection(weight_first(entry.at("F_weight_first"), first_parameters()),
                                                      weight_first(entry.at("G_weight_first"), second_parameters()));
    CHECK(eliminant.components.back().multiplicity == 2);
    CHECK(eliminant.components.back().meetings == 2);
    CHECK(eliminant.curve == parsed("u^2*t + u^2 + t - 1", kept_parameters()));
  }
}

TEST_CASE("Bezoutian eliminant: a map that covers its surface twice makes the eliminant a square") {
  Random random(34);
  const RationalSurface phi = random_surface(random, 2, 2, true, 9);
  const RationalSurface once = random_surface(random, 1, 2, true, 9);
  std::vector<Polynomial> twice;
  const std::vector<Polynomial> images{power(Polynomial::variable(2, 0), 2), Polynomial::variable(2, 1)};
  for (const Polynomial& coordinate : once.coordinates()) twice.push_back(coordinate.compose(images));
  const BezoutianEliminant eliminant =
      intersection(phi, RationalSurface(RationalSurface::Kind::tensor_product, std::move(twice)));
  REQUIRE(eliminant.components.size() == 1);
  CHECK(eliminant.components.front().multiplicity == 2);
  CHECK(eliminant.components.front().meetings == 2);
  CHECK(eliminant.curve == intersection(phi, once).curve);
}

TEST_CASE("Bezoutian eliminant: Villarceau's circles are two components, a plane of another slope cuts one curve") {
  // The torus of radii 5 and 3 and the planes z = 3 x / 4 and z = 2 x / 3.
  const RationalSurface torus =
      first_surface({"(1 + u^2)*(1 + v^2)", "(1 - u^2)*(8 + 2v^2)", "2u*(8 + 2v^2)", "6v*(1 + u^2)"});
  const BezoutianEliminant circles = intersection(torus, second_surface({"1", "4s", "t", "3s"}));
  std::size_t curves = 0;
  for (const EliminantComponent& component : circles.components)
    if (component.kind == Kind::curve) {
      ++curves;
      CHECK(component.multiplicity == 1);
    } else {
      CHECK(component.kind == Kind::base_point);
      CHECK(component.factor == parsed("u^2 + 1", kept_parameters()));
    }
  CHECK(curves == 2);
  const BezoutianEliminant other = intersection(torus, second_surface({"1", "3s", "t", "2s"}));
  curves = 0;
  for (const EliminantComponent& component : other.components) curves += component.kind == Kind::curve ? 1 : 0;
  CHECK(curves == 1);
}

TEST_CASE("Bezoutian eliminant: a cuspidal edge has no second pair of parameters") {
  // x = u, y = v^2, z = v^3 has a cuspidal edge along v = 0 and does not meet itself elsewhere.
  const BezoutianEliminant edge = self_intersection(second_surface({"1", "s", "t^2", "t^3"}));
  REQUIRE(edge.components.size() == 1);
  CHECK(edge.components.front().kind == Kind::coincident_parameters);
  CHECK(edge.components.front().factor == parsed("v", first_parameters()));
  CHECK(edge.curve == Polynomial::constant(2, 1));
  // With z = v^3 - u^2 v it is a curve of double points (u, v), (u, -v) with v = u and v = -u.
  const BezoutianEliminant crossing = self_intersection(second_surface({"1", "s", "t^2", "t^3 - s^2*t"}));
  CHECK(crossing.curve == parsed("u^2 - v^2", first_parameters()));
}

TEST_CASE("Bezoutian eliminant: a curve that is only at the infinite parameter of one surface is marked") {
  const RationalSurface cylinder = second_surface({"s^2 + 1", "1 - s^2", "2s", "t*(s^2 + 1)"});
  // The plane x = -1 touches along the line s = infinity, v = 0.
  const BezoutianEliminant touching = intersection(first_surface({"1", "-1", "v", "u"}), cylinder);
  REQUIRE(touching.components.size() == 1);
  CHECK(touching.components.front().factor == parsed("u - t", kept_parameters()));
  CHECK(touching.components.front().kind == Kind::curve);
  CHECK(touching.components.front().multiplicity == 2);
  CHECK(touching.components.front().infinite_parameters);
  // Another surface through the line meets the cylinder in a second curve above the same u = t.
  const BezoutianEliminant crossing = intersection(first_surface({"1", "v - 1", "u*v", "u"}), cylinder);
  REQUIRE(crossing.components.size() == 2);
  CHECK(crossing.components.front().kind == Kind::at_infinity);
  CHECK(crossing.components.back().factor == parsed("u - t", kept_parameters()));
  CHECK(crossing.components.back().meetings == 2);
  CHECK_FALSE(crossing.components.back().infinite_parameters);
}

TEST_CASE("Bezoutian eliminant: two spheres that touch in a pole of both keep the point of contact") {
  // Of radius 1 and 2, touching in (0, 0, 1), the pole v = 0 of the first and t = 0 of the second.
  const RationalSurface first = first_surface(sphere_by_angles);
  const RationalSurface second =
      second_surface({"(s^2 + 1)*(t^2 + 1)", "4t*(1 - s^2)", "8s*t", "2*(1 - t^2)*(s^2 + 1) - (s^2 + 1)*(t^2 + 1)"});
  const BezoutianEliminant eliminant = intersection(first, second);
  REQUIRE(eliminant.vanishing == DeterminantVanishing::no);
  CHECK(eliminant.curve == Polynomial::constant(2, 1));
  bool seen = false;
  for (const EliminantComponent& component : eliminant.components)
    if (component.factor == parsed("t", kept_parameters())) {
      seen = true;
      CHECK(component.kind == Kind::contracted_curve);
      CHECK(component.meetings >= 1);
    }
  CHECK(seen);
}

TEST_CASE("Bezoutian eliminant: a bilinear surface does not meet itself") {
  const BezoutianEliminant none = self_intersection(second_surface({"1", "s", "t", "s*t"}));
  CHECK(none.size == 0);
  CHECK(none.determinant == Polynomial::constant(2, 1));
  CHECK(none.components.empty());
  CHECK(none.curve == Polynomial::constant(2, 1));
}

TEST_CASE("Bezoutian eliminant: overlapping surfaces, whatever their parameters") {
  const BezoutianEliminant spheres =
      intersection(first_surface(sphere_by_angles), second_surface(sphere_by_projection));
  CHECK(spheres.determinant.is_zero());
  CHECK(spheres.vanishing == DeterminantVanishing::overlap);
  CHECK(spheres.rank < spheres.size);

  const json& example = bezoutian_data().at("example");
  const RationalSurface surface = weight_first(example.at("coordinates"), second_parameters());
  const BezoutianEliminant same = intersection(surface, surface);
  CHECK(same.vanishing == DeterminantVanishing::overlap);
  CHECK(same.rank == 3);
  // What is left is where the surface meets itself.
  CHECK(same.curve == parsed(example.at("determinant"), first_parameters()).primitive_part());
}

TEST_CASE("Bezoutian eliminant: both surfaces contract a line at infinity to one point") {
  // Two spheres that touch in the centre of both projections, and nowhere else.
  const BezoutianEliminant touching = intersection(first_surface({"u^2 + v^2 + 1", "2u", "2v", "u^2 + v^2 - 1"}),
                                                   second_surface({"s^2 + t^2 + 1", "4s", "4t", "s^2 + t^2 - 3"}));
  CHECK(touching.determinant.is_zero());
  CHECK(touching.vanishing == DeterminantVanishing::contracted);
  for (const EliminantComponent& component : touching.components) CHECK(component.kind != Kind::curve);
  CHECK(touching.curve == Polynomial::constant(2, 1));
}

TEST_CASE("Bezoutian eliminant: maps that cover a surface twice, or only a curve") {
  const BezoutianEliminant twice = self_intersection(first_surface(sphere_by_angles));
  CHECK(twice.vanishing == DeterminantVanishing::many_to_one);
  CHECK(twice.rank == 2);
  CHECK(twice.divisor == parsed("v^2*(u^2 + 1)^2", first_parameters()));
  CHECK(twice.curve == Polynomial::constant(2, 1));

  const BezoutianEliminant once = self_intersection(second_surface(sphere_by_projection));
  CHECK(once.vanishing == DeterminantVanishing::contracted);
  CHECK(once.rank == 2);
  CHECK(once.components.empty());

  const BezoutianEliminant line = self_intersection(first_surface({"1", "u + v", "(u + v)^2", "(u + v)^3"}));
  CHECK(line.vanishing == DeterminantVanishing::no_surface);
}

TEST_CASE("Bezoutian eliminant: a common border of two patches is a point of the projection") {
  // Phi(0, v) = (0, v, v^2) = Psi(v, 1).
  const RationalSurface phi = first_surface({"1", "u", "v", "v^2 + u*v"});
  const RationalSurface psi = second_surface({"1", "(t - 1)*(3 - s)", "s + 2*(t - 1)", "s^2 - (t - 1)^2 + (t - 1)*s"});
  const BezoutianEliminant eliminant = intersection(phi, psi);
  REQUIRE(eliminant.stationary.u.size() == 1);
  REQUIRE(eliminant.stationary.t.size() == 1);
  CHECK(eliminant.stationary.u.front() == UnivariatePolynomial({Integer(0), Integer(1)}));
  CHECK(eliminant.stationary.t.front() == UnivariatePolynomial({Integer(-1), Integer(1)}));
  const std::vector<Polynomial> at{Polynomial::constant(1, Rational(0)), Polynomial::constant(1, Rational(1))};
  CHECK(eliminant.determinant.compose(at).is_zero());
  // Moved away from each other in space there is none.
  const RationalSurface moved =
      second_surface({"1", "(t - 1)*(3 - s)", "s + 2*(t - 1)", "s^2 - (t - 1)^2 + (t - 1)*s + 1"});
  CHECK(intersection(phi, moved).stationary.empty());
  // A common border of equal kind, Phi(0, v) = Psi(0, t), is the line u = 0.
  const BezoutianEliminant line = intersection(phi, second_surface({"1", "s*(t + 2)", "t + s", "t^2 + 5s"}));
  CHECK(line.stationary.empty());
  CHECK(std::any_of(line.components.begin(), line.components.end(), [](const EliminantComponent& component) {
    return component.factor == parsed("u", kept_parameters()) && component.kind == Kind::curve;
  }));
}

TEST_CASE("Bezoutian eliminant: planted common points are on the curve, random surfaces have one component") {
  Random random(31);
  for (const auto& [m, n, other_m, other_n] :
       std::vector<std::array<unsigned long, 4>>{{2, 2, 2, 2}, {1, 2, 2, 1}, {2, 1, 1, 3}})
    for (const bool polynomial : {true, false}) {
      const RationalSurface phi = random_surface(random, m, n, polynomial, 9);
      RationalSurface psi = random_surface(random, other_m, other_n, polynomial, 9);
      // Psi is moved so that Psi(3, -1) = Phi(2, 5).
      const std::vector<Rational> p = phi.at({Rational(2), Rational(5)});
      const std::vector<Rational> q = psi.at({Rational(3), Rational(-1)});
      std::vector<Polynomial> moved = psi.coordinates();
      for (std::size_t k = 0; k < 3; ++k) moved[k] = moved[k] + (p[k] / p[3] - q[k] / q[3]) * moved[3];
      psi = RationalSurface(RationalSurface::Kind::tensor_product, moved);
      const BezoutianEliminant eliminant = intersection(phi, psi);
      REQUIRE(eliminant.components.size() == 1);
      CHECK(eliminant.components.front().kind == Kind::curve);
      CHECK(eliminant.stationary.empty());
      const std::vector<Polynomial> at{Polynomial::constant(1, Rational(2)), Polynomial::constant(1, Rational(-1))};
      CHECK(eliminant.curve.compose(at).is_zero());
      const std::vector<Polynomial> beside{Polynomial::constant(1, Rational(2)), Polynomial::constant(1, Rational(1))};
      CHECK_FALSE(eliminant.curve.compose(beside).is_zero());
    }
}

TEST_CASE("Bezoutian eliminant: for one value of u the matrix over Z[t] has the same roots") {
  Random random(32);
  const RationalSurface phi = random_surface(random, 2, 2, true, 9);
  const RationalSurface psi = random_surface(random, 1, 2, false, 9);
  const SeparatedBezoutian matrix(phi, psi);
  const Polynomial d = bezoutian_determinant(matrix, 0, Context());
  const Rational u = Rational(-2) / Rational(3);
  const std::vector<Polynomial> at{Polynomial::constant(2, u), Polynomial::variable(2, 1)};
  const HiddenVariablePolynomial restricted = hide_variable(d.compose(at), 1);
  CHECK(determinant(matrix.at_first_parameter(u)).primitive_part() == restricted.coefficients.front().primitive_part());
}

TEST_CASE("Bezoutian eliminant: any seed, and cancelled at once") {
  const RationalSurface first = first_surface(sphere_by_angles);
  const RationalSurface second = second_surface({"1", "s", "t", "s + 2t + 1/3"});
  const BezoutianEliminant one = intersection(first, second, 1);
  const BezoutianEliminant other = intersection(first, second, 99);
  CHECK(one.curve == other.curve);
  REQUIRE(one.components.size() == other.components.size());
  for (std::size_t k = 0; k < one.components.size(); ++k) CHECK(one.components[k].kind == other.components[k].kind);
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(intersection_eliminant(first, second, 0, cancelled), LimitReached);
}

TEST_CASE("Bezoutian minors: of a surface with itself their gcd is the determinant of the self-intersection") {
  Random random(33);
  for (const auto& [m, n] : std::vector<std::array<unsigned long, 2>>{{2, 1}, {1, 3}, {2, 2}})
    for (const bool polynomial : {true, false}) {
      const RationalSurface surface = random_surface(random, m, n, polynomial, 9);
      const SeparatedBezoutian matrix(surface, surface);
      const BezoutianMinors minors = bezoutian_minors(matrix, 0, Context());
      CHECK(minors.rank == m * n - 1);
      CHECK(minors.gcd == self_intersection_determinant(matrix, 0, Context()).primitive_part());
    }
}

TEST_CASE("base parameters: common zeros, also at infinity of the other parameter, and none") {
  const auto root_of = [](std::vector<long> ascending) {
    std::vector<Integer> coefficients(ascending.begin(), ascending.end());
    return UnivariatePolynomial(coefficients);
  };
  const RationalSurface sphere = first_surface(sphere_by_angles);
  const Context context;
  CHECK(has_base_point_above(sphere, 0, root_of({1, 0, 1}), context));
  CHECK_FALSE(has_base_point_above(sphere, 0, root_of({2, 0, 1}), context));
  CHECK_FALSE(has_base_point_above(sphere, 0, root_of({0, 1}), context));
  CHECK(has_base_point_above(sphere, 1, root_of({0, 1}), context));
  CHECK_FALSE(has_base_point_above(sphere, 1, root_of({1, 0, 1}), context));
  const RationalSurface at_infinity = first_surface({"1", "u*v", "u^2*v", "u + 1"});
  CHECK(has_base_point_above(at_infinity, 0, root_of({0, 1}), context));
  CHECK_FALSE(has_base_point_above(at_infinity, 0, root_of({-1, 1}), context));
  // Any three coordinates have a common zero above u = 0, all four do not.
  const RationalSurface nearly = first_surface(
      {"v*(v - 1)*(v - 2) + u", "v*(v - 1)*(v - 3)", "v*(v - 2)*(v - 3) + u^2", "(v - 1)*(v - 2)*(v - 3)"});
  CHECK_FALSE(has_base_point_above(nearly, 0, root_of({0, 1}), context));
}

TEST_CASE("surface overlap: equal images of different maps, and surfaces that only touch") {
  const RationalSurface sphere = second_surface(sphere_by_projection);
  CHECK(have_equal_image(first_surface(sphere_by_angles), sphere, 0, Context()));
  CHECK_FALSE(have_equal_image(second_surface({"s^2 + t^2 + 1", "4s", "4t", "s^2 + t^2 - 3"}), sphere, 0, Context()));
  CHECK_THROWS_AS(have_equal_image(first_surface({"1", "u", "u^2", "0*v"}), sphere, 0, Context()), InvalidInput);
}
