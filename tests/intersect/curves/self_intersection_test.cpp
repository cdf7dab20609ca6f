// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/intersect/curves/self_intersection.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>
#include <intersect/curve_helpers.hpp>
#include <support/curves.hpp>

using namespace eliminant;
using namespace eliminant::test;
using intersect::CurveResult;
using intersect::CurveSolution;
using intersect::Field;
using intersect::PairKind;
using intersect::Reality;
using intersect::Status;
using symbolic::Interval;
using symbolic::ParametricCurve;

namespace {

CurveResult solve(const intersect::Curve& curve, const intersect::Options& options = {}) {
  return intersect::intersect_curve_with_itself({curve}, options, Context());
}

CurveResult solve_real(const intersect::Curve& curve) {
  intersect::Options options;
  options.field = Field::real;
  return solve(curve, options);
}

CurveResult singular_points(std::string_view equation) { return solve(intersect::ImplicitCurve{curve(equation)}); }

ParametricCurve piecewise(const std::vector<std::pair<std::vector<const char*>, Interval>>& pieces) {
  ParametricCurve result;
  for (const auto& [texts, domain] : pieces) {
    std::vector<Polynomial> coordinates;
    for (const char* text : texts) coordinates.push_back(in_t(text));
    result.pieces.push_back({symbolic::rational_curve(coordinates), domain});
  }
  return result;
}

/// Kinds with multiplicities, as often as they occur.
using Kinds = std::map<std::pair<PairKind, unsigned long>, int>;

Kinds kinds(const CurveResult& result) {
  Kinds found;
  for (const CurveSolution& solution : result.solutions) {
    REQUIRE(solution.kind.has_value());
    ++found[{*solution.kind, solution.multiplicity}];
  }
  return found;
}

/// Both parameters have the point that is printed, and are conjugate, equal or real where the kind says so.
void check_pairs(const CurveResult& result, const symbolic::RationalCurve& map) {
  for (const CurveSolution& solution : result.solutions) {
    CHECK(may_be_same_point(point_at(map, *solution.t), balls(solution.point)));
    CHECK(may_be_same_point(point_at(map, *solution.u), balls(solution.point)));
    if (solution.kind == PairKind::isolated) {
      bridge::ComplexBall sum;
      acb_add(sum.get(), (*solution.t)->ball.get(), (*solution.u)->ball.get(), check_bits);
      CHECK(arb_contains_zero(sum.imaginary()) != 0);
      CHECK(arb_contains_zero((*solution.t)->ball.imaginary()) == 0);
    }
    CHECK((solution.kind == PairKind::cusp) == may_agree(solution.t, solution.u));
    if (solution.kind == PairKind::crossing) CHECK(solution.reality == Reality::real);
    if (solution.kind == PairKind::complex) CHECK(solution.reality == Reality::non_real);
  }
}

/// Of a plane map that takes general points once.
void check_delta(const CurveResult& result, long degree) {
  CHECK(complete_audit_holds(result, static_cast<unsigned long>((degree - 1) * (degree - 2) / 2)));
  unsigned long of_points = 0;
  for (const auto& point : result.singular_points) of_points += point.multiplicity;
  CHECK(of_points == result.counts.with_multiplicity);
}

std::vector<Polynomial> random_plane_map(Draw& draw, long degree, long size) {
  return {random_in_t(draw, degree, size), random_in_t(draw, degree, size), random_in_t(draw, degree, size)};
}

/// Every form with (a t + b) / (c t + d) in place of t.
std::vector<Polynomial> moebius(const std::vector<Polynomial>& coordinates, long degree, long a, long b, long c,
                                long d) {
  const Polynomial above = t_constant(a) * t_variable() + t_constant(b);
  const Polynomial below = t_constant(c) * t_variable() + t_constant(d);
  std::vector<Polynomial> result;
  for (const Polynomial& f : coordinates) {
    Polynomial sum = t_constant(0);
    for (const Polynomial::Term& term : f.terms())
      sum = sum + t_constant(term.coefficient) * power(above, term.exponents[0]) *
                      power(below, static_cast<unsigned long>(degree) - term.exponents[0]);
    result.push_back(sum);
  }
  return result;
}

}  // namespace

