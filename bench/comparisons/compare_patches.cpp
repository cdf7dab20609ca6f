// SPDX-License-Identifier: BSD-3-Clause
//
// eliminant beside OCCT and SISL on the same pairs of Bezier patches, in one run, each run in a process of its own:
//   scripts/compare.sh patches [--markdown] [--only TEXT] [--all] [--limit SECONDS] [--cases N]
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <eliminant/version.hpp>
#include <support/patch_families.hpp>
#include <support/patch_nets.hpp>
#include <support/patch_oracle.hpp>
#include <support/space_distances.hpp>

#include "bezier_solvers.hpp"
#include "family_comparison.hpp"
#include "measured_patches.hpp"
#include "tables.hpp"

namespace {

using namespace eliminant::comparisons;
using eliminant::test::distance;
using eliminant::test::distance_to_segment;
using eliminant::test::PatchCase;
using eliminant::test::TrueComponent;

struct Settings {
  Selection selection;
  double limit_seconds = 10;
  unsigned long cases = std::numeric_limits<unsigned long>::max();
};

const std::vector<FamilyRow> rows_of_table{
    {"random bicubic pairs", {"random bicubic"}},
    {"random biquadratic pairs", {"random biquadratic"}},
    {"up to 10 branches and 8 loops", {"branches and loops, degree 3", "branches and loops, degree 5"}},
    {"one loop of diameter 1e-1 to 1e-4",
     {"loop of diameter 1e-1", "loop of diameter 1e-2", "loop of diameter 1e-3", "loop of diameter 1e-4"}},
    {"disjoint, gap 1e-1 to 1e-5", {"gap of 1e-1", "gap of 1e-2", "gap of 1e-3", "gap of 1e-4", "gap of 1e-5"}},
    {"contact in a point", {"contact in a point", "crossing contact"}},
    {"contact along a curve", {"contact along a curve"}},
};

struct Solver {
  std::string name;
  PatchRun (*prepare)(const PatchCase&);
};

const std::array<Solver, 3> solvers{{{"eliminant", eliminant_patches}, {"OCCT", occt_patches}, {"SISL", sisl_patches}}};

/// One solver on one family.
struct Summary {
  std::vector<double> milliseconds;  ///< of each case that ended
  std::size_t lost = 0;              ///< components
  std::size_t damaged = 0;           ///< cases of these
  std::size_t invented = 0;          ///< polylines away from all components
  std::size_t hung = 0;              ///< cases, as are those below
  std::size_t crashed = 0;
  std::size_t incomplete = 0;
};

// What was found against what is there.

bool is_near(const std::array<double, 3>& p, const std::vector<SpacePolyline>& polylines, double reach) {
  for (const SpacePolyline& polyline : polylines) {
    if (polyline.size() == 1 && distance(p, polyline[0]) < reach) return true;
    for (std::size_t k = 1; k < polyline.size(); ++k)
      if (distance_to_segment(p, polyline[k - 1], polyline[k]) < reach) return true;
  }
  return false;
}

/// Which part of up to so many points of a polyline is near to others.
double near_part(const SpacePolyline& polyline, const std::vector<SpacePolyline>& others, double reach) {
  constexpr std::size_t most = 60;
  const std::size_t step = polyline.size() / most + 1;
  std::size_t near = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < polyline.size(); k += step, ++count)
    if (is_near(polyline[k], others, reach)) ++near;
  return count == 0 ? 0 : static_cast<double>(near) / static_cast<double>(count);
}

double extent(const SpacePolyline& polyline) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(polyline.begin(), polyline.end(),
                                                 [&](const auto& a, const auto& b) { return a[k] < b[k]; });
    largest = std::max(largest, (*high)[k] - (*low)[k]);
  }
  return largest;
}

/// All distances below are of patches of size about 1. A tangential intersection is known to the root of a tolerance.
constexpr double widest_reach = 2e-3;

std::vector<SpacePolyline> components_of(const PatchCase& patches) {
  std::vector<SpacePolyline> result;
  for (const TrueComponent& component : eliminant::test::true_intersection(patches).components) {
    SpacePolyline& polyline = result.emplace_back();
    const auto& places = component.parameters;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      // A straight line of parameters has two places, and is a curve in space.
      constexpr std::size_t parts = 16;
      for (std::size_t k = 0; k < parts; ++k) {
        const double share = static_cast<double>(k) / parts;
        polyline.push_back(eliminant::test::patch_point(patches.first, std::lerp(places[i][0], places[i + 1][0], share),
                                                        std::lerp(places[i][1], places[i + 1][1], share)));
      }
    }
    polyline.push_back(eliminant::test::patch_point(patches.first, places.back()[0], places.back()[1]));
  }
  return result;
}

