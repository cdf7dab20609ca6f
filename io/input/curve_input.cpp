// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/curve_input.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <eliminant/io/input/control_points_input.hpp>
#include <eliminant/io/input/map_input.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>

namespace eliminant::io {

namespace {

using symbolic::ControlPoint;
using symbolic::CurvePiece;
using symbolic::ParametricCurve;
using symbolic::Rational;

const char* const curve_example = "a curve such as {\"parameter\": \"t\", \"x\": \"t\", \"y\": \"t^2\"}";

// A curve as it was written.
struct CurveText {
  intersect::Curve curve;
  // Points [x, y, 0, w] and no others: in space, or in the plane.
  bool plane_or_space = false;
};

std::size_t dimension(const intersect::Curve& curve) {
  const auto* parametric = std::get_if<ParametricCurve>(&curve);
  return parametric == nullptr ? 2 : parametric->pieces.front().map.dimension();
}

// Without the coordinate z, which is zero.
void drop_z(CurveText& text) {
  for (CurvePiece& piece : std::get<ParametricCurve>(text.curve).pieces) {
    std::vector<symbolic::UnivariatePolynomial> coordinates = piece.map.coordinates();
    coordinates.erase(coordinates.begin() + 2);
    piece.map = symbolic::RationalCurve(std::move(coordinates));
  }
}

class CurveReader {
 public:
  CurveReader(const JsonFields& fields, std::string what) : fields_(fields), what_(std::move(what)) {}

  CurveText read(const JsonValue& value) {
    if (value.kind != JsonValue::Kind::object) fields_.refuse(value, what_, curve_example);
    if (value.find("implicit") != nullptr)
      return {intersect::ImplicitCurve{implicit_equation(fields_, value, what_, {"x", "y"})}};
    ParametricCurve curve;
    if (value.find("bezier") != nullptr)
      curve = bezier(value);
    else if (value.find("nurbs") != nullptr)
      curve = nurbs(value);
    else if (value.find("pieces") != nullptr)
      curve = pieces(value);
    else
      curve.pieces.push_back(map(value));
    if (std::all_of(curve.pieces.begin(), curve.pieces.end(), [](const auto& p) { return p.map.degree() == 0; }))
      throw InvalidInput(what_ + " is a single point", "a curve that is not constant", place(value));
    return {std::move(curve), plane_or_space_};
  }

 private:
  SourcePlace place(const JsonValue& value) const { return fields_.document().place_of(value); }

  CurvePiece map(const JsonValue& value) const {
    fields_.require_object(value, what_, {"parameter", "x", "y", "z", "w", "domain"});
    const std::vector<std::string> parameter{
        parameter_name(fields_, fields_.member(value, "parameter",
                                               "\"parameter\": \"t\" with \"x\", \"y\", ..., or one "
                                               "of bezier, nurbs, implicit"))};
    std::vector<symbolic::Polynomial> coordinates;
    for (const char* name : {"x", "y", "z", "w"}) {
      const bool optional = *name == 'z' || *name == 'w';
      if (const JsonValue* coordinate = value.find(name))
        coordinates.push_back(polynomial_from_json(fields_, *coordinate, name, parameter));
      else if (!optional)
        fields_.member(value, name, "a polynomial in " + parameter[0]);
      else if (*name == 'w')
        coordinates.push_back(symbolic::Polynomial::constant(1, 1));
    }
    CurvePiece piece{placed(place(value), [&] { return symbolic::rational_curve(coordinates); }), {}};
    if (const JsonValue* domain = value.find("domain"))
      piece.domain = interval_from_json(fields_, *domain, "the domain of " + what_);
    return piece;
  }

  // Maps in one parameter, each with a domain that begins where the one before ends.
  ParametricCurve pieces(const JsonValue& value) const {
    fields_.require_object(value, what_, {"pieces"});
    const JsonValue& list = fields_.member(value, "pieces");
    ParametricCurve curve;
    for (const JsonValue& element : fields_.array(list, "\"pieces\"")) {
      curve.pieces.push_back(map(element));
      const CurvePiece& piece = curve.pieces.back();
      const CurvePiece& before = curve.pieces[curve.pieces.size() - (curve.pieces.size() > 1 ? 2 : 1)];
      fields_.member(element, "domain", "\"domain\": [lower, upper] for each of the pieces");
      if (piece.map.dimension() != before.map.dimension())
        throw InvalidInput("pieces of " + what_ + " lie in the plane and in space", "all with z or all without it",
                           place(element));
      if (&piece != &before && !(piece.domain->lower == before.domain->upper))
        throw InvalidInput("a piece of " + what_ + " does not begin where the one before ends",
                           "a domain that begins at " + before.domain->upper.to_string().substr(0, 40), place(element));
    }
    if (curve.pieces.empty()) throw InvalidInput("\"pieces\" is an empty array", "at least one map", place(list));
    return curve;
  }

  ParametricCurve bezier(const JsonValue& value) {
    fields_.require_object(value, what_, {"bezier"});
    const PointList net = point_list_from_json(fields_, value, "bezier", "a curve", "degree + 1",
                                               [](std::size_t degree) { return degree + 1; });
    const JsonValue& list = net.points;
    const std::vector<ControlPoint> points = control_points(list, nullptr);
    require_moderate_size(fields_, list, points, {}, net.degree, 4 * points.size());
    ParametricCurve curve;
    curve.pieces.push_back(placed(place(list), [&] { return symbolic::bezier_curve(points); }));
    return curve;
  }

