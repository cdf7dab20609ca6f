// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <io/bad_geometry.hpp>
#include <io/geometry_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::ParametricCurve;
using symbolic::Rational;

namespace {

ParametricCurve parametric(const std::string& text) { return std::get<ParametricCurve>(test::curve_from(text)); }

bool is_map(const symbolic::RationalCurve& map, const std::vector<std::string>& texts) {
  return map.coordinates() == symbolic::rational_curve(test::polynomials(texts, {"t"})).coordinates();
}

}  // namespace

TEST_CASE("read_curve: rational maps in the plane and in space, with and without weight and domain") {
  const ParametricCurve cubic = parametric(R"({"parameter": "t", "x": "1", "y": "t", "z": "t^2", "w": "t^3"})");
  REQUIRE(cubic.pieces.size() == 1);
  CHECK(is_map(cubic.pieces[0].map, {"1", "t", "t^2", "t^3"}));
  CHECK_FALSE(cubic.pieces[0].domain.has_value());
  const ParametricCurve parabola =
      parametric(R"({"parameter": "α", "x": "α/2", "y": "α^2 - 0.1", "domain": ["-1/3", 1e1]})");
  CHECK(is_map(parabola.pieces[0].map, {"10*t", "20*t^2-2", "20"}));
  CHECK(*parabola.pieces[0].domain == Interval{Rational(Integer(-1), Integer(3)), 10});
  CHECK(is_map(parametric(R"({"parameter": "t", "x": 2, "y": "t", "w": "t"})").pieces[0].map, {"2", "t", "t"}));
  CHECK(is_map(parametric(R"({"parameter": "u", "x": "u^2+u", "y": "u+1", "w": "(u+1)*u"})").pieces[0].map,
               {"t", "1", "t"}));
}

TEST_CASE("read_curve: Bezier curves, points with and without weight") {
  const ParametricCurve quarter =
      parametric(R"({"bezier": {"degree": 2, "control_points": [[1, 0], [1, 1], [0, 1, 0, 2]]}})");
  CHECK(is_map(quarter.pieces[0].map, {"1-t^2", "2*t", "1+t^2"}));
  CHECK(*quarter.pieces[0].domain == Interval{0, 1});
  const ParametricCurve segment =
      parametric(R"({"bezier": {"degree": 1, "control_points": [[0, 0, 0], ["1/3", 2, 1, 3]]}})");
  CHECK(is_map(segment.pieces[0].map, {"t", "6*t", "3*t", "1+2*t"}));
  // A weight of zero: the point contributes nothing.
  const ParametricCurve shortened =
      parametric(R"({"bezier": {"degree": 2, "control_points": [[1, 2, 3], [7, 7, 7, 0], [0, 1, 1]]}})");
  CHECK(is_map(shortened.pieces[0].map, {"(1-t)^2", "2*(1-t)^2+t^2", "3*(1-t)^2+t^2", "(1-t)^2+t^2"}));
}

TEST_CASE("read_curve: NURBS curves are cut at their knots") {
  const ParametricCurve polygon = parametric(
      R"({"nurbs": {"degree": 1, "knots": [0, 0, 1, "5/2", 2.5], "control_points": [[0, 0], [1, 0], [1, 3]]}})");
  REQUIRE(polygon.pieces.size() == 2);
  CHECK(is_map(polygon.pieces[0].map, {"t", "0", "1"}));
  CHECK(is_map(polygon.pieces[1].map, {"1", "2*t-2", "1"}));
  CHECK(*polygon.pieces[1].domain == Interval{1, Rational(Integer(5), Integer(2))});
  const ParametricCurve weighted = parametric(R"({"nurbs": {"degree": 2, "knots": [0, 0, 0, 1, 1, 1],
    "control_points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]}})");
  CHECK(is_map(weighted.pieces[0].map, {"1-t^2", "2*t", "1+t^2"}));
}

