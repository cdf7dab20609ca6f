// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/problem_file.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include <eliminant/io/input/curve_input.hpp>
#include <eliminant/io/input/cylinder_extraction_input.hpp>
#include <eliminant/io/input/cylinders_input.hpp>
#include <eliminant/io/input/implicitize_input.hpp>
#include <eliminant/io/input/json_text.hpp>
#include <eliminant/io/input/ms_file.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/io/input/plane_curves_input.hpp>
#include <eliminant/io/input/surface_input.hpp>
#include <eliminant/io/input/surface_problem_input.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::io {

namespace {

using Kind = JsonValue::Kind;

// The fields of each kind of problem.
struct ProblemFields {
  const char* kind;
  std::vector<const char*> fields;
};

const std::array<ProblemFields, 9>& problem_fields() {
  static const std::array<ProblemFields, 9> kinds{{
      {"plane_curves", {"problem", "p", "q", "variables", "box", "id", "options"}},
      {"curve_surface", {"problem", "curve", "surface", "id", "options"}},
      {"curve_curve", {"problem", "first", "second", "id", "options"}},
      {"surface_surface", {"problem", "first", "second", "id", "options"}},
      {"self_intersection", {"problem", "curve", "surface", "id", "options"}},
      {"curve_topology", {"problem", "p", "variables", "box", "id", "options"}},
      {"cylinders", {"problem", "points", "id", "options"}},
      {"cylinder_extraction",
       {"problem", "cloud", "distance", "min_radius", "max_radius", "min_inliers", "confidence", "id", "options"}},
      {"implicitize", {"problem", "curve", "surface", "id", "options"}},
  }};
  return kinds;
}

constexpr const char* known_kinds =
    "\"plane_curves\", \"curve_surface\", \"curve_curve\", \"surface_surface\", \"self_intersection\", "
    "\"curve_topology\", \"cylinders\", \"cylinder_extraction\" or \"implicitize\"";

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Reads the fields of one JSON problem.
class Reader {
 public:
  Reader(const JsonDocument& document, const ReadSettings& settings)
      : document_(document), settings_(settings), fields_(document, settings.limits) {}

  std::optional<ProblemId> id() const {
    const JsonValue* value = document_.root().find("id");
    if (value == nullptr) return std::nullopt;
    if (value->kind == Kind::text) return value->text;
    long number = 0;
    const char* const end = value->text.data() + value->text.size();
    const std::from_chars_result read = std::from_chars(value->text.data(), end, number);
    if (value->kind != Kind::number || read.ptr != end)
      refuse(*value, "\"id\" is " + describe(*value), "a text or a whole number");
    if (read.ec != std::errc())
      refuse(*value, "\"id\" is a number of more than 64 bits", "a text, or a whole number from -2^63 to 2^63 - 1");
    return number;
  }

  // The kind of the problem, with all fields known.
  std::string kind() const {
    const JsonValue& root = document_.root();
    if (root.kind != Kind::object)
      refuse(root, "the problem is " + describe(root), "an object such as {\"problem\": \"plane_curves\", ...}");
    const JsonValue* problem = root.find("problem");
    if (problem == nullptr && settings_.bare_geometry) {
      if (!is_bare()) check_fields(problem_fields().back().fields);
      return "implicitize";
    }
    if (problem == nullptr)
      refuse(root, "the field \"problem\" is missing", "\"problem\": \"plane_curves\" or another kind");
    if (problem->kind != Kind::text) refuse(*problem, "\"problem\" is " + describe(*problem), known_kinds);
    for (const ProblemFields& known : problem_fields()) {
      if (problem->text != known.kind) continue;
      check_fields(known.fields);
      return problem->text;
    }
    refuse(*problem, "unknown problem kind \"" + problem->text.substr(0, 40) + "\"", known_kinds);
  }

  intersect::PlaneCurvesProblem plane_curves() const {
    const PolynomialText p = polynomial("p");
    const PolynomialText q = polynomial("q");
    const auto declared = variables();
    const auto sides = box();
    intersect::PlaneCurvesProblem problem =
        plane_curves_from_text(p, q, settings_.variables ? settings_.variables : declared, settings_.limits);
    problem.box = sides;
    return problem;
  }

