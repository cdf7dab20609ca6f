// SPDX-License-Identifier: BSD-3-Clause
//
// The engines of curve_surface as each other's oracle, two curves in space, and what an attack once broke.
#include <doctest/doctest.h>

#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <intersect/curve_helpers.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::Interval;
using symbolic::ParametricSurface;

namespace {

CurveResult solve(const CurveSurfaceProblem& problem, Engine engine, Field field = Field::automatic) {
  Options options;
  options.engine = engine;
  options.field = field;
  const Context context;
  return intersect_curve_surface(problem, options, context);
}

CurveResult solve(const CurveCurveProblem& problem, Field field = Field::automatic) {
  Options options;
  options.field = field;
  const Context context;
  return intersect_curve_curve(problem, options, context);
}

symbolic::SurfacePiece tensor_map(std::initializer_list<const char*> coordinates,
                                  std::optional<symbolic::ParameterRegion> region = {}) {
  static const std::vector<std::string> names{"s", "t"};
  std::vector<Polynomial> maps;
  for (const char* text : coordinates) maps.push_back(symbolic::parse_polynomial(text, names));
  return {symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, maps), std::move(region)};
}

CurveSurfaceProblem random_problem(Draw& draw, std::size_t curve_degree, std::size_t m, std::size_t n) {
  const auto number = [&](long low, long high) { return Rational(draw.between(low, high)) / Rational(1024); };
  const auto weighted = [&](std::vector<Rational> point) {
    const Rational weight = Rational(draw.between(8, 32)) / Rational(16);
    for (Rational& coordinate : point) coordinate = coordinate * weight;
    point.push_back(weight);
    return point;
  };
  std::vector<symbolic::ControlPoint> curve;
  for (std::size_t i = 0; i <= curve_degree; ++i)
    curve.push_back(weighted({number(0, 1024), number(0, 1024), number(-900, 900)}));
  std::vector<std::vector<symbolic::ControlPoint>> rows(m + 1);
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      rows[i].push_back(weighted({Rational(static_cast<long>(i)) / Rational(static_cast<long>(m)) + number(-200, 200),
                                  Rational(static_cast<long>(j)) / Rational(static_cast<long>(n)) + number(-200, 200),
                                  number(-600, 600)}));
  CurveSurfaceProblem problem;
  problem.curve.pieces.push_back(symbolic::bezier_curve(curve));
  problem.surface = ParametricSurface{{symbolic::bezier_patch(rows)}};
  return problem;
}

