// SPDX-License-Identifier: BSD-3-Clause
//
// eliminant beside CGAL and PARI on the same curves, in one run, in process, each with one thread:
//   scripts/compare.sh [--markdown] [--limit SECONDS] [--only TEXT]
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <eliminant/version.hpp>

#include "measured_runs.hpp"
#include "solvers.hpp"
#include "systems.hpp"
#include "tables.hpp"

namespace {

using namespace eliminant::comparisons;

struct Settings {
  bool markdown = false;
  double limit_seconds = 60;
  std::string only;
};

enum Column : std::size_t { complex_ours, real_ours, real_cgal, complex_pari, real_pari, column_count };

struct Solver {
  std::string name;
  Run (*prepare)(const Curves&);
};

const std::array<Solver, column_count> solvers{{
    {"eliminant complex", eliminant_complex},
    {"eliminant real", eliminant_real},
    {"CGAL real", cgal_real},
    {"PARI complex, x only", pari_complex},
    {"PARI real, x only", pari_real},
}};

using Measurements = std::array<MeasuredRuns, column_count>;
/// A remark after the time where the answer lacks something the column promises.
std::string time_cell(const MeasuredRuns& measured, double limit_seconds) {
  if (measured.ending == Ending::failed) return "failed";
  if (measured.ending == Ending::out_of_time) return fmt::format("> {:g} s", limit_seconds);
  return three_digits(measured.milliseconds) + (measured.outcome.complete ? "" : " *");
}

std::string found_cell(const MeasuredRuns& measured) {
  return measured.ending == Ending::finished ? std::to_string(measured.outcome.found) : "-";
}

/// How many times the time of `ours` it takes `theirs`; a lower bound where that was stopped.
std::string ratio_cell(const MeasuredRuns& theirs, const MeasuredRuns& ours, double limit_seconds) {
  constexpr double milliseconds_per_second = 1000;
  if (ours.ending != Ending::finished || theirs.ending == Ending::failed) return "-";
  if (theirs.ending == Ending::out_of_time)
    return "> " + three_digits(limit_seconds * milliseconds_per_second / ours.milliseconds);
  return three_digits(theirs.milliseconds / ours.milliseconds);
}

std::vector<std::string> solver_header(std::string first) {
  std::vector<std::string> header{std::move(first)};
  for (const Solver& solver : solvers) header.push_back(solver.name);
  return header;
}

Table time_table(const std::vector<System>& systems, const std::vector<Measurements>& all, const Settings& settings) {
  Table rows{solver_header("milliseconds")};
  for (std::size_t i = 0; i < all.size(); ++i) {
    rows.push_back({systems[i].name});
    for (const MeasuredRuns& measured : all[i]) rows.back().push_back(time_cell(measured, settings.limit_seconds));
  }
  return rows;
}

Table ratio_table(const std::vector<System>& systems, const std::vector<Measurements>& all, const Settings& settings) {
  Table rows{{"", "complex found", "real found", "CGAL : eliminant, real", "PARI : eliminant, complex",
              "PARI : eliminant, real"}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Measurements& row = all[i];
    rows.push_back({systems[i].name, found_cell(row[complex_ours]), found_cell(row[real_ours]),
                    ratio_cell(row[real_cgal], row[real_ours], settings.limit_seconds),
                    ratio_cell(row[complex_pari], row[complex_ours], settings.limit_seconds),
                    ratio_cell(row[real_pari], row[real_ours], settings.limit_seconds)});
  }
  return rows;
}

/// The exponent e of time = constant * degree^e through two dense pairs, and the memory of the larger.
Table growth_table(const Measurements& small, long small_degree, const Measurements& large, long large_degree) {
  Table rows{solver_header("dense pairs")};
  rows.push_back({fmt::format("growth exponent, degree {} to {}", small_degree, large_degree)});
  rows.push_back({fmt::format("peak memory in MB, degree {}", large_degree)});
  for (std::size_t i = 0; i < column_count; ++i) {
    const bool both = small[i].ending == Ending::finished && large[i].ending == Ending::finished;
    const double exponent = std::log(large[i].milliseconds / small[i].milliseconds) /
                            std::log(static_cast<double>(large_degree) / static_cast<double>(small_degree));
    rows[1].push_back(both ? fmt::format("{:.1f}", exponent) : "-");
    rows[2].push_back(both ? fmt::format("{:.0f}", large[i].peak_megabytes) : "-");
  }
  return rows;
}

/// Two solvers that count the real solutions differently cannot both be right.
void check_counts(const std::vector<System>& systems, const std::vector<Measurements>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const MeasuredRuns& ours = all[i][real_ours];
    const MeasuredRuns& theirs = all[i][real_cgal];
    if (ours.ending == Ending::finished && theirs.ending == Ending::finished &&
        ours.outcome.found != theirs.outcome.found)
      fmt::print("{}: eliminant finds {} real solutions, CGAL {}\n", systems[i].name, ours.outcome.found,
                 theirs.outcome.found);
  }
}

void compare(const Settings& settings) {
  std::vector<System> chosen;
  for (System& system : systems())
    if (system.name.find(settings.only) != std::string::npos) chosen.push_back(std::move(system));
  if (chosen.empty()) throw std::runtime_error("no system is called " + settings.only);

  std::vector<Measurements> all;
  for (const System& system : chosen) {
    Measurements row;
    for (std::size_t i = 0; i < column_count; ++i) {
      fmt::print(stderr, "{}: {}\n", system.name, solvers[i].name);
      row[i] = measure([&] { return solvers[i].prepare(system.curves); }, settings.limit_seconds);
    }
    all.push_back(row);
  }

  fmt::print("eliminant {}, {}, {}\n\n", eliminant::version, cgal_version(), pari_version());
  print_table(time_table(chosen, all, settings), settings.markdown);
  print_table(ratio_table(chosen, all, settings), settings.markdown);
  constexpr long small_degree = 10;
  constexpr long large_degree = 30;
  std::map<long, const Measurements*> dense;
  for (std::size_t i = 0; i < all.size(); ++i) dense[chosen[i].dense_degree] = &all[i];
  if (dense.contains(small_degree) && dense.contains(large_degree))
    print_table(growth_table(*dense[small_degree], small_degree, *dense[large_degree], large_degree),
                settings.markdown);
  fmt::print("* eliminant: not certified; CGAL: a multiplicity is unknown\n");
  check_counts(chosen, all);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("eliminant, CGAL and PARI on the same plane curves", "compare_plane_curves");
  app.add_flag("--markdown", settings.markdown, "tables for docs/benchmarks.md");
  app.add_option("--limit", settings.limit_seconds, "wall-clock seconds that one run may take")
      ->check(CLI::Range(0.001, 86400.0))
      ->capture_default_str();
  app.add_option("--only", settings.only, "only the systems whose name contains this");
  CLI11_PARSE(app, argc, argv);
  try {
    compare(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare: {}\n", error.what());
    return 1;
  }
  return 0;
}