TEST_CASE("self_intersection: node, cusp and isolated point of cubics") {
  const CurveResult node = solve(map_of({"t^2-1", "t^3-t", "1"}));
  check_delta(node, 3);
  CHECK(kinds(node) == Kinds{{{PairKind::crossing, 1}, 1}});
  CHECK(is_t(node.solutions[0], -1));
  CHECK(is_u(node.solutions[0], 1));
  CHECK(node.solutions[0].inside);

  const CurveResult cusp = solve(map_of({"t^2", "t^3", "1"}));
  check_delta(cusp, 3);
  CHECK(kinds(cusp) == Kinds{{{PairKind::cusp, 1}, 1}});
  CHECK(is_t(cusp.solutions[0], 0));
  CHECK(is_u(cusp.solutions[0], 0));

  const CurveResult isolated = solve(map_of({"t^2+1", "t^3+t", "1"}));
  check_delta(isolated, 3);
  CHECK(kinds(isolated) == Kinds{{{PairKind::isolated, 1}, 1}});
  CHECK(isolated.solutions[0].reality == Reality::real);
  CHECK_FALSE(isolated.solutions[0].inside);
  CHECK(isolated.solutions[0].point[0].real == "0");
  CHECK(solve_real(map_of({"t^2+1", "t^3+t", "1"})).solutions.size() == 1);
}

TEST_CASE("self_intersection: a line and a conic have none") {
  for (const auto& curve :
       {map_of({"t", "2*t+1", "1"}), map_of({"1-t^2", "2*t", "1+t^2"}), map_of({"t", "t^2", "1"})}) {
    const CurveResult result = solve(curve);
    CHECK(result.status == Status::certified);
    CHECK(result.solutions.empty());
    CHECK(result.counts.expected == 0);
    CHECK(result.covering == 1);
  }
}

TEST_CASE("self_intersection: Bernoulli's lemniscate has a node and the circular points, t = infinity among them") {
  const CurveResult result = solve(map_of({"t+t^3", "t-t^3", "1+t^4"}));
  check_delta(result, 4);
  CHECK(kinds(result) == Kinds{{{PairKind::crossing, 1}, 1}, {{PairKind::complex, 1}, 2}});
  const auto node = std::find_if(result.solutions.begin(), result.solutions.end(),
                                 [](const CurveSolution& s) { return s.kind == PairKind::crossing; });
  CHECK(is_t(*node, 0));
  CHECK(is_infinite(node->u));
  const CurveResult real = solve_real(map_of({"t+t^3", "t-t^3", "1+t^4"}));
  CHECK(real.solutions.size() == 1);
  CHECK(real.counts.distinct == 3);
}

TEST_CASE("self_intersection: the multiplicity of a pair is the contact of its branches") {
  // y = x^2 -+ x^3 + ... at t = -1 and t = 1.
  const CurveResult oscnode = solve(map_of({"t^3-t", "(t^2-1)^2", "1"}));
  check_delta(oscnode, 4);
  CHECK(kinds(oscnode) == Kinds{{{PairKind::crossing, 3}, 1}});
  // y = x^2 and y = 3 x^2 + ...
  const CurveResult tacnode = solve(map_of({"t^3-t", "(t+2)*(t^2-1)^2", "1"}));
  check_delta(tacnode, 5);
  const auto contact = std::find_if(tacnode.solutions.begin(), tacnode.solutions.end(),
                                    [](const CurveSolution& s) { return is_t(s, -1) && is_u(s, 1); });
  REQUIRE(contact != tacnode.solutions.end());
  CHECK(contact->multiplicity == 2);
}

TEST_CASE("self_intersection: the multiplicity of a cusp is its delta invariant") {
  // (t^2, t^5): delta 2; at infinity (s^3, s^5): delta 4.
  const CurveResult result = solve(map_of({"t^2", "t^5", "1"}));
  check_delta(result, 5);
  CHECK(kinds(result) == Kinds{{{PairKind::cusp, 2}, 1}, {{PairKind::cusp, 4}, 1}});
  CHECK(is_t(result.solutions[0], 0));
  CHECK(is_infinite(result.solutions[1].t));
  CHECK(is_infinite(result.solutions[1].u));
  // (t^3, t^4): delta 3.
  const CurveResult e6 = solve(map_of({"t^3", "t^4", "1"}));
  check_delta(e6, 4);
  CHECK(kinds(e6) == Kinds{{{PairKind::cusp, 3}, 1}});
  // Conjugate cusps: the deltoid.
  const CurveResult deltoid = solve(map_of({"(1-t^2)*(3+t^2)", "8*t^3", "(1+t^2)^2"}));
  check_delta(deltoid, 4);
}

