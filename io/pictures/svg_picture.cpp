// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/pictures/svg_picture.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <eliminant/io/pictures/picture_scale.hpp>

namespace eliminant::io {

namespace {

// Lengths in pixels.
constexpr double plot_size = 380;
constexpr double panel_left = 66;
constexpr double panel_width = panel_left + plot_size + 26;
constexpr double panel_top = 104;
constexpr double legend_top = panel_top + plot_size + 68;
constexpr double legend_line = 21;
// Of a letter, about.
constexpr double letter_width = 7.4;

// Told apart also by those who do not see all colors; none is lighter than its line may be.
constexpr std::array palette{"#0072b2", "#d55e00", "#009e73", "#b5488f", "#b8860b", "#3f9bd0", "#6a3d9a", "#7a5230"};
constexpr const char* text_color = "#222222";

const char* color_of(const std::optional<std::size_t>& color) {
  return color ? palette[*color % palette.size()] : text_color;
}

std::string text_at(double x, double y, const std::string& text, const std::string& attributes) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes, escaped(text));
}

// The corners of a shape around (0, 0), of radius 1.
std::vector<std::array<double, 2>> corners(PictureShape shape) {
  if (shape == PictureShape::diamond) return {{0, -1.15}, {1.15, 0}, {0, 1.15}, {-1.15, 0}};
  if (shape == PictureShape::square) return {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
  if (shape == PictureShape::triangle) return {{0, -1.1}, {1.05, 0.85}, {-1.05, 0.85}};
  std::vector<std::array<double, 2>> star;
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.2 * std::numbers::pi * i;
    const double radius = i % 2 == 0 ? 1.35 : 0.6;
    star.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return star;
}

std::string mark_at(double x, double y, PictureShape shape, const std::optional<std::size_t>& color,
                    const std::string& title) {
  const char* const paint = color_of(color);
  const std::string tooltip = title.empty() ? "" : "<title>" + escaped(title) + "</title>";
  if (shape == PictureShape::dot || shape == PictureShape::ring) {
    const bool ring = shape == PictureShape::ring;
    return fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"{}\">{}</circle>\n", x,
        y, ring ? 4.2 : 3.6, ring ? "#ffffff" : paint, ring ? paint : "#ffffff", ring ? 1.8 : 1, tooltip);
  }
  constexpr double radius = 6;
  if (shape == PictureShape::cross) {
    const auto stroke = [&](const char* stroke_color, double width) {
      return fmt::format(
          "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"{}\" "
          "fill=\"none\">{}</path>\n",
          x - 5, y - 5, x + 5, y + 5, x - 5, y + 5, x + 5, y - 5, stroke_color, width, tooltip);
    };
    return stroke("#ffffff", 5) + stroke(paint, 2.2);
  }
  std::string points;
  for (const auto& [dx, dy] : corners(shape))
    points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", x + radius * dx, y + radius * dy);
  return fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1\">{}</polygon>\n", points,
                     paint, tooltip);
}

// One panel, its plot beginning at (left, panel_top).
class PanelDrawing {
 public:
  PanelDrawing(const PicturePanel& panel, std::size_t index)
      : panel_(panel),
        view_(view_of(panel)),
        index_(index),
        left_(panel_left + panel_width * static_cast<double>(index)) {}

  std::string draw() const {
    std::string out = text_at(left_ + plot_size / 2, panel_top - 14, panel_.title,
                              "text-anchor=\"middle\" font-size=\"15\" font-weight=\"bold\"");
    out += fmt::format("<clipPath id=\"plot{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
                       index_, left_, panel_top, plot_size, plot_size);
    const bool bordered = panel_.border || panel_.projective;
    out += rectangle(left_, panel_top, plot_size, plot_size, bordered ? "fill=\"#eeeeee\"" : "fill=\"#fafafa\"");
    if (bordered) out += border("fill=\"#ffffff\"");
    out += panel_.space ? axes_in_space() : ticks();
    if (bordered)
      out += border(std::string("fill=\"none\" stroke=\"#555555\" stroke-width=\"1.4\"") +
                    (panel_.projective ? " stroke-dasharray=\"3 3\"" : ""));
    out += fmt::format("<g clip-path=\"url(#plot{})\">\n", index_);
    for (const PictureCurve& curve : panel_.curves) out += curve_path(curve);
    out += "</g>\n";
    out += rectangle(left_, panel_top, plot_size, plot_size, "fill=\"none\" stroke=\"#999999\"");
    for (const PictureMark& mark : panel_.marks) {
      const std::array<double, 2> at{drawn(panel_, mark.at[0]), drawn(panel_, mark.at[1])};
      if (is_inside(at)) out += mark_at(x_of(at[0]), y_of(at[1]), mark.shape, mark.color, mark.title);
    }
    return out;
  }

