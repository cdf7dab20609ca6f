// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/topology/curve_topology.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <support/curves.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using intersect::Box;
using intersect::TopologyResult;
using intersect::TopologyVertex;
using intersect::VertexKind;
using symbolic::Polynomial;
using symbolic::Rational;
using test::curve;

namespace {

TopologyResult topology(const Polynomial& p, const std::optional<Box>& box = {},
                        const intersect::Options& options = {}) {
  intersect::CurveTopologyProblem problem;
  problem.p = p;
  problem.box = box;
  const Context context;
  return intersect::curve_topology(problem, options, context);
}

TopologyResult topology(std::string_view p, const std::optional<Box>& box = {}) { return topology(curve(p), box); }

Box box(const char* a, const char* b, const char* c, const char* d) {
  const auto number = [](const char* text) { return symbolic::parse_number(text); };
  return {{number(a), number(b)}, {number(c), number(d)}};
}

/// Half-branches and Milnor number of every singular point, sorted.
using SingularTypes = std::vector<std::array<unsigned long, 2>>;

SingularTypes singular_types(const TopologyResult& result) {
  SingularTypes types;
  for (const TopologyVertex& vertex : result.vertices)
    if (vertex.kind == VertexKind::singular) types.push_back({vertex.half_branches(), vertex.milnor_number});
  std::sort(types.begin(), types.end());
  return types;
}

/// What does not depend on the coordinates.
struct Shape {
  unsigned long components = 0;
  unsigned long cycles = 0;
  std::size_t loops = 0;
  std::size_t isolated = 0;
  unsigned long ends_at_infinity = 0;
  SingularTypes singular;

  friend bool operator==(const Shape&, const Shape&) = default;
};

std::ostream& operator<<(std::ostream& out, const Shape& shape) {
  out << shape.components << " components, " << shape.cycles << " cycles, " << shape.loops << " loops, "
      << shape.isolated << " isolated, " << shape.ends_at_infinity << " ends at infinity; singular:";
  for (const auto& [half_branches, milnor] : shape.singular) out << " (" << half_branches << ", " << milnor << ")";
  return out;
}

Shape shape_of(const TopologyResult& result) {
  return {result.counts.components, result.counts.cycles,   result.loops.size(),
          result.isolated.size(),   result.counts.infinity, singular_types(result)};
}

/// What every result has to fulfil, whatever the curve.
void check_graph(const TopologyResult& result, bool boxed) {
  CHECK(result.status == intersect::Status::certified);
  std::vector<unsigned long> degrees(result.vertices.size(), 0);
  for (const intersect::TopologyEdge& edge : result.edges) {
    CHECK(edge.from != edge.to);
    ++degrees.at(edge.from);
    ++degrees.at(edge.to);
    CHECK(edge.polyline.size() >= 2);
    // Vertical lines, and vertices that doubles cannot tell apart, have two points above each other.
    const bool steep = edge.polyline.size() == 2;
    for (std::size_t k = 0; k + 1 < edge.polyline.size(); ++k)
      CHECK(
          (edge.polyline[k][0] < edge.polyline[k + 1][0] || (steep && edge.polyline[k][0] == edge.polyline[k + 1][0])));
  }
  for (std::size_t v = 0; v < degrees.size(); ++v) {
    const TopologyVertex& vertex = result.vertices[v];
    CHECK(vertex.certified);
    const bool isolated = std::count(result.isolated.begin(), result.isolated.end(), v) == 1;
    CHECK((degrees[v] == 0) == isolated);
    if (vertex.kind == VertexKind::infinity)
      CHECK(degrees[v] == 1);
    else if (!vertex.on_border)
      CHECK(degrees[v] == vertex.half_branches());
    else
      CHECK(degrees[v] <= vertex.half_branches());
    CHECK((vertex.kind == VertexKind::singular) == (vertex.milnor_number > 0));
    if (boxed) CHECK(vertex.kind != VertexKind::infinity);
    if (!boxed) CHECK(!vertex.on_border);
  }
  CHECK(result.counts.singular + result.counts.critical + result.counts.border + result.counts.infinity ==
        result.vertices.size());
  CHECK(result.vertices.size() + result.counts.cycles == result.edges.size() + result.counts.components);
  for (const auto& loop : result.loops) {
    CHECK(loop.size() >= 2);
    std::vector<std::size_t> ends;
    for (const std::size_t edge : loop) ends.insert(ends.end(), {result.edges[edge].from, result.edges[edge].to});
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k < ends.size(); ++k) CHECK(ends[k] == ends[k ^ 1U]);
  }
}