TEST_CASE("self_intersection: a triple point is three pairs and one singular point") {
  const CurveResult result = solve(map_of({"1-3*t^2", "t*(1-3*t^2)", "(1+t^2)^2"}));
  check_delta(result, 4);
  CHECK(kinds(result) == Kinds{{{PairKind::crossing, 1}, 3}});
  REQUIRE(result.singular_points.size() == 1);
  const intersect::SingularPoint& point = result.singular_points[0];
  REQUIRE(point.parameters.size() == 3);
  CHECK(point.parameters[0]->real == "-0.577350269189626");
  CHECK(point.parameters[1]->real == "0.577350269189626");
  CHECK_FALSE(point.parameters[2].has_value());
  CHECK(point.multiplicity == 3);
  CHECK(point.reality == Reality::real);
  // A triple point with one real branch: t^3 + t = 0 has the roots 0, i, -i.
  const CurveResult one_real = solve(map_of({"t^3+t", "(t^3+t)*(t-2)", "1"}));
  check_delta(one_real, 4);
  CHECK(kinds(one_real) == Kinds{{{PairKind::isolated, 1}, 1}, {{PairKind::complex, 1}, 2}});
  REQUIRE(one_real.singular_points.size() == 1);
  CHECK(one_real.singular_points[0].reality == Reality::real);
  CHECK(one_real.singular_points[0].parameters.size() == 3);
}

TEST_CASE("self_intersection: an ordinary point of four branches, and a cusp on another branch") {
  const CurveResult four = solve(map_of({"t*(t^2-1)*(t-2)", "t*(t^2-1)*(t-2)*(t+3)", "1"}));
  check_delta(four, 5);
  REQUIRE(four.singular_points.size() == 1);
  CHECK(four.singular_points[0].parameters.size() == 4);
  CHECK(four.solutions.size() == 6);
  // t = 0 is a cusp (delta 1), t = 1 a branch through it (contact 2 or 3).
  const CurveResult mixed = solve(map_of({"t^2*(t-1)", "t^3*(t-1)", "1"}));
  check_delta(mixed, 4);
  CHECK(kinds(mixed) == Kinds{{{PairKind::cusp, 1}, 1}, {{PairKind::crossing, 2}, 1}});
  CHECK(mixed.singular_points.size() == 1);
  CHECK(mixed.singular_points[0].multiplicity == 3);
}

TEST_CASE("self_intersection: random plane maps satisfy the delta audit, whatever the coordinates and the parameter") {
  Draw draw(20240);
  for (int run = 0; run < 12; ++run) {
    const long degree = 3 + run % 6;
    const std::vector<Polynomial> map = random_plane_map(draw, degree, 5);
    CAPTURE(run);
    const ParametricCurve curve = map_of(map);
    if (curve.pieces[0].map.degree() < degree) continue;
    const CurveResult result = solve(curve);
    check_delta(result, degree);
    check_pairs(result, curve.pieces[0].map);
    // A change of coordinates keeps parameters and multiplicities.
    const std::vector<Polynomial> changed{map[0] + t_constant(2) * map[1] - map[2],
                                          map[1] - t_constant(3) * map[0] + map[2],
                                          map[2] + t_constant(Rational(1) / Rational(2)) * map[1]};
    const CurveResult in_other_coordinates = solve(map_of(changed));
    REQUIRE(in_other_coordinates.solutions.size() == result.solutions.size());
    for (std::size_t k = 0; k < result.solutions.size(); ++k) {
      CHECK(may_agree(result.solutions[k].t, in_other_coordinates.solutions[k].t));
      CHECK(may_agree(result.solutions[k].u, in_other_coordinates.solutions[k].u));
      CHECK(result.solutions[k].kind == in_other_coordinates.solutions[k].kind);
    }
    // Another parameter keeps the kinds.
    if (degree > 6) continue;
    const CurveResult other = solve(map_of(moebius(map, degree, 2, 1, 1, 3)));
    check_delta(other, degree);
    CHECK(kinds(other) == kinds(result));
  }
}

