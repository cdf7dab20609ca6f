// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/matrices/bezoutian_matrix.hpp>
#include <support/bezoutian_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

Polynomial intersection(const RationalSurface& first, const RationalSurface& second, std::uint64_t seed = 0) {
  return bezoutian_determinant(SeparatedBezoutian(first, second), seed, Context());
}

Polynomial self_intersection(const RationalSurface& surface, std::uint64_t seed = 0) {
  return self_intersection_determinant(SeparatedBezoutian(surface, surface), seed, Context());
}

/// The product of the factors of a list [[text, exponent], ...].
Polynomial product_of(const json& factors, const std::vector<std::string>& names) {
  Polynomial product = Polynomial::constant(2, 1);
  for (const json& factor : factors)
    product = product * power(parse_polynomial(factor.at(0).get<std::string>(), names), factor.at(1));
  return product;
}

}  // namespace

TEST_CASE("Bezoutian determinant: interpolation and expansion agree, with the sign") {
  Random random(21);
  for (const auto& [m, n, other_m, other_n] :
       std::vector<std::array<unsigned long, 4>>{{1, 1, 1, 1}, {2, 1, 1, 2}, {2, 2, 2, 2}, {1, 3, 1, 2}, {3, 1, 2, 2}})
    for (const bool polynomial : {true, false}) {
      const RationalSurface phi = random_surface(random, m, n, polynomial, 99);
      const RationalSurface psi = random_surface(random, other_m, other_n, !polynomial, 99);
      CHECK(intersection(phi, psi) == determinant(intersection_bezoutian_matrix(phi, psi)));
      CHECK(self_intersection(phi) == determinant(self_intersection_bezoutian_matrix(phi)));
    }
}

TEST_CASE("Bezoutian determinant: coefficients of hundreds of bits, and any seed") {
  Random random(22);
  const RationalSurface phi = random_surface(random, 2, 2, false, 1L << 60U);
  const RationalSurface psi = random_surface(random, 1, 2, false, 1L << 60U);
  const Polynomial d = intersection(phi, psi);
  CHECK(d == determinant(intersection_bezoutian_matrix(phi, psi)));
  CHECK(d == intersection(phi, psi, 12345));
}

TEST_CASE("Bezoutian determinant: degrees of all bidegrees of the paper") {
  Random random(23);
  for (const json& entry : bezoutian_data().at("degrees")) {
    const long theorem = entry.at("theorem");
    const auto [m, n] = entry.at("bidegree").get<std::array<unsigned long, 2>>();
    CAPTURE(theorem);
    CAPTURE(m);
    CAPTURE(n);
    const bool polynomial = theorem % 2 == 0;
    const RationalSurface phi = random_surface(random, m, n, polynomial, 99);
    const Polynomial d =
        theorem < 4 ? intersection(phi, random_surface(random, m, n, polynomial, 99)) : self_intersection(phi);
    CHECK(d.degree(0) == entry.at("determinant").at(0).get<long>());
    CHECK(d.degree(1) == entry.at("determinant").at(1).get<long>());
    CHECK(d.total_degree() == entry.at("determinant").at(2).get<long>());
  }
}

TEST_CASE("Bezoutian determinant: the example of the paper") {
  const json& example = bezoutian_data().at("example");
  const Polynomial d = self_intersection(weight_first(example.at("coordinates"), second_parameters()));
  CHECK(Rational(-1) * d == parse_polynomial(example.at("determinant").get<std::string>(), first_parameters()));
  CHECK(d.term_count() == 97);
  CHECK(d.degree(0) == 10);
  CHECK(d.degree(1) == 10);
  CHECK(d.total_degree() == 14);
}

TEST_CASE("Bezoutian determinant: quadrics, tori and others have the known factors") {
  for (const json& entry : bezoutian_data().at("intersections")) {
    const std::string name = entry.at("name");
    CAPTURE(name);
    const RationalSurface first = weight_first(entry.at("F_weight_first"), first_parameters());
    const RationalSurface second = weight_first(entry.at("G_weight_first"), second_parameters());
    const SeparatedBezoutian matrix(first, second);
    CHECK(matrix.size() == entry.at("size").get<std::size_t>());
    const Polynomial d = bezoutian_determinant(matrix, 0, Context());
    if (entry.contains("det")) {
      CHECK(d.is_zero());
      CHECK(generic_rank_modulo(matrix, 0).rank == entry.at("generic_rank").get<std::size_t>());
      continue;
    }
    CHECK(d.primitive_part() == product_of(entry.at("factors"), kept_parameters()).primitive_part());
    CHECK(d.degree(0) == entry.at("degrees_u_t").at(0).get<long>());
    CHECK(d.degree(1) == entry.at("degrees_u_t").at(1).get<long>());
  }
}

