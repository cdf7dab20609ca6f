// SPDX-License-Identifier: BSD-3-Clause
//
// The engines as each other's oracle on small systems with many degeneracies. The environment says how many:
//   ELIMINANT_RANDOM_SYSTEMS   number of systems (1000)
//   ELIMINANT_RANDOM_FIRST     seed of the first system (0); system n depends on its seed n alone
// The target random_systems runs 100000.
#include <array>
#include <cstdlib>

#include <doctest/doctest.h>

#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::parse_number;

namespace {

unsigned long from_environment(const char* name, unsigned long otherwise) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? otherwise : std::strtoul(value, nullptr, 10);
}

/// Coefficients in -3..3, of total degree <= degree and >= lowest; each vanishes with the given chance out of 8.
Polynomial random_sparse(Random& random, unsigned long degree, unsigned long lowest, long vanishing) {
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j)
      if (i + j >= lowest && random.between(1, 8) > vanishing)
        terms.push_back({Rational(random.between(-3, 3)), {i, j}});
  return Polynomial::from_terms(2, terms);
}

/// A curve of degree 1 to 4: of one piece, a product of two, or a square; often without constant or linear terms.
Polynomial random_curve(Random& random) {
  for (;;) {
    const auto degree = static_cast<unsigned long>(random.between(1, 4));
    const long kind = random.between(0, 7);
    const long vanishing = random.between(0, 6);
    const auto lowest = static_cast<unsigned long>(random.between(0, 5) > 3 ? 1 + random.between(0, 1) : 0);
    Polynomial p = random_sparse(random, degree, lowest, vanishing);
    if (kind == 0 && degree >= 2) {
      const auto part = static_cast<unsigned long>(random.between(1, static_cast<long>(degree) - 1));
      p = random_sparse(random, part, 0, vanishing) * random_sparse(random, degree - part, 0, vanishing);
    } else if (kind == 1 && degree >= 2) {
      const Polynomial root = random_sparse(random, degree / 2, 0, vanishing);
      p = root * root;
    }
    if (p.total_degree() >= 1) return p;
  }
}

PlaneCurvesProblem random_system(unsigned long seed) {
  Random random(seed);
  PlaneCurvesProblem result;
  result.p = random_curve(random);
  result.q = random_curve(random);
  // Every eighth pair shares a factor or meets with contact: q + h p meets p as q does.
  const long kind = random.between(0, 15);
  if (kind == 0) {
    const Polynomial common = random_sparse(random, 1, 0, 2);
    if (common.total_degree() >= 1 && result.p.total_degree() < 4 && result.q.total_degree() < 4) {
      result.p = result.p * common;
      result.q = result.q * common;
    }
  } else if (kind == 1) {
    const Polynomial sum = result.q * result.q + random_sparse(random, 1, 0, 4) * result.p;
    if (sum.total_degree() >= 1 && sum.total_degree() <= 4) result.q = sum;
  }
  return result;
}

/// A printed solution: centre and radius.
struct PrintedBox {
  std::array<Rational, 4> centre;
  Rational radius;
};

std::vector<PrintedBox> printed_boxes(const Result& result) {
  std::vector<PrintedBox> boxes;
  for (const Solution& s : result.solutions)
    boxes.push_back(
        {{parse_number(s.x.real), parse_number(s.x.imaginary), parse_number(s.y.real), parse_number(s.y.imaginary)},
         parse_number("1e" + std::to_string(s.radius_exponent))});
  return boxes;
}

bool meet(const PrintedBox& a, const PrintedBox& b) {
  const Rational reach = a.radius + b.radius;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational difference = a.centre[i] - b.centre[i];
    if (reach < difference || reach < -difference) return false;
  }
  return true;
}

/// Every certified solution of `part` meets exactly one of `whole`, of the same multiplicity and reality, and no two
/// the same.
bool is_part_of(const Result& part, const Result& whole) {
  const std::vector<PrintedBox> part_boxes = printed_boxes(part);
  const std::vector<PrintedBox> whole_boxes = printed_boxes(whole);
  std::vector<int> times_met(whole_boxes.size());
  for (std::size_t i = 0; i < part_boxes.size(); ++i) {
    const Solution& s = part.solutions[i];
    if (!s.certified) continue;
    int matches = 0;
    for (std::size_t k = 0; k < whole_boxes.size(); ++k) {
      if (!meet(part_boxes[i], whole_boxes[k])) continue;
      ++matches;
      ++times_met[k];
      if (s.multiplicity != whole.solutions[k].multiplicity || s.reality != whole.solutions[k].reality) return false;
    }
    if (matches != 1) return false;
  }
  return std::all_of(times_met.begin(), times_met.end(), [](int times) { return times <= 1; });
}

bool all_proven(const Result& result) {
  return result.status == Status::certified ||
         (result.status == Status::infinite && result.rest_status == Status::certified);
}

