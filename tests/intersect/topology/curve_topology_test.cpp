// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <support/binary_numbers.hpp>
#include <support/plane_curves.hpp>
#include <support/topology_checks.hpp>

using namespace eliminant;
using namespace eliminant::test;

namespace {

Rational value_at(const Polynomial& p, const Rational& x, const Rational& y) {
  const std::array images{Polynomial::constant(2, x), Polynomial::constant(2, y)};
  return p.compose(images).constant_term();
}

/// The vertex nearest to a point.
const TopologyVertex& vertex_near(const TopologyResult& result, double x, double y) {
  const auto distance = [&](const TopologyVertex& v) {
    return v.kind == VertexKind::infinity ? 1e300 : std::hypot(std::stod(v.x.real) - x, std::stod(v.y.real) - y);
  };
  return *std::min_element(result.vertices.begin(), result.vertices.end(),
                           [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

}  // namespace

TEST_CASE("Curve topology: known curves have the known shape") {
  // {components, cycles, loops, isolated, ends at infinity, {{half-branches, Milnor number}, ...}}
  CHECK(checked_shape("x^2 + y^2 - 1") == Shape{1, 1, 1, 0, 0, {}});
  CHECK(checked_shape("x^2 + y^2 + 1") == Shape{0, 0, 0, 0, 0, {}});
  CHECK(checked_shape("(x^2 + y^2)^2 - x^2 + y^2") == Shape{1, 2, 0, 0, 0, {{4, 1}}});
  CHECK(checked_shape("y^2 - x^2 - x^3") == Shape{1, 1, 0, 0, 2, {{4, 1}}});
  CHECK(checked_shape("y^2 + x^2 - x^3") == Shape{2, 0, 0, 1, 2, {{0, 1}}});
  CHECK(checked_shape("y^2 - x^3") == Shape{1, 0, 0, 0, 2, {{2, 2}}});
  CHECK(checked_shape("y^3 - x^2") == Shape{1, 0, 0, 0, 2, {{2, 2}}});
  CHECK(checked_shape("y^2 - x^3 + x") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("y^2 - x^5") == Shape{1, 0, 0, 0, 2, {{2, 4}}});
  CHECK(checked_shape("x^2 + y^2") == Shape{1, 0, 0, 1, 0, {{0, 1}}});
  CHECK(checked_shape("x^2 - y^4") == Shape{1, 0, 0, 0, 4, {{4, 3}}});
  CHECK(checked_shape("x^2 + y^4") == Shape{1, 0, 0, 1, 0, {{0, 3}}});
  CHECK(checked_shape("(x^2 + y^2 - 1)^3 + 27*x^2*y^2") == Shape{1, 1, 1, 0, 0, {{2, 2}, {2, 2}, {2, 2}, {2, 2}}});
  CHECK(checked_shape("x^2*y^2 - x^2 - y^2") == Shape{5, 0, 0, 1, 8, {{0, 1}}});
  CHECK(checked_shape("(y - x^20)*(y + x^20)") == Shape{1, 0, 0, 0, 4, {{4, 39}}});
  // The folium of Descartes, a rose of three leaves, a cardioid, the devil's curve y^4 - x^4 + 25 x^2 - 24 y^2.
  CHECK(checked_shape("x^3 + y^3 - 3*x*y") == Shape{1, 1, 0, 0, 2, {{4, 1}}});
  CHECK(checked_shape("(x^2 + y^2)^2 - x^3 + 3*x*y^2") == Shape{1, 3, 0, 0, 0, {{6, 4}}});
  CHECK(checked_shape("(x^2 + y^2 - x)^2 - x^2 - y^2") == Shape{1, 1, 1, 0, 0, {{2, 2}}});
  CHECK(checked_shape("y^4 - x^4 + 25*x^2 - 24*y^2") == Shape{3, 2, 0, 0, 4, {{4, 1}}});
}

TEST_CASE("Curve topology: lines, vertical ones and asymptotes among them") {
  CHECK(checked_shape("x") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("y") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("x - y") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("x*(x - 1)*(x^2 - 2)*(x^2 + 1)") == Shape{4, 0, 0, 0, 8, {}});
  CHECK(checked_shape("x*y") == Shape{1, 0, 0, 0, 4, {{4, 1}}});
  CHECK(checked_shape("x*y*(x - y)") == Shape{1, 0, 0, 0, 6, {{6, 4}}});
  CHECK(checked_shape("x*y*(x - y)*(x + y)") == Shape{1, 0, 0, 0, 8, {{8, 9}}});
  CHECK(checked_shape("(x^2 - 1)*(y^2 - 1)") == Shape{1, 1, 0, 0, 8, {{4, 1}, {4, 1}, {4, 1}, {4, 1}}});
  CHECK(checked_shape("x*(x^2 + y^2 - 1)") == Shape{1, 2, 0, 0, 2, {{4, 1}, {4, 1}}});
  CHECK(checked_shape("(x - 1)*(x^2 + y^2 - 1)") == Shape{1, 1, 0, 0, 2, {{4, 3}}});
  CHECK(checked_shape("(x - 2)*(x^2 + y^2 - 1)") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("x*(y^2 - x^3)") == Shape{1, 0, 0, 0, 4, {{4, 5}}});
  CHECK(checked_shape("x*y - 1") == Shape{2, 0, 0, 0, 4, {}});
  CHECK(checked_shape("x*(x*y - 1)") == Shape{3, 0, 0, 0, 6, {}});
  CHECK(checked_shape("x^2*y - 1") == Shape{2, 0, 0, 0, 4, {}});
  CHECK(checked_shape("(x^2 + 1)*y - 1") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("(x^2 - 2)*y^2 - 1") == Shape{4, 0, 0, 0, 8, {}});
  CHECK(checked_shape("(x^2 - 2)*y^2 + y - x") == checked_shape("(y^2 - 2)*x^2 + x - y"));
  // Through infinity and a finite point of one fibre.
  CHECK(checked_shape("y*(x*y - 1)") == Shape{3, 0, 0, 0, 6, {}});
  CHECK(checked_shape("(x*y - 1)*(y - x)") == Shape{1, 0, 0, 0, 6, {{4, 1}, {4, 1}}});
}

TEST_CASE("Curve topology: isolated points, tacnodes and triple points") {
  CHECK(checked_shape("(x^2 + y^2)*(x - 1)") == Shape{2, 0, 0, 1, 2, {{0, 1}}});
  CHECK(checked_shape("(x^2 + y^2)*((x - 3)^2 + y^2)*(x^2 + y^2 - 1)") == Shape{3, 1, 1, 2, 0, {{0, 1}, {0, 1}}});
  CHECK(checked_shape("(x^2 + y^2)*y") == Shape{1, 0, 0, 0, 2, {{2, 4}}});
  CHECK(checked_shape("(x^2 + y^2)*x") == Shape{1, 0, 0, 0, 2, {{2, 4}}});
  CHECK(checked_shape("y*(y - x^2)") == Shape{1, 0, 0, 0, 4, {{4, 3}}});
  CHECK(checked_shape("x*(x - y^2)") == Shape{1, 0, 0, 0, 4, {{4, 3}}});
  CHECK(checked_shape("(y - x^2)*(y + x^2)*(y - 2*x^2)") == Shape{1, 0, 0, 0, 6, {{6, 10}}});
  CHECK(checked_shape("y*(y - x^3)") == Shape{1, 0, 0, 0, 4, {{4, 5}}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*((x - 2)^2 + y^2 - 1)") == Shape{1, 2, 0, 0, 0, {{4, 3}}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*((x - 1/2)^2 + y^2 - 1/4)") == Shape{1, 2, 0, 0, 0, {{4, 3}}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x^2 + (y - 2)^2 - 1)") == Shape{1, 2, 0, 0, 0, {{4, 3}}});
  CHECK(checked_shape("y^3 - x") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("y^4 - x") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("y^3 - x^5") == Shape{1, 0, 0, 0, 2, {{2, 8}}});
}

TEST_CASE("Curve topology: several events above one abscissa") {
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x^2 + (y - 5)^2 - 1)*(x^2 + (y - 10)^2 - 1)") == Shape{3, 3, 3, 0, 0, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*((x - 2)^2 + (y - 5)^2 - 1)*(x - 1)") == Shape{1, 2, 0, 0, 2, {{4, 3}, {4, 3}}});
  CHECK(checked_shape("((x^2 + y^2)^2 - x^2 + y^2)*((x^2 + (y - 3)^2)^2 - x^2 + (y - 3)^2)*(x^2 + (y - 6)^2)") ==
        Shape{3, 4, 0, 1, 0, {{0, 1}, {4, 1}, {4, 1}}});
}

TEST_CASE("Curve topology: branches and ovals that are close") {
  CHECK(checked_shape("(y - x^2)*(y - x^2 - 1/1000000)") == Shape{2, 0, 0, 0, 4, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x^2 + y^2 - 1 - 1/1000000)") == Shape{2, 2, 2, 0, 0, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*((x - 2 - 1/1000000)^2 + y^2 - 1)") == Shape{2, 2, 2, 0, 0, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*((x - 2 + 1/1000000)^2 + y^2 - 1)") == Shape{1, 3, 0, 0, 0, {{4, 1}, {4, 1}}});
  // Events closer than any fixed precision.
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x^2 + (y - 5)^2 - 1 - 1e-80)") == Shape{2, 2, 2, 0, 0, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x - 1 - 1e-80)") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("(x^2 + y^2 - 1)*(x - 1 + 1e-80)") == Shape{1, 2, 0, 0, 2, {{4, 1}, {4, 1}}});
  CHECK(checked_shape("(y^2 - x^2)*((y - 1e-40)^2 - x^2)") == Shape{1, 1, 0, 0, 8, {{4, 1}, {4, 1}, {4, 1}, {4, 1}}});
  CHECK(checked_shape("(x^2 + y^2)*(x^2 + (y - 1e-40)^2)") == Shape{2, 0, 0, 2, 0, {{0, 1}, {0, 1}}});
  // A node opened to either side, and a tiny oval.
  CHECK(checked_shape("y^2 - x^2 - x^3 - 1e-12") == Shape{1, 0, 0, 0, 2, {}});
  CHECK(checked_shape("y^2 - x^2 - x^3 + 1e-12") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("y^2 + x^2 - x^3 - 1e-12") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("y^2 + x^2 - x^3 - 1e-40") == Shape{2, 1, 1, 0, 2, {}});
  CHECK(checked_shape("y^2 + x^2 - x^3 + 1e-40") == Shape{1, 0, 0, 0, 2, {}});
}

