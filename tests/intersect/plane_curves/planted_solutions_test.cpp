// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

const Polynomial x = Polynomial::variable(2, 0);
const Polynomial y = Polynomial::variable(2, 1);

Polynomial constant(const Rational& value) { return Polynomial::constant(2, value); }

/// a x + b y + c.
struct Line {
  Rational a, b, c;
  Polynomial polynomial() const { return a * x + b * y + constant(c); }
};

Line line_through(const std::pair<Rational, Rational>& point, const Rational& a, const Rational& b) {
  return {a, b, -(a * point.first + b * point.second)};
}

struct Planted {
  Polynomial p{2};
  Polynomial q{2};
  PlantedPoints points;
  unsigned long at_infinity = 0;
};

/// Products of lines: each pair of lines of p and q adds one to the multiplicity of the point where they meet, a pair
/// of parallels one at infinity. nullopt when two lines coincide.
std::optional<Planted> from_lines(const std::vector<Line>& first, const std::vector<Line>& second) {
  Planted result;
  result.p = result.q = constant(1);
  for (const Line& line : first) result.p = result.p * line.polynomial();
  for (const Line& line : second) result.q = result.q * line.polynomial();
  for (const Line& f : first)
    for (const Line& g : second) {
      const Rational determinant = f.a * g.b - f.b * g.a;
      if (determinant.is_zero()) {
        if ((f.a * g.c - f.c * g.a).is_zero() && (f.b * g.c - f.c * g.b).is_zero()) return std::nullopt;
        ++result.at_infinity;
        continue;
      }
      const std::pair<Rational, Rational> point{(f.b * g.c - f.c * g.b) / determinant,
                                                (f.c * g.a - f.a * g.c) / determinant};
      const auto known = std::find_if(result.points.begin(), result.points.end(),
                                      [&](const auto& planted) { return planted.first == point; });
      if (known == result.points.end())
        result.points.push_back({point, 1});
      else
        ++known->second;
    }
  return result;
}

void check(const Planted& planted, const Options& options = {}) {
  CAPTURE(text(planted.p));
  CAPTURE(text(planted.q));
  PlaneCurvesProblem input;
  input.p = planted.p;
  input.q = planted.q;
  const Result result = solve(input, options);
  CHECK(result.status == Status::certified);
  CHECK(audit_holds(result));
  CHECK(result.counts.at_infinity == planted.at_infinity);
  CHECK(are_exactly(result, planted.points));
}

Rational random_rational(Random& random) { return Rational(random.between(-12, 12)) / Rational(random.between(1, 6)); }

}  // namespace

TEST_CASE("Planted solutions: 100 products of lines, multiplicities 1 to 6 and more, vertical pairs, parallels") {
  Random random(31);
  // Lines of p and of q through one point: m n is the multiplicity.
  const std::vector<std::pair<int, int>> counts{{1, 1}, {1, 2}, {1, 3}, {2, 2}, {1, 5}, {2, 3}, {5, 1}, {3, 2}};
  int systems = 0;
  while (systems < 100) {
    const std::pair<Rational, Rational> first_point{random_rational(random), random_rational(random)};
    // Every second system has another planted point on the same vertical line.
    const std::pair<Rational, Rational> second_point{systems % 2 == 0 ? first_point.first : random_rational(random),
                                                     random_rational(random)};
    std::vector<Line> p_lines;
    std::vector<Line> q_lines;
    for (const auto& point : {first_point, second_point}) {
      const auto [m, n] = counts[random.next() % counts.size()];
      for (int k = 0; k < m; ++k)
        p_lines.push_back(line_through(point, Rational(random.between(-9, 9)), Rational(random.nonzero(9))));
      for (int k = 0; k < n; ++k)
        q_lines.push_back(line_through(point, Rational(random.nonzero(9)), Rational(random.between(-9, 9))));
    }
    // Every fourth system has parallel lines: solutions at infinity.
    if (systems % 4 == 3) {
      Line parallel = p_lines.front();
      parallel.c = parallel.c + Rational(1);
      q_lines.push_back(parallel);
    }
    const std::optional<Planted> planted = from_lines(p_lines, q_lines);
    if (!planted) continue;
    check(*planted);
    ++systems;
  }
}

