// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <support/patch_families.hpp>
#include <support/patch_fibres.hpp>
#include <support/patch_nets.hpp>
#include <support/patch_oracle.hpp>
#include <support/self_patch_families.hpp>
#include <support/space_distances.hpp>

// The generated patches. Of every family the first few by default; with ELIMINANT_ALL_FAMILIES in the environment all
// of them with every check, with ELIMINANT_FAMILY=NAME those of one family.

using namespace eliminant;
using intersect::BranchEnd;
using intersect::BranchEndKind;
using intersect::Status;
using intersect::SurfaceComponent;
using intersect::SurfaceComponentKind;
using intersect::SurfacePoint;
using intersect::SurfaceResult;
using symbolic::Rational;
using test::ControlNet;
using test::distance;
using test::distance_to_patch;
using test::distance_to_segment;
using test::PatchCase;
using test::PatchCounts;
using test::PowerPatch;
using test::size_of;
using test::TrueComponent;
using test::TrueIntersection;

namespace {

bool all_families() {
  return std::getenv("ELIMINANT_ALL_FAMILIES") != nullptr;  // NOLINT(concurrency-mt-unsafe)
}

std::string only_family() {
  const char* const name = std::getenv("ELIMINANT_FAMILY");  // NOLINT(concurrency-mt-unsafe)
  return name == nullptr ? "" : name;
}

bool is_chosen(unsigned long index, unsigned long first) { return all_families() || index < first; }

SurfaceResult solve(const PatchCase& patches) {
  if (patches.second.empty())
    return intersect::intersect_patch_with_itself(test::surface_piece(patches.first), {}, Context());
  return intersect::intersect_patches(test::surface_piece(patches.first), test::surface_piece(patches.second), {},
                                      Context());
}

/// Of the components themselves.
PatchCounts counts_of(const SurfaceResult& result) {
  PatchCounts counts;
  for (const SurfaceComponent& component : result.components) {
    if (component.kind == SurfaceComponentKind::curve) ++counts.curves;
    if (component.kind == SurfaceComponentKind::loop) ++counts.loops;
    if (component.kind == SurfaceComponentKind::point) ++counts.points;
  }
  counts.singular = result.singular_points.size();
  return counts;
}

std::string summary(const SurfaceResult& result) {
  std::string text = result.engine.method + " status " + std::to_string(static_cast<int>(result.status));
  for (const SurfaceComponent& component : result.components)
    if (!component.certified) text += "; not certified: " + component.reason;
  for (const auto& point : result.singular_points)
    if (!point.certified) text += "; singular point not certified: " + point.reason;
  for (const std::string& warning : result.warnings) text += "; " + warning;
  return text;
}

// The checks.

bool lies_on_side(const BranchEnd& end, const SurfacePoint& point) {
  bool somewhere = false;
  for (std::size_t k = 0; k < 4; ++k) {
    if (end.side[k] == 0) continue;
    somewhere = true;
    if (std::isnan(point.parameters[k])) continue;
    if (std::abs(point.parameters[k] - (end.side[k] < 0 ? 0 : 1)) > 1e-9) return false;
  }
  return somewhere;
}

void check_ends(const SurfaceComponent& component, std::size_t singular_count) {
  if (component.kind == SurfaceComponentKind::loop) {
    CHECK(component.points.size() >= 4);
    CHECK(component.points.front().point == component.points.back().point);
  }
  if (component.kind != SurfaceComponentKind::curve) return;
  CHECK(component.points.size() >= 2);
  const auto check = [&](const BranchEnd& end, const SurfacePoint& point) {
    CHECK((end.kind == BranchEndKind::border || end.kind == BranchEndKind::singular));
    if (end.kind == BranchEndKind::border) CHECK(lies_on_side(end, point));
    if (end.kind == BranchEndKind::singular) CHECK(end.singular_point.value_or(singular_count) < singular_count);
  };
  check(component.start, component.points.front());
  check(component.end, component.points.back());
}

/// All points of the polylines are on both patches, and so are the middles of their segments, up to the error.
void check_on_patches(const SurfaceResult& result, const ControlNet& first, const ControlNet& second) {
  const double size = std::max(size_of(first), size_of(second));
  const double rounding = 1e-14 * size;
  const std::array<PowerPatch, 2> patches{PowerPatch(first), PowerPatch(second)};
  double worst = 0;
  bool inside = true;
  for (const SurfaceComponent& component : result.components) {
    // Next to a singular point doubles tell both patches apart less well, and `error` says so.
    const bool singular =
        component.start.kind == BranchEndKind::singular || component.end.kind == BranchEndKind::singular;
    CHECK(component.error <= (singular ? 1e-5 : 1.000001e-9) * 2 * size);
    for (std::size_t k = 0; k < component.points.size(); ++k) {
      const SurfacePoint& here = component.points[k];
      for (std::size_t side = 0; side < 2; ++side) {
        const double u = here.parameters[2 * side];
        const double v = here.parameters[2 * side + 1];
        worst = std::max(worst, distance_to_patch(here.point, patches[side], u, v) - component.error);
        inside = inside && u >= 0 && u <= 1 && v >= 0 && v <= 1;
        if (k == 0) continue;
        std::array<double, 3> middle;
        for (std::size_t i = 0; i < 3; ++i) middle[i] = (here.point[i] + component.points[k - 1].point[i]) / 2;
        worst = std::max(worst, distance_to_patch(middle, patches[side], u, v) - component.error);
      }
    }
  }
  CHECK(worst <= rounding);
  CHECK(inside);
}

/// Every point of the true components is near a polyline: their distance is the error and what the chords of the
/// polyline, and those of rounded parameters, may take.
void check_nothing_missing(const SurfaceResult& result, const ControlNet& first,
                           const std::vector<TrueComponent>& truth) {
  const double size = size_of(first);
  for (const TrueComponent& component : truth) {
    double worst = 0;
    for (const auto& [u, v] : component.parameters) {
      const auto p = test::patch_point(first, u, v);
      double nearest = std::numeric_limits<double>::infinity();
      for (const SurfaceComponent& found : result.components) {
        if (found.points.size() == 1) nearest = std::min(nearest, distance(p, found.points[0].point) - found.error);
        for (std::size_t k = 1; k < found.points.size(); ++k)
          nearest =
              std::min(nearest, distance_to_segment(p, found.points[k - 1].point, found.points[k].point) - found.error);
      }
      worst = std::max(worst, nearest);
    }
    CHECK(worst <= 1e-11 * size);
  }
}

/// What a result leaves open, in words.
bool says_why(const SurfaceResult& result) {
  const auto open = [](const auto& part) { return !part.certified && !part.reason.empty(); };
  return result.limit || !result.warnings.empty() ||
         std::any_of(result.components.begin(), result.components.end(), open) ||
         std::any_of(result.singular_points.begin(), result.singular_points.end(), open);
}

/// What must hold of a proven result. `truth` is in the parameters of the first patch.
void check_proven(const SurfaceResult& result, const PatchCase& patches, const PatchCounts& expected,
                  const std::vector<TrueComponent>& truth) {
  CHECK(counts_of(result) == expected);
  CHECK(result.counts.curves == expected.curves);
  CHECK(result.counts.loops == expected.loops);
  CHECK(result.counts.points == expected.points);
  CHECK(result.counts.singular == expected.singular);
  CHECK(result.counts.overlaps == 0);
  for (const SurfaceComponent& component : result.components) {
    CHECK(component.certified);
    check_ends(component, result.singular_points.size());
  }
  check_on_patches(result, patches.first, patches.second.empty() ? patches.first : patches.second);
  check_nothing_missing(result, patches.first, truth);
}

/// True where it is proven. Nothing is left open in silence.
bool is_proven(const SurfaceResult& result) {
  if (result.status == Status::certified) return true;
  CHECK(result.status == Status::numeric);
  CHECK(says_why(result));
  CHECK_MESSAGE(false, "not proven");
  return false;
}

void check_invariance(const PatchCase& patches, const SurfaceResult& answer) {
  const auto same = [&](const std::string& change, const PatchCase& changed) {
    const SurfaceResult result = solve(changed);
    INFO(change, ": ", summary(result));
    if (is_proven(result)) CHECK(counts_of(result) == counts_of(answer));
  };
  const auto changed = [&](const auto& first, const auto& second) {
    PatchCase result = patches;
    result.first = first(patches.first);
    if (!patches.second.empty()) result.second = second(patches.second);
    return result;
  };
  const auto unchanged = [](const ControlNet& net) { return net; };
  if (!patches.second.empty()) {
    same("surfaces exchanged", test::exchanged(patches));
    same("s and t exchanged", changed(unchanged, test::parameters_exchanged));
  }
  same("u and v exchanged", changed(test::parameters_exchanged, unchanged));
  same("u reversed", changed(test::parameter_reversed, unchanged));
  for (const int exponent : {-20, 20}) {
    const auto scale = [&](const ControlNet& net) { return test::scaled(net, exponent); };
    same("scaled by 2^" + std::to_string(exponent), changed(scale, scale));
  }
  const auto move = [](const ControlNet& net) { return test::moved(net, 8); };
  std::optional<PatchCase> there;
  try {
    there = changed(move, move);
  } catch (const std::logic_error&) {
    return;  // The coordinates have no room for it.
  }
  same("moved", *there);
}

/// Polylines against elimination above so many values of u; how many of these said something.
std::size_t check_fibres(const PatchCase& patches, const SurfaceResult& answer, long values) {
  std::vector<std::vector<std::array<double, 4>>> polylines;
  for (const SurfaceComponent& component : answer.components) {
    auto& polyline = polylines.emplace_back();
    for (const SurfacePoint& point : component.points) polyline.push_back(point.parameters);
  }
  const test::PatchFibres fibres(patches);
  std::size_t compared = 0;
  for (long k = 1; k <= values; ++k) {
    const Rational u = Rational(k) / Rational(values + 1);
    const auto fibre = fibres.at(u);
    if (!fibre) continue;
    CAPTURE(k);
    CHECK(test::agrees_with_fibre(polylines, static_cast<double>(k) / static_cast<double>(values + 1), *fibre, 1e-3));
    ++compared;
  }
  return compared;
}

/// How many cases of a family are proven.
struct Tally {
  std::size_t cases = 0;
  std::size_t proven = 0;
  std::map<std::string, std::array<std::size_t, 2>> open;

