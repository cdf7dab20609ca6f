// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <eliminant/io/results/text_table.hpp>

/// How the comparisons print.
namespace eliminant::comparisons {

/// The first row is the header.
using Table = std::vector<std::vector<std::string>>;

inline std::string three_digits(double value) {
  constexpr double many = 100;
  if (std::isnan(value)) return "-";
  return value >= many ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// On standard output, as text or as markdown.
inline void print_table(const Table& rows, bool markdown) {
  if (!markdown) {
    std::vector<bool> right(rows.front().size(), true);
    right.front() = false;
    fmt::print("{}\n", io::text_table(rows, right));
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    fmt::print("| {} |\n", fmt::join(rows[i], " | "));
    if (i == 0) fmt::print("| {} |\n", fmt::join(std::vector<std::string>(rows[i].size(), "---"), " | "));
  }
  fmt::print("\n");
}

}  // namespace eliminant::comparisons
