// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/curve_result_text.hpp>

#include <algorithm>

#include <eliminant/io/input/curve_shape.hpp>
#include <eliminant/io/results/result_words.hpp>
#include <eliminant/io/results/text_sections.hpp>
#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::CurveResult;
using intersect::CurveSolution;
using intersect::PairKind;
using intersect::Parameter;
using intersect::Reality;
using intersect::Status;

std::string parameter_text(const Parameter& parameter, Reality reality) {
  return parameter ? coordinate_text(*parameter, reality) : "inf";
}

// "0 <= t <= 1"; an infinite end is left out.
std::string interval_text(const std::string& name, const std::optional<intersect::ParameterInterval>& interval) {
  if (!interval) return "all " + name;
  const auto& [lower, upper] = *interval;
  if (!lower && !upper) return name + " = inf";
  if (!lower) return name + " <= " + upper->real;
  if (!upper) return name + " >= " + lower->real;
  return lower->real + " <= " + name + " <= " + upper->real;
}

std::string overlap_sentences(const CurveResult& result, const CurveShape& shape) {
  std::string subject = shape.surface ? "The curve lies in the surface" : "The curves coincide";
  if (shape.itself) {
    if (!shape.t)
      return result.overlap.empty() ? "" : "\nA factor of the equation is repeated: all its points are singular.\n";
    subject = result.covering > 1 ? "The map takes a general point of the curve " + std::to_string(result.covering) +
                                        " times, and a part of it is traced again"
                                  : "A part of the curve is traced again";
  }
  if (result.overlap.empty())
    return result.status == Status::infinite ? "\n" + subject + ", but nowhere inside the domains.\n" : "";
  std::string text = "\n" + subject + " where\n";
  for (const intersect::Overlap& overlap : result.overlap) {
    std::string line;
    if (shape.t) line = interval_text("t", overlap.t);
    if (shape.u) line += (line.empty() ? "" : ", ") + interval_text("u", overlap.u);
    text += "  " + line + (overlap.certified ? "\n" : " (not certified)\n");
  }
  return text;
}

std::string count_audit(const CurveResult& result, const CurveShape& shape) {
  const intersect::CurveCounts& counts = result.counts;
  unsigned long certified = 0;
  unsigned long listed = 0;
  for (const CurveSolution& solution : result.solutions) {
    listed += solution.multiplicity;
    if (solution.certified) certified += solution.multiplicity;
  }
  const bool all_listed = counts.listed == counts.distinct;
  // Bezout's theorem says nothing about two curves in space, nor about the rest beside an overlap.
  const bool in_space = !shape.surface && shape.names.size() == 4;
  const bool by_equation = shape.itself && !shape.t;
  const bool bezout = result.status != Status::infinite && (!in_space || counts.expected > 0) && !by_equation &&
                      !counts.within_domains_only;
  const std::string found = "found (" + counted(counts.distinct, "solution") + ")";
  std::vector<std::vector<std::string>> rows;
  if (bezout) {
    const char* const number = shape.itself ? "expected by the degrees, (d - 1)(d - 2)/2 for a plane map"
                                            : "expected, the product of the degrees";
    rows.push_back({std::to_string(counts.expected), number});
    rows.push_back({"= " + std::to_string(counts.with_multiplicity), found});
  }
  if (all_listed && counts.with_multiplicity > 0)
    for (auto& row : certified_rows(counts.with_multiplicity, bezout ? "found" : found, certified, listed))
      rows.push_back(std::move(row));
  if (rows.empty()) rows.push_back({std::to_string(counts.with_multiplicity), found});
  std::string text = result.status == Status::infinite ? "\nCount audit of the rest, with multiplicity\n"
                                                       : "\nCount audit, with multiplicity\n";
  text += text_table(rows, {true, false});
  if (bezout && counts.expected != counts.with_multiplicity)
    text += "  THE SUM FAILS: the multiplicities found are not as many as expected\n";
  if (all_listed && listed != counts.with_multiplicity)
    text += "  THE SUM FAILS: the multiplicities listed add up to " + std::to_string(listed) + "\n";
  text += "Solutions: " + realities(counts.distinct, counts.real, counts.undecided) + "; " +
          std::to_string(counts.inside) + " inside";
  if (!all_listed) text += "; " + std::to_string(counts.listed) + " of " + std::to_string(counts.distinct) + " listed";
  return text + "\n";
}

