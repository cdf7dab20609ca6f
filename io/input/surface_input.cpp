// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/surface_input.hpp>

#include <algorithm>
#include <utility>

#include <eliminant/io/input/control_points_input.hpp>
#include <eliminant/io/input/map_input.hpp>
#include <eliminant/io/input/named_errors.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>

namespace eliminant::io {

namespace {

using Kind = JsonValue::Kind;
using symbolic::ControlPoint;
using symbolic::Interval;
using symbolic::ParametricSurface;
using symbolic::Rational;
using symbolic::SurfacePiece;

const char* const surface_example =
    "a surface such as {\"parameters\": [\"s\", \"t\"], \"x\": \"s\", \"y\": \"t\", \"z\": \"s*t\"}";

using Rows = std::vector<std::vector<ControlPoint>>;

std::vector<ControlPoint> all_of(const Rows& rows) {
  std::vector<ControlPoint> points;
  for (const auto& row : rows) points.insert(points.end(), row.begin(), row.end());
  return points;
}

class SurfaceReader {
 public:
  SurfaceReader(const JsonFields& fields, std::string what) : fields_(fields), what_(std::move(what)) {}

  intersect::Surface read(const JsonValue& value) const {
    if (value.kind != Kind::object) fields_.refuse(value, what_, surface_example);
    if (value.find("implicit") != nullptr)
      return intersect::ImplicitSurface{implicit_equation(fields_, value, what_, {"x", "y", "z"})};
    ParametricSurface surface;
    if (value.find("bezier") != nullptr)
      surface.pieces.push_back(bezier(value));
    else if (value.find("triangle") != nullptr)
      surface.pieces.push_back(triangle(value));
    else if (value.find("nurbs") != nullptr)
      surface = nurbs(value);
    else if (value.find("pieces") != nullptr)
      surface = pieces(value);
    else
      surface.pieces.push_back(map(value));
    if (std::none_of(surface.pieces.begin(), surface.pieces.end(),
                     [](const SurfacePiece& piece) { return symbolic::is_two_dimensional(piece.map); }))
      throw InvalidInput("the image of " + what_ + " is only a curve or a point",
                         "a map with two independent parameters", place(value));
    return surface;
  }

 private:
  SourcePlace place(const JsonValue& value) const { return fields_.document().place_of(value); }

  SurfacePiece map(const JsonValue& value) const {
    fields_.require_object(value, what_, {"parameters", "x", "y", "z", "w", "domain"});
    const std::vector<std::string> names =
        parameters(fields_.member(value, "parameters",
                                  "\"parameters\": [\"s\", \"t\"] with \"x\", \"y\", \"z\", ..., or one of "
                                  "bezier, triangle, nurbs, implicit"));
    const bool forms = names.size() == 3;
    std::vector<symbolic::Polynomial> coordinates;
    long degree = -1;
    for (const char* name : {"x", "y", "z", "w"}) {
      if (*name == 'w' && value.find(name) == nullptr) {
        if (forms && degree > 0)
          throw InvalidInput("the field \"w\" is missing beside coordinates of degree " + std::to_string(degree),
                             "a form of the same degree in three parameters, or two parameters", place(value));
        coordinates.push_back(symbolic::Polynomial::constant(names.size(), 1));
        continue;
      }
      const JsonValue& coordinate = fields_.member(value, name, "a polynomial in the parameters");
      coordinates.push_back(polynomial_from_json(fields_, coordinate, name, names));
      if (forms) require_form(coordinate, name, coordinates.back(), degree);
    }
    const auto kind =
        forms ? symbolic::RationalSurface::Kind::triangular : symbolic::RationalSurface::Kind::tensor_product;
    SurfacePiece piece{placed(place(value), [&] { return symbolic::RationalSurface(kind, std::move(coordinates)); }),
                       {}};
    if (const JsonValue* domain = value.find("domain")) piece.region = region(*domain, forms);
    return piece;
  }

  std::vector<std::string> parameters(const JsonValue& value) const {
    std::vector<std::string> names;
    for (const JsonValue& name : fields_.array(value, "\"parameters\"")) {
      names.push_back(parameter_name(fields_, name));
      if (std::find(names.begin(), names.end() - 1, names.back()) != names.end() - 1)
        throw InvalidInput("the parameter '" + names.back() + "' occurs twice", "different names", place(name));
    }
    if (names.size() != 2 && names.size() != 3)
      throw InvalidInput("\"parameters\" has " + std::to_string(names.size()) + " names",
                         "two affine or three homogeneous parameters", place(value));
    return names;
  }

  // `degree` is that of the forms so far, -1 when all are zero.
  void require_form(const JsonValue& value, const std::string& name, const symbolic::Polynomial& p,
                    long& degree) const {
    if (p.is_zero()) return;
    if (!symbolic::is_form(p))
      throw InvalidInput("\"" + name + "\" is not homogeneous in the three parameters", "a form", place(value));
    if (degree >= 0 && p.total_degree() != degree)
      throw InvalidInput("\"" + name + "\" is a form of degree " + std::to_string(p.total_degree()) +
                             " beside one of degree " + std::to_string(degree),
                         "forms of one degree", place(value));
    degree = p.total_degree();
  }

