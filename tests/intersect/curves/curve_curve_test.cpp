// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include <intersect/curve_helpers.hpp>
#include <support/curves.hpp>

#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::Interval;
using symbolic::ParametricCurve;

namespace {

CurveResult meet(const Curve& first, const Curve& second, Field field = Field::automatic) {
  Options options;
  options.field = field;
  const Context context;
  return intersect_curve_curve({first, second}, options, context);
}

Curve equation(std::string_view text) { return ImplicitCurve{curve(text)}; }

/// How many solutions are this pair with this multiplicity.
long count_of(const CurveResult& result, const Rational& t, const Rational& u, unsigned long multiplicity) {
  return std::count_if(result.solutions.begin(), result.solutions.end(), [&](const CurveSolution& s) {
    return is_t(s, t) && is_u(s, u) && s.multiplicity == multiplicity && s.certified && s.reality == Reality::real;
  });
}

/// The parameter of a curve against an equation.
long count_of(const CurveResult& result, const Rational& t, unsigned long multiplicity) {
  return std::count_if(result.solutions.begin(), result.solutions.end(), [&](const CurveSolution& s) {
    return is_t(s, t) && !s.u && s.multiplicity == multiplicity && s.certified;
  });
}

/// Every pair lies on both curves, none is listed twice, and the multiplicities add up.
bool complete(const CurveResult& result, const ParametricCurve& first, const ParametricCurve& second) {
  const symbolic::RationalCurve& a = first.pieces[0].map;
  const symbolic::RationalCurve& b = second.pieces[0].map;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const CurveSolution& s = result.solutions[i];
    const auto on_first = point_at(a, *s.t);
    if (!may_be_same_point(on_first, point_at(b, *s.u)) || !may_be_same_point(on_first, balls(s.point))) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (may_agree(s.t, result.solutions[j].t) && may_agree(s.u, result.solutions[j].u)) return false;
  }
  return complete_audit_holds(result, static_cast<unsigned long>(a.degree() * b.degree()));
}

enum class Change { none, swapped, first_reversed };

/// The same pairs with the same multiplicities, after what was done to the curves is undone.
bool same_pairs(const CurveResult& a, const CurveResult& b, Change change = Change::none) {
  if (a.solutions.size() != b.solutions.size()) return false;
  return std::all_of(a.solutions.begin(), a.solutions.end(), [&](const CurveSolution& s) {
    return std::count_if(b.solutions.begin(), b.solutions.end(), [&](const CurveSolution& other) {
             const auto t = change == Change::swapped          ? other.u
                            : change == Change::first_reversed ? reversed(other.t)
                                                               : other.t;
             const auto& u = change == Change::swapped ? other.t : other.u;
             return may_agree(s.t, t) && may_agree(s.u, u) && s.multiplicity == other.multiplicity &&
                    s.reality == other.reality;
           }) == 1;
  });
}

std::vector<Polynomial> random_map(Draw& draw, long degree) {
  std::vector<Polynomial> map{random_in_t(draw, degree, 5), random_in_t(draw, degree, 5)};
  map.push_back(draw.between(0, 1) == 0 ? t_constant(1) : random_in_t(draw, degree, 5));
  return map;
}

/// The arc of the graph of a cubic over [0, 1], and that over [from, to] with its own parameter in [0, 1].
std::pair<ParametricCurve, ParametricCurve> two_arcs(const Rational& from, const Rational& to) {
  const std::vector<Polynomial> graph{in_t("t"), in_t("t^3 - 2*t + 1"), in_t("1")};
  const Polynomial parameter = t_constant(from) + (to - from) * t_variable();
  return {map_of(graph, Interval{0, 1}), map_of(reparametrized(graph, parameter), Interval{0, 1})};
}

bool is_interval(const std::optional<ParameterInterval>& interval, const Rational& lower, const Rational& upper) {
  return interval && is_value((*interval)[0], lower, -14) && is_value((*interval)[1], upper, -14);
}

/// The unit circle as four arcs, the parameter of each running through an interval of length one.
ParametricCurve circle_of_arcs() {
  const std::vector<std::vector<Polynomial>> quarters{{in_t("1 - t^2"), in_t("2*t"), in_t("1 + t^2")},
                                                      {in_t("-2*t"), in_t("1 - t^2"), in_t("1 + t^2")},
                                                      {in_t("t^2 - 1"), in_t("-2*t"), in_t("1 + t^2")},
                                                      {in_t("2*t"), in_t("t^2 - 1"), in_t("1 + t^2")}};
  ParametricCurve circle;
  for (long k = 0; k < 4; ++k) {
    const auto arc = reparametrized(quarters[static_cast<std::size_t>(k)], t_variable() - t_constant(k));
    circle.pieces.push_back({symbolic::rational_curve(arc), Interval{k, k + 1}});
  }
  return circle;
}

}  // namespace

