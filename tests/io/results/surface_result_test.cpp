// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <io/surface_results.hpp>

#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/results/surface_result_csv.hpp>
#include <eliminant/io/results/surface_result_json.hpp>
#include <eliminant/io/results/surface_result_text.hpp>

using namespace eliminant;
using namespace eliminant::io;
using intersect::SurfaceResult;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool is_null(const JsonValue* value) { return value != nullptr && value->kind == JsonValue::Kind::null; }

const SurfaceDomains domains{symbolic::Interval{0, 1},
                             symbolic::Interval{0, symbolic::Rational(symbolic::Integer(7), symbolic::Integer(2))},
                             std::nullopt, std::nullopt};

}  // namespace

TEST_CASE("Surface results: JSON has the fields of the contract") {
  const JsonDocument document(surface_result_json(test::two_surfaces(), domains, ProblemId(7L), false));
  const JsonValue& root = document.root();
  CHECK(root.find("format")->text == "1");
  CHECK(root.find("problem")->text == "surface_surface");
  CHECK(root.find("id")->text == "7");
  CHECK(root.find("status")->text == "numeric");
  CHECK(root.find("counts")->find("curves")->text == "1");
  CHECK(root.find("counts")->find("loops")->text == "1");
  CHECK(root.find("counts")->find("points")->text == "1");
  CHECK(root.find("counts")->find("overlaps")->text == "0");
  CHECK(root.find("counts")->find("singular")->text == "1");
  CHECK(root.find("counts")->find("excluded")->text == "2");
  CHECK(root.find("domains")->find("v")->elements.at(1).text == "7/2");
  CHECK(is_null(root.find("domains")->find("s")));
  CHECK(root.find("warnings")->elements.at(0).text == "a warning");
  CHECK(root.find("seconds")->find("total")->text == "0.5");
  CHECK(root.find("projection") == nullptr);
  REQUIRE(root.find("components")->elements.size() == 3);
}

TEST_CASE("Surface results: JSON of a curve, with words for its ends") {
  const JsonDocument document(surface_result_json(test::two_surfaces(), domains, {}, false));
  CHECK(document.root().find("id") == nullptr);
  const JsonValue& curve = document.root().find("components")->elements.at(0);
  CHECK(curve.find("kind")->text == "curve");
  const JsonValue& start = *curve.find("start");
  CHECK(start.find("on")->text == "border");
  REQUIRE(start.find("border")->elements.size() == 2);
  CHECK(start.find("border")->elements[0].text == "u=lower");
  CHECK(start.find("border")->elements[1].text == "t=upper");
  CHECK(start.find("transition")->text == "out");
  const JsonValue& end = *curve.find("end");
  CHECK(end.find("on")->text == "singular_point");
  CHECK(end.find("singular_point")->text == "0");
  CHECK(end.find("transition") == nullptr);
  CHECK(curve.find("error")->text == "1e-09");
  CHECK_FALSE(curve.find("tangential")->boolean);
  CHECK(curve.find("certified")->boolean);
  CHECK(curve.find("reason") == nullptr);
  CHECK(curve.find("mirrored") == nullptr);
  const auto& points = curve.find("points")->elements;
  REQUIRE(points.size() == 2);
  // Every number is a decimal text; infinity is a word, an unknown number null, zero has no sign.
  CHECK(points[0].find("u")->kind == JsonValue::Kind::text);
  CHECK(points[0].find("u")->text == "0");
  CHECK(points[0].find("v")->text == "0.1");
  CHECK(points[0].find("s")->text == "inf");
  CHECK(is_null(points[0].find("t")));
  CHECK(points[0].find("x")->text == "-2.5");
  CHECK(points[1].find("s")->text == "inf");
  CHECK(points[1].find("z")->text == "-inf");
  // The rest.
  const JsonValue& loop = document.root().find("components")->elements.at(1);
  CHECK(loop.find("start") == nullptr);
  CHECK(loop.find("tangential")->boolean);
  CHECK_FALSE(loop.find("certified")->boolean);
  CHECK(loop.find("reason")->text == "a contact along a curve is not proven");
  const JsonValue& singular = document.root().find("singular_points")->elements.at(0);
  CHECK(singular.find("kind")->text == "crossing");
  CHECK(singular.find("u")->text == "0.5");
  CHECK(singular.find("radius")->text == "1e-12");
  CHECK(singular.find("half_branches")->text == "4");
}