TEST_CASE("self_intersection: the Milnor numbers of the equation are 2 delta - branches + 1, point by point") {
  // Coefficients from -1 to 1: many cusps, contacts and multiple points, at infinity too.
  Draw draw(611);
  int compared = 0;
  int cusps = 0;
  int larger = 0;
  for (int run = 0; run < 80; ++run) {
    const long degree = 3 + run % 3;
    const std::vector<Polynomial> map = random_plane_map(draw, degree, 1);
    if (map[0].is_zero() && map[1].is_zero() && map[2].is_zero()) continue;
    const ParametricCurve curve = map_of(map);
    if (curve.pieces[0].map.degree() < 1) continue;
    CAPTURE(run);
    const CurveResult by_map = solve(curve);
    if (by_map.status == Status::infinite) continue;
    check_delta(by_map, curve.pieces[0].map.degree());
    check_pairs(by_map, curve.pieces[0].map);
    const std::vector<Polynomial> affine{Polynomial::variable(2, 0), Polynomial::variable(2, 1),
                                         Polynomial::constant(2, 1)};
    const Polynomial equation = symbolic::implicit_equation(curve.pieces[0].map, 0, Context()).compose(affine);
    const CurveResult by_equation = solve(intersect::ImplicitCurve{equation});
    CHECK(by_equation.status == Status::certified);
    REQUIRE(by_equation.solutions.size() == by_map.singular_points.size());
    for (const CurveSolution& singular : by_equation.solutions) {
      int matches = 0;
      for (const intersect::SingularPoint& point : by_map.singular_points) {
        if (!may_be_same_point(balls(point.point), balls(singular.point))) continue;
        ++matches;
        CHECK(singular.multiplicity == 2 * point.multiplicity - point.parameters.size() + 1);
        CHECK(singular.reality == point.reality);
        if (singular.multiplicity == 2) ++cusps;
        if (singular.multiplicity > 2) ++larger;
      }
      CHECK(matches == 1);
    }
    ++compared;
  }
  CHECK(compared > 40);
  CHECK(cusps > 5);
  CHECK(larger > 10);
}

TEST_CASE("self_intersection: planted singularities survive changes of parameter") {
  const std::vector<std::pair<std::vector<Polynomial>, long>> maps{
      {{in_t("t^2"), in_t("t^5"), in_t("1")}, 5},
      {{in_t("1-3*t^2"), in_t("t*(1-3*t^2)"), in_t("(1+t^2)^2")}, 4},
      {{in_t("t^3-t"), in_t("(t+2)*(t^2-1)^2"), in_t("1")}, 5},
      {{in_t("t^2*(t-1)"), in_t("t^3*(t-1)"), in_t("1")}, 4}};
  for (const auto& [map, degree] : maps) {
    const CurveResult plain = solve(map_of(map));
    for (const auto& [a, b, c, d] :
         {std::array{1L, 2L, 0L, 3L}, std::array{0L, 1L, 1L, 0L}, std::array{3L, 1L, 2L, 5L}}) {
      const CurveResult changed = solve(map_of(moebius(map, degree, a, b, c, d)));
      check_delta(changed, degree);
      CHECK(kinds(changed) == kinds(plain));
      CHECK(changed.singular_points.size() == plain.singular_points.size());
    }
  }
}

TEST_CASE("self_intersection: space curves by three moving planes") {
  CHECK(solve(map_of({"t", "t^2", "t^3", "1"})).solutions.empty());
  CHECK(solve(map_of({"t", "t^2", "t^3", "1"})).status == Status::certified);
  const CurveResult cusp = solve(map_of({"t^2", "t^3", "t^4", "1"}));
  CHECK(cusp.status == Status::certified);
  CHECK(kinds(cusp) == Kinds{{{PairKind::cusp, 1}, 1}});
  // (t^2, t^5): delta 2, as in a plane; branches in contact at -1 and 1.
  CHECK(kinds(solve(map_of({"t^2", "t^5", "t^6", "1"}))).at({PairKind::cusp, 2}) == 1);
  const CurveResult contact = solve(map_of({"t^3-t", "(t^2-1)^2", "(t^2-1)^3", "1"}));
  CHECK(contact.status == Status::certified);
  CHECK(kinds(contact).at({PairKind::crossing, 3}) == 1);
  // A curve in a plane of space is a plane curve.
  check_delta(solve(map_of({"t^2-1", "t^3-t", "t^2+1", "1"})), 3);
  Draw draw(77);
  for (int run = 0; run < 8; ++run) {
    // All coordinates have the same values at 0 and 1, or at the roots of t^2 + 1.
    const bool real = run % 2 == 0;
    const Polynomial ends = real ? in_t("t*(t-1)") : in_t("t^2+1");
    std::vector<Polynomial> map;
    for (int k = 0; k < 4; ++k)
      map.push_back(t_constant(draw.between(1, 5)) + ends * random_in_t(draw, 2 + run % 3, 4));
    CAPTURE(run);
    const CurveResult result = solve(map_of(map));
    CHECK(result.status == Status::certified);
    CHECK(kinds(result) == Kinds{{{real ? PairKind::crossing : PairKind::isolated, 1}, 1}});
    check_pairs(result, map_of(map).pieces[0].map);
    if (!real) continue;
    CHECK(is_t(result.solutions[0], 0));
    CHECK(is_u(result.solutions[0], 1));
  }
}