  ParametricCurve nurbs(const JsonValue& value) {
    fields_.require_object(value, what_, {"nurbs"});
    const JsonValue& form = fields_.member(value, "nurbs");
    fields_.require_object(form, "\"nurbs\"", {"degree", "knots", "control_points", "weights"});
    symbolic::KnotVector knots;
    knots.degree = degree_from_json(fields_, fields_.member(form, "degree", "a whole number"), "the degree of a curve");
    const JsonValue& list = fields_.member(form, "control_points", "an array of points");
    const std::size_t count = fields_.array(list, "\"control_points\"").size();
    if (count < knots.degree + 1)
      throw InvalidInput(
          std::to_string(count) + " control points for a curve of degree " + std::to_string(knots.degree),
          "at least " + std::to_string(knots.degree + 1) + " points", place(list));
    require_few_points(fields_, list, count);
    const JsonValue& knot_list = fields_.member(form, "knots", "control points + degree + 1 knots");
    knots.knots = numbers_from_json(fields_, knot_list, "\"knots\"", "a knot");
    placed(place(knot_list), [&] { symbolic::require_knots(knots, count); });
    const std::vector<ControlPoint> points = control_points(list, form.find("weights"));
    require_moderate_size(fields_, list, points, knots.knots, knots.degree,
                          4 * (count - knots.degree) * (knots.degree + 1));
    return placed(place(list), [&] { return symbolic::nurbs_curve(knots, points); });
  }

  // The points with their weights multiplied in; in the plane when one of them has two numbers.
  std::vector<ControlPoint> control_points(const JsonValue& list, const JsonValue* weight_list) {
    std::vector<std::vector<Rational>> points;
    for (const JsonValue& element : list.elements) points.push_back(point_from_json(fields_, element, 2));
    const std::vector<Rational> weights = weights_of(list, weight_list);
    const auto has = [&](std::size_t numbers) {
      return std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.size() == numbers; });
    };
    const bool plane = has(2);
    plane_or_space_ =
        !plane && !has(3) && std::all_of(points.begin(), points.end(), [](const auto& p) { return p[2].is_zero(); });
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (weight_list != nullptr && points[i].size() == 4)
        throw InvalidInput("a control point has a weight beside \"weights\"", "[x, y] or [x, y, z]",
                           place(list.elements[i]));
      if (plane && points[i].size() > 2) {
        if (points[i].size() == 3 || !points[i][2].is_zero())
          throw InvalidInput("a control point in space beside one of two numbers, which lies in the plane",
                             "[x, y] or [x, y, 0, w]", place(list.elements[i]));
        points[i].erase(points[i].begin() + 2);
        points[i] = with_own_weight(std::move(points[i]));
      } else {
        points[i] = points[i].size() == 4 ? with_own_weight(std::move(points[i]))
                                          : with_weight(std::move(points[i]), weights[i]);
      }
    }
    require_a_weight(fields_, weight_list == nullptr ? list : *weight_list, points);
    return points;
  }

  std::vector<Rational> weights_of(const JsonValue& list, const JsonValue* weight_list) const {
    if (weight_list == nullptr) return std::vector<Rational>(list.elements.size(), 1);
    std::vector<Rational> weights = numbers_from_json(fields_, *weight_list, "\"weights\"", "a weight");
    if (weights.size() != list.elements.size())
      throw InvalidInput(
          std::to_string(weights.size()) + " weights for " + std::to_string(list.elements.size()) + " control points",
          "a weight for each point", place(*weight_list));
    return weights;
  }

  const JsonFields& fields_;
  std::string what_;
  bool plane_or_space_ = false;
};

}  // namespace

intersect::Curve read_curve(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  CurveText text = CurveReader(fields, what).read(value);
  if (text.plane_or_space) drop_z(text);
  return std::move(text.curve);
}

symbolic::ParametricCurve read_space_curve(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  CurveText text = CurveReader(fields, what).read(value);
  auto* curve = std::get_if<ParametricCurve>(&text.curve);
  if (curve == nullptr)
    throw InvalidInput(what + " is a plane curve given by an equation", "a space curve with a parameter",
                       fields.document().place_of(value));
  if (dimension(text.curve) != 3)
    throw InvalidInput(what + " is a plane curve", "a space curve: with the coordinate z",
                       fields.document().place_of(value));
  return std::move(*curve);
}

std::array<intersect::Curve, 2> read_curve_pair(const JsonFields& fields, const JsonValue& first,
                                                const JsonValue& second) {
  CurveText a = CurveReader(fields, "\"first\"").read(first);
  CurveText b = CurveReader(fields, "\"second\"").read(second);
  if (a.plane_or_space && (b.plane_or_space || dimension(b.curve) == 2)) drop_z(a);
  if (b.plane_or_space && dimension(a.curve) == 2) drop_z(b);
  if (dimension(a.curve) != dimension(b.curve)) {
    const bool first_in_plane = dimension(a.curve) == 2;
    throw InvalidInput(std::string("\"first\" is a ") + (first_in_plane ? "plane" : "space") +
                           " curve and \"second\" a " + (first_in_plane ? "space" : "plane") + " curve",
                       "two plane curves or two space curves", fields.document().place_of(second));
  }
  return {std::move(a.curve), std::move(b.curve)};
}

}  // namespace eliminant::io