TEST_CASE("Surface results: JSON of a B-spline") {
  const JsonDocument document(surface_result_json(test::two_surfaces(), domains, {}, false));
  const auto& components = document.root().find("components")->elements;
  CHECK(components[1].find("spline") == nullptr);
  const JsonValue& spline = *components[0].find("spline");
  CHECK(spline.find("degree")->text == "3");
  CHECK(spline.find("error")->text == "2e-09");
  CHECK(spline.find("coordinates")->elements.size() == 7);
  CHECK(spline.find("knots")->elements.size() == 8);
  REQUIRE(spline.find("control_points")->elements.size() == 4);
  const auto& point = spline.find("control_points")->elements[1].elements;
  REQUIRE(point.size() == 7);
  CHECK(point[0].text == "0.25");
  CHECK(point[3].kind == JsonValue::Kind::null);
}

TEST_CASE("Surface results: JSON of a self-intersection, with its eliminant on request") {
  const SurfaceResult result = test::with_itself();
  const JsonDocument brief(surface_result_json(result, {}, {}, false));
  CHECK(brief.root().find("problem")->text == "self_intersection");
  CHECK(brief.root().find("components")->elements.at(0).find("mirrored")->boolean);
  const JsonValue& projection = *brief.root().find("projection");
  CHECK(projection.find("variables")->elements.at(1).text == "v");
  CHECK(projection.find("degrees")->elements.at(0).text == "3");
  CHECK(projection.find("degrees")->elements.at(1).text == "1");
  CHECK(projection.find("total_degree")->text == "4");
  CHECK(projection.find("terms")->text == "2");
  CHECK(projection.find("matrix_size")->text == "3");
  CHECK(projection.find("rank")->text == "3");
  CHECK(projection.find("vanishing") == nullptr);
  CHECK(projection.find("equation") == nullptr);
  CHECK(projection.find("curve")->find("terms")->text == "2");
  const auto& factors = projection.find("factors")->elements;
  REQUIRE(factors.size() == 2);
  CHECK(factors[0].find("kind")->text == "base_point");
  CHECK(factors[0].find("multiplicity")->text == "2");
  CHECK(contains(factors[0].find("reason")->text, "base points"));
  CHECK(factors[1].find("proven")->boolean);
  CHECK(projection.find("stationary")->find("u")->elements.at(0).text == "u^2 - 2");
  const JsonDocument full(surface_result_json(result, {}, {}, true));
  CHECK(full.root().find("projection")->find("equation")->text == "u^3*v - u^2");
  CHECK(full.root().find("projection")->find("curve")->find("equation")->text == "u*v - 1");
  CHECK(full.root().find("projection")->find("factors")->elements[0].find("equation")->text == "u");
}

TEST_CASE("Surface results: what was found before a limit stays") {
  SurfaceResult result = test::two_surfaces();
  result.status = intersect::Status::incomplete;
  result.limit = "the time limit was reached";
  const JsonDocument document(surface_result_json(result, {}, {}, false));
  CHECK(document.root().find("status")->text == "incomplete");
  CHECK(document.root().find("error")->find("kind")->text == "limit");
  CHECK(document.root().find("components")->elements.size() == 3);
  const std::string text = surface_result_text(result, {});
  CHECK(text.starts_with("Status: incomplete: the time limit was reached\n"));
  CHECK(contains(text, "u=lower t=upper, out"));
  CHECK(contains(surface_result_csv(result), "\n2,point,"));
}