Shape checked_shape(const Polynomial& p) {
  INFO(test::text(p));
  const TopologyResult result = topology(p);
  check_graph(result, false);
  return shape_of(result);
}

Shape checked_shape(std::string_view p) { return checked_shape(curve(p)); }

Rational value_at(const Polynomial& p, const Rational& x, const Rational& y) {
  const std::array images{Polynomial::constant(2, x), Polynomial::constant(2, y)};
  return p.compose(images).constant_term();
}

Rational exact(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%a", value);
  return symbolic::parse_number(text);
}

/// The vertex nearest to a point.
const TopologyVertex& vertex_near(const TopologyResult& result, double x, double y) {
  const auto distance = [&](const TopologyVertex& v) {
    return v.kind == VertexKind::infinity ? 1e300 : std::hypot(std::stod(v.x.real) - x, std::stod(v.y.real) - y);
  };
  return *std::min_element(result.vertices.begin(), result.vertices.end(),
                           [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

Polynomial x() { return Polynomial::variable(2, 0); }
Polynomial y() { return Polynomial::variable(2, 1); }
Polynomial number(const Rational& value) { return Polynomial::constant(2, value); }

Polynomial composed(const Polynomial& p, const Polynomial& first, const Polynomial& second) {
  const std::array images{first, second};
  return p.compose(images);
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
        const Rational px = exact(edge.polyline[k][0]);
        const Rational py = exact(edge.polyline[k][1]);
        INFO(edge.polyline[k][0], ", ", edge.polyline[k][1]);
        const bool changes = value_at(p, px, py - step).sign() * value_at(p, px, py + step).sign() < 0 ||
                             value_at(p, px - step, py).sign() * value_at(p, px + step, py).sign() < 0;
        CHECK(changes);
      }
  }
}

TEST_CASE("Curve topology: the shape does not depend on the coordinates") {
  const std::vector<Polynomial> curves{curve("(x^2 + y^2)^2 - x^3 + 3*x*y^2"),
                                       curve("y^2 - x^2 - x^3"),
                                       curve("y^2 - x^5 + x^4"),
                                       curve("x*(x^2 + y^2 - 1)*(y - x^2)"),
                                       curve("y^3 - x^5"),
                                       curve("(x^2 - 1)*y^2 - x"),
                                       curve("x^2*y^2 + x*y + 1 - x"),
                                       curve("(x^2 + y^2)*(x*y - 1)"),
                                       curve("(y - x^2)*(y + x^2)*x*y"),
                                       curve("x^4 + y^4 - x^2*y"),
                                       curve("y^3 - 3*y - x^3 + 3*x"),
                                       curve("(x^2-1)^2 - y^2*(3 + 2*y)")};
  for (const Polynomial& p : curves) {
    INFO(test::text(p));
    const Shape shape = checked_shape(p);
    CHECK(checked_shape(symbolic::exchange_variables(p)) == shape);
    CHECK(checked_shape(composed(p, x() + number(Rational(7) / Rational(3)), y() - number(12))) == shape);
    CHECK(checked_shape(composed(p, Rational(1000) * x(), number(0) - Rational(1) / Rational(1024) * y())) == shape);
    CHECK(checked_shape(composed(p, x() + Rational(2) * y(), y() - Rational(1) / Rational(3) * x())) == shape);
  }
}

namespace {

Rational power_two(const Rational& value) { return value * value; }

/// A line a x + b y + c = 0 or a circle (x - a)^2 + (y - b)^2 = c.
struct Object {
  bool line = false;
  Rational a, b, c;

  Polynomial equation() const {
    if (line) return a * x() + b * y() + number(c);
    const Polynomial dx = x() - number(a);
    const Polynomial dy = y() - number(b);
    return dx * dx + dy * dy - number(c);
  }
};

/// The number of common real points of two different objects, from discriminants.
long common_points(const Object& f, const Object& g) {
  if (f.line && g.line) return (f.a * g.b - g.a * f.b).is_zero() ? 0 : 1;
  if (g.line) return common_points(g, f);
  if (f.line) {
    const Rational distance = f.a * g.a + f.b * g.b + f.c;
    const int sign = (g.c * (power_two(f.a) + power_two(f.b)) - power_two(distance)).sign();
    return 1 + sign;
  }
  const Rational squared_distance = power_two(f.a - g.a) + power_two(f.b - g.b);
  if (squared_distance.is_zero()) return 0;
  // (r - s)^2 < d^2 < (r + s)^2 exactly where 4 r^2 s^2 > (d^2 - r^2 - s^2)^2.
  const int sign = (Rational(4) * f.c * g.c - power_two(squared_distance - f.c - g.c)).sign();
  return 1 + sign;
}

}  // namespace

TEST_CASE("Curve topology: arrangements of lines and circles fulfil Euler's formula") {
  test::Random random(20);
  for (int round = 0; round < 60; ++round) {
    std::vector<Object> objects;
    const long count = random.between(2, 4);
    while (static_cast<long>(objects.size()) < count) {
      Object object;
      object.line = random.between(0, 1) == 0;
      object.a = Rational(random.between(-3, 3));
      object.b = Rational(random.between(-3, 3));
      object.c = object.line ? Rational(random.between(-3, 3)) : Rational(random.between(1, 9));
      if (object.line && object.a.is_zero() && object.b.is_zero()) continue;
      const bool known = std::any_of(objects.begin(), objects.end(), [&](const Object& other) {
        return object.equation().primitive_part() == other.equation().primitive_part();
      });
      if (!known) objects.push_back(object);
    }
    Polynomial product = number(1);
    for (const Object& object : objects) product = product * object.equation();
    INFO(test::text(product));
    const TopologyResult result = topology(product);
    check_graph(result, false);
    std::vector<std::size_t> parent(objects.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i];
      return i;
    };
    long pairs = 0;
    for (std::size_t i = 0; i < objects.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const long common = common_points(objects[i], objects[j]); common > 0) {
          pairs += common;
          parent[root(i)] = root(j);
        }
    unsigned long components = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) components += root(i) == i ? 1 : 0;
    // Every object passes a point in two half-branches.
    long pairs_found = 0;
    long euler = 0;
    for (const Object& object : objects) euler += object.line ? 1 : 0;
    for (const auto& [half_branches, milnor] : singular_types(result)) {
      const auto passing = static_cast<long>(half_branches / 2);
      CHECK(half_branches % 2 == 0);
      pairs_found += passing * (passing - 1) / 2;
      euler -= passing - 1;
    }
    CHECK(pairs_found == pairs);
    CHECK(result.counts.components == components);
    CHECK(static_cast<long>(result.counts.cycles) == static_cast<long>(components) - euler);
    CHECK(result.counts.infinity == 2 * static_cast<unsigned long>(std::count_if(
                                            objects.begin(), objects.end(), [](const Object& o) { return o.line; })));
  }
}