TEST_CASE("self_intersection: a map that takes general points several times") {
  const CurveResult twice = solve(map_of({"t^2", "t^4+t^2", "1"}));
  CHECK(twice.status == Status::infinite);
  CHECK(twice.rest_status == Status::certified);
  CHECK(twice.covering == 2);
  CHECK(twice.solutions.empty());
  REQUIRE(twice.overlap.size() == 1);
  CHECK_FALSE(twice.overlap[0].t.has_value());
  CHECK(solve(map_of({"t^3", "t^6", "1"})).covering == 3);
  CHECK(solve(map_of({"t^2", "t^2", "1"})).covering == 2);

  // Traced once, folded at 0, and folded beyond that.
  const CurveResult once = solve(map_of({"t^2", "t^4", "1"}, Interval{0, 1}));
  CHECK(once.status == Status::certified);
  CHECK(once.overlap.empty());
  CHECK(once.solutions.empty());
  CHECK(once.covering == 2);
  const CurveResult folded = solve(map_of({"t^2", "t^4", "1"}, Interval{-1, 2}));
  REQUIRE(folded.overlap.size() == 1);
  CHECK(is_value((*folded.overlap[0].t)[0], -1, -14));
  CHECK(is_value((*folded.overlap[0].t)[1], 1, -14));
  CHECK(is_value((*folded.overlap[0].u)[0], -1, -14));
  CHECK(is_value((*folded.overlap[0].u)[1], 1, -14));
  CHECK(folded.overlap[0].reversed);

  // The nodal cubic in t^2: its node is met by all four pairs of roots of +-1.
  const CurveResult node = solve(map_of({"t^4-1", "t^6-t^2", "1"}));
  CHECK(node.status == Status::infinite);
  CHECK(node.counts.distinct == 4);
  REQUIRE(node.singular_points.size() == 1);
  CHECK(node.singular_points[0].parameters.size() == 4);
  // A circle by the double of the angle, from 0 once around: closed, and traced once.
  const std::vector<Polynomial> circle{in_t("(1-t^2)^2-4*t^2"), in_t("4*t*(1-t^2)"), in_t("(1+t^2)^2")};
  const CurveResult around = solve(map_of(circle, Interval{-1, 1}));
  CHECK(around.status == Status::certified);
  CHECK(around.covering == 2);
  CHECK(around.closed);
  CHECK(around.solutions.empty());
  // A little further: the beginning is traced again.
  const CurveResult further = solve(map_of(circle, Interval{-1, 2}));
  CHECK(further.status == Status::infinite);
  REQUIRE(further.overlap.size() == 1);
  CHECK(is_value((*further.overlap[0].t)[0], -1, -14));
  CHECK(is_value((*further.overlap[0].t)[1], Rational(-1) / Rational(2), -14));
  CHECK(is_value((*further.overlap[0].u)[0], 1, -14));
  CHECK(is_value((*further.overlap[0].u)[1], 2, -14));
}

TEST_CASE("self_intersection: domains are closed and decided exactly; where a curve closes it does not cross") {
  const auto on = [](const Rational& lower, const Rational& upper) {
    return solve(map_of({"t^2-1", "t^3-t", "1"}, Interval{lower, upper}));
  };
  const Rational tiny = power_of_two(-400);
  CHECK(on(-1, 2).solutions.size() == 1);
  CHECK(on(-2, 1).solutions.size() == 1);
  CHECK(on(-2, 2).solutions.size() == 1);
  CHECK(on(Rational(-1) + tiny, 2).solutions.empty());
  CHECK(on(-2, Rational(1) - tiny).solutions.empty());
  CHECK(on(Rational(-1) - tiny, Rational(1) + tiny).solutions.size() == 1);
  CHECK_FALSE(on(-1, 2).closed);
  const CurveResult loop = on(-1, 1);
  CHECK(loop.closed);
  CHECK(loop.solutions.empty());
  CHECK(loop.status == Status::certified);
  // The isolated point is on no real branch.
  CHECK(solve(map_of({"t^2+1", "t^3+t", "1"}, Interval{-5, 5})).solutions.empty());
  // A cusp at the end of the domain.
  CHECK(solve(map_of({"t^2", "t^3", "1"}, Interval{0, 1})).solutions.size() == 1);
  CHECK(solve(map_of({"t^2", "t^3", "1"}, Interval{tiny, 1})).solutions.empty());
}

