// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/implicitize_input.hpp>

#include <variant>

#include <eliminant/io/input/curve_input.hpp>
#include <eliminant/io/input/surface_input.hpp>

namespace eliminant::io {

namespace {

intersect::ImplicitizeProblem read_geometry(const JsonFields& fields, const JsonValue& value, bool is_surface,
                                            const std::string& what) {
  if (is_surface) {
    intersect::Surface surface = read_surface(fields, value, what);
    if (auto* parametric = std::get_if<symbolic::ParametricSurface>(&surface)) return {std::move(*parametric)};
  } else {
    intersect::Curve curve = read_curve(fields, value, what);
    if (auto* parametric = std::get_if<symbolic::ParametricCurve>(&curve)) return {std::move(*parametric)};
  }
  throw InvalidInput(what + " is given by its equation already", "a map, Bezier or NURBS form, which has parameters",
                     fields.document().place_of(value));
}

/// The degree of a Bezier or NURBS surface is a pair, pieces are what the first of them is.
bool is_surface(const JsonValue& object) {
  if (object.find("parameters") != nullptr || object.find("triangle") != nullptr) return true;
  for (const char* name : {"bezier", "nurbs"})
    if (const JsonValue* form = object.find(name)) {
      const JsonValue* degree = form->find("degree");
      return degree != nullptr && degree->kind == JsonValue::Kind::array;
    }
  const JsonValue* pieces = object.find("pieces");
  return pieces != nullptr && !pieces->elements.empty() && is_surface(pieces->elements.front());
}

}  // namespace

intersect::ImplicitizeProblem read_implicitize(const JsonFields& fields, const JsonValue& object) {
  const JsonValue* curve = object.find("curve");
  const JsonValue* surface = object.find("surface");
  if ((curve == nullptr) == (surface == nullptr))
    throw InvalidInput(curve == nullptr ? "the field \"curve\" or \"surface\" is missing"
                                        : "the fields \"curve\" and \"surface\" are both there",
                       "one curve or one surface", fields.document().place_of(object));
  if (surface != nullptr) return read_geometry(fields, *surface, true, "\"surface\"");
  return read_geometry(fields, *curve, false, "\"curve\"");
}

intersect::ImplicitizeProblem read_bare_geometry(const JsonFields& fields, const JsonValue& object) {
  const bool surface = is_surface(object);
  return read_geometry(fields, object, surface, surface ? "the surface" : "the curve");
}

}  // namespace eliminant::io