TEST_CASE("Curve topology: random curves have one shape in all coordinates, and fit into boxes") {
  test::Random random(21);
  for (int round = 0; round < 40; ++round) {
    const Polynomial p = test::random_dense(random, static_cast<unsigned long>(random.between(2, 4)), 3);
    if (p.is_constant()) continue;
    const Shape shape = checked_shape(p);
    INFO(test::text(p));
    CHECK(checked_shape(symbolic::exchange_variables(p)) == shape);
    CHECK(checked_shape(composed(p, x() + y(), number(3) - y())) == shape);
    // Two halves of a box hold what the whole does: chi(A u B) = chi(A) + chi(B) - chi(A n B).
    const auto euler = [&](const char* a, const char* b, const char* c, const char* d) {
      const TopologyResult result = topology(p, box(a, b, c, d));
      check_graph(result, true);
      return static_cast<long>(result.vertices.size()) - static_cast<long>(result.edges.size());
    };
    const long whole = euler("-2", "2", "-2", "2");
    CHECK(whole == euler("-2", "1/3", "-2", "2") + euler("1/3", "2", "-2", "2") - euler("1/3", "1/3", "-2", "2"));
    CHECK(whole == euler("-2", "2", "-2", "0") + euler("-2", "2", "0", "2") - euler("-2", "2", "0", "0"));
  }
}

