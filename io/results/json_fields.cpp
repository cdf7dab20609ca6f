// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/json_fields.hpp>

#include <algorithm>
#include <charconv>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

namespace eliminant::io {

using Kind = JsonValue::Kind;

void JsonFields::refuse(const JsonValue& value, const std::string& what, const std::string& expected) const {
  throw InvalidInput(what + " is " + value.kind_in_words(), expected, document_.place_of(value));
}

const JsonValue& JsonFields::member(const JsonValue& object, const std::string& name,
                                    const std::string& expected) const {
  const JsonValue* value = object.find(name);
  if (value == nullptr)
    throw InvalidInput("the field \"" + name + "\" is missing", expected, document_.place_of(object));
  return *value;
}

void JsonFields::require_object(const JsonValue& value, const std::string& what,
                                std::initializer_list<const char*> names) const {
  if (value.kind != Kind::object) refuse(value, what, "an object");
  for (const JsonMember& member : value.members) {
    if (std::find(names.begin(), names.end(), member.name) != names.end()) continue;
    std::string list;
    for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    throw InvalidInput("unknown field \"" + member.name.substr(0, 40) + "\" in " + what, "one of " + list,
                       document_.place_of(member.offset));
  }
}

const std::vector<JsonValue>& JsonFields::array(const JsonValue& value, const std::string& what) const {
  if (value.kind != Kind::array) refuse(value, what, "an array");
  return value.elements;
}

const std::string& JsonFields::text(const JsonValue& value, const std::string& what) const {
  if (value.kind != Kind::text) refuse(value, what, "a text");
  return value.text;
}

bool JsonFields::boolean(const JsonValue& value, const std::string& what) const {
  if (value.kind != Kind::boolean) refuse(value, what, "true or false");
  return value.boolean;
}

symbolic::Rational JsonFields::number(const JsonValue& value, const std::string& what) const {
  if (value.kind != Kind::number && value.kind != Kind::text) refuse(value, what, "a number or a number as text");
  return symbolic::parse_number(value.text, limits_, document_.locate_inside(value));
}

long JsonFields::integer(const JsonValue& value, const std::string& what, long lowest, long highest) const {
  long number = 0;
  const char* const end = value.text.data() + value.text.size();
  const std::string range = "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  if (value.kind != Kind::number && value.kind != Kind::text) refuse(value, what, range);
  const auto parsed = std::from_chars(value.text.data(), end, number);
  if (parsed.ec != std::errc() || parsed.ptr != end || number < lowest || number > highest)
    throw InvalidInput(what + " is " + value.text.substr(0, 40), range, document_.place_of(value));
  return number;
}

}  // namespace eliminant::io
