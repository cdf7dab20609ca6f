// SPDX-License-Identifier: BSD-3-Clause
//
// Bezier curves against patches and plane Bezier curves against each other, family after family
// (support/bezier_families): the engines as each other's oracle, what was planted, invariance, and elimination by
// another way. By default the dear checks see a part of each family;
//   ELIMINANT_ALL_FAMILIES   set: every check of every case
//   ELIMINANT_FAMILY         the name of the only family to check
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <intersect/curve_helpers.hpp>
#include <support/bezier_problems.hpp>
#include <support/elimination_oracle.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using bridge::ComplexBall;
using symbolic::UnivariatePolynomial;

namespace {

bool all_families() {
  return std::getenv("ELIMINANT_ALL_FAMILIES") != nullptr;  // NOLINT(concurrency-mt-unsafe)
}

std::string only_family() {
  const char* const name = std::getenv("ELIMINANT_FAMILY");  // NOLINT(concurrency-mt-unsafe)
  return name == nullptr ? "" : name;
}

/// One of so many cases of a family gets the dear checks.
bool is_chosen(const BezierCase& bezier, unsigned long of) { return all_families() || bezier.index % of == of / 2; }

/// The resultant of degree 400 takes the exact engine seconds.
bool is_dear(const BezierCase& bezier) { return !bezier.in_plane() && bezier.curve.size() > 8; }

CurveResult solve(const BezierCase& bezier, Engine engine = Engine::automatic, const Similarity& similarity = {}) {
  Options options;
  options.engine = engine;
  const Context context;
  return bezier.in_plane() ? intersect_curve_curve(curve_curve_problem(bezier, similarity), options, context)
                           : intersect_curve_surface(curve_surface_problem(bezier, similarity), options, context);
}

// What is compared with what.

/// Which parameters run backwards in the second of two results.
struct Turned {
  bool t = false;
  bool second = false;
};

bool same_parameter(const std::optional<Parameter>& a, std::optional<Parameter> b, bool turned, const Rational& reach) {
  if (turned) b = reversed(b);
  if (!may_agree(a, b)) return false;
  if (!a || !*a) return true;
  // The digits, of 1 - t where turned.
  const auto digits = [](const Parameter& parameter) { return symbolic::parse_number(parameter->real); };
  Rational other = digits(*b);
  if (turned) other = Rational(1) - other;
  const Rational difference = digits(*a) - other;
  return !(reach < difference) && !(reach < -difference);
}

Rational reach_of(const CurveSolution& solution) {
  return symbolic::parse_number("1e" + std::to_string(solution.radius_exponent));
}

/// Whether each of `a` is the same as exactly one of `b`, and no two as one.
template <class T, class Same>
bool matched(const std::vector<T>& a, const std::vector<T>& b, const Same& same) {
  std::set<std::size_t> taken;
  for (const T& x : a) {
    std::size_t matches = 0;
    for (std::size_t k = 0; k < b.size(); ++k)
      if (same(x, b[k])) {
        ++matches;
        taken.insert(k);
      }
    if (matches != 1) return false;
  }
  return a.size() == b.size() && taken.size() == b.size();
}

bool same_solution(const CurveSolution& a, const CurveSolution& b, const Turned& turned) {
  const Rational reach = reach_of(a) + reach_of(b);
  if (a.multiplicity != b.multiplicity || a.reality != b.reality || a.inside != b.inside ||
      a.surface_parameters.size() != b.surface_parameters.size() || !same_parameter(a.t, b.t, turned.t, reach) ||
      !same_parameter(a.u, b.u, turned.second, reach))
    return false;
  return matched(a.surface_parameters, b.surface_parameters,
                 [&](const std::vector<Parameter>& x, const std::vector<Parameter>& y) {
                   return same_parameter(x[0], y[0], turned.second, reach) && same_parameter(x[1], y[1], false, reach);
                 });
}

bool same_end(const std::optional<ParameterInterval>& a, const std::optional<ParameterInterval>& b, bool turned) {
  if (!a || !b) return !a && !b;
  const Rational reach = symbolic::parse_number("1e-14");
  return same_parameter((*a)[0], (*b)[turned ? 1 : 0], turned, reach) &&
         same_parameter((*a)[1], (*b)[turned ? 0 : 1], turned, reach);
}

/// The same solutions, in any order: with t and 1 - t equal parameters are not sorted alike.
bool same_results(const CurveResult& a, const CurveResult& b, const Turned& turned = {}) {
  return a.status == b.status && a.rest_status == b.rest_status &&
         matched(a.solutions, b.solutions,
                 [&](const CurveSolution& x, const CurveSolution& y) { return same_solution(x, y, turned); }) &&
         matched(a.overlap, b.overlap,
                 [&](const Overlap& x, const Overlap& y) { return same_end(x.t, y.t, turned.t); });
}

/// With the two curves in the other order.
CurveResult exchanged(CurveResult result) {
  for (CurveSolution& solution : result.solutions) std::swap(solution.t, solution.u);
  for (Overlap& overlap : result.overlap) {
    std::swap(overlap.t, overlap.u);
    // The first interval ascends, and the second runs with it.
    if (overlap.t && symbolic::parse_number((*overlap.t)[1]->real) < symbolic::parse_number((*overlap.t)[0]->real)) {
      std::swap((*overlap.t)[0], (*overlap.t)[1]);
      std::swap((*overlap.u)[0], (*overlap.u)[1]);
    }
  }
  return result;
}

std::string summary(const CurveResult& result) {
  std::string text = result.engine.method + " status " + std::to_string(static_cast<int>(result.status));
  for (const CurveSolution& solution : result.solutions) {
    text += "; t " + (solution.t && *solution.t ? (*solution.t)->real : "?");
    if (solution.u && *solution.u) text += " u " + (*solution.u)->real;
    text += " x" + std::to_string(solution.multiplicity) + (solution.inside ? "" : " outside");
  }
  for (const Overlap& overlap : result.overlap)
    if (overlap.t) text += "; overlap " + (*overlap.t)[0]->real + " to " + (*overlap.t)[1]->real;
  for (const std::string& warning : result.warnings) text += "; " + warning;
  return text;
}

// The checks.

bool is_root(const Parameter& parameter, const PlantedParameter& planted) {
  ComplexBall sum;
  for (auto coefficient = planted.polynomial.rbegin(); coefficient != planted.polynomial.rend(); ++coefficient) {
    acb_mul(sum.get(), sum.get(), parameter->ball.get(), check_bits);
    acb_add_fmpz(sum.get(), sum.get(), symbolic::Integer(*coefficient).get(), check_bits);
  }
  const double there = arf_get_d(arb_midref(parameter->ball.real()), ARF_RND_NEAR);
  return acb_contains_zero(sum.get()) != 0 && std::abs(there - planted.approximation) < 1e-6;
}

/// Proven throughout; every solution inside the domains, none twice.
void check_status(const BezierCase& bezier, const CurveResult& result) {
  CHECK(result.status == (bezier.overlap ? Status::infinite : Status::certified));
  if (bezier.overlap) CHECK(result.rest_status == Status::certified);
  for (const CurveSolution& solution : result.solutions) {
    CHECK(solution.certified);
    CHECK(solution.inside);
    CHECK(solution.reality == Reality::real);
  }
  for (std::size_t i = 1; i < result.solutions.size(); ++i) {
    const CurveSolution& before = result.solutions[i - 1];
    const CurveSolution& after = result.solutions[i];
    CHECK_FALSE((may_agree(before.t, after.t) && may_agree(before.u, after.u)));
  }
}

void check_planted(const BezierCase& bezier, const CurveResult& result) {
  for (const PlantedParameter& planted : bezier.planted) {
    std::vector<unsigned long> multiplicities;
    for (const CurveSolution& solution : result.solutions)
      if (is_root(*solution.t, planted)) multiplicities.push_back(solution.multiplicity);
    CHECK(multiplicities == std::vector<unsigned long>{planted.multiplicity});
  }
  CHECK(result.overlap.size() == (bezier.overlap ? 1 : 0));
  if (!bezier.overlap || result.overlap.size() != 1) return;
  const Overlap& overlap = result.overlap.front();
  CHECK(overlap.certified);
  REQUIRE(overlap.t);
  for (std::size_t k = 0; k < 2; ++k) CHECK(is_value((*overlap.t)[k], exact_rational((*bezier.overlap)[k]), -14));
}

/// The engines and what was planted.
CurveResult check_answer(const BezierCase& bezier) {
  const CurveResult automatic = solve(bezier);
  INFO("auto: ", summary(automatic));
  check_status(bezier, automatic);
  check_planted(bezier, automatic);
  if (!is_dear(bezier) || all_families() || bezier.index == 0) {
    const CurveResult exact = solve(bezier, Engine::exact);
    INFO("exact: ", summary(exact));
    check_status(bezier, exact);
    CHECK(same_results(automatic, exact));
  }
  return automatic;
}

void check_invariance(const BezierCase& bezier, const CurveResult& answer) {
  const auto same = [&](const std::string& change, const CurveResult& changed, const Turned& turned = {}) {
    INFO(change, ": ", summary(changed));
    INFO("unchanged: ", summary(answer));
    CHECK(same_results(answer, changed, turned));
  };
  same("t reversed", solve(reversed(bezier)), {true, false});
  same("second reversed", solve(second_reversed(bezier)), {false, true});
  same("scaled down", solve(bezier, Engine::automatic, {power_of_two(-20), 0}));
  same("scaled up", solve(bezier, Engine::automatic, {power_of_two(20), 0}));
  same("translated", solve(bezier, Engine::automatic, {1, power_of_two(20)}));
  if (bezier.in_plane()) same("swapped", exchanged(solve(swapped(bezier))));
}

/// Every solution is a root of the eliminant, of the same multiplicity, and at every other root within [0, 1] the curve
/// is proven to be outside the domain of the other object.
void check_elimination(const BezierCase& bezier, const CurveResult& answer, unsigned long& excluded_roots) {
  UnivariatePolynomial condition = eliminated(bezier);
  if (bezier.overlap) {
    CHECK(condition.is_zero());
    return;
  }
  if (condition.is_zero()) {
    const auto substituted = substituted_in_graph(bezier);
    REQUIRE(substituted);
    condition = *substituted;
  }
  const Context context;
  ParameterRoots roots(condition, Wanted::real, context);
  long inside = 0;
  long sturm = 0;
  for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(condition))
    sturm += sturm_count_in_unit_interval(part.factor);
  std::set<std::size_t> reported;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const int low = roots.compare(i, 0);
    const int high = roots.compare(i, 1);
    if (low > 0 && high < 0) ++inside;
    if (low < 0 || high > 0) continue;
    roots.refine(i, 2 * check_bits);
    // With one parameter on the first curve for each root several solutions may lie above it.
    unsigned long multiplicity = 0;
    for (const CurveSolution& solution : answer.solutions)
      if (acb_overlaps((*solution.t)->ball.get(), roots.ball(i).get()) != 0) multiplicity += solution.multiplicity;
    if (multiplicity > 0) {
      CHECK(multiplicity == roots.multiplicity(i));
      reported.insert(i);
    } else {
      CHECK(proven_apart(bezier, bridge::RealBall(roots.ball(i).real())));
      ++excluded_roots;
    }
  }
  CHECK(inside == sturm);
  CHECK(reported.size() <= answer.solutions.size());
  for (const CurveSolution& solution : answer.solutions) {
    const bool is_a_root = std::any_of(reported.begin(), reported.end(), [&](std::size_t i) {
      return acb_overlaps((*solution.t)->ball.get(), roots.ball(i).get()) != 0;
    });
    CHECK(is_a_root);
  }
}

