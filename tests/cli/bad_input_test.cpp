// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <chrono>
#include <cli/bad_input_table.hpp>
#include <eliminant/io/input/problem_file.hpp>
#include <eliminant/io/results/error_report.hpp>

using namespace eliminant;

TEST_CASE("bad input: kind, place, message and expectation of every row, at once") {
  const std::vector<bad_input::Row> rows = bad_input::rows();
  CHECK(rows.size() >= 50);
  for (const bad_input::Row& row : rows) {
    CAPTURE(row.what);
    const auto begin = std::chrono::steady_clock::now();
    try {
      io::read_problem(row.text, io::problem_syntax("problem." + row.extension, row.text));
      FAIL_CHECK("accepted");
    } catch (const std::exception& error) {
      const io::ErrorReport report = io::report_error(error);
      CAPTURE(report.message);
      CAPTURE(report.expected);
      CHECK(report.kind == row.kind);
      CHECK(report.exit_status == (row.kind == "limit" ? 3 : 2));
      CHECK(report.place.line == row.line);
      CHECK(report.place.column == row.column);
      CHECK(report.message.find(row.message) != std::string::npos);
      CHECK(report.expected.find(row.expected) != std::string::npos);
      CHECK(report.message.size() < 300);
    }
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
  }
}