TEST_CASE("Curve topology: Chebyshev curves have all their nodes") {
  // T_n(x) = T_m(y), m and n coprime: the image of t -> (T_m(t), T_n(t)), with (m - 1)(n - 1) / 2 crossings.
  const auto chebyshev = [](long n, const Polynomial& t) {
    Polynomial before = number(1);
    Polynomial last = t;
    for (long k = 1; k < n; ++k) {
      Polynomial next = Rational(2) * t * last - before;
      before = std::move(last);
      last = std::move(next);
    }
    return last;
  };
  for (const auto& [m, n] : {std::pair(2L, 3L), std::pair(3L, 4L), std::pair(4L, 5L), std::pair(5L, 7L)}) {
    INFO(m, " ", n);
    const auto nodes = static_cast<unsigned long>((m - 1) * (n - 1) / 2);
    const Shape expected{1, nodes, 0, 0, 2, SingularTypes(nodes, {4, 1})};
    CHECK(checked_shape(chebyshev(n, x()) - chebyshev(m, y())) == expected);
    CHECK(checked_shape(chebyshev(m, x()) - chebyshev(n, y())) == expected);
  }
}

TEST_CASE("Curve topology: coordinates have their digits at every scale") {
  for (const char* scale : {"1", "1e-12", "1e12"}) {
    const Rational factor = symbolic::parse_number(scale);
    const Polynomial circle = x() * x() + y() * y() - number(Rational(2) * factor * factor);
    const TopologyResult result = topology(circle * (x() - number(factor)));
    check_graph(result, false);
    std::size_t crossings = 0;
    for (const TopologyVertex& vertex : result.vertices) {
      if (vertex.kind != VertexKind::singular) continue;
      ++crossings;
      const Rational height = symbolic::parse_number(vertex.y.real);
      const Rational radius = symbolic::parse_number("1e" + std::to_string(vertex.radius_exponent));
      const Rational error = (height.sign() < 0 ? -height : height) - factor;
      CHECK(!(radius < error));
      CHECK(!(radius < -error));
      CHECK(radius < factor * symbolic::parse_number("1e-13"));
    }
    CHECK(crossings == 2);
  }
}

