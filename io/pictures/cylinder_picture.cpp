// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <numbers>

#include <eliminant/io/pictures/picture_fields.hpp>

namespace eliminant::io {

namespace {

using Vector = std::array<double, 3>;

Vector vector_in(const JsonValue* value) {
  const auto& elements = elements_in(value);
  if (elements.size() != 3) return {NAN, NAN, NAN};
  return {number_in(&elements[0]), number_in(&elements[1]), number_in(&elements[2])};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled_to(const Vector& a, double length) {
  const double factor = length / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// A way to look at space: what becomes of a point, and the direction of the view.
struct View {
  std::array<double, 2> (*project)(const Vector& point);
  Vector direction;
};

const std::array<View, 3>& views() {
  static const std::array<View, 3> all{{{seen_from_diagonal, {1, 1, 1}},
                                        {[](const Vector& p) -> std::array<double, 2> {
                                           return {p[0], p[1]};
                                         },
                                         {0, 0, 1}},
                                        {[](const Vector& p) -> std::array<double, 2> {
                                           return {p[0], p[2]};
                                         },
                                         {0, 1, 0}}}};
  return all;
}

constexpr std::size_t most_in_legend = 12;

class CylinderPicture {
 public:
  CylinderPicture(Picture& picture, const JsonValue& result) : picture_(picture), result_(result) {
    for (const auto& [title, axes] : {std::pair{"In space", std::array<std::string, 2>{"", ""}},
                                      std::pair{"From above", std::array<std::string, 2>{"x", "y"}},
                                      std::pair{"From the front", std::array<std::string, 2>{"x", "z"}}}) {
      PicturePanel& panel = picture_.panels.emplace_back();
      panel.title = title;
      panel.axes = axes;
      panel.equal_scales = true;
    }
    picture_.panels.front().space = true;
  }

  void draw() {
    PictureTable table{
        "Cylinders", {"#", "direction", "middle of the axis", "radius", "length", "points", "residual"}, {}};
    const auto& cylinders = elements_in(result_.find("cylinders"));
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
      const JsonValue& cylinder = cylinders[i];
      draw_cylinder(cylinder, i);
      const std::string radius = text_in(cylinder.find("radius"));
      if (i < most_in_legend)
        picture_.legend.push_back({"cylinder " + std::to_string(i + 1) + ", radius " + radius, {}, i, false});
      table.rows.push_back({std::to_string(i + 1), list(cylinder.find("direction")), list(cylinder.find("axis_point")),
                            radius, text_in(cylinder.find("length")), text_in(cylinder.find("inliers")),
                            text_in(cylinder.find("residual"))});
    }
    if (cylinders.size() > most_in_legend)
      picture_.legend.push_back({"and " + std::to_string(cylinders.size() - most_in_legend) + " more", {}, {}, true});
    picture_.tables.push_back(std::move(table));
  }

 private:
  static std::string list(const JsonValue* value) {
    std::string text;
    for (const JsonValue& element : elements_in(value)) text += (text.empty() ? "" : ", ") + text_in(&element);
    return text;
  }

  // Both end circles, and the two lines on which the surface turns away from the eye.
  void draw_cylinder(const JsonValue& cylinder, std::size_t index) {
    const double radius = number_in(cylinder.find("radius"));
    const Vector direction = vector_in(cylinder.find("direction"));
    const Vector half = scaled_to(direction, number_in(cylinder.find("length")) / 2);
    const Vector middle = vector_in(cylinder.find("axis_point"));
    const std::array<Vector, 2> ends{sum(middle, half), sum(middle, scaled_to(half, -length(half)))};
    for (std::size_t v = 0; v < views().size(); ++v) {
      const View& view = views()[v];
      for (const Vector& end : ends) draw(v, circle(end, direction, radius), index, true);
      const Vector edge = cross(direction, view.direction);
      if (length(edge) < 1e-9 * length(direction)) continue;  // seen along its axis
      for (const double side : {radius, -radius}) {
        const Vector aside = scaled_to(edge, side);
        draw(v, {sum(ends[0], aside), sum(ends[1], aside)}, index, false);
      }
    }
  }

  static double length(const Vector& a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

  static std::vector<Vector> circle(const Vector& center, const Vector& direction, double radius) {
    constexpr int steps = 48;
    const bool along_x = std::abs(direction[0]) > 0.9 * length(direction);
    const Vector u = scaled_to(cross(direction, along_x ? Vector{0, 1, 0} : Vector{1, 0, 0}), radius);
    const Vector v = scaled_to(cross(direction, u), radius);
    std::vector<Vector> points;
    for (int i = 0; i <= steps; ++i) {
      const double turn = 2 * std::numbers::pi * i / steps;
      Vector point = center;
      for (std::size_t k = 0; k < 3; ++k) point[k] += std::cos(turn) * u[k] + std::sin(turn) * v[k];
      points.push_back(point);
    }
    return points;
  }

  void draw(std::size_t view, const std::vector<Vector>& points, std::size_t index, bool closed) {
    PictureCurve& curve = picture_.panels[view].curves.emplace_back();
    curve.color = index;
    curve.closed = closed;
    curve.title = "cylinder " + std::to_string(index + 1);
    for (const Vector& point : points) curve.points.push_back(views()[view].project(point));
  }

  Picture& picture_;
  const JsonValue& result_;
};

}  // namespace

void draw_cylinder_extraction(Picture& picture, const JsonValue& result) { CylinderPicture(picture, result).draw(); }

}  // namespace eliminant::io
