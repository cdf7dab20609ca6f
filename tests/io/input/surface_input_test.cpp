// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>

#include <io/bad_geometry.hpp>
#include <io/geometry_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::ParametricSurface;
using symbolic::Rational;
using symbolic::RationalSurface;

namespace {

ParametricSurface parametric(const std::string& text) { return std::get<ParametricSurface>(test::surface_from(text)); }

bool is_map(const RationalSurface& map, const std::vector<std::string>& texts) {
  const std::vector<std::string> names = map.kind() == RationalSurface::Kind::triangular
                                             ? std::vector<std::string>{"s", "t", "u"}
                                             : std::vector<std::string>{"s", "t"};
  return map.coordinates() == test::polynomials(texts, names);
}

}  // namespace

TEST_CASE("read_surface: maps of three homogeneous and of two affine parameters") {
  const ParametricSurface sphere =
      parametric(R"({"parameters": ["a", "b", "c"], "x": "a^2+b^2+c^2", "y": "2ac", "z": "2ab", "w": "a^2-b^2-c^2"})");
  REQUIRE(sphere.pieces.size() == 1);
  CHECK(sphere.pieces[0].map.kind() == RationalSurface::Kind::triangular);
  CHECK(is_map(sphere.pieces[0].map, {"s^2+t^2+u^2", "2*s*u", "2*s*t", "s^2-t^2-u^2"}));
  CHECK_FALSE(sphere.pieces[0].region.has_value());
  const ParametricSurface saddle =
      parametric(R"({"parameters": ["t", "s"], "x": "t", "y": "s/2", "z": "s*t", "domain": [[0, 1], ["-1/2", 0.5]]})");
  CHECK(is_map(saddle.pieces[0].map, {"2*s", "t", "2*s*t", "2"}));
  CHECK(saddle.pieces[0].region->sides ==
        std::array{Interval{0, 1}, Interval{Rational(Integer(-1), Integer(2)), Rational(Integer(1), Integer(2))}});
  CHECK_FALSE(saddle.pieces[0].region->triangle);
  const ParametricSurface plane =
      parametric(R"({"parameters": ["s", "t", "u"], "x": "s", "y": "t", "z": 0, "w": "s+t+u", "domain": "triangle"})");
  CHECK(plane.pieces[0].region->triangle);
}

TEST_CASE("read_surface: Bezier patches and triangles") {
  const ParametricSurface saddle = parametric(R"({"bezier": {"degree": [1, 1],
    "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0, 1], [1, 1, 1, 2]]]}})");
  CHECK(is_map(saddle.pieces[0].map, {"s+s*t", "t+s*t", "2*s*t", "1+s*t"}));
  CHECK(saddle.pieces[0].region->sides == std::array{Interval{0, 1}, Interval{0, 1}});
  const ParametricSurface triangle =
      parametric(R"({"triangle": {"degree": 1, "control_points": [[1, 0, 0], [0, 1, 0, 2], [0, 0, "1/2"]]}})");
  CHECK(is_map(triangle.pieces[0].map, {"2*s", "4*t", "u", "2*s+4*t+2*u"}));
  CHECK(triangle.pieces[0].region->triangle);
}

TEST_CASE("read_surface: NURBS surfaces are cut at their knots, pieces are read back") {
  const ParametricSurface roof = parametric(R"({"nurbs": {"degree": [1, 1], "knots": [[0, 0, 1, 2, 2], [0, 0, 1, 1]],
    "control_points": [[[0, 0, 0], [0, 1, 0]], [[1, 0, 1], [1, 1, 1]], [[2, 0, 0], [2, 1, 0]]],
    "weights": [[1, 1], [1, 1], [1, 1]]}})");
  REQUIRE(roof.pieces.size() == 2);
  CHECK(is_map(roof.pieces[0].map, {"s", "t", "s", "1"}));
  CHECK(is_map(roof.pieces[1].map, {"s", "t", "2-s", "1"}));
  CHECK(roof.pieces[1].region->sides == std::array{Interval{1, 2}, Interval{0, 1}});
  const auto piece = [](const std::string& domain) {
    return R"({"parameters": ["s", "t"], "x": "s", "y": "t", "z": "s*t", "domain": )" + domain + "}";
  };
  const ParametricSurface grid = parametric("{\"pieces\": [" + piece("[[0,1],[0,1]]") + "," + piece("[[0,1],[1,3]]") +
                                            "," + piece("[[1,2],[0,1]]") + "," + piece("[[1,2],[1,3]]") + "]}");
  CHECK(grid.pieces.size() == 4);
}

