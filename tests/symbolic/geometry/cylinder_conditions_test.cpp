// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/cylinder_conditions.hpp>

using namespace eliminant::symbolic;
using Kind = CylinderConditions::Kind;
using Points = std::array<SpacePoint, 5>;

namespace {

const std::vector<std::string> xyz{"x", "y", "z"};

Rational value(const Polynomial& form, const SpacePoint& t) {
  Rational sum;
  for (const Polynomial::Term& term : form.terms()) {
    Rational product = term.coefficient;
    for (std::size_t i = 0; i < 3; ++i)
      for (unsigned long e = 0; e < term.exponents[i]; ++e) product = product * t[i];
    sum = sum + product;
  }
  return sum;
}

const Points special{{{0, 0, 0},
                      {1, 1, 0},
                      {1, 0, 1},
                      {0, 1, 1},
                      {Rational(4) / Rational(3), Rational(-1) / Rational(3), Rational(-1) / Rational(3)}}};

}  // namespace

TEST_CASE("Cylinder conditions: a conic and a cubic vanish at the six directions, the conic at no edge") {
  const CylinderConditions conditions = cylinder_conditions(special);
  CHECK(conditions.kind == Kind::general);
  CHECK(conditions.first.total_degree() == 2);
  CHECK(conditions.second.total_degree() == 3);
  const std::vector<SpacePoint> directions{{0, 2, 1}, {0, 1, 2}, {2, 0, -1}, {2, -1, 0}, {-1, 2, 0}, {-1, 0, 2}};
  for (const SpacePoint& t : directions) {
    CHECK(value(conditions.first, t).is_zero());
    CHECK(value(conditions.second, t).is_zero());
  }
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = i + 1; j < 5; ++j)
      CHECK(!value(conditions.first, difference(special[i], special[j])).is_zero());
}

TEST_CASE("Cylinder conditions: an edge that is a direction is a zero of both") {
  const Points on_ruling{{{3, 4, 0}, {3, 4, 7}, {5, 0, 1}, {-4, 3, 2}, {0, -5, -3}}};
  const CylinderConditions conditions = cylinder_conditions(on_ruling);
  CHECK(value(conditions.first, {0, 0, 1}).is_zero());
  CHECK(value(conditions.second, {0, 0, 1}).is_zero());
}

TEST_CASE("Cylinder conditions: the conic does not depend on the order of the points") {
  std::vector<std::size_t> order{0, 1, 2, 3, 4};
  const Polynomial conic = cylinder_conditions(special).first;
  while (std::next_permutation(order.begin(), order.end())) {
    Points permuted;
    for (std::size_t k = 0; k < 5; ++k) permuted[k] = special[order[k]];
    CHECK(cylinder_conditions(permuted).first == conic);
  }
}

TEST_CASE("Cylinder conditions: three points on a line leave a conic without real points but the line") {
  const CylinderConditions conditions = cylinder_conditions({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 2}, {1, 5, 7}}});
  CHECK(conditions.kind == Kind::general);
  CHECK(conditions.first == parse_polynomial("y^2 + z^2", xyz));
}

TEST_CASE("Cylinder conditions: points of a plane on an ellipse") {
  const CylinderConditions conditions =
      cylinder_conditions({{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, -3, 0}, {3, Rational(12) / Rational(5), 0}}});
  CHECK(conditions.kind == Kind::coplanar);
  CHECK(conditions.first.total_degree() == 2);
  CHECK(conditions.second.total_degree() == 2);
  for (const SpacePoint& t : std::vector<SpacePoint>{{4, 0, 3}, {-4, 0, 3}}) {
    CHECK(value(conditions.first, t).is_zero());
    CHECK(value(conditions.second, t).is_zero());
  }
}

TEST_CASE("Cylinder conditions: special positions") {
  const auto kind = [](const Points& points) { return cylinder_conditions(points).kind; };
  const auto reason = [](const Points& points) { return cylinder_conditions(points).reason; };
  CHECK(kind({{{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {2, 4, 0}, {3, 9, 0}}}) == Kind::parabola);
  CHECK(kind({{{0, 1, 0}, {0, 2, 0}, {0, 5, 0}, {1, 0, 0}, {3, 0, 0}}}) == Kind::coplanar);
  CHECK(reason({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 0}, {5, 1, 0}}}) ==
        "all points are in a plane on two parallel lines");
  CHECK(reason({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {7, 0, 0}, {5, 1, 1}}}) ==
        "all points are in a plane, and four of them on a line");
  CHECK(reason({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}}) == "all points are on a line");
  CHECK(reason({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}) == "all points are the same");
  CHECK(reason({{{1, 2, 3}, {1, 2, 3}, {1, 2, 4}, {1, 2, 3}, {1, 2, 3}}}) == "all points are on a line");
  CHECK(reason({{{1, 2, 3}, {1, 2, 3}, {1, 2, 4}, {1, 5, 3}, {1, 2, 3}}}) ==
        "three different points are on infinitely many cylinders");
}

TEST_CASE("Cylinder conditions: four points give a cubic of directions, in a plane a conic") {
  const CylinderConditions in_space = cylinder_conditions({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}});
  CHECK(in_space.kind == Kind::infinite);
  REQUIRE(in_space.directions);
  CHECK(*in_space.directions == parse_polynomial("x^2*y + x^2*z + x*y^2 + x*z^2 + y^2*z + y*z^2", xyz));
  // A square is seen as a rectangle along the directions perpendicular to a side.
  const CylinderConditions square = cylinder_conditions({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}});
  CHECK(square.kind == Kind::infinite);
  REQUIRE(square.directions);
  CHECK(*square.directions == parse_polynomial("x*y", xyz));
}