TEST_CASE("self_intersection: a NURBS circle is closed and simple") {
  symbolic::KnotVector knots;
  knots.degree = 2;
  for (const long knot : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}) knots.knots.emplace_back(knot);
  const std::vector<std::array<long, 3>> points{{1, 0, 1},   {1, 1, 1},  {0, 2, 2},  {-1, 1, 1}, {-1, 0, 1},
                                                {-1, -1, 1}, {0, -2, 2}, {1, -1, 1}, {1, 0, 1}};
  std::vector<symbolic::ControlPoint> control;
  for (const auto& point : points) control.push_back({point[0], point[1], point[2]});
  const CurveResult result = solve(symbolic::nurbs_curve(knots, control));
  CHECK(result.status == Status::certified);
  CHECK(result.closed);
  CHECK(result.solutions.empty());
  CHECK(result.overlap.empty());
}

TEST_CASE("self_intersection: pieces that cross, meet at seams, touch and overlap") {
  // A closed figure of eight: the segments cross in the middle.
  const ParametricCurve eight = piecewise({{{"t", "t", "1"}, {0, 1}},
                                           {{"1", "2-t", "1"}, {1, 2}},
                                           {{"3-t", "t-2", "1"}, {2, 3}},
                                           {{"0", "4-t", "1"}, {3, 4}}});
  const CurveResult crossing = solve(eight);
  CHECK(crossing.status == Status::certified);
  CHECK(crossing.closed);
  CHECK(kinds(crossing) == Kinds{{{PairKind::crossing, 1}, 1}});
  CHECK(is_t(crossing.solutions[0], Rational(1) / Rational(2)));
  CHECK(is_u(crossing.solutions[0], Rational(5) / Rational(2)));

  // Back on the same segment, to its half.
  const CurveResult back =
      solve(piecewise({{{"t", "0", "1"}, {0, 1}}, {{"2-t", "0", "1"}, {1, Rational(3) / Rational(2)}}}));
  CHECK(back.status == Status::infinite);
  CHECK(back.solutions.empty());
  REQUIRE(back.overlap.size() == 1);
  CHECK(back.overlap[0].reversed);
  CHECK(is_value((*back.overlap[0].t)[0], Rational(1) / Rational(2), -14));
  CHECK(is_value((*back.overlap[0].t)[1], 1, -14));

  // A corner on the interior of a segment: a seam that is met is one solution.
  const CurveResult corner = solve(piecewise({{{"t", "0", "1"}, {-2, 2}},
                                              {{"2", "t-2", "1"}, {2, 3}},
                                              {{"5-t", "4-t", "1"}, {3, 4}},
                                              {{"5-t", "t-4", "1"}, {4, 5}}}));
  CHECK(kinds(corner) == Kinds{{{PairKind::crossing, 1}, 1}});
  CHECK(is_t(corner.solutions[0], 1));
  CHECK(is_u(corner.solutions[0], 4));

  // Three seams in one point: three pairs, one point.
  const CurveResult star = solve(piecewise({{{"t", "0", "1"}, {-1, 0}},
                                            {{"t", "t", "1"}, {0, 1}},
                                            {{"2-t", "1", "1"}, {1, 2}},
                                            {{"0", "3-t", "1"}, {2, 3}},
                                            {{"0", "3-t", "1"}, {3, 4}},
                                            {{"t-4", "-1", "1"}, {4, 5}},
                                            {{"6-t", "t-6", "1"}, {5, 6}},
                                            {{"6-t", "6-t", "1"}, {6, 7}}}));
  CHECK(star.status == Status::certified);
  CHECK(star.solutions.size() == 3);
  REQUIRE(star.singular_points.size() == 1);
  CHECK(star.singular_points[0].parameters.size() == 3);
  CHECK(is_value(star.singular_points[0].parameters[0], 0, -14));
  CHECK(is_value(star.singular_points[0].parameters[1], 3, -14));
  CHECK(is_value(star.singular_points[0].parameters[2], 6, -14));
}