  symbolic::ParameterRegion region(const JsonValue& value, bool forms) const {
    if (forms) {
      if (value.kind != Kind::text || value.text != "triangle")
        throw InvalidInput("the domain of a map with three parameters is no triangle",
                           "\"triangle\": no parameter negative; or two parameters", place(value));
      return {{Interval{0, 1}, Interval{0, 1}}, true};
    }
    const std::string what = "the domain of " + what_;
    const std::string expected = "[[first lower, first upper], [second lower, second upper]]";
    if (value.kind != Kind::array) fields_.refuse(value, what, expected);
    if (value.elements.size() != 2)
      throw InvalidInput(what + " is an array of " + std::to_string(value.elements.size()) + " values", expected,
                         place(value));
    const std::string side = "a side of " + what;
    return {
        {interval_from_json(fields_, value.elements[0], side), interval_from_json(fields_, value.elements[1], side)},
        false};
  }

  // Maps of two parameters on the rectangles of a grid, row by row: the first parameter changes last.
  ParametricSurface pieces(const JsonValue& value) const {
    fields_.require_object(value, what_, {"pieces"});
    const JsonValue& list = fields_.member(value, "pieces");
    ParametricSurface surface;
    std::size_t columns = 0;  // of the first row, when it has ended
    for (const JsonValue& element : fields_.array(list, "\"pieces\"")) {
      SurfacePiece piece = map(element);
      fields_.member(element, "domain", "a domain for each of the pieces");
      if (piece.region->triangle)
        throw InvalidInput("one of the pieces is a triangle", "maps of two parameters", place(element));
      const std::size_t i = surface.pieces.size();
      const auto side = [&](std::size_t index, std::size_t direction) -> const Interval& {
        return surface.pieces[index].region->sides[direction];
      };
      const auto& [first, second] = piece.region->sides;
      if (columns == 0 && i > 0 && !(first == side(i - 1, 0))) columns = i;
      const bool begins_row = columns > 0 && i % columns == 0;
      const bool fits = i == 0 || (begins_row ? first.lower == side(i - 1, 0).upper : first == side(i - 1, 0));
      const bool fits_column =
          columns > 0 ? second == side(i % columns, 1) : i == 0 || second.lower == side(i - 1, 1).upper;
      if (!fits || !fits_column)
        throw InvalidInput("the domains of the pieces of " + what_ + " are not a grid of rectangles",
                           "rows of rectangles, the first parameter equal in each row", place(element));
      surface.pieces.push_back(std::move(piece));
    }
    if (surface.pieces.empty()) throw InvalidInput("\"pieces\" is an empty array", "at least one map", place(list));
    if (columns > 0 && surface.pieces.size() % columns != 0)
      throw InvalidInput("the last row of the pieces of " + what_ + " is not complete",
                         std::to_string(columns) + " pieces in each row", place(list));
    return surface;
  }

  SurfacePiece bezier(const JsonValue& value) const {
    fields_.require_object(value, what_, {"bezier"});
    const JsonValue& form = fields_.member(value, "bezier");
    fields_.require_object(form, "\"bezier\"", {"degree", "control_points"});
    const auto degrees = degree_pair_from_json(fields_, fields_.member(form, "degree", "two whole numbers"));
    const JsonValue& list = fields_.member(form, "control_points", "rows of points");
    const std::size_t row_count = fields_.array(list, "\"control_points\"").size();
    if (row_count != degrees[0] + 1)
      throw InvalidInput(
          std::to_string(row_count) + " rows of control points for the first degree " + std::to_string(degrees[0]),
          std::to_string(degrees[0] + 1) + " rows", place(list));
    for (const JsonValue& row : list.elements)
      if (fields_.array(row, "a row of control points").size() != degrees[1] + 1)
        throw InvalidInput("a row of " + std::to_string(row.elements.size()) +
                               " control points for the second degree " + std::to_string(degrees[1]),
                           std::to_string(degrees[1] + 1) + " points", place(row));
    const Rows rows = control_points(list, nullptr);
    const std::vector<ControlPoint> points = all_of(rows);
    require_moderate_size(fields_, list, points, {}, degrees[0] + degrees[1], 4 * points.size());
    return placed(place(list), [&] { return symbolic::bezier_patch(rows); });
  }

  SurfacePiece triangle(const JsonValue& value) const {
    fields_.require_object(value, what_, {"triangle"});
    const PointList net = point_list_from_json(fields_, value, "triangle", "a triangle", "(degree + 1)(degree + 2)/2",
                                               symbolic::triangle_point_count);
    const std::size_t degree = net.degree;
    const JsonValue& list = net.points;
    std::vector<ControlPoint> points;
    for (const JsonValue& element : list.elements) points.push_back(weighted(element, 1));
    require_a_weight(fields_, list, points);
    require_moderate_size(fields_, list, points, {}, degree, 4 * points.size());
    return placed(place(list), [&] { return symbolic::bezier_triangle(degree, points); });
  }