TEST_CASE(
    "Curves in contact of known order at a rational pair: every pair, in either order, reversed, moved far away") {
  Draw draw(1);
  long tested = 0;
  for (int trial = 0; trial < 150; ++trial) {
    CAPTURE(trial);
    // B = A + (t - c)^k C has contact of order k with A exactly where A, A', C are independent.
    const auto order = static_cast<unsigned long>(draw.between(1, 3));
    const Rational c(draw.between(-3, 3));
    const std::vector<Polynomial> a = random_map(draw, draw.between(1, 4));
    std::vector<Polynomial> b;
    std::vector<std::vector<Rational>> frame(3);
    for (const Polynomial& f : a) {
      const Polynomial change = random_in_t(draw, 1, 5);
      b.push_back(f + power(t_variable() - t_constant(c), order) * change);
      frame[0].push_back(value_at(f, {c}));
      frame[1].push_back(value_at(f.derivative(0), {c}));
      frame[2].push_back(value_at(change, {c}));
    }
    if (determinant(frame).is_zero()) continue;
    const ParametricCurve first = map_of(a);
    const ParametricCurve second = map_of(b);
    const CurveResult result = meet(first, second);
    if (result.status == Status::infinite) continue;
    ++tested;
    CHECK(complete(result, first, second));
    CHECK(count_of(result, c, c, order) == 1);
    CHECK(same_pairs(result, meet(second, first), Change::swapped));
    CHECK(same_pairs(result, meet(map_of(reversed(a)), second), Change::first_reversed));
    const Rational scale = power_of_two(trial % 2 == 0 ? 20 : -20);
    const Rational shift = power_of_two(20);
    CHECK(same_pairs(result, meet(map_of(moved(a, scale, shift)), map_of(moved(b, scale, shift)))));
  }
  CHECK(tested >= 100);
}

TEST_CASE("Domains of two curves keep the real pairs inside them, ends included") {
  Draw draw(2);
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    // They meet in (c, e) for sure: A(c) is B(e).
    const Rational c(draw.between(-2, 2));
    const Rational e(draw.between(-2, 2));
    const std::vector<Polynomial> a = random_map(draw, draw.between(1, 3));
    std::vector<Polynomial> b;
    for (const Polynomial& f : a)
      b.push_back(t_constant(value_at(f, {c})) + (t_variable() - t_constant(e)) * random_in_t(draw, 1, 5));
    const ParametricCurve first = map_of(a);
    const ParametricCurve second = map_of(b);
    if (first.pieces[0].map.degree() < 1 || second.pieces[0].map.degree() < 1) continue;
    const CurveResult all = meet(first, second);
    if (all.status == Status::infinite) continue;
    if (std::any_of(all.solutions.begin(), all.solutions.end(),
                    [](const CurveSolution& s) { return is_infinite(s.t) || is_infinite(s.u); }))
      continue;
    const Interval t_domain{c, c + Rational(2)};
    const Interval u_domain{e - Rational(3), e};
    const CurveResult trimmed = meet(map_of(a, t_domain), map_of(b, u_domain));
    CHECK(trimmed.status == Status::certified);
    const auto within = [](const Parameter& value, const Interval& domain) {
      const Rational middle = symbolic::parse_number(value->real);
      const Rational slack = symbolic::parse_number("1e-12");
      return !(middle < domain.lower - slack) && !(domain.upper + slack < middle);
    };
    const auto inside = [&](const CurveSolution& s) {
      return s.reality == Reality::real && within(*s.t, t_domain) && within(*s.u, u_domain);
    };
    CHECK(std::count_if(all.solutions.begin(), all.solutions.end(), inside) ==
          static_cast<long>(trimmed.solutions.size()));
    CHECK(std::all_of(trimmed.solutions.begin(), trimmed.solutions.end(),
                      [&](const CurveSolution& s) { return s.inside && inside(s); }));
    CHECK(std::count_if(trimmed.solutions.begin(), trimmed.solutions.end(),
                        [&](const CurveSolution& s) { return is_t(s, c) && is_u(s, e); }) == 1);
  }
}

