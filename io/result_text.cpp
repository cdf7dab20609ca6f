// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/result_text.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

#include <eliminant/io/result_words.hpp>
#include <eliminant/io/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::Result;
using intersect::Solution;
using intersect::Status;

constexpr std::size_t widest_table = 120;

std::string points(unsigned long count) { return std::to_string(count) + (count == 1 ? " point" : " points"); }

std::string status_sentence(const Result& result) {
  const auto meaning = [](Status status) {
    switch (status) {
      case Status::certified:
        return "certified: every solution proven, multiplicities exact, nothing missing";
      case Status::numeric:
        return "numeric: computed, not proven complete";
      case Status::infinite:
        return "infinite: the curves have a common component";
      case Status::incomplete:
        return "incomplete: a limit was reached before everything was found";
    }
    return "";
  };
  if (result.limit) return "Status: incomplete: " + *result.limit + "\n";
  std::string text = std::string("Status: ") + meaning(result.status) + "\n";
  if (result.rest_status) text += std::string("Rest:   ") + meaning(*result.rest_status) + "\n";
  return text;
}

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
      {"= " + number(counts.with_multiplicity), "finite (" + points(counts.distinct) + ")"},
      {"+ " + number(counts.at_infinity), "at infinity"}};
  if (all_listed && counts.with_multiplicity > 0) {
    rows.push_back({number(counts.with_multiplicity), "finite"});
    rows.push_back({"= " + number(certified), "certified"});
    rows.push_back({"+ " + number(listed - certified), "not certified"});
  }
  std::string text =
      result.common_component ? "\nCount audit of the rest, with multiplicity\n" : "\nCount audit, with multiplicity\n";
  text += text_table(rows, {true, false});
  if (counts.bezout_number != counts.with_multiplicity + counts.at_infinity)
    text += "  THE SUM FAILS: finite + at infinity is not the Bezout number\n";
  if (all_listed && listed != counts.with_multiplicity)
    text += "  THE SUM FAILS: the multiplicities listed add up to " + number(listed) + "\n";
  const unsigned long decided = counts.real + counts.undecided;
  text += "Points: " + number(counts.real) + " real, " +
          number(counts.distinct >= decided ? counts.distinct - decided : 0) + " not real, " +
          number(counts.undecided) + " undecided";
  return text + (all_listed ? "\n" : "; " + number(counts.listed) + " of " + number(counts.distinct) + " listed\n");
}

std::string given_and_used(const Result& result, const RunOptions& given) {
  const intersect::EngineReport& used = result.engine;
  const std::vector<OptionSetting> settings = settings_of(given);
  const auto setting = [&](const char* name, const char* otherwise) {
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.name == name; });
    return found == settings.end() ? std::string(otherwise) : found->value;
  };
  std::string matrix = used.matrix.empty() ? "-" : used.matrix;
  if (used.matrix_size > 0)
    matrix += ", " + std::to_string(used.matrix_size) + " x " + std::to_string(used.matrix_size) + " of degree " +
              std::to_string(used.matrix_degree) + " in " + used.hidden_variable;
  std::string engine = used.method.empty() ? "-" : used.method;
  if (used.pencil_size > 0)
    engine +=
        ", pencil of size " + std::to_string(used.pencil_size) + ", regular part " + std::to_string(used.regular_size);
  if (used.shear && *used.shear != 0) engine += ", shear " + std::to_string(*used.shear);
  const std::string bits = used.precision_bits == 0 ? "-" : std::to_string(used.precision_bits) + " bits";
  return "\n" + text_table({{"", "given", "used"},
                            {"engine", setting("engine", "auto"), engine},
                            {"matrix", setting("matrix", "auto"), matrix},
                            {"precision", setting("precision", "auto"), bits},
                            {"seed", setting("seed", "0"), std::to_string(used.seed)}},
                           {});
}

std::string seconds_line(const Result& result) {
  if (result.seconds.empty()) return {};
  std::string text;
  for (const auto& [stage, value] : result.seconds) {
    std::array<char, 64> number{};
    std::snprintf(number.data(), number.size(), "%.6f", value);
    text += (text.empty() ? "  seconds    " : ", ") + stage + " " + number.data();
  }
  return text + "\n";
}