TEST_CASE("Bezoutian determinant: known self-intersections") {
  for (const json& entry : bezoutian_data().at("self_intersections")) {
    const std::string name = entry.at("name");
    CAPTURE(name);
    const RationalSurface surface = weight_first(entry.at("F_weight_first"), second_parameters());
    const SeparatedBezoutian matrix(surface, surface);
    const auto [m, n] = entry.at("bidegree").get<std::array<long, 2>>();
    if (surface.bidegree() != std::array<long, 2>{m, n}) continue;  // a degree declared too high: its own test
    const Polynomial d = self_intersection_determinant(matrix, 0, Context());
    CHECK(d == determinant(self_intersection_bezoutian_matrix(surface)));
    if (entry.contains("det")) {
      CHECK(d.is_zero());
      CHECK(generic_rank_modulo(matrix, 0).rank == entry.at("generic_rank").get<std::size_t>());
      continue;
    }
    CHECK(d.primitive_part() == product_of(entry.at("factors"), first_parameters()).primitive_part());
    CHECK(d.degree(0) == entry.at("degrees_u_v").at(0).get<long>());
    CHECK(d.degree(1) == entry.at("degrees_u_v").at(1).get<long>());
  }
}

TEST_CASE("Bezoutian determinant: a degree declared too high makes it vanish; the true degree is used") {
  const json& example = bezoutian_data().at("example");
  const RationalSurface surface = weight_first(example.at("coordinates"), second_parameters());
  std::vector<std::array<Polynomial, 4>> first(3, {Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)});
  std::vector<std::array<Polynomial, 4>> second = first;
  for (std::size_t k = 0; k < 4; ++k)
    for (const Polynomial::Term& term : surface.coordinates()[(k + 3) % 4].terms()) {
      const auto add = [&](Polynomial& sum, unsigned long e0, unsigned long e1) {
        sum = sum + Polynomial::from_terms(2, std::vector<Polynomial::Term>{{term.coefficient, {e0, e1}}});
      };
      add(first[term.exponents[1]][k], term.exponents[0], 0);
      add(second[term.exponents[0]][k], 0, term.exponents[1]);
    }
  CHECK(determinant(separated_bezoutian_matrix(first, second)).is_zero());  // the surface against itself
  const RationalSurface plane =
      weight_first(std::vector<std::string>{"1", "s", "t", "s + 2t + 3"}, second_parameters());
  CHECK_FALSE(intersection(surface, plane).is_zero());
  std::vector<std::array<Polynomial, 4>> padded = first;
  padded.push_back({Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)});
  const Polynomial s = Polynomial::variable(2, 0), t = Polynomial::variable(2, 1), one = Polynomial::constant(2, 1);
  const std::vector<std::array<Polynomial, 4>> line{{one, Polynomial(2), t, Rational(2) * t + Rational(3) * one},
                                                    {Polynomial(2), one, Polynomial(2), one}};
  CHECK(determinant(separated_bezoutian_matrix(first, line)) == intersection(surface, plane));
  CHECK(determinant(separated_bezoutian_matrix(padded, line)).is_zero());
}

TEST_CASE("Bezoutian determinant: exchanging the surfaces exchanges the roles of all parameters") {
  Random random(24);
  const RationalSurface phi = random_surface(random, 2, 1, false, 9);
  const RationalSurface psi = random_surface(random, 2, 2, true, 9);
  const auto exchanged = [](const RationalSurface& surface) {
    std::vector<Polynomial> coordinates;
    const std::vector<Polynomial> images{Polynomial::variable(2, 1), Polynomial::variable(2, 0)};
    for (const Polynomial& coordinate : surface.coordinates()) coordinates.push_back(coordinate.compose(images));
    return RationalSurface(RationalSurface::Kind::tensor_product, std::move(coordinates));
  };
  const std::vector<Polynomial> images{Polynomial::variable(2, 1), Polynomial::variable(2, 0)};
  CHECK(intersection(phi, psi).primitive_part() ==
        intersection(exchanged(psi), exchanged(phi)).compose(images).primitive_part());
}

TEST_CASE("Bezoutian determinant: limits and bad indices are refused") {
  Random random(25);
  const RationalSurface phi = random_surface(random, 2, 2, true, 9);
  const SeparatedBezoutian matrix(phi, phi);
  CHECK_THROWS_AS(principal_minor(matrix, {4}, 0, Context()), InvalidInput);
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(bezoutian_determinant(matrix, 0, cancelled), LimitReached);
  const RationalSurface steep = weight_first(
      std::vector<std::string>{"1", "u^20 v^20 + u", "v^20 + 3u^19", "u^20 - v^19 + 2"}, first_parameters());
  CHECK_THROWS_AS(bezoutian_determinant(SeparatedBezoutian(steep, steep), 0, Context()), LimitReached);
}