TEST_CASE("Surface results: CSV has a line for every point") {
  CHECK(surface_result_csv(test::two_surfaces()) ==
        "component,kind,u,v,s,t,x,y,z\n"
        "0,curve,0,0.1,inf,,-2.5,0,1\n"
        "0,curve,0.5,0.5,inf,0.25,0,1e-20,-inf\n"
        "1,loop,0.2,0.2,0.2,0.2,1,2,3\n"
        "1,loop,0.3,0.2,0.2,0.2,1,2,4\n"
        "1,loop,0.2,0.2,0.2,0.2,1,2,3\n"
        "2,point,0.75,0.25,0.5,0.5,0.125,0,0\n");
  CHECK(surface_result_csv(SurfaceResult{}) == "component,kind,u,v,s,t,x,y,z\n");
}

TEST_CASE("Surface results: text") {
  const std::string text = surface_result_text(test::two_surfaces(), {});
  for (const char* part :
       {"Status: numeric", "The surfaces meet in", "1  curve from end to end", "1  closed curve", "1  point on its own",
        "1  singular point", "2  real parts of the projection excluded", "u=lower t=upper, out", "singular point 0",
        "crossing", "Not certified: component 1: a contact along a curve is not proven", "Points on their own"})
    CHECK_MESSAGE(contains(text, part), part);
  CHECK_FALSE(contains(text, "common part"));
  RunOptions options;
  CHECK_FALSE(contains(surface_result_text(test::with_itself(), options), "D = "));
  options.solve.equation = true;
  const std::string itself = surface_result_text(test::with_itself(), options);
  for (const char* part :
       {"Status: certified: every component found, of the kind said, none missing", "The surface meets itself in",
        "Eliminant D(u, v): bidegree (3, 1), total degree 4, 2 terms", "D = u^3*v - u^2", "mirrored", "pinch_point"})
    CHECK_MESSAGE(contains(itself, part), part);
  SurfaceResult overlapping;
  overlapping.status = intersect::Status::infinite;
  overlapping.counts.overlaps = 2;
  CHECK(surface_result_text(overlapping, {}).starts_with("Status: infinite: the surfaces have a part in common\n"));
  CHECK(contains(surface_result_text(overlapping, {}), "2  common parts of both surfaces"));
}

TEST_CASE("Surface results: words of every kind are different") {
  const auto all_different = [](const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) CHECK(words[i] != words[j]);
  };
  std::vector<std::string> words;
  for (int i = 0; i < 4; ++i) words.emplace_back(word_for(static_cast<intersect::SurfaceComponentKind>(i)));
  CHECK(words == std::vector<std::string>{"curve", "loop", "point", "overlap"});
  words.clear();
  for (int i = 0; i < 4; ++i) words.emplace_back(word_for(static_cast<intersect::BranchEndKind>(i)));
  CHECK(words == std::vector<std::string>{"border", "singular_point", "infinity", "unknown"});
  words.clear();
  for (int i = 0; i < 3; ++i) words.emplace_back(word_for(static_cast<intersect::Transition>(i)));
  CHECK(words == std::vector<std::string>{"out", "in", "touching"});
  words.clear();
  for (int i = 0; i < 6; ++i) words.emplace_back(word_for(static_cast<intersect::SurfaceSingularity>(i)));
  CHECK(words == std::vector<std::string>{"contact", "crossing", "cusp", "pinch_point", "triple_point", "undecided"});
  words.clear();
  for (int i = 0; i < 5; ++i) words.emplace_back(word_for(static_cast<symbolic::ComponentKind>(i)));
  all_different(words);
  words.clear();
  for (int i = 0; i < 5; ++i) words.emplace_back(word_for(static_cast<symbolic::DeterminantVanishing>(i)));
  all_different(words);
  intersect::BranchEnd corner;
  corner.side = {1, -1, 0, 1};
  CHECK(border_words(corner) == std::vector<std::string>{"u=upper", "v=lower", "t=upper"});
  corner.side = {0, -1, -1, 0};
  corner.third_side = {true, true};
  CHECK(border_words(corner) == std::vector<std::string>{"v=lower", "u+v=upper", "s=lower", "s+t=upper"});
}