TEST_CASE("read_surface: an equation in x, y, z") {
  const intersect::Surface sphere = test::surface_from(R"({"implicit": "x^2 + y^2 + z^2 - 1"})");
  CHECK(std::get<intersect::ImplicitSurface>(sphere).equation.variable_count() == 3);
}

TEST_CASE("surfaces: kind, place, message and expectation of every bad input") {
  const auto with_surface = [](const std::string& surface) {
    return "{\"problem\": \"curve_surface\", \"curve\": {\"parameter\": \"t\", \"x\": \"t\", \"y\": \"1\", \"z\": "
           "\"0\"},\n"
           "\"surface\":\n" +
           surface + "}";
  };
  const auto bezier = test::under("bezier", with_surface);
  const auto triangle = test::under("triangle", with_surface);
  const auto nurbs = test::under("nurbs", with_surface);
  const std::string square = "\"control_points\": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]";
  const std::string saddle = "{\"parameters\": [\"s\",\"t\"], \"x\": \"s\", \"y\": \"t\", \"z\": \"s*t\"";
  const std::string forms = "{\"parameters\": [\"s\",\"t\",\"u\"], ";
  const auto piece = [&](const std::string& domain) { return saddle + ", \"domain\": " + domain + "}"; };
  check_bad_inputs({
      // The object.
      {"text", with_surface("\"z\""), invalid, 3, 1, "\"surface\" is a text", "a surface such as"},
      {"empty object", with_surface("{}"), invalid, 3, 1, "\"parameters\" is missing", "bezier, triangle, nurbs"},
      {"curve", with_surface("{\"parameter\": \"t\"}"), invalid, 3, 2, "unknown field \"parameter\"",
       "parameters, x, y"},
      {"no surface", "{\"problem\": \"curve_surface\", \"curve\": {}}", invalid, 1, 1, "\"surface\" is missing",
       "a surface"},
      // Maps.
      {"parameters as text", with_surface("{\"parameters\": \"s,t\"}"), invalid, 3, 16, "\"parameters\" is a text",
       "an array"},
      {"one parameter", with_surface("{\"parameters\": [\"s\"]}"), invalid, 3, 16, "\"parameters\" has 1 names",
       "two affine or three"},
      {"parameter twice", with_surface("{\"parameters\": [\"s\", \"s\"]}"), invalid, 3, 22,
       "the parameter 's' occurs twice", "different"},
      {"no z", with_surface("{\"parameters\": [\"s\",\"t\"], \"x\": \"s\", \"y\": \"t\"}"), invalid, 3, 1,
       "\"z\" is missing", "a polynomial"},
      {"unknown variable", with_surface("{\"parameters\": [\"s\",\"t\"], \"x\": \"s+u\"}"), parse, 3, 35,
       "x: unknown variable 'u'", "s, t"},
      {"no form", with_surface(forms + "\"x\": \"s^2+t\"}"), invalid, 3, 36, "\"x\" is not homogeneous", "a form"},
      {"forms of two degrees", with_surface(forms + "\"x\": \"s^2\", \"y\": \"t\"}"), invalid, 3, 48,
       "\"y\" is a form of degree 1 beside one of degree 2", "forms of one degree"},
      {"no weight of forms", with_surface(forms + "\"x\": \"s\", \"y\": \"t\", \"z\": \"u\"}"), invalid, 3, 1,
       "\"w\" is missing beside coordinates of degree 1", "a form of the same degree"},
      {"zero map", with_surface("{\"parameters\": [\"s\",\"t\"], \"x\": 0, \"y\": 0, \"z\": 0, \"w\": 0}"), invalid, 3,
       1, "all coordinates of a rational surface are zero", "not zero"},
      {"a curve as image",
       with_surface("{\"parameters\": [\"s\",\"t\"], \"x\": \"s+t\", \"y\": \"(s+t)^2\", \"z\": 1}"), invalid, 3, 1,
       "the image of \"surface\" is only a curve or a point", "independent"},
      {"high degree", with_surface("{\"parameters\": [\"s\",\"t\"], \"x\": \"s^600*t^401\"}"), limit, 3, 33,
       "degree 1001", ""},
      // Domains.
      {"flat domain", with_surface(saddle + ", \"domain\": [0,1]}"), invalid, 3, 70, "a side of the domain",
       "[lower, upper]"},
      {"domain of one side", with_surface(saddle + ", \"domain\": [[0,1]]}"), invalid, 3, 69, "an array of 1 values",
       "[[first lower"},
      {"reversed domain", with_surface(saddle + ", \"domain\": [[0,1],[1,0]]}"), invalid, 3, 76, "is empty",
       "lower <= upper"},
      {"triangle of two parameters", with_surface(saddle + ", \"domain\": \"triangle\"}"), invalid, 3, 69,
       "the domain of \"surface\" is a text", "[[first lower"},
      {"rectangle of three parameters",
       with_surface(forms + "\"x\": \"s\", \"y\": \"t\", \"z\": \"u\", \"w\": \"s\", \"domain\": [[0,1],[0,1]]}"),
       invalid, 3, 81, "a map with three parameters is no triangle", "two parameters"},
      // Bezier patches.
      {"one degree", bezier("\"degree\": 1, " + square), invalid, 3, 23, "the degree of a surface is a number",
       "[3, 3]"},
      {"three degrees", bezier("\"degree\": [1,1,1], " + square), invalid, 3, 23, "an array of 3 values", "[3, 3]"},
      {"second degree zero", bezier("\"degree\": [1,0], " + square), invalid, 3, 26, "the second degree is 0",
       "from 1 to 1000"},
      {"degrees beyond the limit", bezier("\"degree\": [600,401], " + square), limit, 3, 23, "add up to 1001", ""},
      {"too few rows", bezier("\"degree\": [2,1], " + square), invalid, 3, 48,
       "2 rows of control points for the first degree 2", "3 rows"},
      {"too short a row", bezier("\"degree\": [1,2], " + square), invalid, 3, 49,
       "a row of 2 control points for the second degree 2", "3 points"},
      {"points without rows", bezier("\"degree\": [1,1], \"control_points\": [1,2]"), invalid, 3, 49,
       "a row of control points is a number", "an array"},
      {"point of two numbers", bezier("\"degree\": [1,1], \"control_points\": [[[0,0,0],[0,1]],[[1,0,0],[1,1,1]]]"),
       invalid, 3, 58, "a control point has 2 numbers", "[x, y, z] or [x, y, z, w]"},
      {"all weights zero",
       bezier("\"degree\": [1,1], \"control_points\": [[[0,0,0,0],[0,1,0,0]],[[1,0,0,0],[1,1,1,0]]]"), invalid, 3, 48,
       "all weights are zero", "not zero"},
      {"rows along one line", bezier("\"degree\": [1,1], \"control_points\": [[[0,0,0],[1,1,1]],[[2,2,2],[5,5,5]]]"),
       invalid, 3, 1, "the image of \"surface\" is only a curve", "independent"},
      // Triangles.
      {"points of a triangle", triangle("\"degree\": 2, \"control_points\": [[0,0,0],[1,0,0],[0,1,0]]"), invalid, 3, 46,
       "3 control points for a triangle of degree 2", "6 points"},
      {"pair of degrees", triangle("\"degree\": [1,1], \"control_points\": []"), invalid, 3, 25,
       "the degree of a triangle is an array", "a whole number"},
      {"too large a triangle", triangle("\"degree\": 1001, \"control_points\": []"), limit, 3, 25, "1001, beyond", ""},
      // NURBS.
      {"one knot vector", nurbs("\"degree\": [1,1], \"knots\": [[0,0,1,1]], " + square), invalid, 3, 38,
       "\"knots\" is an array of 1 values", "second knot vector"},
      {"flat knots", nurbs("\"degree\": [1,1], \"knots\": [0,1], " + square), invalid, 3, 39,
       "a knot vector is a number", "an array"},
      {"second knots too short", nurbs("\"degree\": [1,1], \"knots\": [[0,0,1,1],[0,0,1]], " + square), invalid, 3, 49,
       "3 knots for 2 control points of degree 1", "4 knots"},
      {"decreasing first knots", nurbs("\"degree\": [1,1], \"knots\": [[0,1,0,1],[0,0,1,1]], " + square), invalid, 3,
       39, "knot 3 is smaller", "do not decrease"},
      {"too few rows for the degree", nurbs("\"degree\": [2,1], \"knots\": [[],[]], " + square), invalid, 3, 65,
       "2 rows of control points for the first degree 2", "at least 3"},
      {"uneven rows", nurbs("\"degree\": [1,1], \"knots\": [[],[]], \"control_points\": [[[0,0,0],[1,0,0]],[[1,1,1]]]"),
       invalid, 3, 84, "rows of 2 and 1 control points", "one length"},
      {"rows of weights", nurbs("\"degree\": [1,1], \"knots\": [[0,0,1,1],[0,0,1,1]], \"weights\": [[1,1]], " + square),
       invalid, 3, 72, "1 rows of weights for 2 rows of control points", "a weight for each"},
      {"short row of weights",
       nurbs("\"degree\": [1,1], \"knots\": [[0,0,1,1],[0,0,1,1]], \"weights\": [[1,1],[1]], " + square), invalid, 3,
       79, "1 weights for 2 control points", "a weight for each"},
      // Pieces.
      {"no pieces", with_surface("{\"pieces\": []}"), invalid, 3, 12, "\"pieces\" is an empty array", "at least one"},
      {"piece without domain", with_surface("{\"pieces\": [" + saddle + "}]}"), invalid, 3, 13, "\"domain\" is missing",
       "a domain for each"},
      {"pieces that overlap",
       with_surface("{\"pieces\": [" + piece("[[0,1],[0,1]]") + ",\n" + piece("[[0,1],[0,2]]") + "]}"), invalid, 4, 1,
       "not a grid", "rows of rectangles"},
      {"rows that do not match",
       with_surface("{\"pieces\": [" + piece("[[0,1],[0,1]]") + ",\n" + piece("[[1,2],[0,2]]") + "]}"), invalid, 4, 1,
       "not a grid", "rows of rectangles"},
      {"row that is not complete",
       with_surface("{\"pieces\": [" + piece("[[0,1],[0,1]]") + "," + piece("[[0,1],[1,2]]") + "," +
                    piece("[[1,2],[0,1]]") + "]}"),
       invalid, 3, 12, "not complete", "2 pieces in each row"},
      // Equations.
      {"constant equation", with_surface("{\"implicit\": 5}"), invalid, 3, 14, "\"implicit\" is constant",
       "an equation"},
      {"equation in t", with_surface("{\"implicit\": \"x + t\"}"), parse, 3, 19, "implicit: unknown variable 't'",
       "x, y, z"},
  });
}