TEST_CASE("Curve topology: repeated factors count once, with a warning") {
  const TopologyResult once = topology("x*(y - x)*(x^2 + y^2 - 1)");
  const TopologyResult more = topology("x^2*(y - x)^3*(x^2 + y^2 - 1)");
  CHECK(shape_of(once) == shape_of(more));
  CHECK(once.warnings.empty());
  CHECK(more.warnings.size() == 1);
}

TEST_CASE("Curve topology: vertices are the known points") {
  const TopologyResult result = topology("y^2 - x^2 - x^3");
  REQUIRE(result.vertices.size() == 4);
  CHECK(result.vertices[0].kind == VertexKind::critical);
  CHECK(result.vertices[0].x.real == "-1");
  CHECK(result.vertices[0].y.real == "0");
  CHECK(result.vertices[1].kind == VertexKind::singular);
  CHECK(result.vertices[1].left == 2);
  CHECK(result.vertices[1].right == 2);
  CHECK(result.vertices[1].x.real == "0");
  CHECK(result.vertices[1].y.real == "0");
  CHECK(result.vertices[2].x_infinite == 1);
  CHECK(result.vertices[3].x_infinite == 1);
  const TopologyResult asymptote = topology("x*y - 1");
  REQUIRE(asymptote.vertices.size() == 4);
  CHECK(asymptote.vertices[0].x_infinite == -1);
  CHECK(asymptote.vertices[1].y_infinite == -1);
  CHECK(asymptote.vertices[1].x.real == "0");
  CHECK(asymptote.vertices[2].y_infinite == 1);
  CHECK(asymptote.vertices[3].x_infinite == 1);
  intersect::Options digits;
  digits.digits = 30;
  const TopologyResult flower = topology(curve("x^2 - 2 + y^2"), {}, digits);
  REQUIRE(flower.vertices.size() == 2);
  CHECK(flower.vertices[1].x.real == "1.41421356237309504880168872421");
}

