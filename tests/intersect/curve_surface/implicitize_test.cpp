// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_surface/implicitize.hpp>
#include <support/curves.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using nlohmann::json;

namespace {

const std::vector<std::string> plane_names{"x", "y", "w"};
const std::vector<std::string> space_names{"x", "y", "z", "w"};

ImplicitizeProblem of(const symbolic::RationalSurface& surface) {
  return {symbolic::ParametricSurface{{symbolic::SurfacePiece{surface, {}}}}};
}

ImplicitizeProblem of(const symbolic::RationalCurve& curve) {
  return {symbolic::ParametricCurve{{symbolic::CurvePiece{curve, {}}}}};
}

ImplicitizeResult solve(const ImplicitizeProblem& problem, bool equation = false, std::uint64_t seed = 0) {
  Options options;
  options.equation = equation;
  options.seed = seed;
  return implicitize(problem, options, Context());
}

}  // namespace

TEST_CASE("implicitize: degrees of 17 surfaces, and which minors hold planes besides") {
  for (const json& entry : representation_data().at("surfaces")) {
    const std::string name = entry.at("name");
    CAPTURE(name);
    const ImplicitizeResult result = solve(of(surface_of(entry)));
    REQUIRE(result.pieces.size() == 1);
    const PieceRepresentation& piece = result.pieces.front();
    CHECK(piece.represents);
    CHECK(piece.rank_off == piece.matrix.rows());
    CHECK(piece.product == entry.at("product_of_degrees"));
    CHECK(piece.map_degree == entry.at("map_degree"));
    CHECK(piece.degree() * piece.map_degree == piece.product);
    const bool planes = name == "cubic_almost_ci" || name == "sphere_bideg22_single";
    CHECK(piece.extraneous == planes);
    CHECK(*piece.minors == piece.product + (planes ? 1 : 0));
    CHECK(result.warnings.size() == (planes ? 1 : 0));
    // A fibre of two points is seen at one point only; the equation proves it.
    CHECK(piece.proven == (!planes && piece.map_degree == 1));
    CHECK(result.status == (piece.proven ? Status::certified : Status::numeric));
    CHECK_FALSE(piece.equation);
  }
}

TEST_CASE("implicitize: with the equation everything is proven") {
  for (const char* name : {"sphere_quadratic", "sphere_lonlat_biquadratic", "cubic_almost_ci", "sphere_bideg22_single",
                           "torus_2_1", "cone_2_1"}) {
    CAPTURE(name);
    const json& entry = surface_entry(name);
    const ImplicitizeResult result = solve(of(surface_of(entry)), true);
    const PieceRepresentation& piece = result.pieces.front();
    CHECK(result.status == Status::certified);
    CHECK(piece.proven);
    REQUIRE(piece.equation);
    CHECK(piece.equation->total_degree() == piece.degree());
    CHECK(piece.product == entry.at("product_of_degrees"));
    CHECK(piece.map_degree == entry.at("map_degree"));
    CHECK(piece.extraneous == (*piece.minors > piece.product));
    if (entry.contains("equation")) CHECK(*piece.equation == form(entry.at("equation").get<std::string>()));
    CHECK(*piece.equation == *solve(of(surface_of(entry)), true, 12345).pieces.front().equation);
  }
}

TEST_CASE("implicitize: curves in the plane and in space") {
  const ImplicitizeResult circle = solve(of(curve_map({"1-t^2", "2*t", "1+t^2"})), true);
  CHECK(circle.status == Status::certified);
  CHECK(circle.engine.matrix == "moving lines");
  CHECK(symbolic::to_string(*circle.pieces.front().equation, plane_names) == "x^2 + y^2 - w^2");
  CHECK(circle.pieces.front().matrix.rows() == 2);
  CHECK(circle.pieces.front().nu == std::vector<long>{1});
  const ImplicitizeResult twice = solve(of(curve_map({"t^2", "t^4", "1"})));
  CHECK(twice.status == Status::numeric);
  CHECK(twice.pieces.front().map_degree == 2);
  CHECK(twice.pieces.front().degree() == 2);
  CHECK(*twice.pieces.front().minors == 4);
  CHECK(solve(of(curve_map({"t^2", "t^4", "1"})), true).status == Status::certified);
  const ImplicitizeResult cubic = solve(of(curve_map({"t", "t^2", "t^3", "1"})));
  CHECK(cubic.status == Status::certified);
  CHECK(cubic.pieces.front().matrix.rows() == 3);
  CHECK(cubic.pieces.front().matrix.columns() == 6);
  CHECK(cubic.pieces.front().rank_on == 2);
  CHECK_FALSE(cubic.pieces.front().minors);
  CHECK_THROWS_AS(solve(of(curve_map({"t", "t^2", "t^3", "1"})), true), InvalidInput);
  CHECK_THROWS_AS(solve(of(curve_map({"1", "2", "3"}))), InvalidInput);
}

TEST_CASE("implicitize: pieces are represented one by one") {
  const symbolic::ParametricCurve curve{{{curve_map({"t", "t^2", "1"}), symbolic::Interval{0, 1}},
                                         {curve_map({"t", "2*t-1", "1"}), symbolic::Interval{1, 2}}}};
  const ImplicitizeResult result = solve({curve}, true);
  REQUIRE(result.pieces.size() == 2);
  CHECK(symbolic::to_string(*result.pieces[0].equation, plane_names) == "x^2 - y*w");
  CHECK(symbolic::to_string(*result.pieces[1].equation, plane_names) == "2*x - y - w");
  CHECK(std::get<symbolic::CurvePiece>(result.pieces[1].piece).domain->lower == Rational(1));
}

TEST_CASE("implicitize: base points that leave no representation") {
  // All coordinates vanish to third order at (0 : 0 : 1): four cubics in s and t begin them.
  const symbolic::RationalSurface monoid =
      surface_map({"s", "t", "u"}, {"s^3*u + t^4", "s^2*t*u + s^4", "s*t^2*u - s*t^3", "t^3*u + s^2*t^2"});
  const ImplicitizeResult result = solve(of(monoid));
  CHECK(result.status == Status::numeric);
  CHECK_FALSE(result.pieces.front().represents);
  CHECK(result.warnings.size() == 1);
  const ImplicitizeResult with_equation = solve(of(monoid), true);
  CHECK(with_equation.status == Status::incomplete);
  CHECK(with_equation.limit);
}

TEST_CASE("implicitize: a limit leaves what was found") {
  // Degree 32: the matrix is quick, the equation has too many coefficients.
  std::vector<std::string> coordinates;
  Random random(3);
  for (int k = 0; k < 4; ++k) {
    std::string text;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j)
        text += (text.empty() ? "" : " + ") + std::to_string(random.between(1, 9)) + "*s^" + std::to_string(i) + "*t^" +
                std::to_string(j);
    coordinates.push_back(text);
  }
  const symbolic::RationalSurface surface = surface_map({"s", "t"}, coordinates);
  const ImplicitizeResult result = solve(of(surface), true);
  CHECK(result.status == Status::incomplete);
  REQUIRE(result.limit);
  CHECK(result.limit->find("degree 32 has 6545 coefficients") != std::string::npos);
  REQUIRE(result.pieces.size() == 1);
  CHECK(result.pieces.front().product == 32);
  CHECK(result.pieces.front().matrix.rows() == 32);
  Context cancelled;
  cancelled.cancel();
  CHECK(implicitize(of(surface), {}, cancelled).status == Status::incomplete);
}
