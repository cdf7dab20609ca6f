// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>

#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// Solves until the given checkpoint; nullopt when nothing had been found there.
std::optional<Result> solve_until(long checkpoint, const PlaneCurvesProblem& input, const Options& options) {
  Context context;
  long passed = 0;
  context.on_progress([&](std::string_view) {
    if (++passed == checkpoint) context.cancel();
  });
  try {
    return intersect_plane_curves(input, options, context);
  } catch (const LimitReached&) {
    return std::nullopt;
  }
}

/// The index of the one solution of `whole` that `found` may be.
std::optional<std::size_t> the_match(const Solution& found, const Result& whole) {
  std::optional<std::size_t> match;
  for (std::size_t k = 0; k < whole.solutions.size(); ++k) {
    if (acb_overlaps(found.x.ball.get(), whole.solutions[k].x.ball.get()) == 0 ||
        acb_overlaps(found.y.ball.get(), whole.solutions[k].y.ball.get()) == 0)
      continue;
    if (match) return std::nullopt;
    match = k;
  }
  return match;
}

void check_every_limit(const PlaneCurvesProblem& input, const Options& options) {
  const Result whole = solve(input, options);
  std::size_t most = 0;
  bool with_some = false;
  for (long checkpoint = 1;; ++checkpoint) {
    CAPTURE(checkpoint);
    const std::optional<Result> part = solve_until(checkpoint, input, options);
    if (!part) continue;
    if (part->status != Status::incomplete) break;
    with_some = true;
    CHECK(part->limit.has_value());
    CHECK(part->counts.listed == part->solutions.size());
    std::vector<bool> found(whole.solutions.size(), false);
    for (const Solution& s : part->solutions) {
      CHECK_FALSE(s.certified);
      const auto match = the_match(s, whole);
      REQUIRE(match.has_value());
      CHECK_FALSE(found[*match]);
      found[*match] = true;
      CHECK(s.multiplicity == whole.solutions[*match].multiplicity);
      CHECK((s.reality == Reality::undecided || s.reality == whole.solutions[*match].reality));
    }
    most = std::max(most, part->solutions.size());
  }
  CHECK(with_some);
  CHECK(most <= whole.solutions.size());
}

}  // namespace

TEST_CASE("A limit at any moment: what was found so far, each solution once, nothing certified") {
  for (const auto& [p, q] :
       {std::pair{"x^3 + y^3 - 3*x*y + 1/7", "x^2*y - y^2 + 2*x - 1"},
        std::pair{"(x - y)^2*(x + 2) + y^5", "y^2 - x^3"}, std::pair{"(x^2 + y^2)^3 - 4*x^2*y^2", "x^2 + y^2 - 1"}})
    for (const Engine engine : {Engine::automatic, Engine::exact, Engine::pencil}) {
      CAPTURE(p);
      CAPTURE(static_cast<int>(engine));
      Options options;
      options.engine = engine;
      options.digits = 40;
      check_every_limit(problem(p, q), options);
    }
  PlaneCurvesProblem boxed = problem("(x^2 + y^2)^3 - 4*x^2*y^2", "x^2 + y^2 - 1");
  boxed.box = Box{{Rational(0), Rational(1)}, {Rational(-1), Rational(1)}};
  check_every_limit(boxed, {});
}