// "(0.25, inf)", of a triangular surface "(1 : 2 : 1)". Those of a real point need not be real.
std::string preimage_text(const std::vector<Parameter>& preimage) {
  std::string text;
  for (const Parameter& parameter : preimage)
    text += (text.empty() ? "(" : preimage.size() == 3 ? " : " : ", ") + parameter_text(parameter, Reality::undecided);
  return text + ")";
}

// A value of a solution by the name that the formats give it, empty where there is none.
std::string value_text(const CurveSolution& solution, const CurveShape& shape, const std::string& name) {
  // A real point may have conjugate parameters.
  const Reality reality = solution.kind == PairKind::isolated ? Reality::non_real : solution.reality;
  if (name == "t") return solution.t ? parameter_text(*solution.t, reality) : "";
  if (name == "u") return solution.u ? parameter_text(*solution.u, reality) : "";
  const auto position = std::find(shape.names.begin(), shape.names.end(), name) - shape.names.begin();
  return coordinate_text(solution.point.at(static_cast<std::size_t>(position)), solution.reality);
}

std::string kind_word(const CurveSolution& solution) { return solution.kind ? word_for(*solution.kind) : "singular"; }

// The names of what is written of every solution; w only where it is not 1 everywhere.
std::vector<std::string> value_names(const CurveResult& result, const CurveShape& shape) {
  std::vector<std::string> names;
  if (shape.t) names.emplace_back("t");
  if (shape.u) names.emplace_back("u");
  names.insert(names.end(), shape.names.begin(), shape.names.end());
  const bool affine = std::all_of(result.solutions.begin(), result.solutions.end(),
                                  [&](const auto& solution) { return value_text(solution, shape, "w") == "1"; });
  if (affine) names.pop_back();
  return names;
}

std::string solution_blocks(const CurveResult& result, const CurveShape& shape) {
  const std::vector<std::string> names = value_names(result, shape);
  std::string text;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const CurveSolution& solution = result.solutions[i];
    text += "\n  #" + std::to_string(i + 1) + "  multiplicity " + std::to_string(solution.multiplicity);
    if (solution.eigenvalue_multiplicity)
      text += ", of the eigenvalue " + std::to_string(*solution.eigenvalue_multiplicity);
    if (shape.itself) text += ", " + kind_word(solution);
    text += std::string(", real ") + reality_word(solution.reality) + ", inside " + (solution.inside ? "yes" : "no") +
            ", radius " + radius_text(solution.radius_exponent) +
            (solution.certified ? ", certified\n" : ", not certified\n");
    for (const std::string& name : names) text += "    " + name + " = " + value_text(solution, shape, name) + "\n";
    for (const auto& preimage : solution.surface_parameters)
      text += "    surface parameters " + preimage_text(preimage) + "\n";
  }
  return text;
}

// Adds a column, its header first, to the rows of a table.
void add_column(std::vector<std::vector<std::string>>& rows, const std::vector<std::string>& column) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(column[i]);
}

