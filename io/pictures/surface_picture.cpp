// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <limits>

#include <eliminant/io/pictures/picture_fields.hpp>

namespace eliminant::io {

namespace {

// One of the parameter planes; of one surface both pairs are drawn in one plane, the second one dashed.
struct Plane {
  std::array<const char*, 2> names;
  std::string title;
  std::size_t panel;
  bool dashed;
};

// What components are listed one by one in the legend.
constexpr std::size_t most_in_legend = 12;

std::array<double, 2> at_parameters(const JsonValue& point, const Plane& plane) {
  return {number_in(point.find(plane.names[0])), number_in(point.find(plane.names[1]))};
}

std::array<double, 2> in_space(const JsonValue& point) {
  return seen_from_diagonal({number_in(point.find("x")), number_in(point.find("y")), number_in(point.find("z"))});
}

bool is_finite(const std::array<double, 2>& point) { return std::isfinite(point[0]) && std::isfinite(point[1]); }

std::string end_text(const JsonValue* end) {
  if (end == nullptr) return "";
  const std::string on = text_in(end->find("on"));
  if (on == "singular_point") return "singular point " + text_in(end->find("singular_point"));
  std::string text;
  for (const JsonValue& word : elements_in(end->find("border"))) text += (text.empty() ? "" : " ") + text_in(&word);
  if (text.empty()) return on;
  const std::string transition = text_in(end->find("transition"));
  return transition.empty() ? text : text + ", " + transition;
}

PictureShape shape_of(const std::string& kind) {
  if (kind == "contact") return PictureShape::diamond;
  if (kind == "crossing") return PictureShape::cross;
  if (kind == "cusp") return PictureShape::triangle;
  if (kind == "pinch_point") return PictureShape::square;
  if (kind == "triple_point") return PictureShape::star;
  return PictureShape::ring;
}

std::string in_words(const std::string& kind) {
  if (kind == "pinch_point") return "pinch point";
  if (kind == "triple_point") return "triple point";
  return kind == "undecided" ? "singular point, kind undecided" : kind;
}

class SurfacePicture {
 public:
  SurfacePicture(Picture& picture, const JsonValue& result) : picture_(picture), result_(result) {
    const bool itself = text_in(result.find("problem")) == "self_intersection";
    planes_ = {{{"u", "v"}, itself ? "Both preimages on the surface" : "On the first surface", 0, false},
               {{"s", "t"}, "On the second surface", itself ? std::size_t{0} : std::size_t{1}, itself}};
    if (!itself && !has_parameters(planes_[1])) planes_.pop_back();
    if (!itself && !has_parameters(planes_[0])) {
      planes_.erase(planes_.begin());
      planes_.front().panel = 0;
    }
    for (const Plane& plane : planes_)
      if (plane.panel == picture_.panels.size()) add_panel(plane);
    PicturePanel& space = picture_.panels.emplace_back();
    space.title = "In space";
    space.axes = {"", ""};
    space.equal_scales = space.space = true;
    for (const PicturePanel& panel : picture_.panels) space.unbounded = space.unbounded || panel.projective;
  }

  void draw() {
    const auto& components = elements_in(result_.find("components"));
    for (std::size_t i = 0; i < components.size(); ++i) draw_component(components[i], i);
    if (components.size() > most_in_legend)
      picture_.legend.push_back({"and " + std::to_string(components.size() - most_in_legend) + " more", {}, {}, true});
    if (planes_.size() > 1 && planes_[1].dashed)
      picture_.legend.push_back({"dashed: the second preimage (s, t) of the same curve", {}, {}, true});
    const auto& points = elements_in(result_.find("singular_points"));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string kind = text_in(points[i].find("kind"));
      mark(points[i], shape_of(kind), {}, in_words(kind) + " " + std::to_string(i));
      explain(picture_, shape_of(kind), in_words(kind));
    }
    add_tables(components, points);
  }

 private:
  // A surface given by an equation has none.
  bool has_parameters(const Plane& plane) const {
    for (const JsonValue& component : elements_in(result_.find("components")))
      for (const JsonValue& point : elements_in(component.find("points")))
        if (is_finite(at_parameters(point, plane))) return true;
    for (const JsonValue& point : elements_in(result_.find("singular_points")))
      if (is_finite(at_parameters(point, plane))) return true;
    return domain(plane).has_value();
  }

  std::optional<std::array<std::array<double, 2>, 2>> domain(const Plane& plane) const {
    const JsonValue* const domains = result_.find("domains");
    if (domains == nullptr) return std::nullopt;
    std::array<std::array<double, 2>, 2> sides{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& ends = elements_in(domains->find(plane.names[i]));
      if (ends.size() != 2) return std::nullopt;
      sides[i] = {number_in(&ends[0]), number_in(&ends[1])};
      if (!is_finite(sides[i])) return std::nullopt;
    }
    return sides;
  }

