// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/results/curve_result_csv.hpp>
#include <eliminant/io/results/curve_result_json.hpp>
#include <eliminant/io/results/curve_result_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::Coordinate;
using intersect::CurveResult;
using intersect::CurveSolution;
using intersect::Overlap;
using intersect::Parameter;
using intersect::ParameterInterval;
using intersect::Reality;
using intersect::Status;

namespace {

Coordinate number(const char* real, const char* imaginary = "0") {
  Coordinate result;
  result.real = real;
  result.imaginary = imaginary;
  return result;
}

const Parameter infinity;

// A real solution and one at t = infinity, whose point is at infinity, too, and which is not certified; as the pencil
// of a tensor-product surface would give them, the first with two preimages.
CurveResult curve_in_space() {
  CurveResult result;
  result.problem = "curve_surface";
  result.status = Status::numeric;
  result.counts = {
      .distinct = 2, .real = 1, .undecided = 1, .inside = 1, .with_multiplicity = 3, .expected = 3, .listed = 2};
  CurveSolution finite;
  finite.t = number("0.5");
  finite.point = {number("-0.5"), number("0.25"), number("0"), number("1")};
  finite.surface_parameters = {{number("0.25"), infinity}, {number("1", "-2"), number("0", "1")}};
  finite.multiplicity = 2;
  finite.eigenvalue_multiplicity = 3;
  finite.inside = true;
  finite.radius_exponent = -15;
  finite.reality = Reality::real;
  finite.certified = true;
  CurveSolution infinite;
  infinite.t = infinity;
  infinite.point = {number("0.5", "1.5"), number("0"), number("1"), number("0")};
  infinite.radius_exponent = -9;
  infinite.reason = "not tried";
  result.solutions = {finite, infinite};
  result.engine.method = "pencil";
  result.engine.matrix = "moving_planes";
  result.engine.matrix_size = 4;
  result.engine.matrix_degree = 1;
  result.seconds = {{"total", 0.0012345678}};
  result.warnings = {"a warning"};
  return result;
}

CurveResult curves_in_plane() {
  CurveResult result;
  result.problem = "curve_curve";
  result.in_plane = true;
  result.status = Status::certified;
  result.counts = {.distinct = 2, .real = 0, .inside = 0, .with_multiplicity = 2, .expected = 2, .listed = 2};
  CurveSolution solution;
  solution.t = number("1", "-2");
  solution.u = number("0", "-1");
  solution.point = {number("3", "-4"), number("5", "6"), number("1")};
  solution.radius_exponent = -3;
  solution.reality = Reality::non_real;
  solution.certified = true;
  result.solutions = {solution, solution};
  result.solutions[1].u = infinity;
  return result;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("curve_result_json: the fields of a curve and a surface, in their order") {
  const std::string text = curve_result_json(curve_in_space(), ProblemId(7L));
  CHECK(text == R"({
 "format": 1,
 "problem": "curve_surface",
 "id": 7,
 "status": "numeric",
 "counts": {"distinct": 2, "real": 1, "undecided": 1, "inside": 1, "with_multiplicity": 3, "expected": 3, "listed": 2},
 "solutions": [
  {
   "t": ["0.5", "0"],
   "point": [["-0.5", "0"], ["0.25", "0"], ["0", "0"], ["1", "0"]],
   "surface_parameters": [[["0.25", "0"], "inf"], [["1", "-2"], ["0", "1"]]],
   "multiplicity": 2,
   "eigenvalue_multiplicity": 3,
   "inside": true,
   "radius": "1e-15",
   "real": true,
   "certified": true
  },
  {
   "t": "inf",
   "point": [["0.5", "1.5"], ["0", "0"], ["1", "0"], ["0", "0"]],
   "surface_parameters": [],
   "multiplicity": 1,
   "inside": false,
   "radius": "1e-9",
   "real": null,
   "certified": false,
   "reason": "not tried"
  }
 ],
 "engine": {"method": "pencil", "matrix": "moving_planes", "matrix_size": 4, "matrix_degree": 1, "seed": 0},
 "seconds": {"total": 0.001235},
 "warnings": ["a warning"]
}
)");
  CHECK(JsonDocument(text).root().members.size() == 9);
}

TEST_CASE("curve_result_json: two curves have t and u and no parameters of a surface") {
  const std::string text = curve_result_json(curves_in_plane(), std::nullopt);
  CHECK(contains(text, R"(
  {
   "t": ["1", "-2"],
   "u": "inf",
   "point": [["3", "-4"], ["5", "6"], ["1", "0"]],
   "multiplicity": 1,
   "inside": false,
   "radius": "1e-3",
   "real": false,
   "certified": true
  })"));
  CHECK_FALSE(contains(text, "surface_parameters"));
  CHECK_FALSE(contains(text, "overlap"));
  CHECK_FALSE(contains(text, "\"id\""));
}

TEST_CASE("curve_result_json: an overlap is a list of intervals, or all of a line") {
  CurveResult result;
  result.problem = "curve_surface";
  result.status = Status::infinite;
  result.rest_status = Status::certified;
  CHECK(
      contains(curve_result_json(result, std::nullopt), "\"status\": \"infinite\",\n \"rest_status\": \"certified\""));
  CHECK(contains(curve_result_json(result, std::nullopt), "\"overlap\": []"));
  result.overlap = {Overlap{ParameterInterval{number("-0.5"), infinity}, {}, true}, Overlap{}};
  CHECK(contains(curve_result_json(result, std::nullopt),
                 R"("overlap": [{"t": ["-0.5", "inf"], "certified": true}, {"t": "all", "certified": false}])"));

  result.problem = "curve_curve";
  result.overlap = {Overlap{ParameterInterval{number("0"), number("1")}, {}, true}};
  CHECK(contains(curve_result_json(result, std::nullopt), R"([{"t": ["0", "1"], "u": "all", "certified": true}])"));
  result.second_implicit = true;
  CHECK(contains(curve_result_json(result, std::nullopt), R"([{"t": ["0", "1"], "certified": true}])"));
  result.second_implicit = false;
  result.first_implicit = true;
  CHECK(contains(curve_result_json(result, std::nullopt), R"([{"u": "all", "certified": true}])"));
}

TEST_CASE("curve_result_json: a limit is told as the error of an incomplete result") {
  CurveResult result = curve_in_space();
  result.status = Status::incomplete;
  result.limit = "the time limit was reached";
  CHECK(contains(curve_result_json(result, std::nullopt),
                 R"( "status": "incomplete",
 "error": {"kind": "limit", "message": "the time limit was reached", "line": null, "column": null, "expected": null},
 "counts")"));
}

TEST_CASE("curve_result_csv: a header and one line for each solution") {
  CHECK(curve_result_csv(curve_in_space()) ==
        "t_re,t_im,x_re,x_im,y_re,y_im,z_re,z_im,w_re,w_im,radius,real,multiplicity,inside,certified,"
        "a_re,a_im,b_re,b_im,c_re,c_im\n"
        "0.5,0,-0.5,0,0.25,0,0,0,1,0,1e-15,true,2,true,true,0.25,0,inf,0,,\n"
        "inf,0,0.5,1.5,0,0,1,0,0,0,1e-9,undecided,1,false,false,,,,,,\n");
  CHECK(curve_result_csv(curves_in_plane()) ==
        "t_re,t_im,u_re,u_im,x_re,x_im,y_re,y_im,w_re,w_im,radius,real,multiplicity,inside,certified\n"
        "1,-2,0,-1,3,-4,5,6,1,0,1e-3,false,1,false,true\n"
        "1,-2,inf,0,3,-4,5,6,1,0,1e-3,false,1,false,true\n");
}

TEST_CASE("curve_result_csv: the header does not depend on the solutions, and every line has its cells") {
  CurveResult triangular = curve_in_space();
  triangular.solutions[0].surface_parameters = {{number("1"), number("2", "3"), number("1")}};
  CHECK(contains(curve_result_csv(triangular), ",true,true,1,0,2,3,1,0\n"));
  CurveResult half_implicit = curves_in_plane();
  half_implicit.second_implicit = true;
  for (CurveSolution& solution : half_implicit.solutions) solution.u.reset();
  CHECK(contains(curve_result_csv(half_implicit), "\n1,-2,,,3,-4,"));
  for (CurveResult result : {curve_in_space(), curves_in_plane(), triangular, half_implicit}) {
    const std::string text = curve_result_csv(result);
    const auto commas = [&](std::size_t begin) {
      return std::count(text.begin() + static_cast<long>(begin),
                        text.begin() + static_cast<long>(text.find('\n', begin)), ',');
    };
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
      CHECK(commas(begin) == commas(0));
    result.solutions.clear();
    CHECK(curve_result_csv(result) == text.substr(0, text.find('\n') + 1));
  }
}

TEST_CASE("curve_result_text: the audit comes first, then what ran, then the table") {
  CurveResult result = curve_in_space();
  CHECK(curve_result_text(result, {}, false) ==
        R"(Status: numeric: computed, not proven complete

Count audit, with multiplicity
    3  expected, the product of the degrees
  = 3  found (2 solutions)
    3  found
  = 2  certified
  + 1  not certified
Solutions: 1 real, 0 not real, 1 undecided; 1 inside

             given  used
  engine     auto   pencil
  matrix     auto   moving_planes, 4 x 4 of degree 1
  precision  auto   -
  seed       0      0

  #1  multiplicity 2, of the eigenvalue 3, real yes, inside yes, radius 1e-15, certified
    t = 0.5
    x = -0.5
    y = 0.25
    z = 0
    w = 1
    surface parameters (0.25, inf)
    surface parameters (1 - 2i, 1i)

  #2  multiplicity 1, real undecided, inside no, radius 1e-9, not certified
    t = inf
    x = 0.5 + 1.5i
    y = 0
    z = 1
    w = 0
Not certified: #2: not tried
)");
  result.solutions[0].surface_parameters.pop_back();
  result.solutions[0].eigenvalue_multiplicity.reset();
  CHECK(contains(curve_result_text(result, {}, false),
                 R"(
  #  t     x           y     z  w  surface parameters  multiplicity  real       inside  radius  certified
  1  0.5  -0.5         0.25  0  1  (0.25, inf)                    2  yes        yes     1e-15   yes
  2  inf   0.5 + 1.5i  0     1  0                                 1  undecided  no      1e-9    no
Not certified: #2: not tried
)"));
}

TEST_CASE("curve_result_text: two curves in the plane, w left out where it is 1") {
  CHECK(contains(curve_result_text(curves_in_plane(), {}, false),
                 R"(
  #  t        u    x       y       multiplicity  real  inside  radius  certified
  1  1 - 2i  -1i   3 - 4i  5 + 6i             1  no    no      1e-3    yes
  2  1 - 2i   inf  3 - 4i  5 + 6i             1  no    no      1e-3    yes
)"));
}

TEST_CASE("curve_result_text: an overlap is said in words, and the audit is that of the rest") {
  CurveResult result;
  result.problem = "curve_surface";
  result.status = Status::infinite;
  result.rest_status = Status::certified;
  const std::string nowhere = curve_result_text(result, {}, false);
  CHECK(
      nowhere.starts_with("Status: infinite: the curve lies in the surface\n"
                          "Rest:   certified: every solution proven, multiplicities exact, nothing missing\n"
                          "\nThe curve lies in the surface, but nowhere inside the domains.\n"
                          "\nCount audit of the rest, with multiplicity\n  0  found (0 solutions)\n"));
  CHECK(contains(nowhere, "\nThere are no other solutions.\n"));
  result.overlap = {Overlap{ParameterInterval{number("0"), number("1.5")}, {}, true},
                    Overlap{ParameterInterval{number("2"), infinity}, {}, true},
                    Overlap{ParameterInterval{infinity, number("-2")}, {}, false}};
  CHECK(contains(curve_result_text(result, {}),
                 "\nThe curve lies in the surface where\n  0 <= t <= 1.5\n  t >= 2\n  t <= -2 (not certified)\n"));
  result.problem = "curve_curve";
  result.overlap = {
      Overlap{ParameterInterval{number("0"), number("1")}, ParameterInterval{number("3"), number("4")}, true},
      Overlap{{}, {}, true}};
  CHECK(contains(curve_result_text(result, {}),
                 "\nThe curves coincide where\n  0 <= t <= 1, 3 <= u <= 4\n  all t, all u\n"));
}

TEST_CASE("curve_result_text: a sum that fails is named, but two curves in space promise no sum") {
  CurveResult result = curve_in_space();
  result.counts.expected = 4;
  result.solutions.pop_back();
  const std::string text = curve_result_text(result, {});
  CHECK(contains(text, "THE SUM FAILS: the multiplicities found are not as many as expected"));
  CHECK(contains(text, "THE SUM FAILS: the multiplicities listed add up to 2"));

  result = {};
  result.problem = "curve_curve";
  result.status = Status::certified;
  result.counts = {.distinct = 1, .with_multiplicity = 2};
  const std::string space = curve_result_text(result, {});
  CHECK(contains(space,
                 "multiplicity\n  2  found (1 solution)\nSolutions: 0 real, 1 not real, 0 undecided; 0 inside; "
                 "0 of 1 listed\n"));
  CHECK(contains(space, "None of the 1 solution is in the part that was asked for."));
}

TEST_CASE("curve_result_text: empty lists are said in words, and a limit too") {
  CurveResult result;
  result.problem = "curve_surface";
  CHECK(contains(curve_result_text(result, {}), "\nThe curve does not meet the surface.\n"));
  result.problem = "curve_curve";
  CHECK(contains(curve_result_text(result, {}), "\nThe curves have no common point.\n"));
  result.status = Status::incomplete;
  result.limit = "the time limit was reached";
  const std::string limited = curve_result_text(result, {});
  CHECK(contains(limited, "Status: incomplete: the time limit was reached\n"));
  CHECK(contains(limited, "\nFound so far: 0 solutions; the rest is not known.\n"));
  CHECK(contains(limited, "\nNo solutions are listed.\n"));
}

namespace {

// An isolated point, a cusp and a pair through infinity, of a closed curve.
CurveResult curve_with_itself() {
  CurveResult result;
  result.problem = "self_intersection";
  result.in_plane = true;
  result.status = Status::certified;
  result.counts = {.distinct = 3, .real = 3, .inside = 2, .with_multiplicity = 4, .expected = 4, .listed = 3};
  const auto pair = [](const Parameter& t, const Parameter& u, intersect::PairKind kind, unsigned long multiplicity) {
    CurveSolution solution;
    solution.t = t;
    solution.u = u;
    solution.kind = kind;
    solution.point = {number("1"), number("2"), number("1")};
    solution.multiplicity = multiplicity;
    solution.inside = kind != intersect::PairKind::isolated;
    solution.radius_exponent = -15;
    solution.reality = Reality::real;
    solution.certified = true;
    return solution;
  };
  result.solutions = {pair(number("0.5", "-1"), number("0.5", "1"), intersect::PairKind::isolated, 1),
                      pair(number("2"), number("2"), intersect::PairKind::cusp, 2),
                      pair(number("3"), infinity, intersect::PairKind::crossing, 1)};
  result.singular_points = {
      {result.solutions[0].point, {number("0.5", "-1"), number("0.5", "1"), number("7")}, Reality::real, 3}};
  result.closed = true;
  return result;
}

}  // namespace

TEST_CASE("curve_result_json: of a curve with itself kinds, points, and that it is closed") {
  const std::string json = curve_result_json(curve_with_itself(), std::nullopt);
  CHECK(contains(json, R"("problem": "self_intersection")"));
  CHECK(contains(json, R"("t": ["0.5", "-1"],)"));
  CHECK(contains(json, R"("kind": "isolated")"));
  CHECK(contains(json, R"("kind": "cusp")"));
  CHECK(contains(json, R"("u": "inf")"));
  CHECK(contains(json, R"("parameters": [["0.5", "-1"], ["0.5", "1"], ["7", "0"]])"));
  CHECK(contains(json, R"("closed": true)"));
  CHECK(contains(json, R"("covering": 1)"));
  CurveResult by_equation = curve_with_itself();
  by_equation.first_implicit = true;
  for (CurveSolution& solution : by_equation.solutions) {
    solution.t.reset();
    solution.u.reset();
    solution.kind.reset();
  }
  const std::string plain = curve_result_json(by_equation, std::nullopt);
  CHECK(contains(plain, R"("kind": null)"));
  for (const char* field : {"\"t\"", "\"u\"", "singular_points", "closed", "covering"})
    CHECK_FALSE(contains(plain, field));
}

TEST_CASE("curve_result_csv: of a curve with itself the last column is the kind") {
  const std::string csv = curve_result_csv(curve_with_itself());
  CHECK(csv.starts_with(
      "t_re,t_im,u_re,u_im,x_re,x_im,y_re,y_im,w_re,w_im,radius,real,multiplicity,inside,certified,kind\n"));
  CHECK(contains(csv, "\n0.5,-1,0.5,1,1,0,2,0,1,0,1e-15,true,1,false,true,isolated\n"));
  CHECK(contains(csv, "\n3,0,inf,0,1,0,2,0,1,0,1e-15,true,1,true,true,crossing\n"));
}

TEST_CASE("curve_result_text: a real point shows its conjugate parameters, and points of many parameters a sentence") {
  const std::string text = curve_result_text(curve_with_itself(), {});
  CHECK(contains(text, "0.5 - 1i"));
  CHECK(contains(text, "isolated"));
  CHECK(contains(text, "One point has the parameters 0.5 - 1i, 0.5 + 1i, 7; its pairs have multiplicity 3 in all.\n"));
  CHECK(contains(text, "The curve is closed"));
  CurveResult none = curve_with_itself();
  none.solutions.clear();
  none.singular_points.clear();
  none.counts = {};
  CHECK(contains(curve_result_text(none, {}), "The curve does not meet itself."));
  Overlap folded;
  folded.t = folded.u = ParameterInterval{number("-1"), number("1")};
  folded.certified = true;
  none.overlap = {folded};
  none.covering = 2;
  none.status = Status::infinite;
  CHECK(contains(curve_result_text(none, {}), "2 times"));
  CHECK(contains(curve_result_text(none, {}), "-1 <= t <= 1, -1 <= u <= 1"));
}