TEST_CASE("Lines meet in one pair of rational parameters") {
  const CurveResult result = meet(map_of({"0", "t - 2", "1 - t"}), map_of({"3 - t", "2 - 2*t", "t"}));
  CHECK(complete_audit_holds(result, 1));
  CHECK(count_of(result, -2, 3, 1) == 1);
}

TEST_CASE("Parallel lines meet at infinity of both parameters") {
  const CurveResult result = meet(map_of({"t", "0", "1"}), map_of({"t", "1", "1"}));
  REQUIRE(complete_audit_holds(result, 1));
  CHECK(is_infinite(result.solutions[0].t));
  CHECK(is_infinite(result.solutions[0].u));
  CHECK(result.solutions[0].point[0].real == "1");
  CHECK(result.solutions[0].point[2].real == "0");
}

TEST_CASE("Every branch of a double point is a solution") {
  const ParametricCurve node = map_of({"t^2 - 1", "t^3 - t", "1"});
  const CurveResult result = meet(node, map_of({"t", "2*t", "1"}));
  CHECK(complete_audit_holds(result, 3));
  CHECK(count_of(result, -1, 0, 1) == 1);
  CHECK(count_of(result, 1, 0, 1) == 1);
  CHECK(count_of(result, 2, 3, 1) == 1);
  // The line y = x is the tangent of the branch t = 1.
  const CurveResult tangent = meet(node, map_of({"t", "t", "1"}));
  CHECK(complete_audit_holds(tangent, 3));
  CHECK(count_of(tangent, -1, 0, 1) == 1);
  CHECK(count_of(tangent, 1, 0, 2) == 1);
}

TEST_CASE("Lines through a cusp, and through a point at infinity") {
  const ParametricCurve cusp = map_of({"t^2", "t^3", "1"});
  const CurveResult tangent = meet(cusp, map_of({"t", "0", "1"}));
  CHECK(complete_audit_holds(tangent, 3));
  CHECK(count_of(tangent, 0, 0, 3) == 1);
  const CurveResult transversal = meet(cusp, map_of({"0", "t", "1"}));
  REQUIRE(complete_audit_holds(transversal, 3));
  CHECK(count_of(transversal, 0, 0, 2) == 1);
  CHECK(is_infinite(transversal.solutions[1].t));
  CHECK(is_infinite(transversal.solutions[1].u));
  CHECK(transversal.solutions[1].multiplicity == 1);
}

TEST_CASE("A cusp on another cusp, and two cusps with a common tangent") {
  const CurveResult crossed = meet(map_of({"t^2", "t^3", "1"}), map_of({"t^3", "t^2", "1"}));
  CHECK(complete_audit_holds(crossed, 9));
  CHECK(count_of(crossed, 0, 0, 4) == 1);
  CHECK(count_of(crossed, 1, 1, 1) == 1);
  const CurveResult common = meet(map_of({"t^2", "t^3", "1"}), map_of({"t^2", "2*t^3", "1"}));
  CHECK(complete_audit_holds(common, 9));
  CHECK(count_of(common, 0, 0, 6) == 1);
}

TEST_CASE("A map that covers its curve twice meets a line in both parameters") {
  const CurveResult result = meet(map_of({"t^2", "t^4", "1"}), map_of({"t", "t", "1"}));
  CHECK(complete_audit_holds(result, 4));
  CHECK(count_of(result, 0, 0, 2) == 1);
  CHECK(count_of(result, -1, 1, 1) == 1);
  CHECK(count_of(result, 1, 1, 1) == 1);
}

TEST_CASE("A common factor of the coordinates and a raised degree change nothing") {
  const std::vector<Polynomial> a{in_t("t^3 - t"), in_t("t^2 + 3"), in_t("t + 5")};
  const ParametricCurve other = map_of({"2*t^2 - 1", "t - 4", "t^2 + 1"});
  const CurveResult result = meet(map_of(a), other);
  CHECK(complete_audit_holds(result, 6));
  std::vector<Polynomial> multiple;
  for (const Polynomial& f : a) multiple.push_back(f * in_t("3*(t - 2)*(t^2 + 1)"));
  CHECK(same_pairs(result, meet(map_of(multiple), other)));
}

