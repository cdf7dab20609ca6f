// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/pictures/result_picture.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <eliminant/base/error.hpp>
#include <eliminant/io/pictures/picture_fields.hpp>

namespace eliminant::io {

namespace {

using Kind = JsonValue::Kind;

PictureShape shape_of_vertex(const std::string& type) {
  if (type == "isolated") return PictureShape::diamond;
  if (type == "node") return PictureShape::cross;
  if (type == "cusp") return PictureShape::triangle;
  if (type == "tacnode") return PictureShape::square;
  return PictureShape::star;
}

// The arcs in one color, those of each simple closed curve in another.
std::vector<std::size_t> colors_of_edges(const JsonValue& result) {
  std::vector<std::size_t> colors(elements_in(result.find("edges")).size(), 0);
  const auto& loops = elements_in(result.find("loops"));
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (const JsonValue& edge : elements_in(&loops[i])) {
      const double index = number_in(&edge);
      if (index >= 0 && index < static_cast<double>(colors.size())) colors[static_cast<std::size_t>(index)] = i + 1;
    }
  return colors;
}

std::array<std::string, 2> variables_of(const JsonValue& result) {
  const auto& names = elements_in(result.find("variables"));
  return {names.size() == 2 ? text_in(&names[0]) : "x", names.size() == 2 ? text_in(&names[1]) : "y"};
}

PicturePanel& plane(Picture& picture, const JsonValue& result) {
  PicturePanel& panel = picture.panels.emplace_back();
  panel.axes = variables_of(result);
  panel.equal_scales = true;
  return panel;
}

void draw_topology(Picture& picture, const JsonValue& result) {
  PicturePanel& panel = plane(picture, result);
  const auto& edges = elements_in(result.find("edges"));
  const std::vector<std::size_t> colors = colors_of_edges(result);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    PictureCurve& curve = panel.curves.emplace_back();
    curve.color = colors[i];
    curve.title = "edge " + std::to_string(i);
    for (const JsonValue& point : elements_in(edges[i].find("polyline")))
      if (const auto& values = elements_in(&point); values.size() == 2)
        curve.points.push_back({number_in(&values[0]), number_in(&values[1])});
  }
  if (std::count(colors.begin(), colors.end(), 0U) > 0) picture.legend.push_back({"arcs", {}, 0, false});
  for (std::size_t i = 0; i < elements_in(result.find("loops")).size() && i < 8; ++i)
    picture.legend.push_back({"simple closed curve " + std::to_string(i), {}, i + 1, false});
  PictureTable table{"Vertices", {"#", "kind", "type", panel.axes[0], panel.axes[1], "radius", "certified"}, {}};
  const auto& vertices = elements_in(result.find("vertices"));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const JsonValue& vertex = vertices[i];
    const std::string kind = text_in(vertex.find("kind"));
    const std::string type = text_in(vertex.find("type"));
    table.rows.push_back({std::to_string(i), kind, type, text_in(vertex.find("x")), text_in(vertex.find("y")),
                          text_in(vertex.find("radius")), yes_or_no(vertex.find("certified"))});
    if (kind == "infinity") {
      panel.unbounded = true;
      continue;
    }
    const bool singular = kind == "singular";
    const PictureShape shape = singular           ? shape_of_vertex(type)
                               : kind == "border" ? PictureShape::ring
                                                  : PictureShape::dot;
    const std::string meaning = singular           ? (type == "isolated" ? "isolated point" : type)
                                : kind == "border" ? "on the border"
                                                   : "vertical tangent";
    panel.marks.push_back({{number_in(vertex.find("x")), number_in(vertex.find("y"))},
                           shape,
                           {},
                           "vertex " + std::to_string(i) + ": " + meaning});
    explain(picture, shape, meaning);
  }
  picture.tables.push_back(std::move(table));
}