TEST_CASE("Planted solutions: 100 contacts of order 1 to 6 with a graph, in random coordinates") {
  Random random(32);
  for (int trial = 0; trial < 100; ++trial) {
    // p = y - f(x), q = y - f(x) - c prod (x - x_i)^(m_i): all intersections are (x_i, f(x_i)) with multiplicity m_i.
    Polynomial f = constant(random_rational(random)) + constant(random_rational(random)) * x;
    if (trial % 3 == 1) f = f + x * x;
    if (trial % 3 == 2) f = f + x * x * x - constant(2) * x * x;
    Polynomial difference = constant(Rational(random.nonzero(5)));
    PlantedPoints points;
    const long count = random.between(1, 3);
    unsigned long total = 0;
    for (long k = 0; k < count; ++k) {
      const Rational at = random_rational(random);
      if (std::any_of(points.begin(), points.end(), [&](const auto& known) { return known.first.first == at; }))
        continue;
      const auto multiplicity = static_cast<unsigned long>(k == 0 ? 1 + trial % 6 : random.between(1, 3));
      difference = difference * symbolic::power(x - constant(at), multiplicity);
      const std::vector<Polynomial> images{constant(at), constant(0)};
      points.push_back({{at, f.compose(images).constant_term()}, multiplicity});
      total += multiplicity;
    }
    // New coordinates: x = a X + b Y, y = c X + d Y of determinant 1, so X = d x - b y, Y = -c x + a y.
    const long b = trial % 2 == 0 ? 0 : random.between(-2, 2);
    const long c = trial % 2 == 0 ? 0 : random.between(-2, 2);
    const Polynomial new_x = x + Rational(b) * y;
    const Polynomial new_y = Rational(c) * x + Rational(1 + b * c) * y;
    Planted planted;
    planted.p = substitute(y - f, new_x, new_y);
    planted.q = substitute(y - f - difference, new_x, new_y);
    for (const auto& [point, multiplicity] : points)
      planted.points.push_back(
          {{Rational(1 + b * c) * point.first - Rational(b) * point.second, point.second - Rational(c) * point.first},
           multiplicity});
    planted.at_infinity = static_cast<unsigned long>(planted.p.total_degree() * planted.q.total_degree()) - total;
    check(planted);
  }
}

TEST_CASE("Planted solutions: exchanging the curves or the variables changes nothing but the names") {
  Random random(33);
  for (int trial = 0; trial < 10; ++trial) {
    const Polynomial p = random_dense(random, 3, 5) * (x - y);
    const Polynomial q = random_dense(random, 2, 5);
    if (p.total_degree() < 1 || q.total_degree() < 1) continue;
    CAPTURE(text(p));
    CAPTURE(text(q));
    PlaneCurvesProblem input;
    input.p = p;
    input.q = q;
    const Result direct = solve(input);
    std::swap(input.p, input.q);
    CHECK(printed(solve(input)) == printed(direct));
    input.p = substitute(p, y, x);
    input.q = substitute(q, y, x);
    const Result exchanged = solve(input);
    CHECK(exchanged.counts.distinct == direct.counts.distinct);
    for (const Solution& s : direct.solutions)
      CHECK(std::count_if(exchanged.solutions.begin(), exchanged.solutions.end(), [&](const Solution& t) {
              return t.x.real == s.y.real && t.x.imaginary == s.y.imaginary && t.y.real == s.x.real &&
                     t.y.imaginary == s.x.imaginary && t.multiplicity == s.multiplicity;
            }) == 1);
  }
}