TEST_CASE("Ends of curves: touching, short of it and beyond by a power of two") {
  const ParametricCurve segment = map_of({"t", "0", "1"}, Interval{0, 1});
  for (const long exponent : {0L, 13L, 20L, 27L, 200L})
    for (const int side : {-1, 1}) {
      CAPTURE(exponent);
      CAPTURE(side);
      const Rational push = exponent == 0 ? Rational(0) : Rational(side) * power_of_two(-exponent);
      const std::vector<Polynomial> wall{t_constant(Rational(1) + push), t_variable(), t_constant(1)};
      for (const Interval& domain : {Interval{-1, 1}, Interval{0, 1}, Interval{-1, 0}}) {
        const CurveResult result = meet(segment, map_of(wall, domain));
        CHECK(result.status == Status::certified);
        const bool meets = exponent == 0 || side < 0;
        CHECK(result.solutions.size() == (meets ? 1U : 0U));
        CHECK(count_of(result, Rational(1) + push, 0, 1) == (meets ? 1 : 0));
        CHECK(result.counts.inside == result.solutions.size());
      }
    }
}

TEST_CASE("A tangent line, and lines just above and below it") {
  const ParametricCurve parabola = map_of({"t", "t^2", "1"}, Interval{-1, 1});
  for (const long exponent : {0L, 13L, 20L, 27L}) {
    CAPTURE(exponent);
    const Rational push = exponent == 0 ? Rational(0) : power_of_two(-2 * exponent);
    const auto line = [&](const Rational& height) {
      return map_of({t_variable(), t_constant(height), t_constant(1)}, Interval{-1, 1});
    };
    const CurveResult above = meet(parabola, line(push));
    CHECK(above.status == Status::certified);
    if (exponent == 0) {
      CHECK(above.solutions.size() == 1);
      CHECK(count_of(above, 0, 0, 2) == 1);
      continue;
    }
    const Rational root = power_of_two(-exponent);
    CHECK(above.solutions.size() == 2);
    CHECK(count_of(above, root, root, 1) == 1);
    CHECK(count_of(above, -root, -root, 1) == 1);
    const CurveResult below = meet(parabola, line(-push));
    CHECK(below.status == Status::certified);
    CHECK(below.solutions.empty());
  }
}

TEST_CASE("Two arcs of one curve: the overlap, a common end, or nothing") {
  for (const auto& [from, to] : {std::pair<Rational, Rational>{Rational(1) / Rational(4), Rational(3) / Rational(4)},
                                 {Rational(1) / Rational(2), Rational(3)},
                                 {Rational(-2), Rational(1) / Rational(3)},
                                 {Rational(0), Rational(1)},
                                 {Rational(-1), Rational(2)},
                                 {Rational(3) / Rational(4), Rational(1) / Rational(4)}}) {
    CAPTURE(from.to_string());
    CAPTURE(to.to_string());
    const auto [first, second] = two_arcs(from, to);
    const CurveResult result = meet(first, second);
    const Rational lowest = from < to ? from : to;
    const Rational highest = from < to ? to : from;
    const Rational lower = lowest < Rational(0) ? Rational(0) : lowest;
    const Rational upper = Rational(1) < highest ? Rational(1) : highest;
    Rational u_lower = (lower - from) / (to - from);
    Rational u_upper = (upper - from) / (to - from);
    if (u_upper < u_lower) std::swap(u_lower, u_upper);
    CHECK(result.status == Status::infinite);
    CHECK(result.rest_status == Status::certified);
    REQUIRE(result.overlap.size() == 1);
    CHECK(result.overlap[0].certified);
    CHECK(is_interval(result.overlap[0].t, lower, upper));
    CHECK(is_interval(result.overlap[0].u, u_lower, u_upper));
    const CurveResult swapped = meet(second, first);
    REQUIRE(swapped.overlap.size() == 1);
    CHECK(is_interval(swapped.overlap[0].t, u_lower, u_upper));
    CHECK(is_interval(swapped.overlap[0].u, lower, upper));
  }
  const auto [first, second] = two_arcs(1, 2);
  const CurveResult touching = meet(first, second);
  CHECK(touching.overlap.empty());
  CHECK(touching.solutions.size() == 1);
  CHECK(count_of(touching, 1, 0, 1) == 1);
  const auto [left, right] = two_arcs(Rational(1) + power_of_two(-27), 2);
  const CurveResult apart = meet(left, right);
  CHECK(apart.overlap.empty());
  CHECK(apart.solutions.empty());
}

