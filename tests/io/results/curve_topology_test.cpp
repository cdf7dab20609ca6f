// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <limits>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/input/problem_echo.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/curve_topology_csv.hpp>
#include <eliminant/io/results/curve_topology_json.hpp>
#include <eliminant/io/results/curve_topology_text.hpp>
#include <eliminant/io/results/curve_topology_words.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::TopologyResult;
using intersect::TopologyVertex;
using intersect::VertexKind;

namespace {

// The hyperbola beside an isolated point: an end at infinity, an asymptote, and the point.
TopologyResult sample() {
  TopologyResult result;
  result.status = intersect::Status::certified;
  result.counts = {.components = 2, .cycles = 0, .faces = 3, .singular = 1, .critical = 0, .border = 0, .infinity = 2};
  TopologyVertex left;
  left.kind = VertexKind::infinity;
  left.x_infinite = -1;
  left.certified = true;
  TopologyVertex below = left;
  below.x_infinite = 0;
  below.y_infinite = -1;
  below.x.real = "0.5";
  below.radius_exponent = -15;
  TopologyVertex point;
  point.kind = VertexKind::singular;
  point.x.real = std::string("1");
  point.y.real = std::string("-2");
  point.radius_exponent = -14;
  point.milnor_number = 1;
  point.certified = true;
  result.vertices = {left, below, point};
  result.edges.resize(1);
  result.edges[0].from = 0;
  result.edges[0].to = 1;
  result.edges[0].polyline = {{-1, -1}, {0.25, -4}};
  result.isolated = {2};
  result.error = 0x1p-52;
  return result;
}

ProblemFile read(const std::string& text) { return read_problem(text, ProblemSyntax::json); }

}  // namespace

TEST_CASE("Curve topology: a problem is read and echoed") {
  const ProblemFile file = read(
      R"({"problem": "curve_topology", "p": "t^2 - s", "variables": ["s", "t"], "box": [[0, 1], ["1/3", 2]], "id": 7})");
  const auto& problem = std::get<intersect::CurveTopologyProblem>(file.problem);
  CHECK(problem.variables == std::vector<std::string>{"s", "t"});
  CHECK(problem.p == symbolic::Polynomial::variable(2, 1) * symbolic::Polynomial::variable(2, 1) -
                         symbolic::Polynomial::variable(2, 0));
  REQUIRE(problem.box);
  CHECK(problem.box->y[0] == symbolic::Rational(1) / symbolic::Rational(3));
  const std::string echoed = echo_problem(file, {});
  const ProblemFile again = read(echoed);
  CHECK(std::get<intersect::CurveTopologyProblem>(again.problem).p == problem.p);
  CHECK(echo_problem(again, {}) == echoed);
  CHECK(!std::get<intersect::CurveTopologyProblem>(read(R"({"problem": "curve_topology", "p": "x*y"})").problem).box);
}

TEST_CASE("Curve topology: bad problems are refused") {
  CHECK_THROWS_AS(read(R"({"problem": "curve_topology"})"), InvalidInput);
  CHECK_THROWS_AS(read(R"({"problem": "curve_topology", "p": "x", "q": "y"})"), InvalidInput);
  CHECK_THROWS_AS(read(R"({"problem": "curve_topology", "p": "x +* y"})"), ParseError);
  CHECK_THROWS_AS(read(R"({"problem": "curve_topology", "p": "x + y + z"})"), InvalidInput);
  CHECK_THROWS_AS(read(R"({"problem": "curve_topology", "p": "x", "box": [[1, 0], [0, 1]]})"), InvalidInput);
}

TEST_CASE("Curve topology: JSON has the fields of the contract") {
  const JsonDocument document(curve_topology_json(sample(), ProblemId(std::string("seven"))));
  const JsonValue& root = document.root();
  CHECK(root.find("problem")->text == "curve_topology");
  CHECK(root.find("id")->text == "seven");
  CHECK(root.find("status")->text == "certified");
  CHECK(root.find("counts")->find("components")->text == "2");
  CHECK(root.find("counts")->find("isolated")->text == "1");
  CHECK(root.find("counts")->find("faces")->text == "3");
  const auto& vertices = root.find("vertices")->elements;
  REQUIRE(vertices.size() == 3);
  CHECK(vertices[0].find("kind")->text == "infinity");
  CHECK(vertices[0].find("x")->text == "-inf");
  CHECK(vertices[0].find("y")->kind == JsonValue::Kind::null);
  CHECK(vertices[0].find("radius")->kind == JsonValue::Kind::null);
  CHECK(vertices[1].find("x")->text == "0.5");
  CHECK(vertices[1].find("y")->text == "-inf");
  CHECK(vertices[2].find("type")->text == "isolated");
  CHECK(vertices[2].find("y")->text == "-2");
  CHECK(vertices[2].find("radius")->text == "1e-14");
  CHECK(vertices[2].find("half_branches")->find("left")->text == "0");
  CHECK(vertices[2].find("milnor_number")->text == "1");
  const JsonValue& edge = root.find("edges")->elements.at(0);
  CHECK(edge.find("from")->text == "0");
  CHECK(edge.find("to")->text == "1");
  CHECK(edge.find("polyline")->elements.at(1).elements.at(0).text == "0.25");
  CHECK(root.find("isolated")->elements.at(0).text == "2");
  CHECK(root.find("loops")->elements.empty());
  CHECK(root.find("error")->text == "2.220446049250313e-16");
}

TEST_CASE("Curve topology: CSV and text") {
  CHECK(curve_topology_csv(sample()) ==
        "kind,type,x,y,radius,left,right,vertical,milnor_number,on_border,certified\n"
        "infinity,,-inf,,,0,0,0,0,false,true\n"
        "infinity,,0.5,-inf,1e-15,0,0,0,0,false,true\n"
        "singular,isolated,1,-2,1e-14,0,0,0,1,false,true\n");
  const std::string text = curve_topology_text(sample(), {});
  for (const char* part :
       {"every vertex and every arc proven", "2  connected components", "singular, isolated", "Isolated: vertices 2"})
    CHECK(text.find(part) != std::string::npos);
  TopologyResult numeric = sample();
  numeric.status = intersect::Status::numeric;
  CHECK(curve_topology_text(numeric, {}).starts_with("Status: numeric"));
}

TEST_CASE("Curve topology: types of singular points") {
  TopologyVertex vertex;
  const auto type = [&](unsigned long half_branches, unsigned long milnor) {
    vertex.left = half_branches;
    vertex.milnor_number = milnor;
    return std::string(singularity_word(vertex));
  };
  CHECK(type(0, 1) == "isolated");
  CHECK(type(4, 1) == "node");
  CHECK(type(2, 2) == "cusp");
  CHECK(type(4, 3) == "tacnode");
  CHECK(type(0, 3) == "isolated");
  CHECK(type(6, 4) == "other");
  CHECK(double_text(0.1) == "0.1");
  CHECK(double_text(-1e300) == "-1e+300");
}
