// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <support/binary_numbers.hpp>
#include <support/plane_curves.hpp>
#include <support/topology_checks.hpp>

// Shapes in other coordinates, and numbers that theorems give: Euler's formula, inclusion and exclusion, Sturm's
// theorem.

using namespace eliminant;
using namespace eliminant::test;

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
      CHECK(edges == real_roots_above(p, exact_rational(at)));
    }
  }
}
