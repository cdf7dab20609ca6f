// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/result_text.hpp>

#include <eliminant/io/results/result_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::Result;
using intersect::Solution;
using intersect::Status;

std::string component_sentence(const Result& result) {
  if (!result.common_component) return {};
  const symbolic::Polynomial& component = *result.common_component;
  if (component.is_zero()) return "\nBoth polynomials are zero: every point of the plane is a solution.\n";
  return "\nEvery point of the common component is a solution:\n  " + symbolic::to_string(component, result.variables) +
         " = 0\n";
}

std::string count_audit(const Result& result) {
  const intersect::Counts& counts = result.counts;
  unsigned long certified = 0;
  unsigned long listed = 0;
  for (const Solution& solution : result.solutions) {
    listed += solution.multiplicity;
    if (solution.certified) certified += solution.multiplicity;
  }
  const bool all_listed = counts.listed == counts.distinct;
  const auto number = [](unsigned long value) { return std::to_string(value); };
  std::vector<std::vector<std::string>> rows{
      {number(counts.bezout_number), "Bezout number, the product of the degrees"},
      {"= " + number(counts.with_multiplicity), "finite (" + counted(counts.distinct, "point") + ")"},
      {"+ " + number(counts.at_infinity), "at infinity"}};
  if (all_listed && counts.with_multiplicity > 0)
    for (auto& row : certified_rows(counts.with_multiplicity, "finite", certified, listed))
      rows.push_back(std::move(row));
  std::string text =
      result.common_component ? "\nCount audit of the rest, with multiplicity\n" : "\nCount audit, with multiplicity\n";
  text += text_table(rows, {true, false});
  if (counts.bezout_number != counts.with_multiplicity + counts.at_infinity)
    text += "  THE SUM FAILS: finite + at infinity is not the Bezout number\n";
  if (all_listed && listed != counts.with_multiplicity)
    text += "  THE SUM FAILS: the multiplicities listed add up to " + number(listed) + "\n";
  text += "Points: " + realities(counts.distinct, counts.real, counts.undecided);
  return text + (all_listed ? "\n" : "; " + number(counts.listed) + " of " + number(counts.distinct) + " listed\n");
}

std::string solution_blocks(const Result& result) {
  std::string text;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const Solution& solution = result.solutions[i];
    text += "\n  #" + std::to_string(i + 1) + "  multiplicity " + std::to_string(solution.multiplicity) + ", real " +
            reality_word(solution.reality) + ", radius " + radius_text(solution.radius_exponent) +
            (solution.certified ? ", certified\n" : ", not certified\n");
    text += "    " + result.variables[0] + " = " + coordinate_text(solution.x, solution.reality) + "\n";
    text += "    " + result.variables[1] + " = " + coordinate_text(solution.y, solution.reality) + "\n";
  }
  return text;
}

std::string solution_table(const Result& result) {
  std::vector<std::string> xs;
  std::vector<std::string> ys;
  for (const Solution& solution : result.solutions) {
    xs.push_back(coordinate_text(solution.x, solution.reality));
    ys.push_back(coordinate_text(solution.y, solution.reality));
  }
  xs = number_column(result.variables[0], std::move(xs));
  ys = number_column(result.variables[1], std::move(ys));
  std::vector<std::vector<std::string>> rows{{"#", xs[0], ys[0], "multiplicity", "real", "radius", "certified"}};
  for (const Solution& solution : result.solutions) {
    const std::size_t row = rows.size();
    rows.push_back({std::to_string(row), xs[row], ys[row], std::to_string(solution.multiplicity),
                    reality_word(solution.reality), radius_text(solution.radius_exponent),
                    solution.certified ? "yes" : "no"});
  }
  if (table_width(rows) > widest_table) return solution_blocks(result);
  return "\n" + text_table(rows, {true, false, false, true, false, false, false});
}

std::string reasons(const Result& result) {
  std::vector<std::string> of_each;
  for (const Solution& solution : result.solutions) of_each.push_back(solution.certified ? "" : solution.reason);
  return not_certified_lines(of_each);
}

std::string emptiness_sentence(const Result& result) {
  const intersect::Counts& counts = result.counts;
  if (result.status == Status::incomplete) return "\nNo solutions are listed.\n";
  if (counts.distinct > 0)
    return "\nNone of the " + counted(counts.distinct, "point") + " is in the part that was asked for.\n";
  if (result.common_component) return "\nThere are no other solutions.\n";
  return "\nThe curves have no common point in the affine plane" +
         std::string(counts.at_infinity > 0 ? ": all intersections lie at infinity.\n" : ".\n");
}

}  // namespace

std::string result_text(const Result& result, const RunOptions& given, bool with_seconds) {
  const bool whole_plane = result.common_component && result.common_component->is_zero();
  std::string text =
      status_lines(result.status, result.rest_status, result.limit, "the curves have a common component") +
      component_sentence(result);
  if (result.limit)
    text += "\nFound so far: " + counted(result.counts.listed, "point") + "; the rest is not known.\n";
  else if (!whole_plane)
    text += count_audit(result);
  text += given_and_used(result.engine, given);
  if (with_seconds) text += seconds_line(result.seconds);
  if (result.solutions.empty()) return text + (whole_plane ? "" : emptiness_sentence(result));
  return text + solution_table(result) + reasons(result);
}

}  // namespace eliminant::io
