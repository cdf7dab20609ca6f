// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/cylinders_input.hpp>

#include <array>
#include <string>

#include <eliminant/base/error.hpp>
#include <eliminant/io/input/named_errors.hpp>

namespace eliminant::io {

namespace {

constexpr const char* five_points = "five points [x, y, z]";

symbolic::SpacePoint read_point(const JsonFields& fields, const JsonValue& value, const std::string& name) {
  if (value.kind != JsonValue::Kind::array) fields.refuse(value, name, "[x, y, z]");
  if (value.elements.size() != 3)
    throw InvalidInput(
        name + " has " + std::to_string(value.elements.size()) + (value.elements.size() == 1 ? " number" : " numbers"),
        "[x, y, z]", fields.document().place_of(value));
  constexpr std::array axes{"x", "y", "z"};
  symbolic::SpacePoint point;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string coordinate = std::string(axes[i]) + " of " + name;
    point[i] = named(coordinate, [&] { return fields.number(value.elements[i], coordinate); });
  }
  return point;
}

}  // namespace

intersect::CylindersProblem read_cylinders(const JsonFields& fields, const JsonValue& problem) {
  const JsonValue& points = fields.member(problem, "points", five_points);
  if (points.kind != JsonValue::Kind::array) fields.refuse(points, "\"points\"", five_points);
  if (points.elements.size() != 5)
    throw InvalidInput("\"points\" holds " + std::to_string(points.elements.size()) +
                           (points.elements.size() == 1 ? " point" : " points"),
                       five_points, fields.document().place_of(points));
  intersect::CylindersProblem result;
  for (std::size_t k = 0; k < 5; ++k)
    result.points[k] = read_point(fields, points.elements[k], "point " + std::to_string(k + 1));
  return result;
}

}  // namespace eliminant::io