void count_differences(const std::vector<SpacePolyline>& truth, const FoundPolylines& found, Summary& summary) {
  constexpr double most_of_it = 0.9;
  constexpr double finest_reach = 2e-6;
  const std::size_t before = summary.lost;
  for (const SpacePolyline& component : truth) {
    const double part_of_extent = 0.02 * extent(component);
    const double reach = component.size() == 1 ? widest_reach : std::clamp(part_of_extent, finest_reach, widest_reach);
    if (near_part(component, found.polylines, reach) < most_of_it) ++summary.lost;
  }
  if (summary.lost > before) ++summary.damaged;
  for (const SpacePolyline& polyline : found.polylines)
    if (near_part(polyline, truth, widest_reach) < 1 - most_of_it) ++summary.invented;
}

using Measurements = std::array<Summary, solvers.size()>;

struct Measured {
  Measurements by_solver;
  std::size_t cases = 0;
  std::size_t components = 0;
};

Measured measure(const FamilyRow& row, const Settings& settings) {
  Measured result;
  for (const std::string& family : row.families)
    for (const PatchCase& patches : eliminant::test::patch_cases(family)) {
      if (patches.index >= settings.cases) break;
      const std::vector<SpacePolyline> truth = components_of(patches);
      ++result.cases;
      result.components += truth.size();
      for (std::size_t i = 0; i < solvers.size(); ++i) {
        Summary& summary = result.by_solver[i];
        const MeasuredPatches measured = measure_patches(solvers[i].prepare, patches, settings.limit_seconds);
        if (measured.ending == Ending::finished) {
          summary.milliseconds.push_back(measured.milliseconds);
          if (!measured.found.complete) ++summary.incomplete;
        } else {
          ++(measured.ending == Ending::out_of_time ? summary.hung : summary.crashed);
          fmt::print(stderr, "{}: {} {} has no answer\n", solvers[i].name, patches.family, patches.index);
        }
        count_differences(truth, measured.found, summary);
      }
    }
  return result;
}

std::string faults_of(const Summary& summary) {
  return faults({{summary.lost, fmt::format("lost in {}", summary.damaged)},
                 {summary.invented, "invented"},
                 {summary.hung, "hung"},
                 {summary.crashed, "failed"},
                 {summary.incomplete, "not complete"}});
}

void compare(const Settings& settings) {
  Table times{{"milliseconds, median (largest)", "pairs", "components"}};
  Table differences{{"components against the true ones", "components"}};
  for (const Solver& solver : solvers) {
    times[0].push_back(solver.name);
    differences[0].push_back(solver.name);
  }
  times[0].insert(times[0].end(), {"OCCT : eliminant", "SISL : eliminant"});
  for (const FamilyRow& row :
       chosen_rows(rows_of_table, settings.selection, [] { return eliminant::test::patch_cases(); })) {
    fmt::print(stderr, "{}\n", row.name);
    const Measured measured = measure(row, settings);
    times.push_back({row.name, std::to_string(measured.cases), std::to_string(measured.components)});
    differences.push_back({row.name, std::to_string(measured.components)});
    for (const Summary& summary : measured.by_solver) {
      times.back().push_back(fmt::format("{} ({})", three_digits(median(summary.milliseconds)),
                                         three_digits(largest(summary.milliseconds))));
      differences.back().push_back(faults_of(summary));
    }
    for (std::size_t i = 1; i < solvers.size(); ++i)
      times.back().push_back(
          three_digits(median(measured.by_solver[i].milliseconds) / median(measured.by_solver[0].milliseconds)));
  }
  fmt::print("eliminant {}, {}, {}\n\n", eliminant::version, occt_version(), sisl_version());
  print_table(times, settings.selection.markdown);
  print_table(differences, settings.selection.markdown);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("eliminant, OCCT and SISL on the same pairs of Bezier patches", "compare_patches");
  app.add_option("--limit", settings.limit_seconds, "seconds of wall-clock time for one pair (10)");
  app.add_option("--cases", settings.cases, "only the first pairs of each family");
  return run_comparison(app, settings.selection, argc, argv, [&] { compare(settings); });
}