 private:
  double x_of(double x) const { return left_ + plot_size * (x - view_[0].lower) / (view_[0].upper - view_[0].lower); }
  double y_of(double y) const {
    return panel_top + plot_size * (view_[1].upper - y) / (view_[1].upper - view_[1].lower);
  }
  bool is_inside(const std::array<double, 2>& point) const {
    return view_[0].contains(point[0]) && view_[1].contains(point[1]);
  }

  static std::string rectangle(double x, double y, double width, double height, const std::string& attributes) {
    return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n", x, y, width, height,
                       attributes);
  }

  std::string border(const std::string& attributes) const {
    constexpr std::array<double, 2> line{-1, 1};
    const auto [x, y] = panel_.border ? *panel_.border : std::array{line, line};
    return rectangle(x_of(x[0]), y_of(y[1]), x_of(x[1]) - x_of(x[0]), y_of(y[0]) - y_of(y[1]), attributes);
  }

  std::string ticks() const {
    constexpr const char* line = "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"#dddddd\" stroke-width=\"0.8\"/>\n";
    const double right = left_ + plot_size;
    const double bottom = panel_top + plot_size;
    std::string out;
    for (const PictureTick& tick : ticks_in(panel_, view_[0])) {
      const double x = x_of(tick.at);
      out += fmt::format(line, x, panel_top, x, bottom);
      out += text_at(x, bottom + 17, tick.name, "text-anchor=\"middle\" fill=\"#555555\"");
    }
    for (const PictureTick& tick : ticks_in(panel_, view_[1])) {
      const double y = y_of(tick.at);
      out += fmt::format(line, left_, y, right, y);
      out += text_at(left_ - 7, y + 4, tick.name, "text-anchor=\"end\" fill=\"#555555\"");
    }
    const std::string name = "text-anchor=\"middle\" font-size=\"15\" font-style=\"italic\"";
    out += text_at(left_ + plot_size / 2, bottom + 38, panel_.axes[0], name);
    return out + text_at(left_ - 50, panel_top + plot_size / 2 + 5, panel_.axes[1], name);
  }

  // The directions of the axes in the lower left corner.
  std::string axes_in_space() const {
    std::string out;
    const std::array<const char*, 3> names{"x", "y", "z"};
    const double x = left_ + 42;
    const double y = panel_top + plot_size - 40;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> direction{};
      direction[i] = 34;
      const auto [dx, dy] = seen_from_diagonal(direction);
      out += fmt::format("<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"#777777\" stroke-width=\"1.2\"/>\n", x, y,
                         x + dx, y - dy);
      out += text_at(x + 1.3 * dx, y - 1.3 * dy + 4, names[i],
                     "text-anchor=\"middle\" font-style=\"italic\" fill=\"#555555\"");
    }
    return out;
  }

  std::string curve_path(const PictureCurve& curve) const {
    const std::vector<std::array<double, 2>> points = drawn(panel_, curve);
    std::string path;
    std::array<double, 2> last{};
    bool pen_down = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool finite = std::isfinite(points[i][0]) && std::isfinite(points[i][1]);
      if (!finite || (i > 0 && is_jump(points[i - 1], points[i]))) pen_down = false;
      if (!finite) continue;
      // Far outside the numbers would be longer than useful.
      const std::array<double, 2> at{std::clamp(x_of(points[i][0]), -1e5, 1e5),
                                     std::clamp(y_of(points[i][1]), -1e5, 1e5)};
      const bool near = std::hypot(at[0] - last[0], at[1] - last[1]) < 0.3;
      if (pen_down && near && i + 1 < points.size()) continue;
      path += fmt::format("{}{:.2f} {:.2f}", pen_down ? 'L' : 'M', at[0], at[1]);
      last = at;
      pen_down = true;
    }
    if (path.empty()) return "";
    if (curve.area) path += "Z";
    const char* const color = color_of(curve.color);
    const double tint = curve.area ? 0.3 : curve.closed && !panel_.projective ? 0.08 : 0;
    return fmt::format(
        "<path d=\"{}\" fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\" stroke-width=\"2\" stroke-linejoin=\"round\"{}>"
        "<title>{}</title></path>\n",
        path, tint > 0 ? color : "none", tint, color, curve.dashed ? " stroke-dasharray=\"6 4\"" : "",
        escaped(curve.title));
  }

  // From one side of the view to the other, both far outside it: through infinity in space.
  bool is_jump(const std::array<double, 2>& a, const std::array<double, 2>& b) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const double size = view_[i].upper - view_[i].lower;
      const auto side = [&](double x) {
        return x > view_[i].upper + size / 2 ? 1 : x < view_[i].lower - size / 2 ? -1 : 0;
      };
      if (side(a[i]) * side(b[i]) < 0) return true;
    }
    return false;
  }

  const PicturePanel& panel_;
  std::array<PictureRange, 2> view_;
  std::size_t index_;
  double left_;
};

