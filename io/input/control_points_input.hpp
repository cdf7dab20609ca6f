// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>

namespace eliminant::io {

/// The parts of Bezier and NURBS inputs that curves and surfaces share. Whatever is not as expected is an InvalidInput
/// or ParseError with its place; what is too large is a LimitReached.

/// Most control points of one curve or surface.
inline constexpr std::size_t most_control_points = 100'000;

/// A whole number from 1 to the largest degree allowed.
std::size_t degree_from_json(const JsonFields& fields, const JsonValue& value, const std::string& what);

/// [m, n], each as degree_from_json, with m + n at most the largest degree allowed.
std::array<std::size_t, 2> degree_pair_from_json(const JsonFields& fields, const JsonValue& value);

/// An array of numbers; `element` is "a knot" or so.
std::vector<symbolic::Rational> numbers_from_json(const JsonFields& fields, const JsonValue& value,
                                                  const std::string& what, const std::string& element);

/// The numbers of one control point, `lowest` to 4 of them.
std::vector<symbolic::Rational> point_from_json(const JsonFields& fields, const JsonValue& value, std::size_t lowest);

/// A form with one degree and one list of control points.
struct PointList {
  std::size_t degree;
  const JsonValue& points;
};

/// {"degree": d, "control_points": [...]} under `name` of `value`, with as many points as count_of(d) says. `what` is
/// "a curve" or so, `count_in_words` the number of its points.
template <class Count>
PointList point_list_from_json(const JsonFields& fields, const JsonValue& value, const std::string& name,
                               const std::string& what, const std::string& count_in_words, Count count_of);

/// The coordinates of a point followed by its weight, as a control point with the weight multiplied in.
symbolic::ControlPoint with_own_weight(std::vector<symbolic::Rational> numbers);

/// The same of coordinates alone.
symbolic::ControlPoint with_weight(std::vector<symbolic::Rational> coordinates, const symbolic::Rational& weight);

/// Throws InvalidInput when all weights are zero: nothing remains of the points.
void require_a_weight(const JsonFields& fields, const JsonValue& value, std::span<const symbolic::ControlPoint> points);

/// Throws LimitReached when there are more control points than allowed.
void require_few_points(const JsonFields& fields, const JsonValue& value, std::size_t count);

/// Throws LimitReached when polynomials of this degree with `coefficients` coefficients, made from these points and
/// knots, could have more digits, or take more operations, than allowed. An estimate, no bound.
void require_moderate_size(const JsonFields& fields, const JsonValue& value,
                           std::span<const symbolic::ControlPoint> points, std::span<const symbolic::Rational> knots,
                           std::size_t degree, std::size_t coefficients);

template <class Count>
PointList point_list_from_json(const JsonFields& fields, const JsonValue& value, const std::string& name,
                               const std::string& what, const std::string& count_in_words, Count count_of) {
  const JsonValue& form = fields.member(value, name);
  fields.require_object(form, "\"" + name + "\"", {"degree", "control_points"});
  const std::size_t degree =
      degree_from_json(fields, fields.member(form, "degree", "a whole number"), "the degree of " + what);
  const JsonValue& list = fields.member(form, "control_points", count_in_words + " points");
  const std::size_t count = fields.array(list, "\"control_points\"").size();
  if (count != count_of(degree))
    throw InvalidInput(std::to_string(count) + " control points for " + what + " of degree " + std::to_string(degree),
                       std::to_string(count_of(degree)) + " points", fields.document().place_of(list));
  require_few_points(fields, list, count);
  return {degree, list};
}

}  // namespace eliminant::io