/// Not proven, but it says why: a warning, or a reason beside every solution without certificate.
bool states_reason(const Result& result) {
  return !result.warnings.empty() ||
         (!result.solutions.empty() && std::all_of(result.solutions.begin(), result.solutions.end(),
                                                   [](const Solution& s) { return s.certified || !s.reason.empty(); }));
}

std::vector<unsigned long> counts(const Result& result) {
  const Counts& c = result.counts;
  return {c.distinct, c.real, c.undecided, c.with_multiplicity, c.at_infinity, c.bezout_number};
}

struct Tally {
  unsigned long counted_by_clusters = 0;
  unsigned long with_multiple_point = 0;
  unsigned long with_points_at_infinity = 0;
  unsigned long infinite = 0;
  unsigned long unproven_by_pencil = 0;
};

void check_system(unsigned long seed, Tally& tally) {
  const PlaneCurvesProblem system = random_system(seed);
  CAPTURE(seed);
  CAPTURE(text(system.p));
  CAPTURE(text(system.q));
  Options options;
  const Result automatic = solve(system, options);
  options.engine = Engine::exact;
  const Result exact = solve(system, options);
  options.engine = Engine::pencil;
  const Result pencil = solve(system, options);

  CHECK(all_proven(automatic));
  CHECK(all_proven(exact));
  CHECK(audit_holds(automatic));
  CHECK(audit_holds(exact));
  CHECK(exact.status == automatic.status);
  CHECK(exact.common_component == automatic.common_component);
  CHECK(counts(exact) == counts(automatic));
  CHECK(exact.solutions.size() == automatic.solutions.size());
  CHECK(is_part_of(exact, automatic));
  CHECK(pencil.common_component == automatic.common_component);
  CHECK(is_part_of(pencil, automatic));
  if (all_proven(pencil)) {
    CHECK(pencil.status == automatic.status);
    CHECK(audit_holds(pencil));
    CHECK(counts(pencil) == counts(automatic));
    CHECK(pencil.solutions.size() == automatic.solutions.size());
  } else {
    CHECK(states_reason(pencil));
    ++tally.unproven_by_pencil;
    MESSAGE("the pencil alone does not prove seed ", seed, ": ", text(system.p), ", ", text(system.q));
  }

  // The real solutions alone, which the exact engine isolates by another method.
  options.engine = Engine::exact;
  options.field = Field::real;
  const Result real = solve(system, options);
  CHECK(all_proven(real));
  CHECK(counts(real) == counts(automatic));
  CHECK(real.solutions.size() == automatic.counts.real);
  CHECK(is_part_of(real, automatic));

  // The clusters of the pencil, before the exact side is asked.
  PencilMultiplicities expected;
  expected.at_infinity = automatic.counts.at_infinity;
  for (const Solution& solution : automatic.solutions) {
    auto& distinct = expected.distinct_by_multiplicity;
    distinct.resize(std::max<std::size_t>(distinct.size(), solution.multiplicity), 0);
    ++distinct[solution.multiplicity - 1];
  }
  if (const auto& found = pencil.engine.pencil_multiplicities) {
    ++tally.counted_by_clusters;
    CHECK(found->distinct_by_multiplicity == expected.distinct_by_multiplicity);
    CHECK(found->at_infinity == expected.at_infinity);
  }

  if (automatic.counts.with_multiplicity > automatic.counts.distinct) ++tally.with_multiple_point;
  if (automatic.counts.at_infinity > 0) ++tally.with_points_at_infinity;
  if (automatic.status == Status::infinite) ++tally.infinite;
}

}  // namespace

TEST_CASE("Random small systems: the engines agree on status, counts, multiplicities and boxes") {
  const unsigned long count = from_environment("ELIMINANT_RANDOM_SYSTEMS", 1000);
  const unsigned long first = from_environment("ELIMINANT_RANDOM_FIRST", 0);
  const unsigned long range = 10000;
  Tally tally;
  for (unsigned long done = 0; done < count; ++done) {
    check_system(first + done, tally);
    if ((done + 1) % range == 0) MESSAGE("seeds ", first + done + 1 - range, " to ", first + done, " done");
  }
  MESSAGE(count, " systems: ", tally.with_multiple_point, " with a multiple point, ", tally.with_points_at_infinity,
          " with solutions at infinity, ", tally.infinite, " infinite, ", tally.unproven_by_pencil,
          " not proven by the pencil alone, ", tally.counted_by_clusters, " with multiplicities from its clusters");
  // Degeneracies abound.
  CHECK(4 * tally.with_multiple_point >= count);
  CHECK(4 * tally.with_points_at_infinity >= count);
  CHECK(100 * tally.infinite >= count);
  CHECK(100 * tally.counted_by_clusters >= 95 * count);
}