  intersect::CurveTopologyProblem curve_topology() const {
    const PolynomialText p = polynomial("p");
    const auto declared = variables();
    intersect::CurveTopologyProblem problem;
    problem.box = box();
    // The variables are read like those of two curves.
    intersect::PlaneCurvesProblem read =
        plane_curves_from_text(p, p, settings_.variables ? settings_.variables : declared, settings_.limits);
    problem.p = std::move(read.p);
    problem.variables = std::move(read.variables);
    return problem;
  }

  intersect::CurveSurfaceProblem curve_surface() const {
    const JsonValue& curve = geometry("curve", "a space curve");
    const JsonValue& surface = geometry("surface", "a surface");
    return {read_space_curve(fields_, curve, "\"curve\""), read_surface(fields_, surface, "\"surface\"")};
  }

  intersect::CurveCurveProblem curve_curve() const {
    const JsonValue& first = geometry("first", "a curve");
    const JsonValue& second = geometry("second", "a curve");
    auto curves = read_curve_pair(fields_, first, second);
    return {std::move(curves[0]), std::move(curves[1])};
  }

  intersect::SurfaceSurfaceProblem surface_surface() const {
    const JsonValue& first = geometry("first", "a surface");
    const JsonValue& second = geometry("second", "a surface");
    return read_surface_pair(fields_, first, second);
  }

  Problem self_intersection() const {
    refuse_variables();
    return std::visit([](auto&& problem) -> Problem { return std::forward<decltype(problem)>(problem); },
                      read_self_intersection(fields_, document_.root()));
  }

  intersect::CylindersProblem cylinders() const {
    refuse_variables();
    return read_cylinders(fields_, document_.root());
  }

  intersect::CylinderExtractionProblem cylinder_extraction() const {
    refuse_variables();
    return read_cylinder_extraction(fields_, document_.root(), settings_.folder);
  }

  intersect::ImplicitizeProblem implicitize() const {
    refuse_variables();
    return is_bare() ? read_bare_geometry(fields_, document_.root()) : read_implicitize(fields_, document_.root());
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
  void check_fields(const std::vector<const char*>& known) const {
    for (const JsonMember& member : document_.root().members) {
      if (contains(known, member.name)) continue;
      std::string list;
      for (const char* field : known) list += (list.empty() ? "" : ", ") + std::string(field);
      throw InvalidInput("unknown field \"" + member.name + "\"", "one of " + list, document_.place_of(member.offset));
    }
  }

  // A curve or surface itself.
  bool is_bare() const {
    const JsonValue& root = document_.root();
    return root.find("problem") == nullptr && root.find("curve") == nullptr && root.find("surface") == nullptr;
  }

  void refuse_variables() const {
    if (settings_.variables)
      throw InvalidInput("variables are given for a problem with curves and surfaces",
                         "parameters are named in the problem");
  }

  const JsonValue& geometry(const std::string& name, const std::string& expected) const {
    refuse_variables();
    return fields_.member(document_.root(), name, expected);
  }

  static std::string describe(const JsonValue& value) { return value.kind_in_words(); }

  const JsonDocument& document_;
  const ReadSettings& settings_;
  JsonFields fields_;
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
  const std::string kind = reader.kind();
  result.options = reader.options();
  if (kind == "plane_curves")
    result.problem = reader.plane_curves();
  else if (kind == "curve_surface")
    result.problem = reader.curve_surface();
  else if (kind == "curve_curve")
    result.problem = reader.curve_curve();
  else if (kind == "surface_surface")
    result.problem = reader.surface_surface();
  else if (kind == "self_intersection")
    result.problem = reader.self_intersection();
  else if (kind == "curve_topology")
    result.problem = reader.curve_topology();
  else if (kind == "cylinders")
    result.problem = reader.cylinders();
  else if (kind == "cylinder_extraction")
    result.problem = reader.cylinder_extraction();
  else
    result.problem = reader.implicitize();
  return result;
}

ProblemFile problem_from_arguments(const std::string& p, const std::string& q, const std::optional<std::string>& box,
                                   const ReadSettings& settings) {
  symbolic::install_flint_error_handler();
  intersect::PlaneCurvesProblem problem =
      plane_curves_from_text({"P", p, locate_in(p)}, {"Q", q, locate_in(q)}, settings.variables, settings.limits);
  if (box)
    problem.box = named("--box", [&] {
      const JsonDocument document(*box);
      return box_from_json(document, document.root(), settings.limits);
    });
  ProblemFile result;
  result.problem = std::move(problem);
  return result;
}

}  // namespace eliminant::io