TEST_CASE("self_intersection: cutting a curve into pieces changes nothing inside") {
  // Six branches through two triple points would share parameters across pieces; the trifolium cut in three does.
  const std::vector<const char*> trifolium{"1-3*t^2", "t*(1-3*t^2)", "(1+t^2)^2"};
  const CurveResult whole = solve(map_of({"1-3*t^2", "t*(1-3*t^2)", "(1+t^2)^2"}, Interval{-3, 3}));
  const CurveResult cut = solve(piecewise({{trifolium, {-3, 0}}, {trifolium, {0, 1}}, {trifolium, {1, 3}}}));
  REQUIRE(whole.solutions.size() == 1);
  REQUIRE(cut.solutions.size() == 1);
  CHECK(may_agree(whole.solutions[0].t, cut.solutions[0].t));
  CHECK(cut.status == Status::certified);
  // Four branches in one point, in four pieces: six pairs, one point.
  const std::vector<const char*> four{"t*(t^2-1)*(t-2)", "t*(t^2-1)*(t-2)*(t+3)", "1"};
  const Rational half = Rational(1) / Rational(2);
  const CurveResult of_pieces = solve(piecewise({{four, {-2, -half}},
                                                 {four, {-half, half}},
                                                 {four, {half, Rational(3) * half}},
                                                 {four, {Rational(3) * half, 3}}}));
  CHECK(of_pieces.status == Status::certified);
  CHECK(of_pieces.solutions.size() == 6);
  REQUIRE(of_pieces.singular_points.size() == 1);
  CHECK(of_pieces.singular_points[0].parameters.size() == 4);
  // The same at the seams themselves.
  const CurveResult at_seams = solve(piecewise({{four, {-1, 0}}, {four, {0, 1}}, {four, {1, 2}}}));
  CHECK(at_seams.closed);
  CHECK(at_seams.solutions.size() == 3);
  CHECK(at_seams.singular_points.size() == 1);
}

TEST_CASE("self_intersection: random curves cut anywhere, also at their double points") {
  Draw draw(9001);
  int found = 0;
  for (int run = 0; run < 24; ++run) {
    const std::size_t dimension = run % 4 == 3 ? 4 : 3;
    std::vector<Polynomial> map;
    for (std::size_t k = 0; k < dimension; ++k)
      map.push_back(t_constant(draw.between(1, 4)) + in_t("t*(t-1)") * random_in_t(draw, 2, 4));
    const Interval all{-2, 3};
    std::vector<Rational> cuts{-2};
    for (const Rational& cut :
         {Rational(-1) / Rational(2), Rational(0), Rational(1) / Rational(3), Rational(1), Rational(2)})
      if (draw.between(0, 1) == 1) cuts.push_back(cut);
    cuts.emplace_back(3);
    ParametricCurve pieces;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      pieces.pieces.push_back(map_of(map, Interval{cuts[k], cuts[k + 1]}).pieces[0]);
    CAPTURE(run);
    const CurveResult whole = solve(map_of(map, all));
    const CurveResult cut = solve(pieces);
    CHECK(whole.status == Status::certified);
    CHECK(cut.status == Status::certified);
    REQUIRE(cut.solutions.size() == whole.solutions.size());
    for (std::size_t k = 0; k < whole.solutions.size(); ++k) {
      CHECK(may_agree(whole.solutions[k].t, cut.solutions[k].t));
      CHECK(may_agree(whole.solutions[k].u, cut.solutions[k].u));
      CHECK(whole.solutions[k].multiplicity == cut.solutions[k].multiplicity);
      CHECK(whole.solutions[k].kind == cut.solutions[k].kind);
    }
    CHECK(cut.singular_points.size() == whole.singular_points.size());
    found += static_cast<int>(whole.solutions.size());
  }
  CHECK(found >= 24);
}

TEST_CASE("self_intersection: as two equal curves, without t = u and in one order") {
  Draw draw(31337);
  int crossings = 0;
  int traced_again = 0;
  for (int run = 0; run < 150; ++run) {
    CornerCurves curves(draw, run % 3 == 2 ? 3 : 2);
    const ParametricCurve curve = curves.next();
    CAPTURE(run);
    const CurveResult itself = solve(curve);
    const CurveResult twice = intersect::intersect_curve_curve({curve, curve}, {}, Context());
    // A parabola that lies in a line takes points twice.
    if (itself.covering > 1) continue;
    REQUIRE(twice.status == Status::infinite);
    CHECK(twice.rest_status == Status::certified);
    CHECK(itself.rest_status.value_or(itself.status) == Status::certified);
    REQUIRE(twice.solutions.size() == 2 * itself.solutions.size());
    for (const CurveSolution& a : itself.solutions)
      for (const bool exchanged : {false, true})
        CHECK(std::count_if(twice.solutions.begin(), twice.solutions.end(), [&](const CurveSolution& b) {
                return may_agree(exchanged ? a.u : a.t, b.t) && may_agree(exchanged ? a.t : a.u, b.u) &&
                       a.multiplicity == b.multiplicity;
              }) == 1);
    crossings += static_cast<int>(itself.solutions.size());
    traced_again += static_cast<int>(itself.overlap.size());
  }
  CHECK(crossings > 50);
  CHECK(traced_again > 20);
}

