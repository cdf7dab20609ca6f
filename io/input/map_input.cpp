// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/map_input.hpp>

#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/arithmetic/variable_names.hpp>

namespace eliminant::io {

using Kind = JsonValue::Kind;

std::string parameter_name(const JsonFields& fields, const JsonValue& value) {
  if (value.kind != Kind::text) fields.refuse(value, "a parameter", "a name as text");
  if (!symbolic::is_identifier(value.text))
    throw InvalidInput("the parameter '" + value.text.substr(0, 40) + "' is no name",
                       "letters, digits and _, beginning with a letter", fields.document().place_of(value));
  return value.text;
}

symbolic::Polynomial polynomial_from_json(const JsonFields& fields, const JsonValue& value, const std::string& name,
                                          const std::vector<std::string>& variables) {
  // A bare number is a constant polynomial.
  if (value.kind != Kind::text && value.kind != Kind::number)
    fields.refuse(value, "\"" + name + "\"", "a polynomial as text");
  return named(name, [&] {
    return symbolic::parse_polynomial(value.text, variables, fields.limits(), fields.document().locate_inside(value));
  });
}

symbolic::Interval interval_from_json(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  if (value.kind != Kind::array) fields.refuse(value, what, "[lower, upper]");
  const std::vector<JsonValue>& ends = value.elements;
  if (ends.size() != 2)
    throw InvalidInput(what + " is an array of " + std::to_string(ends.size()) + " values", "[lower, upper]",
                       fields.document().place_of(value));
  symbolic::Interval interval = named("domain", [&] {
    return symbolic::Interval{fields.number(ends[0], "an end of " + what), fields.number(ends[1], "an end of " + what)};
  });
  if (interval.upper < interval.lower)
    throw InvalidInput(what + " is empty: its lower end is above its upper end", "lower <= upper",
                       fields.document().place_of(value));
  return interval;
}

symbolic::Polynomial implicit_equation(const JsonFields& fields, const JsonValue& object, const std::string& what,
                                       const std::vector<std::string>& variables) {
  fields.require_object(object, what, {"implicit"});
  const JsonValue& value = fields.member(object, "implicit");
  symbolic::Polynomial equation = polynomial_from_json(fields, value, "implicit", variables);
  if (equation.is_constant())
    throw InvalidInput("\"implicit\" is constant", "an equation with one of its variables",
                       fields.document().place_of(value));
  return equation;
}

}  // namespace eliminant::io
