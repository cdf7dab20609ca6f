// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/surface_problem_input.hpp>

#include <utility>

#include <eliminant/io/input/curve_input.hpp>
#include <eliminant/io/input/surface_input.hpp>

namespace eliminant::io {

namespace {

using ParametricOrEquation = std::variant<symbolic::ParametricSurface, symbolic::Polynomial>;

ParametricOrEquation surface_or_equation(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  intersect::Surface surface = read_surface(fields, value, what);
  if (auto* implicit = std::get_if<intersect::ImplicitSurface>(&surface)) return std::move(implicit->equation);
  return std::get<symbolic::ParametricSurface>(std::move(surface));
}

bool is_equation(const ParametricOrEquation& surface) { return std::holds_alternative<symbolic::Polynomial>(surface); }

}  // namespace

intersect::SurfaceSurfaceProblem read_surface_pair(const JsonFields& fields, const JsonValue& first,
                                                   const JsonValue& second) {
  intersect::SurfaceSurfaceProblem problem{surface_or_equation(fields, first, "\"first\""),
                                           surface_or_equation(fields, second, "\"second\"")};
  if (is_equation(problem.first) && is_equation(problem.second))
    throw InvalidInput("\"first\" and \"second\" are both given by equations",
                       "at least one surface with parameters: a map, Bezier or NURBS form",
                       fields.document().place_of(second));
  return problem;
}

std::variant<intersect::SelfIntersectionProblem, intersect::SurfaceSelfIntersectionProblem> read_self_intersection(
    const JsonFields& fields, const JsonValue& object) {
  const JsonValue* const curve = object.find("curve");
  const JsonValue* const surface = object.find("surface");
  if ((curve == nullptr) == (surface == nullptr))
    throw InvalidInput(curve == nullptr ? "the field \"curve\" or \"surface\" is missing"
                                        : "the fields \"curve\" and \"surface\" are both there",
                       "one curve or one surface", fields.document().place_of(object));
  if (curve != nullptr) return intersect::SelfIntersectionProblem{read_curve(fields, *curve, "\"curve\"")};
  ParametricOrEquation read = surface_or_equation(fields, *surface, "\"surface\"");
  if (is_equation(read))
    throw InvalidInput("\"surface\" is given by an equation", "a surface with parameters: a map, Bezier or NURBS form",
                       fields.document().place_of(*surface));
  return intersect::SurfaceSelfIntersectionProblem{std::get<symbolic::ParametricSurface>(std::move(read))};
}

}  // namespace eliminant::io
