// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/text_sections.hpp>

#include <algorithm>
#include <array>
#include <cstdio>

#include <eliminant/io/results/text_table.hpp>

namespace eliminant::io {

namespace {

using intersect::Status;

std::string meaning(Status status, const std::string& infinite) {
  switch (status) {
    case Status::certified:
      return "certified: every solution proven, multiplicities exact, nothing missing";
    case Status::numeric:
      return "numeric: computed, not proven complete";
    case Status::infinite:
      return "infinite: " + infinite;
    case Status::incomplete:
      return "incomplete: a limit was reached before everything was found";
  }
  return "";
}

// Whether the digits stand for exactly 0.
bool is_zero(const std::string& digits) { return digits.find_first_of("123456789") == std::string::npos; }

}  // namespace

std::string counted(unsigned long count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string status_lines(Status status, const std::optional<Status>& rest_status,
                         const std::optional<std::string>& limit, const std::string& infinite) {
  if (limit) return "Status: incomplete: " + *limit + "\n";
  std::string text = "Status: " + meaning(status, infinite) + "\n";
  if (rest_status) text += "Rest:   " + meaning(*rest_status, infinite) + "\n";
  return text;
}

std::vector<std::vector<std::string>> certified_rows(unsigned long with_multiplicity, const std::string& sum,
                                                     unsigned long certified, unsigned long listed) {
  return {{std::to_string(with_multiplicity), sum},
          {"= " + std::to_string(certified), "certified"},
          {"+ " + std::to_string(listed - certified), "not certified"}};
}

std::string realities(unsigned long distinct, unsigned long real, unsigned long undecided) {
  const unsigned long decided = real + undecided;
  return std::to_string(real) + " real, " + std::to_string(distinct >= decided ? distinct - decided : 0) +
         " not real, " + std::to_string(undecided) + " undecided";
}

std::string given_and_used(const intersect::EngineReport& used, const RunOptions& given) {
  const std::vector<OptionSetting> settings = settings_of(given);
  const auto setting = [&](const char* name, const char* otherwise) {
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const auto& s) { return s.name == name; });
    return found == settings.end() ? std::string(otherwise) : found->value;
  };
  std::string matrix = used.matrix.empty() ? "-" : used.matrix;
  if (used.matrix_size > 0) {
    matrix += ", " + std::to_string(used.matrix_size) + " x " + std::to_string(used.matrix_size) + " of degree " +
              std::to_string(used.matrix_degree);
    if (!used.hidden_variable.empty()) matrix += " in " + used.hidden_variable;
  }
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

std::string seconds_line(const std::vector<std::pair<std::string, double>>& seconds) {
  if (seconds.empty()) return {};
  std::string text;
  for (const auto& [stage, value] : seconds) {
    std::array<char, 64> number{};
    std::snprintf(number.data(), number.size(), "%.6f", value);
    text += (text.empty() ? "  seconds    " : ", ") + stage + " " + number.data();
  }
  return text + "\n";
}

std::string coordinate_text(const intersect::Coordinate& coordinate, intersect::Reality reality) {
  if (reality == intersect::Reality::real || is_zero(coordinate.imaginary)) return coordinate.real;
  const bool negative = coordinate.imaginary.starts_with('-');
  const std::string magnitude = negative ? coordinate.imaginary.substr(1) : coordinate.imaginary;
  if (is_zero(coordinate.real)) return (negative ? "-" : "") + magnitude + "i";
  return coordinate.real + (negative ? " - " : " + ") + magnitude + "i";
}

const char* reality_word(intersect::Reality reality) {
  switch (reality) {
    case intersect::Reality::real:
      return "yes";
    case intersect::Reality::non_real:
      return "no";
    case intersect::Reality::undecided:
      return "undecided";
  }
  return "undecided";
}

std::vector<std::string> number_column(const std::string& name, std::vector<std::string> numbers) {
  const bool with_signs = std::any_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.starts_with('-'); });
  numbers.insert(numbers.begin(), name);
  if (with_signs)
    for (std::string& number : numbers)
      if (!number.starts_with('-')) number.insert(0, " ");
  return numbers;
}

std::string not_certified_lines(const std::vector<std::string>& reasons) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (reasons[i].empty()) continue;
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.first == reasons[i]; });
    if (line == lines.end())
      lines.emplace_back(reasons[i], "#" + std::to_string(i + 1));
    else
      line->second += ", #" + std::to_string(i + 1);
  }
  std::string text;
  for (const auto& [reason, numbers] : lines) text += "Not certified: " + numbers + ": " + reason + "\n";
  return text;
}

}  // namespace eliminant::io