/// How often what was done.
struct Tally {
  unsigned long cases = 0;
  unsigned long solutions = 0;
  unsigned long multiple = 0;
  unsigned long transformed = 0;
  unsigned long eliminated = 0;
  unsigned long excluded_roots = 0;
  std::map<std::string, unsigned long> methods;
};

Tally check_families(bool in_plane) {
  Tally tally;
  for (const BezierCase& bezier : bezier_cases(only_family())) {
    if (bezier.in_plane() != in_plane) continue;
    INFO(bezier.family, " ", bezier.index, ": ", problem_json(bezier));
    const CurveResult answer = check_answer(bezier);
    ++tally.cases;
    tally.solutions += answer.solutions.size();
    for (const CurveSolution& solution : answer.solutions)
      if (solution.multiplicity > 1) ++tally.multiple;
    ++tally.methods[answer.engine.method];
    if (is_chosen(bezier, in_plane ? 2 : 6)) {
      check_invariance(bezier, answer);
      ++tally.transformed;
    }
    if (!is_dear(bezier) && is_chosen(bezier, in_plane ? 2 : 20)) {
      check_elimination(bezier, answer, tally.excluded_roots);
      ++tally.eliminated;
    }
  }
  std::string methods;
  for (const auto& [method, count] : tally.methods) methods += ", " + std::to_string(count) + " by " + method;
  MESSAGE(tally.cases, " cases with ", tally.solutions, " solutions, ", tally.multiple, " of them multiple", methods,
          "; ", tally.transformed, " transformed, ", tally.eliminated, " against elimination, which has ",
          tally.excluded_roots, " more roots in [0, 1]");
  return tally;
}

}  // namespace