  ParametricSurface nurbs(const JsonValue& value) const {
    fields_.require_object(value, what_, {"nurbs"});
    const JsonValue& form = fields_.member(value, "nurbs");
    fields_.require_object(form, "\"nurbs\"", {"degree", "knots", "control_points", "weights"});
    const auto degrees = degree_pair_from_json(fields_, fields_.member(form, "degree", "two whole numbers"));
    const JsonValue& list = fields_.member(form, "control_points", "rows of points");
    const std::array<std::size_t, 2> counts{fields_.array(list, "\"control_points\"").size(), row_length(list)};
    for (std::size_t direction = 0; direction < 2; ++direction)
      if (counts[direction] < degrees[direction] + 1)
        throw InvalidInput(std::to_string(counts[direction]) +
                               (direction == 0 ? " rows of control points for the first degree "
                                               : " control points in a row for the second degree ") +
                               std::to_string(degrees[direction]),
                           "at least " + std::to_string(degrees[direction] + 1), place(list));
    const JsonValue& knot_lists = fields_.member(form, "knots", "two knot vectors");
    if (fields_.array(knot_lists, "\"knots\"").size() != 2)
      throw InvalidInput("\"knots\" is an array of " + std::to_string(knot_lists.elements.size()) + " values",
                         "[first knot vector, second knot vector]", place(knot_lists));
    std::array<symbolic::KnotVector, 2> knots;
    for (std::size_t direction = 0; direction < 2; ++direction) {
      const JsonValue& knot_list = knot_lists.elements[direction];
      knots[direction] = {degrees[direction], numbers_from_json(fields_, knot_list, "a knot vector", "a knot")};
      placed(place(knot_list), [&] { symbolic::require_knots(knots[direction], counts[direction]); });
    }
    const Rows rows = control_points(list, form.find("weights"));
    std::vector<Rational> all_knots = knots[0].knots;
    all_knots.insert(all_knots.end(), knots[1].knots.begin(), knots[1].knots.end());
    const std::size_t coefficients =
        4 * (counts[0] - degrees[0]) * (degrees[0] + 1) * (counts[1] - degrees[1]) * (degrees[1] + 1);
    require_moderate_size(fields_, list, all_of(rows), all_knots, degrees[0] + degrees[1], coefficients);
    return placed(place(list), [&] { return symbolic::nurbs_surface(knots, rows); });
  }

  // The number of points in each row; all rows have as many, and not too many altogether.
  std::size_t row_length(const JsonValue& list) const {
    std::size_t length = 0;
    for (const JsonValue& row : list.elements) {
      const std::size_t own = fields_.array(row, "a row of control points").size();
      if (&row != list.elements.data() && own != length)
        throw InvalidInput("rows of " + std::to_string(length) + " and " + std::to_string(own) + " control points",
                           "rows of one length", place(row));
      length = own;
    }
    require_few_points(fields_, list, list.elements.size() * length);
    return length;
  }

  Rows control_points(const JsonValue& list, const JsonValue* weight_list) const {
    const std::size_t columns = row_length(list);
    if (weight_list != nullptr && fields_.array(*weight_list, "\"weights\"").size() != list.elements.size())
      throw InvalidInput(std::to_string(weight_list->elements.size()) + " rows of weights for " +
                             std::to_string(list.elements.size()) + " rows of control points",
                         "a weight for each point", place(*weight_list));
    Rows rows;
    for (std::size_t i = 0; i < list.elements.size(); ++i) {
      std::vector<Rational> weights(columns, 1);
      if (weight_list != nullptr) {
        const JsonValue& row = weight_list->elements[i];
        weights = numbers_from_json(fields_, row, "a row of weights", "a weight");
        if (weights.size() != columns)
          throw InvalidInput(
              std::to_string(weights.size()) + " weights for " + std::to_string(columns) + " control points",
              "a weight for each point", place(row));
      }
      rows.emplace_back();
      for (std::size_t j = 0; j < columns; ++j) {
        const JsonValue& point = list.elements[i].elements[j];
        rows.back().push_back(weighted(point, weights[j]));
        if (weight_list != nullptr && point.elements.size() == 4)
          throw InvalidInput("a control point has a weight beside \"weights\"", "[x, y, z]", place(point));
      }
    }
    require_a_weight(fields_, weight_list == nullptr ? list : *weight_list, all_of(rows));
    return rows;
  }

  ControlPoint weighted(const JsonValue& value, const Rational& weight) const {
    std::vector<Rational> numbers = point_from_json(fields_, value, 3);
    return numbers.size() == 4 ? with_own_weight(std::move(numbers)) : with_weight(std::move(numbers), weight);
  }

  const JsonFields& fields_;
  std::string what_;
};

}  // namespace

intersect::Surface read_surface(const JsonFields& fields, const JsonValue& value, const std::string& what) {
  return SurfaceReader(fields, what).read(value);
}

}  // namespace eliminant::io