TEST_CASE("Curve topology: a box cuts the curve at its border") {
  const auto in_box = [](std::string_view p, const Box& window) {
    INFO(p);
    const TopologyResult result = topology(p, window);
    check_graph(result, true);
    return std::tuple(shape_of(result), result.counts.border);
  };
  const Box square = box("-1", "1", "-1", "1");
  // The circle inside, touching from inside, from outside, crossing, around the box.
  CHECK(in_box("x^2 + y^2 - 1/4", square) == std::tuple(Shape{1, 1, 1, 0, 0, {}}, 0));
  CHECK(in_box("x^2 + y^2 - 1", square) == std::tuple(Shape{1, 1, 1, 0, 0, {}}, 2));
  CHECK(in_box("(x - 2)^2 + y^2 - 1", square) == std::tuple(Shape{1, 0, 0, 1, 0, {}}, 0));
  CHECK(in_box("x^2 + (y - 2)^2 - 1", square) == std::tuple(Shape{1, 0, 0, 1, 0, {}}, 1));
  CHECK(in_box("x^2 + y^2 - 25/16", square) == std::tuple(Shape{4, 0, 0, 0, 0, {}}, 8));
  CHECK(in_box("x^2 + y^2 - 2", square) == std::tuple(Shape{4, 0, 0, 4, 0, {}}, 4));
  CHECK(in_box("x^2 + y^2 - 4", square) == std::tuple(Shape{0, 0, 0, 0, 0, {}}, 0));
  // Singular points on the border: half of a node, a cusp, an isolated point.
  CHECK(in_box("y^2 - x^2 - x^3", box("0", "1", "-5", "5")) == std::tuple(Shape{1, 0, 0, 0, 0, {{4, 1}}}, 2));
  CHECK(in_box("y^2 - x^2 - x^3", box("-2", "0", "-5", "5")) == std::tuple(Shape{1, 1, 1, 0, 0, {{4, 1}}}, 0));
  CHECK(in_box("y^2 - x^2 - x^3", box("-2", "1", "0", "5")) == std::tuple(Shape{1, 0, 0, 0, 0, {{4, 1}}}, 1));
  CHECK(in_box("y^2 - x^3", box("-1", "0", "-1", "1")) == std::tuple(Shape{1, 0, 0, 1, 0, {{2, 2}}}, 0));
  CHECK(in_box("y^2 - x^3", box("-1", "1", "0", "2")) == std::tuple(Shape{1, 0, 0, 0, 0, {{2, 2}}}, 1));
  CHECK(in_box("x^2 + y^2", box("0", "1", "0", "1")) == std::tuple(Shape{1, 0, 0, 1, 0, {{0, 1}}}, 0));
  // Lines along the border, through corners, touching one.
  CHECK(in_box("y - 1", square) == std::tuple(Shape{1, 0, 0, 0, 0, {}}, 2));
  CHECK(in_box("x - 1", square) == std::tuple(Shape{1, 0, 0, 0, 0, {}}, 2));
  CHECK(in_box("(x^2 - 1)*(y^2 - 1)", square) == std::tuple(Shape{1, 1, 1, 0, 0, {{4, 1}, {4, 1}, {4, 1}, {4, 1}}}, 0));
  CHECK(in_box("x - y", square) == std::tuple(Shape{1, 0, 0, 0, 0, {}}, 2));
  CHECK(in_box("x + y - 2", square) == std::tuple(Shape{1, 0, 0, 1, 0, {}}, 1));
  CHECK(in_box("x*(x^2 + y^2 - 1/4)", square) == std::tuple(Shape{1, 2, 0, 0, 0, {{4, 1}, {4, 1}}}, 2));
  CHECK(in_box("x*(y - 1)", square) == std::tuple(Shape{1, 0, 0, 0, 0, {{4, 1}}}, 3));
  CHECK(in_box("(y - 1)*(x^2 + y^2 - 1)", square) == std::tuple(Shape{1, 1, 0, 0, 0, {{4, 3}}}, 3));
  // Asymptotes.
  CHECK(in_box("x*y - 1/2", square) == std::tuple(Shape{2, 0, 0, 0, 0, {}}, 4));
  CHECK(in_box("x^2*y - 1/2", square) == std::tuple(Shape{2, 0, 0, 0, 0, {}}, 4));
  CHECK(in_box("x*(x*y - 1/2)", square) == std::tuple(Shape{3, 0, 0, 0, 0, {}}, 6));
  // Boxes without inside.
  CHECK(in_box("x^2 + y^2 - 1", box("0", "0", "-2", "2")) == std::tuple(Shape{2, 0, 0, 2, 0, {}}, 2));
  CHECK(in_box("x^2 + y^2 - 1", box("-2", "2", "0", "0")) == std::tuple(Shape{2, 0, 0, 2, 0, {}}, 0));
  CHECK(in_box("x*y", box("0", "0", "-2", "2")) == std::tuple(Shape{1, 0, 0, 0, 0, {{4, 1}}}, 2));
  CHECK(in_box("x*y", box("-2", "2", "0", "0")) == std::tuple(Shape{1, 0, 0, 0, 0, {{4, 1}}}, 2));
  CHECK(in_box("x*y", box("0", "0", "0", "0")) == std::tuple(Shape{1, 0, 0, 1, 0, {{4, 1}}}, 0));
  CHECK(in_box("x - 1/3", box("0", "1", "2", "2")) == std::tuple(Shape{1, 0, 0, 1, 0, {}}, 1));
}

