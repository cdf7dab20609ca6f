// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <io/surface_results.hpp>

#include <eliminant/io/pictures/html_report.hpp>
#include <eliminant/io/pictures/picture_scale.hpp>
#include <eliminant/io/pictures/result_picture.hpp>
#include <eliminant/io/pictures/svg_picture.hpp>
#include <eliminant/io/results/surface_result_json.hpp>

using namespace eliminant;
using namespace eliminant::io;

namespace {

const SurfaceDomains unit{symbolic::Interval{0, 1}, symbolic::Interval{0, 1}, symbolic::Interval{0, 1},
                          symbolic::Interval{symbolic::Rational(symbolic::Integer(-1), symbolic::Integer(2)), 1}};

Picture picture_of(const intersect::SurfaceResult& result, const SurfaceDomains& domains) {
  return result_picture(surface_result_json(result, domains, ProblemId(std::string("a <b> & c")), false));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

bool has_mark(const PicturePanel& panel, PictureShape shape, double x, double y) {
  return std::any_of(panel.marks.begin(), panel.marks.end(), [&](const PictureMark& mark) {
    return mark.shape == shape && mark.at == std::array<double, 2>{x, y};
  });
}

bool explains(const Picture& picture, const std::string& text) {
  return std::any_of(picture.legend.begin(), picture.legend.end(),
                     [&](const PictureLegend& entry) { return entry.text == text; });
}

const std::string head = R"({"format": 1, "problem": )";

}  // namespace

TEST_CASE("Pictures: both parameter planes and space, with curves, points, ends and singular points") {
  const Picture picture = picture_of(test::two_surfaces(), unit);
  CHECK(picture.title == "Intersection of two surfaces: a <b> & c");
  CHECK(picture.subtitle == "numeric: curves 1, loops 1, points 1, singular 1, excluded 2");
  REQUIRE(picture.panels.size() == 3);
  const PicturePanel& first = picture.panels[0];
  CHECK(first.axes == std::array<std::string, 2>{"u", "v"});
  REQUIRE(first.border);
  CHECK((*first.border)[1] == std::array<double, 2>{0, 1});
  REQUIRE(first.curves.size() == 2);
  CHECK(first.curves[0].points[0] == std::array<double, 2>{0, 0.1});
  CHECK_FALSE(first.curves[0].closed);
  CHECK(first.curves[1].closed);
  CHECK(has_mark(first, PictureShape::ring, 0, 0.1));
  CHECK(has_mark(first, PictureShape::diamond, 0.75, 0.25));
  CHECK(has_mark(first, PictureShape::cross, 0.5, 0.5));
  // The end at the crossing has no mark of its own.
  CHECK(first.marks.size() == 3);
  const PicturePanel& second = picture.panels[1];
  CHECK((*second.border)[1] == std::array<double, 2>{-0.5, 1});
  CHECK(std::isinf(second.curves[0].points[0][0]));
  CHECK(std::isnan(second.curves[0].points[0][1]));
  CHECK(picture.panels[2].space);
  for (const char* text :
       {"0: curve from u=lower t=upper, out to singular point 0", "1: loop", "contact", "crossing", "end on a border"})
    CHECK_MESSAGE(explains(picture, text), text);
  REQUIRE(picture.tables.size() == 2);
  CHECK(picture.tables[0].rows.size() == 3);
  CHECK(picture.tables[0].rows[1].back() == "a contact along a curve is not proven; tangential");
}

TEST_CASE("Pictures: a self-intersection shows both preimages in one plane, an equation has no plane") {
  const Picture itself = picture_of(test::with_itself(), {});
  REQUIRE(itself.panels.size() == 2);
  CHECK_FALSE(itself.panels[0].border);
  CHECK(itself.panels[0].projective);
  CHECK(itself.panels[1].unbounded);
  CHECK(itself.panels[0].axes == std::array<std::string, 2>{"u, s", "v, t"});
  REQUIRE(itself.panels[0].curves.size() == 2);
  CHECK_FALSE(itself.panels[0].curves[0].dashed);
  CHECK(itself.panels[0].curves[1].dashed);
  CHECK(itself.panels[0].curves[0].color == itself.panels[0].curves[1].color);
  CHECK(explains(itself, "pinch point"));
  intersect::SurfaceResult equation = test::two_surfaces();
  for (auto& component : equation.components)
    for (auto& point : component.points) point.parameters[2] = point.parameters[3] = NAN;
  equation.singular_points.clear();
  const Picture one = picture_of(equation, {unit[0], unit[1], std::nullopt, std::nullopt});
  REQUIRE(one.panels.size() == 2);
  CHECK(one.panels[0].axes[0] == "u");
  CHECK(one.panels[1].space);
}

TEST_CASE("Pictures: SVG is well formed, the same each time, and shows every curve and mark") {
  const Picture picture = picture_of(test::two_surfaces(), unit);
  const std::string svg = svg_picture(picture);
  CHECK(svg == svg_picture(picture));
  CHECK(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  CHECK(svg.ends_with("</svg>\n"));
  CHECK(count(svg, "a &lt;b&gt; &amp; c") == 2);
  CHECK(svg.find("<b>") == std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  // A curve and a loop in three panels; the curve has one finite point on the second plane.
  CHECK(count(svg, "stroke-linejoin") == 5);
  CHECK(count(svg, "<clipPath") == 3);
  // Two rectangles for each of the two domains.
  CHECK(count(svg, "fill=\"none\" stroke=\"#555555\"") == 2);
  const std::string html = html_report(picture);
  CHECK(html.starts_with("<!DOCTYPE html>"));
  CHECK(count(html, "<table>") == 2);
  CHECK(count(html, "</tr>") == 6);
  CHECK(html.find(svg) != std::string::npos);
}

TEST_CASE("Pictures: a plane curve and common points") {
  const Picture curve = result_picture(head + R"("curve_topology", "status": "certified", "variables": ["a", "b"],
    "counts": {"components": 2, "faces": 0}, "vertices": [
     {"kind": "infinity", "x": "-inf", "y": null},
     {"kind": "singular", "type": "node", "x": "0.5", "y": "-1"},
     {"kind": "critical", "x": "2", "y": "0"}],
    "edges": [{"from": 0, "to": 1, "polyline": [["-1", "0"], ["0.5", "-1"]]},
              {"from": 2, "to": 2, "polyline": [["2", "0"], ["3", "1"], ["2", "0"]]}],
    "loops": [[1]]})");
  CHECK(curve.title == "Topology of a plane curve");
  CHECK(curve.subtitle == "certified: components 2");
  REQUIRE(curve.panels.size() == 1);
  CHECK(curve.panels[0].axes == std::array<std::string, 2>{"a", "b"});
  REQUIRE(curve.panels[0].curves.size() == 2);
  CHECK(curve.panels[0].curves[0].color != curve.panels[0].curves[1].color);
  CHECK(has_mark(curve.panels[0], PictureShape::cross, 0.5, -1));
  CHECK(curve.panels[0].marks.size() == 2);
  CHECK(curve.tables[0].rows.size() == 3);
  const Picture points = result_picture(head + R"("plane_curves", "status": "certified", "solutions": [
     {"x": ["1", "0"], "y": ["2", "0"], "real": true, "multiplicity": 2, "certified": true},
     {"x": ["1", "1"], "y": ["2", "0"], "real": false, "multiplicity": 1, "certified": true}]})");
  REQUIRE(points.panels[0].marks.size() == 1);
  CHECK(has_mark(points.panels[0], PictureShape::diamond, 1, 2));
}