  void add(const std::string& family, bool is_proven) {
    ++cases;
    if (is_proven) ++proven;
    ++open[family][0];
    if (!is_proven) ++open[family][1];
  }
  std::string text() const {
    std::string result = std::to_string(proven) + " of " + std::to_string(cases) + " proven";
    for (const auto& [family, count] : open)
      if (count[1] > 0)
        result += "; " + family + ": " + std::to_string(count[1]) + " of " + std::to_string(count[0]) + " open";
    return result;
  }
};

}  // namespace

TEST_CASE("Patch families: numbers, proofs and places of all components") {
  Tally tally;
  std::size_t fibres = 0;
  for (const PatchCase& patches : test::patch_cases(only_family())) {
    if (!is_chosen(patches.index, 2)) continue;
    INFO(patches.family, " ", patches.index, ": ", test::problem_json(patches));
    const SurfaceResult answer = solve(patches);
    INFO(summary(answer));
    const bool proven = is_proven(answer);
    tally.add(patches.family, proven);
    if (!proven) continue;
    const TrueIntersection truth = test::true_intersection(patches);
    // Components that were sampled are only where the samples are.
    const bool exact = test::substituted_in_graph(patches).has_value();
    check_proven(answer, patches, truth.counts, exact ? truth.components : std::vector<TrueComponent>{});
    // Waves of degree 5 take longest.
    const bool dear = patches.family == "branches and loops, degree 5";
    if (!is_chosen(patches.index, dear ? 0 : 1)) continue;
    check_invariance(patches, answer);
    if (patches.family.starts_with("random")) fibres += check_fibres(patches, answer, all_families() ? 200 : 40);
  }
  MESSAGE(tally.text(), "; ", fibres, " fibres by elimination");
  if (!only_family().empty()) return;
  CHECK(tally.cases >= (all_families() ? 300 : 50));
  CHECK(fibres >= (all_families() ? 15000 : 100));
}

TEST_CASE("Patch families: double curves of one patch, and embedded patches") {
  Tally tally;
  for (const test::SelfPatchCase& patch : test::self_patch_cases(only_family())) {
    const PatchCase& patches = patch.patches;
    if (!is_chosen(patches.index, 1)) continue;
    INFO(patches.family, " ", patches.index, ": ", test::problem_json(patches));
    const SurfaceResult result = solve(patches);
    INFO(summary(result));
    const bool proven = is_proven(result);
    tally.add(patches.family, proven);
    if (!proven) continue;
    TrueIntersection truth = test::true_self_intersection(patch);
    for (TrueComponent& component : truth.components)
      for (auto& place : component.parameters) {
        const auto both = patch.sheets->parameters(place);
        place = {both[0], both[1]};
      }
    // Arcs may be cut where three of them meet.
    if (counts_of(result).curves != truth.counts.curves) truth.counts.curves += 3 * patch.triple_points;
    check_proven(result, patches, truth.counts, truth.components);
    check_invariance(patches, result);
  }
  MESSAGE(tally.text());
  if (only_family().empty()) CHECK(tally.cases >= (all_families() ? 40 : 8));
}