TEST_CASE("Bezier families: curves against patches") {
  const Tally tally = check_families(false);
  if (!only_family().empty()) return;
  CHECK(tally.cases >= 350);
  CHECK(tally.multiple >= 90);
}

TEST_CASE("Bezier families: plane curves") {
  const Tally tally = check_families(true);
  if (!only_family().empty()) return;
  CHECK(tally.cases >= 200);
  CHECK(tally.multiple >= 50);
}

TEST_CASE("Bezier families: a contact pushed off becomes no point or two, of order three one") {
  // Near the contact: solutions by the side to which it was pushed.
  std::map<std::pair<std::string, unsigned long>, std::array<std::size_t, 2>> counts;
  std::map<std::pair<std::string, unsigned long>, unsigned long> orders;
  for (const BezierCase& bezier : bezier_cases()) {
    // The smallest distance, and a neighbourhood that holds the branches of the cubic root.
    if (!bezier.pushed || bezier.pushed->exponent != 27) continue;
    const double reach = bezier.pushed->order == 2 ? 0x1p-10 : 0x1p-6;
    const CurveResult answer = solve(bezier);
    std::size_t near = 0;
    for (const CurveSolution& solution : answer.solutions) {
      const double t = arf_get_d(arb_midref((*solution.t)->ball.real()), ARF_RND_NEAR);
      if (std::abs(t - bezier.pushed->parameter) < reach) ++near;
    }
    const std::pair key(bezier.family, bezier.index / 6);
    counts[key][bezier.pushed->outwards ? 0 : 1] = near;
    orders[key] = bezier.pushed->order;
  }
  CHECK(counts.size() >= 25);
  for (auto& entry : counts) {
    const auto& key = entry.first;
    std::array<std::size_t, 2>& both = entry.second;
    CAPTURE(key.first);
    CAPTURE(key.second);
    std::sort(both.begin(), both.end());
    CHECK(both[0] == (orders[key] == 2 ? 0 : 1));
    CHECK(both[1] == (orders[key] == 2 ? 2 : 1));
  }
}

TEST_CASE("Bezier families: the oracle excludes no solution, and counts the roots of a known polynomial") {
  for (const std::string family : {"contact of order 2", "plane contact of order 3", "through a corner"}) {
    CAPTURE(family);
    for (const BezierCase& bezier : bezier_cases(family)) {
      const auto& line = bezier.planted.front().polynomial;
      const Rational t(symbolic::Integer(-line[0]), symbolic::Integer(line[1]));
      CHECK_FALSE(proven_apart(bezier, bridge::RealBall(t, check_bits)));
      CHECK(proven_apart(bezier, bridge::RealBall(t + power_of_two(-20), check_bits)));
    }
  }
  // t (2 t - 1) (t - 1) (4 t - 3) (t + 1) (t^2 + 1): 1/2 and 3/4 lie inside.
  UnivariatePolynomial product({symbolic::Integer(1)});
  for (const auto& factor :
       std::vector<std::vector<symbolic::Integer>>{{0, 1}, {-1, 2}, {-1, 1}, {-3, 4}, {1, 1}, {1, 0, 1}})
    product = product * UnivariatePolynomial(factor);
  CHECK(sturm_count_in_unit_interval(product) == 2);
}
