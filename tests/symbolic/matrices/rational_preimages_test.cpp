// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/rational_preimages.hpp>
#include <eliminant/symbolic/matrices/row_monomials.hpp>
#include <support/curves.hpp>
#include <support/homogeneous_points.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;
using nlohmann::json;

namespace {

using Parameters = std::vector<Rational>;

/// Of degree at least `least` in each group of parameters.
MatrixRepresentation matrix_for(const RationalSurface& phi, long least) {
  if (phi.kind() == RationalSurface::Kind::triangular)
    return moving_plane_matrix(phi, std::max(least, representation_degree(phi)));
  std::array<long, 2> nu = representation_bidegree(phi);
  for (long& degree : nu) degree = std::max(degree, least);
  return moving_plane_matrix(phi, nu);
}

Parameters homogeneous(const RationalSurface& phi, const Parameters& affine) {
  if (phi.kind() == RationalSurface::Kind::triangular) return {affine[0], affine[1], 1};
  return {affine[0], 1, affine[1], 1};
}

}  // namespace

TEST_CASE("rational preimages: a rational point of each reference surface gives its parameters back") {
  Random random(31);
  for (const json& entry : representation_data().at("surfaces")) {
    CAPTURE(entry.at("name").get<std::string>());
    const RationalSurface phi = surface_of(entry);
    const long sheets = entry.at("map_degree");
    const MatrixRepresentation m = matrix_for(phi, sheets);
    for (int sample = 0; sample < 3; ++sample) {
      const Parameters affine{Rational(Integer(random.nonzero(20)), Integer(random.between(1, 7))),
                              Rational(Integer(random.nonzero(20)), Integer(random.between(1, 7)))};
      const Parameters expected = homogeneous(phi, affine);
      const std::vector<Rational> point = image_of(phi, expected);
      const RationalPreimages found = rational_preimages(phi, m, point);
      CHECK(found.kernel_dimension == sheets);
      CHECK(static_cast<long>(found.parameters.size()) == sheets);
      CHECK(std::find(found.parameters.begin(), found.parameters.end(), expected) != found.parameters.end());
      for (const Parameters& parameters : found.parameters) CHECK(same_point(image_of(phi, parameters), point));
    }
    CHECK(rational_preimages(phi, m, {101, -57, 13, 29}).kernel_dimension == 0);
  }
}

TEST_CASE("rational preimages: parameters at infinity and with zeros") {
  const RationalSurface torus = reference_surface("torus_2_1");
  const MatrixRepresentation m = matrix_for(torus, 1);
  for (const Parameters& expected : std::vector<Parameters>{{1, 0, 1, 0}, {1, 0, 2, 1}, {0, 1, 1, 0}, {0, 1, 0, 1}}) {
    const RationalPreimages found = rational_preimages(torus, m, image_of(torus, expected));
    REQUIRE(found.parameters.size() == 1);
    CHECK(found.parameters.front() == expected);
  }
  const RationalSurface cubic = reference_surface("cubic_generic");
  for (const Parameters& expected : std::vector<Parameters>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {0, -3, 1}}) {
    const RationalPreimages found = rational_preimages(cubic, matrix_for(cubic, 1), cubic.at(expected));
    REQUIRE(found.parameters.size() == 1);
    CHECK(found.parameters.front() == expected);
  }
}

TEST_CASE("rational preimages: double and triple points, with rational parameters or without") {
  // Steiner's surface (st : su : tu : s^2 + t^2 + u^2): the triple point and points of its double lines.
  const RationalSurface roman = surface_map({"s", "t", "u"}, {"s*t", "s*u", "t*u", "s^2+t^2+u^2"});
  const auto at = [&](const std::vector<Rational>& point) {
    const long dimension = rational_preimages(roman, matrix_for(roman, 1), point).kernel_dimension;
    return rational_preimages(roman, matrix_for(roman, dimension), point);
  };
  const RationalPreimages triple = at({0, 0, 0, 1});
  CHECK(triple.kernel_dimension == 3);
  CHECK(triple.parameters == std::vector<Parameters>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
  // s t : s^2 + t^2 = 2 : 5 at s = 2 t and t = 2 s.
  const RationalPreimages both = at({2, 0, 0, 5});
  CHECK(both.kernel_dimension == 2);
  CHECK(both.parameters == std::vector<Parameters>{{Rational(Integer(1), Integer(2)), 1, 0}, {2, 1, 0}});
  // s t : s^2 + t^2 = 1 : 3 at irrational ratios.
  const RationalPreimages irrational = at({1, 0, 0, 3});
  CHECK(irrational.kernel_dimension == 2);
  CHECK(irrational.parameters.empty());
}

TEST_CASE("rational preimages: base points are none, and a collapsed border has a kernel of its own") {
  // On the extraneous plane of the base point the kernel is its evaluation.
  const RationalSurface phi = reference_surface("cubic_almost_ci");
  const MatrixRepresentation m = matrix_for(phi, 1);
  const auto plane = surface_entry("cubic_almost_ci").at("extraneous_plane").get<std::vector<long>>();
  const std::vector<Rational> on_plane{plane[1], -plane[0], plane[3], -plane[2]};
  const RationalPreimages found = rational_preimages(phi, m, on_plane);
  CHECK(found.kernel_dimension == 1);
  CHECK(found.parameters.empty());
  const RationalSurface cone = reference_surface("cone_2_1");
  CHECK(rational_preimages(cone, matrix_for(cone, 1), {0, 0, 0, 1}).kernel_dimension > 1);
}

TEST_CASE("row monomials: multiples of every lower monomial, in one order") {
  const RationalSurface torus = reference_surface("torus_2_1");
  const RowMonomials rows(torus.kind(), moving_plane_matrix(torus, std::array<long, 2>{3, 1}));
  CHECK(rows.has_degree(1));
  CHECK_FALSE(rows.has_degree(2));
  const auto multiples = rows.multiples();
  CHECK(multiples.size() == 3);
  for (const auto& of_one : multiples) CHECK(of_one.size() == 4);
  const RationalSurface roman = reference_surface("steiner_roman");
  const RowMonomials ternary(roman.kind(), moving_plane_matrix(roman, 2));
  CHECK(ternary.multiples().size() == 3);
  CHECK(ternary.multiples().front().size() == 3);
  // Of degree 0 nothing can be read.
  const RationalSurface bilinear = reference_surface("bilinear");
  const RowMonomials narrow(bilinear.kind(), moving_plane_matrix(bilinear, std::array<long, 2>{1, 0}));
  CHECK_FALSE(narrow.has_degree(1));
  CHECK_FALSE(narrow.parameters(std::vector<Rational>{1, 2}, 0));
  CHECK(narrow.multiples().empty());
}

TEST_CASE("rational preimages: what is no point is refused") {
  const RationalSurface torus = reference_surface("torus_2_1");
  const MatrixRepresentation m = matrix_for(torus, 1);
  CHECK_THROWS_AS(rational_preimages(torus, m, {0, 0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(rational_preimages(torus, m, {1, 2, 3}), InvalidInput);
  CHECK_THROWS_AS(image_of(torus, {1, 2}), InvalidInput);
}
