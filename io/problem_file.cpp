// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/problem_file.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <eliminant/io/json_text.hpp>
#include <eliminant/io/ms_file.hpp>
#include <eliminant/io/plane_curves_input.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::io {

namespace {

using Kind = JsonValue::Kind;

constexpr std::array fields{"problem", "p", "q", "variables", "box", "id", "options"};
constexpr std::array later_problems{"curve_curve",    "curve_surface", "surface_surface",    "self_intersection",
                                    "curve_topology", "cylinders",     "cylinder_extraction"};

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Reads the fields of one JSON problem.
class Reader {
 public:
  Reader(const JsonDocument& document, const ReadSettings& settings) : document_(document), settings_(settings) {}

  std::optional<ProblemId> id() const {
    const JsonValue* value = document_.root().find("id");
    if (value == nullptr) return std::nullopt;
    if (value->kind == Kind::text) return value->text;
    long number = 0;
    const char* const end = value->text.data() + value->text.size();
    if (value->kind != Kind::number || std::from_chars(value->text.data(), end, number).ptr != end)
      refuse(*value, "\"id\" is " + describe(*value), "a text or a whole number");
    return number;
  }

  void check_fields() const {
    const JsonValue& root = document_.root();
    if (root.kind != Kind::object)
      refuse(root, "the problem is " + describe(root), "an object such as {\"problem\": \"plane_curves\", ...}");
    const JsonValue* problem = root.find("problem");
    if (problem == nullptr) refuse(root, "the field \"problem\" is missing", "\"problem\": \"plane_curves\"");
    if (problem->kind != Kind::text) refuse(*problem, "\"problem\" is " + describe(*problem), "\"plane_curves\"");
    if (problem->text != "plane_curves")
      refuse(*problem,
             contains(later_problems, problem->text)
                 ? "the problem kind \"" + problem->text + "\" is not supported by this version"
                 : "unknown problem kind \"" + problem->text.substr(0, 40) + "\"",
             "\"plane_curves\"");
    for (const JsonMember& member : root.members) {
      if (contains(fields, member.name)) continue;
      std::string list;
      for (const char* field : fields) list += (list.empty() ? "" : ", ") + std::string(field);
      throw InvalidInput("unknown field \"" + member.name + "\"", "one of " + list, document_.place_of(member.offset));
    }
  }

  PolynomialText polynomial(const char* name) const {
    const JsonValue* value = document_.root().find(name);
    if (value == nullptr)
      refuse(document_.root(), "the field \"" + std::string(name) + "\" is missing", "a polynomial as text");
    // A bare number is a constant polynomial.
    if (value->kind != Kind::text && value->kind != Kind::number)
      refuse(*value, "\"" + std::string(name) + "\" is " + describe(*value), "a polynomial as text");
    return {name, value->text, document_.locate_inside(*value)};
  }

  std::optional<std::vector<std::string>> variables() const {
    const JsonValue* value = document_.root().find("variables");
    if (value == nullptr) return std::nullopt;
    if (value->kind != Kind::array) refuse(*value, "\"variables\" is " + describe(*value), "an array of two names");
    std::vector<std::string> names;
    for (const JsonValue& element : value->elements) {
      if (element.kind != Kind::text) refuse(element, "a variable is " + describe(element), "a name as text");
      names.push_back(element.text);
    }
    require_two_variables(names, document_.place_of(*value));
    return names;
  }

  std::optional<intersect::Box> box() const {
    const JsonValue* value = document_.root().find("box");
    if (value == nullptr) return std::nullopt;
    return box_from_json(document_, *value, settings_.limits);
  }

  std::vector<OptionSetting> options() const {
    const JsonValue* value = document_.root().find("options");
    if (value == nullptr) return {};
    if (value->kind != Kind::object) refuse(*value, "\"options\" is " + describe(*value), "an object");
    std::vector<OptionSetting> settings;
    for (const auto& [name, offset, option] : value->members) {
      const bool known = contains(option_names(), name);
      const bool boolean = option.kind == Kind::boolean;
      const bool word = option.kind == Kind::text || option.kind == Kind::number;
      if (known && (is_switch(name) ? !boolean : !word))
        refuse(option, "option " + name + " is " + describe(option),
               is_switch(name) ? "true or false" : "a number or a text");
      settings.push_back({name, boolean ? (option.boolean ? "true" : "false") : option.text,
                          document_.place_of(known ? option.offset : offset)});
    }
    RunOptions checked;
    apply_options(checked, settings);
    return settings;
  }

 private:
  [[noreturn]] void refuse(const JsonValue& value, const std::string& message, const std::string& expected) const {
    throw InvalidInput(message, expected, document_.place_of(value));
  }
  static std::string describe(const JsonValue& value) { return value.kind_in_words(); }

  const JsonDocument& document_;
  const ReadSettings& settings_;
};

}  // namespace

ProblemSyntax problem_syntax(const std::string& path, std::string_view text) {
  if (path.ends_with(".ms")) return ProblemSyntax::msolve;
  if (path.ends_with(".json")) return ProblemSyntax::json;
  // The first line of msolve's format holds names and commas only.
  const std::string_view line = text.substr(0, text.find('\n'));
  const bool names =
      line.find_first_of("{}[]\":") == std::string_view::npos && line.find(',') != std::string_view::npos;
  return names ? ProblemSyntax::msolve : ProblemSyntax::json;
}

ProblemFile read_problem(const std::string& text, ProblemSyntax syntax, const ReadSettings& settings,
                         std::optional<ProblemId>* id) {
  symbolic::install_flint_error_handler();
  ProblemFile result;
  if (syntax == ProblemSyntax::msolve) {
    result.problem = read_ms_problem(text, settings.variables, settings.limits);
    return result;
  }
  const JsonDocument document(text);
  const Reader reader(document, settings);
  result.id = reader.id();
  if (id != nullptr) *id = result.id;
  reader.check_fields();
  const PolynomialText p = reader.polynomial("p");
  const PolynomialText q = reader.polynomial("q");
  const auto variables = reader.variables();
  result.options = reader.options();
  const auto box = reader.box();
  result.problem = plane_curves_from_text(p, q, settings.variables ? settings.variables : variables, settings.limits);
  result.problem.box = box;
  return result;
}

ProblemFile problem_from_arguments(const std::string& p, const std::string& q, const std::optional<std::string>& box,
                                   const ReadSettings& settings) {
  symbolic::install_flint_error_handler();
  ProblemFile result;
  result.problem =
      plane_curves_from_text({"P", p, locate_in(p)}, {"Q", q, locate_in(q)}, settings.variables, settings.limits);
  if (!box) return result;
  try {
    const JsonDocument document(*box);
    result.problem.box = box_from_json(document, document.root(), settings.limits);
  } catch (const ParseError& error) {
    throw ParseError(std::string("--box: ") + error.what(), error.expected(), error.place());
  }
  return result;
}

}  // namespace eliminant::io