double width_of(const Picture& picture) { return panel_width * static_cast<double>(picture.panels.size()) + 14; }

double legend_column(const Picture& picture) {
  std::size_t longest = 0;
  for (const PictureLegend& entry : picture.legend) longest = std::max(longest, entry.text.size());
  return 66 + letter_width * static_cast<double>(longest);
}

std::size_t legend_rows(const Picture& picture) {
  const double fitting = std::floor((width_of(picture) - panel_left) / legend_column(picture));
  const auto columns = static_cast<std::size_t>(std::max(1.0, fitting));
  return (picture.legend.size() + columns - 1) / columns;
}

// The subtitle, on two lines where it is too long for one, broken at a comma.
std::string subtitle(const Picture& picture) {
  const auto fitting = static_cast<std::size_t>((width_of(picture) - panel_left) / letter_width);
  const std::string& text = picture.subtitle;
  const std::size_t comma = text.size() > fitting ? text.rfind(", ", fitting) : std::string::npos;
  const std::string attributes = "fill=\"#555555\"";
  if (comma == std::string::npos) return text_at(panel_left, 51, text, attributes);
  return text_at(panel_left, 51, text.substr(0, comma + 1), attributes) +
         text_at(panel_left, 68, text.substr(comma + 2), attributes);
}

std::string legend(const Picture& picture) {
  // Curves before marks.
  std::vector<PictureLegend> entries = picture.legend;
  std::stable_partition(entries.begin(), entries.end(), [](const PictureLegend& entry) { return !entry.shape; });
  std::string out;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const PictureLegend& entry = entries[i];
    const double x = panel_left + legend_column(picture) * static_cast<double>(i / legend_rows(picture));
    const double y = legend_top + legend_line * static_cast<double>(i % legend_rows(picture));
    if (entry.shape)
      out += mark_at(x + 13, y - 4, *entry.shape, entry.color, "");
    else
      out += fmt::format("<path d=\"M{:.1f} {:.1f}h26\" stroke=\"{}\" stroke-width=\"2.4\"{}/>\n", x, y - 4,
                         color_of(entry.color), entry.dashed ? " stroke-dasharray=\"6 4\"" : "");
    out += text_at(x + 36, y, entry.text, "");
  }
  return out;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out;
}

std::string svg_picture(const Picture& picture) {
  const double width = width_of(picture);
  const double height = legend_top + legend_line * static_cast<double>(legend_rows(picture)) + 6;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"12.5\" fill=\"{2}\">\n",
      width, height, text_color);
  out += "<title>" + escaped(picture.title) + "</title>\n";
  out += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#ffffff\"/>\n", width, height);
  out += text_at(panel_left, 30, picture.title, "font-size=\"18\" font-weight=\"bold\"");
  out += subtitle(picture);
  for (std::size_t i = 0; i < picture.panels.size(); ++i) out += PanelDrawing(picture.panels[i], i).draw();
  return out + legend(picture) + "</svg>\n";
}

}  // namespace eliminant::io