TEST_CASE("read_curve: pieces in sequence, and an equation") {
  const ParametricCurve pieces = parametric(R"({"pieces": [
    {"parameter": "t", "x": "t", "y": "0", "domain": [0, 1]},
    {"parameter": "t", "x": "1", "y": "t - 1", "domain": [1, 2]}]})");
  CHECK(pieces.pieces.size() == 2);
  const intersect::Curve circle = test::curve_from(R"({"implicit": "x^2 + y^2 - 1"})");
  CHECK(std::get<intersect::ImplicitCurve>(circle).equation.total_degree() == 2);
}

TEST_CASE("control points [x, y, 0, w] alone: in the plane, in space where a space curve is asked for") {
  const std::string arc = R"({"bezier": {"degree": 2, "control_points": [[1, 0, 0, 1], [1, 1, 0, 1], [0, 1, 0, 2]]}})";
  CHECK(is_map(parametric(arc).pieces[0].map, {"1-t^2", "2*t", "1+t^2"}));
  const JsonDocument document(arc);
  const ParametricCurve in_space = read_space_curve(JsonFields(document), document.root(), "\"curve\"");
  CHECK(is_map(in_space.pieces[0].map, {"1-t^2", "2*t", "0", "1+t^2"}));

  const auto dimensions = [](const std::string& first, const std::string& second) {
    const JsonDocument pair("[" + first + ", " + second + "]");
    const auto& elements = pair.root().elements;
    std::vector<std::size_t> result;
    for (const auto& curve : read_curve_pair(JsonFields(pair), elements[0], elements[1]))
      result.push_back(std::get<ParametricCurve>(curve).pieces[0].map.dimension());
    return result;
  };
  const std::string plane = R"({"parameter": "t", "x": "t", "y": "t"})";
  const std::string space = R"({"parameter": "t", "x": "t", "y": "t", "z": "t"})";
  using Dimensions = std::vector<std::size_t>;
  CHECK(dimensions(arc, plane) == Dimensions{2, 2});
  CHECK(dimensions(plane, arc) == Dimensions{2, 2});
  CHECK(dimensions(arc, space) == Dimensions{3, 3});
  CHECK(dimensions(space, arc) == Dimensions{3, 3});
  CHECK(dimensions(arc, arc) == Dimensions{2, 2});
  CHECK(dimensions(space, space) == Dimensions{3, 3});
}