TEST_CASE("Pictures: what is no result, or has no picture, is refused") {
  for (const char* text :
       {"[]", "1", "{}", R"({"problem": "surface_surface", "first": {}})", R"({"format": 2, "status": "certified"})",
        R"({"format": 1, "problem": "plane_curves", "status": "error", "error": {}})",
        R"({"format": 1, "problem": "curve_curve", "status": "certified", "solutions": []})",
        R"({"format": 1, "problem": "self_intersection", "status": "certified", "solutions": []})",
        R"({"format": 1, "problem": null, "status": "certified"})"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(result_picture(text), InvalidInput);
  }
  CHECK_THROWS_AS(result_picture("{"), ParseError);
  CHECK_THROWS_AS(result_picture("no JSON"), ParseError);
  // Fields of other types than expected, or none, are nothing to draw.
  for (
      const char* text :
      {R"({"format": 1, "problem": "surface_surface", "status": "numeric"})",
       R"({"format": 1, "problem": "surface_surface", "status": "numeric", "components": {"points": 1}, "domains": []})",
       R"({"format": 1, "problem": "surface_surface", "status": "numeric", "components": [1, {"kind": "curve", "points": [{}]}]})",
       R"({"format": 1, "problem": "curve_topology", "status": "numeric", "edges": [{"polyline": [[1]]}], "loops": [[7, -1]]})",
       R"({"format": 1, "problem": "plane_curves", "status": "numeric", "solutions": [[], {"real": true}]})"}) {
    CAPTURE(text);
    CHECK_NOTHROW(html_report(result_picture(text)));
  }
}

TEST_CASE("Pictures: the view holds the border, everything, or most of what runs to infinity") {
  PicturePanel panel;
  panel.border = {{{0, 2}, {-1, 1}}};
  const auto bordered = view_of(panel);
  CHECK((bordered[0].contains(0) && bordered[0].contains(2)));
  CHECK_FALSE(bordered[0].contains(2.5));
  panel.border.reset();
  PictureCurve& curve = panel.curves.emplace_back();
  for (int i = 0; i <= 100; ++i) curve.points.push_back({i / 100.0, 1});
  curve.points.push_back({1e9, 1});
  curve.points.push_back({INFINITY, NAN});
  CHECK(view_of(panel)[0].contains(1e9));
  panel.unbounded = true;
  const auto most = view_of(panel);
  CHECK((most[0].contains(0) && most[0].contains(1)));
  CHECK_FALSE(most[0].contains(10));
  CHECK(most[1].contains(1));
  CHECK(most[1].lower < most[1].upper);
  const auto nothing = view_of({});
  CHECK(nothing[0].lower < nothing[0].upper);
}

TEST_CASE("Pictures: a projective line has infinity at both ends, and curves run through it") {
  PicturePanel panel;
  panel.projective = true;
  CHECK(drawn(panel, 0) == 0);
  CHECK(drawn(panel, 1) == doctest::Approx(0.5));
  CHECK(drawn(panel, -INFINITY) == doctest::Approx(-1));
  const auto view = view_of(panel);
  CHECK((view[0].contains(-1) && view[0].contains(1)));
  CHECK(ticks_in(panel, view[0]).front().name == "\u221e");
  PictureCurve curve;
  curve.points = {{1, 0}, {100, 0}, {-100, 0}, {-1, 0}};
  const auto points = drawn(panel, curve);
  REQUIRE(points.size() == 7);
  CHECK(points[2] == std::array<double, 2>{1, 0});
  CHECK(std::isnan(points[3][0]));
  CHECK(points[4] == std::array<double, 2>{-1, 0});
  // Infinity itself, reached from below zero.
  curve.points = {{-100, 0}, {INFINITY, 0}, {100, 0}};
  CHECK(drawn(panel, curve).size() == 6);
  panel.projective = false;
  CHECK(drawn(panel, curve) == curve.points);
}

TEST_CASE("Pictures: ticks are round numbers inside") {
  const auto names = [](const PictureRange& range) {
    std::vector<std::string> texts;
    for (const PictureTick& tick : ticks_in({}, range)) texts.push_back(tick.name);
    return texts;
  };
  CHECK(names({0, 1}) == std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"});
  CHECK(names({-1, 5}) == std::vector<std::string>{"-1", "0", "1", "2", "3", "4", "5"});
  CHECK(names({-3e-7, 3e-7}) == std::vector<std::string>{"-3e-07", "-2e-07", "-1e-07", "0", "1e-07", "2e-07", "3e-07"});
  CHECK(names({0, 1e6}).size() == 6);
}

TEST_CASE("Pictures: space is seen along its diagonal") {
  const std::array<double, 2> z = seen_from_diagonal({0, 0, 1});
  CHECK(z[0] == 0);
  CHECK(z[1] > 0);
  const std::array<double, 2> diagonal = seen_from_diagonal({2, 2, 2});
  CHECK(std::fabs(diagonal[0]) + std::fabs(diagonal[1]) < 1e-15);
}