TEST_CASE("Curve topology: faces of the complement are counted") {
  const auto faces = [](std::string_view p, const std::optional<Box>& window = {}) {
    return topology(p, window).counts.faces;
  };
  CHECK(faces("x^2 + y^2 + 1") == 1);
  CHECK(faces("x^2 + y^2") == 1);
  CHECK(faces("x^2 + y^2 - 1") == 2);
  CHECK(faces("x*y*(x - y)") == 6);
  CHECK(faces("x*y - 1") == 3);
  CHECK(faces("(x^2 - 1)*(y^2 - 1)") == 9);
  CHECK(faces("(x^2 + y^2)^2 - x^2 + y^2") == 3);
  const Box square = box("-1", "1", "-1", "1");
  CHECK(faces("x^2 + y^2 + 1", square) == 1);
  CHECK(faces("x^2 + y^2 - 1", square) == 5);
  CHECK(faces("x^2 + y^2 - 1/4", square) == 2);
  CHECK(faces("x^2 + y^2 - 25/16", square) == 5);
  CHECK(faces("(x^2 - 1)*(y^2 - 1)", square) == 1);
  CHECK(faces("(x - 1)*(y + 1)*(x - y)", square) == 2);
  CHECK(faces("x*y", square) == 4);
  CHECK(faces("x*y*(y - 1)", square) == 4);
  CHECK(faces("x + y - 2", square) == 1);
  CHECK(faces("x", box("0", "0", "-1", "1")) == 0);
}