std::string solution_table(const CurveResult& result, const CurveShape& shape) {
  const std::vector<CurveSolution>& solutions = result.solutions;
  std::vector<std::vector<std::string>> rows{{"#"}};
  for (std::size_t i = 1; i <= solutions.size(); ++i) rows.push_back({std::to_string(i)});
  std::vector<bool> right_aligned{true};
  const auto add = [&](const std::string& name, bool right, auto text_of) {
    std::vector<std::string> column{name};
    for (const CurveSolution& solution : solutions) column.push_back(text_of(solution));
    add_column(rows, column);
    right_aligned.push_back(right);
  };
  for (const std::string& name : value_names(result, shape)) {
    std::vector<std::string> numbers;
    for (const CurveSolution& solution : solutions) numbers.push_back(value_text(solution, shape, name));
    add_column(rows, number_column(name, std::move(numbers)));
    right_aligned.push_back(false);
  }
  if (std::any_of(solutions.begin(), solutions.end(), [](const auto& s) { return !s.surface_parameters.empty(); }))
    add("surface parameters", false, [](const CurveSolution& solution) {
      std::string text;
      for (const auto& preimage : solution.surface_parameters)
        text += (text.empty() ? "" : ", ") + preimage_text(preimage);
      return text;
    });
  if (shape.itself) add("kind", false, kind_word);
  add("multiplicity", true, [](const auto& solution) { return std::to_string(solution.multiplicity); });
  if (std::any_of(solutions.begin(), solutions.end(), [](const auto& s) { return s.eigenvalue_multiplicity; }))
    add("of eigenvalue", true, [](const CurveSolution& solution) {
      return solution.eigenvalue_multiplicity ? std::to_string(*solution.eigenvalue_multiplicity) : "-";
    });
  add("real", false, [](const auto& solution) { return std::string(reality_word(solution.reality)); });
  add("inside", false, [](const auto& solution) { return std::string(solution.inside ? "yes" : "no"); });
  add("radius", false, [](const auto& solution) { return radius_text(solution.radius_exponent); });
  add("certified", false, [](const auto& solution) { return std::string(solution.certified ? "yes" : "no"); });
  if (table_width(rows) > widest_table) return solution_blocks(result, shape);
  return "\n" + text_table(rows, right_aligned);
}

std::string reasons(const CurveResult& result) {
  std::vector<std::string> of_each;
  for (const CurveSolution& solution : result.solutions) of_each.push_back(solution.certified ? "" : solution.reason);
  return not_certified_lines(of_each);
}

// What the list of pairs does not show: which of them have one point.
std::string points_of_itself(const CurveResult& result) {
  std::string text;
  for (const intersect::SingularPoint& point : result.singular_points) {
    if (point.parameters.size() < 3) continue;
    std::string parameters;
    for (const Parameter& parameter : point.parameters)
      parameters += (parameters.empty() ? "" : ", ") + parameter_text(parameter, Reality::undecided);
    text += "One point has the parameters " + parameters + "; its pairs have multiplicity " +
            std::to_string(point.multiplicity) + " in all.\n";
  }
  if (result.closed) text += "The curve is closed: that it ends where it begins is no self-intersection.\n";
  return text.empty() ? text : "\n" + text;
}

std::string emptiness_sentence(const CurveResult& result, const CurveShape& shape) {
  if (result.status == Status::incomplete) return "\nNo solutions are listed.\n";
  if (result.counts.distinct > 0)
    return "\nNone of the " + counted(result.counts.distinct, "solution") + " is in the part that was asked for.\n";
  if (result.status == Status::infinite) return "\nThere are no other solutions.\n";
  if (shape.itself) return shape.t ? "\nThe curve does not meet itself.\n" : "\nThe curve has no singular point.\n";
  return shape.surface ? "\nThe curve does not meet the surface.\n" : "\nThe curves have no common point.\n";
}

}  // namespace

std::string curve_result_text(const CurveResult& result, const RunOptions& given, bool with_seconds) {
  const CurveShape shape = shape_of(result);
  const std::string infinite = shape.itself    ? "infinitely many points of the curve are double"
                               : shape.surface ? "the curve lies in the surface"
                                               : "the curves coincide";
  std::string text =
      status_lines(result.status, result.rest_status, result.limit, infinite) + overlap_sentences(result, shape);
  if (result.limit)
    text += "\nFound so far: " + counted(result.counts.listed, "solution") + "; the rest is not known.\n";
  else
    text += count_audit(result, shape);
  text += given_and_used(result.engine, given);
  if (with_seconds) text += seconds_line(result.seconds);
  if (result.solutions.empty()) return text + emptiness_sentence(result, shape) + points_of_itself(result);
  return text + solution_table(result, shape) + reasons(result) + points_of_itself(result);
}

}  // namespace eliminant::io
