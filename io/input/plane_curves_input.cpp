// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/plane_curves_input.hpp>

#include <algorithm>
#include <array>

#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/arithmetic/variable_names.hpp>

namespace eliminant::io {

namespace {

std::vector<symbolic::NameOccurrence> names_in(const PolynomialText& polynomial) {
  return named(polynomial.name, [&] { return symbolic::names_in(polynomial.text, polynomial.locate); });
}

// The names of one letter that occur, and x and y: an undeclared `xy` is read as their product.
std::string single_letters(const PolynomialText& p, const PolynomialText& q) {
  std::string letters = "xy";
  for (const PolynomialText* polynomial : {&p, &q})
    for (const auto& occurrence : names_in(*polynomial))
      if (occurrence.name.size() == 1) letters += occurrence.name;
  return letters;
}

std::vector<std::string> inferred_variables(const PolynomialText& p, const PolynomialText& q) {
  const std::string letters = single_letters(p, q);
  std::vector<std::string> names;
  for (const PolynomialText* polynomial : {&p, &q}) {
    for (const auto& [whole_name, offset] : names_in(*polynomial)) {
      const bool product = whole_name.find_first_not_of(letters) == std::string::npos;
      for (std::size_t k = 0; k < (product ? whole_name.size() : 1); ++k) {
        const std::string name = product ? whole_name.substr(k, 1) : whole_name;
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        names.push_back(name);
        if (names.size() <= 2) continue;
        throw InvalidInput(
            polynomial->name + ": a third variable '" + name + "' occurs beside " + names[0] + " and " + names[1],
            "two variables; declare them (\"variables\": [\"x\", \"y\"] or --variables x,y) to read xy as x*y",
            polynomial->locate ? polynomial->locate(offset) : place_in(polynomial->text, offset));
      }
    }
  }
  std::sort(names.begin(), names.end());
  for (const char* name : {"x", "y"})
    if (names.size() < 2 && std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
  return names;
}

symbolic::Rational number_from_json(const JsonDocument& document, const JsonValue& value,
                                    const symbolic::Limits& limits) {
  if (value.kind != JsonValue::Kind::number && value.kind != JsonValue::Kind::text)
    throw InvalidInput("an end of \"box\" is " + std::string(value.kind_in_words()), "a number or a number as text",
                       document.place_of(value));
  return named("box", [&] { return symbolic::parse_number(value.text, limits, document.locate_inside(value)); });
}

std::array<symbolic::Rational, 2> interval_from_json(const JsonDocument& document, const JsonValue& value,
                                                     const symbolic::Limits& limits) {
  if (value.kind != JsonValue::Kind::array || value.elements.size() != 2)
    throw InvalidInput(
        "a side of \"box\" is " + std::string(value.kind_in_words()) +
            (value.kind == JsonValue::Kind::array ? " of " + std::to_string(value.elements.size()) + " values" : ""),
        "[lower, upper]", document.place_of(value));
  std::array<symbolic::Rational, 2> interval{number_from_json(document, value.elements[0], limits),
                                             number_from_json(document, value.elements[1], limits)};
  if (interval[1] < interval[0])
    throw InvalidInput("a side of \"box\" is empty: its lower end is above its upper end", "lower <= upper",
                       document.place_of(value));
  return interval;
}

}  // namespace

void require_two_variables(const std::vector<std::string>& variables, SourcePlace place) {
  if (variables.size() != 2)
    throw InvalidInput("\"variables\" names " + std::to_string(variables.size()) + " variables", "two names", place);
  for (const std::string& name : variables)
    if (!symbolic::is_identifier(name))
      throw InvalidInput("the variable '" + name.substr(0, 40) + "' is no name",
                         "letters, digits and _, beginning with a letter", place);
  if (variables[0] == variables[1])
    throw InvalidInput("the variable '" + variables[0] + "' is declared twice", "two different names", place);
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view part = text.substr(0, comma);
    const std::size_t begin = std::min(part.find_first_not_of(" \t\r\n"), part.size());
    part.remove_prefix(begin);
    part = part.substr(0, part.find_last_not_of(" \t\r\n") + 1);
    parts.emplace_back(part);
    if (comma == text.size()) return parts;
    text.remove_prefix(comma + 1);
  }
}

intersect::PlaneCurvesProblem plane_curves_from_text(const PolynomialText& p, const PolynomialText& q,
                                                     const std::optional<std::vector<std::string>>& variables,
                                                     const symbolic::Limits& limits) {
  intersect::PlaneCurvesProblem problem;
  problem.variables = variables ? *variables : inferred_variables(p, q);
  const auto parse = [&](const PolynomialText& polynomial) {
    return named(polynomial.name, [&] {
      return symbolic::parse_polynomial(polynomial.text, problem.variables, limits, polynomial.locate);
    });
  };
  problem.p = parse(p);
  problem.q = parse(q);
  return problem;
}

intersect::Box box_from_json(const JsonDocument& document, const JsonValue& value, const symbolic::Limits& limits) {
  if (value.kind != JsonValue::Kind::array || value.elements.size() != 2)
    throw InvalidInput(
        "\"box\" is " + std::string(value.kind_in_words()) +
            (value.kind == JsonValue::Kind::array ? " of " + std::to_string(value.elements.size()) + " values" : ""),
        "[[x lower, x upper], [y lower, y upper]]", document.place_of(value));
  return {interval_from_json(document, value.elements[0], limits),
          interval_from_json(document, value.elements[1], limits)};
}

}  // namespace eliminant::io