TEST_CASE("Curve topology: points of polylines lie on the curve") {
  for (const char* text : {"x^2 + y^2 - 1", "(x^2 + y^2)^2 - x^2 + y^2", "y^2 - x^2 - x^3", "x*y - 1",
                           "x^4 + y^4 - 3*x^2*y + x/5", "x*(y - x^2)*(x^2 + y^2 - 2)"}) {
    INFO(text);
    const Polynomial p = curve(text);
    const TopologyResult result = topology(p);
    CHECK(result.error < 1e-12);
    const Rational step = symbolic::parse_number("1e-9");
    for (const intersect::TopologyEdge& edge : result.edges)
      for (std::size_t k = 1; k + 1 < edge.polyline.size(); ++k) {
        const Rational px = exact_rational(edge.polyline[k][0]);
        const Rational py = exact_rational(edge.polyline[k][1]);
        INFO(edge.polyline[k][0], ", ", edge.polyline[k][1]);
        const bool changes = value_at(p, px, py - step).sign() * value_at(p, px, py + step).sign() < 0 ||
                             value_at(p, px - step, py).sign() * value_at(p, px + step, py).sign() < 0;
        CHECK(changes);
      }
  }
}

TEST_CASE("Curve topology: the eliminant of a self-intersection has the known critical points and windows") {
  std::ifstream file(std::string(ELIMINANT_TEST_DATA) + "/curve_topology.json");
  REQUIRE(file);
  const auto data = nlohmann::json::parse(file);
  const std::vector<std::string> names{"u", "v"};
  const Polynomial eliminant = symbolic::parse_polynomial(data["D"].get<std::string>(), names);
  CHECK(eliminant.term_count() == 97);

  // As a curve over v the critical points are those with D = D_u = 0.
  const Polynomial over_v = symbolic::exchange_variables(eliminant);
  intersect::PlaneCurvesProblem system;
  system.p = over_v;
  system.q = over_v.derivative(1);
  const intersect::Result critical = test::solve(system);
  CHECK(critical.status == intersect::Status::certified);
  CHECK(critical.counts.distinct == data["complex_critical_points"].get<unsigned long>());
  CHECK(critical.counts.real == data["real_critical_points"].size());

  intersect::Options digits;
  digits.digits = 30;
  const TopologyResult whole = topology(over_v, box("-3", "3", "-3", "3"), digits);
  for (const auto& point : data["real_critical_points"]) {
    const std::string u = point["u"].get<std::string>();
    const std::string v = point["v"].get<std::string>();
    INFO(u, " ", v);
    if (std::fabs(std::stod(u)) > 3 || std::fabs(std::stod(v)) > 3) continue;
    const TopologyVertex& vertex = vertex_near(whole, std::stod(v), std::stod(u));
    const Rational reach = symbolic::parse_number("1e-28");
    for (const auto& [found, known] : {std::pair(vertex.x.real, v), std::pair(vertex.y.real, u)}) {
      const Rational difference = symbolic::parse_number(found) - symbolic::parse_number(known);
      CHECK(difference < reach);
      CHECK(-difference < reach);
    }
    const std::string kind = point["kind"].get<std::string>();
    if (kind == "node") {
      const bool isolated = point["real_type"].get<std::string>().find("isolated") == 0;
      CHECK(vertex.kind == VertexKind::singular);
      CHECK(vertex.milnor_number == 1);
      CHECK(vertex.half_branches() == (isolated ? 0 : 4));
    } else if (kind == "triple") {
      CHECK(vertex.kind == VertexKind::singular);
      CHECK(vertex.milnor_number == 4);
      CHECK((vertex.half_branches() == 2 || vertex.half_branches() == 6));
    } else {
      CHECK(vertex.kind == VertexKind::critical);
      CHECK(vertex.half_branches() == 2);
    }
  }
  for (const auto& known : data["topology"]) {
    const auto low = std::to_string(known["box"][0].get<int>());
    const auto high = std::to_string(known["box"][1].get<int>());
    INFO("window ", low, " ", high);
    for (const bool exchanged : {true, false}) {
      const TopologyResult result =
          topology(exchanged ? over_v : eliminant, box(low.c_str(), high.c_str(), low.c_str(), high.c_str()));
      check_graph(result, true);
      CHECK(result.counts.components == known["components"].get<unsigned long>());
      CHECK(result.isolated.size() == known["isolated_points"].get<std::size_t>());
      std::array<long, 4> crossings{};
      for (const TopologyVertex& vertex : result.vertices) {
        if (!vertex.on_border) continue;
        // u is horizontal in the data.
        if (vertex.x.real == low) ++crossings[exchanged ? 2 : 0];
        if (vertex.x.real == high) ++crossings[exchanged ? 3 : 1];
        if (vertex.y.real == low) ++crossings[exchanged ? 0 : 2];
        if (vertex.y.real == high) ++crossings[exchanged ? 1 : 3];
      }
      CHECK(crossings == known["border_crossings_left_right_bottom_top"].get<std::array<long, 4>>());
      CHECK(result.counts.faces == known["faces_of_the_complement_in_the_box"].get<unsigned long>());
    }
  }
}

TEST_CASE("Curve topology: bad input and limits") {
  CHECK_THROWS_AS(topology("0*x"), InvalidInput);
  CHECK_THROWS_AS(topology("3 + 0*x"), InvalidInput);
  CHECK_THROWS_AS(topology("x", box("1", "0", "0", "1")), InvalidInput);
  intersect::Options options;
  options.digits = 0;
  CHECK_THROWS_AS(topology(curve("x"), {}, options), InvalidInput);
  options = {};
  options.engine = intersect::Engine::box;
  CHECK_THROWS_AS(topology(curve("x"), {}, options), InvalidInput);
  options = {};
  options.certify = false;
  CHECK(topology(curve("x"), {}, options).status == intersect::Status::numeric);
  intersect::CurveTopologyProblem problem;
  problem.p = curve("x^2 + y^2 - 1");
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(intersect::curve_topology(problem, {}, cancelled), LimitReached);
}
