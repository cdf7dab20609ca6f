// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinders_text.hpp>

#include <utility>
#include <vector>

#include <eliminant/io/results/cylinders_words.hpp>
#include <eliminant/io/results/result_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::CylinderSolution;
using intersect::CylindersResult;
using intersect::Reality;
using intersect::Status;

std::string degeneracy_lines(const CylindersResult& result) {
  if (!result.degeneracy) return "";
  std::string text = "\nThe points are special: " + *result.degeneracy + ".\n";
  if (result.directions) text += "A cylinder has each general direction with\n  " + directions_text(result) + " = 0\n";
  return text;
}

std::string count_audit(const CylindersResult& result) {
  const intersect::CylinderCounts& counts = result.counts;
  unsigned long certified = 0;
  unsigned long listed = 0;
  for (const CylinderSolution& solution : result.solutions) {
    listed += solution.multiplicity;
    if (solution.certified) certified += solution.multiplicity;
  }
  const bool all_listed = counts.listed == counts.distinct;
  const auto number = [](unsigned long value) { return std::to_string(value); };
  std::vector<std::vector<std::string>> rows{
      {number(counts.bezout_number), "Bezout number of the conditions on the direction"},
      {"= " + number(counts.with_multiplicity), "cylinders (" + number(counts.distinct) + " different)"},
      {"+ " + number(counts.isotropic), "directions with x^2 + y^2 + z^2 = 0, which have no cylinder"}};
  if (all_listed && counts.with_multiplicity > 0)
    for (auto& row : certified_rows(counts.with_multiplicity, "cylinders", certified, listed))
      rows.push_back(std::move(row));
  std::string text = "\nCount audit, with multiplicity\n" + text_table(rows, {true, false});
  if (counts.bezout_number != counts.with_multiplicity + counts.isotropic)
    text += "  THE SUM FAILS: cylinders + isotropic directions is not the Bezout number\n";
  text += "Cylinders: " + number(counts.real) + " real, " + number(counts.distinct - counts.real) + " not real";
  return text + (all_listed ? "\n" : "; " + number(counts.listed) + " of " + number(counts.distinct) + " listed\n");
}

std::string vector_text(const std::array<intersect::Coordinate, 3>& vector, Reality reality) {
  std::string text;
  for (const intersect::Coordinate& coordinate : vector)
    text += (text.empty() ? "(" : ", ") + coordinate_text(coordinate, reality);
  return text + ")";
}

std::string block(const CylinderSolution& solution, std::size_t number) {
  std::string text = "\n  #" + std::to_string(number) + "  multiplicity " + std::to_string(solution.multiplicity) +
                     ", real " + reality_word(solution.reality) +
                     (solution.certified ? ", certified\n" : ", not certified\n");
  std::vector<std::vector<std::string>> rows{
      {"", "", "error"},
      {"direction", vector_text(solution.direction, solution.reality), radius_text(solution.direction_error_exponent)},
      {"axis point", vector_text(solution.axis_point, solution.reality),
       radius_text(solution.axis_point_error_exponent)}};
  if (solution.radius) rows.push_back({"radius", solution.radius->real, radius_text(solution.radius_error_exponent)});
  rows.push_back({"radius^2", coordinate_text(solution.radius_squared, solution.reality),
                  radius_text(solution.radius_squared_error_exponent)});
  rows.push_back({"residual", residual_text(solution), ""});
  return text + text_table(rows, {});
}

std::string emptiness_sentence(const CylindersResult& result) {
  if (result.status == Status::incomplete) return "\nNo cylinders are listed.\n";
  if (result.counts.distinct > 0)
    return "\nNone of the " + counted(result.counts.distinct, "cylinder") + " is in the part that was asked for.\n";
  return result.status == Status::infinite ? "" : "\nThere is no cylinder through these points.\n";
}

}  // namespace

std::string cylinders_text(const CylindersResult& result, const RunOptions& options) {
  std::string text = status_lines(result.status, result.rest_status, result.limit,
                                  "infinitely many cylinders pass through the points") +
                     degeneracy_lines(result);
  if (!result.limit && (result.status != Status::infinite || !result.solutions.empty())) text += count_audit(result);
  text += given_and_used(result.engine, options) + seconds_line(result.seconds);
  if (result.solutions.empty()) return text + emptiness_sentence(result);
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    text += block(result.solutions[i], i + 1);
    reasons.push_back(result.solutions[i].certified ? "" : result.solutions[i].reason);
  }
  return text + not_certified_lines(reasons);
}

}  // namespace eliminant::io