TEST_CASE("A curve with a double point against itself: the overlap, and the two pairs of the double point") {
  const ParametricCurve node = map_of({"t^2 - 1", "t^3 - t", "1"});
  const CurveResult result = meet(node, node);
  CHECK(result.status == Status::infinite);
  CHECK(result.rest_status == Status::certified);
  REQUIRE(result.overlap.size() == 1);
  CHECK_FALSE(result.overlap[0].t);
  CHECK(result.solutions.size() == 2);
  CHECK(count_of(result, -1, 1, 1) == 1);
  CHECK(count_of(result, 1, -1, 1) == 1);
}

TEST_CASE("Two space curves: the multiplicity is the least contact of projections, not that of two equations") {
  // 2 y - z vanishes to a higher order than y and z.
  for (const long factor : {-3, -2, -1, 1, 2, 3, 5}) {
    const std::vector<Polynomial> parabola{in_t("t"), in_t("t^2"), t_constant(factor) * in_t("t^2") + in_t("t^3"),
                                           in_t("1")};
    for (const auto& [first, second] : {std::pair{map_of({"t", "0", "0", "1"}), map_of(parabola)},
                                        std::pair{map_of(parabola), map_of({"t", "0", "0", "1"})}}) {
      const CurveResult result = meet(first, second);
      CHECK(result.status == Status::certified);
      REQUIRE(result.solutions.size() == 1);
      CHECK(result.solutions[0].multiplicity == 2);
    }
  }
  // Contact of order 3, and a cusp met by its tangent and by another line.
  CHECK(meet(map_of({"t", "0", "0", "1"}), map_of({"t", "t^3", "2*t^3+t^4", "1"})).solutions[0].multiplicity == 3);
  const ParametricCurve cusp = map_of({"t^2", "t^3", "t^4", "1"});
  CHECK(meet(map_of({"t", "0", "0", "1"}), cusp).solutions[0].multiplicity == 3);
  CHECK(meet(map_of({"0", "t", "t", "1"}), cusp).solutions[0].multiplicity == 2);
  // Two cusps: the multiplicity is a bound.
  const CurveResult two = meet(map_of({"t^3", "t^2", "t^4", "1"}), cusp);
  CHECK(two.status == Status::numeric);
  const auto at_origin = std::find_if(two.solutions.begin(), two.solutions.end(),
                                      [](const CurveSolution& s) { return is_t(s, 0) && is_u(s, 0); });
  REQUIRE(at_origin != two.solutions.end());
  CHECK_FALSE(at_origin->certified);
  CHECK(at_origin->multiplicity >= 4);
}

TEST_CASE("Two space curves: the end of a domain on a line, whose moving planes have no parameter") {
  const std::vector<Polynomial> curve{in_t("t"), in_t("t-1"), in_t("t^2-t"), in_t("1")};
  for (const auto& [lower, upper, size] :
       {std::tuple{0L, 1L, 1U}, std::tuple{1L, 2L, 1U}, std::tuple{0L, 2L, 1U}, std::tuple{2L, 3L, 0U}}) {
    const CurveResult result = meet(map_of({"t", "0", "0", "1"}), map_of(curve, Interval{lower, upper}));
    CHECK(result.status == Status::certified);
    CHECK(result.solutions.size() == size);
    CHECK(meet(map_of(curve, Interval{lower, upper}), map_of({"t", "0", "0", "1"})).solutions.size() == size);
  }
}

TEST_CASE("A solution on a seam between two pieces is listed once") {
  const ParametricCurve circle = circle_of_arcs();
  const CurveResult result = meet(circle, map_of({"t", "0", "1"}));
  CHECK(result.status == Status::certified);
  // The ends of the closed circle are one point, too.
  CHECK(result.solutions.size() == 2);
  for (const auto& [t, u] : {std::pair{0, 1}, {2, -1}}) CHECK(count_of(result, t, u, 1) == 1);
  const CurveResult diagonal = meet(circle, equation("y - x"));
  CHECK(diagonal.solutions.size() == 2);
  const CurveResult axis = meet(circle, equation("y"));
  CHECK(axis.solutions.size() == 2);
  for (const int t : {0, 2}) CHECK(count_of(axis, t, 1) == 1);
  const CurveResult tangent = meet(circle, equation("y - 1"));
  CHECK(tangent.solutions.size() == 1);
  CHECK(count_of(tangent, 1, 2) == 1);
}