bool same_solutions(const CurveResult& a, const CurveResult& b) {
  if (a.solutions.size() != b.solutions.size()) return false;
  for (std::size_t i = 0; i < a.solutions.size(); ++i) {
    const CurveSolution& first = a.solutions[i];
    const CurveSolution& second = b.solutions[i];
    if (!may_agree(first.t, second.t) || first.multiplicity != second.multiplicity || first.reality != second.reality ||
        first.surface_parameters.size() != second.surface_parameters.size())
      return false;
    for (std::size_t k = 0; k < first.surface_parameters.size(); ++k)
      for (std::size_t p = 0; p < 2; ++p)
        if (!may_agree(first.surface_parameters[k][p], second.surface_parameters[k][p])) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("Engines: box, pencil and exact agree on rational curves and patches") {
  Draw draw(4);
  int boxes = 0;
  int pencils = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    const auto degree = static_cast<std::size_t>(draw.between(1, 3));
    const auto m = static_cast<std::size_t>(draw.between(1, 2));
    const auto n = static_cast<std::size_t>(draw.between(1, degree < 3 ? 3 : 2));
    const CurveSurfaceProblem problem = random_problem(draw, degree, m, n);
    const CurveResult exact = solve(problem, Engine::exact);
    const CurveResult box = solve(problem, Engine::box);
    CHECK(exact.status == Status::certified);
    CHECK(box.status == Status::certified);
    CHECK(same_solutions(exact, box));
    if (box.engine.method == "box") ++boxes;
    const CurveResult exact_complex = solve(problem, Engine::exact, Field::complex);
    const CurveResult pencil = solve(problem, Engine::pencil, Field::complex);
    CHECK(pencil.status == Status::certified);
    CHECK(same_solutions(exact_complex, pencil));
    CHECK(pencil.counts.with_multiplicity == pencil.counts.expected);
    if (pencil.engine.method == "pencil") ++pencils;
  }
  // Generic problems are answered by the engine that was asked.
  CHECK(boxes > 50);
  CHECK(pencils > 50);
}

TEST_CASE("Engines: the box engine proves a contact at rational parameters") {
  // z = s^2 + t^2 and a line that touches it in (1/2, 1/2, 1/2).
  CurveSurfaceProblem problem;
  problem.curve = map_of({"t", "1/2", "t - 1/4 + 1/4", "1"}, Interval{0, 1});
  problem.surface = ParametricSurface{
      {tensor_map({"s", "t", "s^2 + t^2", "1"}, symbolic::ParameterRegion{{Interval{0, 1}, {0, 1}}, false})}};
  for (const Engine engine : {Engine::box, Engine::exact}) {
    const CurveResult result = solve(problem, engine);
    CHECK(result.status == Status::certified);
    REQUIRE(result.solutions.size() == 1);
    CHECK(result.solutions[0].multiplicity == 2);
    CHECK(is_t(result.solutions[0], Rational(1) / Rational(2)));
    CHECK(result.engine.method == (engine == Engine::box ? "box" : "exact"));
  }
}

TEST_CASE("Engines: a contact at irrational parameters is left to the exact engine by the box engine") {
  // z = (s^2 - 1/2)^2 + t - 1/2 along y = 1/2, z = 0: a double root at the square root of 1/2.
  CurveSurfaceProblem problem;
  problem.curve = map_of({"t", "1/2", "0", "1"}, Interval{0, 1});
  problem.surface = ParametricSurface{{tensor_map({"s", "t", "(s^2 - 1/2)^2 + t - 1/2", "1"},
                                                  symbolic::ParameterRegion{{Interval{0, 1}, {0, 1}}, false})}};
  const CurveResult result = solve(problem, Engine::box);
  CHECK(result.status == Status::certified);
  REQUIRE(result.solutions.size() == 1);
  CHECK(result.solutions[0].multiplicity == 2);
  CHECK(result.solutions[0].t->value().real == "0.707106781186548");
  CHECK(result.engine.method == "exact");
}

TEST_CASE("A map of total degree two written as a tensor product") {
  // The unit sphere: a base point at infinity that is no local complete intersection.
  const ParametricSurface sphere{{tensor_map({"2*s", "2*t", "s^2+t^2-1", "s^2+t^2+1"})}};
  const CurveResult tangent = solve({map_of({"t", "0", "1", "1"}), sphere}, Engine::automatic);
  CHECK(tangent.status == Status::certified);
  REQUIRE(tangent.solutions.size() == 1);
  CHECK(tangent.solutions[0].multiplicity == 2);
  const CurveResult apart = solve({map_of({"t", "5", "1", "1"}), sphere}, Engine::automatic);
  CHECK(apart.status == Status::certified);
  CHECK(apart.counts.real == 0);
  CHECK(apart.overlap.empty());
  const ParametricSurface graph{{tensor_map({"s", "t", "s^2 + t^2", "1"})}};
  const CurveResult line = solve({map_of({"t", "1/5", "1/7", "1"}), graph}, Engine::automatic);
  CHECK(line.status == Status::certified);
  CHECK(line.counts.expected == 2);
  CHECK(line.solutions.size() == 2);
}

TEST_CASE("Two sheets of a patch at one parameter are one solution") {
  const symbolic::ParameterRegion region{{Interval{-3, 3}, Interval{-9, 9}}, false};
  const CurveResult result = solve({map_of({"2", "t", "3", "1"}, Interval{-5, 5}),
                                    ParametricSurface{{tensor_map({"s^2", "t", "s^4 - 3*t + s^2", "1"}, region)}}},
                                   Engine::automatic);
  CHECK(result.status == Status::certified);
  REQUIRE(result.solutions.size() == 1);
  CHECK(is_t(result.solutions[0], Rational(1)));
  CHECK(result.solutions[0].surface_parameters.size() == 2);
}

TEST_CASE("Two pieces of a surface at one parameter are one solution, whatever the engine") {
  // Walls over two segments that cross in (1, 1).
  const symbolic::ParameterRegion region{{Interval{0, 1}, Interval{0, 1}}, false};
  const symbolic::SurfacePiece wall = tensor_map({"2*s", "2*s", "t", "1"}, region);
  const symbolic::ParameterRegion next{{Interval{1, 2}, Interval{0, 1}}, false};
  const symbolic::SurfacePiece other = tensor_map({"4 - 2*s", "2*s - 2", "t", "1"}, next);
  for (const Engine engine : {Engine::automatic, Engine::box, Engine::pencil, Engine::exact}) {
    const CurveResult result =
        solve({map_of({"1", "4*t - 1", "1/2", "1"}, Interval{0, 1}), ParametricSurface{{wall, other}}}, engine);
    CHECK(result.status == Status::certified);
    REQUIRE(result.solutions.size() == 1);
    CHECK(is_t(result.solutions[0], Rational(1) / Rational(2)));
    CHECK(result.solutions[0].surface_parameters.size() == 2);
    CHECK(result.solutions[0].multiplicity == 2);
  }
}

TEST_CASE("A point to which a whole border of a plane patch belongs") {
  // The border t = 1 is the point (2, 1, 0).
  const symbolic::ParameterRegion region{{Interval{0, 1}, Interval{0, 1}}, false};
  const CurveResult result =
      solve({map_of({"2", "1", "2*t - 1", "1"}, Interval{0, 1}),
             ParametricSurface{{tensor_map({"(2 - 2*s)*(1 - t)^2 + 2*t*(1 - t)*(3*s - 2) + 2*t^2",
                                            "(3*s - 2)*(1 - t)^2 + 4*t*(1 - t)*(1 - s) + t^2", "0", "1"},
                                           region)}}},
            Engine::automatic);
  REQUIRE(result.solutions.size() == 1);
  CHECK(is_t(result.solutions[0], Rational(1) / Rational(2)));
}

TEST_CASE("The pencil engine with a curve in the surface that leaves the patch") {
  const symbolic::ParameterRegion region{{Interval{0, 1}, Interval{0, 1}}, false};
  const CurveResult result = solve(
      {map_of({"t", "1/2", "0", "1"}, Interval{-1, 2}), ParametricSurface{{tensor_map({"s", "t", "0", "1"}, region)}}},
      Engine::pencil);
  CHECK(result.status == Status::infinite);
  CHECK(result.overlap.size() == 1);
}

TEST_CASE("Solutions that agree in all digits asked for get more") {
  const CurveResult close = solve(
      {map_of({"t", "0", "0", "1"}),
       ImplicitSurface{symbolic::parse_polynomial("(x-1)*(x-1-1e-40)+y+z", std::vector<std::string>{"x", "y", "z"})}},
      Engine::automatic);
  REQUIRE(close.solutions.size() == 2);
  for (const CurveSolution& s : close.solutions) CHECK(s.radius_exponent < -40);
}

TEST_CASE("The end of a domain against an infinite parameter of the other curve") {
  const CurveResult result = solve({map_of({"t", "0", "1"}, Interval{0, 1}), map_of({"1", "t", "t^2+1"})});
  CHECK(result.status == Status::certified);
  REQUIRE(result.solutions.size() == 2);
  CHECK(is_t(result.solutions[0], Rational(0)));
  CHECK(is_infinite(result.solutions[0].u));
  CHECK(is_t(result.solutions[1], Rational(1)));
  CHECK(is_u(result.solutions[1], Rational(0)));
}

TEST_CASE("A cusp where the domains of one curve touch is listed once; real arcs of double maps are not claimed") {
  const CurveResult cusp =
      solve({map_of({"t^2", "t^3", "1"}, Interval{-1, 0}), map_of({"t^2", "t^3", "1"}, Interval{0, 1})});
  CHECK(cusp.solutions.size() == 1);
  const CurveResult doubled = solve({map_of({"t^2", "t^4", "1"}), map_of({"-t^2", "t^4", "1"})}, Field::real);
  for (const Overlap& overlap : doubled.overlap) CHECK_FALSE(overlap.certified);
}

TEST_CASE("Two curves in space") {
  // The twisted cubic and its chord through t = 0 and 1, its tangent at 1, and a line beside it.
  const symbolic::ParametricCurve cubic = map_of({"t", "t^2", "t^3", "1"});
  const CurveResult chord = solve({cubic, map_of({"t", "t", "t", "1"})});
  CHECK(chord.status == Status::certified);
  REQUIRE(chord.solutions.size() == 2);
  CHECK(is_t(chord.solutions[0], Rational(0)));
  CHECK(is_t(chord.solutions[1], Rational(1)));
  CHECK(chord.solutions[0].multiplicity == 1);
  const CurveResult tangent = solve({cubic, map_of({"t + 1", "2*t + 1", "3*t + 1", "1"})});
  REQUIRE(tangent.solutions.size() == 1);
  CHECK(tangent.solutions[0].multiplicity == 2);
  CHECK(is_u(tangent.solutions[0], Rational(0)));
  CHECK(solve({cubic, map_of({"t", "t", "t + 1/1000000007", "1"})}).solutions.empty());
  const CurveResult same = solve({cubic, map_of({"2*t", "4*t^2", "8*t^3", "1"}, Interval{0, 1})});
  CHECK(same.status == Status::infinite);
  REQUIRE(same.overlap.size() == 1);
  CHECK((*same.overlap[0].t)[1]->real == "2");
  // In one plane Bezout's number holds again.
  const CurveResult plane = solve({map_of({"t", "t^2", "0", "1"}), map_of({"t", "1", "0", "1"})});
  CHECK(plane.counts.expected == 2);
  CHECK(plane.solutions.size() == 2);
}

TEST_CASE("A curve in the surface is cut at the borders of the patch") {
  const symbolic::ParameterRegion unit{{Interval{0, 1}, Interval{0, 1}}, false};
  const ParametricSurface saddle{{tensor_map({"s", "t", "s*t", "1"}, unit)}};
  const CurveResult inside = solve({map_of({"t", "t^2", "t^3", "1"}, Interval{-1, 2}), saddle}, Engine::automatic);
  CHECK(inside.status == Status::infinite);
  CHECK(inside.rest_status == Status::certified);
  REQUIRE(inside.overlap.size() == 1);
  CHECK((*inside.overlap[0].t)[0]->real == "0");
  CHECK((*inside.overlap[0].t)[1]->real == "1");
  const CurveResult shifted = solve({map_of({"t", "t^2 - 1/2", "t^3 - t/2", "1"}), saddle}, Engine::automatic);
  REQUIRE(shifted.overlap.size() == 1);
  CHECK((*shifted.overlap[0].t)[0]->real == "0.707106781186548");
  CHECK((*shifted.overlap[0].t)[1]->real == "1");
}