namespace {

using Coefficients = std::vector<Rational>;

void drop_leading_zeros(Coefficients& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

/// The remainder of a by b, ascending coefficients.
Coefficients remainder(Coefficients a, const Coefficients& b) {
  while (a.size() >= b.size()) {
    const Rational quotient = a.back() / b.back();
    for (std::size_t i = 0; i < b.size(); ++i)
      a[a.size() - b.size() + i] = a[a.size() - b.size() + i] - quotient * b[i];
    drop_leading_zeros(a);
  }
  return a;
}

/// Distinct real roots of f(x, y) in y by Sturm's theorem.
long real_roots_above(const Polynomial& f, const Rational& abscissa) {
  Coefficients p(static_cast<std::size_t>(f.degree(1)) + 1);
  for (const Polynomial::Term& term : f.terms()) {
    Rational power(1);
    for (unsigned long k = 0; k < term.exponents[0]; ++k) power = power * abscissa;
    p[term.exponents[1]] = p[term.exponents[1]] + term.coefficient * power;
  }
  drop_leading_zeros(p);
  if (p.size() < 2) return 0;
  std::vector<Coefficients> sturm{p, {}};
  for (std::size_t i = 1; i < p.size(); ++i) sturm[1].push_back(Rational(static_cast<long>(i)) * p[i]);
  while (true) {
    Coefficients next = remainder(sturm[sturm.size() - 2], sturm.back());
    if (next.empty()) break;
    for (Rational& c : next) c = -c;
    sturm.push_back(std::move(next));
  }
  const auto variations = [&](int side) {
    int changes = 0;
    int last = 0;
    for (const Coefficients& q : sturm) {
      const int sign = q.back().sign() * (side < 0 && q.size() % 2 == 0 ? -1 : 1);
      if (last * sign < 0) ++changes;
      last = sign;
    }
    return changes;
  };
  return variations(-1) - variations(1);
}

}  // namespace

TEST_CASE("Curve topology: as many edges cross a vertical line as Sturm's theorem says") {
  test::Random random(22);
  for (int round = 0; round < 40; ++round) {
    Polynomial p = test::random_dense(random, static_cast<unsigned long>(random.between(2, 5)), 4);
    // A factor squared, moved apart a little or not at all.
    if (round % 3 == 0) p = p * p + Rational(random.between(-1, 0)) / Rational(1000000) * number(1);
    if (p.is_constant()) continue;
    INFO(test::text(p));
    const TopologyResult result = topology(p);
    check_graph(result, false);
    const auto x_of = [&](std::size_t v) {
      const TopologyVertex& vertex = result.vertices[v];
      return vertex.x_infinite != 0 ? 1e300 * vertex.x_infinite : std::stod(vertex.x.real);
    };
    for (long k = -20; k <= 20; ++k) {
      const double at = static_cast<double>(k) / 8 + 0x1p-7;
      INFO(at);
      long edges = 0;
      for (const intersect::TopologyEdge& edge : result.edges) {
        CHECK(std::fabs(x_of(edge.from) - at) > 1e-12);
        if (x_of(edge.from) < at && at < x_of(edge.to)) ++edges;
      }
      CHECK(edges == real_roots_above(p, exact(at)));
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
