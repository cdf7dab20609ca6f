// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <vector>

#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/error_report.hpp>

inline const std::string parse = "parse_error";
inline const std::string invalid = "invalid_input";
inline const std::string limit = "limit";

/// A problem with a bad curve or surface and what is said of it.
struct BadGeometry {
  std::string what;
  std::string text;
  std::string kind;
  std::size_t line;
  std::size_t column;
  std::string message;   ///< a part of the message
  std::string expected;  ///< a part of what was expected
};

/// Reads every problem and compares the error it gives; none may take long.
inline void check_bad_inputs(const std::vector<BadGeometry>& rows) {
  using namespace eliminant;
  for (const BadGeometry& row : rows) {
    CAPTURE(row.what);
    const auto begin = std::chrono::steady_clock::now();
    try {
      io::read_problem(row.text, io::ProblemSyntax::json);
      FAIL_CHECK("accepted");
    } catch (const std::exception& error) {
      const io::ErrorReport report = io::report_error(error);
      CAPTURE(report.message);
      CAPTURE(report.expected);
      CHECK(report.kind == row.kind);
      CHECK(report.place.line == row.line);
      CHECK(report.place.column == row.column);
      CHECK(report.message.find(row.message) != std::string::npos);
      CHECK(report.expected.find(row.expected) != std::string::npos);
      CHECK(report.message.size() < 300);
    }
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
  }
}