  void add_panel(const Plane& plane) {
    PicturePanel& panel = picture_.panels.emplace_back();
    panel.title = plane.title;
    for (std::size_t i = 0; i < 2; ++i)
      panel.axes[i] =
          planes_.back().dashed ? std::string(plane.names[i]) + ", " + planes_.back().names[i] : plane.names[i];
    panel.border = domain(plane);
    panel.projective = !panel.border;
  }

  PicturePanel& space() { return picture_.panels.back(); }

  void draw_component(const JsonValue& component, std::size_t index) {
    const std::string kind = text_in(component.find("kind"));
    const auto& points = elements_in(component.find("points"));
    std::string title = std::to_string(index) + ": " + kind;
    if (kind == "curve")
      title += " from " + end_text(component.find("start")) + " to " + end_text(component.find("end"));
    if (kind == "point") {
      for (const JsonValue& point : points) mark(point, PictureShape::diamond, index, title);
      explain(picture_, PictureShape::diamond, "contact");
      return;
    }
    PictureCurve curve;
    curve.color = index;
    curve.closed = kind == "loop";
    curve.area = kind == "overlap";
    curve.title = title;
    for (const Plane& plane : planes_) {
      curve.points.clear();
      for (const JsonValue& point : points) curve.points.push_back(at_parameters(point, plane));
      curve.dashed = plane.dashed;
      picture_.panels[plane.panel].curves.push_back(curve);
    }
    curve.points.clear();
    for (const JsonValue& point : points) curve.points.push_back(in_space(point));
    curve.dashed = false;
    space().curves.push_back(curve);
    if (index < most_in_legend) picture_.legend.push_back({title, {}, index, false});
    if (kind == "curve" && !points.empty()) {
      mark_end(points.front(), component.find("start"), index);
      mark_end(points.back(), component.find("end"), index);
    }
  }

  void mark_end(const JsonValue& point, const JsonValue* end, std::size_t color) {
    const std::string on = end == nullptr ? "" : text_in(end->find("on"));
    if (on == "border") {
      mark(point, PictureShape::ring, color, end_text(end));
      explain(picture_, PictureShape::ring, "end on a border");
    } else if (on == "unknown") {
      mark(point, PictureShape::dot, color, "not followed further");
      explain(picture_, PictureShape::dot, "not followed further");
    }
  }

  void mark(const JsonValue& point, PictureShape shape, std::optional<std::size_t> color, const std::string& title) {
    for (const Plane& plane : planes_)
      picture_.panels[plane.panel].marks.push_back({at_parameters(point, plane), shape, color, title});
    space().marks.push_back({in_space(point), shape, color, title});
  }

  void add_tables(const std::vector<JsonValue>& components, const std::vector<JsonValue>& points) {
    PictureTable table{"Components", {"#", "kind", "points", "from", "to", "error", "certified", "remark"}, {}};
    for (std::size_t i = 0; i < components.size(); ++i) {
      const JsonValue& component = components[i];
      std::string remark = text_in(component.find("reason"));
      const auto add = [&](const char* field) {
        const JsonValue* const value = component.find(field);
        if (value != nullptr && value->boolean) remark += (remark.empty() ? "" : "; ") + std::string(field);
      };
      add("tangential");
      add("mirrored");
      table.rows.push_back({std::to_string(i), text_in(component.find("kind")),
                            std::to_string(elements_in(component.find("points")).size()),
                            end_text(component.find("start")), end_text(component.find("end")),
                            text_in(component.find("error")), yes_or_no(component.find("certified")), remark});
    }
    picture_.tables.push_back(std::move(table));
    if (points.empty()) return;
    table = {"Singular points",
             {"#", "kind", "u", "v", "s", "t", "x", "y", "z", "half-branches", "radius", "certified"},
             {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      std::vector<std::string>& row = table.rows.emplace_back();
      row = {std::to_string(i), in_words(text_in(points[i].find("kind")))};
      for (const char* name : {"u", "v", "s", "t", "x", "y", "z", "half_branches", "radius"})
        row.push_back(text_in(points[i].find(name)));
      row.push_back(yes_or_no(points[i].find("certified")));
    }
    picture_.tables.push_back(std::move(table));
  }

  Picture& picture_;
  const JsonValue& result_;
  std::vector<Plane> planes_;
};

}  // namespace

std::array<double, 2> seen_from_diagonal(const std::array<double, 3>& point) {
  const auto& [x, y, z] = point;
  return {(y - x) / std::sqrt(2.0), (2 * z - x - y) / std::sqrt(6.0)};
}

void draw_surface_result(Picture& picture, const JsonValue& result) { SurfacePicture(picture, result).draw(); }

}  // namespace eliminant::io