TEST_CASE("curves: kind, place, message and expectation of every bad input") {
  const auto curve_surface = [](const std::string& curve) {
    return "{\"problem\": \"curve_surface\", \"surface\": {\"implicit\": \"z\"}, \"curve\":\n" + curve + "}";
  };
  const auto bezier = test::under("bezier", curve_surface);
  const auto nurbs = test::under("nurbs", curve_surface);
  const auto first_of_two = [](const std::string& curve) {
    return "{\"problem\": \"curve_curve\", \"second\": {\"implicit\": \"x\"}, \"first\":\n" + curve + "}";
  };
  const std::string cubic = "\"control_points\": [[0,0,0],[1,0,0],[1,1,0],[1,1,1]]";
  const std::string many_points = [] {
    std::string list;
    for (int i = 0; i < 100'001; ++i) list += ",[0,0,0]";
    return "\"control_points\": [" + list.substr(1) + "]";
  }();
  const std::string wide = "{\"parameter\": \"t\", \"x\": \"t\", \"y\": \"t\", \"z\": \"1\"";
  check_bad_inputs({
      // The object.
      {"number", curve_surface("7"), invalid, 2, 1, "\"curve\" is a number", "a curve such as"},
      {"empty object", curve_surface("{}"), invalid, 2, 1, "\"parameter\" is missing", "bezier, nurbs, implicit"},
      {"no curve", "{\"problem\": \"curve_surface\", \"surface\": {}}", invalid, 1, 1, "\"curve\" is missing",
       "a space curve"},
      {"unknown field", curve_surface(wide + ", \"v\": \"1\"}"), invalid, 2, 50, "unknown field \"v\"",
       "parameter, x, y"},
      {"parameters of a surface", curve_surface("{\"parameters\": [\"s\", \"t\"]}"), invalid, 2, 2,
       "unknown field \"parameters\"", "parameter, x, y"},
      {"two kinds", curve_surface("{\"bezier\": {}, \"parameter\": \"t\"}"), invalid, 2, 16,
       "unknown field \"parameter\" in \"curve\"", "bezier"},
      // Maps.
      {"parameter as number", curve_surface("{\"parameter\": 1}"), invalid, 2, 15, "a parameter is a number", "a name"},
      {"parameter that is no name", curve_surface("{\"parameter\": \"2t\"}"), invalid, 2, 15, "'2t' is no name",
       "beginning with a letter"},
      {"no y", curve_surface("{\"parameter\": \"t\", \"x\": \"t\"}"), invalid, 2, 1, "\"y\" is missing",
       "a polynomial in t"},
      {"x as array", curve_surface("{\"parameter\": \"t\", \"x\": []}"), invalid, 2, 25, "\"x\" is an array",
       "a polynomial as text"},
      {"another variable", curve_surface("{\"parameter\": \"t\", \"x\": \"1 + s\"}"), parse, 2, 30,
       "x: unknown variable 's'", "t or a product"},
      {"rational function", curve_surface("{\"parameter\": \"t\", \"x\": \"1/t\"}"), parse, 2, 28,
       "x: division by an expression", "a number"},
      {"high degree", curve_surface("{\"parameter\": \"t\", \"x\": \"t^1001\"}"), limit, 2, 28, "x: ", ""},
      {"zero map", curve_surface("{\"parameter\": \"t\", \"x\": 0, \"y\": 0, \"z\": 0, \"w\": 0}"), invalid, 2, 1,
       "all coordinates of a rational curve are zero", "not zero"},
      {"single point",
       curve_surface("{\"parameter\": \"t\", \"x\": \"t\", \"y\": \"2t\", \"z\": \"3t\", \"w\": \"t\"}"), invalid, 2, 1,
       "\"curve\" is a single point", "not constant"},
      {"plane curve", curve_surface("{\"parameter\": \"t\", \"x\": \"t\", \"y\": \"t\"}"), invalid, 2, 1,
       "\"curve\" is a plane curve", "a space curve"},
      {"equation in space", curve_surface("{\"implicit\": \"x + y\"}"), invalid, 2, 1, "\"curve\" is a plane curve",
       "a space curve with a parameter"},
      // Domains.
      {"domain as number", curve_surface(wide + ", \"domain\": 1}"), invalid, 2, 60,
       "the domain of \"curve\" is a number", "[lower, upper]"},
      {"domain of three ends", curve_surface(wide + ", \"domain\": [0, 1, 2]}"), invalid, 2, 60,
       "the domain of \"curve\" is an array of 3 values", "[lower, upper]"},
      {"reversed domain", curve_surface(wide + ", \"domain\": [1, 0]}"), invalid, 2, 60, "is empty", "lower <= upper"},
      {"infinite domain", curve_surface(wide + ", \"domain\": [0, \"inf\"]}"), parse, 2, 65, "domain: ", "a number"},
      {"domain of null", curve_surface(wide + ", \"domain\": [null, 1]}"), invalid, 2, 61,
       "an end of the domain of \"curve\" is null", "a number"},
      // Bezier curves.
      {"bezier as array", curve_surface("{\"bezier\": []}"), invalid, 2, 12, "\"bezier\" is an array", "an object"},
      {"no degree", bezier(cubic), invalid, 2, 12, "\"degree\" is missing", "a whole number"},
      {"no control points", bezier("\"degree\": 3"), invalid, 2, 12, "\"control_points\" is missing", "degree + 1"},
      {"fractional degree", bezier("\"degree\": 2.5, " + cubic), invalid, 2, 23, "the degree of a curve is 2.5",
       "a whole number from 1 to 1000"},
      {"degree zero", bezier("\"degree\": 0, " + cubic), invalid, 2, 23, "the degree of a curve is 0", "from 1 to"},
      {"degree as array", bezier("\"degree\": [3], " + cubic), invalid, 2, 23, "the degree of a curve is an array",
       "a whole number"},
      {"degree beyond the limit", bezier("\"degree\": 1001, " + cubic), limit, 2, 23, "1001, beyond the limit", ""},
      {"degree far beyond", bezier("\"degree\": 99999999999999999999, " + cubic), limit, 2, 23, "beyond the limit", ""},
      {"too few points", bezier("\"degree\": 4, " + cubic), invalid, 2, 44, "4 control points for a curve of degree 4",
       "5 points"},
      {"weights of bezier", bezier("\"degree\": 3, \"weights\": []"), invalid, 2, 26, "unknown field \"weights\"",
       "degree, control_points"},
      {"point as number", bezier("\"degree\": 1, \"control_points\": [1, [0,0,0]]"), invalid, 2, 45,
       "a control point is a number", "[x, y, z]"},
      {"point of one number", bezier("\"degree\": 1, \"control_points\": [[0,0,0], [1]]"), invalid, 2, 54,
       "a control point has 1 numbers", "[x, y, z, w]"},
      {"point of five numbers", bezier("\"degree\": 1, \"control_points\": [[0,0,0], [1,2,3,4,5]]"), invalid, 2, 54,
       "a control point has 5 numbers", "[x, y, z, w]"},
      {"coordinate as null", bezier("\"degree\": 1, \"control_points\": [[0,0,null], [1,1,1]]"), invalid, 2, 50,
       "a coordinate of a control point is null", "a number"},
      {"coordinate as polynomial", bezier("\"degree\": 1, \"control_points\": [[0,0,\"t\"], [1,1,1]]"), parse, 2, 51,
       "a coordinate of a control point: ", "a number"},
      {"plane and space", bezier("\"degree\": 1, \"control_points\": [[0,0], [1,1,1]]"), invalid, 2, 52,
       "a control point in space beside one of two numbers", "[x, y, 0, w]"},
      {"plane and lifted", bezier("\"degree\": 1, \"control_points\": [[0,0], [1,1,1,2]]"), invalid, 2, 52,
       "a control point in space beside one of two numbers", "[x, y, 0, w]"},
      {"all weights zero", bezier("\"degree\": 1, \"control_points\": [[0,0,0,0], [1,1,1,0]]"), invalid, 2, 44,
       "all weights are zero", "not zero"},
      {"equal points", bezier("\"degree\": 1, \"control_points\": [[1,2,3], [1,2,3]]"), invalid, 2, 1,
       "\"curve\" is a single point", "not constant"},
      {"points in the plane", bezier("\"degree\": 1, \"control_points\": [[1,2], [1,3]]"), invalid, 2, 1,
       "\"curve\" is a plane curve", "a space curve"},
      {"too many digits", bezier("\"degree\": 3, \"control_points\": [[0,0,\"1e-1000001\"]]"), invalid, 2, 44,
       "1 control points for a curve of degree 3", ""},
      {"long exponent", bezier("\"degree\": 1, \"control_points\": [[0,0,1e-1000001], [1,1,1]]"), limit, 2, 50,
       "exponent", ""},
      // NURBS curves.
      {"no knots", nurbs("\"degree\": 3, " + cubic), invalid, 2, 11, "\"knots\" is missing", "knots"},
      {"knots as text", nurbs("\"degree\": 3, \"knots\": \"0,1\", " + cubic), invalid, 2, 34, "\"knots\" is a text",
       "an array"},
      {"knot as text", nurbs("\"degree\": 3, \"knots\": [0,0,0,\"a\"], " + cubic), parse, 2, 42,
       "a knot: ", "a number"},
      {"too few knots", nurbs("\"degree\": 3, \"knots\": [0,0,0,1,1,1], " + cubic), invalid, 2, 34,
       "6 knots for 4 control points of degree 3", "8 knots"},
      {"decreasing knots", nurbs("\"degree\": 3, \"knots\": [0,0,0,0,2,1,2,2], " + cubic), invalid, 2, 34,
       "knot 6 is smaller than the knot before", "do not decrease"},
      {"empty domain", nurbs("\"degree\": 3, \"knots\": [0,1,2,3,3,4,5,6], " + cubic), invalid, 2, 34,
       "the domain of a knot vector is empty", "positive length"},
      {"multiple knot", nurbs("\"degree\": 1, \"knots\": [0,0,1,1,1,2], " + cubic), invalid, 2, 34,
       "a knot occurs more than 2 times", "degree + 1"},
      {"few points", nurbs("\"degree\": 4, \"knots\": [0,0,1,1], " + cubic), invalid, 2, 63,
       "4 control points for a curve of degree 4", "at least 5"},
      {"too few weights", nurbs("\"degree\": 3, \"knots\": [0,0,0,0,1,1,1,1], \"weights\": [1,2,1], " + cubic), invalid,
       2, 64, "3 weights for 4 control points", "a weight for each"},
      {"weights twice",
       nurbs("\"degree\": 1, \"knots\": [0,0,1,1], \"weights\": [1,2], \"control_points\": [[0,0,0],[1,1,1,2]]"),
       invalid, 2, 90, "a weight beside \"weights\"", "[x, y, z]"},
      {"weights zero",
       nurbs("\"degree\": 1, \"knots\": [0,0,1,1], \"weights\": [0,0], \"control_points\": [[0,0,0],[1,1,1]]"), invalid,
       2, 56, "all weights are zero", "not zero"},
      {"a piece of zeros",
       nurbs("\"degree\": 1, \"knots\": [0,0,1,2,2], \"weights\": [0,0,1], \"control_points\": "
             "[[0,0,0],[1,1,1],[2,0,0]]"),
       invalid, 2, 85, "all coordinates of a rational curve are zero", "not zero"},
      {"too many points", nurbs("\"degree\": 1, \"knots\": [], " + many_points), limit, 2, 56,
       "100001 control points, beyond the limit", ""},
      // Pieces.
      {"no pieces", curve_surface("{\"pieces\": []}"), invalid, 2, 12, "\"pieces\" is an empty array", "at least one"},
      {"piece without domain", curve_surface("{\"pieces\": [" + wide + "}]}"), invalid, 2, 13, "\"domain\" is missing",
       "[lower, upper]"},
      {"a gap", curve_surface("{\"pieces\": [" + wide + ", \"domain\": [0,1]},\n" + wide + ", \"domain\": [2,3]}]}"),
       invalid, 3, 1, "does not begin where the one before ends", "begins at 1"},
      // Two curves.
      {"space and plane", first_of_two(wide + "}"), invalid, 1, 38, "\"first\" is a space curve and \"second\" a plane",
       "two plane curves or two space curves"},
      {"constant equation", first_of_two("{\"implicit\": \"1\"}"), invalid, 2, 14, "\"implicit\" is constant",
       "an equation"},
      {"zero equation", first_of_two("{\"implicit\": \"x-x\"}"), invalid, 2, 14, "\"implicit\" is constant",
       "an equation"},
      {"equation in z", first_of_two("{\"implicit\": \"x*z\"}"), parse, 2, 17, "implicit: unknown variable 'z'",
       "x, y"},
      {"equation with domain", first_of_two("{\"implicit\": \"x\", \"domain\": [0,1]}"), invalid, 2, 19,
       "unknown field \"domain\"", "implicit"},
      {"triangle as curve", first_of_two("{\"triangle\": {}}"), invalid, 2, 2, "unknown field \"triangle\"",
       "parameter"},
      {"field of another kind", "{\"problem\": \"curve_curve\", \"p\": \"x\"}", invalid, 1, 28, "unknown field \"p\"",
       "first, second"},
      {"box of another kind", "{\"problem\": \"curve_surface\", \"box\": []}", invalid, 1, 30, "unknown field \"box\"",
       "curve, surface"},
      {"no second", "{\"problem\": \"curve_curve\", \"first\": {}}", invalid, 1, 1, "\"second\" is missing", "a curve"},
  });
}