void draw_plane_curves(Picture& picture, const JsonValue& result) {
  PicturePanel& panel = plane(picture, result);
  PictureTable table{"Real solutions", {"#", panel.axes[0], panel.axes[1], "multiplicity", "radius", "certified"}, {}};
  for (const JsonValue& solution : elements_in(result.find("solutions"))) {
    const JsonValue* const real = solution.find("real");
    const auto& x = elements_in(solution.find("x"));
    const auto& y = elements_in(solution.find("y"));
    if (real == nullptr || !real->boolean || x.empty() || y.empty()) continue;
    const std::string multiplicity = text_in(solution.find("multiplicity"));
    const bool simple = multiplicity == "1";
    panel.marks.push_back({{number_in(&x[0]), number_in(&y[0])},
                           simple ? PictureShape::dot : PictureShape::diamond,
                           simple ? 0 : 1,
                           "multiplicity " + multiplicity});
    explain(picture, panel.marks.back().shape, simple ? "simple solution" : "multiple solution");
    table.rows.push_back({std::to_string(table.rows.size()), text_in(&x[0]), text_in(&y[0]), multiplicity,
                          text_in(solution.find("radius")), yes_or_no(solution.find("certified"))});
  }
  picture.tables.push_back(std::move(table));
}

std::string counts_text(const JsonValue* counts) {
  std::string text;
  if (counts == nullptr || counts->kind != Kind::object) return text;
  for (const JsonMember& count : counts->members) {
    std::string name = count.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    if (count.value.kind == Kind::number && count.value.text != "0")
      text += (text.empty() ? "" : ", ") + name + " " + count.value.text;
  }
  return text;
}

}  // namespace

double number_in(const JsonValue* value) {
  const std::string text = text_in(value);
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const bool read = !text.empty() && rest == end && error == std::errc{};
  if (read) return number;
  // Domains are rational: only the nearest double of each part is needed for a picture.
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
  double denominator = 0;
  const auto above = std::from_chars(text.data(), text.data() + slash, number);
  const auto below = std::from_chars(text.data() + slash + 1, end, denominator);
  const bool quotient = above.ptr == text.data() + slash && below.ptr == end && denominator != 0;
  return quotient ? number / denominator : std::numeric_limits<double>::quiet_NaN();
}

std::string text_in(const JsonValue* value) {
  if (value == nullptr || (value->kind != Kind::text && value->kind != Kind::number)) return "";
  return value->text;
}

const std::vector<JsonValue>& elements_in(const JsonValue* value) {
  static const std::vector<JsonValue> none;
  return value == nullptr || value->kind != Kind::array ? none : value->elements;
}

std::string yes_or_no(const JsonValue* value) {
  if (value == nullptr || value->kind != Kind::boolean) return "";
  return value->boolean ? "yes" : "no";
}

void explain(Picture& picture, PictureShape shape, const std::string& text) {
  const bool there = std::any_of(picture.legend.begin(), picture.legend.end(), [&](const PictureLegend& entry) {
    return entry.shape == shape && entry.text == text;
  });
  if (!there) picture.legend.push_back({text, shape, {}, false});
}

Picture result_picture(const std::string& text) {
  const JsonDocument document(text);
  const JsonValue& result = document.root();
  const std::string kind = text_in(result.find("problem"));
  const std::string status = text_in(result.find("status"));
  const char* const expected = "what eliminant writes with --format json";
  if (result.kind != Kind::object || text_in(result.find("format")) != "1" || status.empty())
    throw InvalidInput("this is no result", expected, document.place_of(result));
  if (status == "error")
    throw InvalidInput("this result is an error: nothing was found that could be drawn", "a result with another status",
                       document.place_of(*result.find("status")));
  Picture picture;
  const std::string id = text_in(result.find("id"));
  picture.subtitle = status;
  if (const std::string counts = counts_text(result.find("counts")); !counts.empty()) picture.subtitle += ": " + counts;
  if (kind == "surface_surface" || (kind == "self_intersection" && result.find("components") != nullptr)) {
    picture.title = kind == "surface_surface" ? "Intersection of two surfaces" : "Self-intersection of a surface";
    draw_surface_result(picture, result);
  } else if (kind == "curve_topology") {
    picture.title = "Topology of a plane curve";
    draw_topology(picture, result);
  } else if (kind == "plane_curves") {
    picture.title = "Common points of two plane curves";
    draw_plane_curves(picture, result);
  } else if (kind == "cylinder_extraction") {
    picture.title = "Cylinders in a point cloud";
    draw_cylinder_extraction(picture, result);
  } else {
    throw InvalidInput(
        "there is no picture of results of the kind \"" + kind.substr(0, 40) + "\"",
        "surface_surface, self_intersection of a surface, curve_topology, plane_curves or cylinder_extraction",
        document.place_of(result));
  }
  if (!id.empty()) picture.title += ": " + id;
  return picture;
}

}  // namespace eliminant::io