TEST_CASE("self_intersection: singular points of an equation, at infinity too") {
  const CurveResult cubic = singular_points("y^2-x^2-x^3");
  CHECK(cubic.status == Status::certified);
  CHECK(kinds(cubic) == Kinds{{{PairKind::crossing, 1}, 1}});
  CHECK(kinds(singular_points("y^2+x^2-x^3")) == Kinds{{{PairKind::isolated, 1}, 1}});
  CHECK(kinds(singular_points("y^2-x^3")) == Kinds{{{PairKind::cusp, 2}, 1}});
  CHECK(singular_points("x^2+y^2-1").solutions.empty());
  CHECK(singular_points("x^2+y^2-1").status == Status::certified);
  CHECK(singular_points("y-x^2").solutions.empty());
  CHECK(singular_points("x").solutions.empty());
  // Milnor numbers: tacnode 3, ordinary triple point 4, E8 8.
  const CurveResult tacnode = singular_points("y*(y-x^2)+y^3");
  REQUIRE(tacnode.solutions.size() == 1);
  CHECK(tacnode.solutions[0].multiplicity == 3);
  const CurveResult triple = singular_points("x*y*(x-y)");
  REQUIRE(triple.solutions.size() == 1);
  CHECK(triple.solutions[0].multiplicity == 4);
  CHECK_FALSE(triple.solutions[0].kind.has_value());
  // x^3 = y^5: E8 in the affine plane; at infinity (1 : 0 : 0), where w^2 = y^5: Milnor number 4.
  const CurveResult e8 = singular_points("x^3-y^5");
  REQUIRE(e8.solutions.size() == 2);
  CHECK(e8.counts.with_multiplicity == 12);
  // Parallel lines meet at infinity, a repeated factor is infinite.
  const CurveResult lines = singular_points("x*(x-1)");
  REQUIRE(lines.solutions.size() == 1);
  CHECK(lines.solutions[0].point[1].real == "1");
  CHECK(lines.solutions[0].point[2].real == "0");
  const CurveResult oblique = singular_points("(2*x+y)*(2*x+y-1)*(x-y)");
  CHECK(kinds(oblique) == Kinds{{{PairKind::crossing, 1}, 3}});
  const CurveResult repeated = singular_points("(x^2+y^2-1)^2*(x-y)");
  CHECK(repeated.status == Status::infinite);
  CHECK(repeated.rest_status == Status::certified);
  CHECK(repeated.solutions.size() == 2);
  CHECK_THROWS_AS(singular_points("3"), InvalidInput);
  CHECK_THROWS_AS(singular_points("x-x"), InvalidInput);
}

TEST_CASE("self_intersection: the singular points of the lemniscate by its map and by its equation are the same") {
  const CurveResult by_map = solve(map_of({"t+t^3", "t-t^3", "1+t^4"}));
  const CurveResult by_equation = singular_points("(x^2+y^2)^2-x^2+y^2");
  // x^2 - y^2 = 4 t^4 / (1+t^4)^2 and x^2 + y^2 = 2 t^2 / (1 + t^4): the equation is (x^2+y^2)^2 = x^2 - y^2.
  CHECK(by_equation.status == Status::certified);
  CHECK(by_equation.solutions.size() == by_map.solutions.size());
  CHECK(kinds(by_equation) == kinds(by_map));
  for (const CurveSolution& a : by_map.solutions)
    CHECK(std::any_of(by_equation.solutions.begin(), by_equation.solutions.end(),
                      [&](const CurveSolution& b) { return may_be_same_point(balls(a.point), balls(b.point)); }));
}

TEST_CASE("self_intersection: what is no curve is refused") {
  CHECK_THROWS_AS(solve(map_of({"t", "t", "t"})), InvalidInput);
}