// Whether the digits stand for exactly 0.
bool is_zero(const std::string& digits) { return digits.find_first_of("123456789") == std::string::npos; }

// "0.5 - 1.25i"; a solution known to be real has no imaginary part.
std::string coordinate_text(const intersect::Coordinate& coordinate, intersect::Reality reality) {
  if (reality == intersect::Reality::real || is_zero(coordinate.imaginary)) return coordinate.real;
  const bool negative = coordinate.imaginary.starts_with('-');
  const std::string magnitude = negative ? coordinate.imaginary.substr(1) : coordinate.imaginary;
  if (is_zero(coordinate.real)) return (negative ? "-" : "") + magnitude + "i";
  return coordinate.real + (negative ? " - " : " + ") + magnitude + "i";
}

const char* reality_word(const Solution& solution) {
  switch (solution.reality) {
    case intersect::Reality::real:
      return "yes";
    case intersect::Reality::non_real:
      return "no";
    case intersect::Reality::undecided:
      return "undecided";
  }
  return "undecided";
}

std::string solution_blocks(const Result& result) {
  std::string text;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const Solution& solution = result.solutions[i];
    text += "\n  #" + std::to_string(i + 1) + "  multiplicity " + std::to_string(solution.multiplicity) + ", real " +
            reality_word(solution) + ", radius 1e" + std::to_string(solution.radius_exponent) +
            (solution.certified ? ", certified\n" : ", not certified\n");
    text += "    " + result.variables[0] + " = " + coordinate_text(solution.x, solution.reality) + "\n";
    text += "    " + result.variables[1] + " = " + coordinate_text(solution.y, solution.reality) + "\n";
  }
  return text;
}

// A column of numbers. Where one has a sign, the others get a blank in its place: digits stand below digits.
std::vector<std::string> number_column(const std::string& name, std::vector<std::string> numbers) {
  const bool with_signs = std::any_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.starts_with('-'); });
  numbers.insert(numbers.begin(), name);
  if (with_signs)
    for (std::string& number : numbers)
      if (!number.starts_with('-')) number.insert(0, " ");
  return numbers;
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
                    reality_word(solution), "1e" + std::to_string(solution.radius_exponent),
                    solution.certified ? "yes" : "no"});
  }
  if (table_width(rows) > widest_table) return solution_blocks(result);
  return "\n" + text_table(rows, {true, false, false, true, false, false, false});
}

// Equal reasons once, with the numbers of the solutions they hold for.
std::string reasons(const Result& result) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const Solution& solution = result.solutions[i];
    if (solution.certified || solution.reason.empty()) continue;
    const auto line =
        std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.first == solution.reason; });
    if (line == lines.end())
      lines.emplace_back(solution.reason, "#" + std::to_string(i + 1));
    else
      line->second += ", #" + std::to_string(i + 1);
  }
  std::string text;
  for (const auto& [reason, numbers] : lines) text += "Not certified: " + numbers + ": " + reason + "\n";
  return text;
}

std::string emptiness_sentence(const Result& result) {
  const intersect::Counts& counts = result.counts;
  if (result.status == Status::incomplete) return "\nNo solutions are listed.\n";
  if (counts.distinct > 0) return "\nNone of the " + points(counts.distinct) + " is in the part that was asked for.\n";
  if (result.common_component) return "\nThere are no other solutions.\n";
  return "\nThe curves have no common point in the affine plane" +
         std::string(counts.at_infinity > 0 ? ": all intersections lie at infinity.\n" : ".\n");
}

}  // namespace

std::string result_text(const Result& result, const RunOptions& given, bool with_seconds) {
  const bool whole_plane = result.common_component && result.common_component->is_zero();
  std::string text = status_sentence(result) + component_sentence(result);
  if (result.limit)
    text += "\nFound so far: " + points(result.counts.listed) + "; the rest is not known.\n";
  else if (!whole_plane)
    text += count_audit(result);
  text += given_and_used(result, given);
  if (with_seconds) text += seconds_line(result);
  if (result.solutions.empty()) return text + (whole_plane ? "" : emptiness_sentence(result));
  return text + solution_table(result) + reasons(result);
}

}  // namespace eliminant::io