TEST_CASE("The ends of a single map are two parameters, of a curve of pieces one seam") {
  const ParametricCurve loop = map_of({"t^2 - 1", "t^3 - t", "1"}, Interval{-1, 1});
  CHECK(meet(loop, equation("x - 2*y")).solutions.size() == 3);
  ParametricCurve cut = map_of({"t^2 - 1", "t^3 - t", "1"}, Interval{-1, 0});
  cut.pieces.push_back(map_of({"t^2 - 1", "t^3 - t", "1"}, Interval{0, 1}).pieces[0]);
  const CurveResult once = meet(cut, equation("x - 2*y"));
  REQUIRE(once.solutions.size() == 2);
  CHECK(is_t(once.solutions[0], -1));
  CHECK(is_t(once.solutions[1], Rational(1) / Rational(2)));
}

TEST_CASE("Pieces with disjoint boxes are left out of the counts, and of them alone") {
  ParametricCurve zigzag = map_of({"t", "t^2", "1"}, Interval{0, 1});
  zigzag.pieces.push_back(map_of({"t", "2-t", "1"}, Interval{1, 2}).pieces[0]);
  const ParametricCurve far = map_of({"t", "t+5", "1"}, Interval{0, 1});
  const CurveResult apart = meet(zigzag, far);
  CHECK(apart.status == Status::certified);
  CHECK(apart.solutions.empty());
  CHECK(apart.counts.within_domains_only);
  CHECK(apart.counts.distinct == 0);
  // All complex solutions, and the exact engine, look at every pair: two points of the parabola, one of the line.
  const CurveResult complex = meet(zigzag, far, Field::complex);
  CHECK_FALSE(complex.counts.within_domains_only);
  CHECK(complex.counts.expected == 3);
  CHECK(complex.solutions.size() == 3);
  // A single pair that the box engine does not answer keeps its audit.
  CHECK(meet(map_of({"t", "t^2", "1"}, Interval{0, 1}), far, Field::complex).counts.expected == 2);
  // Boxes that only touch say nothing.
  const CurveResult touching = meet(zigzag, map_of({"t", "t-2", "1"}, Interval{2, 3}));
  CHECK(touching.solutions.size() == 1);
}

