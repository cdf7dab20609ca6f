// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <support/text_surfaces.hpp>

#include <eliminant/symbolic/elimination/rational_inversion.hpp>

using namespace eliminant::symbolic;
using eliminant::test::map_of;

namespace {

/// Quotients and equation hold for all parameters.
void check_identities(const RationalSurface& map, const RationalInversion& inversion) {
  CHECK(inversion.equation.compose(map.coordinates()).is_zero());
  for (const std::size_t k : {0U, 1U}) {
    REQUIRE_FALSE(inversion.parameters[k].empty());
    for (const ParameterQuotient& q : inversion.parameters[k])
      CHECK(q.numerator.compose(map.coordinates()) ==
            Polynomial::variable(2, k) * q.denominator.compose(map.coordinates()));
  }
}

}  // namespace

TEST_CASE("Rational inversion: planes, a cylinder and quadrics by lines are inverted everywhere") {
  const std::vector<std::vector<std::string>> maps{{"u", "v", "u + 2*v", "1"},
                                                   {"1 - u^2", "2*u", "v*(u^2 + 1)", "u^2 + 1"},
                                                   {"u", "v", "u*v", "1"},
                                                   {"u + v", "u - v", "1 - u*v", "1 + u*v"},
                                                   {"u", "v", "u^3 - 3*u*v^2", "1"}};
  for (const auto& texts : maps) {
    CAPTURE(texts[2]);
    const RationalSurface map = map_of(texts);
    const auto inversion = rational_inversion(map);
    REQUIRE(inversion);
    check_identities(map, *inversion);
    CHECK(inversion->is_inverse_everywhere());
  }
}

TEST_CASE("Rational inversion: the pole of a sphere, the apex of a cone and a double line have no witness") {
  struct Case {
    std::vector<std::string> map;
    std::array<long, 4> point;
    std::array<long, 4> other;
  };
  const std::vector<Case> cases{
      {{"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"}, {0, 0, 1, 1}, {0, 0, -1, 1}},
      {{"v*(1 - u^2)", "2*u*v", "v*(u^2 + 1)", "u^2 + 1"}, {0, 0, 0, 1}, {1, 0, 1, 1}},
      {{"u", "u*v", "v^2", "1"}, {0, 0, 4, 1}, {1, 2, 4, 1}},
  };
  for (const auto& [texts, point, other] : cases) {
    CAPTURE(texts[2]);
    const RationalSurface map = map_of(texts);
    const auto inversion = rational_inversion(map);
    REQUIRE(inversion);
    check_identities(map, *inversion);
    const auto has_witness = [&](const std::array<long, 4>& at) {
      std::vector<Polynomial> values;
      for (const long x : at) values.push_back(Polynomial::constant(1, x));
      bool found = false;
      for (const Polynomial& witness : inversion->witnesses) found = found || !witness.compose(values).is_zero();
      return found;
    };
    CHECK_FALSE(has_witness(point));
    CHECK(has_witness(other));
  }
}

TEST_CASE("Rational inversion: a torus by quadratic forms") {
  const RationalSurface torus = map_of({"(1-u^2)*(v^2+3)", "2*u*(v^2+3)", "2*v*(u^2+1)", "(u^2+1)*(v^2+1)"});
  const auto inversion = rational_inversion(torus);
  REQUIRE(inversion);
  check_identities(torus, *inversion);
  CHECK(inversion->equation.total_degree() == 4);
  for (const auto& quotients : inversion->parameters)
    for (const ParameterQuotient& q : quotients) CHECK(q.numerator.total_degree() == 2);
  // On the outer, upper and inner circle one of them is not zero.
  for (const std::array<long, 4>& at : {std::array<long, 4>{3, 0, 0, 1}, {0, 2, 1, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}}) {
    std::vector<Polynomial> values;
    for (const long x : at) values.push_back(Polynomial::constant(1, x));
    CHECK(inversion->equation.compose(values).is_zero());
    CHECK(std::any_of(inversion->witnesses.begin(), inversion->witnesses.end(),
                      [&](const Polynomial& witness) { return !witness.compose(values).is_zero(); }));
  }
}

TEST_CASE("Rational inversion: whether points without a witness are images of lines") {
  const auto are_lines = [](const std::vector<std::string>& map) {
    const auto inversion = rational_inversion(map_of(map));
    REQUIRE(inversion);
    return inversion->exceptions_are_lines;
  };
  CHECK(are_lines({"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"}));
  CHECK(are_lines({"v*(1 - u^2)", "2*u*v", "v*(u^2 + 1)", "u^2 + 1"}));
  CHECK(are_lines({"u", "v", "u*v", "1"}));
  // Where z < 0 the double line of Whitney's umbrella has no real parameters.
  CHECK_FALSE(are_lines({"u", "u*v", "v^2", "1"}));
}

TEST_CASE("Rational inversion: maps that cover their image twice, and parameters of higher degree, have none") {
  CHECK_FALSE(rational_inversion(map_of({"2*v*(1 - u^2)", "4*u*v", "(1 - v^2)*(u^2 + 1)", "(u^2 + 1)*(v^2 + 1)"})));
  CHECK_FALSE(rational_inversion(map_of({"u^2", "v", "u^2 + v", "1"})));
}
