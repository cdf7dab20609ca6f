// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/double_points.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <eliminant/bridge/enclosures/decimal.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;

/// Whether the values of two parameters may be equal, or conjugate.
bool may_be(const Parameter& a, const Parameter& b, bool conjugate) {
  if (!a || !b) return !a && !b;
  if (!conjugate) return acb_overlaps(a->ball.get(), b->ball.get()) != 0;
  ComplexBall mirrored;
  acb_conj(mirrored.get(), b->ball.get());
  return acb_overlaps(a->ball.get(), mirrored.get()) != 0;
}

/// For each solution (t, u) the one that is (u, t), or (conj t, conj u): there is one, because the list is complete,
/// so that it is known where the balls leave one only. nullopt where they do not.
std::optional<std::vector<std::size_t>> images(const std::vector<CurveSolution>& solutions, bool conjugate) {
  std::vector<std::size_t> result;
  for (const CurveSolution& solution : solutions) {
    const Parameter& first = conjugate ? *solution.t : *solution.u;
    const Parameter& second = conjugate ? *solution.u : *solution.t;
    std::optional<std::size_t> image;
    for (std::size_t j = 0; j < solutions.size(); ++j) {
      if (!may_be(*solutions[j].t, first, conjugate) || !may_be(*solutions[j].u, second, conjugate)) continue;
      if (image) return std::nullopt;
      image = j;
    }
    if (!image) return std::nullopt;
    result.push_back(*image);
  }
  return result;
}

Coordinate conjugate_of(Coordinate value) {
  acb_conj(value.ball.get(), value.ball.get());
  if (value.imaginary.starts_with('-'))
    value.imaginary.erase(0, 1);
  else if (value.imaginary != "0")
    value.imaginary.insert(0, "-");
  return value;
}

/// u is the conjugate of t, and the point is real.
void make_isolated(CurveSolution& solution) {
  solution.kind = PairKind::isolated;
  solution.reality = Reality::real;
  if (*solution.t) solution.u = conjugate_of(**solution.t);
  for (Coordinate& coordinate : solution.point) {
    arb_zero(coordinate.ball.imaginary());
    coordinate.imaginary = "0";
  }
}

/// One of the two orders of each pair, with the counts of the pairs; nullopt where more digits are needed.
std::optional<MapPairResult> unordered(MapPairResult ordered) {
  const auto swapped = images(ordered.solutions, false);
  const auto mirrored = images(ordered.solutions, true);
  if (!swapped || !mirrored) return std::nullopt;
  MapPairResult result = std::move(ordered);
  const std::vector<CurveSolution> all = std::exchange(result.solutions, {});
  const unsigned long expected = result.counts.expected / 2;
  result.counts = {};
  result.counts.expected = expected;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((*swapped)[i] < i) continue;
    CurveSolution solution = all[i];
    if ((*swapped)[i] == i) {
      solution.kind = PairKind::cusp;
      solution.u = solution.t;
      // Twice the delta invariant; an upper bound of that may be odd.
      solution.multiplicity = (solution.multiplicity + 1) / 2;
    } else if (solution.reality == Reality::real) {
      solution.kind = PairKind::crossing;
    } else if ((*mirrored)[i] == (*swapped)[i]) {
      make_isolated(solution);
    } else if (solution.reality == Reality::non_real) {
      solution.kind = PairKind::complex;
    }
    ++result.counts.distinct;
    if (solution.reality == Reality::real) ++result.counts.real;
    if (solution.reality == Reality::undecided) ++result.counts.undecided;
    result.counts.with_multiplicity += solution.multiplicity;
    result.solutions.push_back(std::move(solution));
  }
  return result;
}

}  // namespace

MapPairResult double_points(const symbolic::CurvePiece& piece, const Options& options, const Context& context) {
  Options more = options;
  more.field = Field::complex;
  constexpr int most_doublings = 6;
  for (int doubling = 0;; ++doubling) {
    MapPairResult ordered = intersect_map_with_itself(piece, more, context);
    ordered.touches.clear();
    if (auto result = unordered(ordered)) return *std::move(result);
    if (doubling < most_doublings && ordered.status == Status::certified) {
      more.digits *= 2;
      continue;
    }
    // Solutions are missing or not proven: each order stands for itself.
    std::erase_if(ordered.solutions, [](const CurveSolution& s) {
      return *s.t && *s.u && s.reality == Reality::real && arb_gt((*s.t)->ball.real(), (*s.u)->ball.real()) != 0;
    });
    ordered.status = Status::numeric;
    ordered.warnings.emplace_back("not every pair of parameters of one point could be told from its reverse");
    return ordered;
  }
}

}  // namespace eliminant::intersect