TEST_CASE("Curves of pieces with common seams, corners and overlaps: exchanging them exchanges t and u") {
  Draw draw(4242);
  int with_overlap = 0;
  int at_seams = 0;
  for (int run = 0; run < 200; ++run) {
    CornerCurves curves(draw, run % 3 == 2 ? 3 : 2);
    const ParametricCurve first = curves.next();
    const ParametricCurve second = run % 10 == 0 ? first : curves.next();
    CAPTURE(run);
    const CurveResult there = meet(first, second);
    const CurveResult back = meet(second, first);
    CHECK(there.status == back.status);
    CHECK(there.rest_status == back.rest_status);
    CHECK(there.solutions.size() == back.solutions.size());
    for (const CurveSolution& a : there.solutions)
      CHECK(std::count_if(back.solutions.begin(), back.solutions.end(), [&](const CurveSolution& b) {
              return may_agree(a.t, b.u) && may_agree(a.u, b.t) && a.multiplicity == b.multiplicity;
            }) == 1);
    CHECK(there.overlap.size() == back.overlap.size());
    for (const intersect::Overlap& a : there.overlap)
      CHECK(std::any_of(back.overlap.begin(), back.overlap.end(), [&](const intersect::Overlap& b) {
        const auto same = [](const auto& i, const auto& j) {
          if (!i || !j) return !i && !j;
          return may_agree((*i)[0], (*j)[0]) && may_agree((*i)[1], (*j)[1]);
        };
        return same(a.t, b.u) && same(a.u, b.t);
      }));
    // No pair is listed twice.
    for (std::size_t i = 0; i < there.solutions.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        CHECK_FALSE((may_agree(there.solutions[i].t, there.solutions[j].t) &&
                     may_agree(there.solutions[i].u, there.solutions[j].u)));
    with_overlap += there.overlap.empty() ? 0 : 1;
    for (const CurveSolution& s : there.solutions)
      if ((*s.t)->exact && (*s.u)->exact) ++at_seams;
  }
  CHECK(with_overlap > 20);
  CHECK(at_seams > 50);
}

TEST_CASE("An arc and its circle: the overlap, through infinity of a parameter too") {
  const ParametricCurve quarter = map_of({"1 - t^2", "2*t", "1 + t^2"}, Interval{0, 1});
  const CurveResult whole = meet(map_of({"1 - t^2", "2*t", "1 + t^2"}), quarter);
  REQUIRE(whole.overlap.size() == 1);
  CHECK(is_interval(whole.overlap[0].t, 0, 1));
  const CurveResult through = meet(map_of({"t^2 - 1", "2*t", "1 + t^2"}), quarter);
  REQUIRE(through.overlap.size() == 1);
  REQUIRE(through.overlap[0].t);
  CHECK(is_value((*through.overlap[0].t)[0], 1, -14));
  CHECK_FALSE((*through.overlap[0].t)[1]);
  CHECK(is_interval(through.overlap[0].u, 0, 1));
}

TEST_CASE("A map against an equation agrees with two maps and with two equations") {
  const ParametricCurve node = map_of({"t^2 - 1", "t^3 - t", "1"});
  const Curve circle = equation("x^2 + y^2 - 1/4");
  const CurveResult maps = meet(node, map_of({"1 - t^2", "2*t", "2 + 2*t^2"}));
  const CurveResult mixed = meet(node, circle);
  const CurveResult swapped = meet(circle, node);
  const CurveResult equations = meet(equation("y^2 - x^2*(x + 1)"), circle);
  CHECK(complete_audit_holds(maps, 6));
  CHECK(complete_audit_holds(mixed, 6));
  CHECK(complete_audit_holds(swapped, 6));
  CHECK(complete_audit_holds(equations, 6));
  REQUIRE(maps.solutions.size() == mixed.solutions.size());
  for (std::size_t k = 0; k < maps.solutions.size(); ++k) {
    CHECK(may_agree(maps.solutions[k].t, mixed.solutions[k].t));
    CHECK(may_agree(maps.solutions[k].t, swapped.solutions[k].u));
    CHECK_FALSE(swapped.solutions[k].t);
    CHECK(maps.solutions[k].multiplicity == mixed.solutions[k].multiplicity);
  }
}

TEST_CASE("A map against an equation: contact of order three, and a curve on the curve") {
  const CurveResult flex = meet(map_of({"t", "t^3", "1"}), equation("y"));
  CHECK(complete_audit_holds(flex, 3));
  CHECK(count_of(flex, 0, 3) == 1);
  const CurveResult infinite = meet(map_of({"t", "t^3", "1"}), equation("y - 1"));
  CHECK(complete_audit_holds(infinite, 3));
  const CurveResult on = meet(map_of({"1 - t^2", "2*t", "1 + t^2"}, Interval{-1, 2}), equation("x^2 + y^2 - 1"));
  CHECK(on.status == Status::infinite);
  REQUIRE(on.overlap.size() == 1);
  CHECK(is_interval(on.overlap[0].t, -1, 2));
}

TEST_CASE("Bezier curves: points of weights that are not one, and curves of lower degree than they are given") {
  // Two quarters of circles with a common end, the second one centred in (2, 0).
  const ParametricCurve first{{symbolic::bezier_curve({{1, 0, 1}, {1, 1, 1}, {0, 2, 2}})}};
  const ParametricCurve second{{symbolic::bezier_curve({{1, 0, 1}, {1, 1, 1}, {4, 2, 2}})}};
  const CurveResult touching = meet(first, second);
  CHECK(touching.status == Status::certified);
  CHECK(touching.solutions.size() == 1);
  CHECK(count_of(touching, 0, 0, 2) == 1);
  // A straight line with four control points.
  const ParametricCurve line{{symbolic::bezier_curve({{0, 0, 1}, {1, 1, 3}, {2, 2, 3}, {1, 1, 1}})}};
  const CurveResult result = meet(first, line);
  CHECK(result.status == Status::certified);
  REQUIRE(result.solutions.size() == 1);
  // tan(pi / 8) is the parameter of the quarter's middle.
  CHECK(result.solutions[0].t.value()->real == "0.414213562373095");
}

TEST_CASE("A single point is no curve, and a space curve does not meet a plane one") {
  CHECK_THROWS_AS(meet(map_of({"1", "2", "1"}), map_of({"t", "0", "1"})), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"1", "2", "1"}), equation("x")), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"t", "0", "1"}), equation("0")), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"t", "0", "1"}), equation("3")), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"t", "0", "1"}), map_of({"t", "0", "1", "1"})), InvalidInput);
}
