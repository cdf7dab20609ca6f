// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/ms_file.hpp>

#include <string_view>

#include <eliminant/io/input/plane_curves_input.hpp>

namespace eliminant::io {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

}  // namespace

intersect::PlaneCurvesProblem read_ms_problem(const std::string& text,
                                              const std::optional<std::vector<std::string>>& variables,
                                              const symbolic::Limits& limits) {
  const auto place = [&](std::size_t offset) { return place_in(text, offset); };
  const std::size_t first_end = std::min(text.find('\n'), text.size());
  const std::vector<std::string> names = split_at_commas(std::string_view(text).substr(0, first_end));
  require_two_variables(names, place(0));

  const std::size_t second = std::min(first_end + 1, text.size());
  const std::size_t second_end = std::min(text.find('\n', second), text.size());
  const std::string_view characteristic = trimmed(std::string_view(text).substr(second, second_end - second));
  if (characteristic != "0")
    throw InvalidInput("the characteristic on the second line is '" + std::string(characteristic.substr(0, 40)) + "'",
                       "0 (the rational numbers)", place(second));

  std::vector<PolynomialText> polynomials;
  std::size_t begin = std::min(second_end + 1, text.size());
  while (true) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = std::string_view(text).substr(begin, end - begin);
    // A comma behind the last polynomial is common and harmless.
    const bool behind_last = end == text.size() && trimmed(part).empty() && !polynomials.empty();
    if (!behind_last && polynomials.size() == 2)
      throw InvalidInput("a third polynomial begins", "two polynomials", place(begin));
    if (!behind_last)
      polynomials.push_back({polynomials.empty() ? "p" : "q", std::string(part),
                             [&text, begin](std::size_t offset) { return place_in(text, begin + offset); }});
    if (end == text.size()) break;
    begin = end + 1;
  }
  if (polynomials.size() < 2 || trimmed(polynomials[0].text).empty())
    throw InvalidInput("the file has fewer than two polynomials", "two polynomials separated by a comma",
                       place(text.size()));
  return plane_curves_from_text(polynomials[0], polynomials[1], variables ? *variables : names, limits);
}

}  // namespace eliminant::io
