// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

/// What the comparisons on generated families of cases have in common.
namespace eliminant::comparisons {

/// Which rows are measured, and how they are printed.
struct Selection {
  bool markdown = false;
  bool all = false;
  std::string only;
};

/// A row of a table: its name, and the families of cases in it.
struct FamilyRow {
  std::string name;
  std::vector<std::string> families;
};

/// Of the rows, or with `all` of one row for each family of the cases, those whose names contain `only`.
/// Throws std::runtime_error when there is none.
template <class Cases>
std::vector<FamilyRow> chosen_rows(std::vector<FamilyRow> rows, const Selection& selection, const Cases& all_cases) {
  if (selection.all) {
    rows.clear();
    for (const auto& one : all_cases())
      if (rows.empty() || rows.back().name != one.family) rows.push_back({one.family, {one.family}});
  }
  std::erase_if(rows, [&](const FamilyRow& row) { return row.name.find(selection.only) == std::string::npos; });
  if (rows.empty()) throw std::runtime_error("no family is called " + selection.only);
  return rows;
}

/// NaN where there are none.
inline double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times.empty() ? std::numeric_limits<double>::quiet_NaN() : times[times.size() / 2];
}

inline double largest(const std::vector<double>& times) {
  return times.empty() ? std::numeric_limits<double>::quiet_NaN() : *std::max_element(times.begin(), times.end());
}

/// "3 lost, 1 invented"; "-" where all counts are 0.
inline std::string faults(const std::vector<std::pair<std::size_t, std::string>>& counts) {
  std::string text;
  for (const auto& [count, what] : counts)
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  return text.empty() ? "-" : text;
}

/// The program: reads the selection, beside what options the caller has added, and compares. Gives the exit code.
inline int run_comparison(CLI::App& app, Selection& selection, int argc, char** argv,
                          const std::function<void()>& compare) {
  app.add_flag("--markdown", selection.markdown, "tables for docs/benchmarks.md");
  app.add_flag("--all", selection.all, "every generated family");
  app.add_option("--only", selection.only, "only the rows whose name contains this");
  CLI11_PARSE(app, argc, argv);
  try {
    compare();
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare: {}\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace eliminant::comparisons
