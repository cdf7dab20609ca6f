// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::io {

/// What a picture of a result shows, before it is drawn: planes side by side with curves and marks, a legend, tables.

enum class PictureShape { dot, ring, diamond, cross, triangle, square, star };

struct PictureCurve {
  /// A point that is not finite interrupts the curve.
  std::vector<std::array<double, 2>> points;
  /// Index of a color; equal ones are what belongs together.
  std::size_t color = 0;
  bool dashed = false;
  /// Its inside is tinted: a closed curve, or (`area`) the outline of an area.
  bool closed = false;
  bool area = false;
  /// Shown beside the pointer.
  std::string title;
};

struct PictureMark {
  std::array<double, 2> at{};
  PictureShape shape = PictureShape::dot;
  /// Without one it is drawn in the color of text.
  std::optional<std::size_t> color;
  std::string title;
};

struct PicturePanel {
  std::string title;
  std::array<std::string, 2> axes;
  /// Drawn as a rectangle: lower and upper end in both directions.
  std::optional<std::array<std::array<double, 2>, 2>> border;
  /// One unit is as long in both directions.
  bool equal_scales = false;
  /// The axes are whole projective lines, infinity at both ends, drawn on the scale of the angle arctan x.
  bool projective = false;
  /// Curves run to infinity: what is shown is where most of the points are.
  bool unbounded = false;
  /// Space seen from the direction (1, 1, 1), see `seen_from_diagonal`: without ticks.
  bool space = false;
  std::vector<PictureCurve> curves;
  std::vector<PictureMark> marks;
};

struct PictureLegend {
  std::string text;
  /// Of a mark; a curve has none.
  std::optional<PictureShape> shape;
  std::optional<std::size_t> color;
  bool dashed = false;
};

struct PictureTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

struct Picture {
  std::string title;
  std::string subtitle;
  std::vector<PicturePanel> panels;
  std::vector<PictureLegend> legend;
  std::vector<PictureTable> tables;
};

/// The orthogonal projection along (1, 1, 1), z upwards.
std::array<double, 2> seen_from_diagonal(const std::array<double, 3>& point);

}  // namespace eliminant::io
